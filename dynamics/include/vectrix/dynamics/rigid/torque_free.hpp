#pragma once

#include <cmath>
#include <vectrix/dynamics/rigid/euler.hpp>
#include <vectrix/dynamics/rigid/free_rotation.hpp>
#include <vectrix/dynamics/rigid/state.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>

namespace vectrix {

/// The exact motion of a rigid body without torque, in closed form, at any time before or after the start:
///     w^p = (a1 cn(u), a2 sn(u), a3 dn(u)),  u = rho (t - t0) + u0      principal axes p (Jacobi 1850;
///     q_b^i = q_l^i q_z(Phi) s(h^p)* q_b^p,                             Landau, Lifshitz, Mechanics, 37)
/// with l along the angular momentum h, s(h) the shortest rotation of the third axis onto h, and
///     Phi(t) = mean rate (t - t0) + 2 arg theta(u + i eta)              theta of the squared nome
/// in every regime. Attitude and rate are accurate to a few roundings. The phases, in long double, lose 2e-18
/// of |h| (t - t0) over the smallest moment: on x86, 2e-14 rad after 1e4 rad; larger for slender bodies, by
/// the ratio of their moments. Made by torque_free(); copies are cheap.
template <InertialFrame I, Frame B> class TorqueFree {
 public:
  TorqueFree(detail::Trusted, const Inertia<B>& J_b, const Quantity<si::time>& epoch,
             detail::FreeRotation rotation)
      : inertia_(J_b), epoch_(epoch), rotation_(std::move(rotation)) {}

  /// Throws BadInput if the time is not finite.
  State<I, B> at(const Quantity<si::time>& t) const {
    const detail::RotationNumbers now = numbers(t);
    return {t, attitude(now), rate(now)};
  }
  /// R_b^i, w_ib^b and alpha_ib^b: an edge of a frame graph, edge(motion). Throws as at() does.
  AcceleratingDcm<I, B> operator()(const Quantity<si::time>& t) const {
    const detail::RotationNumbers now = numbers(t);
    const AngularVelocity<I, B, In<B>> w_ib_b = rate(now);
    return {dcm(attitude(now)), w_ib_b, euler(inertia_, w_ib_b, zero<si::torque>(in<B>))};
  }

  Regime regime() const { return rotation_.regime(); }
  /// The period of the rate, 4 K / rho. It is infinite on the separatrix, and for a constant rate.
  Quantity<si::time> period() const { return Quantity<si::time>::from_value(rotation_.period()); }

 private:
  detail::RotationNumbers numbers(const Quantity<si::time>& t) const {
    if (!std::isfinite(t.value())) {
      throw BadInput("TorqueFree of " + frame_name<B>() + " relative to " + frame_name<I>() +
                     ": the time is " + detail::text(t.value()) + " s");
    }
    return rotation_.at(static_cast<long double>(t.value()) - static_cast<long double>(epoch_.value()));
  }
  static Quaternion<I, B> attitude(const detail::RotationNumbers& now) {
    return {detail::trusted, [&] { return Eigen::Quaterniond(now.q[0], now.q[1], now.q[2], now.q[3]); }};
  }
  static AngularVelocity<I, B, In<B>> rate(const detail::RotationNumbers& now) {
    return AngularVelocity<I, B, In<B>>{detail::trusted,
                                        detail::Column<double>(now.w[0], now.w[1], now.w[2])};
  }

  Inertia<B> inertia_;
  Quantity<si::time> epoch_;
  detail::FreeRotation rotation_;
};

/// The torque-free motion through a given state, for any inertia tensor. Throws BadInput if a number is not
/// finite, or a principal moment is not positive.
template <class I, class B> TorqueFree<I, B> torque_free(const Inertia<B>& J_b, const State<I, B>& initial) {
  const std::string place = "torque_free(" + frame_name<B>() + " relative to " + frame_name<I>() + "): ";
  if (!std::isfinite(initial.time.value())) {
    throw BadInput(place + "the initial time is " + detail::text(initial.time.value()) + " s");
  }
  if (!J_b.matrix().allFinite()) throw BadInput(place + "an entry of the inertia tensor is not finite");
  const detail::Column<double> w = initial.w_ib_b.coordinates();
  if (!w.allFinite()) {
    throw BadInput(place + "the rate (" + detail::text(w.x()) + ", " + detail::text(w.y()) + ", " +
                   detail::text(w.z()) + ") rad/s is not finite");
  }
  detail::FreeRotation rotation(J_b.matrix(), initial.q_i_from_b.scalar_first(), w);
  if (!(rotation.smallest_moment() > 0.0)) {
    throw BadInput(place + "the smallest principal moment is " + detail::text(rotation.smallest_moment()) +
                   " kg m^2");
  }
  if (!J_b.has_inverse()) throw BadInput(place + detail::no_inverse(J_b));
  return {detail::trusted, J_b, initial.time, std::move(rotation)};
}
template <class InertiaOf, class InertiaAbout, class InertiaIn, class StateRelativeTo, class StateOf>
auto torque_free(  // torque_free(J_b, state of b): one body b, about its centre of mass, in its own axes
    const Inertia<InertiaOf, InertiaAbout, In<InertiaIn>>&, const State<StateRelativeTo, StateOf>&)
    -> Refused = delete;

}  // namespace vectrix
