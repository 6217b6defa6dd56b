// A user's program with frames alone: coordinates are transformed from a to b and back.
#include <vectrix/frames.hpp>

struct Site : vectrix::inertial_frame {};
struct Mast : vectrix::moving_frame {};

int main() {
  using namespace vectrix;
  const Eigen::Matrix3d quarter_turn = (Eigen::Matrix3d() << 0, 1, 0, -1, 0, 0, 0, 0, 1).finished();
  const Dcm<Mast, Site> R_mast_from_site = dcm(to<Mast>, from<Site>, quarter_turn);
  const Vector<Site, si::length> r_site = vector(in<Site>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre);
  const Vector<Mast, si::length> r_mast = R_mast_from_site * r_site;
  return (r_mast.coordinates() - Eigen::Vector3d(2, -1, 3)).norm() < 1e-15 ? 0 : 1;
}
