#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <vectrix/dynamics/ode/solution.hpp>

namespace vectrix::ode {

/// Storage of a solution: nodes in flat arrays, node i at [i * dimension, (i + 1) * dimension).
struct Record {
  std::size_t dimension = 0;
  double start = 0.0;
  bool stopped = false;
  std::vector<double> times;
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
  void push(double t, std::span<const double> y, std::span<const double> ydot) {
    times.push_back(t);
    states.insert(states.end(), y.begin(), y.end());
    rates.insert(rates.end(), ydot.begin(), ydot.end());
  }
  void pop() {
    times.pop_back();
    states.resize(states.size() - dimension);
    rates.resize(rates.size() - dimension);
  }
};

}  // namespace vectrix::ode
