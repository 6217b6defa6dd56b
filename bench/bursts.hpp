#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/frames/scalar/larger.hpp>

namespace bench {

inline constexpr std::size_t inputs = 64;

/// A task, each of whose calls has other numbers.
struct Task {
  std::string name;
  std::function<void(std::size_t)> call;
  std::vector<double> ns = {};
};

/// A row: ours over the peer's.
struct Row {
  Task ours, peer;
  double target;                       ///< of the ratio; 0: none
  std::function<double()> difference;  ///< largest, over all inputs
  double allowed;
};

/// Short bursts, interleaved, so that a slow machine slows all. The tenth percentile: what other users of the
/// machine do only adds time.
inline void measure(std::vector<Row>& rows) {
  constexpr int rounds = 200;
  constexpr double burst = 20e-6;  // s, about
  std::vector<std::pair<Task*, std::size_t>> order;
  for (Row& row : rows) {
    for (Task* task : {&row.ours, &row.peer}) {
      const auto begin = std::chrono::steady_clock::now();
      for (std::size_t i = 0; i < inputs; ++i) task->call(i);
      const double once =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / inputs;
      order.emplace_back(task, std::max<std::size_t>(1, static_cast<std::size_t>(burst / once)));
    }
  }
  std::mt19937_64 generator(5);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    for (const auto& [task, calls] : order) {
      const auto begin = std::chrono::steady_clock::now();
      for (std::size_t i = 0; i < calls; ++i) task->call(i % inputs);
      task->ns.push_back(
          std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() /
          static_cast<double>(calls));
    }
  }
  for (Row& row : rows) {
    for (Task* task : {&row.ours, &row.peer}) {
      std::nth_element(task->ns.begin(), task->ns.begin() + rounds / 10, task->ns.end());
    }
  }
}

inline double time_of(const Task& task) {
  return task.ns[task.ns.size() / 10];
}

template <class Difference> double largest_over_inputs(const Difference& difference) {
  double largest = 0.0;
  for (std::size_t i = 0; i < inputs; ++i)
    largest = vectrix::detail::larger(largest, std::abs(difference(i)));
  return largest;
}

/// The rows of a table: work, ns, peer, ns, ratio, target.
inline void print(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const double ours = time_of(row.ours), theirs = time_of(row.peer);
    std::printf("| %s | %.0f | %s | %.0f | %.4f |", row.ours.name.c_str(), ours, row.peer.name.c_str(),
                theirs, ours / theirs);
    if (row.target > 0.0) {
      std::printf(" %.4f%s |\n", row.target, ours / theirs <= row.target ? "" : ", missed");
    } else {
      std::printf(" |\n");
    }
  }
}

}  // namespace bench
