#pragma once

#include "scenario/scenario.hpp"
#include "scenario/table.hpp"

namespace vectrix::cli {

/// Reads the stars, stations, measures and requirements of a scenario whose orbit and Earth are read. Throws
/// BadInput with file, line and column.
void read_measures(const ScenarioTable& table, Scenario& scenario);

}  // namespace vectrix::cli
