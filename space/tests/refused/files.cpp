// Files
#include <vectrix/space.hpp>

using namespace vectrix;

struct MarsInertial : inertial_frame {};
struct Ship : moving_frame {};
struct Body : moving_frame {};

namespace orbit_file_in_a_frame_without_a_name {
// mistake: the samples of an orbit file in a frame of one's own, without the name that it has in the file
// expect: MarsInertial
// expect: if A has no standard name in a file
auto samples(const OrbitEphemerisSegment& segment) {
#ifdef REPAIRED
  return segment.samples<MarsInertial, Ship>(called<MarsInertial>("EME2000", "MARS BARYCENTER"));
#else
  return segment.samples<MarsInertial, Ship>();
#endif
}
}  // namespace orbit_file_in_a_frame_without_a_name

namespace orbit_file_with_a_name_of_another_frame {
// mistake: the name in the file is claimed of another frame than the one asked for
// expect: Called<MarsInertial>
// expect: earth::Eme2000
auto samples(const OrbitEphemerisSegment& segment) {
#ifdef REPAIRED
  return segment.samples<MarsInertial, Ship>(called<MarsInertial>("EME2000", "MARS BARYCENTER"));
#else
  return segment.samples<earth::Eme2000, Ship>(called<MarsInertial>("EME2000", "MARS BARYCENTER"));
#endif
}
}  // namespace orbit_file_with_a_name_of_another_frame

namespace orbit_file_of_samples_by_elapsed_time {
// mistake: an orbit file of samples by seconds, of which no file knows the date
// expect: PositionSample<(vectrix::)?earth::Gcrf, Ship
// expect: metadata, samples of q in a
auto segment(const std::vector<PositionSample<earth::Gcrf, Ship>>& by_seconds,
             const std::vector<PositionSample<earth::Gcrf, Ship, Epoch>>& by_epoch) {
#ifdef REPAIRED
  static_cast<void>(by_seconds);
  return OrbitEphemerisSegment({"SHIP", "2026-001A"}, by_epoch);
#else
  static_cast<void>(by_epoch);
  return OrbitEphemerisSegment({"SHIP", "2026-001A"}, by_seconds);
#endif
}
}  // namespace orbit_file_of_samples_by_elapsed_time

namespace orbit_file_in_gcrf_in_an_edge_of_eme2000 {
// mistake: samples in Eme2000 taken for samples in Gcrf
// expect: earth::Eme2000
// expect: samples of q in a
auto motion(const OrbitEphemerisSegment& segment, const Quantity<si::time>& gap) {
#ifdef REPAIRED
  return SampledPosition<earth::Eme2000, Ship, Epoch>(segment.samples<earth::Eme2000, Ship>(), gap);
#else
  return SampledPosition<earth::Gcrf, Ship, Epoch>(segment.samples<earth::Eme2000, Ship>(), gap);
#endif
}
}  // namespace orbit_file_in_gcrf_in_an_edge_of_eme2000

namespace attitude_file_of_a_body_without_a_name {
// mistake: the samples of an attitude file for a body, without the name that it has in the file
// expect: (vectrix::)?earth::Eme2000
// expect: Body
// expect: two frames; if F has no standard name in a file
auto samples(const AttitudeEphemerisSegment& segment) {
#ifdef REPAIRED
  return segment.samples<earth::Eme2000, Body>(called<Body>("SC_BODY_1"));
#else
  return segment.samples<earth::Eme2000, Body>();
#endif
}
}  // namespace attitude_file_of_a_body_without_a_name

namespace attitude_file_transposed {
// mistake: samples of the body relative to Eme2000 taken for those of Eme2000 relative to the body
// expect: AttitudeSample<(vectrix::)?earth::Eme2000, Body
// expect: samples of b relative to a
auto attitude(const AttitudeEphemerisSegment& segment, const Quantity<si::time>& gap) {
#ifdef REPAIRED
  return SampledAttitude<Body, earth::Eme2000, Epoch>(
      segment.samples<Body, earth::Eme2000>(called<Body>("SC_BODY_1")), gap);
#else
  return SampledAttitude<Body, earth::Eme2000, Epoch>(
      segment.samples<earth::Eme2000, Body>(called<Body>("SC_BODY_1")), gap);
#endif
}
}  // namespace attitude_file_transposed

