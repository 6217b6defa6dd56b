// mistake: a displacement and a velocity added
// expect: Left = (vectrix::)?Vector<Gcrf, (vectrix::)?si::length
// expect: Right = (vectrix::)?Vector<Gcrf, (vectrix::)?si::velocity
// expect: one frame and one unit
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto next(const Vector<Gcrf, si::length>& r_gcrf, const Vector<Gcrf, si::velocity>& v_gcrf,
          Quantity<si::time> dt) {
#ifdef REPAIRED
  return r_gcrf + v_gcrf * dt;
#else
  static_cast<void>(dt);
  return r_gcrf + v_gcrf;
#endif
}
