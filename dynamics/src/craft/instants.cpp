#include <vectrix/dynamics/craft/instants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vectrix::detail {

TickList ticks(const Clock& clock, double start, double end) {
  const double count = std::ceil((end - start) / clock.period);
  constexpr double most = 1e8;  // 1.6 GB of times
  if (!(count <= most)) {
    throw BadInput("propagate: a period of " + text(clock.period) + " s gives " + text(count) +
                   " ticks from " + text(start) + " s to " + text(end) + " s, more than " + text(most));
  }
  const double apart = same_instant(start, end);
  if (clock.period < 4.0 * apart) {
    throw BadInput("propagate: a period of " + text(clock.period) + " s is below the rounding of " +
                   text(std::max(std::abs(start), std::abs(end))) + " s");
  }
  TickList list;
  for (std::size_t k = 0;; ++k) {
    const double elapsed = static_cast<double>(k) * clock.period;
    if (start + elapsed >= end - apart) break;
    list.sampled.push_back(start + elapsed);
    list.applied.push_back(clock.latency == 0.0 ? start + elapsed : start + (elapsed + clock.latency));
  }
  return list;
}

TickList ticks(const TimeList& times, double start, double end) {
  TickList list;
  std::ranges::copy_if(times.times, std::back_inserter(list.sampled),
                       [&](double t) { return t >= start && t < end; });
  list.applied = list.sampled;
  return list;
}

double same_instant(double start, double end) {
  return 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start), std::abs(end));
}

std::vector<double> instants_of(const std::vector<TickList>& lists, double start, double end) {
  std::vector<double> all;
  for (const TickList& list : lists) {
    all.insert(all.end(), list.sampled.begin(), list.sampled.end());
    all.insert(all.end(), list.applied.begin(), list.applied.end());
  }
  std::ranges::sort(all);
  const double apart = same_instant(start, end);
  std::vector<double> instants;
  for (const double t : all) {
    if (t > start + apart && t < end - apart && (instants.empty() || t > instants.back() + apart))
      instants.push_back(t);
  }
  return instants;
}

}  // namespace vectrix::detail
