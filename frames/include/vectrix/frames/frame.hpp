#pragma once

#include <string>
#include <string_view>
#include <type_traits>

namespace vectrix {

/// A frame is an empty type that the user defines, with a motion property. It is never instantiated:
///     struct Gcrf : vectrix::inertial_frame {};
///     struct Body : vectrix::moving_frame {};
///     template <int I> struct Wheel : vectrix::moving_frame {};
/// Inertial: Newton's and Euler's laws hold in it. Moving: nothing is claimed about it.
struct inertial_frame {};
struct moving_frame {};

namespace detail {

// A variable, not a concept: nested concepts lengthen the diagnostic.
template <class F>
inline constexpr bool either_inertial_or_moving =
    !std::is_same_v<F, inertial_frame> && !std::is_same_v<F, moving_frame> &&
    std::is_base_of_v<inertial_frame, F> != std::is_base_of_v<moving_frame, F>;

}  // namespace detail

template <class F>
concept Frame =
    std::is_same_v<F, std::remove_cv_t<F>> && std::is_empty_v<F> && detail::either_inertial_or_moving<F>;

template <class F>
concept InertialFrame = Frame<F> && std::is_base_of_v<inertial_frame, F>;

/// A point is also an empty type that the user defines. A frame given as a point stands for its origin:
///     struct StarTrackerMount : vectrix::named_point {};
struct named_point {};

template <class P>
concept Point =
    std::is_same_v<P, std::remove_cv_t<P>> && std::is_empty_v<P> && !std::is_same_v<P, named_point> &&
    (detail::either_inertial_or_moving<P> || std::is_base_of_v<named_point, P>);

namespace detail {

/// The name of F in the signature of a function, without the namespace of this library, which clang writes
/// and g++ leaves out here.
inline std::string name_in(std::string_view signature) {
  const auto begin = signature.find("F = ") + 4;
  std::string_view name = signature.substr(begin, signature.find_first_of(";]", begin) - begin);
  constexpr std::string_view own = "vectrix::", before_names = "< ,";
  std::string result;
  while (!name.empty()) {
    const bool at_start = result.empty() || before_names.find(result.back()) != std::string_view::npos;
    if (at_start && name.starts_with(own)) name.remove_prefix(own.size());
    result += name.front();
    name.remove_prefix(1);
  }
  return result;
}

}  // namespace detail

/// The name of the frame as the compiler writes it, for messages: "earth::Gcrf".
template <Point F> std::string frame_name() {
  return detail::name_in(__PRETTY_FUNCTION__);
}

namespace detail {

/// frame_name<F>, for a function of a library that needs the name of a frame in its messages only.
using NameFunction = std::string (*)();

}  // namespace detail

// The arguments of doors and queries: to<B>, from<A>, in<C>, of<B>, relative_to<A>. of and relative_to also
// take points. For frames known only at run time there are To(b), From(a) and so on:
// kinematics/named/frame.hpp.
template <class F> struct To {};
template <class F> struct From {};
template <class F> struct In {};
template <class F> struct Of {};
template <class F> struct RelativeTo {};
template <class F> struct ObservedFrom {};

namespace detail {

/// The result of a door between two frames. A and B must differ: one frame at two instants needs two types.
template <class B, class A, class Result> using OfTwo = std::enable_if_t<!std::is_same_v<B, A>, Result>;

}  // namespace detail

template <Frame F> inline constexpr To<F> to{};
template <Frame F> inline constexpr From<F> from{};
template <Frame F> inline constexpr In<F> in{};
template <Point P> inline constexpr Of<P> of{};
template <Point P> inline constexpr RelativeTo<P> relative_to{};
template <Frame A> inline constexpr ObservedFrom<A> observed_from{};  // the observer is fixed in A

}  // namespace vectrix
