#pragma once

#include <filesystem>
#include <string>

#include "attitude_record.hpp"
#include "selection.hpp"

namespace vectrix::cli {

/// What an attitude kernel of SPICE needs beside it. Empty: not given.
struct KernelWords {
  std::string clock{}, frames{}, leap_seconds{};  // files
  std::string frame{};                            // the name or the number of the body's frame
  std::string frame_word = "--ck-frame NAME";     // how to state it
  std::string frame_place{};                      // where it is stated, in a scenario: "file:3:7: "
};
/// For all times of UTC that are read from now on, if they are given. Throws BadInput as the two do.
void use_leap_seconds_of(const KernelWords& words);

/// Whether the file begins as a binary kernel or a transfer file does. Throws BadInput if it cannot be read.
bool is_kernel(const std::filesystem::path& file);

/// The records between the selected times. An attitude relative to another frame of the file, or to one that
/// is mounted, is multiplied with that of the other one, and so on: kernel_chain.hpp. Throws BadInput as
/// AttitudeKernel and KernelChain do, without a clock, and for several frames of which none is named. The
/// leap seconds are not used here: see above.
AttitudeRecord read_kernel(const std::filesystem::path& file, const KernelWords& words,
                           const Selection& selection);

}  // namespace vectrix::cli
