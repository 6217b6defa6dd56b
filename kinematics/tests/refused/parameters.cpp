// Euler angles and other parameters
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace axis_angle_about_axis_of_third_frame {
// mistake: an axis expressed in a frame that is neither turned nor turned from
// expect: Axis = (vectrix::)?Vector<Camera
// expect: a direction in one of them
auto attitude(const Vector<Camera, si::dimensionless>& n_c, const Dcm<Body, Camera>& R_b_from_c,
              Quantity<si::angle> angle) {
#ifdef REPAIRED
  return axis_angle(of<Body>, relative_to<Gcrf>, R_b_from_c * n_c, angle);
#else
  return static_cast<void>(R_b_from_c), axis_angle(of<Body>, relative_to<Gcrf>, n_c, angle);
#endif
}
}  // namespace axis_angle_about_axis_of_third_frame

namespace euler_angles_about_one_axis_twice {
// mistake: two turns in a row about one axis, which are one turn
// expect: Sequence = (vectrix::)?Intrinsic<3, 3, 1>
// expect: no axis twice in a row
auto attitude(Quantity<si::angle> first, Quantity<si::angle> second, Quantity<si::angle> third) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 1, 3>, of<Body>, relative_to<Gcrf>, first, second, third);
#else
  return euler_angles(intrinsic<3, 3, 1>, of<Body>, relative_to<Gcrf>, first, second, third);
#endif
}
}  // namespace euler_angles_about_one_axis_twice

namespace euler_angles_extrinsic_for_intrinsic {
// mistake: angles about the axes of a, which stay, used as angles about axes that turn along
// expect: Extrinsic<3, 2, 1>
// expect: Intrinsic<3, 2, 1>
EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body> attitude(const EulerAngles<Extrinsic<3, 2, 1>, Gcrf, Body>& x) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, dcm(x));
#else
  return x;
#endif
}
}  // namespace euler_angles_extrinsic_for_intrinsic

namespace euler_angles_of_degrees {
// mistake: angles in degrees
// expect: Sequence = (vectrix::)?Intrinsic<3, 2, 1>
// expect: two frames; angles in rad
auto attitude(double yaw, double pitch, double roll) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, convert<si::angle>(yaw * si::degree),
                      convert<si::angle>(pitch * si::degree), convert<si::angle>(roll * si::degree));
#else
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, yaw * si::degree, pitch * si::degree,
                      roll * si::degree);
#endif
}
}  // namespace euler_angles_of_degrees

namespace euler_angles_of_one_frame {
// mistake: the Euler angles of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
auto attitude(Quantity<si::angle> yaw, Quantity<si::angle> pitch, Quantity<si::angle> roll) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, yaw, pitch, roll);
#else
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Body>, yaw, pitch, roll);
#endif
}
}  // namespace euler_angles_of_one_frame

namespace euler_angles_of_other_sequence {
// mistake: 3-1-3 angles used as 3-2-1
// expect: Intrinsic<3, 1, 3>
// expect: Intrinsic<3, 2, 1>
EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body> attitude(const EulerAngles<Intrinsic<3, 1, 3>, Gcrf, Body>& x) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, dcm(x));
#else
  return x;
#endif
}
}  // namespace euler_angles_of_other_sequence

namespace euler_rate_of_other_sequence {
// mistake: the rates of 3-1-3 angles taken for those of 3-2-1 angles
// expect: Attitude = (vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 2, 1>, Gcrf, Body
// expect: Rate = (vectrix::)?ParameterRate<(vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 1, 3>, Gcrf, Body
// expect: xdot the rate of that x
using Angles321 = EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>;
using Angles313 = EulerAngles<Intrinsic<3, 1, 3>, Gcrf, Body>;

auto rate_of(const Angles321& x, const ParameterRate<Angles321>& xdot,
             const ParameterRate<Angles313>& xdot_313) {
#ifdef REPAIRED
  return static_cast<void>(xdot_313), angular_velocity_from(x, xdot, in<Body>);
#else
  return static_cast<void>(xdot), angular_velocity_from(x, xdot_313, in<Body>);
#endif
}
}  // namespace euler_rate_of_other_sequence

namespace gibbs_as_modified_rodrigues {
// mistake: a Gibbs vector used as modified Rodrigues parameters
// expect: GibbsVector<Gcrf, Body
// expect: ModifiedRodrigues<Gcrf, Body
ModifiedRodrigues<Gcrf, Body> attitude(const GibbsVector<Gcrf, Body>& g) {
#ifdef REPAIRED
  return modified_rodrigues(quaternion(g));
#else
  return g;
#endif
}
}  // namespace gibbs_as_modified_rodrigues

namespace gibbs_rate_of_modified_rodrigues {
// mistake: the rate of modified Rodrigues parameters taken for that of a Gibbs vector
// expect: Attitude = (vectrix::)?GibbsVector<Gcrf, Body
// expect: Rate = (vectrix::)?ParameterRate<(vectrix::)?ModifiedRodrigues<Gcrf, Body
// expect: xdot the rate of that x
auto rate_of(const GibbsVector<Gcrf, Body>& g, const ModifiedRodrigues<Gcrf, Body>& sigma,
             const ParameterRate<ModifiedRodrigues<Gcrf, Body>>& sigmadot) {
#ifdef REPAIRED
  return static_cast<void>(g), angular_velocity_from(sigma, sigmadot, in<Body>);
#else
  return static_cast<void>(sigma), angular_velocity_from(g, sigmadot, in<Body>);
#endif
}
}  // namespace gibbs_rate_of_modified_rodrigues

namespace modified_rodrigues_driven_by_reversed_rate {
// mistake: parameters of b relative to a driven by the rate of a relative to b
// expect: Rotation = (vectrix::)?ModifiedRodrigues<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Body, Gcrf
auto rate_of(const ModifiedRodrigues<Gcrf, Body>& sigma,
             const AngularVelocity<Body, Gcrf, In<Body>>& w_bi_b) {
#ifdef REPAIRED
  return rate(sigma, -w_bi_b);
#else
  return rate(sigma, w_bi_b);
#endif
}
}  // namespace modified_rodrigues_driven_by_reversed_rate

namespace modified_rodrigues_of_rotation_vector {
// mistake: a rotation vector, in radians, given for modified Rodrigues parameters
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angle
// expect: numbers without unit
auto attitude(const Vector<Body, si::angle>& theta) {
#ifdef REPAIRED
  return modified_rodrigues(exp_quaternion(rotation_vector(of<Body>, relative_to<Gcrf>, theta)));
#else
  return modified_rodrigues(of<Body>, relative_to<Gcrf>, theta);
#endif
}
}  // namespace modified_rodrigues_of_rotation_vector
