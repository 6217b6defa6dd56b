#pragma once

#include <cmath>
#include <vectrix/dynamics/inertia.hpp>

namespace vectrix {

namespace detail {

template <class F, class S> S checked_distance(const char* action, const Vector<F, si::length, S>& r) {
  const S distance = r.coordinates().norm();
  // Its cube divides.
  if (!all(distance * distance * distance > S(0))) {
    throw BadInput(std::string{action} + "(r in " + frame_name<F>() + "): |r| is " + text(distance) + " m");
  }
  return distance;
}

}  // namespace detail

/// Acceleration by a central point mass at the origin: a = - mu r / |r|^3. Throws BadInput when |r|^3 is
/// zero.
template <class I, class S>
Vector<I, si::acceleration, S> point_mass_gravity(const Quantity<si::gravitational_parameter, S>& mu,
                                                  const Vector<I, si::length, S>& r_i) {
  const S distance = detail::checked_distance("point_mass_gravity", r_i);
  return {detail::trusted, (-mu.value() / (distance * distance * distance)) * r_i.coordinates()};
}

/// Torque of a central point mass on a rigid body whose centre of mass is at r, to first order in size over
/// distance:
///     tau^b = 3 mu / |r|^5  r^b x (J_b r^b)          (Hughes, Spacecraft Attitude Dynamics, section 8.1)
/// Throws BadInput when |r|^3 is zero.
template <class B, class S>
Vector<B, si::torque, S> gravity_gradient_torque(const Quantity<si::gravitational_parameter, S>& mu,
                                                 const Inertia<B, CentreOfMassOf<B>, In<B>, S>& J_b,
                                                 const Vector<B, si::length, S>& r_b) {
  const S distance = detail::checked_distance("gravity_gradient_torque", r_b);
  const detail::Column<S> direction = r_b.coordinates() / distance;
  const S strength = S(3) * mu.value() / (distance * distance * distance);
  return {detail::trusted, strength * direction.cross(J_b.matrix() * direction)};
}
template <class InertiaOf, class InertiaAbout, class InertiaIn, class PositionIn, class S>
  requires(!(std::same_as<InertiaOf, PositionIn> && std::same_as<InertiaOf, InertiaIn> &&
             std::same_as<InertiaAbout, CentreOfMassOf<InertiaOf>>))
auto gravity_gradient_torque(  // J_b about the centre of mass and r_b: both in the body's frame
    const Quantity<si::gravitational_parameter, S>&,
    const Inertia<InertiaOf, InertiaAbout, In<InertiaIn>, S>&, const Vector<PositionIn, si::length, S>&)
    -> Refused = delete;

}  // namespace vectrix
