#include "scenario/flight.hpp"

#include <algorithm>

#include "evidence.hpp"
#include "figures.hpp"
#include "hidden.hpp"
#include "plain_words.hpp"
#include "quantile.hpp"
#include "reference_frame.hpp"
#include "resampled.hpp"
#include "sample_faults.hpp"
#include "scenario/budget.hpp"
#include "sunlight.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Vector3d;

// In the axes of the body, or of the reference as they are.
void turn_rates(AttitudeRecord& record, const StatedRates& stated, const BodyFrames& frames) {
  (void)frames.body_from(stated.of, stated.of_place);
  if (record.rate_axes == RateAxes::reference) return;
  const Eigen::Quaterniond& body_from_axes = frames.body_from(stated.in, stated.in_place);
  for (Vector3d& w : record.rates) w = body_from_axes * w;
}

// The result of the function, which is refused at this place.
template <class Function> auto at_place_of(const Place& place, const Function& function) {
  try {
    return function();
  } catch (const BadInput& error) {
    refuse(place, error.what());
  }
}

// The result of the function. If a table cannot be used, a column that it does not have is named where the
// scenario names it.
template <class Function> auto with_columns_of(const Scenario& scenario, const Function& function) {
  try {
    return function();
  } catch (const CsvError&) {
    require_columns(scenario);
    throw;
  }
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

// Which instants count; empty if all do.
std::vector<bool> counting(const Requirement& required, const Flight& flight, const Measured& measure) {
  return at_place_of(required.place, [&] {
    return counting(required.when, measure.hidden, flight.visible_sun, measure.target);
  });
}

}  // namespace

std::vector<Epoch> instants(const Scenario& scenario, const AttitudeRecord& record) {
  if (!scenario.step) return record.times;
  const Epoch start = scenario.start.value_or(record.times.front()),
              end = scenario.end.value_or(record.times.back());
  const auto steps = every(*scenario.step * si::second, from_until(start, end));
  constexpr std::int64_t most = 10'000'000;
  if (steps.size() > most)
    refuse(scenario.time_place, "'time.step' makes " + std::to_string(steps.size()) + " instants; at most " +
                                    std::to_string(most) + " are looked at");
  std::vector<Epoch> all;
  for (const Epoch& t : steps) all.push_back(t);
  return all;
}

FlownAttitude read_flown_attitude(const Scenario& scenario) {
  AttitudeRecord record = with_columns_of(scenario, [&] {
    return in_plain_words(scenario.attitude.file.string(), [&] { return read_attitude(scenario.attitude); });
  });
  if (!scenario.body.empty()) record.body = scenario.body;
  if (scenario.gap) record.longest_step = scenario.gap;
  BodyFrames frames(record.body, scenario.frames);
  if (scenario.rates) turn_rates(record, *scenario.rates, frames);
  for (const Measure& measure : scenario.measures) (void)frames.in_body(measure.axis);
  for (const Contribution& each : scenario.contributions) (void)frames.body_from(each.in, each.in_place);
  return {std::move(record), std::move(frames)};
}

TimeSpan looked_at(const Scenario& scenario, const AttitudeRecord& samples) {
  const Epoch &first = samples.times.front(), &last = samples.times.back();
  const Epoch start = std::max(scenario.start.value_or(first), first),
              end = std::min(scenario.end.value_or(last), last);
  if (end < start)
    refuse(scenario.time_place, "the samples of " + samples.file + " are from " + first.utc() + " UTC to " +
                                    last.utc() + " UTC, none from 'time.start' to 'time.end'");
  return from_until(start, end);
}

void require_orientation(const Scenario& scenario, const Epoch& t) {
  if (!scenario.orientation) return;
  try {
    (void)scenario.orientation->at(t);
  } catch (const BadInput& error) {
    refuse(scenario.orientation_place, error.what());
  }
}

Flight read_flight(const Scenario& scenario, Progress& progress) {
  FlownAttitude flown = read_flown_attitude(scenario);
  const Epoch middle = middle_of(looked_at(scenario, flown.record));
  const auto asked = instants(scenario, flown.record);
  AttitudeRecord attitude = scenario.step ? resampled(flown.record, asked) : flown.record;
  AttitudeRecord samples = around(flown.record, attitude.times.front(), attitude.times.back());
  Flight flight{std::move(flown), std::move(attitude), std::move(samples), asked.size(), nullptr, {}, {}};
  const auto& times = flight.attitude.times;
  // The reference must be known at the samples too.
  const auto& all = inertial(flight.attitude.reference) ? times : flight.samples.times;
  for (const Epoch& t : {times.front(), times.back()}) require_orientation(scenario, t);
  if (scenario.orbit)
    flight.orbit = with_columns_of(
        scenario, [&] { return read_orbit(*scenario.orbit, from_until(all.front(), all.back()), middle); });
  for (AttitudeRecord* const each : {&flight.attitude, &flight.samples})
    turn_to_gcrf(*each, flight.orbit, scenario.orientation, reference_keys);
  progress.begin("orbit", times.size());
  flight.motions = motions_at(times, flight.orbit, [&] { progress.count(); });
  progress.end();
  if (flight.orbit) flight.visible_sun = visible_suns(times, flight.motions);
  return flight;
}

