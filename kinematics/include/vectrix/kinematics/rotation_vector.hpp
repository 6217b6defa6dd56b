#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {
namespace detail {

template <class C, class... Fs> inline constexpr bool is_one_of = (std::same_as<C, Fs> || ...);

}  // namespace detail

/// theta_ab, of type RotationVector<A, B>: angle times axis, rad. Turning a by it gives b; its coordinates
/// are the same in a and in b, because the axis is. exp(theta_ab) is R_a_from_b.
template <Frame A, Frame B, class S = double> class RotationVector {
 public:
  template <class Derived>
  RotationVector(detail::Trusted, const Eigen::MatrixBase<Derived>& coordinates)
      : coordinates_(coordinates) {}

  const detail::Column<S>& coordinates() const { return coordinates_; }
  /// The angle |theta|, and the vector expressed in a or in b.
  Quantity<si::angle, S> angle() const {
    return Quantity<si::angle, S>::from_value(detail::scaled_norm(coordinates_));
  }
  Vector<A, si::angle, S> in_reference() const { return {detail::trusted, coordinates_}; }
  Vector<B, si::angle, S> in_turned() const { return {detail::trusted, coordinates_}; }

 private:
  detail::Column<S> coordinates_;
};

/// Claims that turning a by the vector gives b; the vector may be expressed in either.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
RotationVector<A, B, S> rotation_vector(Of<B>, RelativeTo<A>, const Vector<C, si::angle, S>& theta) {
  return {detail::trusted, theta.coordinates()};
}
template <class OfFrame, class RelativeFrame, class VectorIn, class UnitGiven, class S>
  requires(!((std::same_as<VectorIn, OfFrame> ||
              std::same_as<VectorIn, RelativeFrame>)&&std::same_as<UnitGiven, si::angle>))
void rotation_vector(Of<OfFrame>, RelativeTo<RelativeFrame>,  // an angle, expressed in one of its two frames
                     const Vector<VectorIn, UnitGiven, S>&) = delete;

// theta_ba = -theta_ab
template <class A, class B, class S>
RotationVector<B, A, S> negative(const RotationVector<A, B, S>& theta_ab) {
  return {detail::trusted, -theta_ab.coordinates()};
}

}  // namespace vectrix
