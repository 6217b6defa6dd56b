// mistake: the Mahalanobis distance of a vector expressed in another frame than the covariance
// expect: CovarianceIn = Body
// expect: VectorIn = Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto outlier(const Covariance<Body, si::length>& P_body, const Vector<Gcrf, si::length>& r_gcrf,
             const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return mahalanobis_distance(P_body, R_body_from_gcrf * r_gcrf);
#else
  return static_cast<void>(R_body_from_gcrf), mahalanobis_distance(P_body, r_gcrf);
#endif
}
