// mistake: the counts of two gyros on two bodies corrected for coning together
// expect: AngleIncrement<Gcrf, Body
// expect: AngleIncrement<Gcrf, Camera
// expect: of one b relative to one a
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const AngleIncrement<Gcrf, Body>& first, [[maybe_unused]] const AngleIncrement<Gcrf, Body>& second,
          [[maybe_unused]] const AngleIncrement<Gcrf, Camera>& of_camera) {
#ifdef REPAIRED
  return coning_corrected(first, second);
#else
  return coning_corrected(first, of_camera);
#endif
}
