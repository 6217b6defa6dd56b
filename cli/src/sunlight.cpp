#include "sunlight.hpp"

namespace vectrix::cli {

std::vector<double> visible_suns(const std::vector<Epoch>& times,
                                 const std::vector<SatelliteMotion>& motions) {
  using earth::Gcrf, earth::Itrf;
  const auto span = from_until(times.front(), times.back());
  const Ephemeris<sky::Sun> sun(span);
  // The ellipsoid is round about its axis: the observed turn of the Earth does not matter.
  const EarthMotion earth(EarthOrientation::unobserved(span, 0.0 * si::second), span);
  std::vector<double> parts;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto R_itrf_from_gcrf = inverse(earth.rotation(times[i]));
    parts.push_back(wgs84::visible_sun(R_itrf_from_gcrf * sun.line_of_sight(times[i], motions[i], geometric),
                                       R_itrf_from_gcrf * -motions[i].position));
  }
  return parts;
}

}  // namespace vectrix::cli
