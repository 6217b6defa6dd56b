// mistake: the cross product r x F returned as a force
// expect: si::torque
// expect: si::force
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto load(const Vector<Body, si::length>& r_body, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  const Vector<Body, si::torque> load_body = cross(r_body, F_body);
  return load_body;
#else
  const Vector<Body, si::force> load_body = cross(r_body, F_body);
  return load_body;
#endif
}
