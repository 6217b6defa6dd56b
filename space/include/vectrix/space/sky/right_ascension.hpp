#pragma once

#include <Eigen/Core>
#include <type_traits>

#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

/// The place of a direction on the sky: right ascension from x over y, in [0, 2 pi); declination from the
/// plane of x and y to z, in [-pi/2, pi/2].
struct RightAscensionDeclination {
  Quantity<si::angle> right_ascension, declination;
};

namespace detail {

VECTRIX_EXPORT RightAscensionDeclination right_ascension_of(const Caller& name, const Eigen::Vector3d& r);
VECTRIX_EXPORT Eigen::Vector3d direction_of(const Caller& name, const RightAscensionDeclination& place);

/// The frames that have right ascensions: the inertial ones, and that of the true equator and equinox of
/// date.
template <class F> inline constexpr bool has_right_ascension = InertialFrame<F>;
template <> inline constexpr bool has_right_ascension<earth::TrueOfDate> = true;

}  // namespace detail

/// Right ascension and declination of a vector or a displacement, of any length, in an inertial frame or in
/// earth::TrueOfDate, earth::Teme. At the poles the right ascension is undefined: it is 0. Throws BadInput
/// for the zero vector.
template <class A, class U>
std::enable_if_t<detail::has_right_ascension<A>, RightAscensionDeclination> right_ascension_declination(
    const Vector<A, U>& r_a) {
  return detail::right_ascension_of({"right_ascension_declination", [] { return "in " + frame_name<A>(); }},
                                    r_a.coordinates());
}
template <class P, class Q, class A>
std::enable_if_t<detail::has_right_ascension<A>, RightAscensionDeclination> right_ascension_declination(
    const Displacement<P, Q, In<A>>& r_pq_a) {
  return right_ascension_declination(r_pq_a.vector());
}
template <class Given>
auto right_ascension_declination(  // of a vector or a displacement in a frame that is inertial, or of date
    const Given&) -> Refused = delete;

/// The inverse: the unit vector. Throws BadInput if an angle is not finite or |declination| exceeds pi/2.
template <class A>
std::enable_if_t<detail::has_right_ascension<A>, Vector<A, si::dimensionless>> direction_at(
    In<A>, const RightAscensionDeclination& place) {
  return {detail::trusted,
          detail::direction_of({"direction_at", [] { return "in<" + frame_name<A>() + ">"; }}, place)};
}
template <class InFrame, class... Given>
auto direction_at(  // in<A>, RightAscensionDeclination: a inertial, or of date
    InFrame, const Given&...) -> Refused = delete;

}  // namespace vectrix
