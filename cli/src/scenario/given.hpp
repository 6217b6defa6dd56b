#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenario/table.hpp"

namespace vectrix::cli {

// What goes together in a table of a scenario; all throw BadInput with file, line and column.

/// The one of these keys that is given.
const ScenarioValue& one_of(const ScenarioTable& table, const std::vector<std::string_view>& keys);
/// Refuses these keys: "'orbit.unit' is of a table".
void refuse_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys,
                 const std::string& why);
/// Wants these keys: "'orbit.unit' is missing: a table needs it".
void want_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys, const std::string& of);

Quantity<si::angle> angle_of(const ScenarioTable& table, std::string_view key);
/// Of an amount, in a unit.
double positive(const ScenarioValue& value, std::string_view unit);

}  // namespace vectrix::cli
