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
