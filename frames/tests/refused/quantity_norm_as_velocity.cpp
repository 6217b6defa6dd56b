// mistake: the length of a position given for a speed
// expect: quantity
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto speed(const Vector<Gcrf, si::length>& r_gcrf, const Vector<Gcrf, si::velocity>& v_gcrf) {
#ifdef REPAIRED
  static_cast<void>(r_gcrf);
  const Quantity<si::velocity> v = norm(v_gcrf);
  return v;
#else
  static_cast<void>(v_gcrf);
  const Quantity<si::velocity> v = norm(r_gcrf);
  return v;
#endif
}
