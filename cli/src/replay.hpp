#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "progress.hpp"

namespace vectrix::cli {

struct ReplayOptions {
  std::filesystem::path file;
  bool check = false;  // the scenario and its attitude are read, and nothing else is done
  bool force = false;  // writes over existing files
  std::string version{};
  std::filesystem::path hdf5{};  // a file that is written with all results; empty if not wanted
};

/// Reads a scenario file, measures the flight, and writes what was found: a line for each measure and each
/// requirement to `out`, and the files that the scenario names and `hdf5`. True if all that is required is
/// fulfilled. Throws BadInput.
bool replay(const ReplayOptions& options, Progress& progress, std::ostream& out);

}  // namespace vectrix::cli
