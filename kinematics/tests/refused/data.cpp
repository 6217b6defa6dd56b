// Rotations from data
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace attitude_sample_transposed {
// mistake: a line of an attitude file that takes Gcrf to the body, kept as one that takes the body to Gcrf
// expect: Quaternion<Body, ?Gcrf
// expect: Quaternion<Gcrf, ?Body
auto line(const Quantity<si::time>& t, const Quaternion<Body, Gcrf>& q_b_from_i) {
#ifdef REPAIRED
  return AttitudeSample<Gcrf, Body>{t, inverse(q_b_from_i)};
#else
  return AttitudeSample<Gcrf, Body>{t, q_b_from_i};
#endif
}
}  // namespace attitude_sample_transposed

namespace estimate_motion_with_deviation_in_arcseconds {
// mistake: the deviation of the samples in arc seconds, which would be taken for radians
// expect: samples of b relative to a, t and half width in s, sigma in rad
// expect: AttitudeSample<Gcrf, Body
auto estimate(const std::vector<AttitudeSample<Gcrf, Body>>& samples) {
#ifdef REPAIRED
  return estimate_motion(samples, 10.0 * si::second, 2.0 * si::second,
                         convert<si::angle>(5.0 * si::arcsecond));
#else
  return estimate_motion(samples, 10.0 * si::second, 2.0 * si::second, 5.0 * si::arcsecond);
#endif
}
}  // namespace estimate_motion_with_deviation_in_arcseconds

namespace mean_of_transposed_rotations {
// mistake: the mean of rotations from the body, asked for as one to it
// expect: ToFrame = Body[;,] FromFrame = Gcrf
// expect: Quaternion<Gcrf, Body(, double)?>
auto average(const std::vector<Quaternion<Gcrf, Body>>& attitudes) {
#ifdef REPAIRED
  return inverse(mean_rotation(to<Gcrf>, from<Body>, attitudes).rotation);
#else
  return mean_rotation(to<Body>, from<Gcrf>, attitudes);
#endif
}
}  // namespace mean_of_transposed_rotations

namespace observation_in_one_frame {
// mistake: both vectors of an observation are in the body: they say nothing of its attitude
// expect: Measured = vectrix::Vector<Body|Vector<Body.*Vector<Body
auto observe(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
             const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  static_cast<void>(R_b_from_i);
  return observation(sun_b, sun_i, 0.01 * si::radian);
#else
  return observation(sun_b, R_b_from_i * sun_i, 0.01 * si::radian);
#endif
}
}  // namespace observation_in_one_frame

namespace observation_of_two_quantities {
// mistake: a line of sight is said to be the magnetic force in the other frame
// expect: Vector<Body, vectrix::si::length
// expect: Vector<Gcrf, vectrix::si::force
auto observe(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
             const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  static_cast<void>(pull_i);
  return observation(sun_b, sun_i, 0.01 * si::radian);
#else
  static_cast<void>(sun_i);
  return observation(sun_b, pull_i, 0.01 * si::radian);
#endif
}
}  // namespace observation_of_two_quantities

namespace observation_with_deviation_in_arcseconds {
// mistake: a standard deviation in arc seconds, which would be taken for radians
// expect: r_b, r_a, sigma: one direction in two frames, in one unit; an angle in rad
// expect: Vector<Body
auto observe(const Vector<Body, si::length>& star_b, const Vector<Gcrf, si::length>& star_i) {
#ifdef REPAIRED
  return observation(star_b, star_i, convert<si::angle>(5.0 * si::arcsecond));
#else
  return observation(star_b, star_i, 5.0 * si::arcsecond);
#endif
}
}  // namespace observation_with_deviation_in_arcseconds

namespace rotation_spline_of_another_pair {
// mistake: the spline of the body through the samples of the camera
// expect: AttitudeSample<Gcrf, Camera
// expect: A = Gcrf; B = Body|RotationSpline<Gcrf, Body>
auto motion(const std::vector<AttitudeSample<Gcrf, Camera>>& samples) {
#ifdef REPAIRED
  return RotationSpline<Gcrf, Camera>(samples, 10.0 * si::second, natural_ends);
#else
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends);
#endif
}
}  // namespace rotation_spline_of_another_pair

namespace rotation_spline_with_rate_in_reference {
// mistake: the rate at an end is expressed in Gcrf, that of the spline in the body
// expect: AngularVelocity<Gcrf, Body, vectrix::In<Gcrf>|AngularVelocity<Gcrf, Body, In<Gcrf>
// expect: natural_ends, or w_ab_b at the first and the last
auto motion(const std::vector<AttitudeSample<Gcrf, Body>>& samples,
            const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_ib_i) {
#ifdef REPAIRED
  const auto in_body = [&](const AttitudeSample<Gcrf, Body>& sample) {
    return inverse(sample.q_a_from_b) * w_ib_i;
  };
  return RotationSpline(samples, 10.0 * si::second, in_body(samples.front()), in_body(samples.back()));
#else
  return RotationSpline(samples, 10.0 * si::second, w_ib_i, w_ib_i);
#endif
}
}  // namespace rotation_spline_with_rate_in_reference

namespace rotation_spline_without_ends {
// mistake: nothing is said of the ends of a spline: no claim is made by default
// expect: natural_ends, or w_ab_b at the first and the last
// expect: AttitudeSample<Gcrf, Body
auto motion(const std::vector<AttitudeSample<Gcrf, Body>>& samples) {
#ifdef REPAIRED
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends);
#else
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second);
#endif
}
}  // namespace rotation_spline_without_ends

namespace triad_frames_exchanged {
// mistake: the references come first and the measurements second in each pair
// expect: to<B>, from<A>, r_b, r_a, s_b, s_a
// expect: First = vectrix::Vector<Gcrf|Vector<Gcrf
auto attitude(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
              const Vector<Body, si::force>& pull_b, const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  return triad(to<Body>, from<Gcrf>, sun_b, sun_i, pull_b, pull_i);
#else
  return triad(to<Body>, from<Gcrf>, sun_i, sun_b, pull_i, pull_b);
#endif
}
}  // namespace triad_frames_exchanged

namespace wahba_covariance_without_errors {
// mistake: the covariance of an attitude found from weights alone: no error was said
// expect: AttitudeFit<Body, Gcrf
// expect: covariance
auto uncertainty(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
                 const Vector<Body, si::force>& pull_b, const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  const auto sigma = 0.01 * si::radian;
  return wahba(to<Body>, from<Gcrf>,
               std::vector{observation(sun_b, sun_i, sigma), observation(pull_b, pull_i, sigma)})
      .covariance;
#else
  return wahba(
             to<Body>, from<Gcrf>,
             std::vector{weighted_observation(sun_b, sun_i, 1.0), weighted_observation(pull_b, pull_i, 2.0)})
      .covariance;
#endif
}
}  // namespace wahba_covariance_without_errors

namespace wahba_frames_exchanged {
// mistake: the observations are of the body from Gcrf, the rotation asked for is the other way round
// expect: ToFrame = Gcrf[;,] FromFrame = Body
// expect: Observation<Body, Gcrf>
auto attitude(const std::vector<Observation<Body, Gcrf>>& stars) {
#ifdef REPAIRED
  return inverse(wahba(to<Body>, from<Gcrf>, stars).rotation);
#else
  return wahba(to<Gcrf>, from<Body>, stars);
#endif
}
}  // namespace wahba_frames_exchanged
