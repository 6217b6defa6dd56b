#pragma once

#include <optional>
#include <vector>

#include "target.hpp"

namespace vectrix::cli {

/// Whether the Earth may hide the target from a satellite: the Sun, the Moon, a star or a station.
bool may_be_hidden(const MeasureTarget& target);

/// Whether the Earth hides it, at every time: the line to the centre of the Sun or the Moon, or to a star,
/// passes through the ellipsoid WGS-84, or the satellite is below the horizon of the station, the plane
/// across its vertical. Without air and mountains. Empty if the target cannot be hidden, or there is no
/// orbit.
std::vector<bool> hidden_by_earth(const MeasureTarget& target, const std::vector<Epoch>& times,
                                  const std::vector<SatelliteMotion>& motions, bool has_orbit,
                                  const std::vector<Eigen::Vector3d>& lines,
                                  const std::optional<EarthOrientation>& orientation);

/// How often: "the Earth hides it at 3 of 181 samples"; "" if never.
std::string words_of_hidden(const std::vector<bool>& hidden, const char* samples);

}  // namespace vectrix::cli
