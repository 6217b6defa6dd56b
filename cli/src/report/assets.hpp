#pragma once

#include <string_view>

namespace vectrix::cli {

/// What cli/report holds, as it is built into the program: see the CMakeLists.txt.
extern const std::string_view report_script, report_style, report_licences;

}  // namespace vectrix::cli
