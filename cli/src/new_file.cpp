#include "new_file.hpp"

#include <fstream>
#include <system_error>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {
namespace fs = std::filesystem;

void refuse_input(const fs::path& file, const std::vector<fs::path>& inputs) {
  for (const auto& input : inputs) {
    std::error_code none;  // of a file that does not exist
    if (fs::equivalent(file, input, none))
      throw BadInput(file.string() + ": is the same file as " + input.string() + ", which is read");
  }
}

void require_new(const fs::path& file, bool force) {
  if (!force && fs::exists(file)) throw BadInput(file.string() + ": exists; --force overwrites it");
}

void write_new(const fs::path& file, const std::function<void(const fs::path&)>& write, bool force) {
  require_new(file, force);
  std::error_code none;  // of what does not exist
  const fs::path target = fs::is_symlink(file, none) ? fs::weakly_canonical(file, none) : file;
  const bool is_device = fs::exists(target, none) && !fs::is_regular_file(target, none);
  const fs::path part = is_device ? target : fs::path(target.string() + ".part");
  try {
    write(part);
    if (!is_device) fs::rename(part, target);
  } catch (const std::exception& error) {
    if (!is_device) fs::remove(part, none);
    throw BadInput(file.string() + ": " + error.what());
  }
}

void write_new(const fs::path& file, const std::string& text, bool force) {
  write_new(
      file,
      [&](const fs::path& part) {
        std::ofstream out(part, std::ios::binary);
        if (!out) throw BadInput("cannot be written");
        out << text;
        out.close();
        if (!out) throw BadInput("was not written to its end");
      },
      force);
}

}  // namespace vectrix::cli
