#include <cmath>

#include <vectrix/space/earth/site.hpp>

#include "require_geodetic.hpp"

namespace vectrix::detail {

SiteNumbers east_north_up_site(const Caller& name, const Geodetic& place) {
  require_geodetic(name, place);
  const double latitude = place.latitude.angle.value(), longitude = place.longitude.value();
  const Eigen::Vector3d east(-std::sin(longitude), std::cos(longitude), 0.0);
  const Eigen::Vector3d outward(std::cos(longitude), std::sin(longitude), 0.0);
  const Eigen::Vector3d pole = Eigen::Vector3d::UnitZ();
  SiteNumbers site;
  site.axes << east, std::cos(latitude) * pole - std::sin(latitude) * outward,
      std::cos(latitude) * outward + std::sin(latitude) * pole;
  site.position = wgs84::position(place).coordinates();
  return site;
}

SiteNumbers north_east_down_site(const Caller& name, const Geodetic& place) {
  const SiteNumbers enu = east_north_up_site(name, place);
  SiteNumbers site = enu;
  site.axes << enu.axes.col(1), enu.axes.col(0), -enu.axes.col(2);
  return site;
}

}  // namespace vectrix::detail
