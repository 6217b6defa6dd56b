#pragma once

#include <vectrix/dynamics/force/moment.hpp>
#include <vectrix/dynamics/mass/inertia.hpp>

namespace vectrix {
namespace detail {

template <class TorqueGiven, class B, class S>
inline constexpr bool is_central_torque = std::is_same_v<TorqueGiven, Vector<B, si::torque, S>> ||
                                          std::is_same_v<TorqueGiven, Torque<CentreOfMassOf<B>, In<B>, S>>;

}  // namespace detail

/// Euler's equation for a rigid body about its centre of mass, in its own axes:
///     J_b alpha_ib^b = tau^b - w_ib^b x (J_b w_ib^b)
/// It holds relative to an inertial frame only; another reference does not compile. The torque is about the
/// centre of mass: a `Torque<CentreOfMassOf<B>, In<B>>` has this in its type, for a `Vector<B, si::torque>`
/// it is a claim. Throws BadInput if the inertia has no inverse, as that of a rod. A torque w x (J w) that
/// underflows, below 1e-307 N m, is lost; propagate() refuses it.
template <class I, class B, class S, class TorqueGiven>
inline std::enable_if_t<InertialFrame<I> && detail::is_central_torque<TorqueGiven, B, S>,
                        AngularAcceleration<I, B, In<B>, S>>
euler(const Inertia<B, CentreOfMassOf<B>, In<B>, S>& J_b, const AngularVelocity<I, B, In<B>, S>& w_ib_b,
      const TorqueGiven& torque_b) {
  const detail::Column<S> momentum = J_b.matrix() * w_ib_b.coordinates();
  const detail::Column<S> net = torque_b.coordinates() - w_ib_b.coordinates().cross(momentum);
  return AngularAcceleration<I, B, In<B>, S>{detail::trusted, J_b.inverse_matrix() * net};
}
template <class InertiaOf, class InertiaAbout, class InertiaIn, class RateRelativeTo, class RateOf,
          class RateIn, class TorqueGiven, class S>
  requires(!(InertialFrame<RateRelativeTo> && std::is_same_v<InertiaOf, RateOf> &&
             std::is_same_v<InertiaOf, RateIn> && std::is_same_v<InertiaOf, InertiaIn> &&
             std::is_same_v<InertiaAbout, CentreOfMassOf<InertiaOf>> &&
             detail::is_central_torque<TorqueGiven, InertiaOf, S>))
auto euler(  // euler(J_b, w_ib_b, torque_b): i inertial; one body b, about its centre of mass, all in b
    const Inertia<InertiaOf, InertiaAbout, In<InertiaIn>, S>&,
    const AngularVelocity<RateRelativeTo, RateOf, In<RateIn>, S>&, const TorqueGiven&) -> Refused = delete;

}  // namespace vectrix
