#pragma once

#include <string>
#include <vectrix/dynamics.hpp>

#include "difference.hpp"

namespace vectrix::validation {

/// Duration of NASA's orbital attitude runs.
inline constexpr double nasa_duration_s = 28800.0;

/// The scenario of NASA's run "2", "8A", "8B", "9A" or "10A", from the published initial conditions.
Scenario<Inertial, Body> nasa_scenario(const std::string& run);

}  // namespace vectrix::validation
