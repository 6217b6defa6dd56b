#pragma once

#include <vectrix/frames/transform.hpp>
#include <vectrix/kinematics/named/dcm_doors.hpp>
#include <vectrix/kinematics/named/transform.hpp>

namespace vectrix {
namespace detail {

template <class Derived>
concept Matrix4x4d = Matrix4x4<Derived> && std::same_as<typename Derived::Scalar, double>;

template <class Typed>
NamedTransform named_transform(std::string_view door, NamedFrame b, NamedFrame a, const Typed& typed) {
  return through_door(door, b, a, [&] {
    const auto X = typed(vectrix::to<Some<'b'>>, vectrix::from<Some<'a'>>);
    return NamedTransform{trusted, {trusted, b, a, X.rotation.matrix()}, X.translation.coordinates()};
  });
}

}  // namespace detail

// The doors of Transform for frames known at run time, with the same checks and errors.

/// Checked: throws BadInput when the last row is not 0 0 0 1, the translation is not finite, or the rotation
/// does not pass dcm(). Lengths in metres.
template <detail::Matrix4x4d Matrix>
NamedTransform transform(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  return detail::named_transform("transform", b.frame, a.frame,
                                 [&](auto to_b, auto from_a) { return transform(to_b, from_a, matrix); });
}

struct NearestNamedTransform {
  NamedTransform transform;
  /// How far the rotation moved, as in NearestNamedDcm.
  double distance;
};

/// Projected: keeps the translation and takes the rotation by nearest_dcm().
template <detail::Matrix4x4d Matrix>
NearestNamedTransform nearest_transform(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  double distance = 0.0;
  const NamedTransform nearest =
      detail::named_transform("nearest_transform", b.frame, a.frame, [&](auto to_b, auto from_a) {
        const auto found = nearest_transform(to_b, from_a, matrix);
        distance = found.distance;
        return found.transform;
      });
  return {nearest, distance};
}

/// Trusted: does not check the matrix.
template <detail::Matrix4x4d Matrix>
NamedTransform trust_transform(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  return detail::named_transform("trust_transform", b.frame, a.frame, [&](auto to_b, auto from_a) {
    return trust_transform(to_b, from_a, matrix);
  });
}

/// The bare homogeneous matrix [R_a^b, r_ba^b; 0 0 0 1], lengths in metres.
inline Eigen::Matrix4d homogeneous_matrix(const NamedTransform& X_b_from_a) {
  using namespace detail;
  const Displacement<Some<'b'>, Some<'a'>, In<Some<'b'>>> r_ba_b{trusted,
                                                                 X_b_from_a.translation().coordinates()};
  return homogeneous_matrix(Transform<Some<'b'>, Some<'a'>>{
      Dcm<Some<'b'>, Some<'a'>>{trusted, X_b_from_a.rotation().matrix()}, r_ba_b});
}

}  // namespace vectrix
