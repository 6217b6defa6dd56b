// mistake: a torque and a force added
// expect: Left = (vectrix::)?Vector<Body, (vectrix::)?si::torque
// expect: Right = (vectrix::)?Vector<Body, (vectrix::)?si::force
// expect: one frame and one unit
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto load(const Vector<Body, si::torque>& tau_body, const Vector<Body, si::length>& r_body,
          const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return tau_body + cross(r_body, F_body);
#else
  static_cast<void>(r_body);
  return tau_body + F_body;
#endif
}
