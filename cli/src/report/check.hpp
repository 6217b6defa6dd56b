#pragma once

#include "report/report.hpp"

namespace vectrix::cli {

/// Throws BadInput for what a report cannot show: see html().
void require_consistent(const Report& report);

}  // namespace vectrix::cli
