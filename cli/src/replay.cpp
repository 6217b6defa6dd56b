#include "replay.hpp"

#include <algorithm>
#include <ostream>
#include <vector>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "hidden.hpp"
#include "new_file.hpp"
#include "plain_words.hpp"
#include "result_file/result_file.hpp"
#include "scenario/budget.hpp"
#include "scenario/flight.hpp"
#include "scenario/replay_report.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

std::string range(const AttitudeRecord& record) {
  return record.times.front().utc(3) + " to " + record.times.back().utc(3) + " UTC";
}

void write_measures(const Scenario& scenario, const std::vector<Measured>& measures, std::ostream& out) {
  std::size_t width = 0;
  for (const Measure& each : scenario.measures) width = std::max(width, each.name.size());
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const AngleFigures figures(counted_of(measures[i].angles, measures[i].counts));
    out << label(scenario.measures[i].name, width + 4) << decimals(figures.value(figures.place_of_least()))
        << " to " << decimals(figures.value(figures.place_of_largest())) << " deg, median "
        << decimals(figures.quantile(50.0)) << ", rms " << decimals(figures.rms()) << ": "
        << measures[i].what;
    if (const std::string words = words_of_hidden(measures[i].hidden, "instant"); !words.empty())
      out << "; " << words;
    if (const std::string words = words_of_left_out(scenario.measures[i].when, measures[i].counts, "instant");
        !words.empty())
      out << "; " << words;
    out << '\n';
  }
  if (!measures.empty()) out << '\n';
}

bool write_verdicts(const Scenario& scenario, const std::vector<Judged>& verdicts, std::ostream& out) {
  if (verdicts.empty()) {
    out << "Nothing is required.\n";
    return true;
  }
  std::size_t failed = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Report::Verdict& each = verdicts[i];
    if (!each.fulfilled) ++failed;
    out << label(each.fulfilled ? "fulfilled" : "not fulfilled", 17)
        << scenario.measures[scenario.requirements[i].measure].name << ": " << each.required << "; it is "
        << each.reached << ", margin " << each.margin << '\n';
  }
  out << (failed == 0 ? "Everything required is fulfilled.\n"
                      : "Not fulfilled: " + std::to_string(failed) + " of " +
                            counted(verdicts.size(), "requirement") + ".\n");
  return failed == 0;
}

void write_budgets(const Scenario& scenario, const std::vector<BudgetFigure>& budgets, std::ostream& out) {
  std::size_t width = 0;
  for (const BudgetFigure& each : budgets) width = std::max(width, each.what.size());
  for (std::size_t i = 0; i < budgets.size(); ++i) {
    const BudgetFigure& each = budgets[i];
    if (i == 0 || each.measure != budgets[i - 1].measure)
      out << (i == 0 ? "\n" : "") << "Budget of " << scenario.measures[each.measure].name << ", "
          << counted(each.parts.size(), "contribution") << ":\n";
    out << label(each.what, width + 4) << "budget " << decimals(each.budget) << " deg, data "
        << decimals(each.data) << " deg; " << each.remark << '\n';
  }
  if (!budgets.empty()) out << '\n';
}

std::string table(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures) {
  std::string text = "# " + scenario.title + "\n";
  for (std::size_t i = 0; i < measures.size(); ++i)
    text += "# " + scenario.measures[i].name + ": " + measures[i].what + "\n";
  text += "# Attitude of " + flight.attitude.body + " relative to " + flight.attitude.reference_of_file() +
          " from " + flight.attitude.file +
          ". Times in UTC, angles in degrees; hidden: 1 if the Earth hides the target.\ntime_utc";
  for (std::size_t i = 0; i < measures.size(); ++i) {
    text += "," + scenario.measures[i].name + "_deg";
    if (!measures[i].hidden.empty()) text += "," + scenario.measures[i].name + "_hidden";
  }
  text += "\n";
  for (std::size_t i = 0; i < flight.attitude.size(); ++i) {
    text += exact_text(flight.attitude.times[i], scale::utc);
    for (const Measured& measure : measures) {
      text += "," + detail::text(degrees * measure.angles[i]);
      if (!measure.hidden.empty()) text += measure.hidden[i] ? ",1" : ",0";
    }
    text += "\n";
  }
  return text;
}

void require_writable(const Scenario& scenario, const ReplayOptions& options) {
  if (const auto kind = ending_of(options.hdf5); !options.hdf5.empty() && kind != ".h5" && kind != ".hdf5")
    throw BadInput("--hdf5 " + options.hdf5.string() + ": the name ends neither in .h5 nor in .hdf5");
  for (const auto& file : {scenario.report, scenario.csv, options.hdf5}) {
    if (file.empty()) continue;
    refuse_input(file, scenario.inputs);
    require_new(file, options.force);
  }
}

template <class Content>
void write_file(const std::filesystem::path& file, const Content& content, bool force, std::ostream& out) {
  write_new(file, content, force);
  out << "Written: " << file.string() << '\n';
}

}  // namespace

bool replay(const ReplayOptions& options, Progress& progress, std::ostream& out) {
  const Scenario scenario =
      in_plain_words(options.file.string(), [&] { return read_scenario(options.file); });
  if (options.check) {
    const auto flown = read_flown_attitude(scenario);
    (void)instants(scenario, flown.record);
    out << scenario.file << ": " << counted(scenario.measures.size(), "measure") << " and "
        << counted(scenario.requirements.size(), "requirement") << " of " << flown.record.body
        << " relative to " << flown.record.reference << ", " << counted(flown.record.size(), "sample") << ", "
        << range(flown.record) << ". Nothing is wrong.\n";
    return true;
  }
  require_writable(scenario, options);
  const Flight flight = read_flight(scenario, progress);
  std::vector<Measured> measures;
  for (const Measure& each : scenario.measures)
    measures.push_back(in_plain_words(each.place.text(), [&] { return measured(each, scenario, flight); }));
  const auto judged = verdicts(scenario, flight, measures);
  const auto budgets = budget_figures(scenario, flight, measures);

  out << scenario.title << '\n'
      << counted(flight.attitude.size(), scenario.step ? "instant" : "sample") << " of "
      << flight.attitude.body << " relative to " << flight.attitude.reference_of_file() << ", "
      << range(flight.attitude) << '\n';
  if (const std::string missing = without_attitude(scenario, flight); !missing.empty())
    out << "Without attitude, not judged: " << missing << '\n';
  out << '\n';
  write_measures(scenario, measures, out);
  const bool fulfilled = write_verdicts(scenario, judged, out);
  write_budgets(scenario, budgets, out);
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (const std::string better = better_readings(flight, measures[i]); !better.empty())
      out << scenario.measures[i].name
          << " is on its target if the quaternions are read otherwise: " << better
          << ". vectrix check compares the readings.\n";
  if (!scenario.csv.empty()) write_file(scenario.csv, table(scenario, flight, measures), options.force, out);
  if (scenario.report.empty() && options.hdf5.empty()) return fulfilled;
  const Result result = replay_result(scenario, flight, measures, judged, budgets, options.version);
  if (!options.hdf5.empty())
    write_file(
        options.hdf5, [&](const std::filesystem::path& part) { write_result(result, part); }, options.force,
        out);
  if (!scenario.report.empty()) write_file(scenario.report, html(report_of(result)), options.force, out);
  return fulfilled;
}

}  // namespace vectrix::cli
