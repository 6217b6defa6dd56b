#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include <vectrix/space/pointing/moving_direction.hpp>

namespace vectrix {

/// Smallest sine of the angle between two directions that fix an attitude. The rounding of their cross
/// product turns it by about 1e-16 over the sine, and its rate has the relative error 1e-16 over the square.
inline constexpr double nearly_one_direction = 1e-7;

/// An axis of the body b that lies along a direction: align(unit_z(in<Body>), moving_direction(...)).
template <Frame B, Frame A, Level level, class S = double> struct Alignment {
  Vector<B, si::dimensionless, S> axis;
  MovingDirection<A, level, S> direction;
};
/// An axis of the body b that lies as near as possible to a direction: constrain(unit_x(in<Body>), ...).
template <Frame B, Frame A, Level level, class S = double> struct Constraint {
  Vector<B, si::dimensionless, S> axis;
  MovingDirection<A, level, S> direction;
};

/// The first words of pointing(): which axis of the body lies along which direction.
template <class B, class A, Level level, class S>
detail::OfTwo<B, A, Alignment<B, A, level, S>> align(const Vector<B, si::dimensionless, S>& axis_b,
                                                     const MovingDirection<A, level, S>& direction_a) {
  return Alignment<B, A, level, S>{axis_b, direction_a};
}
/// The second words: which other axis lies as near as possible to which other direction.
template <class B, class A, Level level, class S>
detail::OfTwo<B, A, Constraint<B, A, level, S>> constrain(const Vector<B, si::dimensionless, S>& axis_b,
                                                          const MovingDirection<A, level, S>& direction_a) {
  return Constraint<B, A, level, S>{axis_b, direction_a};
}
template <class Axis, class Along>
auto align(  // axis_b, a MovingDirection observed from another frame a
    const Axis&, const Along&) -> Refused = delete;
template <class Axis, class Along>
auto constrain(  // axis_b, a MovingDirection observed from another frame a
    const Axis&, const Along&) -> Refused = delete;

namespace detail {

/// name() begins the message; `what` are the two vectors.
template <class S, class Name>
void require_two_directions(const Name& name, const char* what, const Column<S>& u, const Column<S>& v) {
  require_plane<S>(
      nearly_one_direction, u, v,
      [&](const std::string& u_norm, const std::string& v_norm) {
        return name() + "the lengths of the two " + what + " are " + u_norm + " and " + v_norm;
      },
      "one direction fixes no attitude");
}

/// What is known at a level of R_b^a = T_a T_b^T: the triads of two directions in a and of two axes of b.
template <class A, class B, class S>
Dcm<A, B, S> held_together(const FollowingTriad<S, 1>& triad_a, const Square<S>& axes_b) {
  return {trusted, Square<S>(triad_a.axes * axes_b.transpose())};
}
template <class A, class B, class S>
MovingDcm<A, B, S> held_together(const FollowingTriad<S, 2>& triad_a, const Square<S>& axes_b) {
  return {Dcm<A, B, S>{trusted, Square<S>(triad_a.axes * axes_b.transpose())},
          AngularVelocity<A, B, In<B>, S>{trusted, Column<S>(axes_b * triad_a.w)}};
}
template <class A, class B, class S>
AcceleratingDcm<A, B, S> held_together(const FollowingTriad<S, 3>& triad_a, const Square<S>& axes_b) {
  return {Dcm<A, B, S>{trusted, Square<S>(triad_a.axes * axes_b.transpose())},
          AngularVelocity<A, B, In<B>, S>{trusted, Column<S>(axes_b * triad_a.w)},
          AngularAcceleration<A, B, In<B>, S>{trusted, Column<S>(axes_b * triad_a.alpha)}};
}

/// `law` names the caller in messages.
template <class B, class A, Level first, Level second, class S>
auto pointed_by(const char* law, const Alignment<B, A, first, S>& alignment,
                const Constraint<B, A, second, S>& constraint) {
  constexpr Level level = std::min(first, second);
  const auto name = [law] {
    return std::string{law} + "(" + frame_name<B>() + " relative to " + frame_name<A>() + "): ";
  };
  const auto p_a = leading<level>(alignment.direction.numbers());
  const auto s_a = leading<level>(constraint.direction.numbers());
  const Column<S>&p_b = alignment.axis.coordinates(), &s_b = constraint.axis.coordinates();
  require_two_directions(name, "directions", p_a[0], s_a[0]);
  require_two_directions(name, "axes", p_b, s_b);
  const FollowingTriad<S, known_at(level)> triad_a(p_a, cross_of(p_a, s_a));
  const FollowingTriad<S, 1> triad_b({p_b}, {p_b.cross(s_b)});
  return held_together<A, B>(triad_a, triad_b.axes);
}

template <class First, class Second> inline constexpr bool points = false;
template <class B, class A, Level first, Level second, class S>
inline constexpr bool points<Alignment<B, A, first, S>, Constraint<B, A, second, S>> = !InertialFrame<B>;

}  // namespace detail

/// The attitude of a body of which one axis lies along a direction, and another as near as possible to a
/// second direction (aligned and constrained):
///     pointing(align(unit_z(in<Body>), nadir), constrain(unit_x(in<Body>), sun))
/// With x along the first and z along p x s, the triads T_a of the directions and T_b of the axes give
///     R_b^a = T_a T_b^T
/// and their derivatives w_ab^b and alpha_ab^b. The lower level of the two directions decides what is known:
/// a Dcm<A, Body>, a MovingDcm or an AcceleratingDcm. Throws BadInput if distance_from_singularity() of the
/// directions, or the sine of the angle between the axes, is below nearly_one_direction.
template <class B, class A, Level first, Level second, class S>
  requires(!InertialFrame<B>)
auto pointing(const Alignment<B, A, first, S>& alignment, const Constraint<B, A, second, S>& constraint) {
  return detail::pointed_by("pointing", alignment, constraint);
}
template <class First, class Second>
  requires(!detail::points<First, Second>)
auto pointing(  // align(axis_b, direction_a), constrain(axis_b, direction_a): b not inertial; one b, one a
    const First&, const Second&) -> Refused = delete;

}  // namespace vectrix
