#include <cmath>

#include <vectrix/space/earth/site.hpp>

#include "latitude.hpp"

namespace vectrix::detail {

SiteNumbers east_north_up_site(const std::string& name, const Geodetic& place) {
  const double latitude = checked_latitude(name, place), longitude = place.longitude.value();
  if (!std::isfinite(longitude)) {
    throw BadInput(name + ": the longitude " + text(longitude) + " rad is not finite");
  }
  if (!std::isfinite(place.height.value())) {
    throw BadInput(name + ": the height " + text(place.height.value()) + " m is not finite");
  }
  const Eigen::Vector3d east(-std::sin(longitude), std::cos(longitude), 0.0);
  const Eigen::Vector3d outward(std::cos(longitude), std::sin(longitude), 0.0);
  const Eigen::Vector3d pole = Eigen::Vector3d::UnitZ();
  SiteNumbers site;
  site.axes << east, std::cos(latitude) * pole - std::sin(latitude) * outward,
      std::cos(latitude) * outward + std::sin(latitude) * pole;
  site.position = wgs84::position(place).coordinates();
  return site;
}

SiteNumbers north_east_down_site(const std::string& name, const Geodetic& place) {
  const SiteNumbers enu = east_north_up_site(name, place);
  SiteNumbers site = enu;
  site.axes << enu.axes.col(1), enu.axes.col(0), -enu.axes.col(2);
  return site;
}

}  // namespace vectrix::detail
