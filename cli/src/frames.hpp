#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace vectrix::cli {

struct FramesOptions {
  std::filesystem::path file;
  std::string from{}, to{};  // both, or neither: then the frames are listed
  std::string at{};          // by default the first sample
};

/// Writes the frames of a scenario, or the chain from one to another at an instant: v_to = R v_from, each
/// factor of R and where it is stated, and the angular velocity. Throws BadInput.
void frames(const FramesOptions& options, std::ostream& out);

}  // namespace vectrix::cli
