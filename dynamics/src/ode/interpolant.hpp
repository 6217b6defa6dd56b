#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "record.hpp"

namespace vectrix::ode {

/// The solution in the interval [left, left + 1] of nodes, both in one segment: the method's own interpolant
/// if it was kept, else the Hermite polynomial around the interval, in Newton's form:
///     p(t) = sum_k f[z_0 … z_k] (t - z_0) … (t - z_{k-1}),   each node twice, nearest first.
class Interpolant {
 public:
  Interpolant(const Record& record, std::size_t left);

  /// State at a time in the closed interval, since the start of the segment.
  void at(double elapsed, std::span<double> state) const;

 private:
  static constexpr std::size_t max_nodes = 6;
  static constexpr std::size_t max_abscissas = 2 * max_nodes;

  void choose_nodes();
  void hermite(double elapsed, std::span<double> state) const;

  const Record& record_;
  std::size_t left_;
  std::array<std::size_t, max_nodes> nodes_;
  std::size_t node_count_ = 0;
  std::array<double, max_abscissas> abscissas_;
  // Not set if the method's interpolant was kept, and only for node_count_ nodes.
  /// inverse_spans_[k][i] = 1 / (z_{i+k} - z_i); the spans between a node and itself are not used.
  std::array<std::array<double, max_abscissas>, max_abscissas> inverse_spans_;
};

/// State at t in [times.front(), times.back()].
void interpolate(const Record& record, double t, std::span<double> state);

}  // namespace vectrix::ode
