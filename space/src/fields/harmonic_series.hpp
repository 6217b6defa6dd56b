#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "harmonics.hpp"

namespace vectrix::detail {

/// Several sums of solid harmonics of one radius, evaluated together: all use the same functions. Each
/// function waits for the two before it in its column, m, so that few sums are taken by two columns at a
/// time.
template <std::size_t sums> class HarmonicSeries {
 public:
  HarmonicSeries(const std::array<Harmonics, sums>& harmonics, double radius)
      : degree_(harmonics.front().degree()), radius_(radius) {
    for (int m = 0; m <= degree_; m += step) {
      for (int n = m; n <= degree_; ++n) {
        Row row{};
        for (std::size_t c = 0; c < columns; ++c) {
          const int nc = n + static_cast<int>(c), mc = m + static_cast<int>(c);
          if (nc > degree_) continue;  // the second column is shorter
          const double k = (static_cast<double>(nc) * nc - mc * mc) / (4.0 * nc * nc - 1.0);
          if (columns == 1)
            row.k = Pair{k, k};
          else
            row.k[c] = k;
          for (std::size_t i = 0; i < sums; ++i) {
            const auto& pair = harmonics[i].at(nc, mc);
            row.coefficients[c][i] = Pair{pair.C, pair.S};
          }
        }
        rows_.push_back(row);
      }
    }
  }

  /// The sums at a point, m.
  [[nodiscard]] std::array<double, sums> at(const Eigen::Vector3d& r) const {
#ifdef __x86_64__
    static const bool fuses = __builtin_cpu_supports("fma");
    if (fuses) return fused_sums_at(r);
#endif
    return sums_at(r);
  }

 private:
  /// In each column P_n+1 = (a z/r^2) P_n - k_nm (a/r)^2 P_n-1, times (a (x + i y)/r^2)^m: no angle, and no
  /// singular point at the poles.
  [[nodiscard, gnu::always_inline]] inline std::array<double, sums> sums_at(const Eigen::Vector3d& r) const {
    const double square = r.squaredNorm();
    const Eigen::Vector3d scaled = radius_ / square * r;
    const Pair z = both(scaled.z()), q2 = both(radius_ * radius_ / square);
    std::array<Pair, sums> total{};
    double cosine = 1.0, sine = 0.0;  // of the power of x + i y
    const Row* row = rows_.data();
    for (int m = 0; m <= degree_; m += step) {
      std::array<std::array<Pair, sums>, columns> column{};
      Pair before{}, now = both(1.0);
      for (int n = m; n <= degree_; ++n, ++row) {
        for_each<columns>([&]<std::size_t c>() __attribute__((always_inline)) {
          const Pair function = columns == 1 ? now : both(now[c]);
          for_each<sums>([&]<std::size_t i>() __attribute__((always_inline)) {
            column[c][i] += function * row->coefficients[c][i];
          });
        });
        const Pair next = z * now - row->k * q2 * before;
        before = now;
        now = next;
      }
      for_each<columns>([&]<std::size_t c>() __attribute__((always_inline)) {
        const Pair phase{cosine, sine};
        for_each<sums>([&]<std::size_t i>()
                           __attribute__((always_inline)) { total[i] += phase * column[c][i]; });
        const double turned = cosine * scaled.x() - sine * scaled.y();
        sine = cosine * scaled.y() + sine * scaled.x();
        cosine = turned;
      });
    }
    std::array<double, sums> result{};
    const double q = radius_ / std::sqrt(square);
    for (std::size_t i = 0; i < sums; ++i) result[i] = q * (total[i][0] + total[i][1]);
    return result;
  }
#ifdef __x86_64__
  /// The same with multiplications and additions in one, as the C library has its sines where the processor
  /// can: half the time.
  [[nodiscard, gnu::target("fma")]] std::array<double, sums> fused_sums_at(const Eigen::Vector3d& r) const {
    return sums_at(r);
  }
#endif

  using Pair = double __attribute__((vector_size(16)));
  static constexpr std::size_t columns = sums > 4 ? 1 : 2;  // the registers hold the sums of so many
  static constexpr int step = static_cast<int>(columns);

  struct Row {
    Pair k;  // of both columns; of one, twice the same number
    std::array<std::array<Pair, sums>, columns> coefficients;
  };

  [[gnu::always_inline]] static inline Pair both(double x) {
    return Pair{x, x};
  }
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
  std::vector<Row> rows_;
};

}  // namespace vectrix::detail
