#pragma once

#include <filesystem>

#include "scenario/table.hpp"

namespace vectrix::cli {

/// Reads one file by the schema, without those that it includes; needed keys may be missing.
ScenarioTable read_one_file(const std::filesystem::path& file);

}  // namespace vectrix::cli
