// mistake: the moment of a force expressed in other axes than its lever arm
// expect: Displacement<Hinge, Body
// expect: Eci
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto torque(const Displacement<Hinge, Body, In<Body>>& r_hb, const Vector<Eci, si::force>& F_eci,
            const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return moment(r_hb, R_body_from_eci * F_eci);
#else
  return static_cast<void>(R_body_from_eci), moment(r_hb, F_eci);
#endif
}
