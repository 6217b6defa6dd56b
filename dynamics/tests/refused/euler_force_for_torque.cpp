// mistake: Euler's equation driven by a force
// expect: TorqueGiven = (vectrix::)?Vector<Body, (vectrix::)?si::force
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Vector<Body, si::length>& r_body, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return euler(J_body, w_body, cross(r_body, F_body));
#else
  static_cast<void>(r_body);
  return euler(J_body, w_body, F_body);
#endif
}
