#pragma once

#include <cmath>
#include <numbers>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/frames/scalar/sine_cosine.hpp>
#include <vectrix/kinematics/attitude/parameters.hpp>

namespace vectrix {

/// theta_ab, of type RotationVector<A, B>: angle times axis, rad. Turning a by it gives b. Its coordinates
/// are the same in a and in b, because those of the axis are. exp(theta_ab) is R_a_from_b.
template <Frame A, Frame B, class S = double>
class RotationVector : public detail::AttitudeParameters<RotationVector<A, B, S>, A, B, S, 3> {
 public:
  using detail::AttitudeParameters<RotationVector<A, B, S>, A, B, S, 3>::AttitudeParameters;

  /// The angle |theta|, and the vector expressed in a or in b.
  Quantity<si::angle, S> angle() const {
    return Quantity<si::angle, S>::from_value(detail::scaled_norm(this->coordinates()));
  }
  /// The distance of |theta| from the nearest non-zero whole number of turns.
  Quantity<si::angle, S> distance_from_singularity() const {
    using std::abs;
    const S size = detail::scaled_norm(this->coordinates());
    const auto [sine, cosine] = detail::sine_cosine(size);
    const S full = detail::number<S>(2 * std::numbers::pi);
    return Quantity<si::angle, S>::from_value(
        detail::select<S>(size < full / S(2), S(full - size), detail::arc_tangent(S(abs(sine)), cosine)));
  }
  Vector<A, si::angle, S> in_reference() const { return {detail::trusted, this->coordinates()}; }
  Vector<B, si::angle, S> in_turned() const { return {detail::trusted, this->coordinates()}; }

  /// theta_ba = -theta_ab
  RotationVector<B, A, S> operator-() const { return {detail::trusted, -this->coordinates()}; }

  static const char* name() { return "rotation vector"; }
  static const char* singularity() { return "a full turn"; }
  static const char* unit_symbol(int derivative) {
    return derivative == 0 ? "rad" : derivative == 1 ? "rad/s" : "rad/s^2";
  }
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<RotationVector<A, B, S>> = true;

/// Claims that turning a by the vector gives b; the vector may be expressed in either.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, RotationVector<A, B, S>> rotation_vector(Of<B>, RelativeTo<A>,
                                                             const Vector<C, si::angle, S>& theta) {
  return {detail::trusted, theta.coordinates()};
}
template <class OfFrame, class RelativeFrame, class VectorIn, class UnitGiven, class S>
  requires(std::same_as<OfFrame, RelativeFrame> || !detail::is_one_of<VectorIn, OfFrame, RelativeFrame> ||
           !std::same_as<UnitGiven, si::angle>)
auto rotation_vector(  // an angle between two frames, expressed in one of them
    Of<OfFrame>, RelativeTo<RelativeFrame>, const Vector<VectorIn, UnitGiven, S>&) -> Refused = delete;

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const RotationVector<A, B, S>& theta_ab) {
  return detail::print_column(out, theta_ab.coordinates(), "rad") << detail::print_of_relative_to<B, A>;
}

}  // namespace vectrix
