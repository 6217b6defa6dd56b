#include "interpolation.hpp"

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

std::string Interpolation::name() const {
  return method + " interpolation of degree " + std::to_string(degree);
}

void require_degree(const std::string& place, const Interpolation& interpolation) {
  constexpr int largest = 15;
  const int least = interpolation.is_hermite() ? 3 : 2;
  const int degree = interpolation.degree;
  if (degree >= least && degree <= largest && (!interpolation.is_hermite() || degree % 2 == 1)) return;
  throw BadInput(place + interpolation.name() + " does not exist; the degree is " +
                 (interpolation.is_hermite() ? "odd, " : "") + std::to_string(least) + " to " +
                 std::to_string(largest));
}

}  // namespace vectrix::cli
