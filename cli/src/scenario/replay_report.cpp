#include "scenario/replay_report.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "hidden.hpp"
#include "pointing_error.hpp"
#include "quantile.hpp"
#include "reading.hpp"
#include "reference_frame.hpp"
#include "sample_faults.hpp"
#include "selection.hpp"
#include "sha256.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

std::string span_of(const AttitudeRecord& record) {
  return record.times.front().utc(3) + " to " + record.times.back().utc(3) + " UTC";
}

std::vector<Report::Fact> facts(const Scenario& scenario, const Flight& flight,
                                const std::vector<Measured>& measures) {
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
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (const std::string words = words_of_hidden(measures[i].hidden, "instant"); !words.empty())
      all.push_back({"target of " + scenario.measures[i].name, words});
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (const std::string words = words_of_left_out(scenario.measures[i].when, measures[i].counts, "instant");
        !words.empty())
      all.push_back({"figures of " + scenario.measures[i].name, words});
  return all;
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

// In the axes of the body; none if they are relative to a frame that moves.
std::vector<Vector3d> body_rates(const AttitudeRecord& record) {
  if (!record.stated_reference.empty()) return {};
  auto rates = record.rates_in_radians();
  if (record.rate_axes == RateAxes::reference)
    for (std::size_t i = 0; i < rates.size(); ++i)
      rates[i] = record.to_reference(i, record.stated).conjugate() * rates[i];
  return rates;
}

Result::Attitude attitude_of(const AttitudeRecord& record) {
  return {record.times, quaternions(record), body_rates(record),
          longest_step(record, median(durations_of(record)))};
}

Report::Table statistics(const Scenario& scenario, const Flight& flight,
                         const std::vector<Measured>& measures) {
  Report::Table table{
      "Angles, deg", {"measure", "least", "median", "95 %", "largest", "rms", "largest at, UTC"}, {}};
  for (std::size_t k = 0; k < measures.size(); ++k) {
    const AngleFigures figures(counted_of(measures[k].angles, measures[k].counts));
    const auto times = counted_of(flight.attitude.times, measures[k].counts);
    table.rows.push_back({scenario.measures[k].name, decimals(figures.value(figures.place_of_least())),
                          decimals(figures.quantile(50.0)), decimals(figures.quantile(95.0)),
                          decimals(figures.value(figures.place_of_largest())), decimals(figures.rms()),
                          times[figures.place_of_largest()].utc(3)});
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

// The contributions in the order of the scenario, then all together, and the data.
Report::Table budget_table(const Scenario& scenario, const BudgetFigure& figure) {
  Report::Table table{"Budget of " + scenario.measures[figure.measure].name + ": " + figure.what + ", deg",
                      {"contribution", "in", "kind", "alone", "share of the mean square"},
                      {}};
  for (const auto& [name, in, kind, alone, share] : figure.parts)
    table.rows.push_back({name, in, kind, decimals(alone), shown(100.0 * share) + " %"});
  table.rows.push_back({"all together", "", "", decimals(figure.budget), ""});
  table.rows.push_back({"the data", "", figure.remark, decimals(figure.data), ""});
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
  if (found.wrong_times.count > 0)
    add("times that seem wrong", found.wrong_times, shown(found.wrong_times.largest) + " s");
  add("norms off the median by more than 1e-6", found.norm_errors, shown(found.norm_errors.largest));
  return table;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadInput(file.string() + ": cannot be read again");
  return {std::istreambuf_iterator<char>(in), {}};
}

Report::Input input(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
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
  if (const std::string axes = axes_of_reference(record.reference); !axes.empty())
    report.choices.push_back(
        {"axes of " + record.reference, axes + ", of the orbit relative to GCRF", "CCSDS"});
  if (!record.rates.empty() && !inertial(record.reference))
    report.choices.push_back(
        {"rates of the file",
         "not shown: they are relative to " + record.reference + ", and the page to GCRF", "the program"});
  if (!record.chain.empty())
    report.choices.push_back({"multiplied from what the kernel has", record.chain, record.file});
  if (!record.hidden_segments.empty())
    report.choices.push_back({"hidden by later segments of the kernel", record.hidden_segments, record.file});
  if (!record.no_rates.empty()) report.choices.push_back({"rates of the file", record.no_rates, record.file});
}

Result::Orbit orbit_of(const Scenario& scenario, const Flight& flight) {
  const auto& times = flight.attitude.times;
  const auto span = from_until(times.front(), times.back());
  const EarthMotion earth(scenario.orientation.value_or(EarthOrientation::unobserved(span, 0.0 * si::second)),
                          span);
  Result::Orbit orbit{flight.motions, flight.visible_sun, {}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Geodetic place =
        wgs84::geodetic((inverse(earth.rotation(times[i])) * flight.motions[i].position).vector());
    orbit.ground_track.emplace_back(place.latitude.angle.in(si::degree), place.longitude.in(si::degree));
  }
  return orbit;
}

void add_measure(Result& result, const Measure& measure, const Measured& found, const BodyFrames& frames) {
  result.measures.push_back({measure.name, found.what, measure.axis.text, found.target,
                             frames.in_body(measure.axis), found.angles, found.directions, found.hidden});
  for (double& angle : result.measures.back().degrees) angle *= degrees;
}

void add_verdict(Result& result, const Requirement& required, const Judged& judged) {
  result.texts.verdicts.push_back(judged);
  const Judgement& found = judged.figures;
  result.verdicts.push_back({required.measure, judged.limit, required.percent, required.window.value_or(0.0),
                             required.when, found.found, found.margin, found.within, judged.count,
                             found.fulfilled});
}

}  // namespace

Result replay_result(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures,
                     const std::vector<Judged>& verdicts, const std::vector<BudgetFigure>& budgets,
                     const std::string& version) {
  const AttitudeRecord& attitude = flight.attitude;
  const BodyFrames& frames = flight.flown.frames;
  Report texts{.title = scenario.title,
               .start = attitude.times.front(),
               .facts = facts(scenario, flight, measures),
               .version = version};
  if (!measures.empty()) {
    texts.tables.push_back(statistics(scenario, flight, measures));
    texts.tables.push_back(by_reading(scenario, flight, measures));
    for (const BudgetFigure& each : budgets) texts.tables.push_back(budget_table(scenario, each));
  }
  texts.tables.push_back(faults(flight.flown.record));
  for (const auto& file : scenario.inputs) texts.inputs.push_back(input(file));
  add_choices(texts, scenario, flight);

  Result result{std::move(texts), attitude.body, attitude.reference, attitude_of(attitude),
                attitude_of(flight.samples)};
  if (flight.orbit) result.orbit = orbit_of(scenario, flight);
  result.frames.assign(frames.all().begin() + 1, frames.all().end());
  for (std::size_t k = 0; k < measures.size(); ++k)
    add_measure(result, scenario.measures[k], measures[k], frames);
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    add_verdict(result, scenario.requirements[k], verdicts[k]);
  for (const auto& file : scenario.texts) result.scenario.push_back({file.string(), bytes_of(file)});
  return result;
}

}  // namespace vectrix::cli
