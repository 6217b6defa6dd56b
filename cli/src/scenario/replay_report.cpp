#include "scenario/replay_report.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <limits>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "pointing_error.hpp"
#include "quantile.hpp"
#include "reading.hpp"
#include "sample_faults.hpp"
#include "selection.hpp"
#include "sha256.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

// Samples as curves over time: in the middle of each gap they are interrupted.
class Curves {
 public:
  Curves(const AttitudeRecord& record, const Epoch& start) : record_(record) {
    const double longest = longest_step(record, median(durations_of(record)));
    for (std::size_t i = 0; i < record.size(); ++i) {
      const double t = (record.times[i] - start).value();
      if (i > 0 && (record.times[i] - record.times[i - 1]).value() > longest)
        add(0.5 * (seconds_.back() + t), std::nullopt);
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
    return sample + 1 == record_.size() || is_before_gap_[sample];
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

  const AttitudeRecord& record_;
  std::vector<double> seconds_;
  std::vector<std::optional<std::size_t>> samples_;
  std::vector<bool> is_before_gap_;
};

std::string span_of(const AttitudeRecord& record) {
  return record.times.front().utc(3) + " to " + record.times.back().utc(3) + " UTC";
}

std::vector<Report::Fact> facts(const Scenario& scenario, const Flight& flight) {
  const AttitudeRecord& record = flight.flown.record;
  std::vector<Report::Fact> all{
      {"attitude", counted(record.size(), "sample") + " of " + record.body + " relative to " +
                       record.reference + " from " + record.file},
      {"looked at", counted(flight.attitude.size(), scenario.step ? "instant" : "sample") + ", " +
                        span_of(flight.attitude)}};
  if (const std::string missing = without_attitude(scenario, flight); !missing.empty())
    all.push_back({"without attitude, not judged", missing});
  if (scenario.orbit) all.push_back({"orbit", files_of(*scenario.orbit).front().string()});
  for (std::size_t i = 0; i < scenario.measures.size(); ++i)
    all.push_back({"measure", scenario.measures[i].name});
  return all;
}

Report::Plot angles(const Scenario& scenario, const std::vector<Measured>& measures, const Curves& curves) {
  Report::Plot plot = curves.plot("Angles between axes and their targets", "deg", "");
  for (std::size_t k = 0; k < measures.size(); ++k)
    plot.curves.push_back(curves.curve(scenario.measures[k].name,
                                       [&](std::size_t i) { return degrees * measures[k].angles[i]; }));
  for (const Requirement& required : scenario.requirements)
    if (!required.window)
      plot.limits.push_back({required.degrees, scenario.measures[required.measure].name + " at most " +
                                                   detail::text(required.degrees) + " deg"});
  return plot;
}

std::vector<Quaterniond> quaternions(const AttitudeRecord& record) {
  std::vector<Quaterniond> all;
  for (std::size_t i = 0; i < record.size(); ++i) {
    Quaterniond q = record.to_reference(i, record.stated);
    if (!all.empty() && q.dot(all.back()) < 0.0) q.coeffs() *= -1.0;
    all.push_back(q);
  }
  return all;
}

Report::Plot components(const AttitudeRecord& record, const std::vector<Quaterniond>& q,
                        const Curves& curves) {
  Report::Plot plot = curves.plot("Quaternion that takes coordinates from " + record.body + " to " +
                                      record.reference + ", its sign without jumps",
                                  "", "");
  plot.curves = {curves.curve("scalar", [&](std::size_t i) { return q[i].w(); }),
                 curves.curve("x", [&](std::size_t i) { return q[i].x(); }),
                 curves.curve("y", [&](std::size_t i) { return q[i].y(); }),
                 curves.curve("z", [&](std::size_t i) { return q[i].z(); })};
  return plot;
}

// The mean rate from a sample to the next, rad/s in the body: by the shortest turn.
Vector3d rate_of_turn(const AttitudeRecord& record, const std::vector<Quaterniond>& q, std::size_t i) {
  const Eigen::AngleAxisd turn(q[i].conjugate() * q[i + 1]);
  return turn.axis() * (turn.angle() / (record.times[i + 1] - record.times[i]).value());
}

void add_rates(Report& report, const AttitudeRecord& record) {
  const Curves curves(record, report.start);
  const auto q = quaternions(record);
  const Vector3d none = Vector3d::Constant(not_there);
  std::vector<Vector3d> turns;
  for (std::size_t i = 0; i < record.size(); ++i)
    turns.push_back(curves.ends_before_a_gap(i) ? none : rate_of_turn(record, q, i));
  Report::Plot plot = curves.plot("Rate of " + record.body + " relative to " + record.reference +
                                      ", by its turn from each sample to the next",
                                  "deg/s", record.body);
  curves.add_components(plot, [&](std::size_t i) { return Vector3d(degrees * turns[i]); });
  report.plots.push_back(std::move(plot));
  if (record.rates.empty()) return;
  auto rates = record.rates_in_radians();
  if (record.rate_axes == RateAxes::reference)
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = q[i].conjugate() * rates[i];
  Report::Plot differences = curves.plot(
      "Rates of the file, mean of each sample and the next, less the rate by the turn between them", "deg/s",
      record.body);
  curves.add_components(differences, [&](std::size_t i) {
    return curves.ends_before_a_gap(i) ? none
                                       : Vector3d(degrees * (0.5 * (rates[i] + rates[i + 1]) - turns[i]));
  });
  report.plots.push_back(std::move(differences));
}

// The samples of the file from the one before the first instant to the one after the last.
AttitudeRecord around(AttitudeRecord record, const Epoch& first, const Epoch& last) {
  const auto& times = record.times;
  const auto begin = std::upper_bound(times.begin() + 1, times.end(), first) - 1;
  const auto end = std::lower_bound(times.begin(), times.end() - 1, last) + 1;
  const Places places{begin - times.begin(), end - times.begin()};
  keep(record.times, places);
  keep(record.numbers, places);
  keep(record.rates, places);
  return record;
}

Report::Table statistics(const Scenario& scenario, const Flight& flight,
                         const std::vector<Measured>& measures) {
  Report::Table table{
      "Angles, deg", {"measure", "least", "median", "95 %", "largest", "rms", "largest at, UTC"}, {}};
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const AngleFigures figures(measures[k].angles);
    table.rows.push_back({scenario.measures[k].name, decimals(figures.value(figures.place_of_least())),
                          decimals(figures.quantile(50.0)), decimals(figures.quantile(95.0)),
                          decimals(figures.value(figures.place_of_largest())), decimals(figures.rms()),
                          flight.attitude.times[figures.place_of_largest()].utc(3)});
  }
  return table;
}

Report::Table by_reading(const Scenario& scenario, const Flight& flight,
                         const std::vector<Measured>& measures) {
  Report::Table table{"Median angle, deg, if the quaternions were read otherwise", {"measure"}, {}};
  for (const Reading& reading : readings_of(flight.attitude)) table.headings.emplace_back(reading.name());
  for (std::size_t k = 0; k < measures.size(); ++k) {
    table.rows.push_back({scenario.measures[k].name});
    for (const double median : measures[k].by_reading)
      table.rows.back().push_back(decimals(degrees * median));
  }
  return table;
}

Report::Table faults(const AttitudeRecord& record) {
  const SampleFaults found = faults_of(record);
  Report::Table table{"Samples of the file", {"what", "how many", "most", "at, UTC"}, {}};
  const auto add = [&](const std::string& what, const SampleFaults::Extreme& extreme,
                       const std::string& most) {
    table.rows.push_back({what, std::to_string(extreme.count), extreme.count == 0 ? "" : most,
                          extreme.count == 0 ? std::string{} : record.times[extreme.sample].utc(3)});
  };
  add("gaps", found.gaps, shown(found.gaps.largest) + " s");
  add("changes from q to -q", found.sign_flips, "");
  add("steps near half a turn", found.half_turns, shown(degrees * found.half_turns.largest) + " deg");
  add("jumps, ten times faster than usual", found.jumps, shown(degrees * found.jumps.largest) + " deg");
  add("norms off the median by more than 1e-6", found.norm_errors, shown(found.norm_errors.largest));
  return table;
}

void add_orbit(Report::Scene& scene, const Scenario& scenario, const Flight& flight) {
  struct Lvlh : moving_frame {};
  const auto& times = flight.attitude.times;
  const auto span = from_until(times.front(), times.back());
  const EarthMotion earth(scenario.orientation.value_or(EarthOrientation::unobserved(span, 0.0 * si::second)),
                          span);
  const Eigen::Matrix3d R_gcrf_from_reference = gcrf_from(flight.attitude.reference);
  Report::View view{"LVLH", {}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto& [r, v] = flight.motions[i];
    view.from_reference.emplace_back(
        Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix().transpose() * R_gcrf_from_reference));
    scene.positions.emplace_back(R_gcrf_from_reference.transpose() * r.coordinates());
    const Geodetic place = wgs84::geodetic((inverse(earth.rotation(times[i])) * r).vector());
    scene.ground_track.emplace_back(place.latitude.angle.in(si::degree), place.longitude.in(si::degree));
  }
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

Report::Scene scene(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures,
                    const Curves& curves, const std::vector<Quaterniond>& q) {
  Report::Scene scene{flight.attitude.body, flight.attitude.reference, curves.seconds(), q};
  const auto& frames = flight.flown.frames.all();
  scene.frames.assign(frames.begin() + 1, frames.end());
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const FixedAxis& axis = scenario.measures[k].axis;
    const auto is_new = [](const auto& all, const std::string& name) {
      return std::none_of(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    };
    if (is_new(scene.axes, axis.text)) scene.axes.push_back({axis.text, flight.flown.frames.in_body(axis)});
    if (is_new(scene.directions, measures[k].target))
      scene.directions.push_back({measures[k].target, measures[k].directions});
  }
  if (flight.orbit) add_orbit(scene, scenario, flight);
  interrupt(scene, curves);
  return scene;
}

Report::Input input(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadInput(file.string() + ": cannot be read again");
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return {file.string(), bytes.size(), sha256(bytes)};
}

void add_choices(Report& report, const Scenario& scenario, const Flight& flight) {
  const AttitudeRecord& record = flight.flown.record;
  report.choices = scenario.choices;
  if (!scenario.attitude.columns && record.has_quaternions)
    report.choices.push_back(
        {"quaternions of the attitude",
         "R(q) takes coordinates to " +
             (record.stated.maps == Convention::Maps::to_body ? record.body : record.reference) +
             ", the scalar is " + (record.stated.scalar == Convention::Scalar::first ? "first" : "last"),
         record.file});
  if (!scenario.gap)
    report.choices.push_back({"gaps", "steps longer than three times the usual one", "the program"});
  if (scenario.orbit && !scenario.orbit->elements.empty())
    report.choices.push_back(
        {"element set", "the one nearest to the middle of the time that is looked at", "the program"});
  if (scenario.orbit && !scenario.orientation)
    report.choices.push_back(
        {"ground track", "with UT1 equal to UTC and no polar motion: up to 0.004 deg off", "the program"});
  if (!record.no_rates.empty()) report.choices.push_back({"rates of the file", record.no_rates, record.file});
}

}  // namespace

Report replay_report(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures,
                     const std::vector<Report::Verdict>& verdicts, const std::string& version) {
  const AttitudeRecord& attitude = flight.attitude;
  Report report{scenario.title, attitude.times.front(), facts(scenario, flight), verdicts, {}, {}, {}, {}, {},
                version};
  const Curves curves(attitude, report.start);
  const auto q = quaternions(attitude);
  if (!measures.empty()) report.plots.push_back(angles(scenario, measures, curves));
  report.plots.push_back(components(attitude, q, curves));
  add_rates(report, around(flight.flown.record, attitude.times.front(), attitude.times.back()));
  if (!measures.empty()) {
    report.tables.push_back(statistics(scenario, flight, measures));
    report.tables.push_back(by_reading(scenario, flight, measures));
  }
  report.tables.push_back(faults(flight.flown.record));
  report.scene = scene(scenario, flight, measures, curves, q);
  for (const auto& file : scenario.inputs) report.inputs.push_back(input(file));
  add_choices(report, scenario, flight);
  return report;
}

}  // namespace vectrix::cli
