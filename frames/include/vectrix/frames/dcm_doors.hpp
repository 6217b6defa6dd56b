#pragma once

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vectrix/frames/dcm_chain.hpp>
#include <vectrix/frames/scalar/sine_cosine.hpp>

namespace vectrix {

/// Largest entry of |M^T M - I| that `dcm()` accepts. Rotations printed with ten digits or more pass; for
/// fewer digits use nearest_dcm(), which returns how far it moved the matrix.
inline constexpr double orthonormality_tolerance = 1e-9;

/// Largest | |q| - 1 | of a quaternion, and of an axis, that the checked doors accept; numbers printed with
/// ten digits pass. At |q| = 1 + d the entries of M^T M - I are up to 8 d, and rounding: what one door
/// accepts, the other accepts converted. Numbers of a product have the errors of all its factors: take them
/// through a nearest_ door.
inline constexpr double unit_norm_tolerance = 1.2e-10;

/// Smallest determinant, relative to the cube of the largest entry, of a matrix that nearest_dcm() accepts.
inline constexpr double nearly_singular = 1e-12;

namespace detail {

[[gnu::cold]] inline std::string dcm_door(const char* door, const std::string& b, const std::string& a) {
  return std::string{door} + "(to<" + b + ">, from<" + a + ">): ";
}
template <class B, class A> std::string dcm_door(const char* door) {
  return dcm_door(door, frame_name<B>(), frame_name<A>());
}

template <class B, class A, class S> void require_finite(const Square<S>& matrix, const char* door) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      const S entry = matrix(row, column);
      if (!all(entry - entry == S(0))) {
        throw BadInput(dcm_door<B, A>(door) + "entry (" + text(row + 1) + ", " + text(column + 1) + ") is " +
                       text(entry));
      }
    }
  }
}

template <class B, class A, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_left_handed(const S& determinant, const char* door) {
  throw BadInput(dcm_door<B, A>(door) + "the determinant is " + text(determinant) +
                 "; a rotation is right-handed");
}

template <class B, class A, class S> Dcm<B, A, S> checked_dcm(const Square<S>& entries, const char* door) {
  require_finite<B, A>(entries, door);
  const S error = (entries.transpose() * entries - Square<S>::Identity()).cwiseAbs().maxCoeff();
  const double tolerance =
      std::max(orthonormality_tolerance, 9 * door_tolerance<S>(0.0));  // 8 of a norm, 1 of rounding
  if (!all(error <= number<S>(tolerance))) {
    throw BadInput(dcm_door<B, A>(door) + "M^T M differs from the identity by " + text(error) +
                   ", tolerance " + text(tolerance) + "; nearest_dcm() projects");
  }
  if (const S determinant = entries.determinant(); !all(determinant > S(0))) {
    refuse_left_handed<B, A>(determinant, door);
  }
  return Dcm<B, A, S>{trusted, entries};
}

}  // namespace detail

