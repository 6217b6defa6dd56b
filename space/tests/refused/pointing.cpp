// Pointing
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Gcrf, earth::Itrf;
using sky::Sun;

struct Satellite : moving_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

using Motion = PointMotion<Gcrf, Satellite, Gcrf>;
using ToSun = PointMotion<Satellite, Sun, Gcrf>;

namespace first_and_second_direction_exchanged {
// mistake: the direction that is only approached given for the one that is kept
// expect: First = (vectrix::)?Constraint<Body, .*Gcrf
// expect: align\(axis_b, direction_a\), constrain
auto attitude(const Motion& motion, const ToSun& sun) {
  const auto nadir = -moving_direction(motion);
#ifdef REPAIRED
  return pointing(align(unit_z(in<Body>), nadir), constrain(unit_x(in<Body>), moving_direction(sun)));
#else
  return pointing(constrain(unit_x(in<Body>), moving_direction(sun)), align(unit_z(in<Body>), nadir));
#endif
}
}  // namespace first_and_second_direction_exchanged

namespace directions_of_two_observers {
// mistake: one direction observed from the Earth, the other from an inertial frame
// expect: Alignment<Body, .*Gcrf
// expect: Constraint<Body, .*Itrf
auto attitude(const Motion& motion, const PointMotion<Itrf, Satellite, Itrf>& motion_itrf,
              const MovingDcm<Gcrf, Itrf>& earth) {
  const auto velocity = moving_direction(motion_itrf.velocity);
#ifdef REPAIRED
  const auto along = earth * velocity;
#else
  static_cast<void>(earth);
  const auto along = velocity;
#endif
  return pointing(align(unit_z(in<Body>), -moving_direction(motion)), constrain(unit_x(in<Body>), along));
}
}  // namespace directions_of_two_observers

namespace axes_of_two_bodies {
// mistake: one axis of the camera, the other of the body
// expect: Alignment<Camera, .*Gcrf
// expect: Constraint<Body, .*Gcrf
auto attitude(const Motion& motion, const ToSun& sun, const Dcm<Body, Camera>& R_body_from_camera) {
  const auto to_sun = constrain(unit_x(in<Body>), moving_direction(sun));
#ifdef REPAIRED
  return pointing(align(R_body_from_camera * unit_z(in<Camera>), -moving_direction(motion)), to_sun);
#else
  static_cast<void>(R_body_from_camera);
  return pointing(align(unit_z(in<Camera>), -moving_direction(motion)), to_sun);
#endif
}
}  // namespace axes_of_two_bodies

namespace direction_with_a_velocity_of_another_observer {
// mistake: a position in Gcrf and a velocity that the rotating Earth sees
// expect: ObservedFrom<.*Itrf
// expect: observed from the frame in which all are expressed
auto nadir(const Motion& motion, const Velocity<Gcrf, Satellite, ObservedFrom<Itrf>, In<Gcrf>>& v_itrf) {
#ifdef REPAIRED
  static_cast<void>(v_itrf);
  return -moving_direction(motion.position, motion.velocity);
#else
  return -moving_direction(motion.position, v_itrf);
#endif
}
}  // namespace direction_with_a_velocity_of_another_observer

namespace angular_acceleration_of_a_law_without_it {
// mistake: the angular acceleration of a law of which the accelerations were not given
// expect: AccelerationOn<(vectrix::)?Link<(vectrix::)?earth::Gcrf, Body>
struct Given {
  Acceleration<Gcrf, Satellite, ObservedFrom<Gcrf>, In<Gcrf>> a;
  Acceleration<Satellite, Sun, ObservedFrom<Gcrf>, In<Gcrf>> a_sun;
};
auto change(const Motion& motion, const ToSun& sun, [[maybe_unused]] const Given& given) {
#ifdef REPAIRED
  const auto graph = frame_graph(
      edge([=](Quantity<si::time>) { return yaw_steering(from<Body>, motion, given.a, sun, given.a_sun); }));
#else
  const auto graph =
      frame_graph(edge([=](Quantity<si::time>) { return yaw_steering(from<Body>, motion, sun); }));
#endif
  return graph.at(0.0 * si::second).angular_acceleration(of<Body>, relative_to<Gcrf>, in<Body>);
}
}  // namespace angular_acceleration_of_a_law_without_it

namespace yaw_steering_from_the_satellite_to_the_earth {
// mistake: the Earth from the satellite, instead of the satellite from the Earth: z would point upwards
// expect: PointMotion<Satellite, .*Gcrf
// expect: satellite from the Earth
auto attitude(const Motion& motion, const ToSun& sun) {
#ifdef REPAIRED
  return yaw_steering(from<Body>, motion, sun);
#else
  const PointMotion<Satellite, Gcrf, Gcrf> to_earth{-motion.position, -motion.velocity};
  return yaw_steering(from<Body>, to_earth, sun);
#endif
}
}  // namespace yaw_steering_from_the_satellite_to_the_earth

