#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {

/// [x]x, the skew matrix of the cross product:
///     1.  [x]x y = x x y      2.  [R x]x = R [x]x R^T      3.  ([x]x)^2 = x x^T - |x|^2 I
/// Works on bare coordinates. Any input is valid.
template <class Derived>
  requires(Derived::SizeAtCompileTime == 3)
auto hat(const Eigen::MatrixBase<Derived>& x) {
  using S = typename Derived::Scalar;
  const detail::Column<S> v = x;
  detail::Square<S> skew;
  skew << S(0), -v.z(), v.y(), v.z(), S(0), -v.x(), -v.y(), v.x(), S(0);
  return skew;
}

namespace detail {

/// The first entry that is not finite, as "entry (1, 2) is nan".
template <class Derived> std::string not_finite(const Eigen::MatrixBase<Derived>& matrix) {
  using S = typename Derived::Scalar;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      const S entry = matrix(row, column);
      if (!all(entry - entry == S(0)))
        return "entry (" + text(row + 1) + ", " + text(column + 1) + ") is " + text(entry);
    }
  }
  return "the entries, each finite, do not sum";
}

/// vee(); place() begins the messages.
template <class S, class Place> Column<S> vee_of(const Square<S>& m, const Place& place) {
  // Far above the rounding of a product of rotations, far below the error of a wrong matrix.
  const double skew_tolerance = door_tolerance<S>(1e-9);
  if (!all_finite(m)) throw BadInput(place() + not_finite(m));
  const S symmetric = ((m + m.transpose()) / S(2)).cwiseAbs().maxCoeff();
  const S largest = m.cwiseAbs().maxCoeff();
  if (!all(symmetric <= number<S>(skew_tolerance) * largest)) {
    throw BadInput(place() + "the symmetric part reaches " + text(symmetric) + " beside entries of " +
                   text(largest) + "; the matrix is not skew");
  }
  return {(m(2, 1) - m(1, 2)) / S(2), (m(0, 2) - m(2, 0)) / S(2), (m(1, 0) - m(0, 1)) / S(2)};
}

}  // namespace detail

/// The x of a skew matrix [x]x, from the half difference of opposite entries.
/// Throws BadInput when the matrix is not finite, or its symmetric part exceeds 1e-9 of its largest entry.
template <class Derived> auto vee(const Eigen::MatrixBase<Derived>& matrix) {
  return detail::vee_of<typename Derived::Scalar>(matrix, [] { return std::string{"vee(matrix): "}; });
}

}  // namespace vectrix
