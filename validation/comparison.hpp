#pragma once

#include <string>
#include <vector>

namespace vectrix::validation {

/// One line of the table: the quantity, the tolerance and its reason, and the largest difference found.
struct Row {
  std::string group;
  std::string scenario;
  std::string compared;
  double tolerance;
  std::string unit;
  std::string reason;
  double reached;

  bool passed() const { return reached <= tolerance; }
};

using Rows = std::vector<Row>;

// Each function adds the rows of one reference.
Rows exact_rows(const std::string& data);
Rows nasa_rows(const std::string& data);
Rows basilisk_rows(const std::string& data);
Rows erfa_rows(const std::string& data);
Rows simbody_rows(const std::string& data);
Rows space_rows(const std::string& data);  // its figures are those of the tests of space/
Rows multibody_rows(const std::string& data);
Rows trees_in_motion_rows(const std::string& data);
Rows prescribed_rows(const std::string& data);
Rows closed_form_rows(const std::string& data);

/// The table in Markdown, one section per group.
std::string markdown(const Rows& rows);

}  // namespace vectrix::validation
