#pragma once

#include <string>
#include <vector>

#include "scenario/budget.hpp"
#include "scenario/flight.hpp"
#include "scenario/result.hpp"

namespace vectrix::cli {

/// What a replay found. It reads the inputs again, for their checksums.
Result replay_result(const Scenario& scenario, const Flight& flight, const std::vector<Measured>& measures,
                     const std::vector<Judged>& verdicts, const std::vector<BudgetFigure>& budgets,
                     const std::string& version);

}  // namespace vectrix::cli
