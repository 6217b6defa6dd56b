#pragma once

#include <cmath>
#include <vectrix/dynamics/mass/inertia.hpp>
#include <vectrix/space/orbit/attraction.hpp>

namespace vectrix {

namespace detail {

template <class F> Caller gravity_at(const char* action) {
  return {action, [] { return "r in " + frame_name<F>(); }};
}

}  // namespace detail

/// Acceleration by a central point mass at the origin: a = - mu r / |r|^3. Throws BadInput if mu is not
/// positive or mu/|r|^3 not finite.
template <class I, class S>
Vector<I, si::acceleration, S> point_mass_gravity(const Quantity<si::gravitational_parameter, S>& mu,
                                                  const Vector<I, si::length, S>& r_i) {
  const S pull = detail::attraction<S>(detail::gravity_at<I>("point_mass_gravity"), mu.value(),
                                       r_i.coordinates().norm());
  return {detail::trusted, -pull * r_i.coordinates()};
}

/// Torque of a central point mass on a rigid body whose centre of mass is at r, to first order in the ratio
/// of the body's size to the distance:
///     tau^b = 3 mu / |r|^5  r^b x (J_b r^b)          (Hughes, Spacecraft Attitude Dynamics, section 8.1)
/// Throws BadInput if mu is not positive or mu/|r|^3 not finite.
template <class B, class S>
Vector<B, si::torque, S> gravity_gradient_torque(const Quantity<si::gravitational_parameter, S>& mu,
                                                 const Inertia<B, CentreOfMassOf<B>, In<B>, S>& J_b,
                                                 const Vector<B, si::length, S>& r_b) {
  const S distance = r_b.coordinates().norm();
  const S pull =
      detail::attraction<S>(detail::gravity_at<B>("gravity_gradient_torque"), mu.value(), distance);
  const detail::Column<S> direction = r_b.coordinates() / distance;
  return {detail::trusted, S(3) * pull * direction.cross(J_b.matrix() * direction)};
}
template <class InertiaOf, class InertiaAbout, class InertiaIn, class PositionIn, class S>
  requires(!(std::same_as<InertiaOf, PositionIn> && std::same_as<InertiaOf, InertiaIn> &&
             std::same_as<InertiaAbout, CentreOfMassOf<InertiaOf>>))
auto gravity_gradient_torque(  // J_b about the centre of mass and r_b: both in the body's frame
    const Quantity<si::gravitational_parameter, S>&,
    const Inertia<InertiaOf, InertiaAbout, In<InertiaIn>, S>&, const Vector<PositionIn, si::length, S>&)
    -> Refused = delete;

}  // namespace vectrix
