#pragma once

#include <Eigen/Cholesky>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/scalar/principal_values.hpp>

namespace vectrix {

/// P^a, `P_a`, of type Covariance<A, U>: the covariance, in the axes of a, of a vector r in the unit U; its
/// entries have the unit U^2. Its laws:
///     1.  P^b = R_a^b P^a (R_a^b)^T          R_b_from_a * P_a
///     2.  cov(r + s) = cov(r) + cov(s)       P_a + Q_a: the sum claims that r and s are independent
///     3.  var(n . r) = n^T P n               variance_along(P_a, n_a)
/// Every quantity changes its axes by R_b_from_a * quantity; for a covariance this multiplies from both
/// sides. Made by covariance() or covariance_from_standard_deviations(); there is no default.
template <Frame F, VectorUnit U, class S = double> class Covariance {
 public:
  using frame = F;
  using unit = U;
  using scalar = S;

  Covariance() = delete;  // covariance<U>(in<F>, matrix)
  template <class Derived>
  Covariance(detail::Trusted, const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {}

  template <class Operand = Covariance>
  auto operator-() const -> Refused = delete;  // a covariance has no negative

  /// The bare 3x3 matrix, in the square of the coherent SI unit. Frame and unit are no longer checked.
  const detail::Square<S>& matrix() const& { return matrix_; }
  detail::Square<S> matrix() && { return matrix_; }

 private:
  detail::Square<S> matrix_;
};

template <class F, class U, class S> inline constexpr bool detail::is_framed<Covariance<F, U, S>> = true;

/// Tolerance of covariance() for rounding: the asymmetry relative to the largest entry, and a negative
/// principal variance relative to the largest one. mahalanobis_distance() needs a larger share than this of
/// each variance that the other axes do not explain.
inline constexpr double covariance_tolerance = 1e-12;

namespace detail {

template <class F, class S> void require_covariance(const Square<S>& matrix) {
  const std::string place = "covariance(in<" + frame_name<F>() + ">): ";
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      const S entry = matrix(row, column);
      if (!(entry - entry == S(0))) {
        throw BadInput(place + "entry (" + text(row + 1) + ", " + text(column + 1) + ") is " + text(entry));
      }
    }
  }
  const S tolerance = S(door_tolerance<S>(covariance_tolerance));
  const S largest = matrix.cwiseAbs().maxCoeff();
  const S asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff();
  if (!(asymmetry <= tolerance * largest)) {
    throw BadInput(place + "the matrix is not symmetric: it differs from its transpose by " +
                   text(asymmetry));
  }
  const Column<S> variances = principal_values(matrix);
  if (!(variances(0) >= -tolerance * variances(2))) {
    throw BadInput(place + "the principal variances (" + text(variances(0)) + ", " + text(variances(1)) +
                   ", " + text(variances(2)) + ") are not all positive or zero");
  }
}

/// The check branches, so it takes one lane after the other.
template <class F, Batch S> void require_covariance(const Square<S>& matrix) {
  for (std::size_t i = 0; i < S::size(); ++i) require_covariance<F, typename S::value_type>(lane(matrix, i));
}

template <class F, class S> void require_deviations(const Column<S>& deviations) {
  if constexpr (Batch<S>) {
    for (std::size_t i = 0; i < S::size(); ++i)
      require_deviations<F, typename S::value_type>(lane(deviations, i));
  } else {
    const Column<S> variances = deviations.cwiseAbs2();
    const bool underflows = ((deviations.array() > S(0)) && (variances.array() == S(0))).any();
    if (!(deviations.minCoeff() >= S(0) && variances.allFinite()) || underflows) {
      throw BadInput("covariance_from_standard_deviations(in<" + frame_name<F>() + ">): (" +
                     text(deviations.x()) + ", " + text(deviations.y()) + ", " + text(deviations.z()) +
                     ") are not all zero, or positive with a square that a number can hold");
    }
  }
}

template <class F, class S> [[noreturn, gnu::cold, gnu::noinline]] void refuse_distance(const S& share) {
  throw BadInput("mahalanobis_distance(covariance in " + frame_name<F>() +
                 "): the covariance is singular: the share of a variance that the other axes leave open is " +
                 text(share));
}

template <class F, class S> S mahalanobis(const Square<S>& P, const Column<S>& r) {
  if constexpr (Batch<S>) {
    return S([&](std::size_t i) { return mahalanobis<F, typename S::value_type>(lane(P, i), lane(r, i)); });
  } else {
    const S open = S(door_tolerance<S>(covariance_tolerance));
    const Column<S> variances = P.diagonal();
    if (!(variances.minCoeff() > S(0))) {
      refuse_distance<F, S>(S(0));
    }
    // Scaled by the standard deviations of the axes: axes of very different variance do not make P singular.
    const Column<S> scale = variances.cwiseSqrt().cwiseInverse();
    const Eigen::LLT<Square<S>> factor(Square<S>(scale.asDiagonal() * P * scale.asDiagonal()));
    const S share = factor.matrixLLT().diagonal().cwiseAbs2().minCoeff();
    if (factor.info() != Eigen::Success || !(share > open)) {
      refuse_distance<F, S>(factor.info() == Eigen::Success ? share : S(0));
    }
    const Column<S> normal = factor.matrixL().solve(scale.cwiseProduct(r));
    return normal.norm();
  }
}

}  // namespace detail

