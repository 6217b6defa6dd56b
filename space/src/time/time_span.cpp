#include <algorithm>
#include <cmath>
#include <limits>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/time_span.hpp>

#include "date.hpp"

namespace vectrix {
using detail::shown;

void detail::refuse_outside(const std::string& name, const Epoch& epoch, const char* what,
                            const TimeSpan& span) {
  const std::string said = shown(epoch), start = shown(span.start()), end = shown(span.end());
  const char* how = said == start || said == end ? " is less than 1e-6 s outside " : " is outside ";
  throw BadInput(name + ": the epoch " + said + how + what + " " + start + " to " + end);
}

TimeSpan from_until(const Epoch& start, const Epoch& end) {
  if (end < start) {
    throw BadInput("from_until: the end, " + shown(end) + ", is before the start, " + shown(start));
  }
  return {start, end};
}

TimeSpan from_until(const Epoch& start, const Quantity<si::time>& duration) {
  if (!(duration.value() >= 0.0 && std::isfinite(duration.value()))) {
    throw BadInput("from_until: the duration is " + detail::text(duration.value()) + " s");
  }
  return from_until(start, start + duration);
}

Epoch EpochRange::operator[](std::int64_t k) const {
  return std::min(span_.start() + static_cast<double>(k) * step_, span_.end());
}

EpochRange every(const Quantity<si::time>& step, const TimeSpan& span) {
  if (!(step.value() > 0.0 && std::isfinite(step.value()))) {
    throw BadInput("every: the step is " + detail::text(step.value()) + " s");
  }
  const double length = (span.end() - span.start()).value();
  constexpr double clock_rounding = 3e-11;  // s: of both epochs, and of their difference
  const double rounding = clock_rounding + 2.0 * std::numeric_limits<double>::epsilon() * length;
  const double steps = std::floor((length + std::min(rounding, 0.5 * step.value())) / step.value());
  if (!(steps < 9007199254740992.0)) {
    throw BadInput("every: the step of " + detail::text(step.value()) + " s is too short for a span of " +
                   detail::text(length) + " s");
  }
  return {step, span, static_cast<std::int64_t>(steps) + 1};
}

}  // namespace vectrix
