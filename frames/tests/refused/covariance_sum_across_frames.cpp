// mistake: covariances in different frames added
// expect: Covariance<Body
// expect: Covariance<Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto total(const Covariance<Body, si::length>& P_body, const Covariance<Gcrf, si::length>& Q_gcrf,
           const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return P_body + R_body_from_gcrf * Q_gcrf;
#else
  return static_cast<void>(R_body_from_gcrf), P_body + Q_gcrf;
#endif
}
