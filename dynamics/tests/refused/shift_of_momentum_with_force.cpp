// mistake: an angular momentum shifted with a force instead of the linear momentum
// expect: AngularMomentum<Thruster
// expect: si::force
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto about_hinge(const AngularMomentum<Thruster, In<Body>>& H_thruster,
                 const Displacement<Thruster, Hinge, In<Body>>& r_th, const Vector<Body, si::force>& F,
                 const Quantity<si::time>& t) {
#ifdef REPAIRED
  return shift(H_thruster, r_th, F * t);
#else
  return static_cast<void>(t), shift(H_thruster, r_th, F);
#endif
}
