#pragma once

#include <string>

#include "command/description.hpp"

namespace vectrix::cli {

/// Scripts that complete commands, options, their values if there is a list of them, and names of files.
std::string bash_completion(const ProgramDescription& program);
std::string zsh_completion(const ProgramDescription& program);

}  // namespace vectrix::cli
