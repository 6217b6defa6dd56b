#include "rate.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <vectrix/frames/errors.hpp>

namespace vectrix::ode {

Rate::Rate(const Problem& problem)
    : problem_(problem),
      last_state_(problem.initial_state.size()),
      last_rate_(problem.initial_state.size()) {}

void Rate::enter_segment(double start, double end) {
  segment_start_ = start;
  segment_end_ = end;
  remembers_ = false;
}

// A stage of an integrator may pass the segment's end by a rounding error. The function never sees such a
// time.
double Rate::time(double elapsed) const {
  return std::clamp(segment_start_ + elapsed, segment_start_, segment_end_);
}

bool Rate::operator()(double elapsed, std::span<const double> y, std::span<double> ydot) noexcept {
  if (failed()) return false;
  if (remembers_ && elapsed == last_elapsed_ &&
      std::memcmp(y.data(), last_state_.data(), y.size_bytes()) == 0) {
    std::ranges::copy(last_rate_, ydot.begin());
    return true;
  }
  remembers_ = false;
  last_elapsed_ = elapsed;
  try {
    evaluate(elapsed, y, ydot);
  } catch (...) {
    cause_ = std::current_exception();
  }
  return !failed();
}

void Rate::evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) {
  ++evaluations_;
  const double t = time(elapsed);
  problem_.rhs(segment_start_, t, y, ydot);
  const auto wrong = std::ranges::find_if(ydot, [](double rate) { return !std::isfinite(rate); });
  if (wrong != ydot.end()) {
    trouble_ = detail::component_name(problem_, static_cast<std::size_t>(wrong - ydot.begin())) +
               " of the right-hand side is " + vectrix::detail::text(*wrong) +
               " at t = " + vectrix::detail::text(t);
    return;
  }
  std::ranges::copy(y, last_state_.begin());
  std::ranges::copy(ydot, last_rate_.begin());
  remembers_ = true;
}

}  // namespace vectrix::ode
