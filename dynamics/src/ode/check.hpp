#pragma once

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// Says which component of a state has a tolerance that its rounding exceeds; empty if none has.
std::string tolerance_below_rounding(const Problem& problem, std::span<const double> state);

/// Throws BadInput, with the field and its number, if the problem is not well posed. Does not ask for a
/// right-hand side.
void check(const Problem& problem);

}  // namespace vectrix::ode
