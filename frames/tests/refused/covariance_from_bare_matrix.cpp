// mistake: a bare matrix as a covariance: nothing says in which frame and unit it is
// expect: Covariance<Body
// expect: (Eigen::Matrix<double, 3, 3>|Matrix3d)
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto filter(const Eigen::Matrix3d& P) {
#ifdef REPAIRED
  const Covariance<Body, si::length> P_body = covariance<si::length>(in<Body>, P);
#else
  const Covariance<Body, si::length> P_body = P;
#endif
  return P_body;
}
