// mistake: a bare matrix as an inertia: nothing says whose, nor which sign its off-diagonal numbers have
// expect: Inertia<Body
// expect: (Eigen::Matrix<double, 3, 3>|Matrix3d)
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto satellite(const Eigen::Matrix3d& J) {
#ifdef REPAIRED
  const Inertia<Body> J_body = trust_inertia(in<Body>, J);
#else
  const Inertia<Body> J_body = J;
#endif
  return J_body;
}
