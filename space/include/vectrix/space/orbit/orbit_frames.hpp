#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/pointing/following_triad.hpp>

namespace vectrix {

/// Smallest sine of the angle between position and velocity from which an orbit frame is made. The rounding
/// of r x v turns the frame by about 1e-16 over the sine, and its rate has the relative error 1e-16 over the
/// square of the sine.
inline constexpr double nearly_rectilinear = 1e-7;

/// |r x v| / (|r| |v|), the sine of the angle between position and velocity. At zero the orbit has no plane
/// and no orbit frame: rectilinear motion, no velocity, or q at p.
template <class P, class Q, class A, class C, class S>
Quantity<si::dimensionless, S> distance_from_singularity(
    const Displacement<P, Q, In<C>, S>& r_pq_c, const Velocity<P, Q, ObservedFrom<A>, In<C>, S>& v_pq_a_c) {
  return Quantity<si::dimensionless, S>::from_value(
      detail::sine_between<S>(r_pq_c.coordinates(), v_pq_a_c.coordinates()));
}
template <class P, class Q, class A, class S>
Quantity<si::dimensionless, S> distance_from_singularity(const PointMotion<P, Q, A, S>& motion) {
  return distance_from_singularity(motion.position, motion.velocity);
}

namespace detail {

/// n = r x v, ndot = r x a, nddot = v x a + r x j
template <class S, std::size_t N> Jet<S, N - 1> normal_of(const Jet<S, N>& r) {
  Jet<S, N - 1> n;
  n[0] = r[0].cross(r[1]);
  if constexpr (N > 2) n[1] = r[0].cross(r[2]);
  if constexpr (N > 3) n[2] = r[1].cross(r[2]) + r[0].cross(r[3]);
  return n;
}

/// The axes x, y, z of an orbit frame, as signed axes of the triad whose first axis is along the position, or
/// along the velocity, and whose third is along r x v.
struct LvlhAxes {
  static constexpr const char* name = "lvlh";
  static constexpr std::size_t along = 0;  // derivatives of the position
  static constexpr std::array axes{2, -3, -1};
};
struct RicAxes {
  static constexpr const char* name = "ric";
  static constexpr std::size_t along = 0;
  static constexpr std::array axes{1, 2, 3};
};
struct VnbAxes {
  static constexpr const char* name = "vnb";
  static constexpr std::size_t along = 1;
  static constexpr std::array axes{1, 3, -2};
};
struct NtwAxes {
  static constexpr const char* name = "ntw";
  static constexpr std::size_t along = 1;
  static constexpr std::array axes{-2, 1, 3};
};

/// lvlh(from<Orbit>, Ship relative to Gcrf):
template <class Axes, class B, class P, class Q> std::string orbit_frame_place() {
  return std::string{Axes::name} + "(from<" + frame_name<B>() + ">, " + frame_name<Q>() + " relative to " +
         frame_name<P>() + "): ";
}
template <class Axes, class B, class P, class Q, class S>
void require_orbital_plane(const Column<S>& r, const Column<S>& v) {
  require_plane<S>(
      nearly_rectilinear, r, v,
      [](const std::string& r_norm, const std::string& v_norm) {
        return orbit_frame_place<Axes, B, P, Q>() + "|r| is " + r_norm + " m, |v| " + v_norm + " m/s";
      },
      "rectilinear motion has no orbital plane");
}

/// The columns of axes, or the components of a vector, of the triad in the order and with the signs of Axes.
template <class Axes, class S> Square<S> reordered_axes(const Square<S>& triad) {
  Square<S> columns;
  for (int i = 0; i < 3; ++i) {
    const int axis = Axes::axes[static_cast<std::size_t>(i)];
    columns.col(i) = axis > 0 ? Column<S>(triad.col(axis - 1)) : Column<S>(-triad.col(-axis - 1));
  }
  return columns;
}
template <class Axes, class S> Column<S> reordered(const Column<S>& x) {
  Column<S> y;
  for (int i = 0; i < 3; ++i) {
    const int axis = Axes::axes[static_cast<std::size_t>(i)];
    y(i) = axis > 0 ? x(axis - 1) : S(-x(-axis - 1));
  }
  return y;
}

/// The triad of the position r with its derivatives.
template <class Axes, class S, std::size_t N> FollowingTriad<S, N - 1> orbit_triad(const Jet<S, N>& r) {
  Jet<S, N - 1> p;
  for (std::size_t i = 0; i + 1 < N; ++i) p[i] = r[i + Axes::along];
  return {p, normal_of(r)};
}

/// Position, velocity, and if given acceleration and jerk of q relative to p, observed from the inertial a,
/// in a.
template <class P, class Q, InertialFrame A, class S, std::size_t N> struct OrbitPath { Jet<S, N> r; };
template <class P, class Q, class A, class S>
OrbitPath<P, Q, A, S, 2> orbit_path(const Displacement<P, Q, In<A>, S>& r_pq_a,
                                    const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a) {
  return {{r_pq_a.coordinates(), v_pq_a_a.coordinates()}};
}
template <class P, class Q, class A, class S>
OrbitPath<P, Q, A, S, 3> orbit_path(const Displacement<P, Q, In<A>, S>& r_pq_a,
                                    const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a,
                                    const Acceleration<P, Q, ObservedFrom<A>, In<A>, S>& a_pq_a_a) {
  return {{r_pq_a.coordinates(), v_pq_a_a.coordinates(), a_pq_a_a.coordinates()}};
}
template <class P, class Q, class A, class S>
OrbitPath<P, Q, A, S, 4> orbit_path(const Displacement<P, Q, In<A>, S>& r_pq_a,
                                    const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a,
                                    const Acceleration<P, Q, ObservedFrom<A>, In<A>, S>& a_pq_a_a,
                                    const Derivative<A, A, si::acceleration, S>& jerk_a_a) {
  return {{r_pq_a.coordinates(), v_pq_a_a.coordinates(), a_pq_a_a.coordinates(),
           jerk_a_a.vector().coordinates()}};
}
template <class P, class Q, class A, class S, class... Derivatives>
auto orbit_path(const PointMotion<P, Q, A, S>& motion, const Derivatives&... derivatives)
    -> decltype(orbit_path(motion.position, motion.velocity, derivatives...)) {
  return orbit_path(motion.position, motion.velocity, derivatives...);
}

// What is given decides what is known: (r, v) gives R, (r, v, a) also w, (r, v, a, da/dt|_a) also alpha.
template <class Axes, Frame A, Frame B, class S, std::size_t N>
auto frame_of(const FollowingTriad<S, N>& triad) {
  const Dcm<A, B, S> R{trusted, reordered_axes<Axes>(triad.axes)};
  if constexpr (N == 1) {
    return R;
  } else {
    const AngularVelocity<A, B, In<B>, S> w{trusted, reordered<Axes>(triad.w)};
    if constexpr (N == 2) {
      return MovingDcm<A, B, S>{R, w};
    } else {
      return AcceleratingDcm<A, B, S>{
          R, w, AngularAcceleration<A, B, In<B>, S>{trusted, reordered<Axes>(triad.alpha)}};
    }
  }
}
template <class Axes, Frame B, class P, class Q, class A, class S, std::size_t N>
auto following(const OrbitPath<P, Q, A, S, N>& path) {
  require_orbital_plane<Axes, B, P, Q>(path.r[0], path.r[1]);
  return frame_of<Axes, A, B>(orbit_triad<Axes>(path.r));
}

template <class Axes, class B, class... Motion>
using FollowingOf =
    std::enable_if_t<!InertialFrame<B>,
                     decltype(following<Axes, B>(orbit_path(std::declval<const Motion&>()...)))>;
template <class Axes, class FromFrame, class... Motion> inline constexpr bool follows = false;
template <class Axes, class B, class... Motion>
  requires requires {
    typename FollowingOf<Axes, B, Motion...>;
  }
inline constexpr bool follows<Axes, From<B>, Motion...> = true;

}  // namespace detail

/// The frame of a point q that orbits p, with the motion of q observed from the inertial frame a, in a:
///     lvlh   z to nadir, -r; y along -(r x v); x = y x z, forward      local vertical, local horizontal
/// What is given decides what is known:
///     lvlh(from<Lvlh>, r_pq_a, v_pq_a_a)                         Dcm<A, Lvlh>
///     lvlh(from<Lvlh>, r_pq_a, v_pq_a_a, a_pq_a_a)               MovingDcm<A, Lvlh>
///     lvlh(from<Lvlh>, r_pq_a, v_pq_a_a, a_pq_a_a, jerk_a_a)     AcceleratingDcm<A, Lvlh>
/// A PointMotion may stand for r and v. The jerk, d/dt|_a a_pq|a as a Derivative<A, A, si::acceleration>, is
/// that of the real motion: two bodies alone, without J2, make alpha wrong by 2e-9 rad/s^2 in a low orbit.
/// Throws BadInput if distance_from_singularity() is below nearly_rectilinear.
template <class B, class... Motion>
detail::FollowingOf<detail::LvlhAxes, B, Motion...> lvlh(From<B>, const Motion&... motion) {
  return detail::following<detail::LvlhAxes, B>(detail::orbit_path(motion...));
}
/// The same with x radial, r; z along r x v; y = z x x, forward: radial, in-track, cross-track. Also called
/// RSW, RTN or QSW.
template <class B, class... Motion>
detail::FollowingOf<detail::RicAxes, B, Motion...> ric(From<B>, const Motion&... motion) {
  return detail::following<detail::RicAxes, B>(detail::orbit_path(motion...));
}
/// The same with x along v; y along r x v; z = x x y, away from p: velocity, normal, binormal.
template <class B, class... Motion>
detail::FollowingOf<detail::VnbAxes, B, Motion...> vnb(From<B>, const Motion&... motion) {
  return detail::following<detail::VnbAxes, B>(detail::orbit_path(motion...));
}
/// The same with y along v; z along r x v; x = y x z, away from p: normal, tangential, cross-track.
template <class B, class... Motion>
detail::FollowingOf<detail::NtwAxes, B, Motion...> ntw(From<B>, const Motion&... motion) {
  return detail::following<detail::NtwAxes, B>(detail::orbit_path(motion...));
}
template <class FromFrame, class... Motion>
  requires(!detail::follows<detail::LvlhAxes, FromFrame, Motion...>)
auto lvlh(  // from<B>: not inertial; r, v, then a and da/dt: observed from one inertial a, in a
    FromFrame, const Motion&...) -> Refused = delete;
template <class FromFrame, class... Motion>
  requires(!detail::follows<detail::RicAxes, FromFrame, Motion...>)
auto ric(  // from<B>: not inertial; r, v, then a and da/dt: observed from one inertial a, in a
    FromFrame, const Motion&...) -> Refused = delete;
template <class FromFrame, class... Motion>
  requires(!detail::follows<detail::VnbAxes, FromFrame, Motion...>)
auto vnb(  // from<B>: not inertial; r, v, then a and da/dt: observed from one inertial a, in a
    FromFrame, const Motion&...) -> Refused = delete;
template <class FromFrame, class... Motion>
  requires(!detail::follows<detail::NtwAxes, FromFrame, Motion...>)
auto ntw(  // from<B>: not inertial; r, v, then a and da/dt: observed from one inertial a, in a
    FromFrame, const Motion&...) -> Refused = delete;

}  // namespace vectrix
