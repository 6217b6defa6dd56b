#include "sundials_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sundials.hpp"

namespace vectrix::ode {
namespace {

constexpr int stop_reached = 1;  // CV_TSTOP_RETURN and ARK_TSTOP_RETURN

}  // namespace

void SundialsStepper::evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) {
  require(rate_(elapsed, y, ydot) ? 0 : flag::rhs_failed);
}

void SundialsStepper::restart(double t, std::span<const double> y, double stop, double longest) {
  failures_before_ = error_test_failures();
  origin_ = reached_ = t;
  stop_ = stop;
  clock_ = clock_error_ = 0.0;
  elapsed_ = {};
  require(reinitialize(y, longest));
}

double SundialsStepper::step() {
  const double before = clock_;
  double length = 0.0;
  int flag = set_stop((stop_ - origin_) - clock_error_);
  if (flag >= 0) flag = advance(clock_, length);
  if (flag >= 0 && !(clock_ > before)) {
    message_ = "the step became too short to change the time";
    flag = flag::no_progress;
  }
  require(flag);

  elapsed_.add(length);
  clock_error_ = (elapsed_.sum - clock_) + elapsed_.rest;
  const double last_before_stop = std::nextafter(stop_, -std::numeric_limits<double>::infinity());
  reached_ = flag == stop_reached ? stop_ : std::min(time(clock_), last_before_stop);
  return reached_;
}

void SundialsStepper::rate(std::span<double> ydot) {
  evaluate(reached_, state(), ydot);
}

int SundialsStepper::call_rate(double clock, N_Vector y, N_Vector ydot, void* stepper) {
  SundialsStepper& self = *static_cast<SundialsStepper*>(stepper);
  return self.rate_(self.time(clock), span_of(y), span_of(ydot)) ? 0 : -1;
}

void SundialsStepper::require(int flag) const {
  if (flag >= 0) return;
  if (rate_.cause())
    throw Trouble{flag::rhs_failed, rate_.trouble_time(), "the right-hand side threw", rate_.cause()};
  if (!rate_.trouble().empty())
    throw Trouble{flag::rhs_failed, rate_.trouble_time(), rate_.trouble(), nullptr};
  throw Trouble{flag, rate_.time(reached_), message_, nullptr};
}

}  // namespace vectrix::ode
