#pragma once

#include <Eigen/Core>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/sky/geocentric.hpp>

namespace vectrix::detail {

/// A motion by Chebyshev series, one for each piece of whole days of TAI:
///     r(u) = sum_j c_j T_j(u), u in [-1, 1] over the piece       v = dr/dt
/// The series pass through the motion at the extrema of the highest T_j, of which two are the ends of the
/// piece: so r is continuous. The pieces lie on one grid, whatever the span: a result does not depend on it.
class VECTRIX_EXPORT ChebyshevPieces {
 public:
  using Series = PlainMotion (*)(const JulianDate<scale::Tt>& tt);

  /// Pieces that contain the two epochs.
  ChebyshevPieces(Series series, int piece_days, int coefficients, const Epoch& first, const Epoch& last);

  /// At an instant within the pieces. What is outside is extrapolated: the caller has to check.
  [[nodiscard]] PlainMotion at(const JulianDate<scale::Tai>& tai) const;

 private:
  using Row = Eigen::Vector4d;  // the last number is 0: two registers instead of one and a half

  int piece_days_;
  double pieces_per_day_;
  int rows_of_piece_;
  int pieces_ = 0;
  double first_day_ = 0.0;
  std::vector<Row> rows_;  // the coefficients of the first piece, an even number of them, of the second ...
};

}  // namespace vectrix::detail
