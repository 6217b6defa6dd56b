// mistake: an axis expressed in a frame that is neither turned nor turned from
// expect: Axis = (vectrix::)?Vector<Camera
// expect: a direction in one of them
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Vector<Camera, si::dimensionless>& n_c, const Dcm<Body, Camera>& R_b_from_c,
              Quantity<si::angle> angle) {
#ifdef REPAIRED
  return axis_angle(of<Body>, relative_to<Gcrf>, R_b_from_c * n_c, angle);
#else
  return static_cast<void>(R_b_from_c), axis_angle(of<Body>, relative_to<Gcrf>, n_c, angle);
#endif
}
