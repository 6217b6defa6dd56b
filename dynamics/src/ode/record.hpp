#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
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

  /// The interpolants that the method made itself, `degree` terms for each component (see Stepper::terms),
  /// and where those of the step after a node begin: no_terms if it made none, or there is no such step.
  std::size_t degree = 0;
  bool sparse = false;  ///< they were made only where they were needed
  std::vector<double> terms;
  std::vector<std::size_t> terms_begin;
  static constexpr std::size_t no_terms = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t none_needed = no_terms - 1;

  [[nodiscard]] bool has_terms(std::size_t left) const { return terms_begin[left] < none_needed; }
  /// Whether there is a state within the step after a node.
  [[nodiscard]] bool is_dense(std::size_t left) const { return !sparse || terms_begin[left] != no_terms; }
  [[nodiscard]] std::span<const double> terms_of(std::size_t left) const {
    return {terms.data() + terms_begin[left], degree * dimension};
  }
  /// Keeps the terms of the last step.
  void add_terms(std::span<const double> added) {
    terms_begin[times.size() - 2] = terms.size();
    terms.insert(terms.end(), added.begin(), added.end());
  }
  /// The last step has a state within it without terms.
  void need_no_terms() { terms_begin[times.size() - 2] = none_needed; }
  /// Takes back add_terms(), if it was called for the last step.
  void drop_terms() {
    if (!has_terms(times.size() - 2)) return;
    auto& begin = terms_begin[times.size() - 2];
    terms.resize(begin);
    begin = no_terms;
  }
  /// Replaces the last node by one within the last step.
  void shorten(double t, double since_segment, std::span<const double> y, std::span<const double> ydot) {
    const std::size_t left = times.size() - 2;
    const double part = (since_segment - elapsed[left]) / (elapsed[left + 1] - elapsed[left]);
    if (has_terms(left)) {
      double power = 1.0;
      for (std::size_t i = 0; i < degree * dimension; ++i) {
        if (i % dimension == 0) power *= part;
        terms[terms_begin[left] + i] *= power;
      }
    }
    pop();
    push(t, since_segment, y, ydot);
  }

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
    terms_begin.push_back(no_terms);
    states.insert(states.end(), y.begin(), y.end());
    rates.insert(rates.end(), ydot.begin(), ydot.end());
  }
  void pop() {
    times.pop_back();
    elapsed.pop_back();
    terms_begin.pop_back();
    states.resize(states.size() - dimension);
    rates.resize(rates.size() - dimension);
  }
};

}  // namespace vectrix::ode
