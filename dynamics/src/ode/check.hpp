#pragma once

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// Name of a component of the state, for messages.
std::string component(const Problem& problem, std::size_t i);

/// Throws BadInput, with the field and its number, if the problem is not well posed.
void check(const Problem& problem);

}  // namespace vectrix::ode
