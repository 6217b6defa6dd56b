// Sun and Moon
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Gcrf;
using sky::Sun;

struct Satellite : moving_frame {};
struct Camera : moving_frame {};

using Position = Displacement<Gcrf, Satellite, In<Gcrf>>;
using State = PointMotion<Gcrf, Satellite, Gcrf>;

namespace line_of_sight_without_a_correction {
// mistake: does not say whether the Sun is where it is or where it is seen
// expect: p's motion for apparent, or position for light_time
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
// expect: p's motion for apparent, or position for light_time
// expect: Apparent
auto to_the_sun(const Ephemeris<Sun>& sun, const Epoch& t, const State& state) {
#ifdef REPAIRED
  return sun.line_of_sight(t, state, apparent);
#else
  return sun.line_of_sight(t, state.position, apparent);
#endif
}
}  // namespace apparent_place_without_a_velocity

namespace image_taken_for_the_body {
// mistake: takes where the Sun is seen for where it is
// expect: Image<(vectrix::)?sky::Sun, (vectrix::)?Apparent>
auto from_the_earth(const Ephemeris<Sun>& sun, const Epoch& t, const State& state) {
#ifdef REPAIRED
  const Displacement<Gcrf, Sun, In<Gcrf>> r_es = state.position + sun.line_of_sight(t, state, geometric);
#else
  const Displacement<Gcrf, Sun, In<Gcrf>> r_es = state.position + sun.line_of_sight(t, state, apparent);
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
