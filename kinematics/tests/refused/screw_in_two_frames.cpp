// mistake: a screw whose rotation is expressed in b and whose translation in a
// expect: OfFrame = (vectrix::)?Of<Body>
// expect: Rotation = (vectrix::)?Vector<Body
// expect: Translation = (vectrix::)?Vector<Gcrf
// expect: an angle and a length expressed in one of them
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const Vector<Body, si::angle>& theta_b, const Vector<Gcrf, si::length>& rho_a,
            const Dcm<Body, Gcrf>& R_b_from_a) {
#ifdef REPAIRED
  return screw(of<Body>, relative_to<Gcrf>, theta_b, R_b_from_a * rho_a);
#else
  static_cast<void>(R_b_from_a);
  return screw(of<Body>, relative_to<Gcrf>, theta_b, rho_a);
#endif
}
