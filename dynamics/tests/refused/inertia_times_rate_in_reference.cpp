// mistake: the inertia in the body's axes times the rate in the reference's
// expect: InertiaOf = Body
// expect: RateIn = Gcrf
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto momentum(const Inertia<Body>& J_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
              const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf) {
#ifdef REPAIRED
  return J_body * (R_body_from_gcrf * w_gcrf);
#else
  static_cast<void>(R_body_from_gcrf);
  return J_body * w_gcrf;
#endif
}
