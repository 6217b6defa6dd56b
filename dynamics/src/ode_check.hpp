#pragma once

#include <vectrix/dynamics/ode.hpp>

namespace vectrix::ode {

/// BadInput, with the field and the number that failed, unless the problem is well posed.
void check(const Problem& problem);

}  // namespace vectrix::ode
