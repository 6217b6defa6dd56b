#pragma once

#include <concepts>
#include <iterator>
#include <string>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {

/// The instants from start to end, both included. Made by from_until().
class TimeSpan {
 public:
  [[nodiscard]] const Epoch& start() const { return start_; }
  [[nodiscard]] const Epoch& end() const { return end_; }
  [[nodiscard]] bool contains(const Epoch& epoch) const { return start_ <= epoch && epoch <= end_; }

  friend VECTRIX_EXPORT TimeSpan from_until(const Epoch& start, const Epoch& end);

 private:
  TimeSpan(const Epoch& start, const Epoch& end) : start_(start), end_(end) {}

  Epoch start_, end_;
};

namespace detail {

/// Throws BadInput: name, ": the epoch ... is outside ", what, " start to end".
[[noreturn]] VECTRIX_EXPORT void refuse_outside(const std::string& name, const Epoch& epoch, const char* what,
                                                const TimeSpan& span);

template <class X>
concept Duration = std::convertible_to<const X&, Quantity<si::time>> || requires(const X& x) {
  convert<si::time>(x);
};
template <class Start, class End>
inline constexpr bool ends_of_span = std::same_as<Start, Epoch> &&
                                     (std::same_as<End, Epoch> || Duration<End>);

}  // namespace detail

/// Throws BadInput if the end is before the start, or the duration is negative or not finite.
VECTRIX_EXPORT TimeSpan from_until(const Epoch& start, const Epoch& end);
VECTRIX_EXPORT TimeSpan from_until(const Epoch& start, const Quantity<si::time>& duration);
/// In another unit of time: from_until(start, 1.0 * si::day).
template <class U>
  requires(!std::same_as<U, si::time> && detail::converts<si::time, U, double>)
TimeSpan from_until(const Epoch& start, const Quantity<U>& duration) {
  return from_until(start, convert<si::time>(duration));
}
// Not deleted: clang would list all functions of this name.
template <class Start, class End>
  requires(!detail::ends_of_span<Start, End>)
Refused from_until(const Start&, const End&) {
  static_assert(detail::ends_of_span<Start, End>, "an Epoch, and an Epoch or a duration");
  return {};
}

/// The epochs start + k step of a span, k = 0, 1, ..., each from its own k: no error grows from one to the
/// next. Made by every().
class VECTRIX_EXPORT EpochRange {
 public:
  class Iterator;

  [[nodiscard]] std::int64_t size() const { return size_; }
  /// start + k step, at most the end of the span.
  [[nodiscard]] Epoch operator[](std::int64_t k) const;
  [[nodiscard]] inline Iterator begin() const;
  [[nodiscard]] inline Iterator end() const;

  friend VECTRIX_EXPORT EpochRange every(const Quantity<si::time>& step, const TimeSpan& span);

 private:
  EpochRange(const Quantity<si::time>& step, const TimeSpan& span, std::int64_t size)
      : step_(step), span_(span), size_(size) {}

  Quantity<si::time> step_;
  TimeSpan span_;
  std::int64_t size_;
};

/// Refers to its range, and gives epochs by value.
class EpochRange::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Epoch;
  using difference_type = std::int64_t;
  using pointer = void;
  using reference = Epoch;

  Iterator() = default;
  Iterator(const EpochRange& range, std::int64_t k) : range_(&range), k_(k) {}

  Epoch operator*() const { return (*range_)[k_]; }
  Iterator& operator++() {
    ++k_;
    return *this;
  }
  Iterator operator++(int) {
    const Iterator before = *this;
    ++k_;
    return before;
  }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.k_ == b.k_; }

 private:
  const EpochRange* range_ = nullptr;
  std::int64_t k_ = 0;
};

EpochRange::Iterator EpochRange::begin() const {
  return {*this, 0};
}
EpochRange::Iterator EpochRange::end() const {
  return {*this, size_};
}

/// The epochs of a span, a step apart: for (const Epoch& t : every(10.0 * si::second, span)). The end is one
/// of them if the span is a whole number of steps, up to the rounding of the clock and of the step. Throws
/// BadInput if the step is not positive and finite, or there are more than 2^53 steps.
VECTRIX_EXPORT EpochRange every(const Quantity<si::time>& step, const TimeSpan& span);

}  // namespace vectrix
