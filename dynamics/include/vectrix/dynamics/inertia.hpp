#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <vectrix/kinematics/angular_acceleration.hpp>

namespace vectrix {

/// J_b: the inertia tensor of a rigid body about its centre of mass, in axes of the frame b fixed to it, kg
/// m^2.
///     J_b = [ Jxx Jxy Jxz; Jxy Jyy Jyz; Jxz Jyz Jzz ],  Jxx = int (y^2 + z^2) dm,  Jxy = - int x y dm
/// Made by inertia_from_tensor() or inertia_from_moments_and_products(), which differ in the sign of the
/// off-diagonal numbers; there is no default. Its principal moments are positive and satisfy J1 + J2 >= J3.
template <Frame B, class S = double> class Inertia {
 public:
  Inertia() = delete;  // inertia_from_tensor(in<B>, ...) or inertia_from_moments_and_products(in<B>, ...)
  Inertia(detail::Trusted, const detail::Square<S>& tensor)
      : tensor_(tensor), inverse_((tensor / tensor.trace()).inverse() / tensor.trace()) {}

  /// The entries of the tensor, kg m^2: the way out of the typed world; and the inverse tensor.
  const detail::Square<S>& matrix() const { return tensor_; }
  const detail::Square<S>& inverse_matrix() const { return inverse_; }

 private:
  detail::Square<S> tensor_;
  detail::Square<S> inverse_;
};

template <class B, class S> inline constexpr bool detail::is_framed<Inertia<B, S>> = true;

namespace detail {

/// Relative room for rounding in J1 + J2 >= J3, which a flat plate satisfies with equality, and in J1 > 0,
/// which the rounding of a thin rod's J1 = 0 must not pass.
template <class S> S moment_tolerance() {
  return S(std::max(1e-12, 16.0 * static_cast<double>(Eigen::NumTraits<S>::epsilon())));
}

template <class B, class S> Inertia<B, S> checked_inertia(const char* door, const Square<S>& tensor) {
  const std::string place = std::string{door} + "(in<" + frame_name<B>() + ">): ";
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = row; column < 3; ++column) {
      const S& entry = tensor(row, column);
      if (!(entry - entry == S(0))) {
        throw BadInput(place + "entry (" + text(row + 1) + ", " + text(column + 1) + ") of the tensor is " +
                       text(entry) + " kg m^2");
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Square<S>> solver(tensor, Eigen::EigenvaluesOnly);
  const Column<S> moments = solver.eigenvalues();  // in increasing order
  const std::string listed =
      "(" + text(moments(0)) + ", " + text(moments(1)) + ", " + text(moments(2)) + ") kg m^2";
  if (!(moments(0) > moment_tolerance<S>() * moments(2))) {
    throw BadInput(place + "the principal moments " + listed + " are not all positive");
  }
  const S excess = moments(2) - moments(0) - moments(1);
  if (!(excess <= moment_tolerance<S>() * moments(2))) {
    throw BadInput(place + "the largest principal moment of " + listed +
                   " exceeds the sum of the others by " + text(excess) + "; no body has this inertia");
  }
  const Inertia<B, S> inertia{trusted, tensor};
  if (!inertia.inverse_matrix().allFinite()) {
    throw BadInput(place + "the principal moments " + listed + " are too small to be divided by");
  }
  return inertia;
}

template <class S>
Square<S> symmetric(const S& xx, const S& yy, const S& zz, const S& xy, const S& xz, const S& yz) {
  Square<S> matrix;
  matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return matrix;
}

}  // namespace detail

/// From the entries of the tensor: Jxy = - int x y dm is given as it stands in the matrix.
/// Throws BadInput when an entry is not finite, a principal moment is not positive, or one exceeds the other
/// two.
template <Frame B, class S>
Inertia<B, S> inertia_from_tensor(In<B>, const Quantity<si::moment_of_inertia, S>& Jxx,
                                  const Quantity<si::moment_of_inertia, S>& Jyy,
                                  const Quantity<si::moment_of_inertia, S>& Jzz,
                                  const Quantity<si::moment_of_inertia, S>& Jxy,
                                  const Quantity<si::moment_of_inertia, S>& Jxz,
                                  const Quantity<si::moment_of_inertia, S>& Jyz) {
  return detail::checked_inertia<B, S>(
      "inertia_from_tensor",
      detail::symmetric(Jxx.value(), Jyy.value(), Jzz.value(), Jxy.value(), Jxz.value(), Jyz.value()));
}
template <class InFrame, class... Given>
auto inertia_from_tensor(  // in<B>, then six quantities in kg m^2: Jxx, Jyy, Jzz, ...
    const InFrame&, const Given&...) -> Refused = delete;

/// From moments and products of inertia, Pxy = + int x y dm: the tensor's off-diagonal entries are their
/// negatives. Throws BadInput as inertia_from_tensor().
template <Frame B, class S>
Inertia<B, S> inertia_from_moments_and_products(In<B>, const Quantity<si::moment_of_inertia, S>& Jxx,
                                                const Quantity<si::moment_of_inertia, S>& Jyy,
                                                const Quantity<si::moment_of_inertia, S>& Jzz,
                                                const Quantity<si::moment_of_inertia, S>& Pxy,
                                                const Quantity<si::moment_of_inertia, S>& Pxz,
                                                const Quantity<si::moment_of_inertia, S>& Pyz) {
  return detail::checked_inertia<B, S>(
      "inertia_from_moments_and_products",
      detail::symmetric<S>(Jxx.value(), Jyy.value(), Jzz.value(), -Pxy.value(), -Pxz.value(), -Pyz.value()));
}
template <class InFrame, class... Given>
auto inertia_from_moments_and_products(  // in<B>, then six quantities in kg m^2: Jxx, Jyy, Jzz, ...
    const InFrame&, const Given&...) -> Refused = delete;

/// The trusted door: no check at all. For a symmetric positive tensor that is no rigid body's, such as the
/// effective tensor of a body with rotors, which may break J1 + J2 >= J3.
template <Frame B, class Derived> auto trust_inertia(In<B>, const Eigen::MatrixBase<Derived>& tensor) {
  return Inertia<B, typename Derived::Scalar>{detail::trusted, tensor};
}

// h^b = J_b w_ab^b, the angular momentum about the centre of mass, relative to a.
template <class B, class A, class S>
Vector<B, si::angular_momentum, S> product(const Inertia<B, S>& J_b,
                                           const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  return {detail::trusted, J_b.matrix() * w_ab_b.coordinates()};
}
// J_b alpha_ab^b, the torque that the change of the rate takes, were there no gyroscopic one.
template <class B, class A, class S>
Vector<B, si::torque, S> product(const Inertia<B, S>& J_b,
                                 const AngularAcceleration<A, B, In<B>, S>& alpha_ab_b) {
  return {detail::trusted, J_b.matrix() * alpha_ab_b.coordinates()};
}

template <class B, class S> std::ostream& print_framed(std::ostream& out, const Inertia<B, S>& J_b) {
  return detail::print_square(out, J_b.matrix()) << " kg m^2 in " << frame_name<B>();
}

/// T = 1/2 w . J w, the rotational energy relative to a.
template <class B, class A, class S>
Quantity<si::energy, S> kinetic_energy(const Inertia<B, S>& J_b,
                                       const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  return dot(w_ab_b.vector(), J_b * w_ab_b) / S(2);
}

}  // namespace vectrix
