#pragma once

#include <vectrix/dynamics/multibody/articulated.hpp>

namespace vectrix::multibody {

/// The mass of a body, kg, its first moment m c, kg m, and its inertia, kg m^2, about its own origin, in its
/// own axes. The origin lies on the joint on which the body hangs.
template <class S> struct Mass {
  S m;
  Column<S> mc;
  Symmetric<S> J;
};

/// A body at one instant. All vectors are in the hub's axes.
template <class S> struct Moving {
  Square<S> R;             ///< R_b^h
  Column<S> r;             ///< from the parent's origin to this one
  Column<S> w;             ///< w_ib
  Column<S> alpha0, a0;    ///< accelerations if all joint accelerations were zero
  Articulated<S> I;        ///< with what hangs on it; after the inward pass, what the joint leaves of it
  Column<S> alpha, a;      ///< what the joint accelerations add to alpha0 and a0
  Column<S> axis, U, V;    ///< hinge and slider: the freedom, and the momentum at unit speed
  S inverse_D, e;          ///< hinge and slider
  Square<S> G;             ///< ball: A^-1 H
  Column<S> alpha_e, a_e;  ///< ball and free: accelerations of the body itself, the ball's for a = 0
};

/// The parent is the hub: R = 1, r = 0, and at zero accelerations it has none.
template <class S> struct OnHub { Column<S> w; };

// In the hub's axes, of what is in the parent's.
template <class S> [[gnu::always_inline]] inline Square<S> in_hub(const OnHub<S>&, const Square<S>& R) {
  return R;
}
template <class S> [[gnu::always_inline]] inline Square<S> in_hub(const Moving<S>& p, const Square<S>& R) {
  return p.R * R;
}
template <class S> [[gnu::always_inline]] inline Column<S> in_hub(const OnHub<S>&, const Column<S>& v) {
  return v;
}
template <class S> [[gnu::always_inline]] inline Column<S> in_hub(const Moving<S>& p, const Column<S>& v) {
  return p.R * v;
}

// At zero joint accelerations: alpha_b = alpha_p + w_p x w_pb and a of a point of the parent.
template <class S>
[[gnu::always_inline]] inline Column<S> turned_with(const OnHub<S>& p, const Column<S>& w_pb) {
  return cross(p.w, w_pb);
}
template <class S>
[[gnu::always_inline]] inline Column<S> turned_with(const Moving<S>& p, const Column<S>& w_pb) {
  return p.alpha0 + cross(p.w, w_pb);
}
template <class S> [[gnu::always_inline]] inline Column<S> carried_by(const OnHub<S>& p, const Column<S>& r) {
  return cross(p.w, cross(p.w, r));
}
template <class S>
[[gnu::always_inline]] inline Column<S> carried_by(const Moving<S>& p, const Column<S>& r) {
  return p.a0 + cross(p.alpha0, r) + cross(p.w, cross(p.w, r));
}

/// The inertia of a rigid body in the hub's axes, and the wrench that it needs at zero joint accelerations:
///     n = J alpha + mc x a + w x J w,   f = m a + alpha x mc + w x (w x mc)
/// From here on no velocity occurs.
template <class S> [[gnu::always_inline]] inline void load_rigid(const Mass<S>& body, Moving<S>& b) {
  const Column<S> mc = b.R * body.mc;
  b.I.A = rotated(b.R, body.J);
  b.I.H = hat(mc);
  b.I.M = diagonal(body.m);
  b.I.n = b.I.A * b.alpha0 + cross(mc, b.a0) + cross(b.w, b.I.A * b.w);
  b.I.f = b.a0 * body.m + cross(b.alpha0, mc) + cross(b.w, cross(b.w, mc));
}

}  // namespace vectrix::multibody
