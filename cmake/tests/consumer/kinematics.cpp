// A user's program with frames and kinematics: a mast that turns about z at 2 rad/s, compared with its
// quarter turn.
#include <cmath>
#include <numbers>
#include <vectrix/kinematics.hpp>

struct Site : vectrix::inertial_frame {};
struct Mast : vectrix::moving_frame {};

int main() {
  using namespace vectrix;
  const Dcm<Mast, Site> R_mast_from_site = turned_z(to<Mast>, from<Site>, std::numbers::pi / 2 * si::radian);
  const auto w_sm_m = angular_velocity(of<Mast>, relative_to<Site>,
                                       vector(in<Mast>, 0.0 * si::radian / si::second,
                                              0.0 * si::radian / si::second, 2.0 * si::radian / si::second));
  // d/dt R_m^s = R_m^s [w_sm^m]x, whose first column is 2 R_m^s e_y
  const auto Rdot_site_from_mast = rate(inverse(R_mast_from_site), w_sm_m);
  return (Rdot_site_from_mast.matrix().col(0) - Eigen::Vector3d(-2, 0, 0)).norm() < 1e-15 ? 0 : 1;
}
