#pragma once

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engines.hpp"

/// Engines at equal accuracy, and how the targets are met.
namespace bench {

/// Of the processor for this thread.
inline double milliseconds(const std::function<void()>& call) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  call();
  return now() - start;
}

/// What other users of the machine do only adds time.
inline double lower_quartile(std::vector<double> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

struct Attempt {
  double tolerance, error;
  std::size_t evaluations;
};
/// `target`: of its time over that of the first row; 0: none.
struct Row {
  Engine engine;
  double target = 0.0;
  std::vector<Attempt> attempts = {};
  const Attempt* chosen = nullptr;
  std::vector<double> ms = {};
};

inline double best_error(const Row& row) {
  double best = INFINITY;
  for (const Attempt& attempt : row.attempts) best = std::min(best, attempt.error);
  return best;
}

/// Tolerances from 1e-5 down, half a decade a step, until the error is reached.
inline void sweep(Row& row, const Attitude& exact, double tightest) {
  constexpr double loosest = 1e-5, least = 1e-15;
  for (double tolerance = loosest; tolerance > least; tolerance /= std::sqrt(10.0)) {
    try {
      const Result result = row.engine.run(tolerance);
      row.attempts.push_back({tolerance, angle_between(result.at_end, exact), result.evaluations});
    } catch (const std::exception&) {
      continue;  // too many steps, or a tolerance that it refuses
    }
    if (row.attempts.back().error <= tightest) return;
  }
}

/// The cheapest attempt that reaches the error; null if none does.
inline const Attempt* cheapest(const Row& row, double error) {
  const Attempt* best = nullptr;
  for (const Attempt& attempt : row.attempts)
    if (attempt.error <= error && (!best || attempt.evaluations < best->evaluations)) best = &attempt;
  return best;
}

/// A target that is not met, for the list below the tables.
using Misses = std::vector<std::string>;
inline void compare(double ratio, double target, const std::string& what, Misses& misses) {
  if (!(target > 0.0)) {
    std::printf(" %.1f | |\n", ratio);
    return;
  }
  std::printf(" %.1f | %g |\n", ratio, target);
  if (ratio >= target) return;
  std::array<char, 32> numbers{};
  std::snprintf(numbers.data(), numbers.size(), ": %.1f of %g", ratio, target);
  misses.push_back(what + numbers.data());
}
inline void print_misses(const Misses& misses) {
  std::printf("\nNot reached:\n\n");
  for (const std::string& miss : misses) std::printf("- %s\n", miss.c_str());
  if (misses.empty()) std::printf("- nowhere.\n");
}

/// The table of a problem, a block of rows for each error.
inline void print_at_equal_accuracy(const std::string& problem, std::vector<Row> rows, const Attitude& exact,
                                    const std::vector<double>& errors, int rounds, Misses& misses) {
  std::printf(
      "| error, rad | integrator | tolerance | error reached | evaluations | ms | over the first | target |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (Row& row : rows) sweep(row, exact, errors.back());
  for (const double error : errors) {
    for (Row& row : rows) {
      row.chosen = cheapest(row, error);
      row.ms.clear();
    }
    for (int round = 0; round < rounds; ++round)
      for (Row& row : rows)
        if (row.chosen) row.ms.push_back(milliseconds([&] { (void)row.engine.run(row.chosen->tolerance); }));
    for (const Row& row : rows) {
      if (!row.chosen) {
        std::printf("| %.0e | %s | not reached | at best %.1e | | | | |\n", error, row.engine.name.c_str(),
                    best_error(row));
        continue;
      }
      std::printf("| %.0e | %s | %.0e | %.1e | %zu | %.3g |", error, row.engine.name.c_str(),
                  row.chosen->tolerance, row.chosen->error, row.chosen->evaluations, lower_quartile(row.ms));
      if (!rows.front().chosen) {
        std::printf(" | |\n");
        continue;
      }
      std::array<char, 32> to{};
      std::snprintf(to.data(), to.size(), ", %.0e rad, ", error);
      compare(lower_quartile(row.ms) / lower_quartile(rows.front().ms), row.target,
              problem + to.data() + row.engine.name, misses);
    }
    if (!rows.front().chosen) misses.push_back(problem + ": the first row does not reach the error");
  }
}

}  // namespace bench
