// mistake: w_ab^a assigned to a variable of type w_ab^b
// expect: In<Gcrf>
// expect: In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

AngularVelocity<Gcrf, Body, In<Body>> rate(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                                           const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf) {
#ifdef REPAIRED
  return R_body_from_gcrf * w_gcrf;
#else
  static_cast<void>(R_body_from_gcrf);
  return w_gcrf;
#endif
}
