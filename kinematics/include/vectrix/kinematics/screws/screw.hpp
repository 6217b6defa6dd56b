#pragma once

#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/jacobian.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/screws/twist.hpp>

namespace vectrix {

/// xi_ab = (theta_ab, rho), of type Screw<A, B>: the twist times the time of a steady motion that takes b
/// from coincidence with a to b. It is to a Transform what a RotationVector is to a Dcm:
///     1.  X_b^a = exp(xi_ab):  R_b^a = exp([theta]x),  r_ab^a = J_l(theta) rho
///     2.  xi_ba = -xi_ab
///     3.  xi_ab = Ad(X_b^a) xi_ab
/// By law 3 rho, m, has the same coordinates in a and in b: in a it is the velocity, times the time, of the
/// particle at a's origin, in b that of b's origin. Screws do not add; their transforms multiply.
template <Frame A, Frame B, class S = double> class Screw {
 public:
  using reference = A;
  using turned = B;
  using scalar = S;

  template <class Rotation, class Translation>
  Screw(detail::Trusted, const Eigen::MatrixBase<Rotation>& theta, const Eigen::MatrixBase<Translation>& rho)
      : theta_(detail::trusted, theta), rho_(rho) {}

  const RotationVector<A, B, S>& rotation_vector() const& { return theta_; }
  RotationVector<A, B, S> rotation_vector() && { return theta_; }
  /// rho expressed in a or in b.
  Vector<A, si::length, S> in_reference() const { return {detail::trusted, rho_}; }
  Vector<B, si::length, S> in_turned() const { return {detail::trusted, rho_}; }
  /// The six bare numbers, the rotation first.
  Eigen::Matrix<S, 6, 1> coordinates() const {
    Eigen::Matrix<S, 6, 1> numbers;
    numbers << theta_.coordinates(), rho_;
    return numbers;
  }

  /// xi_ba = -xi_ab
  Screw<B, A, S> operator-() const { return {detail::trusted, -theta_.coordinates(), -rho_}; }

  static const char* name() { return "screw"; }
  static const char* singularity() { return "a full turn"; }

 private:
  RotationVector<A, B, S> theta_;
  detail::Column<S> rho_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<Screw<A, B, S>> = true;

/// Claims that theta and rho are xi_ab, both expressed in a or both in b.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, Screw<A, B, S>> screw(Of<B>, RelativeTo<A>, const Vector<C, si::angle, S>& theta,
                                          const Vector<C, si::length, S>& rho) {
  return {detail::trusted, theta.coordinates(), rho.coordinates()};
}
template <class OfFrame, class RelativeToFrame, class Rotation, class Translation>
auto screw(  // of<B>, relative_to<A>: two frames; an angle and a length expressed in one of them
    const OfFrame&, const RelativeToFrame&, const Rotation&, const Translation&) -> Refused = delete;

namespace detail {

template <class X, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_motion(const Column<S>& r, const char* action) {
  throw BadInput(parameters_name<X>(action) + "(" + text(r.x()) + ", " + text(r.y()) + ", " + text(r.z()) +
                 ") is not finite");
}
template <class X, class S> const Column<S>& finite_motion(const Column<S>& r, const char* action) {
  if (!all_finite(r)) refuse_motion<X>(r, action);
  return r;
}

}  // namespace detail

/// exp: X_b^a, from the series of the skew matrix, r_ab^a = (I + c_2 [theta]x + c_3 ([theta]x)^2) rho.
/// With theta = w t and rho = v t this equals
///     r = (I - R) (w x v)/|w|^2 + w (w . v) t/|w|^2,
/// but without division by |w|: accurate to rounding from pure translation to any angle.
/// Throws BadInput when |theta|^2 or the translation overflows.
template <class A, class B, class S> Transform<A, B, S> exp(const Screw<A, B, S>& xi_ab) {
  using X = Screw<A, B, S>;
  const auto turn = detail::turn<X>(xi_ab.rotation_vector().coordinates(), "exp");
  const detail::Column<S> r_ab_a = detail::left_jacobian_times(turn, xi_ab.in_reference().coordinates());
  return {exp(xi_ab.rotation_vector()),
          Displacement<A, B, In<A>, S>{detail::trusted, detail::finite_motion<X>(r_ab_a, "exp")}};
}

/// log: the screw of the shortest turn, |theta| <= pi, theta = log(R_b^a) and rho = J_l^-1(theta) r_ab^a,
/// with exp(xi_ab) = X_a_from_b. Accurate to rounding, as the log of a Dcm, which also chooses the axis at
/// pi.
template <class A, class B, class S> Screw<A, B, S> log(const Transform<A, B, S>& X_a_from_b) {
  const RotationVector<A, B, S> theta_ab = log(X_a_from_b.rotation);
  const auto turn = detail::turn<Screw<A, B, S>>(theta_ab.coordinates(), "log");
  return {detail::trusted, theta_ab.coordinates(),
          detail::inverse_left_jacobian_times(turn, X_a_from_b.translation.coordinates())};
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const Screw<A, B, S>& xi_ab) {
  const auto xi = xi_ab.coordinates();
  detail::print_column(out, xi.template head<3>(), "rad") << "; ";
  return detail::print_column(out, xi.template tail<3>(), "m") << detail::print_of_relative_to<B, A>;
}

}  // namespace vectrix
