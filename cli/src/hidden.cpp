#include "hidden.hpp"

#include <algorithm>

#include "figures.hpp"

namespace vectrix::cli {

using earth::Gcrf, earth::Itrf;

bool may_be_hidden(const MeasureTarget& target) {
  const auto* const plain = std::get_if<Target>(&target);
  return !plain || *plain == Target::sun || *plain == Target::moon;
}

std::vector<bool> hidden_by_earth(const MeasureTarget& target, const std::vector<Epoch>& times,
                                  const std::vector<SatelliteMotion>& motions, bool has_orbit,
                                  const std::vector<Eigen::Vector3d>& lines,
                                  const std::optional<EarthOrientation>& orientation) {
  std::vector<bool> hidden;
  if (!has_orbit || !may_be_hidden(target)) return hidden;
  const auto span = from_until(times.front(), times.back());
  // The ellipsoid is round about its axis: without a station the observed turn of the Earth does not matter.
  const EarthMotion earth(orientation.value_or(EarthOrientation::unobserved(span, 0.0 * si::second)), span);
  const auto* const station = std::get_if<StationTarget>(&target);
  const Eigen::Vector3d up =
      station ? wgs84::up(wgs84::position(station->at)).coordinates() : Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto R_itrf_from_gcrf = inverse(earth.rotation(times[i]));
    const auto line = R_itrf_from_gcrf * vector<si::dimensionless>(in<Gcrf>, lines[i]);
    hidden.push_back(station ? line.coordinates().dot(up) > 0.0
                             : wgs84::angle_from_limb(line, R_itrf_from_gcrf * -motions[i].position).value() <
                                   0.0);
  }
  return hidden;
}

std::string words_of_hidden(const std::vector<bool>& hidden, const char* samples) {
  const auto count = std::count(hidden.begin(), hidden.end(), true);
  if (count == 0) return "";
  return "the Earth hides it at " + std::to_string(count) + " of " + counted(hidden.size(), samples);
}

}  // namespace vectrix::cli
