#pragma once

#include <filesystem>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// Whether the file is HDF5, as replay writes its results. Throws BadInput if it cannot be read.
bool is_stored_result(const std::filesystem::path& file);

/// The samples of a stored result, with the frames and the gaps that it has. Throws BadInput as
/// read_result().
AttitudeRecord read_stored_attitude(const std::filesystem::path& file);

}  // namespace vectrix::cli
