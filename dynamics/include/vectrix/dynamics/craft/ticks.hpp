#pragma once

#include <cstddef>
#include <vector>
#include <vectrix/dynamics/craft/changes.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

/// When one change by a clock or a list of times happens in a run: its function sees the state at a time, and
/// its result takes effect `latency` later.
struct TickList {
  std::vector<double> times;
  double latency;
};
/// Those in [start, end).
VECTRIX_EXPORT TickList ticks(const Clock& clock, double start, double end);
VECTRIX_EXPORT TickList ticks(const TimeList& times, double start, double end);
VECTRIX_EXPORT TickList ticks(RunStart, double start, double end);

/// Times that differ by less are one instant: products k period of several clocks have rounded differently.
VECTRIX_EXPORT double same_instant(double start, double end);
/// Each instant of the lists inside (start, end) once, strictly increasing.
VECTRIX_EXPORT std::vector<double> instants_of(const std::vector<const TickList*>& lists, double start,
                                               double end);

}  // namespace vectrix::detail
