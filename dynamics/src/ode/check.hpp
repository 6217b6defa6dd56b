#pragma once

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// What a component of the state is called in messages.
std::string component(const Problem& problem, std::size_t i);

/// BadInput, with the field and the number that failed, unless the problem is well posed.
void check(const Problem& problem);

}  // namespace vectrix::ode
