#include <vectrix/space/sky/stars.hpp>

#include <erfa.h>
#include <erfam.h>

#include <vectrix/space/sky/aberration.hpp>

namespace vectrix::detail {

Eigen::Vector3d StarSight::direction(LightTime, const Star& star, const Epoch& epoch,
                                     const Eigen::Vector3d& r) const {
  return star.direction_from(trusted, epoch, sun_.earth(epoch).position + r);
}

Eigen::Vector3d StarSight::direction(Apparent, const Star& star, const Epoch& epoch, const Eigen::Vector3d& r,
                                     const Eigen::Vector3d& v) const {
  const PlainMotion earth = sun_.earth(epoch);
  const Eigen::Vector3d n = star.direction_from(trusted, epoch, earth.position + r);
  const Eigen::Vector3d from_sun = r - sun_.motion(epoch).position;
  const double distance = from_sun.norm();
  const Eigen::Vector3d away = from_sun / distance;
  Eigen::Vector3d deflected;
  // ERFA 2.0 takes arrays without const.
  eraLdsun(const_cast<double*>(n.data()), const_cast<double*>(away.data()), distance / ERFA_DAU,
           deflected.data());
  return aberrated(deflected.normalized(), earth.velocity + v);
}

}  // namespace vectrix::detail
