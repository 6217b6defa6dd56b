// Sun and Moon
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Gcrf;
using sky::Sun;

struct Satellite : moving_frame {};
struct Camera : moving_frame {};

using Position = Displacement<Gcrf, Satellite, In<Gcrf>>;
using Motion = PointMotion<Gcrf, Satellite, Gcrf>;

namespace line_of_sight_without_a_correction {
// mistake: does not say whether the Sun is where it is or where it is seen
// expect: with a correction:
// expect: Satellite
auto to_the_sun(const Ephemeris<Sun>& sun, const Epoch& t, const Position& r) {
#ifdef REPAIRED
  return sun.line_of_sight(t, r, light_time);
#else
  return sun.line_of_sight(t, r);
#endif
}
}  // namespace line_of_sight_without_a_correction

namespace apparent_place_without_a_velocity {
// mistake: an apparent place for a satellite of which only the position is given
// expect: with a correction:
// expect: Apparent
auto to_the_sun(const Ephemeris<Sun>& sun, const Epoch& t, const Motion& motion) {
#ifdef REPAIRED
  return sun.line_of_sight(t, motion, apparent);
#else
  return sun.line_of_sight(t, motion.position, apparent);
#endif
}
}  // namespace apparent_place_without_a_velocity

namespace image_taken_for_the_body {
// mistake: takes where the Sun is seen for where it is
// expect: Image<(vectrix::)?sky::Sun, (vectrix::)?Apparent>
auto from_the_earth(const Ephemeris<Sun>& sun, const Epoch& t, const Motion& motion) {
#ifdef REPAIRED
  const Displacement<Gcrf, Sun, In<Gcrf>> r_es = motion.position + sun.line_of_sight(t, motion, geometric);
#else
  const Displacement<Gcrf, Sun, In<Gcrf>> r_es = motion.position + sun.line_of_sight(t, motion, apparent);
#endif
  return r_es;
}
}  // namespace image_taken_for_the_body

namespace aberration_in_two_frames {
// mistake: a direction in the camera and a velocity along the axes of GCRF
// expect: Camera
// expect: aberrated\(n_a, v_a\)
auto seen(const Dcm<Camera, Gcrf>& R_camera_from_gcrf, const Vector<Camera, si::dimensionless>& n_camera,
          const Vector<Gcrf, si::velocity>& v_gcrf) {
#ifdef REPAIRED
  return aberrated(n_camera, R_camera_from_gcrf * v_gcrf);
#else
  static_cast<void>(R_camera_from_gcrf);
  return aberrated(n_camera, v_gcrf);
#endif
}
}  // namespace aberration_in_two_frames

namespace sun_and_body_exchanged {
// mistake: the body's line first, and the Sun's after it
// expect: Moon
// expect: r_ps_c, r_pb_c
using ToSun = Displacement<Satellite, Sun, In<Gcrf>>;
using ToMoon = Displacement<Satellite, sky::Moon, In<Gcrf>>;
double seen(const ToSun& r_ps, const ToMoon& r_pm) {
#ifdef REPAIRED
  return visible_sun(r_ps, r_pm, sky::moon_radius);
#else
  return visible_sun(r_pm, r_ps, sky::moon_radius);
#endif
}
}  // namespace sun_and_body_exchanged

namespace centre_taken_for_axes {
// mistake: asks for the rotation of the centre of Mars, a point without axes
// expect: sky::Mars
// expect: a frame fixed to a body
auto of_mars(const Epoch& t) {
#ifdef REPAIRED
  return iau_rotation(of<mars::Iau>, t);
#else
  return iau_rotation(of<sky::Mars>, t);
#endif
}
}  // namespace centre_taken_for_axes

namespace frame_at_another_body {
// mistake: the frame of the Moon where Mars is
// expect: sky::Mars
// expect: the ephemeris of the same body
auto of_the_moon(const Ephemeris<sky::Moon>& moon, const Ephemeris<sky::Mars>& mars, const Epoch& t) {
#ifdef REPAIRED
  static_cast<void>(mars);
  return iau_motion(of<moon::Iau>, moon, t);
#else
  static_cast<void>(moon);
  return iau_motion(of<moon::Iau>, mars, t);
#endif
}
}  // namespace frame_at_another_body

