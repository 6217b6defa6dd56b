#pragma once

#include <vectrix/dynamics/multibody/body.hpp>

namespace vectrix::multibody {

/// A balanced rotor inside a body, whose mass properties contain it: it turns at the speed O, rad/s, relative
/// to its body about the unit vector n of the body's axes, with the inertia J_s, kg m^2, about n. A body's
/// torque tau on it:
///     J_s (O' + n.alpha) = tau,   and the body has J - J_s n n^T, -n tau and -w x n J_s (O + n.w)
/// One that is locked or driven has a given O': the body has J, and -n J_s O' for -n tau.
template <class S> struct Rotor {
  int body;  ///< 0: the hub; else the link with this number, counted from 1
  Column<S> axis;
  S inertia;
};

/// A mode of a flexible appendage of a body: its coordinate eta has the unit kg^1/2 m, mass 1, the frequency
/// W, rad/s, and the damping ratio z. The participations d_r, kg^1/2 m, and d_t, kg^1/2, are about the body's
/// origin, in its axes. Only the first moment depends on eta, mc = mc_0 + d_t eta:
///     eta'' + 2 z W eta' + W^2 eta = Q - d_r.alpha - d_t.a
///     f += 2 w x d_t eta' + d_t eta'',   n += w x d_r eta' + d_r eta''
/// so that momentum, angular momentum and energy are kept. With a constant first moment they are not.
template <class S> struct Mode {
  int body;
  Column<S> rotation, translation;  ///< d_r, d_t
  S frequency, damping_ratio;
};

/// A mode at one instant: d_r and d_t in the hub's axes, and Q - 2 z W eta' - W^2 eta.
template <class S> struct MovingMode {
  Column<S> r, t;
  S force;
};

/// Adds the momentum of a rotor to what its body needs; the body's J is already less J_s n n^T.
template <class S>
void add_rotor(const Rotor<S>& rotor, const Column<S>& axis_h, const S& speed, const S& torque,
               const Column<S>& w, Articulated<S>& I) {
  const S momentum(rotor.inertia * (speed + dot(axis_h, w)));
  I.n += cross(w, axis_h * momentum) + axis_h * torque;
}

/// Adds a mode, with eta and eta', to its body, which has the accelerations alpha and a at zero joint
/// accelerations.
template <class S>
void add_mode(const MovingMode<S>& mode, const S& eta, const S& rate, const Column<S>& w,
              const Column<S>& alpha, const Column<S>& a, Articulated<S>& I) {
  const Column<S> moment = mode.t * eta;
  const Square<S> H = hat(moment);
  I.H = {I.H.x + H.x, I.H.y + H.y, I.H.z + H.z};
  I.n += cross(moment, a) + cross(w, mode.r * rate);
  I.f += cross(alpha, moment) + cross(w, cross(w, moment) + mode.t * S(S(2.0) * rate));
  const S free(mode.force - dot(mode.r, alpha) - dot(mode.t, a));
  eliminate_one(I, mode.r, mode.t, S(1.0), free);
}

}  // namespace vectrix::multibody
