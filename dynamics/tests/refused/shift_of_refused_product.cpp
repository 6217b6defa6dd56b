// mistake: a wrench re-expressed by the inverse rotation, inside a shift
// expect: Dcm<Body, Eci
// expect: Wrench<Thruster, (vectrix::)?In<Body>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto about_hinge(const Wrench<Thruster, In<Body>>& W_thruster,
                 const Displacement<Thruster, Hinge, In<Eci>>& r_th, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return shift(inverse(R_body_from_eci) * W_thruster, r_th);
#else
  return shift(R_body_from_eci * W_thruster, r_th);
#endif
}
