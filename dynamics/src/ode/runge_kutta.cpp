#include <vectrix/dynamics/ode/runge_kutta.hpp>

#include <cmath>
#include <string>

#include <vectrix/frames/errors.hpp>

namespace vectrix::ode::detail {
namespace {

using vectrix::detail::text;

[[noreturn]] void refuse(const std::string& message) {
  throw BadInput("ode::RungeKutta" + message);
}

}  // namespace

void require_tolerances(double relative, std::span<const double> absolute) {
  if (!(relative >= 0.0 && std::isfinite(relative)))
    refuse(": the relative tolerance must be finite and at least 0, got " + text(relative));
  for (std::size_t c = 0; c < absolute.size(); ++c)
    if (!(absolute[c] > 0.0 && std::isfinite(absolute[c])))
      refuse(": the absolute tolerance of component " + text(c) + " must be finite and greater than 0, got " +
             text(absolute[c]));
}

void require_start(double t, std::span<const double> y, double first_step) {
  if (!std::isfinite(t)) refuse("::start: the time must be finite, got " + text(t));
  for (std::size_t c = 0; c < y.size(); ++c)
    if (!std::isfinite(y[c]))
      refuse("::start: component " + text(c) + " of the state must be finite, got " + text(y[c]));
  if (!(first_step >= 0.0)) refuse("::start: the first step must be at least 0, got " + text(first_step));
}

void require_size(const char* call, const char* what, std::size_t size, std::size_t wanted) {
  if (size != wanted)
    refuse(std::string(call) + ": " + what + " has " + text(wanted) + " numbers, the span " + text(size));
}

void refuse_end(double time, double until) {
  refuse("::step: the end must be finite and later than " + text(time) + ", got " + text(until));
}

void refuse_longest(double longest) {
  refuse("::step: the longest step must be greater than 0, got " + text(longest));
}

void refuse_time(double t, double before, double time) {
  refuse("::interpolate: the time " + text(t) + " is outside the last step, [" + text(before) + ", " +
         text(time) + "]");
}

void refuse_no_step(const char* call, double time) {
  refuse(std::string(call) + ": there is no accepted step that ends at " + text(time));
}

}  // namespace vectrix::ode::detail
