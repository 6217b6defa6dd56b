#include <cstdio>

#include "comparison.hpp"

namespace vectrix::validation {
namespace {

std::string scientific(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", value);
  return buffer;
}

}  // namespace

std::string markdown(const Rows& rows) {
  std::string text;
  std::string group;
  for (const Row& row : rows) {
    if (row.group != group) {
      group = row.group;
      text += "\n## " + group +
              "\n\n| scenario | compared | tolerance | reached | verdict | why this tolerance |\n" +
              "| --- | --- | --- | --- | --- | --- |\n";
    }
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    text += "| " + row.scenario + " | " + row.compared + " | " + scientific(row.tolerance) + unit + " | " +
            scientific(row.reached) + unit + " | " + (row.passed() ? "pass" : "**FAIL**") + " | " +
            row.reason + " |\n";
  }
  return text;
}

}  // namespace vectrix::validation
