#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <vectrix/dynamics/ode/solution.hpp>

namespace vectrix::ode {

/// Storage of a solution: nodes in flat arrays, node i at [i * dimension, (i + 1) * dimension).
///
/// The time of a node is kept twice. `times` is rounded to the precision of the caller's time, 2e-7 s in
/// seconds since 1970. `elapsed`, the time since the start of the segment, is not: it is the time of the
/// state.
struct Record {
  std::size_t dimension = 0;
  double start = 0.0;
  bool stopped = false;
  std::vector<double> times;
  std::vector<double> elapsed;
  std::vector<double> states;
  std::vector<double> rates;
  std::vector<std::size_t> segments;  ///< first node of each segment
  std::vector<double> output_times;
  std::vector<double> outputs;
  std::vector<Event> events;
  Statistics statistics;

  [[nodiscard]] std::span<const double> state(std::size_t node) const {
    return {states.data() + node * dimension, dimension};
  }
  [[nodiscard]] std::span<const double> rate(std::size_t node) const {
    return {rates.data() + node * dimension, dimension};
  }
  /// The nodes of the segment that has this node: the first, and one past the last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> segment_of(std::size_t node) const {
    const auto next = std::ranges::upper_bound(segments, node);
    return {*std::prev(next), next == segments.end() ? times.size() : *next};
  }
  void push(double t, double since_segment, std::span<const double> y, std::span<const double> ydot) {
    times.push_back(t);
    elapsed.push_back(since_segment);
    states.insert(states.end(), y.begin(), y.end());
    rates.insert(rates.end(), ydot.begin(), ydot.end());
  }
  void pop() {
    times.pop_back();
    elapsed.pop_back();
    states.resize(states.size() - dimension);
    rates.resize(rates.size() - dimension);
  }
};

}  // namespace vectrix::ode
