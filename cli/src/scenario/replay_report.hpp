#pragma once

#include <string>
#include <vector>

#include "scenario/budget.hpp"
#include "scenario/flight.hpp"

namespace vectrix::cli {

/// What a replay shows.
Report replay_report(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures,
                     const std::vector<Report::Verdict>& verdicts, const std::vector<BudgetFigure>& budgets,
                     const std::string& version);

}  // namespace vectrix::cli
