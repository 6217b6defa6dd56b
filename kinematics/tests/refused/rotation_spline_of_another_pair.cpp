// mistake: the spline of the body through the samples of the camera
// expect: AttitudeSample<Gcrf, Camera
// expect: A = Gcrf; B = Body|RotationSpline<Gcrf, Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const std::vector<AttitudeSample<Gcrf, Camera>>& samples) {
#ifdef REPAIRED
  return RotationSpline<Gcrf, Camera>(samples, 10.0 * si::second, natural_ends);
#else
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends);
#endif
}
