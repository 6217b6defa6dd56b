#pragma once

#include <filesystem>
#include <string>

namespace vectrix::cli {

/// Throws BadInput if the file exists, unless `force`, and if it cannot be written.
void write_new(const std::filesystem::path& file, const std::string& text, bool force);

/// The shortest text that reads back as the same number.
std::string exact_number(double number);

}  // namespace vectrix::cli
