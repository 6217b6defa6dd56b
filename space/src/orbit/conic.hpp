#pragma once

#include <string>
#include <vectrix/space/orbit/two_body.hpp>

namespace vectrix::detail {

/// What both kinds of elements need of a motion: the semi-latus rectum, the unit normal, e cos nu and
/// e sin nu.
struct Conic {
  double p;
  Eigen::Vector3d normal;
  double e_cos_nu, e_sin_nu;
};
/// Throws BadInput if mu is not positive, the motion has no plane, or p/r is so small that the elements would
/// not give r back.
Conic conic_of(const Caller& name, double mu, const OrbitNumbers& orbit);

/// The motion r = radius (cosine P + sine Q), v = (mu/p)^1/2 (x P + y Q) in the plane of the unit vectors P
/// and Q. Throws BadInput if it is not finite.
struct PlanarMotion {
  double radius, cosine, sine, x, y;
};
OrbitNumbers in_space(const Caller& name, double mu, double p, const PlanarMotion& motion,
                      const Eigen::Vector3d& P, const Eigen::Vector3d& Q);

void require_positive(const Caller& name, const char* what, double value, const char* unit);

}  // namespace vectrix::detail
