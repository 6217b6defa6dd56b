#include "scenario/given.hpp"

namespace vectrix::cli {

const ScenarioValue& one_of(const ScenarioTable& table, const std::vector<std::string_view>& keys) {
  const ScenarioValue* given = nullptr;
  for (const std::string_view key : keys) {
    const auto* const found = table.find(key);
    if (!found) continue;
    if (given)
      refuse(found->place, "'" + found->path + "' and '" + given->path + "' are both given; one is needed");
    given = found;
  }
  if (!given) refuse(table.place, "'" + table.path + "' needs one of: " + listed(keys));
  return *given;
}

void refuse_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys,
                 const std::string& why) {
  for (const std::string_view key : keys)
    if (const auto* const found = table.find(key)) refuse(found->place, "'" + found->path + "' " + why);
}
void want_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys, const std::string& of) {
  for (const std::string_view key : keys)
    if (!table.find(key))
      refuse(table.place, "'" + table.path + '.' + std::string(key) + "' is missing: " + of + " needs it");
}

Quantity<si::angle> angle_of(const ScenarioTable& table, std::string_view key) {
  return table.at(key).as<Amount>().in("rad") * si::radian;
}

double positive(const ScenarioValue& value, std::string_view unit) {
  const auto& amount = value.as<Amount>();
  if (!(amount.in(unit) > 0.0))
    refuse(value.place, "'" + value.path + "' is " + amount.text() + "; it must be above 0");
  return amount.in(unit);
}

}  // namespace vectrix::cli
