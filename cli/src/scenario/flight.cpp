#include "scenario/flight.hpp"

#include <algorithm>

#include "evidence.hpp"
#include "figures.hpp"
#include "hidden.hpp"
#include "plain_words.hpp"
#include "quantile.hpp"
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

std::vector<Epoch> instants(const Scenario& scenario, const AttitudeRecord& record) {
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

// Which instants count; empty if all do.
std::vector<bool> counting(const Requirement& required, const Flight& flight, const Measured& measure) {
  std::vector<bool> all;
  if (required.when == When::always) return all;
  if (required.when == When::visible) {
    all = measure.hidden;
    all.flip();
    if (std::find(all.begin(), all.end(), true) == all.end())
      refuse(required.place, "at no instant is " + measure.target + " visible past the Earth");
    return all;
  }
  const bool in_sunlight = required.when == When::sunlight;
  for (const double part : flight.visible_sun) all.push_back(part == (in_sunlight ? 1.0 : 0.0));
  if (std::find(all.begin(), all.end(), true) == all.end())
    refuse(required.place, std::string("no instant is in ") + (in_sunlight ? "sunlight" : "shadow"));
  return all;
}

// The result of the function, which is refused at the place of the requirement.
template <class Function> auto of_windows(const Requirement& required, const Function& function) {
  try {
    return function();
  } catch (const BadInput& error) {
    refuse(required.place, error.what());
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

}  // namespace

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
  const auto asked = scenario.step ? instants(scenario, flown.record) : flown.record.times;
  AttitudeRecord attitude = scenario.step ? resampled(flown.record, asked) : flown.record;
  Flight flight{std::move(flown), std::move(attitude), asked.size(), nullptr, {}, {}};
  const auto& times = flight.attitude.times;
  for (const Epoch& t : {times.front(), times.back()}) require_orientation(scenario, t);
  if (scenario.orbit)
    flight.orbit = with_columns_of(scenario, [&] {
      return read_orbit(*scenario.orbit, from_until(times.front(), times.back()), middle);
    });
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
    return of_windows(required, [&] {
      return relative_errors(flight.attitude, measure.in_body, *required.window, among).errors;
    });
  std::vector<double> errors;
  for (std::size_t i = 0; i < measure.angles.size(); ++i)
    if (among.empty() || among[i]) errors.push_back(measure.angles[i]);
  return errors;
}

WindowErrors errors_in_windows(const Requirement& required, const Scenario& scenario, const Flight& flight,
                               const Measured& measure) {
  const auto among = counting(required, flight, measure);
  const Vector3d axis = flight.flown.frames.in_body(scenario.measures[required.measure].axis);
  return of_windows(required, [&] {
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
