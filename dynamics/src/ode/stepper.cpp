#include "stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sundials.hpp"

namespace vectrix::ode {
namespace {

constexpr int stop_reached = 1;  // CV_TSTOP_RETURN and ARK_TSTOP_RETURN

}  // namespace

int Stepper::restart(double t, std::span<const double> y, double stop, double longest) {
  failures_before_ = error_test_failures();
  origin_ = t;
  stop_ = stop;
  clock_ = elapsed_ = elapsed_rest_ = clock_error_ = 0.0;
  return reinitialize(y, longest);
}

int Stepper::step(double& t) {
  const double before = clock_;
  double length = 0.0;
  int flag = set_stop((stop_ - origin_) - clock_error_);
  if (flag >= 0) flag = advance(clock_, length);
  if (flag < 0) return flag;
  if (!(clock_ > before)) {
    message_ = "the step became too short to change the time";
    return flag::no_progress;
  }

  // elapsed + rest += length. The rest takes the exact rounding error of the sum, whichever term is larger.
  const double sum = elapsed_ + length;
  const double part = sum - elapsed_;
  elapsed_rest_ += (elapsed_ - (sum - part)) + (length - part);
  elapsed_ = sum;
  clock_error_ = (elapsed_ - clock_) + elapsed_rest_;
  const double last_before_stop = std::nextafter(stop_, -std::numeric_limits<double>::infinity());
  t = flag == stop_reached ? stop_ : std::min(time(clock_), last_before_stop);
  return flag;
}

int Stepper::rate(double t, std::span<double> ydot) {
  return rate_(t, state(), ydot) ? 0 : flag::rhs_failed;
}

int Stepper::call_rate(double clock, N_Vector y, N_Vector ydot, void* stepper) {
  const Stepper& self = *static_cast<Stepper*>(stepper);
  return self.rate_(self.time(clock), span_of(y), span_of(ydot)) ? 0 : -1;
}

}  // namespace vectrix::ode
