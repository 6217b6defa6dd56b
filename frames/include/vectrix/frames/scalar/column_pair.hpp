#pragma once

#include <Eigen/Core>
#include <concepts>

namespace vectrix::detail {

/// Three doubles in registers of two. Eigen's product extracts the second number twice, for the first two
/// results and for the third; a chain of products pays this at every matrix.
template <std::same_as<double> S> class ColumnPair {
  using Two = double __attribute__((vector_size(16)));

 public:
  explicit ColumnPair(const Eigen::Matrix<S, 3, 1>& x) : first_two{x[0], x[1]}, third(x[2]) {}
  ColumnPair(Two xy, S z) : first_two(xy), third(z) {}
  Eigen::Matrix<S, 3, 1> column() const { return {first_two[0], first_two[1], third}; }

  [[gnu::always_inline]] friend ColumnPair operator*(const Eigen::Matrix<S, 3, 3>& m, const ColumnPair& v) {
    const auto two = [&m](Eigen::Index j) { return Two{m(0, j), m(1, j)}; };
    const S x = v.first_two[0], y = v.first_two[1], z = v.third;
    return {two(0) * Two{x, x} + two(1) * Two{y, y} + two(2) * Two{z, z},
            m(2, 0) * x + m(2, 2) * z + m(2, 1) * y};
  }

 private:
  Two first_two;
  S third;
};

}  // namespace vectrix::detail
