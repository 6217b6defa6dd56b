#pragma once

#include <cstddef>
#include <vector>
#include <vectrix/dynamics/craft/changes.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

/// When one change by a clock or a list of times happens in a run.
struct TickList {
  std::vector<double> sampled;  ///< the function sees the state then
  std::vector<double> applied;  ///< and its result takes effect then
};
/// Those in [start, end).
VECTRIX_EXPORT TickList ticks(const Clock& clock, double start, double end);
VECTRIX_EXPORT TickList ticks(const TimeList& times, double start, double end);
template <class G> TickList ticks(const Zero<G>&, double, double) {
  return {};
}

/// TimeList that differ by less are one instant: products k period of several clocks have rounded
/// differently.
VECTRIX_EXPORT double same_instant(double start, double end);
/// Each instant of the lists once, strictly increasing.
VECTRIX_EXPORT std::vector<double> instants_of(const std::vector<TickList>& lists, double start, double end);

}  // namespace vectrix::detail
