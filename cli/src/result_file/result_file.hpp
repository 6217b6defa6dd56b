#pragma once

#include <filesystem>

#include "scenario/result.hpp"

namespace vectrix::cli {

/// Writes a result as HDF5, by result_entries(). The bytes depend on the result alone. Throws BadInput if the
/// file cannot be written.
void write_result(const Result& result, const std::filesystem::path& file);

/// The same result, to the last digit. Throws BadInput, with the names of the file and of the dataset, as
/// Hdf5Reader does; for a file of another form or that holds something else; for sizes that differ; times
/// that do not increase, quaternions and directions whose norm is not 1 to 1e-6, places that are not on the
/// Earth, numbers that name nothing, and times whose leap seconds are not those of this program.
Result read_result(const std::filesystem::path& file);

}  // namespace vectrix::cli
