// mistake: the length of a position given for a speed
// expect: quantity
// expect: Quantity<si::velocity>|time_base_dimension
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

void apply(Quantity<si::velocity> given);

void use(const Vector<Gcrf, si::length>& r_gcrf, const Vector<Gcrf, si::velocity>& v_gcrf) {
#ifdef REPAIRED
  static_cast<void>(r_gcrf);
  apply(norm(v_gcrf));
#else
  static_cast<void>(v_gcrf);
  apply(norm(r_gcrf));
#endif
}