/// The checked door: claims that `matrix` is the covariance of a vector's coordinates in F, in the square of
/// the coherent SI unit U: covariance<si::length>(in<F>, P).
/// Throws BadInput when an entry is not finite, the matrix is not symmetric, or a principal variance is
/// negative.
template <VectorUnit U, Frame F, class Derived>
  requires detail::Matrix3x3<Derived>
auto covariance(In<F>, const Eigen::MatrixBase<Derived>& matrix) {
  using S = typename Derived::Scalar;
  detail::require_size(matrix, 3, 3, [] { return "covariance(in<" + frame_name<F>() + ">): "; });
  const detail::Square<S> entries = matrix;
  detail::require_covariance<F, S>(entries);
  return Covariance<F, U, S>{detail::trusted, entries};
}

/// The trusted door: checks nothing. The caller guarantees a symmetric matrix without negative variances.
template <VectorUnit U, Frame F, class Derived>
  requires detail::Matrix3x3<Derived>
auto trust_covariance(In<F>, const Eigen::MatrixBase<Derived>& matrix) {
  detail::require_size(matrix, 3, 3, [] { return "trust_covariance(in<" + frame_name<F>() + ">): "; });
  return Covariance<F, U, typename Derived::Scalar>{detail::trusted, matrix};
}

/// The covariance of a vector with independent coordinates in F, whose standard deviations are given.
/// Throws BadInput when one is not finite or negative, or its square overflows or underflows.
template <Frame F, VectorUnit U, class S>
  requires(!std::is_integral_v<S>)
Covariance<F, U, S> covariance_from_standard_deviations(In<F>, const Quantity<U, S>& x,
                                                        const Quantity<U, S>& y, const Quantity<U, S>& z) {
  const detail::Column<S> deviations{x.value(), y.value(), z.value()};
  detail::require_deviations<F>(deviations);
  return {detail::trusted, detail::Square<S>(deviations.cwiseAbs2().asDiagonal())};
}
template <class F, class X, class Y, class Z, class UnitGiven = typename detail::UnitOf<X>::type>
auto covariance_from_standard_deviations(  // one SI vector unit for all: 1.0 * si::metre, or convert<U>()
    In<F>, const X&, const Y&, const Z&) -> Refused = delete;

// P^b = R_a^b P^a (R_a^b)^T
template <class B, class A, class U, class S>
Covariance<B, U, S> product(const Dcm<B, A, S>& R_b_from_a, const Covariance<A, U, S>& P_a) {
  return {detail::trusted, R_b_from_a.matrix() * P_a.matrix() * R_b_from_a.matrix().transpose()};
}

// cov(r + s) = P + Q for independent r and s
template <class F, class U, class S>
Covariance<F, U, S> sum(const Covariance<F, U, S>& P_a, const Covariance<F, U, S>& Q_a) {
  return {detail::trusted, P_a.matrix() + Q_a.matrix()};
}

/// n^T P n: the variance of the component along the direction n. Throws BadInput when |n| differs from 1 by
/// more than orthonormality_tolerance.
template <class F, class U, class S>
Quantity<unit_product<U, U>, S> variance_along(const Covariance<F, U, S>& P_a,
                                               const Vector<F, si::dimensionless, S>& n_a) {
  const S length = n_a.coordinates().norm();
  const S tolerance = detail::number<S>(detail::door_tolerance<S>(orthonormality_tolerance));
  if (!detail::all(length - S(1) <= tolerance && S(1) - length <= tolerance)) {
    throw BadInput("variance_along(covariance in " + frame_name<F>() + "): |n| is " + detail::text(length) +
                   "; direction() has length 1");
  }
  return Quantity<unit_product<U, U>, S>::from_value(n_a.coordinates().dot(P_a.matrix() * n_a.coordinates()));
}
template <class CovarianceIn, class DirectionIn, class U, class UnitGiven, class S>
  requires(!(std::same_as<CovarianceIn, DirectionIn> && std::same_as<UnitGiven, si::dimensionless>))
auto variance_along(  // variance_along(P_a, n_a): one frame; n is a direction
    const Covariance<CovarianceIn, U, S>&, const Vector<DirectionIn, UnitGiven, S>&) -> Refused = delete;

/// The Mahalanobis distance sqrt(r^T P^-1 r): the length of r in standard deviations. Throws BadInput when P
/// is singular to rounding.
template <class F, class U, class S>
Quantity<si::dimensionless, S> mahalanobis_distance(const Covariance<F, U, S>& P_a,
                                                    const Vector<F, U, S>& r_a) {
  return Quantity<si::dimensionless, S>::from_value(
      detail::mahalanobis<F, S>(P_a.matrix(), r_a.coordinates()));
}
template <class CovarianceIn, class CovarianceUnit, class VectorIn, class UnitGiven, class S>
  requires(!(std::same_as<CovarianceIn, VectorIn> && std::same_as<CovarianceUnit, UnitGiven>))
auto mahalanobis_distance(  // mahalanobis_distance(P_a, r_a): one frame, one unit
    const Covariance<CovarianceIn, CovarianceUnit, S>&, const Vector<VectorIn, UnitGiven, S>&)
    -> Refused = delete;

/// [4 0 0; 0 4 0; 0 0 9] (m/s)^2 in Body
template <class F, class U, class S>
std::ostream& print_framed(std::ostream& out, const Covariance<F, U, S>& P_a) {
  return detail::print_square(out, P_a.matrix()) << detail::print_squared<U> << " in " << frame_name<F>();
}

}  // namespace vectrix
