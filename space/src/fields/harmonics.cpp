#include "harmonics.hpp"

#include <cmath>

namespace vectrix::detail {

Harmonics harmonics_of(const Harmonics& normalized, Harmonics::Normalization normalization) {
  const int degree = normalized.degree();
  Harmonics result(degree);
  // Fully normalized: sqrt((2 - delta)(2n+1)(n-m)!/(n+m)!) times the leading coefficient
  // (2n)!/(2^n n! (n-m)!), from the diagonal up each column.
  long double diagonal = 1;
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) diagonal *= std::sqrt(m == 1 ? 3.0L : (2 * m + 1.0L) / (2 * m));
    long double factor = diagonal;
    for (int n = m; n <= degree; ++n) {
      if (n > m)
        factor *= std::sqrt((2 * n + 1.0L) * (2 * n - 1) / (static_cast<long double>(n - m) * (n + m)));
      const bool full = normalization == Harmonics::Normalization::full;
      const long double scale = full ? factor : factor / std::sqrt(2 * n + 1.0L);
      const Harmonics::Pair& given = normalized.at(n, m);
      result.add(n, m, {static_cast<double>(scale * given.C), static_cast<double>(scale * given.S)});
    }
  }
  return result;
}

Harmonics derivative(const Harmonics& harmonics, int axis) {
  Harmonics result(harmonics.degree() + 1);
  for (int n = 0; n <= harmonics.degree(); ++n) {
    for (int m = 0; m <= n; ++m) {
      const double C = (2 * n + 1) * harmonics.at(n, m).C, S = (2 * n + 1) * harmonics.at(n, m).S;
      if (axis == 2) {
        result.add(n + 1, m, {-C, -S});
      } else if (m == 0) {
        result.add(n + 1, 1, axis == 0 ? Harmonics::Pair{-C, 0.0} : Harmonics::Pair{0.0, -C});
      } else if (axis == 0) {
        result.add(n + 1, m + 1, {-C / 2, -S / 2});
        result.add(n + 1, m - 1, {C / 2, m == 1 ? 0.0 : S / 2});
      } else {
        result.add(n + 1, m + 1, {S / 2, -C / 2});
        result.add(n + 1, m - 1, {S / 2, m == 1 ? 0.0 : -C / 2});
      }
    }
  }
  return result;
}

}  // namespace vectrix::detail
