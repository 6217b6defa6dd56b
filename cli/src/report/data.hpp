#pragma once

#include <optional>
#include <string>

#include "report/report.hpp"

namespace vectrix::cli {

/// The time of all plots and of the scene, and the unit in which it is written.
struct TimeAxis {
  double first = 0.0, last = 0.0;  // s
  std::string unit = "s";
  double seconds_per_unit = 1.0;

  [[nodiscard]] double in_unit(double seconds) const { return seconds / seconds_per_unit; }
};
/// Nothing if the report has neither a plot nor a scene.
std::optional<TimeAxis> time_axis(const Report& report);

/// How many samples of each plot are kept, so that all plots together have about the same size.
std::size_t most_samples(const Report::Plot& plot, std::size_t plots);
std::size_t most_samples(const Report::Scene& scene);

/// The direction to the centre of the Earth, and the angle from it to the limb of a sphere with the radius of
/// the equator; NaN inside that.
Eigen::Vector4d limb(const Eigen::Vector3d& position);

/// What the script of the page reads: times and curves in base64, thinned as kept_samples() does.
std::string data_of_page(const Report& report);

}  // namespace vectrix::cli
