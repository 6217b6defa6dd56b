#include <vectrix/dynamics/ode/stepper.hpp>

namespace vectrix::ode {

std::string Stepper::flag_name(int flag) const {
  switch (flag) {
    case flag::too_many_steps:
      return "TOO_MUCH_WORK";
    case flag::step_too_short:
      return "ERR_FAILURE";
    case flag::rhs_failed:
      return "RHSFUNC_FAIL";
    case flag::root_failed:
      return "RTFUNC_FAIL";
    default:
      return "unnamed";
  }
}

}  // namespace vectrix::ode
