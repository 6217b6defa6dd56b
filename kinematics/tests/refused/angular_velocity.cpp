// Angular velocity
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace at_rest_of_one_frame {
// mistake: a frame at rest relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
auto mounted() {
#ifdef REPAIRED
  return at_rest(of<Body>, relative_to<Gcrf>, in<Body>);
#else
  return at_rest(of<Body>, relative_to<Body>, in<Body>);
#endif
}
}  // namespace at_rest_of_one_frame

namespace omega_as_vector {
// mistake: a rate, which knows its two frames, assigned to a vector, which does not
// expect: AngularVelocity<Gcrf, Body
// expect: Vector<Body, (vectrix::)?si::angular_velocity
Vector<Body, si::angular_velocity> rate(const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return w_body.vector();
#else
  return w_body;
#endif
}
}  // namespace omega_as_vector

namespace omega_assigned_in_other_frame {
// mistake: w_ab^a assigned to a variable of type w_ab^b
// expect: In<Gcrf>
// expect: In<Body>
AngularVelocity<Gcrf, Body, In<Body>> rate(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                                           const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf) {
#ifdef REPAIRED
  return R_body_from_gcrf * w_gcrf;
#else
  static_cast<void>(R_body_from_gcrf);
  return w_gcrf;
#endif
}
}  // namespace omega_assigned_in_other_frame

namespace omega_assigned_reversed {
// mistake: w_ba assigned to a variable of type w_ab
// expect: AngularVelocity<Body, Gcrf
// expect: AngularVelocity<Gcrf, Body
AngularVelocity<Gcrf, Body, In<Body>> rate(const AngularVelocity<Body, Gcrf, In<Body>>& w_body_gcrf) {
#ifdef REPAIRED
  return -w_body_gcrf;
#else
  return w_body_gcrf;
#endif
}
}  // namespace omega_assigned_reversed

namespace omega_chain_in_two_frames {
// mistake: two rates expressed in different frames added
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Camera>
// expect: one frame and one unit
auto rate(const Dcm<Camera, Body>& R_camera_from_body,
          const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body_body,
          const AngularVelocity<Body, Camera, In<Camera>>& w_body_camera_camera) {
#ifdef REPAIRED
  return R_camera_from_body * w_gcrf_body_body + w_body_camera_camera;
#else
  static_cast<void>(R_camera_from_body);
  return w_gcrf_body_body + w_body_camera_camera;
#endif
}
}  // namespace omega_chain_in_two_frames

namespace omega_chain_inner_frames {
// mistake: two rates that do not chain
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Body>
auto rate(const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
          const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera) {
#ifdef REPAIRED
  return -w_gcrf_body + w_gcrf_camera;
#else
  return w_gcrf_body + w_gcrf_camera;
#endif
}
}  // namespace omega_chain_inner_frames

namespace omega_chained_in_place {
// mistake: a chain of rates is the rate of another pair than its first
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body
// expect: Right = (vectrix::)?AngularVelocity<Body, Wheel
// expect: a chain is another
struct Wheel : moving_frame {};

auto spin(AngularVelocity<Gcrf, Body, In<Body>> w_body,
          const AngularVelocity<Body, Wheel, In<Body>>& w_wheel) {
#ifdef REPAIRED
  return w_body + w_wheel;
#else
  return w_body += w_wheel;
#endif
}
}  // namespace omega_chained_in_place

namespace omega_cross_position_across_frames {
// mistake: a rate expressed in the inertial frame crossed with a position expressed in the rotating one
// expect: AngularVelocity<
// expect: In<Gcrf>.*Vector<Body
auto velocity_of_turning(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                         const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf,
                         const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return cross(R_body_from_gcrf * w_gcrf, r_body);
#else
  static_cast<void>(R_body_from_gcrf);
  return cross(w_gcrf, r_body);
#endif
}
}  // namespace omega_cross_position_across_frames

