#include "sundials_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "sundials.hpp"

namespace vectrix::ode {
namespace {

constexpr int stop_reached = 1;  // CV_TSTOP_RETURN and ARK_TSTOP_RETURN

}  // namespace

SundialsStepper::SundialsStepper(const Problem& problem)
    : rates_{std::cref(problem.rhs), &problem},
      last_state_(problem.initial_state.size()),
      last_rate_(problem.initial_state.size()) {}

void SundialsStepper::enter_segment(double start, double end) {
  rates_.start = start;
  rates_.end = end;
  remembers_ = false;
}

void SundialsStepper::evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) {
  require(find_rate(elapsed, y, ydot) ? 0 : flag::rhs_failed);
}

bool SundialsStepper::find_rate(double elapsed, std::span<const double> y, std::span<double> ydot) noexcept {
  if (rates_.trouble) return false;
  if (remembers_ && elapsed == last_elapsed_ &&
      std::memcmp(y.data(), last_state_.data(), y.size_bytes()) == 0) {
    std::ranges::copy(last_rate_, ydot.begin());
    return true;
  }
  remembers_ = false;
  try {
    rates_(elapsed, y, ydot);
  } catch (const Trouble& trouble) {
    rates_.trouble = trouble;
  }
  if (rates_.trouble) return false;
  last_elapsed_ = elapsed;
  std::ranges::copy(y, last_state_.begin());
  std::ranges::copy(ydot, last_rate_.begin());
  remembers_ = true;
  return true;
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
  return self.find_rate(self.time(clock), span_of(y), span_of(ydot)) ? 0 : -1;
}

std::string SundialsStepper::worst_of(void* memory, N_Vector state, Getter errors, Getter weights) const {
  const VectorPtr error(N_VClone(state)), weight(N_VClone(state));
  if (!error || !weight || errors(memory, error.get()) < 0 || weights(memory, weight.get()) < 0) return {};
  const auto size = span_of(state).size();
  double largest = 0.0;
  std::size_t worst = size;
  for (std::size_t i = 0; i < size; ++i) {
    const double share = std::abs(span_of(error.get())[i]) * span_of(weight.get())[i];
    if (share > largest) largest = share, worst = i;
  }
  return worst < size ? detail::component_name(*rates_.problem, worst) : "";
}

void SundialsStepper::require(int flag) const {
  if (flag >= 0) return;
  rates_.require_none();
  throw Trouble{flag, rates_.time(reached_), message_, nullptr};
}

}  // namespace vectrix::ode
