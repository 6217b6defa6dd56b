#include "report/data.hpp"

#include <algorithm>
#include <cmath>

#include "report/text.hpp"
#include "report/thinning.hpp"

namespace vectrix::cli {
namespace {

// Bytes before base64, which takes 4 for 3.
constexpr std::size_t plot_bytes = 1'500'000, scene_bytes = 700'000;

std::string joined_objects(const std::vector<std::string>& objects) {
  std::string text = "[";
  for (const auto& object : objects) text += (text.size() == 1 ? "" : ",") + object;
  return text + "]";
}
template <class Things, class Function> std::string json_of(const Things& things, const Function& object) {
  std::vector<std::string> objects;
  for (const auto& thing : things) objects.push_back(object(thing));
  return joined_objects(objects);
}

// Columns of coordinates, one after the other sample.
template <class Vectors, class Coordinates>
std::string packed(const Vectors& vectors, const std::vector<std::size_t>& places,
                   const Coordinates& coordinates) {
  std::vector<float> numbers;
  for (const std::size_t i : places)
    for (const double x : coordinates(vectors[i])) numbers.push_back(static_cast<float>(x));
  return json_text(base64(numbers));
}
std::string packed(const std::vector<Eigen::Quaterniond>& all, const std::vector<std::size_t>& places) {
  return packed(all, places, [](const Eigen::Quaterniond& q) -> Eigen::Vector4d { return q.coeffs(); });
}

template <class Vector> std::string list_of(const Vector& v) {
  return json_list({v.data(), static_cast<std::size_t>(v.size())});
}

// The values are stored in single precision less an offset: where they are large and change little, about
// their middle.
std::string curve_object(const Report::Curve& curve, const std::vector<std::size_t>& places) {
  double smallest = HUGE_VAL, largest = -HUGE_VAL;
  for (const double x : curve.values) {
    smallest = std::fmin(smallest, x);
    largest = std::fmax(largest, x);
  }
  constexpr double large = 16.0;  // ranges
  const bool has_offset = std::fmax(-smallest, largest) > large * (largest - smallest);
  const double offset = has_offset ? 0.5 * (smallest + largest) : 0.0;
  std::vector<float> numbers;
  for (const std::size_t i : places) numbers.push_back(static_cast<float>(curve.values[i] - offset));
  return "{\"name\":" + json_text(curve.name) + ",\"offset\":" + detail::text(offset) +
         ",\"values\":" + json_text(base64(numbers)) + "}";
}

std::string plot_object(const Report::Plot& plot, std::size_t plots) {
  const auto places = kept_samples(plot.curves, most_samples(plot, plots));
  return "{\"title\":" + json_text(plot.title) + ",\"unit\":" + json_text(plot.unit) +
         ",\"seconds\":" + json_text(base64(at_places(plot.seconds, places))) + ",\"curves\":" +
         json_of(plot.curves, [&](const auto& curve) { return curve_object(curve, places); }) +
         ",\"limits\":" +
         json_of(plot.limits,
                 [](const auto& limit) {
                   return "{\"name\":" + json_text(limit.name) + ",\"value\":" + detail::text(limit.value) +
                          "}";
                 }) +
         "}";
}

std::string scene_object(const Report::Scene& scene) {
  const auto places = even_samples(gaps_of(scene), most_samples(scene));
  std::string text = "{\"body\":" + json_text(scene.body) + ",\"reference\":" + json_text(scene.reference) +
                     ",\"seconds\":" + json_text(base64(at_places(scene.seconds, places))) +
                     ",\"attitude\":" + packed(scene.reference_from_body, places);
  text += ",\"frames\":" + json_of(scene.frames, [](const auto& frame) {
            return "{\"name\":" + json_text(frame.name) +
                   ",\"quaternion\":" + list_of(frame.body_from_frame.coeffs()) + "}";
          });
  text += ",\"axes\":" + json_of(scene.axes, [](const auto& axis) {
            return "{\"name\":" + json_text(axis.name) + ",\"axis\":" + list_of(axis.axis) + "}";
          });
  text += ",\"directions\":" + json_of(scene.directions, [&](const auto& direction) {
            return "{\"name\":" + json_text(direction.name) +
                   ",\"vectors\":" + packed(direction.vectors, places, [](const auto& v) { return v; }) + "}";
          });
  text += ",\"views\":" + json_of(scene.views, [&](const auto& view) {
            return "{\"name\":" + json_text(view.name) +
                   ",\"quaternions\":" + packed(view.from_reference, places) + "}";
          });
  if (!scene.positions.empty()) text += ",\"limb\":" + packed(scene.positions, places, limb);
  if (!scene.ground_track.empty())
    text += ",\"track\":" + packed(scene.ground_track, places, [](const auto& v) { return v; });
  return text + "}";
}

// The start in UTC, if no leap second is in the time or at its end.
std::string utc_of_start(const Report& report, const TimeAxis& axis) {
  try {
    const Epoch after = report.start + (axis.last + 1.0) * si::second;
    if ((report.start + axis.first * si::second).tai_minus_utc() != after.tai_minus_utc()) return "null";
    return json_text(report.start.utc(3) + "Z");
  } catch (const BadInput&) {  // before UTC
    return "null";
  }
}

}  // namespace

std::optional<TimeAxis> time_axis(const Report& report) {
  std::vector<const std::vector<double>*> all;
  for (const auto& plot : report.plots) all.push_back(&plot.seconds);
  if (report.scene) all.push_back(&report.scene->seconds);
  if (all.empty()) return std::nullopt;
  TimeAxis axis{HUGE_VAL, -HUGE_VAL};
  for (const auto* seconds : all) {
    axis.first = std::min(axis.first, seconds->front());
    axis.last = std::max(axis.last, seconds->back());
  }
  constexpr double minute = 60.0, hour = 3600.0, day = 86400.0;
  const double span = axis.last - axis.first;
  if (span > 5.0 * minute) axis.unit = "min", axis.seconds_per_unit = minute;
  if (span > 5.0 * hour) axis.unit = "h", axis.seconds_per_unit = hour;
  if (span > 5.0 * day) axis.unit = "d", axis.seconds_per_unit = day;
  return axis;
}

std::size_t most_samples(const Report::Plot& plot, std::size_t plots) {
  return plot_bytes / plots / (sizeof(double) + sizeof(float) * plot.curves.size());
}
std::size_t most_samples(const Report::Scene& scene) {
  const std::size_t numbers = 4 + 3 * scene.directions.size() + 4 * scene.views.size() +
                              (scene.positions.empty() ? 0 : 4) + (scene.ground_track.empty() ? 0 : 2);
  return scene_bytes / (sizeof(double) + sizeof(float) * numbers);
}

Eigen::Vector4d limb(const Eigen::Vector3d& position) {
  const double r = position.norm();
  Eigen::Vector4d result;
  result << -position / r, std::asin(wgs84::semi_major_axis.value() / r);
  return result;
}

std::string data_of_page(const Report& report) {
  const auto axis = time_axis(report);
  if (!axis) return "null";
  return "{\"first\":" + detail::text(axis->first) + ",\"last\":" + detail::text(axis->last) +
         ",\"unit\":{\"name\":" + json_text(axis->unit) +
         ",\"seconds\":" + detail::text(axis->seconds_per_unit) + "},\"utc\":" + utc_of_start(report, *axis) +
         ",\"plots\":" +
         json_of(report.plots, [&](const auto& plot) { return plot_object(plot, report.plots.size()); }) +
         ",\"scene\":" + (report.scene ? scene_object(*report.scene) : "null") + "}";
}

}  // namespace vectrix::cli
