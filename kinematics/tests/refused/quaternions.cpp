// Quaternions and rotation vectors
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace exp_of_angle_increment {
// mistake: the exponential of the integral of a rate, which is no rotation vector
// expect: exp
// expect: Given = (vectrix::)?AngleIncrement<Gcrf, Body
// expect: of a rotation vector or a screw
auto turn(const AngleIncrement<Gcrf, Body>& first, const AngleIncrement<Gcrf, Body>& second) {
#ifdef REPAIRED
  return vectrix::exp(coning_corrected(first, second));
#else
  return vectrix::exp(first + second);
#endif
}
}  // namespace exp_of_angle_increment

namespace exp_of_twist {
// mistake: the exponential of a twist, without the time for which it is held
// expect: Given = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Body>
// expect: of a rotation vector or a screw
auto place(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab_b, Quantity<si::time> t) {
#ifdef REPAIRED
  return vectrix::exp(held(V_ab_b, t));
#else
  static_cast<void>(t);
  return vectrix::exp(V_ab_b);
#endif
}
}  // namespace exp_of_twist

namespace exp_of_vector {
// mistake: the exponential of a vector, which does not know its two frames
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angle
// expect: of a rotation vector or a screw
auto attitude(const Vector<Body, si::angle>& theta_body) {
#ifdef REPAIRED
  return vectrix::exp(rotation_vector(of<Body>, relative_to<Gcrf>, theta_body));
#else
  return vectrix::exp(theta_body);
#endif
}
}  // namespace exp_of_vector

namespace nearest_quaternion_scalar_first_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(double a, double b, double c, double d) {
#ifdef REPAIRED
  return nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, a, b, c, d);
#else
  return nearest_quaternion_scalar_first(to<Body>, from<Body>, a, b, c, d);
#endif
}
}  // namespace nearest_quaternion_scalar_first_of_one_frame

namespace nearest_quaternion_scalar_last_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(double a, double b, double c, double d) {
#ifdef REPAIRED
  return nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, a, b, c, d);
#else
  return nearest_quaternion_scalar_last(to<Body>, from<Body>, a, b, c, d);
#endif
}
}  // namespace nearest_quaternion_scalar_last_of_one_frame

namespace quaternion_as_dcm {
// mistake: a quaternion where a DCM is needed
// expect: Quaternion<Body, Gcrf
// expect: Dcm<Body, Gcrf
Dcm<Body, Gcrf> attitude(const Quaternion<Body, Gcrf>& q_body_from_gcrf) {
#ifdef REPAIRED
  return dcm(q_body_from_gcrf);
#else
  return q_body_from_gcrf;
#endif
}
}  // namespace quaternion_as_dcm

namespace quaternion_assigned_transposed {
// mistake: q_a_from_b assigned to a variable of type q_b_from_a
// expect: Quaternion<Gcrf, Body
// expect: Quaternion<Body, Gcrf
Quaternion<Body, Gcrf> attitude(const Quaternion<Gcrf, Body>& q_gcrf_from_body) {
#ifdef REPAIRED
  return inverse(q_gcrf_from_body);
#else
  return q_gcrf_from_body;
#endif
}
}  // namespace quaternion_assigned_transposed

namespace quaternion_from_bare_eigen {
// mistake: a bare quaternion that nobody has claimed to be a rotation
// expect: Quaternion<Body, Gcrf
Quaternion<Body, Gcrf> attitude(const Eigen::Quaterniond& q) {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, q.w(), q.x(), q.y(), q.z());
#else
  return q;
#endif
}
}  // namespace quaternion_from_bare_eigen

namespace quaternion_from_four_numbers {
// mistake: four numbers that do not say where the scalar is
// expect: Quaternion<Body, Gcrf
// expect: where is the scalar
auto attitude() {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, 1.0, 0.0, 0.0, 0.0);
#else
  return Quaternion<Body, Gcrf>(1.0, 0.0, 0.0, 0.0);
#endif
}
}  // namespace quaternion_from_four_numbers

