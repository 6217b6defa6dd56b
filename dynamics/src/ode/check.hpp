#pragma once

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// Name of a component of the state, for messages.
std::string component(const Problem& problem, std::size_t i);

/// Says which component of a state has a tolerance that its rounding exceeds; empty if none has.
std::string tolerance_below_rounding(const Problem& problem, std::span<const double> state);

/// Throws BadInput, with the field and its number, if the problem is not well posed.
void check(const Problem& problem);

}  // namespace vectrix::ode
