// mistake: wrenches expressed in different frames added
// expect: Wrench<Hinge, (vectrix::)?In<Body>
// expect: Wrench<Hinge, (vectrix::)?In<Eci>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto total(const Wrench<Hinge, In<Body>>& W_body, const Wrench<Hinge, In<Eci>>& W_eci,
           const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return W_body + R_body_from_eci * W_eci;
#else
  return static_cast<void>(R_body_from_eci), W_body + W_eci;
#endif
}
