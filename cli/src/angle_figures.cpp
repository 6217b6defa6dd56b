#include "angle_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "figures.hpp"
#include "quantile.hpp"

namespace vectrix::cli {

AngleFigures::AngleFigures(std::vector<double> angles) : angles_(std::move(angles)), order_(angles_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return angles_[a] < angles_[b]; });
}

std::size_t AngleFigures::place_of(double percent) const {
  return order_[place_of_quantile(percent, order_.size())];
}

double AngleFigures::value(std::size_t place) const {
  return degrees * angles_[place];
}

double AngleFigures::rms() const {
  double squares = 0.0;
  for (const double angle : angles_) squares += angle * angle;
  return degrees * std::sqrt(squares / static_cast<double>(angles_.size()));
}

Judgement AngleFigures::judge(double required, double percent) const {
  const double found = quantile(percent);
  const auto within = std::count_if(angles_.begin(), angles_.end(),
                                    [&](double angle) { return degrees * angle <= required; });
  return {found, required - found, static_cast<std::size_t>(within), found <= required};
}

}  // namespace vectrix::cli
