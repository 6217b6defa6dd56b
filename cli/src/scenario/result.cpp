#include "scenario/result.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "figures.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

bool is_gap(const Result::Attitude& attitude, std::size_t i) {
  return (attitude.times[i + 1] - attitude.times[i]).value() > attitude.longest_step;
}

// Samples as curves over time: in the middle of each gap they are interrupted.
class Curves {
 public:
  Curves(const Result::Attitude& attitude, const Epoch& start) : size_(attitude.times.size()) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double t = (attitude.times[i] - start).value();
      if (i > 0 && is_gap(attitude, i - 1)) add(0.5 * (seconds_.back() + t), std::nullopt);
      add(t, i);
    }
  }

  [[nodiscard]] Report::Plot plot(const std::string& title, const std::string& unit,
                                  const std::string& axes) const {
    return {title, unit, axes, seconds_, {}};
  }
  [[nodiscard]] const std::vector<double>& seconds() const { return seconds_; }
  /// Something of each sample, and `none` in each gap.
  template <class Value>
  [[nodiscard]] std::vector<Value> interrupted(const std::vector<Value>& values, const Value& none) const {
    std::vector<Value> all;
    for (const auto& sample : samples_) all.push_back(sample ? values[*sample] : none);
    return all;
  }
  /// Of the value at each sample.
  template <class Value>
  [[nodiscard]] Report::Curve curve(const std::string& name, const Value& value) const {
    Report::Curve curve{name, {}};
    for (const auto& sample : samples_) curve.values.push_back(sample ? value(*sample) : not_there);
    return curve;
  }
  /// Of a vector of each sample; the last one before a gap has none.
  template <class Vector> void add_components(Report::Plot& plot, const Vector& vector) const {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      plot.curves.push_back(
          curve(std::string(1, "xyz"[axis]), [&](std::size_t i) { return vector(i)[axis]; }));
  }
  [[nodiscard]] bool ends_before_a_gap(std::size_t sample) const {
    return sample + 1 == size_ || is_before_gap_[sample];
  }

 private:
  void add(double t, std::optional<std::size_t> sample) {
    if (sample) {
      is_before_gap_.push_back(false);
    } else {
      is_before_gap_.back() = true;
    }
    seconds_.push_back(t);
    samples_.push_back(sample);
  }

  std::size_t size_;
  std::vector<double> seconds_;
  std::vector<std::optional<std::size_t>> samples_;
  std::vector<bool> is_before_gap_;
};

Report::Plot angles(const Result& result, const Curves& curves) {
  Report::Plot plot = curves.plot("Angles between axes and their targets", "deg", "");
  for (const Result::Angles& measure : result.measures)
    plot.curves.push_back(curves.curve(measure.name, [&](std::size_t i) { return measure.degrees[i]; }));
  for (const Result::Verdict& verdict : result.verdicts)
    if (verdict.window == 0.0)
      plot.limits.push_back({verdict.required, result.measures[verdict.measure].name + " at most " +
                                                   detail::text(verdict.required) + " deg"});
  return plot;
}

Report::Plot components(const Result& result, const Curves& curves) {
  const auto& q = result.attitude.reference_from_body;
  Report::Plot plot = curves.plot("Quaternion that takes coordinates from " + result.body + " to " +
                                      result.reference + ", its sign without jumps",
                                  "", "");
  plot.curves = {curves.curve("scalar", [&](std::size_t i) { return q[i].w(); }),
                 curves.curve("x", [&](std::size_t i) { return q[i].x(); }),
                 curves.curve("y", [&](std::size_t i) { return q[i].y(); }),
                 curves.curve("z", [&](std::size_t i) { return q[i].z(); })};
  return plot;
}

// The mean rate from a sample to the next, rad/s in the body: by the shortest turn.
Vector3d rate_of_turn(const Result::Attitude& attitude, std::size_t i) {
  const auto& q = attitude.reference_from_body;
  const Eigen::AngleAxisd turn(q[i].conjugate() * q[i + 1]);
  return turn.axis() * (turn.angle() / (attitude.times[i + 1] - attitude.times[i]).value());
}

