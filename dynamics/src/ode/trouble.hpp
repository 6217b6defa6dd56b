#pragma once

#include <exception>
#include <string>

namespace vectrix::ode {

/// What ended a run early, thrown inside this library only; solve() makes a Failure of it.
struct Trouble {
  int flag;
  double time;
  std::string text;
  std::exception_ptr cause;  ///< what the problem's function threw, if it did
};

}  // namespace vectrix::ode
