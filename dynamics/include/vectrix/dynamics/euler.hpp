#pragma once

#include <vectrix/dynamics/inertia.hpp>

namespace vectrix {

/// Euler's equation for a rigid body about its centre of mass, in its own axes:
///     J_b alpha_ib^b = tau^b - w_ib^b x (J_b w_ib^b)
/// It holds relative to an inertial frame only; another reference does not compile. Any finite input is
/// valid.
template <InertialFrame I, class B, class S>
inline AngularAcceleration<I, B, In<B>, S> euler(const Inertia<B, S>& J_b,
                                                 const AngularVelocity<I, B, In<B>, S>& w_ib_b,
                                                 const Vector<B, si::torque, S>& torque_b) {
  const detail::Column<S> momentum = J_b.matrix() * w_ib_b.coordinates();
  const detail::Column<S> net = torque_b.coordinates() - w_ib_b.coordinates().cross(momentum);
  return AngularAcceleration<I, B, In<B>, S>{detail::trusted, J_b.inverse_matrix() * net};
}
template <class RotatingReference, class InertiaOf, class RateOf, class RateIn, class TorqueIn, class U,
          class S>
  requires(!InertialFrame<RotatingReference>)
void euler(const Inertia<InertiaOf, S>&,  // euler(J_b, w_ib_b, torque_b): i must be inertial
           const AngularVelocity<RotatingReference, RateOf, In<RateIn>, S>&,
           const Vector<TorqueIn, U, S>&) = delete;
template <InertialFrame I, class InertiaOf, class RateOf, class RateIn, class TorqueIn, class TorqueUnit,
          class S>
  requires(!(std::same_as<InertiaOf, RateOf> && std::same_as<InertiaOf, RateIn> &&
             std::same_as<InertiaOf, TorqueIn> && std::same_as<TorqueUnit, si::torque>))
void euler(const Inertia<InertiaOf, S>&,  // euler(J_b, w_ib_b, torque_b): one body b, all in b, a torque
           const AngularVelocity<I, RateOf, In<RateIn>, S>&, const Vector<TorqueIn, TorqueUnit, S>&) = delete;

}  // namespace vectrix
