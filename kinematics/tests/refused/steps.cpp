// Steps on the group and gyro counts
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace angle_increment_in_reference {
// mistake: the integral of a rate expressed in the reference frame as a count in the body
// expect: angle_increment
// expect: Vector<Gcrf
auto count([[maybe_unused]] const Vector<Gcrf, si::angle>& alpha_gcrf,
           [[maybe_unused]] const Vector<Body, si::angle>& alpha_body) {
#ifdef REPAIRED
  return angle_increment(of<Body>, relative_to<Gcrf>, alpha_body);
#else
  return angle_increment(of<Body>, relative_to<Gcrf>, alpha_gcrf);
#endif
}
}  // namespace angle_increment_in_reference

namespace commutator_free_step_of_other_body {
// mistake: a step on the group with the rate of another body
// expect: commutator_free_step
// expect: OfCamera
// expect: A = Gcrf
// expect: B = Body
struct OfCamera {
  AngularVelocity<Gcrf, Camera, In<Camera>> operator()(const Quantity<si::time>& t,
                                                       const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};
struct OfBody {
  AngularVelocity<Gcrf, Body, In<Body>> operator()(const Quantity<si::time>& t,
                                                   const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};

auto step([[maybe_unused]] const OfBody& of_body, [[maybe_unused]] const OfCamera& of_camera,
          const Dcm<Gcrf, Body>& R_gcrf_from_body, const Quantity<si::time>& t,
          const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return commutator_free_step(of_body, R_gcrf_from_body, t, dt);
#else
  return commutator_free_step(of_camera, R_gcrf_from_body, t, dt);
#endif
}
}  // namespace commutator_free_step_of_other_body

namespace coning_of_two_bodies {
// mistake: the counts of two gyros on two bodies corrected for coning together
// expect: AngleIncrement<Gcrf, Body
// expect: AngleIncrement<Gcrf, Camera
// expect: of one b relative to one a
auto turn(const AngleIncrement<Gcrf, Body>& first, [[maybe_unused]] const AngleIncrement<Gcrf, Body>& second,
          [[maybe_unused]] const AngleIncrement<Gcrf, Camera>& of_camera) {
#ifdef REPAIRED
  return coning_corrected(first, second);
#else
  return coning_corrected(first, of_camera);
#endif
}
}  // namespace coning_of_two_bodies

namespace coning_of_intervals_of_two_bodies {
// mistake: a count corrected for coning with the previous count of a gyro on another body
// expect: AngleIncrement<Gcrf, Body
// expect: AngleIncrement<Gcrf, Camera
// expect: of one b relative to one a
auto turn(const AngleIncrement<Gcrf, Body>& first, [[maybe_unused]] const AngleIncrement<Gcrf, Body>& second,
          [[maybe_unused]] const AngleIncrement<Gcrf, Camera>& of_camera, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return coning_corrected_after(first, dt, second, dt);
#else
  return coning_corrected_after(first, dt, of_camera, dt);
#endif
}
}  // namespace coning_of_intervals_of_two_bodies

namespace exponential_step_of_rate_in_reference {
// mistake: a step in the body's axes with the rate expressed in the reference frame
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf
// expect: the rate in b's own axes
auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf,
          const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return exponential_step(R_gcrf_from_body, inverse(R_gcrf_from_body) * w_gcrf, dt);
#else
  return exponential_step(R_gcrf_from_body, w_gcrf, dt);
#endif
}
}  // namespace exponential_step_of_rate_in_reference

namespace first_order_step_as_dcm {
// mistake: what a first-order step gave taken for a rotation
// expect: FirstOrderAttitude<Gcrf, Body
// expect: Dcm<Gcrf, Body
Dcm<Gcrf, Body> step(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                     const AngularVelocity<Gcrf, Body, In<Body>>& w_body, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return nearest_dcm(first_order_step(R_gcrf_from_body, w_body, dt)).dcm;
#else
  return first_order_step(R_gcrf_from_body, w_body, dt);
#endif
}
}  // namespace first_order_step_as_dcm

namespace gyro_corrected_by_other_gyro {
// mistake: what the gyro of one body measured freed of the errors of another's
// expect: corrected
// expect: Given = (vectrix::)?Measured<
// expect: Gcrf, Body
auto rate(const Measured<AngularVelocity<Gcrf, Body, In<Body>>>& reading_body,
          [[maybe_unused]] const GyroErrors<Body>& of_body,
          [[maybe_unused]] const GyroErrors<Camera>& of_camera) {
#ifdef REPAIRED
  return of_body.corrected(reading_body);
#else
  return of_camera.corrected(reading_body);
#endif
}
}  // namespace gyro_corrected_by_other_gyro

namespace gyro_reading_as_rate {
// mistake: a step with what a gyro measured, its errors included
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?Measured<
auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const Measured<AngularVelocity<Gcrf, Body, In<Body>>>& reading,
          [[maybe_unused]] const GyroErrors<Body>& errors, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return exponential_step(R_gcrf_from_body, errors.corrected(reading), dt);
#else
  return exponential_step(R_gcrf_from_body, reading, dt);
#endif
}
}  // namespace gyro_reading_as_rate

