#pragma once

#include <cstddef>
#include <string>

namespace vectrix::cli {

/// How an orbit is interpolated between its samples, as a message says it.
struct Interpolation {
  std::string method;  // HERMITE or LAGRANGE
  int degree;

  [[nodiscard]] bool is_hermite() const { return method == "HERMITE"; }
  /// How many samples one polynomial takes.
  [[nodiscard]] std::size_t samples() const {
    return static_cast<std::size_t>(is_hermite() ? (degree + 1) / 2 : degree + 1);
  }
  /// "HERMITE interpolation of degree 7"
  [[nodiscard]] std::string name() const;
};

/// Throws BadInput, which begins with `place`, for a degree that the method does not have.
void require_degree(const std::string& place, const Interpolation& interpolation);

}  // namespace vectrix::cli
