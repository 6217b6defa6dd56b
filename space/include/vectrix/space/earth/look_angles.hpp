#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <utility>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/site.hpp>

namespace vectrix {

/// Where a point is seen from a place: azimuth in [0, 2 pi), from the north over the east; elevation above
/// the horizon in [-pi/2, pi/2], geometric, without refraction; and the distance.
struct LookAngles {
  Quantity<si::angle> azimuth, elevation;
  Quantity<si::length> range;
};

/// Look angles and their time derivatives.
struct MovingLookAngles : LookAngles {
  Quantity<si::angular_velocity> azimuth_rate, elevation_rate;
  Quantity<si::velocity> range_rate;
};

namespace detail {

VECTRIX_EXPORT LookAngles look_angles_of(const Caller& name, const Eigen::Vector3d& r);
VECTRIX_EXPORT MovingLookAngles look_angles_of(const Caller& name, const Eigen::Vector3d& r,
                                               const Eigen::Vector3d& v);
VECTRIX_EXPORT Eigen::Vector3d position_of(const Caller& name, const LookAngles& look);

template <class S, class Q> Caller look_of(const char* action) {
  return {action, [] { return frame_name<Q>() + " from " + frame_name<S>(); }};
}

template <class S, class Q>
std::enable_if_t<EastNorthUpFrame<S>, LookAngles> look(const Displacement<S, Q, In<S>>& r_sq_s) {
  return look_angles_of(look_of<S, Q>("look_angles"), r_sq_s.coordinates());
}
template <class S, class Q>
std::enable_if_t<EastNorthUpFrame<S>, MovingLookAngles> look(
    const Displacement<S, Q, In<S>>& r_sq_s, const Velocity<S, Q, ObservedFrom<S>, In<S>>& v_sq_s_s) {
  return look_angles_of(look_of<S, Q>("look_angles"), r_sq_s.coordinates(), v_sq_s_s.coordinates());
}
template <class S, class Q>
std::enable_if_t<EastNorthUpFrame<S>, MovingLookAngles> look(const PointMotion<S, Q, S>& motion) {
  return look(motion.position, motion.velocity);
}
template <class... Given> using LookOf = decltype(look(std::declval<const Given&>()...));
template <class... Given>
concept HasLook = requires {
  typename LookOf<Given...>;
};

}  // namespace detail

/// Look angles of the point q from the origin of the east-north-up frame s, of r_sq^s = (e, n, u):
///     tan A = e/n,      tan E = u/h, h = sqrt(e^2 + n^2),      range |r|
/// In the zenith and the nadir, h = 0, the azimuth is undefined: it is 0. Throws BadInput if q is at s, or
/// |r| overflows. With the velocity that s observes, v = rdot^s, or of a PointMotion, also their rates:
///     look_angles(r_sq_s)                 LookAngles
///     look_angles(r_sq_s, v_sq_s_s)       MovingLookAngles
///     dA/dt = (n edot - e ndot)/h^2,  dE/dt = (h^2 udot - u (e edot + n ndot))/(h |r|^2),  d|r|/dt = r.v/|r|
/// The rate of the azimuth grows as 1/h. Throws BadInput also where h = 0, where the angles have no rates,
/// and if a rate overflows.
template <class... Given> detail::LookOf<Given...> look_angles(const Given&... given) {
  return detail::look(given...);
}
template <class... Given>
  requires(!detail::HasLook<Given...>)
auto look_angles(  // of r_sq_s; with rates of r_sq_s, v_sq_s_s: s the origin of an east_north_up_frame
    const Given&...) -> Refused = delete;

/// The inverse: claims that q is seen from the origin of s at these angles and this range. Throws BadInput if
/// a number is not finite, |elevation| exceeds pi/2, or the range is negative.
template <class Q, class S>
std::enable_if_t<EastNorthUpFrame<S>, detail::OfTwo<S, Q, Displacement<S, Q, In<S>>>> displacement_at(
    Of<Q>, RelativeTo<S>, const LookAngles& look) {
  return Displacement<S, Q, In<S>>{detail::trusted,
                                   detail::position_of(detail::look_of<S, Q>("displacement_at"), look)};
}
template <class OfPoint, class RelativeToPoint, class Given>
auto displacement_at(  // of<Q>, relative_to<S>, LookAngles: s the origin of an east_north_up_frame
    OfPoint, RelativeToPoint, const Given&) -> Refused = delete;

}  // namespace vectrix
