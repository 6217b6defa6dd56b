#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "attitude_record.hpp"
#include "evidence.hpp"

namespace vectrix::cli {

struct CheckOptions {
  std::filesystem::path file;
  std::optional<TableColumns> columns;  // of a table; a message says them itself
  std::size_t segment = 1;              // of a message
  std::filesystem::path elements, orbit;  // empty if not given
  std::optional<Eigen::Vector3d> axis;    // in the axes of the body, any length
  std::optional<Target> target;
};

/// Writes which readings of an attitude make its rates, its steadiness and its target agree. It chooses none.
/// True if a comparison confirms the file as stated, and none prefers another reading. Throws BadInput.
bool check(const CheckOptions& options, std::ostream& out);

}  // namespace vectrix::cli