namespace attitude_file_with_rates_in_a_third_frame {
// mistake: the rates of an attitude file asked for in a frame that is neither of the two of the file
// expect: Ship
// expect: in A or B; if F has no standard name
auto rates(const AttitudeEphemerisSegment& segment) {
#ifdef REPAIRED
  return segment.angular_velocities<earth::Eme2000, Body>(in<Body>, called<Body>("SC_BODY_1"));
#else
  return segment.angular_velocities<earth::Eme2000, Body>(in<Ship>, called<Body>("SC_BODY_1"));
#endif
}
}  // namespace attitude_file_with_rates_in_a_third_frame

namespace attitude_file_with_rates_of_another_body {
// mistake: an attitude file of one body with the rates of another
// expect: AngularVelocity<(vectrix::)?earth::Eme2000, Ship
// expect: metadata, samples of b relative to a
auto segment(const std::vector<AttitudeSample<earth::Eme2000, Body, Epoch>>& samples,
             const std::vector<AngularVelocity<earth::Eme2000, Body, In<Body>>>& of_body,
             const std::vector<AngularVelocity<earth::Eme2000, Ship, In<Ship>>>& of_ship) {
#ifdef REPAIRED
  static_cast<void>(of_ship);
  return AttitudeEphemerisSegment({"SHIP", "2026-001A"}, samples, of_body, called<Body>("SC_BODY_1"));
#else
  static_cast<void>(of_body);
  return AttitudeEphemerisSegment({"SHIP", "2026-001A"}, samples, of_ship, called<Body>("SC_BODY_1"));
#endif
}
}  // namespace attitude_file_with_rates_of_another_body

namespace attitude_kernel_without_the_name_of_a_frame {
// mistake: the attitude of a body of an attitude kernel, without the name that it has there
// expect: Body
// expect: if F has no standard name in a file
auto attitude(const AttitudeKernel& kernel) {
#ifdef REPAIRED
  return kernel.attitude(of<Body>, relative_to<earth::Gcrf>, kernel.span(), called<Body>("BODY_COORD"));
#else
  return kernel.attitude(of<Body>, relative_to<earth::Gcrf>, kernel.span());
#endif
}
}  // namespace attitude_kernel_without_the_name_of_a_frame

namespace attitude_kernel_with_rates_in_the_body {
// mistake: an attitude kernel of rates in the axes of the body: the format has them in those of the reference
// expect: In<Body>
// expect: rates in a
auto write(const std::vector<AttitudeSample<earth::Gcrf, Body, Epoch>>& samples,
           const std::vector<AngularVelocity<earth::Gcrf, Body, In<earth::Gcrf>>>& in_gcrf,
           const std::vector<AngularVelocity<earth::Gcrf, Body, In<Body>>>& in_body,
           const SpacecraftClock& clock, const FrameKernel& frames) {
  const AttitudeKernelText text{"BODY", 10.0 * si::second};
#ifdef REPAIRED
  static_cast<void>(in_body);
  return write_attitude_kernel("x.bc", text, samples, in_gcrf, clock, frames, called<Body>("BODY_COORD"));
#else
  return write_attitude_kernel("x.bc", text, samples, in_body, clock, frames, called<Body>("BODY_COORD"));
#endif
}
}  // namespace attitude_kernel_with_rates_in_the_body

namespace ephemeris_kernel_of_a_frame_without_an_origin {
// mistake: the orbit of a ship from an ephemeris kernel in a frame of one's own, of which it does not know the origin
// expect: MarsInertial
// expect: if one has no standard name in kernels
auto motion(const EphemerisKernel& kernel) {
#ifdef REPAIRED
  return kernel.motion(of<Ship>, relative_to<MarsInertial>, kernel.span(), called<Ship>("-77"),
                       called<MarsInertial>("J2000", "MARS BARYCENTER"));
#else
  return kernel.motion(of<Ship>, relative_to<MarsInertial>, kernel.span(), called<Ship>("-77"));
#endif
}
}  // namespace ephemeris_kernel_of_a_frame_without_an_origin