namespace omega_default {
// mistake: a rate without a value
// expect: AngularVelocity<Gcrf, Body
auto rate() {
#ifdef REPAIRED
  const AngularVelocity<Gcrf, Body, In<Body>> w_gcrf_body = at_rest(of<Body>, relative_to<Gcrf>, in<Body>);
  return w_gcrf_body;
#else
  const AngularVelocity<Gcrf, Body, In<Body>> w_gcrf_body;
  return w_gcrf_body;
#endif
}
}  // namespace omega_default

namespace omega_difference_of_estimates {
// mistake: the error of an estimate, which is no rate of one frame relative to another, as a difference
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Reason = .*one_pair_twice
auto error(const AngularVelocity<Gcrf, Body, In<Body>>& w_gyro,
           const AngularVelocity<Gcrf, Body, In<Body>>& w_truth) {
#ifdef REPAIRED
  return error_between(w_gyro, w_truth);
#else
  return w_gyro - w_truth;
#endif
}
}  // namespace omega_difference_of_estimates

namespace omega_difference_in_two_frames {
// mistake: the difference of two rates that are expressed in two frames
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Camera>
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Reason = .*expressed_in_two_frames
auto rate(const Dcm<Body, Camera>& R_body_from_camera,
          const AngularVelocity<Gcrf, Camera, In<Camera>>& w_gcrf_camera_camera,
          const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body_body) {
#ifdef REPAIRED
  return R_body_from_camera * w_gcrf_camera_camera - w_gcrf_body_body;
#else
  static_cast<void>(R_body_from_camera);
  return w_gcrf_camera_camera - w_gcrf_body_body;
#endif
}
}  // namespace omega_difference_in_two_frames

namespace omega_difference_without_common_frame {
// mistake: the difference of two rates that have no frame in common: the one needed is reversed
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Body>
// expect: Reason = .*no_frame_cancels
auto rate(const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
          const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  return w_gcrf_body - -w_body_camera;
#else
  return w_gcrf_body - w_body_camera;
#endif
}
}  // namespace omega_difference_without_common_frame

namespace omega_times_bare_gain {
// mistake: a torque from a rate and a gain without a unit
// expect: Left = double
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body
// expect: k . w.vector
Vector<Body, si::torque> damper(const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  const auto k = 0.5 * (si::newton_metre / (si::radian / si::second));
#else
  const double k = 0.5;
#endif
  return -k * w_body;
}
}  // namespace omega_times_bare_gain

namespace omega_dot_across_frames {
// mistake: the power of a torque and a rate that are expressed in two frames
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Body
// expect: Vector<Gcrf, (vectrix::)?si::torque
// expect: in one frame
auto power(const AngularVelocity<Gcrf, Body, In<Body>>& w_body, const Vector<Gcrf, si::torque>& torque_gcrf,
           const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return dot(w_body, R_body_from_gcrf * torque_gcrf);
#else
  return dot(w_body, torque_gcrf);
#endif
}
}  // namespace omega_dot_across_frames

namespace omega_for_euler_rates {
// mistake: an angular velocity given for the rates of Euler angles
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body
// expect: xdot the rate of that x
auto rate_of(const EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>& x,
             const AngularVelocity<Gcrf, Body, In<Body>>& w_b) {
#ifdef REPAIRED
  return angular_velocity_from(x, rate(x, w_b), in<Gcrf>);
#else
  return angular_velocity_from(x, w_b, in<Gcrf>);
#endif
}
}  // namespace omega_for_euler_rates

namespace omega_in_third_frame_drives_dcm {
// mistake: a DCM driven by a rate expressed in a third frame
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Camera>
auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Dcm<Body, Camera>& R_body_from_camera,
                      const AngularVelocity<Gcrf, Body, In<Camera>>& w_camera) {
#ifdef REPAIRED
  return rate(R_gcrf_from_body, R_body_from_camera * w_camera);
#else
  static_cast<void>(R_body_from_camera);
  return rate(R_gcrf_from_body, w_camera);
#endif
}
}  // namespace omega_in_third_frame_drives_dcm

