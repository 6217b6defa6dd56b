#pragma once

#include <string>

#include "command/description.hpp"

namespace vectrix::cli {

/// The page vectrix.1 of the manual, with a section for each command.
std::string program_manual(const ProgramDescription& program);
/// The page vectrix-scenario.5, of the scenario file.
std::string scenario_manual(const std::string& version);

/// The page of a command, for docs/reference, and the name of its file.
std::string page_name(const CommandDescription& command);
std::string command_page(const CommandDescription& command);

}  // namespace vectrix::cli
