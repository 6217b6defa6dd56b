#pragma once

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/graph/level.hpp>

namespace vectrix {

/// X_a^b, `X_b_from_a`, of type Transform<B, A>: the rotation R_a^b and the position r_ba^b, m, of a's origin
/// relative to b's. It takes positions relative to a's origin to positions relative to b's:
///     1.  r_bq^b = R_a^b r_aq^a + r_ba^b      X_b_from_a * r_aq_a
///     2.  X_a^c = X_b^c X_a^b                 X_c_from_b * X_b_from_a
///     3.  X_b^a = (X_a^b)^-1                  inverse(X_b_from_a)
/// Any pair is valid, so it is an aggregate: Transform{R_b_from_a, r_ba_b}. transform() makes it from a
/// matrix.
template <Frame B, Frame A, class S = double> struct Transform {
  Dcm<B, A, S> rotation;
  Displacement<B, A, In<B>, S> translation;
};
// The rotation gives the frames. A translation of other frames is refused by its type.
template <class B, class A, class S, class Translation>
Transform(const Dcm<B, A, S>&, const Translation&) -> Transform<B, A, S>;

template <class B, class A, class S> inline constexpr bool detail::is_framed<Transform<B, A, S>> = true;
template <class B, class A, class S>
struct QuestionOf<Transform<B, A, S>> : std::type_identity<AskTransform<B, A>> {};

// r_bq^b = R_a^b r_aq^a + r_ba^b
template <class B, class A, class Q, class S>
Displacement<B, Q, In<B>, S> product(const Transform<B, A, S>& X_b_from_a,
                                     const Displacement<A, Q, In<A>, S>& r_aq_a) {
  return Displacement<B, Q, In<B>, S>{detail::trusted, X_b_from_a.rotation.matrix() * r_aq_a.coordinates() +
                                                           X_b_from_a.translation.coordinates()};
}
// X_a^c = X_b^c X_a^b
template <class C, class B, class A, class S>
Transform<C, A, S> product(const Transform<C, B, S>& X_c_from_b, const Transform<B, A, S>& X_b_from_a) {
  return {detail::composed(X_c_from_b.rotation, X_b_from_a.rotation), X_c_from_b * X_b_from_a.translation};
}
// r_ab^a = -R_b^a r_ba^b
template <class B, class A, class S> Transform<A, B, S> inverse(const Transform<B, A, S>& X_b_from_a) {
  return {inverse(X_b_from_a.rotation),
          Displacement<A, B, In<A>, S>{detail::trusted, -(X_b_from_a.rotation.matrix().transpose() *
                                                          X_b_from_a.translation.coordinates())}};
}

/// The bare homogeneous matrix [R_a^b, r_ba^b; 0 0 0 1], lengths in metres. The frames are no longer checked.
template <class B, class A, class S>
Eigen::Matrix<S, 4, 4> homogeneous_matrix(const Transform<B, A, S>& X_b_from_a) {
  Eigen::Matrix<S, 4, 4> matrix = Eigen::Matrix<S, 4, 4>::Identity();
  matrix.template topLeftCorner<3, 3>() = X_b_from_a.rotation.matrix();
  matrix.template topRightCorner<3, 1>() = X_b_from_a.translation.coordinates();
  return matrix;
}

namespace detail {

template <class M>
concept Matrix4x4 = std::is_base_of_v<Eigen::MatrixBase<M>, M> && M::RowsAtCompileTime == 4 &&
                    M::ColsAtCompileTime == 4 && !std::is_integral_v<typename M::Scalar>;

template <class B, class A, class S>
Displacement<B, A, In<B>, S> checked_translation(const char* door, const Eigen::Matrix<S, 4, 4>& matrix) {
  const auto refuse = [&](const std::string& why) { throw BadInput(dcm_door<B, A>(door) + why); };
  for (Eigen::Index i = 0; i < 4; ++i) {
    const S expected = i == 3 ? S(1) : S(0);
    if (!all(matrix(3, i) == expected)) {
      refuse("entry (4, " + text(i + 1) + ") is " + text(matrix(3, i)) + " instead of " + text(expected));
    }
  }
  const Column<S> r = matrix.template topRightCorner<3, 1>();
  if (!all_finite(r)) {
    refuse("the translation (" + text(r.x()) + ", " + text(r.y()) + ", " + text(r.z()) + ") is not finite");
  }
  return Displacement<B, A, In<B>, S>{trusted, r};
}

}  // namespace detail

/// The checked door for a homogeneous matrix, lengths in metres. Throws BadInput when its last row is not
/// 0 0 0 1, the translation is not finite, or the rotation does not pass dcm().
template <Frame B, Frame A, detail::Matrix4x4 Matrix>
detail::OfTwo<B, A, Transform<B, A, typename Matrix::Scalar>> transform(To<B>, From<A>,
                                                                        const Matrix& matrix) {
  using S = typename Matrix::Scalar;
  const Eigen::Matrix<S, 4, 4> entries = matrix;
  const auto r_ba_b = detail::checked_translation<B, A, S>("transform", entries);
  return Transform<B, A, S>{dcm(to<B>, from<A>, entries.template topLeftCorner<3, 3>()), r_ba_b};
}
template <class ToFrame, class FromFrame, class Given>
auto transform(  // to<B>, from<A>: two frames; a 4x4 matrix
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

template <class B, class A, class S = double> struct NearestTransform {
  Transform<B, A, S> transform;
  S distance;  // how far the rotation moved, as in NearestDcm
};

/// The projected door: keeps the translation and takes the rotation by nearest_dcm(). Throws BadInput as
/// transform() does for the last row and the translation, and as nearest_dcm().
template <Frame B, Frame A, detail::Matrix4x4 Matrix>
detail::OfTwo<B, A, NearestTransform<B, A, typename Matrix::Scalar>> nearest_transform(To<B>, From<A>,
                                                                                       const Matrix& matrix) {
  using S = typename Matrix::Scalar;
  const Eigen::Matrix<S, 4, 4> entries = matrix;
  const auto r_ba_b = detail::checked_translation<B, A, S>("nearest_transform", entries);
  const auto nearest = nearest_dcm(to<B>, from<A>, entries.template topLeftCorner<3, 3>());
  return NearestTransform<B, A, S>{{nearest.dcm, r_ba_b}, nearest.distance};
}
template <class ToFrame, class FromFrame, class Given>
auto nearest_transform(  // to<B>, from<A>: two frames; a 4x4 matrix
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

/// The trusted door: checks nothing.
template <Frame B, Frame A, detail::Matrix4x4 Matrix>
detail::OfTwo<B, A, Transform<B, A, typename Matrix::Scalar>> trust_transform(To<B>, From<A>,
                                                                              const Matrix& matrix) {
  using S = typename Matrix::Scalar;
  return Transform<B, A, S>{
      Dcm<B, A, S>{detail::trusted, matrix.template topLeftCorner<3, 3>()},
      Displacement<B, A, In<B>, S>{detail::trusted, matrix.template topRightCorner<3, 1>()}};
}
template <class ToFrame, class FromFrame, class Given>
auto trust_transform(  // to<B>, from<A>: two frames; a 4x4 matrix
    const ToFrame&, const FromFrame&, const Given&) -> Refused = delete;

template <class A, class B, class S>
struct LevelOf<Transform<A, B, S>> : detail::PlacedLevel<A, B, S, Level::rotation> {};
template <class A, class B, class S> const Dcm<A, B, S>& rotation_of(const Transform<A, B, S>& X_a_from_b) {
  return X_a_from_b.rotation;
}
/// The rotation and the position, without their motion.
template <class A, class B, class S> const Transform<A, B, S>& transform_of(const Transform<A, B, S>& value) {
  return value;
}

template <class B, class A, class S>
std::ostream& print_framed(std::ostream& out, const Transform<B, A, S>& X_b_from_a) {
  return out << X_b_from_a.rotation << "; " << X_b_from_a.translation;
}

}  // namespace vectrix
