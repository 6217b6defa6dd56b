#pragma once

#include <string>
#include <vector>

namespace vectrix::validation {

/// One line of the table: what is compared, the tolerance and why it is that, and the largest difference
/// found.
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

// Each adds its rows: one function for each source of truth.
Rows exact_rows(const std::string& data);
Rows nasa_rows(const std::string& data);
Rows basilisk_rows(const std::string& data);
Rows simbody_rows(const std::string& data);

/// The table as Markdown, a section for each group.
std::string markdown(const Rows& rows);

}  // namespace vectrix::validation
