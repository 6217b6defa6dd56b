// mistake: a derivative transported by the rate of the old observer relative to a third frame
// expect: Derivative<Body, Body
// expect: AngularVelocity<Gcrf, Camera
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto velocity(const Derivative<Body, Body, si::length>& rdot, const Vector<Body, si::length>& r_body,
              const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera,
              const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera);
  return transport(observed_from<Gcrf>, rdot, r_body, w_gcrf_body);
#else
  static_cast<void>(w_gcrf_body);
  return transport(observed_from<Gcrf>, rdot, r_body, w_gcrf_camera);
#endif
}
