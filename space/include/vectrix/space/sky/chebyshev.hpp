#pragma once

#include <array>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/sky/geocentric.hpp>

namespace vectrix::detail {

/// A motion by polynomials through its positions at Chebyshev points, one for each piece of whole days of
/// TAI:
///     r(u) = sum_k a_k u^k, u in [-1, 1] over the piece       v = dr/dt
/// The points are the extrema of the highest Chebyshev polynomial, of which two are the ends of the piece: so
/// r is continuous. The pieces lie on one grid, whatever the span: a result does not depend on it.
class VECTRIX_EXPORT ChebyshevPieces {
 public:
  using Series = PlainMotion (*)(const JulianDate<scale::Tt>& tt);

  /// Pieces that contain the two epochs.
  ChebyshevPieces(Series series, int piece_days, int coefficients, const Epoch& first, const Epoch& last);

  /// At an instant within the pieces. What is outside is extrapolated: the caller has to check.
  [[nodiscard]] PlainMotion at(const JulianDate<scale::Tai>& tai) const;

 private:
  using Row = std::array<double, 4>;  // x, y, z, and 0: two registers instead of one and a half

  int piece_days_;
  double pieces_per_day_;
  int rows_of_piece_;
  int pieces_ = 0;
  double first_day_ = 0.0;
  std::vector<Row> rows_;  // of each piece an even number of coefficients, from that of the highest power
};

}  // namespace vectrix::detail
