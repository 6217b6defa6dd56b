// mistake: an inertia re-expressed by the rotation that leads to its frame instead of from it
// expect: Dcm<Body, Eci
// expect: Inertia<Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto in_eci(const Inertia<Body>& J_body, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return inverse(R_body_from_eci) * J_body;
#else
  return R_body_from_eci * J_body;
#endif
}
