#pragma once

#include "scenario/scenario.hpp"
#include "scenario/table.hpp"

namespace vectrix::cli {

/// Reads the contributions to the pointing error budgets of a scenario whose requirements are read: at their
/// percentages the figures of a budget are. Throws BadInput with file, line and column, also if a budget
/// would have no figure.
void read_contributions(const ScenarioTable& table, Scenario& scenario);

}  // namespace vectrix::cli
