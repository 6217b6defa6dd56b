// Rotations that move
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace accelerating_dcm_of_alpha_in_reference {
// mistake: an acceleration expressed in a where accelerating_dcm() takes it in b
// expect: 'Body' (vs.|and) 'Gcrf'
auto motion(const Dcm<Gcrf, Body>& R_gcrf_from_body, const AngularVelocity<Gcrf, Body, In<Body>>& w_body,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_gcrf) {
#ifdef REPAIRED
  return accelerating_dcm(R_gcrf_from_body, w_body, inverse(R_gcrf_from_body) * alpha_gcrf);
#else
  return accelerating_dcm(R_gcrf_from_body, w_body, alpha_gcrf);
#endif
}
}  // namespace accelerating_dcm_of_alpha_in_reference

namespace accelerating_dcm_product_inner_frames {
// mistake: two accelerating rotations whose inner frames do not cancel
// expect: Left = (vectrix::)?AcceleratingDcm<Gcrf, Body
// expect: Right = (vectrix::)?AcceleratingDcm<Camera, Body
// expect: the inner frames cancel
auto motion(const AcceleratingDcm<Gcrf, Body>& gcrf_from_body,
            const AcceleratingDcm<Camera, Body>& camera_from_body) {
#ifdef REPAIRED
  return gcrf_from_body * inverse(camera_from_body);
#else
  return gcrf_from_body * camera_from_body;
#endif
}
}  // namespace accelerating_dcm_product_inner_frames

namespace dcm_rate_as_dcm {
// mistake: the derivative of a rotation used as a rotation
// expect: DcmRate<Gcrf, Body
// expect: Dcm<Gcrf, Body
Dcm<Gcrf, Body> attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                         const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(rate(R_gcrf_from_body, w_body));
  return R_gcrf_from_body;
#else
  return rate(R_gcrf_from_body, w_body);
#endif
}
}  // namespace dcm_rate_as_dcm

namespace dcm_rate_composed {
// mistake: the derivative of a rotation composed as a rotation
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?DcmRate<Body, Camera
// expect: the kinds go together
auto attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body, const DcmRate<Body, Camera>& Rdot_body_from_camera,
              const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  static_cast<void>(Rdot_body_from_camera);
  return R_gcrf_from_body * R_body_from_camera;
#else
  static_cast<void>(R_body_from_camera);
  return R_gcrf_from_body * Rdot_body_from_camera;
#endif
}
}  // namespace dcm_rate_composed

namespace dcm_rate_composed_on_the_left {
// mistake: a rotation composed after the derivative of another
// expect: Left = (vectrix::)?DcmRate<Gcrf, Body
// expect: Right = (vectrix::)?Dcm<Body, Camera
auto attitude(const DcmRate<Gcrf, Body>& Rdot_gcrf_from_body, const Dcm<Gcrf, Body>& R_gcrf_from_body,
              const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  static_cast<void>(Rdot_gcrf_from_body);
  return R_gcrf_from_body * R_body_from_camera;
#else
  static_cast<void>(R_gcrf_from_body);
  return Rdot_gcrf_from_body * R_body_from_camera;
#endif
}
}  // namespace dcm_rate_composed_on_the_left

namespace dcm_rate_times_vector_of_other_frame {
// mistake: the derivative of a rotation applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?DcmRate<Gcrf, Body
// expect: Right = (vectrix::)?Vector<Gcrf
auto velocity(const DcmRate<Gcrf, Body>& Rdot_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf,
              const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  static_cast<void>(r_gcrf);
  return Rdot_gcrf_from_body * r_body;
#else
  static_cast<void>(r_body);
  return Rdot_gcrf_from_body * r_gcrf;
#endif
}
}  // namespace dcm_rate_times_vector_of_other_frame

namespace moving_dcm_of_other_omega {
// mistake: a rotation joined with the rate of another pair of frames
// expect: DcmFrom = Body
// expect: RateOf = Camera
auto motion(const Dcm<Gcrf, Body>& R_gcrf_from_body,
            const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera_body,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera_body);
  return moving_dcm(R_gcrf_from_body, w_gcrf_body_body);
#else
  static_cast<void>(w_gcrf_body_body);
  return moving_dcm(R_gcrf_from_body, w_gcrf_camera_body);
#endif
}
}  // namespace moving_dcm_of_other_omega

namespace moving_dcm_product_inner_frames {
// mistake: two moving rotations whose inner frames do not cancel
// expect: Left = (vectrix::)?MovingDcm<Gcrf, Body
// expect: Right = (vectrix::)?MovingDcm<Camera, Body
// expect: the inner frames cancel
auto motion(const MovingDcm<Gcrf, Body>& gcrf_from_body, const MovingDcm<Camera, Body>& camera_from_body) {
#ifdef REPAIRED
  return gcrf_from_body * inverse(camera_from_body);
#else
  return gcrf_from_body * camera_from_body;
#endif
}
}  // namespace moving_dcm_product_inner_frames

namespace moving_dcm_times_dcm {
// mistake: a moving rotation and one whose motion is not known multiplied
// expect: Left = (vectrix::)?MovingDcm<Gcrf, Body
// expect: Right = (vectrix::)?Dcm<Body, Camera
// expect: the kinds go together
auto motion(const MovingDcm<Gcrf, Body>& gcrf_from_body, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return gcrf_from_body * moving_dcm(R_body_from_camera, at_rest(of<Camera>, relative_to<Body>, in<Camera>));
#else
  return gcrf_from_body * R_body_from_camera;
#endif
}
}  // namespace moving_dcm_times_dcm

namespace second_rate_in_two_frames {
// mistake: a rate expressed in b and an acceleration expressed in a
// expect: X = (vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 2, 1>, Gcrf, Body
// expect: Acceleration = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: both expressed in b, or both in a
auto second(const EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>& x,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_b,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_i, const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return second_rate(x, w_b, R_b_from_i * alpha_i);
#else
  return static_cast<void>(R_b_from_i), second_rate(x, w_b, alpha_i);
#endif
}
}  // namespace second_rate_in_two_frames