namespace limb_in_two_frames {
// mistake: a boresight in the camera, and the Moon along the axes of GCRF
// expect: Camera
// expect: in one frame
auto keep_out(const Dcm<Camera, Gcrf>& R_camera_from_gcrf, const Vector<Camera, si::dimensionless>& n_camera,
              const Displacement<Satellite, sky::Moon, In<Gcrf>>& r_pm) {
#ifdef REPAIRED
  return angle_from_limb(n_camera, R_camera_from_gcrf * r_pm, sky::moon_radius);
#else
  static_cast<void>(R_camera_from_gcrf);
  return angle_from_limb(n_camera, r_pm, sky::moon_radius);
#endif
}
}  // namespace limb_in_two_frames

namespace ellipsoid_without_its_axis {
// mistake: the Earth's ellipsoid, with lines along the axes of GCRF
// expect: in earth::Itrf
// expect: In<(vectrix::)?(earth::)?Gcrf>
double seen(const Dcm<earth::Itrf, Gcrf>& R_itrf_from_gcrf,
            const Displacement<Satellite, Sun, In<Gcrf>>& r_ps,
            const Displacement<Satellite, Gcrf, In<Gcrf>>& r_pe) {
#ifdef REPAIRED
  return wgs84::visible_sun(R_itrf_from_gcrf * r_ps, R_itrf_from_gcrf * r_pe);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return wgs84::visible_sun(r_ps, r_pe);
#endif
}
}  // namespace ellipsoid_without_its_axis

namespace place_of_a_body_that_has_no_series {
// mistake: asks the series of the Sun, the Moon and the planets for a satellite
// expect: Of<Satellite>
// expect: the Moon or a planet
auto place(const Epoch& t) {
#ifdef REPAIRED
  return geocentric(of<sky::Moon>, t);
#else
  return geocentric(of<Satellite>, t);
#endif
}
}  // namespace place_of_a_body_that_has_no_series

namespace satellite_of_elements_without_the_earth {
// mistake: where a satellite of two-line elements sees the Sun, of a graph that does not join TEME and GCRF
// expect: Lacking = (vectrix::)?UnknownFrame<(vectrix::)?(earth::)?Gcrf
auto to_the_sun(const Ephemeris<Sun>& sun, const EarthOrientation& orientation, const Sgp4<Satellite>& orbit,
                const Epoch& t) {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(orientation), edge(teme(orientation)), edge(orbit));
#else
  static_cast<void>(orientation);
  const auto graph = frame_graph(edge(orbit));
#endif
  const auto now = graph.at(t);
  return sun.direction(now, seen_from<Satellite>, apparent, in<Satellite>);
}
}  // namespace satellite_of_elements_without_the_earth

namespace sun_along_the_axes_of_a_frame_apart {
// mistake: the Sun along the axes of a camera that no edge joins to the satellite
// expect: Lacking = (vectrix::)?UnknownFrame<Camera
auto to_the_sun(const Ephemeris<Sun>& sun, const Motion& motion, const Dcm<Camera, Satellite>& mounting,
                const Epoch& t) {
  const auto orbit = [=](const Epoch&) { return parallel(motion); };
#ifdef REPAIRED
  const auto graph = frame_graph(edge(orbit), static_edge(mounting));
#else
  static_cast<void>(mounting);
  const auto graph = frame_graph(edge(orbit));
#endif
  const auto now = graph.at(t);
  return sun.line_of_sight(now, seen_from<Satellite>, light_time, in<Camera>);
}
}  // namespace sun_along_the_axes_of_a_frame_apart

namespace rotation_of_a_planet_at_no_time {
// mistake: the rotation of Mars without an epoch
// expect: Of<(vectrix::)?mars::Iau
// expect: an Epoch
auto of_mars(const Epoch& t) {
#ifdef REPAIRED
  return iau_rotation(of<mars::Iau>, t);
#else
  static_cast<void>(t);
  return iau_rotation(of<mars::Iau>);
#endif
}
}  // namespace rotation_of_a_planet_at_no_time
