// mistake: the covariance of a velocity added to that of a position
// expect: si::length
// expect: si::velocity
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto total(const Covariance<Body, si::length>& P_body, const Covariance<Body, si::velocity>& Q_body) {
#ifdef REPAIRED
  return static_cast<void>(Q_body), P_body + P_body;
#else
  return P_body + Q_body;
#endif
}
