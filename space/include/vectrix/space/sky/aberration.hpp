#pragma once

#include <Eigen/Core>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/vector.hpp>

namespace vectrix {

/// The speed of light, exact.
inline constexpr Quantity<si::velocity> speed_of_light = 299792458.0 * (si::metre / si::second);

namespace detail {

/// n a unit vector, v in m/s.
VECTRIX_EXPORT Eigen::Vector3d aberrated(const Eigen::Vector3d& n, const Eigen::Vector3d& v);

}  // namespace detail

/// The direction in which an observer sees light that comes from n, by the observer's motion v relative to
/// the frame in which n is given: for light from beyond the Earth, relative to the barycentre of the solar
/// system. With b = v/c and g = (1 - b^2)^-1/2, which for the Earth is a turn of up to 20.5 arcsec to v:
///     n' = (n/g + (1 + n.b/(1 + 1/g)) b) / (1 + n.b)
/// Throws BadInput unless |n| is 1 within 1e-9, and |v| is less than the speed of light.
template <Frame F>
Vector<F, si::dimensionless> aberrated(const Vector<F, si::dimensionless>& n_a,
                                       const Vector<F, si::velocity>& v_a) {
  return {detail::trusted, detail::aberrated(n_a.coordinates(), v_a.coordinates())};
}
template <class DirectionIn, class DirectionUnit, class VelocityIn, class VelocityUnit>
  requires(!std::same_as<DirectionIn, VelocityIn> || !std::same_as<DirectionUnit, si::dimensionless> ||
           !std::same_as<VelocityUnit, si::velocity>)
auto aberrated(  // aberrated(n_a, v_a): a direction and the velocity of the observer, in one frame
    const Vector<DirectionIn, DirectionUnit>&, const Vector<VelocityIn, VelocityUnit>&) -> Refused = delete;

}  // namespace vectrix
