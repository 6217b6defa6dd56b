// mistake: the angular velocity from a rotation vector's rate, asked in neither of its two frames
// expect: Expressed = (vectrix::)?In<Camera>
// expect: angular_velocity\(theta_ab, thetadot_ab, in<B>\) or in<A>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto spin(const RotationVector<Gcrf, Body>& theta_ab, const RotationVectorRate<Gcrf, Body>& thetadot_ab,
          const Dcm<Camera, Body>& R_c_from_b) {
#ifdef REPAIRED
  return R_c_from_b * angular_velocity(theta_ab, thetadot_ab, in<Body>);
#else
  static_cast<void>(R_c_from_b);
  return angular_velocity(theta_ab, thetadot_ab, in<Camera>);
#endif
}
