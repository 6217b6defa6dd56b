#include "scenario/table.hpp"

#include <algorithm>
#include <system_error>

#include "scenario/one_file.hpp"
#include "scenario/schema.hpp"

namespace vectrix::cli {
namespace {

namespace fs = std::filesystem;

void require_version(const ScenarioTable& table) {
  const auto* const version = table.find("version");
  const std::string known = std::to_string(scenario_version);
  if (!version)
    refuse(table.place, "'version' is missing; this program reads version " + known + ": version = " + known);
  if (version->as<std::size_t>() != std::size_t{scenario_version})
    refuse(version->place, "version " + std::to_string(version->as<std::size_t>()) +
                               " is not known; this program reads version " + known);
}

// What stands in `from`, as if it stood in `into`.
void merge(ScenarioTable& into, const ScenarioTable& from, const Key& key) {
  for (const auto& [name, value] : from.values) {
    const auto found = into.values.find(name);
    if (found == into.values.end()) {
      into.values.emplace(name, value);
      continue;
    }
    const Key& known = *key.find(name);
    if (known.kind == Kind::table) {
      merge(std::get<std::vector<ScenarioTable>>(found->second.value).front(),
            value.as<std::vector<ScenarioTable>>().front(), known);
    } else if (known.kind == Kind::tables) {
      auto& all = std::get<std::vector<ScenarioTable>>(found->second.value);
      const auto& more = value.as<std::vector<ScenarioTable>>();
      all.insert(all.end(), more.begin(), more.end());
    } else {
      refuse(found->second.place,
             "'" + value.path + "' is given twice; the other place is " + value.place.text());
    }
  }
}

bool is_one_of(const fs::path& file, const std::vector<fs::path>& files) {
  return std::any_of(files.begin(), files.end(), [&](const fs::path& each) {
    std::error_code none;  // of a pipe
    return fs::equivalent(file, each, none);
  });
}

// With all files that it includes; `within` are the files that include it.
ScenarioTable read_all(const fs::path& file, std::vector<fs::path> within) {
  within.push_back(file);
  ScenarioTable table = read_one_file(file);
  require_version(table);
  table.files = {file};
  const auto included = table.values.extract("include");
  if (included.empty()) return table;
  for (const std::string& each : included.mapped().as<std::vector<std::string>>()) {
    if (is_one_of(each, within))
      refuse(included.mapped().place, "includes " + each + ", which includes this file or is it");
    ScenarioTable part = read_all(each, within);
    part.values.erase("version");
    merge(table, part, schema());
    table.files.insert(table.files.end(), part.files.begin(), part.files.end());
  }
  return table;
}

void require_keys(const ScenarioTable& table, const Key& key) {
  for (const Key& each : key.keys) {
    const auto* const found = table.find(each.name);
    if (!found && each.needed)
      refuse(table.place, "'" + (table.path.empty() ? "" : table.path + '.') + each.name +
                              "' is missing: " + each.help + " (" + form_of(each) + ")");
    if (!found || each.keys.empty()) continue;
    for (const ScenarioTable& part : found->as<std::vector<ScenarioTable>>()) require_keys(part, each);
  }
}

}  // namespace

ScenarioTable read_scenario_table(const fs::path& file) {
  ScenarioTable table = read_all(file, {});
  require_keys(table, schema());
  return table;
}

}  // namespace vectrix::cli
