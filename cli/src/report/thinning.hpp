#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "report/report.hpp"

namespace vectrix::cli {

/// The places of the samples that are kept, in their order: all of them if they are at most so many. Else the
/// samples are cut into parts of equal number, and of each part the smallest and the largest value of every
/// curve are kept, so that about so many are, and the first NaN of a part that has one. The first and the
/// last sample are kept too. Nothing is averaged.
std::vector<std::size_t> kept_samples(std::span<const Report::Curve> curves, std::size_t most);

/// `most` places, at least 4, or all, evenly, with the first and the last one. If there are gaps, half as
/// many evenly, and between two of these the first gap, so that no gap is passed over.
std::vector<std::size_t> even_samples(const std::vector<bool>& are_gaps, std::size_t most);
std::vector<bool> gaps_of(const Report::Scene& scene);

template <class Value>
std::vector<Value> at_places(const std::vector<Value>& values, const std::vector<std::size_t>& places) {
  std::vector<Value> kept;
  kept.reserve(places.size());
  for (const std::size_t i : places) kept.push_back(values[i]);
  return kept;
}

}  // namespace vectrix::cli
