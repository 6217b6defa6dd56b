#pragma once

#include <exception>
#include <string>

namespace vectrix::ode {

/// The reason why a run ended early. Thrown inside this library only; solve() turns it into a Failure.
struct Trouble {
  int flag;
  double time;
  std::string text;
  std::exception_ptr cause;  ///< the exception of the problem's function, if any
};

}  // namespace vectrix::ode
