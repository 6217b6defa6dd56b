#pragma once

#include <filesystem>
#include <iosfwd>

namespace vectrix::cli {

struct StoredReportOptions {
  std::filesystem::path file;      // of vectrix replay --hdf5
  std::filesystem::path output{};  // by default the same name with .html
  bool force = false;              // writes over an existing file
};

/// Writes the report of a stored result. Throws BadInput as read_result does, and if the result cannot be
/// shown.
void stored_report(const StoredReportOptions& options, std::ostream& out);

}  // namespace vectrix::cli
