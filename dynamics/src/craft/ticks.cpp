#include <vectrix/dynamics/craft/ticks.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace vectrix::detail {

TickList ticks(const Clock& clock, double start, double end) {
  const double count = std::ceil((end - start) / clock.period);
  constexpr double most = 1e8;  // 0.8 GB of times
  if (!(count <= most)) {
    throw BadInput("propagate: a period of " + text(clock.period) + " s gives " + text(count) +
                   " ticks from " + text(start) + " s to " + text(end) + " s, more than " + text(most));
  }
  const double apart = same_instant(start, end);
  if (clock.period < 4.0 * apart) {
    throw BadInput("propagate: a period of " + text(clock.period) + " s is below the rounding of " +
                   text(std::max(std::abs(start), std::abs(end))) + " s");
  }
  TickList list{{}, clock.latency};
  for (double k = 0.0; start + k * clock.period < end - apart; ++k)
    list.times.push_back(start + k * clock.period);
  return list;
}

TickList ticks(const TimeList& times, double start, double end) {
  TickList list{{}, 0.0};
  std::ranges::copy_if(times.times, std::back_inserter(list.times),
                       [&](double t) { return t >= start && t < end; });
  return list;
}

TickList ticks(RunStart, double start, double) {
  return {{start}, 0.0};
}

double same_instant(double start, double end) {
  return 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start), std::abs(end));
}

std::vector<double> instants_of(const std::vector<const TickList*>& lists, double start, double end) {
  std::vector<double> all;
  for (const TickList* list : lists) {
    all.insert(all.end(), list->times.begin(), list->times.end());
    if (list->latency == 0.0) continue;
    for (const double t : list->times) all.push_back(t + list->latency);
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
