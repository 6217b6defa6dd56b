// mistake: the centre of mass of one body with the inertia of another
// expect: Inertia<Wheel
// expect: CentreOfMassOf<Body>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto wheel(const Quantity<si::mass>& m, const Displacement<Body, CentreOfMassOf<Body>, In<Wheel>>& r_body,
           const Displacement<Body, CentreOfMassOf<Wheel>, In<Wheel>>& r_wheel,
           const Inertia<Wheel>& J_wheel) {
#ifdef REPAIRED
  return static_cast<void>(r_body), mass_properties(m, r_wheel, J_wheel);
#else
  return static_cast<void>(r_wheel), mass_properties(m, r_body, J_wheel);
#endif
}
