#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vectrix::cli {

/// Throws BadInput if what is to be written is the same file as an input, whatever their names are.
void refuse_input(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs);

/// Throws BadInput if the file exists, unless `force`.
void require_new(const std::filesystem::path& file, bool force);
/// Throws BadInput if the file exists, unless `force`, and if it cannot be written. The file is there as a
/// whole or, if that fails, as it was before.
void write_new(const std::filesystem::path& file, const std::string& text, bool force);
/// The same for what a function writes to the name that it is given, or else throws.
void write_new(const std::filesystem::path& file,
               const std::function<void(const std::filesystem::path&)>& write, bool force);

}  // namespace vectrix::cli
