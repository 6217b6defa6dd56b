// mistake: a vector of one frame assigned to a variable of another
// expect: Vector<Gcrf, (vectrix::)?si::length
// expect: Vector<Body, (vectrix::)?si::length
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Vector<Body, si::length> position(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                                  const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  return R_body_from_gcrf * r_gcrf;
#else
  static_cast<void>(R_body_from_gcrf);
  return r_gcrf;
#endif
}
