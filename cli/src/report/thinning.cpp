#include "report/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vectrix::cli {
namespace {

std::vector<std::size_t> all_places(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

// Adds the places of the extremes among the samples from..until, and of the first NaN.
void add_extremes(std::vector<std::size_t>& places, const std::vector<double>& values, std::size_t from,
                  std::size_t until) {
  std::size_t smallest = until, largest = until, gap = until;
  for (std::size_t i = from; i < until; ++i) {
    if (std::isnan(values[i])) {
      gap = std::min(gap, i);
      continue;
    }
    if (smallest == until || values[i] < values[smallest]) smallest = i;
    if (largest == until || values[i] > values[largest]) largest = i;
  }
  for (const std::size_t place : {smallest, largest, gap})
    if (place != until) places.push_back(place);
}

}  // namespace

std::vector<std::size_t> kept_samples(std::span<const Report::Curve> curves, std::size_t most) {
  const std::size_t count = curves.front().values.size();
  if (count <= most) return all_places(count);
  const std::size_t parts = std::max<std::size_t>(1, most / (2 * curves.size()));
  std::vector<std::size_t> places{0, count - 1};
  for (std::size_t part = 0; part < parts; ++part)
    for (const Report::Curve& curve : curves)
      add_extremes(places, curve.values, part * count / parts, (part + 1) * count / parts);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::size_t> even_samples(const std::vector<bool>& are_gaps, std::size_t most) {
  const std::size_t count = are_gaps.size();
  if (count <= most) return all_places(count);
  const bool has_gaps = std::find(are_gaps.begin(), are_gaps.end(), true) != are_gaps.end();
  const std::size_t even = has_gaps ? std::max<std::size_t>(2, most / 2) : most;
  std::vector<std::size_t> places{0};
  for (std::size_t i = 1; i < even; ++i) {
    const std::size_t next = i * (count - 1) / (even - 1);
    for (std::size_t gap = places.back() + 1; gap < next; ++gap)
      if (are_gaps[gap]) {
        places.push_back(gap);
        break;
      }
    places.push_back(next);
  }
  return places;
}

std::vector<bool> gaps_of(const Report::Scene& scene) {
  std::vector<bool> are_gaps;
  for (const auto& q : scene.reference_from_body) are_gaps.push_back(std::isnan(q.w()));
  return are_gaps;
}

}  // namespace vectrix::cli