/// The checked door: claims that `matrix` takes coordinates in a to coordinates in b. The entries are kept as
/// given; see DcmChain for products.
/// Throws BadInput when an entry is not finite, when M^T M differs from I by more than
/// orthonormality_tolerance, or when the determinant is not positive.
template <Frame B, Frame A, detail::Matrix3x3 Matrix>
detail::OfTwo<B, A, Dcm<B, A, typename Matrix::Scalar>> dcm(To<B>, From<A>, const Matrix& matrix) {
  detail::require_size(matrix, 3, 3, [] { return detail::dcm_door<B, A>("dcm"); });
  return detail::checked_dcm<B, A, typename Matrix::Scalar>(matrix, "dcm");
}
template <class ToFrame, class FromFrame, class Given>
auto dcm(  // to<B>, from<A>: two frames; a 3x3 matrix
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

template <class B, class A, class S> struct NearestDcm {
  Dcm<B, A, S> dcm;
  /// Frobenius norm of the change.
  S distance;
};

namespace detail {

template <class B, class A, class S> NearestDcm<B, A, S> nearest(const Square<S>& entries) {
  require_finite<B, A>(entries, "nearest_dcm");
  // Scaled by the largest entry, so that the determinant does not underflow or overflow.
  const S largest = entries.cwiseAbs().maxCoeff();
  const Square<S> scaled = largest > S(0) ? Square<S>(entries / largest) : entries;
  const S determinant = scaled.determinant();
  const S singular = S(door_tolerance<S>(nearly_singular));
  if (!(determinant > singular || determinant < -singular)) {
    throw BadInput(dcm_door<B, A>("nearest_dcm") + "the determinant is " + text(determinant) +
                   " times the cube of the largest entry; no rotation is nearest to a singular matrix");
  }
  if (determinant < S(0)) refuse_left_handed<B, A>(S(entries.determinant()), "nearest_dcm");
  const Eigen::JacobiSVD<Square<S>> svd(scaled, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Square<S> rotation = svd.matrixU() * svd.matrixV().transpose();
  const Square<S> correction = rotation - entries;
  return {Dcm<B, A, S>{trusted, rotation}, scaled_norm(correction)};
}
/// The decomposition branches, so it takes one lane after the other.
template <class B, class A, Batch S> NearestDcm<B, A, S> nearest(const Square<S>& entries) {
  Square<S> rotation;
  S distance;
  for (std::size_t i = 0; i < S::size(); ++i) {
    const auto one = nearest<B, A, typename S::value_type>(lane(entries, i));
    for (Eigen::Index k = 0; k < 9; ++k) rotation.data()[k][i] = one.dcm.matrix().data()[k];
    distance[i] = one.distance;
  }
  return {Dcm<B, A, S>{trusted, rotation}, distance};
}

}  // namespace detail

/// The projected door: the rotation nearest to `matrix` in the Frobenius norm, and its distance.
///     M = U Sigma V^T  ->  R = U V^T       (polar factor; Higham, Functions of Matrices, theorem 8.4)
/// Throws BadInput when an entry is not finite, the matrix is left-handed, or it is singular to rounding.
/// Numbers with derivatives do not compile: the iteration stops when the values have converged, before the
/// derivatives have.
template <Frame B, Frame A, detail::Matrix3x3 Matrix>
  requires(!detail::Differentiated<typename Matrix::Scalar>)
detail::OfTwo<B, A, NearestDcm<B, A, typename Matrix::Scalar>> nearest_dcm(To<B>, From<A>,
                                                                           const Matrix& matrix) {
  detail::require_size(matrix, 3, 3, [] { return detail::dcm_door<B, A>("nearest_dcm"); });
  return detail::nearest<B, A, typename Matrix::Scalar>(matrix);
}
template <class ToFrame, class FromFrame, class Given>
auto nearest_dcm(  // to<B>, from<A>: two frames; a 3x3 matrix, without derivatives
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

/// The trusted door: checks no number. The caller guarantees a rotation matrix that takes a to b.
template <Frame B, Frame A, detail::Matrix3x3 Matrix>
detail::OfTwo<B, A, Dcm<B, A, typename Matrix::Scalar>> trust_dcm(To<B>, From<A>, const Matrix& matrix) {
  detail::require_size(matrix, 3, 3, [] { return detail::dcm_door<B, A>("trust_dcm"); });
  return Dcm<B, A, typename Matrix::Scalar>{detail::trusted, matrix};
}
/// The same for the result of make(), an Eigen::Matrix<S, 3, 3>. It is built in the Dcm, not copied.
///     trust_dcm(to<B>, from<A>, [&] { return spin(angle); })
template <Frame B, Frame A, std::invocable Make>
  requires detail::Matrix3x3<std::invoke_result_t<const Make&>>
      detail::OfTwo<B, A, Dcm<B, A, typename std::invoke_result_t<const Make&>::Scalar>> trust_dcm(
          To<B>, From<A>, const Make& make) {
    return Dcm<B, A, typename std::invoke_result_t<const Make&>::Scalar>{detail::trusted, make};
  }
template <class ToFrame, class FromFrame, class Given>
auto trust_dcm(  // to<B>, from<A>: two frames; a 3x3 matrix
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

/// Claims that the axes of a and b are parallel.
template <class S = double, Frame B, Frame A> detail::OfTwo<B, A, Dcm<B, A, S>> aligned(To<B>, From<A>) {
  return {detail::trusted, detail::Square<S>::Identity()};
}
template <class S = double, class ToFrame, class FromFrame>
auto aligned(const ToFrame&, const FromFrame&) -> Refused = delete;  // to<B>, from<A>: two frames

namespace detail {

template <class B, class A, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_angle(const char* door, S theta) {
  throw BadInput(dcm_door<B, A>(door) + "the angle is " + text(theta));
}

template <Eigen::Index axis, class B, class A, class S>
Dcm<B, A, S> turned(const char* door, const Quantity<si::angle, S>& angle) {
  const S theta = angle.value();
  const auto turn = sine_cosine(theta);
  const S s = turn.sine, c = turn.cosine;
  if (!all(c == c)) {  // the cosine of an infinity is NaN
    refuse_angle<B, A>(door, theta);
  }
  return {trusted, [&] {
            constexpr Eigen::Index next = (axis + 1) % 3;
            constexpr Eigen::Index last = (axis + 2) % 3;
            Square<S> matrix = Square<S>::Identity();
            matrix(next, next) = matrix(last, last) = c;
            matrix(next, last) = s;
            matrix(last, next) = -s;
            return matrix;
          }};
}

}  // namespace detail

/// R_b_from_a, where turning a by `angle` about its x axis (y, z) gives b. Any finite angle is valid.
///     turned_z: [cos sin 0; -sin cos 0; 0 0 1], the passive matrix; its inverse is the active one.
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Dcm<B, A, S>> turned_x(To<B>, From<A>, const Quantity<si::angle, S>& angle) {
  return detail::turned<0, B, A>("turned_x", angle);
}
template <class ToFrame, class FromFrame, class Given>
auto turned_x(  // to<B>, from<A>: two frames; an angle in rad
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Dcm<B, A, S>> turned_y(To<B>, From<A>, const Quantity<si::angle, S>& angle) {
  return detail::turned<1, B, A>("turned_y", angle);
}
template <class ToFrame, class FromFrame, class Given>
auto turned_y(  // to<B>, from<A>: two frames; an angle in rad
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Dcm<B, A, S>> turned_z(To<B>, From<A>, const Quantity<si::angle, S>& angle) {
  return detail::turned<2, B, A>("turned_z", angle);
}
template <class ToFrame, class FromFrame, class Given>
auto turned_z(  // to<B>, from<A>: two frames; an angle in rad
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

/// R_b_from_a from the basis vectors of b given in a: the rows of the matrix.
/// Throws BadInput, as dcm() does, when they are not an orthonormal right-handed triad.
template <Frame B, class A, class S>
detail::OfTwo<B, A, Dcm<B, A, S>> dcm_from_axes(To<B>, const Vector<A, si::dimensionless, S>& x_a,
                                                const Vector<A, si::dimensionless, S>& y_a,
                                                const Vector<A, si::dimensionless, S>& z_a) {
  detail::Square<S> rows;
  rows << x_a.coordinates().transpose(), y_a.coordinates().transpose(), z_a.coordinates().transpose();
  return detail::checked_dcm<B, A>(rows, "dcm_from_axes");
}
template <class ToFrame, class X, class Y, class Z>
auto dcm_from_axes(  // to<B>, x_a, y_a, z_a: two frames; directions
    const ToFrame&, const X&, const Y&, const Z&) -> Refused = delete;

}  // namespace vectrix
