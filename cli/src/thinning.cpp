#include "thinning.hpp"

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

std::vector<std::size_t> even_samples(std::size_t count, std::size_t most) {
  if (count <= most) return all_places(count);
  std::vector<std::size_t> places(most);
  for (std::size_t i = 0; i < most; ++i) places[i] = i * (count - 1) / (most - 1);
  return places;
}

}  // namespace vectrix::cli