namespace omega_of_degrees_per_second {
// mistake: degrees per second given for rad/s
// expect: InFrame = (vectrix::)?In<Body>
// expect: one SI vector unit for all: .* or convert<U>
auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(0.1 * si::degree_per_second);
  return vector(in<Body>, spin, spin, spin);
#else
  const auto spin = 0.1 * si::degree_per_second;
  return vector(in<Body>, spin, spin, spin);
#endif
}
}  // namespace omega_of_degrees_per_second

namespace omega_of_one_frame {
// mistake: the rate of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
auto spin(const Vector<Body, si::angular_velocity>& w_body) {
#ifdef REPAIRED
  return angular_velocity(of<Body>, relative_to<Gcrf>, w_body);
#else
  return angular_velocity(of<Body>, relative_to<Body>, w_body);
#endif
}
}  // namespace omega_of_one_frame

namespace omega_of_other_pair_drives_dcm {
// mistake: a DCM driven by the rate of another pair of frames
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Camera>
auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularVelocity<Gcrf, Camera, In<Camera>>& w_gcrf_camera,
                      const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera);
  return rate(R_gcrf_from_body, w_gcrf_body);
#else
  static_cast<void>(w_gcrf_body);
  return rate(R_gcrf_from_body, w_gcrf_camera);
#endif
}
}  // namespace omega_of_other_pair_drives_dcm

namespace omega_of_other_pair_drives_quaternion {
// mistake: a quaternion driven by the rate of another pair of frames
// expect: Rotation = (vectrix::)?Quaternion<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Body>
auto rate_of_attitude(const Quaternion<Gcrf, Body>& q_gcrf_from_body,
                      const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera,
                      const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera);
  return rate(q_gcrf_from_body, w_gcrf_body);
#else
  static_cast<void>(w_gcrf_body);
  return rate(q_gcrf_from_body, w_gcrf_camera);
#endif
}
}  // namespace omega_of_other_pair_drives_quaternion

namespace omega_of_revolutions_per_minute {
// mistake: revolutions per minute given for rad/s
// expect: InFrame = (vectrix::)?In<Wheel<2> ?>
// expect: one SI vector unit for all: .* or convert<U>
template <int I> struct Wheel : moving_frame {};

auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(6000.0 * si::revolution_per_minute);
  return vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin);
#else
  const auto spin = 6000.0 * si::revolution_per_minute;
  return vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin);
#endif
}
}  // namespace omega_of_revolutions_per_minute

namespace omega_of_torque {
// mistake: a torque given for a rate
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::torque
// expect: a vector in rad/s
auto rate(const Vector<Body, si::torque>& tau_body, const Vector<Body, si::angular_velocity>& w_body) {
#ifdef REPAIRED
  static_cast<void>(tau_body);
  return angular_velocity(of<Body>, relative_to<Gcrf>, w_body);
#else
  static_cast<void>(w_body);
  return angular_velocity(of<Body>, relative_to<Gcrf>, tau_body);
#endif
}
}  // namespace omega_of_torque

namespace omega_reexpressed_from_other_frame {
// mistake: a rate re-expressed by a rotation from a frame in which it is not expressed
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: the inner frames cancel
auto rate(const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf_body_gcrf) {
#ifdef REPAIRED
  return inverse(R_gcrf_from_body) * w_gcrf_body_gcrf;
#else
  return R_gcrf_from_body * w_gcrf_body_gcrf;
#endif
}
}  // namespace omega_reexpressed_from_other_frame

namespace omega_reversed_drives_dcm {
// mistake: a DCM driven by the rate of a relative to b
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Body, Gcrf, (vectrix::)?In<Body>
auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularVelocity<Body, Gcrf, In<Body>>& w_body_gcrf) {
#ifdef REPAIRED
  return rate(R_gcrf_from_body, -w_body_gcrf);
#else
  return rate(R_gcrf_from_body, w_body_gcrf);
#endif
}
}  // namespace omega_reversed_drives_dcm
