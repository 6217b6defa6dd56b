#pragma once

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// Throws BadInput, with the field and its number, if the problem is not well posed. Does not ask for a
/// right-hand side.
void check(const Problem& problem);

}  // namespace vectrix::ode
