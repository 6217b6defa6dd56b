#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "harmonics.hpp"

namespace vectrix::detail {

/// Several sums of solid harmonics of one radius, evaluated together: all use the same functions. The rows
/// stand in the order of the evaluation, by columns m.
template <std::size_t sums> class HarmonicSeries {
 public:
  HarmonicSeries(const std::array<Harmonics, sums>& harmonics, double radius)
      : degree_(harmonics.front().degree()), radius_(radius) {
    for (int m = 0; m <= degree_; ++m) {
      for (int n = m; n <= degree_; ++n) {
        Row row{n > m + 1 ? (Pair{} + ((n - 1.0) * (n - 1) - m * m) / (4.0 * (n - 1) * (n - 1) - 1)) : Pair{},
                {}};
        for (std::size_t i = 0; i < sums; ++i)
          row.coefficients[i] = Pair{harmonics[i].at(n, m).C, harmonics[i].at(n, m).S};
        rows_.push_back(row);
      }
    }
  }

  /// The sums at a point, m. In each column P_n = (a z/r^2) P_n-1 - k_nm (a/r)^2 P_n-2, times
  /// (a (x + i y)/r^2)^m: no angle, and no singular point at the poles.
  [[nodiscard]] std::array<double, sums> at(const Eigen::Vector3d& r) const {
    const double square = r.squaredNorm();
    const Eigen::Vector3d scaled = radius_ / square * r;
    const Pair z = Pair{} + scaled.z(), q2 = Pair{} + radius_ * radius_ / square;
    std::array<Pair, sums> total{};
    double cosine = 1.0, sine = 0.0;  // of the power of x + i y
    const Row* row = rows_.data();
    for (int m = 0; m <= degree_; ++m) {
      std::array<Pair, sums> column{};
      Pair before{}, now = Pair{} + 1.0;
      for (int n = m; n <= degree_; ++n, ++row) {
        if (n > m) {
          const Pair next = z * now - row->k * q2 * before;
          before = now;
          now = next;
        }
        for (std::size_t i = 0; i < sums; ++i) column[i] += now * row->coefficients[i];
      }
      const Pair phase{cosine, sine};
      for (std::size_t i = 0; i < sums; ++i) total[i] += phase * column[i];
      const double turned = cosine * scaled.x() - sine * scaled.y();
      sine = cosine * scaled.y() + sine * scaled.x();
      cosine = turned;
    }
    std::array<double, sums> result{};
    const double q = radius_ / std::sqrt(square);
    for (std::size_t i = 0; i < sums; ++i) result[i] = q * (total[i][0] + total[i][1]);
    return result;
  }

 private:
  using Pair = double __attribute__((vector_size(16)));
  struct Row {
    Pair k;  // twice the same number
    std::array<Pair, sums> coefficients;
  };

  int degree_;
  double radius_;
  std::vector<Row> rows_;
};

}  // namespace vectrix::detail
