#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "../fused.hpp"
#include "harmonics.hpp"

namespace vectrix::detail {

/// Several sums of solid harmonics of one radius, evaluated together: all use the same functions. Each
/// function waits for the two before it in its column, m, so that several columns are taken at a time.
template <std::size_t sums> class HarmonicSeries {
 public:
  HarmonicSeries(const std::array<Harmonics, sums>& harmonics, double radius)
      : degree_(harmonics.front().degree()), radius_(radius) {
    for (int m = 0; m <= degree_; m += step) {
      for (int n = m; n <= degree_; ++n) {
        Functions factor{};
        Row row{};
        for (std::size_t c = 0; c < columns; ++c) {
          const int nc = n + static_cast<int>(c), mc = m + static_cast<int>(c);
          if (nc > degree_) continue;  // the later columns are shorter
          factor[c] = (static_cast<double>(nc) * nc - mc * mc) / (4.0 * nc * nc - 1.0);
          for (std::size_t i = 0; i < sums; ++i) {
            const auto& pair = harmonics[i].at(nc, mc);
            row[c][i / 2][2 * (i % 2)] = pair.C;
            row[c][i / 2][2 * (i % 2) + 1] = pair.S;
          }
        }
        factors_.push_back(factor);
        rows_.push_back(row);
      }
    }
  }

  /// The sums at a point, m.
  [[nodiscard]] std::array<double, sums> at(const Eigen::Vector3d& r) const {
    return fused([&]() __attribute__((always_inline)) { return sums_at(r); });
  }

 private:
  /// In each column P_n+1 = (a z/r^2) P_n - k_nm (a/r)^2 P_n-1, times (a (x + i y)/r^2)^m: no angle, and no
  /// singular point at the poles.
  [[nodiscard, gnu::always_inline]] inline std::array<double, sums> sums_at(const Eigen::Vector3d& r) const {
    const double square = r.squaredNorm();
    const Eigen::Vector3d scaled = radius_ / square * r;
    const Functions z = Functions{} + scaled.z(), q2 = Functions{} + radius_ * radius_ / square;
    std::array<TwoSums, twos> total{};
    double cosine = 1.0, sine = 0.0;  // of the power of x + i y
    const Row* row = rows_.data();
    const Functions* k = factors_.data();
    for (int m = 0; m <= degree_; m += step) {
      std::array<std::array<TwoSums, twos>, columns> column{};
      Functions before{}, now = Functions{} + 1.0;
      for (int n = m; n <= degree_; ++n, ++row, ++k) {
        for_each<columns>([&]<std::size_t c>() __attribute__((always_inline)) {
          const TwoSums function = TwoSums{} + now[c];
          for_each<twos>([&]<std::size_t i>()
                             __attribute__((always_inline)) { column[c][i] += function * (*row)[c][i]; });
        });
        const Functions next = z * now - *k * q2 * before;
        before = now;
        now = next;
      }
      for_each<columns>([&]<std::size_t c>() __attribute__((always_inline)) {
        const TwoSums phase{cosine, sine, cosine, sine};
        for_each<twos>([&]<std::size_t i>()
                           __attribute__((always_inline)) { total[i] += phase * column[c][i]; });
        const double turned = cosine * scaled.x() - sine * scaled.y();
        sine = cosine * scaled.y() + sine * scaled.x();
        cosine = turned;
      });
    }
    std::array<double, sums> result{};
    const double q = radius_ / std::sqrt(square);
    for (std::size_t i = 0; i < sums; ++i) {
      const std::size_t first = 2 * (i % 2);
      result[i] = q * (total[i / 2][first] + total[i / 2][first + 1]);
    }
    return result;
  }

  using TwoSums = double __attribute__((vector_size(32)));  // C and S of two sums
  static constexpr std::size_t twos = (sums + 1) / 2;
  static constexpr std::size_t columns = twos > 2 ? 2 : 4;  // the registers hold the sums of so many
  static constexpr int step = static_cast<int>(columns);
  using Two = double __attribute__((vector_size(16)));
  using Functions = std::conditional_t<columns == 2, Two, TwoSums>;

  using Row = std::array<std::array<TwoSums, twos>, columns>;

  /// Written out, so that the sums stay in registers.
  template <std::size_t count, class Function>
  [[gnu::always_inline]] static inline void for_each(const Function& function) {
    [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
      (function.template operator()<i>(), ...);
    }
    (std::make_index_sequence<count>{});
  }

  int degree_;
  double radius_;
  std::vector<Functions> factors_;  // k_nm of the columns
  std::vector<Row> rows_;           // the coefficients of the functions
};

}  // namespace vectrix::detail
