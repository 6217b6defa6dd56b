#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {

/// G^c, of type GravityGradient<C>: the derivative of the gravitational acceleration by the position, a
/// symmetric tensor without trace, expressed in c, 1/s^2.
///     1.  g(r + d)^c = g(r)^c + G^c d^c + ...      G_c * d_c
///     2.  G^d = R_c^d G^c (R_c^d)^T                R_d_from_c * G_c
template <Frame C> class GravityGradient {
 public:
  using expressed = C;

  GravityGradient(detail::Trusted, const detail::Square<double>& tensor) : tensor_(tensor) {}

  /// The entries, 1/s^2, without types.
  const detail::Square<double>& matrix() const& { return tensor_; }
  detail::Square<double> matrix() && { return tensor_; }

 private:
  detail::Square<double> tensor_;
};

template <class C> inline constexpr bool detail::is_framed<GravityGradient<C>> = true;

// g(r + d) - g(r) = G d
template <class C>
Vector<C, si::acceleration> product(const GravityGradient<C>& G_c, const Vector<C, si::length>& d_c) {
  return {detail::trusted, G_c.matrix() * d_c.coordinates()};
}
// G^d = R_c^d G^c (R_c^d)^T
template <class D, class C>
GravityGradient<D> product(const Dcm<D, C>& R_d_from_c, const GravityGradient<C>& G_c) {
  return {detail::trusted, R_d_from_c.matrix() * G_c.matrix() * R_d_from_c.matrix().transpose()};
}

template <class C> std::ostream& print_framed(std::ostream& out, const GravityGradient<C>& G_c) {
  return detail::print_square(out, G_c.matrix()) << " 1/s^2 in " << frame_name<C>();
}

}  // namespace vectrix
