// mistake: a force at the door for a torque
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::force
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto torque(const Displacement<Hinge, Body, In<Body>>& r_hb, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return moment(r_hb, F_body);
#else
  return static_cast<void>(r_hb), torque_about<Hinge>(F_body);
#endif
}
