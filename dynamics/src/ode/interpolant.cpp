#include "interpolant.hpp"

#include <algorithm>

#include <vectrix/frames/errors.hpp>

namespace vectrix::ode {

Interpolant::Interpolant(const Record& record, std::size_t left) : record_(record), left_(left) {
  if (record.has_terms(left)) return;
  choose_nodes();
  const std::size_t count = 2 * node_count_;
  for (std::size_t i = 0; i < count; ++i) abscissas_[i] = record_.elapsed[nodes_[i / 2]];
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t i = k == 1 ? 1 : 0; i + k < count; i += k == 1 ? 2 : 1) {
      inverse_spans_[k][i] = 1.0 / (abscissas_[i + k] - abscissas_[i]);
    }
  }
}

/// Takes the two ends of the interval, then nodes outwards, the nearer side first. Skips nodes that are
/// closer to each other than half the interval: their divided differences would amplify rounding far beyond
/// that of the state.
void Interpolant::choose_nodes() {
  const std::size_t left = left_;
  const auto& t = record_.elapsed;
  const auto [first, after] = record_.segment_of(left);
  const std::size_t last = after - 1;
  const double start = t[left];
  const double end = t[left + 1];
  const double gap = 0.5 * (end - start);

  nodes_[0] = left;
  nodes_[1] = left + 1;
  node_count_ = 2;
  std::size_t low = left;  // outermost nodes chosen so far
  std::size_t high = left + 1;
  while (node_count_ < max_nodes) {
    std::size_t below = low;
    while (below > first && t[low] - t[below] < gap) --below;
    const bool has_below = t[low] - t[below] >= gap;
    std::size_t above = high;
    while (above < last && t[above] - t[high] < gap) ++above;
    const bool has_above = t[above] - t[high] >= gap;
    if (!has_below && !has_above) break;
    const bool take_below = has_below && (!has_above || start - t[below] < t[above] - end);
    nodes_[node_count_++] = take_below ? (low = below) : (high = above);
  }
}

void Interpolant::at(double elapsed, std::span<double> state) const {
  if (!record_.has_terms(left_)) {
    hermite(elapsed, state);
    return;
  }
  const std::size_t size = record_.dimension;
  const std::span<const double> y = record_.state(left_), terms = record_.terms_of(left_);
  const double theta =
      (elapsed - record_.elapsed[left_]) / (record_.elapsed[left_ + 1] - record_.elapsed[left_]);
  for (std::size_t c = 0; c < size; ++c) {
    double sum = 0.0;
    for (std::size_t p = record_.degree; p-- > 0;) sum = theta * (sum + terms[p * size + c]);
    state[c] = y[c] + sum;
  }
}

void Interpolant::hermite(double elapsed, std::span<double> state) const {
  const std::size_t count = 2 * node_count_;
  std::array<double, max_abscissas> distance{};
  for (std::size_t i = 0; i < count; ++i) distance[i] = elapsed - abscissas_[i];

  for (std::size_t c = 0; c < record_.dimension; ++c) {
    std::array<double, max_abscissas> difference{};  // column k of the table of divided differences
    for (std::size_t i = 0; i < count; ++i) difference[i] = record_.state(nodes_[i / 2])[c];
    std::array<double, max_abscissas> newton{};
    newton[0] = difference[0];
    for (std::size_t k = 1; k < count; ++k) {
      for (std::size_t i = 0; i + k < count; ++i) {
        difference[i] = k == 1 && i % 2 == 0 ? record_.rate(nodes_[i / 2])[c]
                                             : (difference[i + 1] - difference[i]) * inverse_spans_[k][i];
      }
      newton[k] = difference[0];
    }
    double value = newton[count - 1];
    for (std::size_t k = count - 1; k-- > 0;) value = newton[k] + distance[k] * value;
    state[c] = value;
  }
}

void interpolate(const Record& record, double t, std::span<double> state) {
  const auto later = std::ranges::upper_bound(record.times, t);
  const auto [first, after] = record.segment_of(static_cast<std::size_t>(later - record.times.begin()) - 1);
  const std::span nodes = std::span(record.elapsed).subspan(first, after - first);
  const double elapsed = std::min(t - record.times[first], nodes.back());
  const auto next = std::ranges::upper_bound(nodes, elapsed);
  const std::size_t node = first + static_cast<std::size_t>(next - nodes.begin()) - 1;
  if (record.elapsed[node] == elapsed) {
    std::ranges::copy(record.state(node), state.begin());
  } else if (!record.is_dense(node) && record.times[node] < t && t < record.times[node + 1]) {
    throw BadInput("ode::Solution::at: time " + vectrix::detail::text(t) +
                   " is within a step whose dense output was not kept (Problem::dense_output)");
  } else {
    Interpolant(record, node).at(elapsed, state);
  }
}

}  // namespace vectrix::ode
