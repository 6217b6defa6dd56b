// mistake: a wrench shifted by a displacement expressed in other axes
// expect: Wrench<Thruster, (vectrix::)?In<Body>
// expect: Displacement<Thruster, Hinge, (vectrix::)?In<Eci>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto about_hinge(const Wrench<Thruster, In<Body>>& W_thruster,
                 const Displacement<Thruster, Hinge, In<Eci>>& r_eci, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return shift(W_thruster, R_body_from_eci * r_eci);
#else
  return static_cast<void>(R_body_from_eci), shift(W_thruster, r_eci);
#endif
}
