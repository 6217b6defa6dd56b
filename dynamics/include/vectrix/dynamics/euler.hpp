#pragma once

#include <vectrix/dynamics/inertia.hpp>

namespace vectrix {

/// Euler's equation for a rigid body about its centre of mass, in its own axes:
///     J_b alpha_ib^b = tau^b - w_ib^b x (J_b w_ib^b)
/// It holds relative to an inertial frame only; another reference does not compile. Any finite input is
/// valid.
template <class I, class B, class S>
inline std::enable_if_t<InertialFrame<I>, AngularAcceleration<I, B, In<B>, S>> euler(
    const Inertia<B, S>& J_b, const AngularVelocity<I, B, In<B>, S>& w_ib_b,
    const Vector<B, si::torque, S>& torque_b) {
  const detail::Column<S> momentum = J_b.matrix() * w_ib_b.coordinates();
  const detail::Column<S> net = torque_b.coordinates() - w_ib_b.coordinates().cross(momentum);
  return AngularAcceleration<I, B, In<B>, S>{detail::trusted, J_b.inverse_matrix() * net};
}
template <class InertiaOf, class RateRelativeTo, class RateOf, class RateIn, class TorqueIn, class TorqueUnit,
          class S>
  requires(!(InertialFrame<RateRelativeTo> && std::is_same_v<InertiaOf, RateOf> &&
             std::is_same_v<InertiaOf, RateIn> && std::is_same_v<InertiaOf, TorqueIn> &&
             std::is_same_v<TorqueUnit, si::torque>))
auto euler(  // euler(J_b, w_ib_b, torque_b): i is inertial; one body b, all in b; a torque
    const Inertia<InertiaOf, S>&, const AngularVelocity<RateRelativeTo, RateOf, In<RateIn>, S>&,
    const Vector<TorqueIn, TorqueUnit, S>&) -> Refused = delete;

}  // namespace vectrix
