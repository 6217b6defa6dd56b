// Angular acceleration
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace alpha_assigned_to_omega {
// mistake: an angular acceleration assigned to an angular velocity
// expect: AngularAcceleration<Gcrf, Body
// expect: AngularVelocity<Gcrf, Body
AngularVelocity<Gcrf, Body, In<Body>> rate(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body,
                                           Quantity<si::time> dt) {
#ifdef REPAIRED
  return angular_velocity(of<Body>, relative_to<Gcrf>, alpha_body.vector() * dt);
#else
  static_cast<void>(dt);
  return alpha_body;
#endif
}
}  // namespace alpha_assigned_to_omega

namespace alpha_chained_with_rates_exchanged {
// mistake: the two rates of a chain of accelerations exchanged: the transport term would change its sign
// expect: RateAb = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Body>
// expect: RateBd = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: one frame c
auto acceleration(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
                  const AngularAcceleration<Body, Camera, In<Body>>& alpha_body_camera,
                  const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
                  const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  return chain(alpha_gcrf_body, alpha_body_camera, w_gcrf_body, w_body_camera);
#else
  return chain(alpha_gcrf_body, alpha_body_camera, w_body_camera, w_gcrf_body);
#endif
}
}  // namespace alpha_chained_with_rates_exchanged

namespace alpha_chained_without_omega {
// mistake: accelerations added without the rates: the transport term would be lost
// expect: Left = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularAcceleration<Body, Camera, (vectrix::)?In<Body>
auto acceleration(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
                  const AngularAcceleration<Body, Camera, In<Body>>& alpha_body_camera,
                  const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
                  const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  return chain(alpha_gcrf_body, alpha_body_camera, w_gcrf_body, w_body_camera);
#else
  static_cast<void>(w_gcrf_body);
  static_cast<void>(w_body_camera);
  return alpha_gcrf_body + alpha_body_camera;
#endif
}
}  // namespace alpha_chained_without_omega

namespace alpha_difference {
// mistake: accelerations subtracted without the rates: the transport term would be lost
// expect: Left = (vectrix::)?AngularAcceleration<Gcrf, Camera, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
// expect: Reason = .*transport_term_is_lost
auto acceleration(const AngularAcceleration<Gcrf, Camera, In<Body>>& alpha_gcrf_camera,
                  const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
                  const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera,
                  const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  return chain(-alpha_gcrf_body, alpha_gcrf_camera, -w_gcrf_body, w_gcrf_camera);
#else
  static_cast<void>(w_gcrf_camera);
  static_cast<void>(w_gcrf_body);
  return alpha_gcrf_camera - alpha_gcrf_body;
#endif
}
}  // namespace alpha_difference

namespace alpha_drives_dcm {
// mistake: an angular acceleration given for an angular velocity
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body,
                      const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(alpha_body);
  return rate(R_gcrf_from_body, w_body);
#else
  static_cast<void>(w_body);
  return rate(R_gcrf_from_body, alpha_body);
#endif
}
}  // namespace alpha_drives_dcm

namespace alpha_of_omega_vector {
// mistake: a vector in rad/s given for an angular acceleration
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angular_velocity
// expect: a vector in rad/s
auto acceleration(const Vector<Body, si::angular_velocity>& w_body, Quantity<si::time> dt) {
#ifdef REPAIRED
  return angular_acceleration(of<Body>, relative_to<Gcrf>, w_body / dt);
#else
  static_cast<void>(dt);
  return angular_acceleration(of<Body>, relative_to<Gcrf>, w_body);
#endif
}
}  // namespace alpha_of_omega_vector

namespace alpha_of_one_frame {
// mistake: the angular acceleration of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
auto spin(const Vector<Body, si::angular_acceleration>& alpha_body) {
#ifdef REPAIRED
  return angular_acceleration(of<Body>, relative_to<Gcrf>, alpha_body);
#else
  return angular_acceleration(of<Body>, relative_to<Body>, alpha_body);
#endif
}
}  // namespace alpha_of_one_frame

namespace alpha_plus_omega {
// mistake: an angular acceleration and an angular velocity added
// expect: Left = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Body>
auto sum(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
         const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
         const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  static_cast<void>(alpha_gcrf_body);
  return w_gcrf_body + w_body_camera;
#else
  static_cast<void>(w_gcrf_body);
  return alpha_gcrf_body + w_body_camera;
#endif
}
}  // namespace alpha_plus_omega

namespace alpha_reexpressed_from_other_frame {
// mistake: an acceleration re-expressed by a rotation from a frame in which it is not expressed
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: the inner frames cancel
auto acceleration(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                  const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_gcrf) {
#ifdef REPAIRED
  return inverse(R_gcrf_from_body) * alpha_gcrf;
#else
  return R_gcrf_from_body * alpha_gcrf;
#endif
}
}  // namespace alpha_reexpressed_from_other_frame

namespace unaccelerated_of_one_frame {
// mistake: a frame not accelerated relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
auto mounted() {
#ifdef REPAIRED
  return unaccelerated(of<Body>, relative_to<Gcrf>, in<Body>);
#else
  return unaccelerated(of<Body>, relative_to<Body>, in<Body>);
#endif
}
}  // namespace unaccelerated_of_one_frame

namespace angular_acceleration_of_other_rate {
// mistake: the angular acceleration of a quaternion from the derivatives of its inverse
// expect: Attitude = (vectrix::)?Quaternion<Gcrf, Body
// expect: Rate = (vectrix::)?QuaternionRate<Body, Gcrf
// expect: angular_acceleration_from.x_ab, xdot_ab, xddot_ab, in<B>. or in<A>
auto acceleration(const Quaternion<Gcrf, Body>& q_i_from_b, const QuaternionRate<Body, Gcrf>& qdot_b_from_i,
                  const QuaternionSecondRate<Body, Gcrf>& qddot_b_from_i) {
#ifdef REPAIRED
  return angular_acceleration_from(inverse(q_i_from_b), qdot_b_from_i, qddot_b_from_i, in<Body>);
#else
  return angular_acceleration_from(q_i_from_b, qdot_b_from_i, qddot_b_from_i, in<Body>);
#endif
}
}  // namespace angular_acceleration_of_other_rate
