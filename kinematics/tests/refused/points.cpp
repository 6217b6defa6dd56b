// Velocities and accelerations of points
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
struct Tip : named_point {};

namespace acceleration_transport_without_coriolis {
// mistake: an acceleration transported as if it were a velocity, without Euler and Coriolis
// expect: Acceleration<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
auto motion(const Acceleration<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& a_b,
            const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_ib_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, a_b, v_b, r_b, alpha_ib_b, w_ib_b);
#else
  return static_cast<void>(alpha_ib_b), static_cast<void>(v_b),
         transport(observed_from<Gcrf>, a_b, r_b, w_ib_b);
#endif
}
}  // namespace acceleration_transport_without_coriolis

namespace centrifugal_across_frames {
// mistake: a rate and a position expressed in different frames
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: Displacement<Gcrf, Tip, (vectrix::)?In<Body>
auto motion(const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_ib_i, const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return centrifugal_acceleration(R_b_from_i * w_ib_i, r_b);
#else
  return static_cast<void>(R_b_from_i), centrifugal_acceleration(w_ib_i, r_b);
#endif
}
}  // namespace centrifugal_across_frames

namespace coriolis_of_inertial_velocity {
// mistake: the Coriolis acceleration of the inertial observer's velocity
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Gcrf>
// expect: AngularVelocity<Gcrf, Body
auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Gcrf>, In<Body>>& v_i,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return coriolis_acceleration(w_ib_b, transport(observed_from<Body>, v_i, r_b, -w_ib_b));
#else
  return static_cast<void>(r_b), coriolis_acceleration(w_ib_b, v_i);
#endif
}
}  // namespace coriolis_of_inertial_velocity

namespace derivative_of_other_observer {
// mistake: the derivative seen from b used as the one seen from a
// expect: Derivative<Body, Body
// expect: Derivative<Gcrf, Body
Derivative<Gcrf, Body, si::length> velocity(const Derivative<Body, Body, si::length>& rdot,
                                            const Vector<Body, si::length>& r_body,
                                            const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, rdot, r_body, w_body);
#else
  static_cast<void>(r_body);
  static_cast<void>(w_body);
  return rdot;
#endif
}
}  // namespace derivative_of_other_observer

namespace particle_acceleration_at_two_points {
// mistake: the acceleration of a particle from a twist at one point and its rate at another
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Camera>
// expect: Change = (vectrix::)?TwistRate<Gcrf, Body, (vectrix::)?At<Body>
// expect: at one point, expressed in one frame
auto push(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab,
          const TwistRate<Gcrf, Body, At<Body>, In<Body>>& Vdot_ab,
          const Displacement<Body, Camera, In<Body>>& r_bc_b) {
#ifdef REPAIRED
  return particle_acceleration(shift(V_ab, r_bc_b), shift(Vdot_ab, r_bc_b));
#else
  return particle_acceleration(shift(V_ab, r_bc_b), Vdot_ab);
#endif
}
}  // namespace particle_acceleration_at_two_points

namespace point_velocity_of_other_point {
// mistake: the velocity of a camera from the twist at the body's origin
// expect: OfPoint = Camera
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: the twist at q
auto camera_velocity(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab,
                     const Displacement<Body, Camera, In<Body>>& r_bc_b) {
#ifdef REPAIRED
  return point_velocity(of<Camera>, shift(V_ab, r_bc_b));
#else
  static_cast<void>(r_bc_b);
  return point_velocity(of<Camera>, V_ab);
#endif
}
}  // namespace point_velocity_of_other_point

namespace transport_in_two_frames {
// mistake: a derivative and its vector expressed in different frames
// expect: Change = (vectrix::)?Derivative<Body, Body
// expect: Vector<Gcrf
auto velocity(const Derivative<Body, Body, si::length>& rdot, const Dcm<Body, Gcrf>& R_body_from_gcrf,
              const Vector<Gcrf, si::length>& r_gcrf, const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, rdot, R_body_from_gcrf * r_gcrf, w_body);
#else
  static_cast<void>(R_body_from_gcrf);
  return transport(observed_from<Gcrf>, rdot, r_gcrf, w_body);
#endif
}
}  // namespace transport_in_two_frames

namespace transport_of_other_quantity {
// mistake: the derivative of a position transported with a velocity in the place of the position
// expect: Derivative<Body, Body, (vectrix::)?si::length
// expect: Vector<Body, (vectrix::)?si::velocity
auto velocity(const Derivative<Body, Body, si::length>& rdot, const Vector<Body, si::length>& r_body,
              const Vector<Body, si::velocity>& v_body, const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(v_body);
  return transport(observed_from<Gcrf>, rdot, r_body, w_body);
#else
  static_cast<void>(r_body);
  return transport(observed_from<Gcrf>, rdot, v_body, w_body);
#endif
}
}  // namespace transport_of_other_quantity

namespace transport_of_wrong_pair {
// mistake: a derivative transported by the rate of the old observer relative to a third frame
// expect: Derivative<Body, Body
// expect: AngularVelocity<Gcrf, Camera
auto velocity(const Derivative<Body, Body, si::length>& rdot, const Vector<Body, si::length>& r_body,
              const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera,
              const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera);
  return transport(observed_from<Gcrf>, rdot, r_body, w_gcrf_body);
#else
  static_cast<void>(w_gcrf_body);
  return transport(observed_from<Gcrf>, rdot, r_body, w_gcrf_camera);
#endif
}
}  // namespace transport_of_wrong_pair