namespace yaw_steering_with_sun_and_earth_exchanged {
// mistake: the Sun in place of the Earth: z would point to the Sun
// expect: PointMotion<(vectrix::)?sky::Sun, Satellite
// expect: satellite from the Earth
auto attitude(const Motion& motion, const ToSun& sun) {
#ifdef REPAIRED
  return yaw_steering(from<Body>, motion, sun);
#else
  const PointMotion<Sun, Satellite, Gcrf> from_sun{-sun.position, -sun.velocity};
  const PointMotion<Satellite, Gcrf, Gcrf> to_earth{-motion.position, -motion.velocity};
  return yaw_steering(from<Body>, from_sun, to_earth);
#endif
}
}  // namespace yaw_steering_with_sun_and_earth_exchanged

namespace zero_doppler_steering_by_the_inertial_velocity {
// mistake: zero-Doppler steering by the velocity in an inertial frame: up to 4 deg off in yaw
// expect: PointMotion<(vectrix::)?earth::Gcrf, Satellite
// expect: observed from the Earth-fixed frame
auto attitude(const Motion& motion, const PointMotion<Itrf, Satellite, Itrf>& motion_itrf) {
#ifdef REPAIRED
  static_cast<void>(motion);
  return zero_doppler_steering(from<Body>, motion_itrf);
#else
  static_cast<void>(motion_itrf);
  return zero_doppler_steering(from<Body>, motion);
#endif
}
}  // namespace zero_doppler_steering_by_the_inertial_velocity

namespace normal_of_the_ellipsoid_in_an_inertial_frame {
// mistake: the normal of the ellipsoid of a place in inertial axes
// expect: PointMotion<(vectrix::)?earth::Gcrf, Satellite
// expect: relative to earth::Itrf
auto up(const Motion& motion, const PointMotion<Itrf, Satellite, Itrf>& motion_itrf) {
#ifdef REPAIRED
  static_cast<void>(motion);
  return wgs84::moving_up(motion_itrf);
#else
  static_cast<void>(motion_itrf);
  return wgs84::moving_up(motion);
#endif
}
}  // namespace normal_of_the_ellipsoid_in_an_inertial_frame

namespace limb_towards_a_direction_of_inertial_axes {
// mistake: the side of the limb as a direction in inertial axes
// expect: MovingDirection<(vectrix::)?earth::Gcrf
// expect: a MovingDirection in earth::Itrf
auto direction_of(const PointMotion<Itrf, Satellite, Itrf>& motion_itrf, const Motion& motion,
                  const MovingDcm<Itrf, Gcrf>& earth) {
  const auto side = moving_direction(motion.velocity);
  const auto height = 30e3 * si::metre;
#ifdef REPAIRED
  return wgs84::limb(height, earth * side, motion_itrf);
#else
  static_cast<void>(earth);
  return wgs84::limb(height, side, motion_itrf);
#endif
}
}  // namespace limb_towards_a_direction_of_inertial_axes

namespace error_of_a_part_at_an_axis_of_the_body {
// mistake: the error of a camera, in its axes, looked at along an axis of the body
// expect: ErrorIn = Camera
// expect: AxisIn = Body
auto cone(const Covariance<Camera, si::angle>& P_camera, const Dcm<Body, Camera>& R_body_from_camera) {
  const auto noise = constant_error(P_camera);
#ifdef REPAIRED
  return absolute_error(R_body_from_camera * noise, unit_z(in<Body>));
#else
  return static_cast<void>(R_body_from_camera), absolute_error(noise, unit_z(in<Body>));
#endif
}
}  // namespace error_of_a_part_at_an_axis_of_the_body

namespace errors_of_two_frames {
// mistake: errors that arise in two frames added
// expect: PointingError<Body>
// expect: PointingError<Camera>
auto total(const Covariance<Body, si::angle>& P_body, const Covariance<Camera, si::angle>& P_camera,
           const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return constant_error(P_body) + R_body_from_camera * constant_error(P_camera);
#else
  return static_cast<void>(R_body_from_camera), constant_error(P_body) + constant_error(P_camera);
#endif
}
}  // namespace errors_of_two_frames

namespace error_outside_the_chain {
// mistake: an error carried by a rotation that does not begin at its frame
// expect: Dcm<Body, Camera
// expect: PointingError<Body>
auto in_body(const Covariance<Body, si::angle>& P_body, const Covariance<Camera, si::angle>& P_camera,
             const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return static_cast<void>(P_body), R_body_from_camera * constant_error(P_camera);
#else
  return static_cast<void>(P_camera), R_body_from_camera * constant_error(P_body);
#endif
}
}  // namespace error_outside_the_chain

namespace correlation_time_without_a_unit {
// mistake: a bare number as a correlation time
// expect: random_error
// expect: double
auto noise(const Covariance<Camera, si::angle>& P_camera) {
#ifdef REPAIRED
  return random_error(P_camera, 0.5 * si::second);
#else
  return random_error(P_camera, 0.5);
#endif
}
}  // namespace correlation_time_without_a_unit
