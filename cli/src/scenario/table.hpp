#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <vectrix/space.hpp>

#include "scenario/place.hpp"
#include "scenario/units.hpp"

namespace vectrix::cli {

class ScenarioTable;

/// The value of a key, as its kind says.
struct ScenarioValue {
  Place place;
  std::variant<std::string, std::size_t, std::vector<double>, std::vector<std::string>, Amount, Epoch,
               std::vector<ScenarioTable>>
      value;
  std::string path{};  // "attitude.quaternion.scalar"

  /// The value of the kind that the schema has for it.
  template <class T> [[nodiscard]] const T& as() const { return std::get<T>(value); }
  [[nodiscard]] const std::string& text() const { return as<std::string>(); }
};

/// What stands in a table of a scenario file: keys that the schema knows, with values of their kinds.
class ScenarioTable {
 public:
  Place place;
  std::string path{};  // empty for the whole file
  std::map<std::string, ScenarioValue, std::less<>> values{};
  std::vector<std::filesystem::path> files{};  // of the whole file: itself and those that it includes

  [[nodiscard]] const ScenarioValue* find(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const ScenarioValue& at(std::string_view key) const { return values.find(key)->second; }
  /// The table under a key, or nothing.
  [[nodiscard]] const ScenarioTable* table(std::string_view key) const {
    const auto* found = find(key);
    return found ? &found->as<std::vector<ScenarioTable>>().front() : nullptr;
  }
  /// The tables of an array; none if it is not there.
  [[nodiscard]] std::vector<ScenarioTable> tables(std::string_view key) const {
    const auto* found = find(key);
    return found ? found->as<std::vector<ScenarioTable>>() : std::vector<ScenarioTable>{};
  }
};

/// Reads a scenario file and those that it includes, by the schema. Files that are read are named as seen
/// from here. Throws BadInput with file, line and column for what is no TOML, an unknown key (with the
/// nearest one), a needed key that is missing, a value of another kind, a unit of another dimension, a file
/// that does not exist, a key that is given twice, and files that include each other.
ScenarioTable read_scenario_table(const std::filesystem::path& file);

}  // namespace vectrix::cli
