// mistake: a rate expressed in the inertial frame crossed with a position expressed in the rotating one
// expect: AngularVelocity<
// expect: In<Gcrf>.*Vector<Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto velocity_of_turning(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                         const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf,
                         const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return cross(R_body_from_gcrf * w_gcrf, r_body);
#else
  static_cast<void>(R_body_from_gcrf);
  return cross(w_gcrf, r_body);
#endif
}
