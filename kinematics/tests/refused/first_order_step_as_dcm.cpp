// mistake: what a first-order step gave taken for a rotation
// expect: FirstOrderAttitude<Gcrf, Body
// expect: Dcm<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Gcrf, Body> step(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                     const AngularVelocity<Gcrf, Body, In<Body>>& w_body, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return nearest_dcm(first_order_step(R_gcrf_from_body, w_body, dt)).dcm;
#else
  return first_order_step(R_gcrf_from_body, w_body, dt);
#endif
}