namespace quaternion_negated {
// mistake: the negative of a quaternion, which is the same rotation
// expect: Quaternion<Body, Gcrf
// expect: the same rotation
auto reverse(const Quaternion<Body, Gcrf>& q_body_from_gcrf) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf);
#else
  return -q_body_from_gcrf;
#endif
}
}  // namespace quaternion_negated

namespace quaternion_product_inner_frames {
// mistake: two quaternions whose inner frames do not cancel
// expect: Left = (vectrix::)?Quaternion<Camera, Body
// expect: Right = (vectrix::)?Quaternion<Gcrf, Body
// expect: the inner frames cancel
auto attitude(const Quaternion<Camera, Body>& q_camera_from_body,
              const Quaternion<Gcrf, Body>& q_gcrf_from_body) {
#ifdef REPAIRED
  return q_camera_from_body * inverse(q_gcrf_from_body);
#else
  return q_camera_from_body * q_gcrf_from_body;
#endif
}
}  // namespace quaternion_product_inner_frames

namespace quaternion_scalar_first_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(double a, double b, double c, double d) {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, a, b, c, d);
#else
  return quaternion_scalar_first(to<Body>, from<Body>, a, b, c, d);
#endif
}
}  // namespace quaternion_scalar_first_of_one_frame

namespace quaternion_scalar_last_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(double a, double b, double c, double d) {
#ifdef REPAIRED
  return quaternion_scalar_last(to<Body>, from<Gcrf>, a, b, c, d);
#else
  return quaternion_scalar_last(to<Body>, from<Body>, a, b, c, d);
#endif
}
}  // namespace quaternion_scalar_last_of_one_frame

namespace quaternion_second_rate_in_two_frames {
// mistake: the second derivative of a quaternion from a rate in b and an acceleration in a
// expect: X = (vectrix::)?Quaternion<Gcrf, Body
// expect: Acceleration = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: both expressed in b, or both in a
auto second(const Quaternion<Gcrf, Body>& q_i_from_b, const AngularVelocity<Gcrf, Body, In<Body>>& w_b,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_i) {
#ifdef REPAIRED
  return second_rate(q_i_from_b, w_b, inverse(q_i_from_b) * alpha_i);
#else
  return second_rate(q_i_from_b, w_b, alpha_i);
#endif
}
}  // namespace quaternion_second_rate_in_two_frames

namespace quaternion_times_dcm {
// mistake: a quaternion and a DCM multiplied
// expect: Left = (vectrix::)?Quaternion<Camera, Body
// expect: Right = (vectrix::)?Dcm<Body, Gcrf
// expect: the kinds go together
auto attitude(const Quaternion<Camera, Body>& q_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return dcm(q_camera_from_body) * R_body_from_gcrf;
#else
  return q_camera_from_body * R_body_from_gcrf;
#endif
}
}  // namespace quaternion_times_dcm

namespace quaternion_times_omega_of_other_frame {
// mistake: a quaternion re-expresses a rate that is expressed in another frame
// expect: Left = (vectrix::)?Quaternion<Body, Gcrf
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body
auto reexpressed(const Quaternion<Body, Gcrf>& q_body_from_gcrf,
                 const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf) * w_body;
#else
  return q_body_from_gcrf * w_body;
#endif
}
}  // namespace quaternion_times_omega_of_other_frame

namespace quaternion_times_vector_of_other_frame {
// mistake: a quaternion applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?Quaternion<Body, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
auto position(const Quaternion<Body, Gcrf>& q_body_from_gcrf, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf) * r_body;
#else
  return q_body_from_gcrf * r_body;
#endif
}
}  // namespace quaternion_times_vector_of_other_frame