std::string without_attitude(const Scenario& scenario, const Flight& flight) {
  const AttitudeRecord& record = flight.attitude;
  const std::string where = ", in gaps or outside the samples";
  if (scenario.step) {
    const std::size_t missing = flight.instants - record.size();
    return missing == 0 ? "" : std::to_string(missing) + " of " + counted(flight.instants, "instant") + where;
  }
  auto steps = durations_of(record);
  const double longest = longest_step(record, median(steps));
  steps.push_back((record.times.front() - scenario.start.value_or(record.times.front())).value());
  steps.push_back((scenario.end.value_or(record.times.back()) - record.times.back()).value());
  double seconds = 0.0;
  for (const double step : steps) seconds += step > longest ? step : 0.0;
  return seconds == 0.0 ? "" : shown(seconds) + " s" + where;
}

Measured measured(const Measure& measure, const Scenario& scenario, const Flight& flight) {
  Measured made;
  made.target = name_of(measure.target);
  made.what = "angle between " + measure.axis.text + " and " + made.target;
  if (measure.correction)
    made.what += ", " + words_of(*measure.correction) + ", seen from " +
                 (flight.orbit ? "the satellite" : "the centre of the Earth");
  const auto lines = lines_to(measure.target, flight.attitude.times, flight.motions,
                              measure.correction.value_or(geometric), scenario.orientation);
  made.hidden = hidden_by_earth(measure.target, flight.attitude.times, flight.motions,
                                static_cast<bool>(flight.orbit), lines, scenario.orientation);
  made.directions = directions_of(lines, flight.attitude, made.target);
  made.in_body = seen_in_body(flight.attitude, made.directions);
  const Vector3d axis = flight.flown.frames.in_body(measure.axis);
  made.angles = absolute_errors(made.in_body, axis);
  made.counts = at_place_of(
      measure.place, [&] { return counting(measure.when, made.hidden, flight.visible_sun, made.target); });
  made.by_reading = off_directions(flight.attitude, axis, made.directions);
  return made;
}

std::string better_readings(const Flight& flight, const Measured& measure) {
  const auto fit = fitting(measure.by_reading, largest_off_target);
  std::string names;
  if (fit.empty() || fit.front() == 0) return names;
  const auto readings = readings_of(flight.attitude);
  for (const std::size_t i : fit)
    names += (names.empty() ? "" : ", ") + std::string(readings[i].name()) + " (median " +
             decimals(degrees * measure.by_reading[i]) + " deg)";
  return names;
}

std::vector<double> errors_of(const Requirement& required, const Scenario& scenario, const Flight& flight,
                              const Measured& measure) {
  if (required.by_budget && required.window)
    return errors_in_windows(required, scenario, flight, measure).from_means;
  const auto among = counting(required, flight, measure);
  if (required.window)
    return at_place_of(required.place, [&] {
      return relative_errors(flight.attitude, measure.in_body, *required.window, among).errors;
    });
  return counted_of(measure.angles, among);
}

WindowErrors errors_in_windows(const Requirement& required, const Scenario& scenario, const Flight& flight,
                               const Measured& measure) {
  const auto among = counting(required, flight, measure);
  const Vector3d axis = flight.flown.frames.in_body(scenario.measures[required.measure].axis);
  return at_place_of(required.place, [&] {
    return window_errors(flight.attitude, measure.in_body, axis, *required.window, among);
  });
}

std::vector<Judged> verdicts(const Scenario& scenario, const Flight& flight,
                             const std::vector<Measured>& measures) {
  std::vector<Judged> all;
  for (const Requirement& required : scenario.requirements) {
    const Measured& measure = measures[required.measure];
    const AngleFigures figures(errors_of(required, scenario, flight, measure));
    const double limit =
        required.by_budget ? limit_by_budget(required, scenario, flight.flown.frames) : required.degrees;
    const Judgement judged = figures.judge(limit, required.percent);
    all.push_back({{scenario.measures[required.measure].name + ": " + measure.what, required.text,
                    decimals(judged.found) + " deg (" + std::to_string(judged.within) + " of " +
                        std::to_string(figures.size()) + " are within)",
                    decimals(judged.margin) + " deg", judged.fulfilled},
                   judged,
                   limit,
                   figures.size()});
  }
  return all;
}

}  // namespace vectrix::cli
