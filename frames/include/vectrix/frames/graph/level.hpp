#pragma once

#include <type_traits>
#include <vectrix/frames/dcm_chain.hpp>

namespace vectrix {

/// The level: what is known of the rotation between two frames. R alone; R and w; or R, w and alpha. Each
/// level is a type: Dcm here, MovingDcm and AcceleratingDcm in kinematics. A rate that is not
/// known is not taken for zero.
enum class Level { rotation, rate, acceleration };

/// The frames, scalar and level of a type that a graph edge may carry, and whether it has the position of the
/// second frame's origin. Specialised beside each such type.
template <class Value> struct LevelOf;

namespace detail {

template <class A, class B, class S, Level known, bool has_place> struct EdgeLevel {
  using first = A;
  using second = B;
  using scalar = S;
  static constexpr Level level = known;
  static constexpr bool placed = has_place;
};
template <class A, class B, class S, Level known> struct TurningLevel : EdgeLevel<A, B, S, known, false> {};
template <class A, class B, class S, Level known> struct PlacedLevel : EdgeLevel<A, B, S, known, true> {};

}  // namespace detail

template <class A, class B, class S>
struct LevelOf<Dcm<A, B, S>> : detail::TurningLevel<A, B, S, Level::rotation> {};

// The questions to a frame graph.
template <class B, class A> struct AskRotation;
template <class B, class A, class C> struct AskAngularVelocity;
template <class B, class A, class C> struct AskAngularAcceleration;
template <class B, class A> struct AskTransform;
template <class Q, class P, class C> struct AskPosition;
template <class Q, class P, class A, class C> struct AskVelocity;
template <class Q, class P, class A, class C> struct AskAcceleration;

/// The question that a value of type Answer answers; void for other types. Specialised beside each such type.
template <class Answer> struct QuestionOf : std::type_identity<void> {};
template <class B, class A, class S>
struct QuestionOf<Dcm<B, A, S>> : std::type_identity<AskRotation<B, A>> {};

template <class Value>
concept EdgeValue = requires {
  LevelOf<Value>::level;
};

/// The rotation in a value of any level.
template <class A, class B, class S> const Dcm<A, B, S>& rotation_of(const Dcm<A, B, S>& R_a_from_b) {
  return R_a_from_b;
}

}  // namespace vectrix
