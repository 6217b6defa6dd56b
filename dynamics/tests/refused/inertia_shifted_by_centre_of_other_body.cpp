// mistake: parallel axes with the centre of mass of another body
// expect: Inertia<Body
// expect: Displacement<(vectrix::)?CentreOfMassOf<Wheel>, Hinge
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto about_hinge(const Inertia<Body>& J_body, const Displacement<CentreOfMassOf<Body>, Hinge, In<Body>>& r_bh,
                 const Displacement<CentreOfMassOf<Wheel>, Hinge, In<Body>>& r_wh,
                 const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return static_cast<void>(r_wh), shift(J_body, r_bh, m);
#else
  return static_cast<void>(r_bh), shift(J_body, r_wh, m);
#endif
}
