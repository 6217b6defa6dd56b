#include "new_file.hpp"

#include <fstream>
#include <system_error>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

void refuse_input(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs) {
  for (const auto& input : inputs) {
    std::error_code none;  // of a file that does not exist
    if (std::filesystem::equivalent(file, input, none))
      throw BadInput(file.string() + ": is the same file as " + input.string() + ", which is read");
  }
}

void require_new(const std::filesystem::path& file, bool force) {
  if (!force && std::filesystem::exists(file))
    throw BadInput(file.string() + ": exists; --force overwrites it");
}

void write_new(const std::filesystem::path& file, const std::string& text, bool force) {
  require_new(file, force);
  std::ofstream out(file, std::ios::binary);
  if (!out) throw BadInput(file.string() + ": cannot be written");
  out << text;
  out.close();
  if (!out) throw BadInput(file.string() + ": was not written to its end");
}

}  // namespace vectrix::cli