namespace velocity_expressed_in_two_frames {
// mistake: velocities expressed in different frames added
// expect: Velocity<Body, Camera,.*In<Gcrf>
// expect: Velocity<Camera, Tip,.*In<Body>
auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Gcrf>>& v_bc_i,
            const Velocity<Camera, Tip, ObservedFrom<Gcrf>, In<Body>>& v_ct_b,
            const Dcm<Gcrf, Body>& R_i_from_b) {
#ifdef REPAIRED
  return v_bc_i + R_i_from_b * v_ct_b;
#else
  return static_cast<void>(R_i_from_b), v_bc_i + v_ct_b;
#endif
}
}  // namespace velocity_expressed_in_two_frames

namespace velocity_from_acceleration {
// mistake: metres per second squared at a door for metres per second
// expect: si::acceleration
auto motion(const Vector<Body, si::acceleration>& a_b, const Quantity<si::time>& t) {
#ifdef REPAIRED
  return velocity(of<Tip>, relative_to<Body>, observed_from<Body>, a_b * t);
#else
  return static_cast<void>(t), velocity(of<Tip>, relative_to<Body>, observed_from<Body>, a_b);
#endif
}
}  // namespace velocity_from_acceleration

namespace velocity_from_displacement {
// mistake: a place taken for a velocity
// expect: si::length
auto motion(const Displacement<Gcrf, Tip, In<Body>>& r_b, Quantity<si::time> dt) {
#ifdef REPAIRED
  return velocity(of<Tip>, relative_to<Gcrf>, observed_from<Body>, r_b.vector() / dt);
#else
  return static_cast<void>(dt), velocity(of<Tip>, relative_to<Gcrf>, observed_from<Body>, r_b.vector());
#endif
}
}  // namespace velocity_from_displacement

namespace velocity_of_two_observers {
// mistake: velocities seen by different observers added
// expect: Velocity<Body, Camera, (vectrix::)?ObservedFrom<Gcrf>
// expect: Velocity<Camera, Tip, (vectrix::)?ObservedFrom<Body>
// expect: seen_by_two_observers
auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Body>>& v_bc_i_b,
            const Velocity<Camera, Tip, ObservedFrom<Body>, In<Body>>& v_ct_b_b,
            const Displacement<Camera, Tip, In<Body>>& r_ct_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return v_bc_i_b + transport(observed_from<Gcrf>, v_ct_b_b, r_ct_b, w_ib_b);
#else
  return static_cast<void>(r_ct_b), static_cast<void>(w_ib_b), v_bc_i_b + v_ct_b_b;
#endif
}
}  // namespace velocity_of_two_observers

namespace velocity_points_do_not_chain {
// mistake: velocities of points that do not chain added
// expect: Velocity<Body, Camera,
// expect: Velocity<Body, Tip,
auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Body>>& v_bc,
            const Velocity<Body, Tip, ObservedFrom<Gcrf>, In<Body>>& v_bt) {
#ifdef REPAIRED
  return -v_bc + v_bt;
#else
  return v_bc + v_bt;
#endif
}
}  // namespace velocity_points_do_not_chain

namespace velocity_taken_for_another_observer {
// mistake: the rotating observer's velocity taken for the inertial one's
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
// expect: Velocity<(Gcrf, Tip|\[2 \* ...\]), (vectrix::)?ObservedFrom<Gcrf>
Velocity<Gcrf, Tip, ObservedFrom<Gcrf>, In<Body>> motion(
    const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
    const Displacement<Gcrf, Tip, In<Body>>& r_b, const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, r_b, w_ib_b);
#else
  return static_cast<void>(r_b), static_cast<void>(w_ib_b), v_b;
#endif
}
}  // namespace velocity_taken_for_another_observer

namespace velocity_transport_with_reversed_position {
// mistake: the position between the same points, reversed
// expect: Displacement<Tip, Gcrf
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Tip, Gcrf, In<Body>>& r_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, -r_b, w_ib_b);
#else
  return transport(observed_from<Gcrf>, v_b, r_b, w_ib_b);
#endif
}
}  // namespace velocity_transport_with_reversed_position

namespace velocity_transport_with_reversed_rate {
// mistake: the rate of the old observer relative to the new one, reversed
// expect: AngularVelocity<Body, Gcrf
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularVelocity<Body, Gcrf, In<Body>>& w_bi_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, r_b, -w_bi_b);
#else
  return transport(observed_from<Gcrf>, v_b, r_b, w_bi_b);
#endif
}
}  // namespace velocity_transport_with_reversed_rate

namespace motion_seen_from_another_frame_as_an_edge {
// mistake: a motion relative to the origin of one frame, observed from another, taken for the motion of a frame
// expect: RelativeToPoint = Body
// expect: Observer = Gcrf
auto at(const PointMotion<Body, Camera, Gcrf>& motion, const AngularVelocity<Body, Gcrf, In<Gcrf>>& w_bi_i,
        const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  const auto v_b = R_b_from_i * transport(observed_from<Body>, motion.velocity, motion.position, w_bi_i);
  return parallel(PointMotion<Body, Camera, Body>{R_b_from_i * motion.position, v_b});
#else
  return static_cast<void>(w_bi_i), static_cast<void>(R_b_from_i), parallel(motion);
#endif
}
}  // namespace motion_seen_from_another_frame_as_an_edge
