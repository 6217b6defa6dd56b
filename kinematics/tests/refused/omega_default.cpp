// mistake: a rate without a value
// expect: AngularVelocity<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate() {
#ifdef REPAIRED
  const AngularVelocity<Gcrf, Body, In<Body>> w_gcrf_body = at_rest(of<Body>, relative_to<Gcrf>, in<Body>);
  return w_gcrf_body;
#else
  const AngularVelocity<Gcrf, Body, In<Body>> w_gcrf_body;
  return w_gcrf_body;
#endif
}
