// mistake: wrenches about different points added
// expect: Wrench<Hinge
// expect: Wrench<Thruster
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto total(const Wrench<Hinge, In<Body>>& W_hinge, const Wrench<Thruster, In<Body>>& W_thruster,
           const Displacement<Thruster, Hinge, In<Body>>& r_th) {
#ifdef REPAIRED
  return W_hinge + shift(W_thruster, r_th);
#else
  return static_cast<void>(r_th), W_hinge + W_thruster;
#endif
}
