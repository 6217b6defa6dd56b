// mistake: an angular momentum taken for a torque
// expect: si::angular_momentum
// expect: si::torque
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Vector<Body, si::torque> gyroscopic(const Inertia<Body>& J_body,
                                    const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return cross(w_body.vector(), J_body * w_body);
#else
  return J_body * w_body;
#endif
}
