// Covariances
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace covariance_distance_across_frames {
// mistake: the Mahalanobis distance of a vector expressed in another frame than the covariance
// expect: CovarianceIn = Body
// expect: VectorIn = Gcrf
auto outlier(const Covariance<Body, si::length>& P_body, const Vector<Gcrf, si::length>& r_gcrf,
             const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return mahalanobis_distance(P_body, R_body_from_gcrf * r_gcrf);
#else
  return static_cast<void>(R_body_from_gcrf), mahalanobis_distance(P_body, r_gcrf);
#endif
}
}  // namespace covariance_distance_across_frames

namespace covariance_from_bare_matrix {
// mistake: a bare matrix as a covariance: nothing says in which frame and unit it is
// expect: Covariance<Body
// expect: (Eigen::Matrix<double, 3, 3>|Matrix3d)
auto filter(const Eigen::Matrix3d& P) {
#ifdef REPAIRED
  const Covariance<Body, si::length> P_body = covariance<si::length>(in<Body>, P);
#else
  const Covariance<Body, si::length> P_body = P;
#endif
  return P_body;
}
}  // namespace covariance_from_bare_matrix

namespace covariance_multiplied_from_both_sides {
// mistake: a covariance re-expressed by hand, R P R^T, when R * P is that already
// expect: Covariance<Camera
// expect: Dcm<Body, Camera
auto in_camera(const Covariance<Body, si::length>& P_body, const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return R_camera_from_body * P_body;
#else
  return R_camera_from_body * P_body * inverse(R_camera_from_body);
#endif
}
}  // namespace covariance_multiplied_from_both_sides

namespace covariance_rotated_by_inverse {
// mistake: a covariance re-expressed by the rotation that leads to its frame instead of from it
// expect: Dcm<Body, Camera
// expect: Covariance<Body
auto in_camera(const Covariance<Body, si::length>& P_body, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return inverse(R_body_from_camera) * P_body;
#else
  return R_body_from_camera * P_body;
#endif
}
}  // namespace covariance_rotated_by_inverse

namespace covariance_sum_across_frames {
// mistake: covariances in different frames added
// expect: Covariance<Body
// expect: Covariance<Gcrf
auto total(const Covariance<Body, si::length>& P_body, const Covariance<Gcrf, si::length>& Q_gcrf,
           const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return P_body + R_body_from_gcrf * Q_gcrf;
#else
  return static_cast<void>(R_body_from_gcrf), P_body + Q_gcrf;
#endif
}
}  // namespace covariance_sum_across_frames

namespace covariance_sum_of_units {
// mistake: the covariance of a velocity added to that of a position
// expect: si::length
// expect: si::velocity
auto total(const Covariance<Body, si::length>& P_body, const Covariance<Body, si::velocity>& Q_body) {
#ifdef REPAIRED
  return static_cast<void>(Q_body), P_body + P_body;
#else
  return P_body + Q_body;
#endif
}
}  // namespace covariance_sum_of_units
