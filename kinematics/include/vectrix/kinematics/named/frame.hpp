#pragma once

#include <atomic>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/frame.hpp>

namespace vectrix {

/// The motion property of a frame known at run time, as inertial_frame and moving_frame for a type.
enum class FrameMotion { inertial, moving };

namespace detail {

struct TreeNode;

/// The data of a frame in its graph. The address is constant until the graph is destroyed.
struct FrameRecord {
  const void* graph;
  std::string name;
  FrameMotion motion;
  std::uint32_t number;
  /// Its node in its tree. Replaced when two trees are joined.
  std::atomic<const TreeNode*> node{nullptr};
};

}  // namespace detail

/// A frame of a NamedGraph, known at run time, for example wheel k of a file. Made by `graph.add_frame("wheel
/// 3", ...)` or `graph.frame("wheel 3")`. It belongs to that graph. Neither it nor a value that carries it
/// may outlive the graph.
class NamedFrame {
 public:
  explicit NamedFrame(const detail::FrameRecord& record) : record_(&record) {}

  const std::string& name() const { return record_->name; }
  FrameMotion motion() const { return record_->motion; }
  bool operator==(const NamedFrame&) const = default;

  const detail::FrameRecord& record() const { return *record_; }

 private:
  const detail::FrameRecord* record_;
};

namespace detail {

template <class F>
concept RunTimeFrame = std::same_as<F, NamedFrame> || std::same_as<F, std::string_view>;

template <RunTimeFrame F> struct Word {
  F frame;
  explicit Word(F given) : frame(given) {}
};

inline std::string in_quotes(std::string_view name) {
  return '"' + std::string{name} + '"';
}
inline std::string in_quotes(NamedFrame frame) {
  return in_quotes(frame.name());
}

}  // namespace detail

// The arguments of doors and queries for frames known at run time, by handle or by name: To(camera),
// From("itrf"). They are capitalised because the variable template to<Camera> and a function cannot share a
// name.
template <detail::RunTimeFrame F> struct To<F> : detail::Word<F> { using detail::Word<F>::Word; };
template <detail::RunTimeFrame F> struct From<F> : detail::Word<F> { using detail::Word<F>::Word; };
template <detail::RunTimeFrame F> struct In<F> : detail::Word<F> { using detail::Word<F>::Word; };
template <detail::RunTimeFrame F> struct Of<F> : detail::Word<F> { using detail::Word<F>::Word; };
template <detail::RunTimeFrame F> struct RelativeTo<F> : detail::Word<F> { using detail::Word<F>::Word; };
template <detail::RunTimeFrame F> struct ObservedFrom<F> : detail::Word<F> { using detail::Word<F>::Word; };

To(NamedFrame)->To<NamedFrame>;
From(NamedFrame)->From<NamedFrame>;
In(NamedFrame)->In<NamedFrame>;
Of(NamedFrame)->Of<NamedFrame>;
RelativeTo(NamedFrame)->RelativeTo<NamedFrame>;
ObservedFrom(NamedFrame)->ObservedFrom<NamedFrame>;
To(std::string_view)->To<std::string_view>;
From(std::string_view)->From<std::string_view>;
In(std::string_view)->In<std::string_view>;
Of(std::string_view)->Of<std::string_view>;
RelativeTo(std::string_view)->RelativeTo<std::string_view>;
ObservedFrom(std::string_view)->ObservedFrom<std::string_view>;

}  // namespace vectrix
