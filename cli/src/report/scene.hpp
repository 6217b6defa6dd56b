#pragma once

#include <string>

#include "report/report.hpp"

namespace vectrix::cli {

/// The scene at its first time, seen from the reference, as an SVG in parallel projection: the body with its
/// axes, the frames and axes fixed in it, the directions, the limb of the Earth, and where the trail goes
/// during the whole time. The trail is that of the first axis, or else of z of the body.
std::string scene_svg(const Report::Scene& scene);

/// Latitude over longitude, with the place of the first time, which the script moves.
std::string ground_track_svg(const std::vector<Eigen::Vector2d>& track);

}  // namespace vectrix::cli
