#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "scenario/replay_report.hpp"
#include "scenario_folder.hpp"

namespace vectrix::cli {

inline const std::filesystem::path examples = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples";

/// The text of an example that may stand in any folder, and writes nothing.
inline std::string example(const std::string& name) {
  std::string text = content(examples / "scenarios" / name);
  for (auto at = text.find("../data"); at != std::string::npos; at = text.find("../data"))
    text.replace(at, 7, (examples / "data").string());
  return text.substr(0, text.find("[output]"));
}

/// All that a replay finds.
struct Replayed {
  std::shared_ptr<const TemporaryFolder> folder;
  Scenario scenario;
  Flight flight;
  std::vector<Measured> measures;
  std::vector<Judged> judged;

  [[nodiscard]] bool fulfilled(std::size_t i) const { return judged.at(i).fulfilled; }
  [[nodiscard]] std::vector<BudgetFigure> budgets() const {
    return budget_figures(scenario, flight, measures);
  }
  [[nodiscard]] Result result() const {
    return replay_result(scenario, flight, measures, judged, budgets(), "0");
  }
  [[nodiscard]] Report report() const { return report_of(result()); }
};
inline Replayed replayed_file(const std::filesystem::path& file,
                              const std::shared_ptr<const TemporaryFolder>& folder = nullptr) {
  const Scenario scenario = read_scenario(file);
  Progress silent(nullptr);
  Replayed made{folder, scenario, read_flight(scenario, silent), {}, {}};
  for (const Measure& each : scenario.measures)
    made.measures.push_back(measured(each, scenario, made.flight));
  made.judged = verdicts(scenario, made.flight, made.measures);
  return made;
}
inline Replayed replayed(const std::string& text) {
  const auto folder = std::make_shared<const TemporaryFolder>();
  return replayed_file(folder->written("s.toml", text), folder);
}

}  // namespace vectrix::cli