namespace rotation_vector_driven_in_third_frame {
// mistake: a rotation vector driven by an angular velocity expressed in a third frame
// expect: RotationVector<Gcrf, Body
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Camera>
auto bortz(const RotationVector<Gcrf, Body>& theta_ab, const AngularVelocity<Gcrf, Body, In<Camera>>& w_ab_c,
           const Dcm<Body, Camera>& R_b_from_c) {
#ifdef REPAIRED
  return rate(theta_ab, R_b_from_c * w_ab_c);
#else
  static_cast<void>(R_b_from_c);
  return rate(theta_ab, w_ab_c);
#endif
}
}  // namespace rotation_vector_driven_in_third_frame

namespace rotation_vector_in_third_frame {
// mistake: a rotation vector expressed in neither of its two frames
// expect: VectorIn = Camera
// expect: OfFrame = Body
// expect: between two frames, expressed in one of them
auto turn(const Vector<Camera, si::angle>& theta_camera, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, R_body_from_camera * theta_camera);
#else
  static_cast<void>(R_body_from_camera);
  return rotation_vector(of<Body>, relative_to<Gcrf>, theta_camera);
#endif
}
}  // namespace rotation_vector_in_third_frame

namespace rotation_vector_of_one_frame {
// mistake: a turn of a frame to itself
// expect: OfFrame = Body
// expect: RelativeFrame = Body
// expect: two frames
auto turn(const Vector<Body, si::angle>& theta) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, theta);
#else
  return rotation_vector(of<Body>, relative_to<Body>, theta);
#endif
}
}  // namespace rotation_vector_of_one_frame

namespace rotation_vector_of_rate {
// mistake: a rate given for a rotation vector
// expect: UnitGiven = (vectrix::)?si::angular_velocity
// expect: an angle
auto turn(const Vector<Body, si::angular_velocity>& w_body, Quantity<si::time> dt) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, w_body * dt);
#else
  static_cast<void>(dt);
  return rotation_vector(of<Body>, relative_to<Gcrf>, w_body);
#endif
}
}  // namespace rotation_vector_of_rate

namespace rotation_vector_rate_as_omega {
// mistake: the rate of a rotation vector taken for an angular velocity
// expect: Dcm<Gcrf, Body
// expect: ParameterRate<(vectrix::)?RotationVector<Gcrf, Body
DcmRate<Gcrf, Body> motion(const RotationVector<Gcrf, Body>& theta_ab,
                           const ParameterRate<RotationVector<Gcrf, Body>>& thetadot_ab) {
#ifdef REPAIRED
  return rate(exp(theta_ab), angular_velocity_from(theta_ab, thetadot_ab, in<Body>));
#else
  return rate(exp(theta_ab), thetadot_ab);
#endif
}
}  // namespace rotation_vector_rate_as_omega

namespace rotation_vectors_added {
// mistake: two rotation vectors added, as if turns commuted
// expect: Left = (vectrix::)?RotationVector<Gcrf, Body
// expect: Right = (vectrix::)?RotationVector<Body, Camera
Dcm<Gcrf, Camera> attitude(const RotationVector<Gcrf, Body>& theta_ab,
                           const RotationVector<Body, Camera>& theta_bc) {
#ifdef REPAIRED
  return exp(theta_ab) * exp(theta_bc);
#else
  return exp(theta_ab + theta_bc);
#endif
}
}  // namespace rotation_vectors_added

namespace slerp_between_two_pairs {
// mistake: a slerp between attitudes of different bodies
// expect: FirstFrom = Body; LastTo = Gcrf; LastFrom = Camera|Slerp<Gcrf, Body, Gcrf, Camera>
auto slew(const Quaternion<Gcrf, Body>& q0, const Quaternion<Gcrf, Camera>& q1,
          const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return Slerp(0.0 * si::second, q0, 10.0 * si::second, q1 * quaternion(R_camera_from_body));
#else
  static_cast<void>(R_camera_from_body);
  return Slerp(0.0 * si::second, q0, 10.0 * si::second, q1);
#endif
}
}  // namespace slerp_between_two_pairs