namespace increment_composed_on_the_left {
// mistake: the increment of a step composed on the left, as if it were expressed in the reference frame
// expect: Left = (vectrix::)?Dcm<(vectrix::)?Before<Gcrf, Body>, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, (vectrix::)?Before<Gcrf, Body
Dcm<Gcrf, Body> step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Increment<Gcrf, Body>& theta) {
#ifdef REPAIRED
  return before(R_gcrf_from_body) * vectrix::exp(theta);
#else
  return vectrix::exp(theta) * before(R_gcrf_from_body);
#endif
}
}  // namespace increment_composed_on_the_left

namespace increment_of_other_pair {
// mistake: an attitude advanced by the increment of another body
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Before<Gcrf, Camera>, Camera
// expect: of the same b relative to the same a
auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Increment<Gcrf, Camera>& theta_camera,
          const Dcm<Gcrf, Camera>& R_gcrf_from_camera) {
#ifdef REPAIRED
  static_cast<void>(R_gcrf_from_body);
  return advance(R_gcrf_from_camera, theta_camera);
#else
  static_cast<void>(R_gcrf_from_camera);
  return advance(R_gcrf_from_body, theta_camera);
#endif
}
}  // namespace increment_of_other_pair

namespace magnus_of_rate_in_reference {
// mistake: the Magnus increment of a rate expressed in the reference frame
// expect: magnus_increment
// expect: in b's own axes
// expect: InReference|in_reference
struct InReference {
  AngularVelocity<Gcrf, Body, In<Gcrf>> operator()(const Quantity<si::time>& t) const;
};
struct InBody {
  AngularVelocity<Gcrf, Body, In<Body>> operator()(const Quantity<si::time>& t) const;
};

auto turn([[maybe_unused]] const InBody& in_body, [[maybe_unused]] const InReference& in_reference,
          const Quantity<si::time>& t, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return magnus_increment<4>(in_body, t, dt);
#else
  return magnus_increment<4>(in_reference, t, dt);
#endif
}
}  // namespace magnus_of_rate_in_reference

namespace munthe_kaas_step_of_rate_in_reference {
// mistake: a step on the group with a rate expressed in the reference frame
// expect: munthe_kaas_step
// expect: InReference|in_reference
// expect: A = Gcrf
// expect: B = Body
struct InReference {
  AngularVelocity<Gcrf, Body, In<Gcrf>> operator()(const Quantity<si::time>& t,
                                                   const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};

auto step(const InReference& in_reference, const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const Quantity<si::time>& t, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  const auto in_body = [&](const Quantity<si::time>& now, const Dcm<Gcrf, Body>& R) {
    return inverse(R) * in_reference(now, R);
  };
  return munthe_kaas_step<4>(in_body, R_gcrf_from_body, t, dt);
#else
  return munthe_kaas_step<4>(in_reference, R_gcrf_from_body, t, dt);
#endif
}
}  // namespace munthe_kaas_step_of_rate_in_reference
