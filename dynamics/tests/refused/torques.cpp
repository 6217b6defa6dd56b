// Torques
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Eci : inertial_frame {};
struct Body : moving_frame {};
struct Thruster : named_point {};
struct Hinge : named_point {};

namespace gravity_gradient_about_hinge {
// mistake: the gravity-gradient torque, about the centre of mass, with the inertia about a hinge
// expect: InertiaAbout = Hinge
auto gradient(const Quantity<si::gravitational_parameter>& mu, const Inertia<Body, Hinge>& J_hinge,
              const Inertia<Body>& J_body, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), gravity_gradient_torque(mu, J_body, r_body);
#else
  return static_cast<void>(J_body), gravity_gradient_torque(mu, J_hinge, r_body);
#endif
}
}  // namespace gravity_gradient_about_hinge

namespace gravity_gradient_of_inertial_position {
// mistake: the gravity-gradient torque in the body's axes with a position in inertial ones
// expect: PositionIn = Eci
// expect: InertiaOf = Body
auto gradient(const Quantity<si::gravitational_parameter>& mu, const Inertia<Body>& J_body,
              const Vector<Eci, si::length>& r_eci, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return gravity_gradient_torque(mu, J_body, R_body_from_eci * r_eci);
#else
  static_cast<void>(R_body_from_eci);
  return gravity_gradient_torque(mu, J_body, r_eci);
#endif
}
}  // namespace gravity_gradient_of_inertial_position

namespace moment_of_inertial_force {
// mistake: the moment of a force expressed in other axes than its lever arm
// expect: Displacement<Hinge, Body
// expect: Eci
auto torque(const Displacement<Hinge, Body, In<Body>>& r_hb, const Vector<Eci, si::force>& F_eci,
            const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return moment(r_hb, R_body_from_eci * F_eci);
#else
  return static_cast<void>(R_body_from_eci), moment(r_hb, F_eci);
#endif
}
}  // namespace moment_of_inertial_force

namespace shift_in_two_frames {
// mistake: a wrench shifted by a displacement expressed in other axes
// expect: Wrench<Thruster, (vectrix::)?In<Body>
// expect: Displacement<Thruster, Hinge, (vectrix::)?In<Eci>
auto about_hinge(const Wrench<Thruster, In<Body>>& W_thruster,
                 const Displacement<Thruster, Hinge, In<Eci>>& r_eci, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return shift(W_thruster, R_body_from_eci * r_eci);
#else
  return static_cast<void>(R_body_from_eci), shift(W_thruster, r_eci);
#endif
}
}  // namespace shift_in_two_frames

namespace shift_of_momentum_with_force {
// mistake: an angular momentum shifted with a force instead of the linear momentum
// expect: AngularMomentum<Thruster
// expect: si::force
auto about_hinge(const AngularMomentum<Thruster, In<Body>>& H_thruster,
                 const Displacement<Thruster, Hinge, In<Body>>& r_th, const Vector<Body, si::force>& F,
                 const Quantity<si::time>& t) {
#ifdef REPAIRED
  return shift(H_thruster, r_th, F * t);
#else
  return static_cast<void>(t), shift(H_thruster, r_th, F);
#endif
}
}  // namespace shift_of_momentum_with_force

namespace shift_of_refused_product {
// mistake: a wrench re-expressed by the inverse rotation, inside a shift
// expect: Dcm<Body, Eci
// expect: Wrench<Thruster, (vectrix::)?In<Body>
auto about_hinge(const Wrench<Thruster, In<Body>>& W_thruster,
                 const Displacement<Thruster, Hinge, In<Eci>>& r_th, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return shift(inverse(R_body_from_eci) * W_thruster, r_th);
#else
  return shift(R_body_from_eci * W_thruster, r_th);
#endif
}
}  // namespace shift_of_refused_product

namespace shift_with_displacement_reversed {
// mistake: a torque shifted by the displacement from the new point to the old
// expect: Torque<Thruster
// expect: Displacement<Hinge, Thruster
auto about_hinge(const Torque<Thruster, In<Body>>& M_thruster,
                 const Displacement<Hinge, Thruster, In<Body>>& r_ht, const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return shift(M_thruster, -r_ht, F);
#else
  return shift(M_thruster, r_ht, F);
#endif
}
}  // namespace shift_with_displacement_reversed

namespace torque_about_two_points {
// mistake: torques about different points added
// expect: Torque<Hinge
// expect: Torque<Thruster
auto total(const Torque<Hinge, In<Body>>& M_hinge, const Torque<Thruster, In<Body>>& M_thruster,
           const Displacement<Thruster, Hinge, In<Body>>& r_th, const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return M_hinge + shift(M_thruster, r_th, F);
#else
  return static_cast<void>(r_th), static_cast<void>(F), M_hinge + M_thruster;
#endif
}
}  // namespace torque_about_two_points

namespace torque_of_a_force {
// mistake: a force at the door for a torque
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::force
auto torque(const Displacement<Hinge, Body, In<Body>>& r_hb, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return moment(r_hb, F_body);
#else
  return static_cast<void>(r_hb), torque_about<Hinge>(F_body);
#endif
}
}  // namespace torque_of_a_force

namespace wrench_about_two_points {
// mistake: wrenches about different points added
// expect: Wrench<Hinge
// expect: Wrench<Thruster
auto total(const Wrench<Hinge, In<Body>>& W_hinge, const Wrench<Thruster, In<Body>>& W_thruster,
           const Displacement<Thruster, Hinge, In<Body>>& r_th) {
#ifdef REPAIRED
  return W_hinge + shift(W_thruster, r_th);
#else
  return static_cast<void>(r_th), W_hinge + W_thruster;
#endif
}
}  // namespace wrench_about_two_points

namespace wrench_in_two_frames {
// mistake: wrenches expressed in different frames added
// expect: Wrench<Hinge, (vectrix::)?In<Body>
// expect: Wrench<Hinge, (vectrix::)?In<Eci>
auto total(const Wrench<Hinge, In<Body>>& W_body, const Wrench<Hinge, In<Eci>>& W_eci,
           const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return W_body + R_body_from_eci * W_eci;
#else
  return static_cast<void>(R_body_from_eci), W_body + W_eci;
#endif
}
}  // namespace wrench_in_two_frames