void add_rates(Report& report, const Result& result) {
  const Result::Attitude& samples = result.samples;
  const Curves curves(samples, report.start);
  const Vector3d none = Vector3d::Constant(not_there);
  std::vector<Vector3d> turns;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    turns.push_back(curves.ends_before_a_gap(i) ? none : rate_of_turn(samples, i));
  Report::Plot plot = curves.plot("Rate of " + result.body + " relative to " + result.reference +
                                      ", by its turn from each sample to the next",
                                  "deg/s", result.body);
  curves.add_components(plot, [&](std::size_t i) { return Vector3d(degrees * turns[i]); });
  report.plots.push_back(std::move(plot));
  const auto& rates = samples.rates;
  if (rates.empty()) return;
  Report::Plot differences = curves.plot(
      "Rates of the file, mean of each sample and the next, less the rate by the turn between them", "deg/s",
      result.body);
  curves.add_components(differences, [&](std::size_t i) {
    return curves.ends_before_a_gap(i) ? none
                                       : Vector3d(degrees * (0.5 * (rates[i] + rates[i + 1]) - turns[i]));
  });
  report.plots.push_back(std::move(differences));
}

void add_orbit(Report::Scene& scene, const Result::Orbit& orbit) {
  struct Lvlh : moving_frame {};
  const Eigen::Matrix3d R_gcrf_from_reference = gcrf_from(scene.reference);
  Report::View view{"LVLH", {}};
  for (const auto& [r, v] : orbit.motions) {
    view.from_reference.emplace_back(
        Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix().transpose() * R_gcrf_from_reference));
    scene.positions.emplace_back(R_gcrf_from_reference.transpose() * r.coordinates());
  }
  scene.ground_track = orbit.ground_track;
  scene.views.push_back(std::move(view));
}

void interrupt(Report::Scene& scene, const Curves& curves) {
  const Quaterniond no_attitude(not_there, not_there, not_there, not_there);
  const auto in_gaps = [&](auto& values, const auto& none) {
    if (!values.empty()) values = curves.interrupted(values, none);
  };
  in_gaps(scene.reference_from_body, no_attitude);
  for (auto& direction : scene.directions)
    in_gaps(direction.vectors, Vector3d(Vector3d::Constant(not_there)));
  for (auto& view : scene.views) in_gaps(view.from_reference, no_attitude);
  in_gaps(scene.positions, Vector3d(Vector3d::Constant(not_there)));
  in_gaps(scene.ground_track, Eigen::Vector2d(Eigen::Vector2d::Constant(not_there)));
}

Report::Scene scene(const Result& result, const Curves& curves) {
  Report::Scene scene{result.body, result.reference, curves.seconds(), result.attitude.reference_from_body};
  scene.frames = result.frames;
  for (const Result::Angles& measure : result.measures) {
    const auto is_new = [](const auto& all, const std::string& name) {
      return std::none_of(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    };
    if (is_new(scene.axes, measure.axis)) scene.axes.push_back({measure.axis, measure.axis_in_body});
    if (is_new(scene.directions, measure.target))
      scene.directions.push_back({measure.target, measure.directions});
  }
  if (result.orbit) add_orbit(scene, *result.orbit);
  interrupt(scene, curves);
  return scene;
}

}  // namespace

std::vector<std::size_t> gaps_of(const Result::Attitude& attitude) {
  std::vector<std::size_t> gaps;
  for (std::size_t i = 0; i + 1 < attitude.times.size(); ++i)
    if (is_gap(attitude, i)) gaps.push_back(i);
  return gaps;
}

Report report_of(const Result& result) {
  Report report = result.texts;
  const Curves curves(result.attitude, report.start);
  if (!result.measures.empty()) report.plots.push_back(angles(result, curves));
  report.plots.push_back(components(result, curves));
  add_rates(report, result);
  report.scene = scene(result, curves);
  return report;
}

}  // namespace vectrix::cli
