// Rigid motions, screws and twists
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
struct Tip : named_point {};

namespace moving_transform_times_transform {
// mistake: a place without a velocity chained to a motion, as if it were at rest
// expect: MovingTransform<Gcrf, Body
// expect: Transform<Body, Camera
// expect: the kinds go together
auto motion(const MovingTransform<Gcrf, Body>& ib, const Transform<Body, Camera>& X_b_from_c,
            const MovingTransform<Body, Camera>& bc) {
#ifdef REPAIRED
  return (static_cast<void>(X_b_from_c), ib * bc);
#else
  return static_cast<void>(bc), ib * X_b_from_c;
#endif
}
}  // namespace moving_transform_times_transform

namespace screw_driven_by_twist_elsewhere {
// mistake: a screw driven by the twist at b's origin in a's axes, neither the body nor the reference form
// expect: Screw<Gcrf, Body
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Gcrf>
auto change(const Screw<Gcrf, Body>& xi_ab, const Twist<Gcrf, Body, At<Body>, In<Gcrf>>& V_ab_a) {
#ifdef REPAIRED
  return rate(xi_ab, inverse(exp(xi_ab).rotation) * V_ab_a);
#else
  return rate(xi_ab, V_ab_a);
#endif
}
}  // namespace screw_driven_by_twist_elsewhere

namespace screw_in_two_frames {
// mistake: a screw whose rotation is expressed in b and whose translation in a
// expect: OfFrame = (vectrix::)?Of<Body>
// expect: Rotation = (vectrix::)?Vector<Body
// expect: Translation = (vectrix::)?Vector<Gcrf
// expect: an angle and a length expressed in one of them
auto motion(const Vector<Body, si::angle>& theta_b, const Vector<Gcrf, si::length>& rho_a,
            const Dcm<Body, Gcrf>& R_b_from_a) {
#ifdef REPAIRED
  return screw(of<Body>, relative_to<Gcrf>, theta_b, R_b_from_a * rho_a);
#else
  static_cast<void>(R_b_from_a);
  return screw(of<Body>, relative_to<Gcrf>, theta_b, rho_a);
#endif
}
}  // namespace screw_in_two_frames

namespace screws_chained {
// mistake: two screws added, as twists are
// expect: Left = (vectrix::)?Screw<Gcrf, Body
// expect: Right = (vectrix::)?Screw<Body, Camera
Transform<Gcrf, Camera> place(const Screw<Gcrf, Body>& xi_ab, const Screw<Body, Camera>& xi_bc) {
#ifdef REPAIRED
  return exp(xi_ab) * exp(xi_bc);
#else
  return exp(xi_ab + xi_bc);
#endif
}
}  // namespace screws_chained

namespace twist_at_two_points {
// mistake: twists taken at different points added
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: Twist<Body, Camera, (vectrix::)?At<Tip>
auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib,
            const Twist<Body, Camera, At<Tip>, In<Body>>& V_bc,
            const Displacement<Body, Tip, In<Body>>& r_bt_b) {
#ifdef REPAIRED
  return shift(V_ib, r_bt_b) + V_bc;
#else
  return static_cast<void>(r_bt_b), V_ib + V_bc;
#endif
}
}  // namespace twist_at_two_points

namespace twist_by_reversed_transform {
// mistake: a twist taken to another frame by the inverse transform
// expect: Transform<Body, Camera
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Body>
auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib, const Transform<Body, Camera>& X_b_from_c) {
#ifdef REPAIRED
  return inverse(X_b_from_c) * V_ib;
#else
  return X_b_from_c * V_ib;
#endif
}
}  // namespace twist_by_reversed_transform

namespace twist_from_screw_in_third_frame {
// mistake: the twist of a screw that changes, asked in neither of its two frames
// expect: Screw<A, B, S>|Screw<Gcrf, Body
// expect: Expressed = (vectrix::)?In<Camera>
// expect: twist_from.xi_ab, xidot_ab, in<B>. or in<A>
auto motion(const Screw<Gcrf, Body>& xi_ab, const ScrewRate<Gcrf, Body>& xidot_ab,
            const Transform<Camera, Body>& X_c_from_b) {
#ifdef REPAIRED
  return X_c_from_b * twist_from(xi_ab, xidot_ab, in<Body>);
#else
  static_cast<void>(X_c_from_b);
  return twist_from(xi_ab, xidot_ab, in<Camera>);
#endif
}
}  // namespace twist_from_screw_in_third_frame

namespace twist_held_in_mixed_form {
// mistake: a twist at b's origin held in a's axes, whose motion is no exponential
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Gcrf>
// expect: V_ab held at b in b, or at a in a
auto later(const Transform<Gcrf, Body>& X_a_from_b, const Twist<Gcrf, Body, At<Body>, In<Gcrf>>& V_ab_a,
           Quantity<si::time> t) {
#ifdef REPAIRED
  return moved(X_a_from_b, inverse(X_a_from_b.rotation) * V_ab_a, t);
#else
  return moved(X_a_from_b, V_ab_a, t);
#endif
}
}  // namespace twist_held_in_mixed_form

namespace twist_held_of_other_pair {
// mistake: a transform moved by the twist of another frame
// expect: TransformTo = Gcrf
// expect: TransformFrom = Body
// expect: Motion = (vectrix::)?Twist<Gcrf, Camera, (vectrix::)?At<Camera>, (vectrix::)?In<Camera>
auto later(const Transform<Gcrf, Body>& X_a_from_b, const Transform<Gcrf, Camera>& X_a_from_c,
           const Twist<Gcrf, Camera, At<Camera>, In<Camera>>& V_ac_c, Quantity<si::time> t) {
#ifdef REPAIRED
  static_cast<void>(X_a_from_b);
  return moved(X_a_from_c, V_ac_c, t);
#else
  static_cast<void>(X_a_from_c);
  return moved(X_a_from_b, V_ac_c, t);
#endif
}
}  // namespace twist_held_of_other_pair

namespace twist_rates_added {
// mistake: rates of twists added, without the bracket
// expect: Left = (vectrix::)?TwistRate<Gcrf, Body, (vectrix::)?At<Camera>, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?TwistRate<Body, Camera, (vectrix::)?At<Camera>, (vectrix::)?In<Body>
template <class A, class B> using V = Twist<A, B, At<Camera>, In<Body>>;
template <class A, class B> using Vdot = TwistRate<A, B, At<Camera>, In<Body>>;

Vdot<Gcrf, Camera> motion(const V<Gcrf, Body>& V_ab, const Vdot<Gcrf, Body>& Vdot_ab,
                          const V<Body, Camera>& V_bc, const Vdot<Body, Camera>& Vdot_bc) {
#ifdef REPAIRED
  return chain(Vdot_ab, Vdot_bc, V_ab, V_bc);
#else
  static_cast<void>(V_ab);
  static_cast<void>(V_bc);
  return Vdot_ab + Vdot_bc;
#endif
}
}  // namespace twist_rates_added

namespace twist_shifted_backwards {
// mistake: a twist shifted by the position of the wrong end
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: Displacement<Tip, Body
auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib,
            const Displacement<Tip, Body, In<Body>>& r_tb_b) {
#ifdef REPAIRED
  return shift(V_ib, -r_tb_b);
#else
  return shift(V_ib, r_tb_b);
#endif
}
}  // namespace twist_shifted_backwards
