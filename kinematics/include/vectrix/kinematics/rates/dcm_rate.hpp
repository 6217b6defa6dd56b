#pragma once

#include <vectrix/kinematics/rates/angular_acceleration.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

namespace vectrix {
/// Rdot_b^a, `Rdot_a_from_b`, of type DcmRate<A, B>: the time derivative of R_b^a, 1/s. Not a rotation, and
/// not convertible to one.
template <Frame A, Frame B, class S = double> class DcmRate {
 public:
  template <class Derived>
  DcmRate(detail::Trusted, const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {}
  template <class First, class Second, class Third>
  DcmRate(detail::Trusted, const Eigen::MatrixBase<First>& first_column,
          const Eigen::MatrixBase<Second>& second_column, const Eigen::MatrixBase<Third>& third_column) {
    matrix_.col(0) = first_column;
    matrix_.col(1) = second_column;
    matrix_.col(2) = third_column;
  }

  const detail::Square<S>& matrix() const& { return matrix_; }
  detail::Square<S> matrix() && { return matrix_; }

 private:
  detail::Square<S> matrix_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<DcmRate<A, B, S>> = true;

// d/dt R_b^a = R_b^a [w_ab^b]x = [w_ab^a]x R_b^a
// always_inline: g++ otherwise calls these two dozen instructions as a function.
template <class A, class B, class S>
[[gnu::always_inline]] inline DcmRate<A, B, S> attitude_rate(const Dcm<A, B, S>& R_a_from_b,
                                                             const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  // The columns of R [w]x, without the zeros of [w]x.
  const auto& R = R_a_from_b.matrix();
  const S x = w_ab_b.coordinates().x();
  const S y = w_ab_b.coordinates().y();
  const S z = w_ab_b.coordinates().z();
  return {detail::trusted, R.col(1) * z - R.col(2) * y, R.col(2) * x - R.col(0) * z,
          R.col(0) * y - R.col(1) * x};
}
template <class A, class B, class S>
  requires(!std::same_as<A, B>)
inline DcmRate<A, B, S> attitude_rate(const Dcm<A, B, S>& R_a_from_b,
                                      const AngularVelocity<A, B, In<A>, S>& w_ab_a) {
  const auto& R = R_a_from_b.matrix();
  const auto& w = w_ab_a.coordinates();
  return {detail::trusted, w.cross(R.col(0)), w.cross(R.col(1)), w.cross(R.col(2))};
}
namespace detail {

template <class A, class B> std::string derivative_of(const char* action) {
  return std::string{action} + "(R to " + frame_name<A>() + " from " + frame_name<B>() + "): ";
}

}  // namespace detail

/// The checked door for a derivative given as a matrix: Rdot_b^a = R_b^a [w]x for some w.
/// Throws BadInput when the matrix is not finite, or R^T Rdot is not skew (see vee()).
template <class A, class B, class Derived, class S>
DcmRate<A, B, S> dcm_rate(const Dcm<A, B, S>& R_a_from_b, const Eigen::MatrixBase<Derived>& matrix) {
  const detail::Square<S> given = matrix;
  const std::string place = detail::derivative_of<A, B>("dcm_rate");
  if (!detail::all_finite(given)) throw BadInput(place + detail::not_finite(given));
  detail::vee_of<S>(R_a_from_b.matrix().transpose() * given, [&] { return place + "of R^T times it "; });
  return {detail::trusted, matrix};
}

// w_ab^b = vee(R^T Rdot) in b, w_ab^a = vee(Rdot R^T) in a, by angular_velocity_from(R_a_from_b,
// Rdot_a_from_b, in<B>).
template <class A, class B, class S, class C>
  requires(std::same_as<C, A> || std::same_as<C, B>)
AngularVelocity<A, B, In<C>, S> attitude_velocity(const Dcm<A, B, S>& R_a_from_b,
                                                  const DcmRate<A, B, S>& Rdot_a_from_b, In<C>) {
  const auto& R = R_a_from_b.matrix();
  const auto& Rdot = Rdot_a_from_b.matrix();
  const auto place = [] {
    return detail::derivative_of<A, B>("angular_velocity_from") + "of R^T times the rate ";
  };
  const detail::Column<S> w = std::same_as<C, B> ? detail::vee_of<S>(R.transpose() * Rdot, place)
                                                 : detail::vee_of<S>(Rdot * R.transpose(), place);
  return AngularVelocity<A, B, In<C>, S>{detail::trusted,
                                         vector<si::angular_velocity>(in<C>, w).coordinates()};
}

// Rdot_b^a r^b, the part of d/dt (R_b^a r^b) due to the rotation of b.
template <class A, class B, class U, class S>
Vector<A, unit_of_vector_quotient<U, si::time>, S> product(const DcmRate<A, B, S>& Rdot_a_from_b,
                                                           const Vector<B, U, S>& r_b) {
  return {detail::trusted, Rdot_a_from_b.matrix() * r_b.coordinates()};
}

namespace detail {

/// Throws BadInput unless the symmetric part of R^T Rddot is [w]x^2. The skew part may be any angular
/// acceleration.
template <class A, class B, class S> void require_centripetal(const Square<S>& turn, const Square<S>& w) {
  const double tolerance = door_tolerance<S>(1e-9);
  if (!all_finite(turn)) {
    throw BadInput("second derivative of R(" + frame_name<A>() + " from " + frame_name<B>() +
                   "): of R^T times it " + not_finite(turn));
  }
  const Square<S> apart = (turn + turn.transpose()) / S(2) - w * w;
  const S error = apart.cwiseAbs().maxCoeff();
  const S largest = turn.cwiseAbs().maxCoeff();
  if (!all(error <= number<S>(tolerance) * largest)) {
    throw BadInput("second derivative of R(" + frame_name<A>() + " from " + frame_name<B>() +
                   "): the symmetric part of R^T Rddot differs from [w]x^2 by " + text(error) +
                   " beside entries of " + text(largest) + "; it is not one at this rate");
  }
}

}  // namespace detail

/// Rddot_b^a, `Rddot_a_from_b`: the second time derivative of R_b^a, 1/s^2; made by
/// second_rate(R_a_from_b, w_ab_c, alpha_ab_c), or from a matrix by dcm_second_rate().
template <Frame A, Frame B, class S = double> class DcmSecondRate {
 public:
  template <class Derived>
  DcmSecondRate(detail::Trusted, const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {}

  const detail::Square<S>& matrix() const& { return matrix_; }
  detail::Square<S> matrix() && { return matrix_; }

 private:
  detail::Square<S> matrix_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<DcmSecondRate<A, B, S>> = true;

// alpha_ab^b = vee(R^T Rddot - [w_ab^b]x^2), alpha_ab^a = vee(Rddot R^T - [w_ab^a]x^2). The symmetric part of
// R^T Rddot must be [w]x^2 to 1e-9 of the largest entry.
template <class A, class B, class S, class C>
  requires(std::same_as<C, A> || std::same_as<C, B>)
AngularAcceleration<A, B, In<C>, S> attitude_acceleration(const Dcm<A, B, S>& R_a_from_b,
                                                          const DcmRate<A, B, S>& Rdot_a_from_b,
                                                          const DcmSecondRate<A, B, S>& Rddot_a_from_b,
                                                          In<C>) {
  const auto& R = R_a_from_b.matrix();
  const detail::Square<S> w = hat(attitude_velocity(R_a_from_b, Rdot_a_from_b, in<C>).coordinates());
  detail::Square<S> turn;
  if constexpr (std::same_as<C, B>) {
    turn = R.transpose() * Rddot_a_from_b.matrix();
  } else {
    turn = Rddot_a_from_b.matrix() * R.transpose();
  }
  detail::require_centripetal<A, B>(turn, w);
  const detail::Square<S> skew = (turn - turn.transpose()) / S(2);
  return AngularAcceleration<A, B, In<C>, S>{detail::trusted, vee(skew)};
}

// d2/dt2 R_b^a = R_b^a ([w]x^2 + [alpha]x) of w_ab^b and alpha_ab^b, ([w]x^2 + [alpha]x) R_b^a of those in a
template <class A, class B, class C, class S>
  requires(std::same_as<C, A> || std::same_as<C, B>)
DcmSecondRate<A, B, S> attitude_second_rate(const Dcm<A, B, S>& R_a_from_b,
                                            const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                            const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  const auto& R = R_a_from_b.matrix();
  const detail::Square<S> w = hat(w_ab_c.coordinates());
  const detail::Square<S> turn = w * w + hat(alpha_ab_c.coordinates());
  if constexpr (std::same_as<C, B>) {
    return {detail::trusted, R * turn};
  } else {
    return {detail::trusted, turn * R};
  }
}

/// The checked door for a second derivative given as a matrix. Throws BadInput when it is not finite, or is
/// inconsistent with this rotation and rate for every angular acceleration.
template <class A, class B, class Derived, class S>
DcmSecondRate<A, B, S> dcm_second_rate(const Dcm<A, B, S>& R_a_from_b, const DcmRate<A, B, S>& Rdot_a_from_b,
                                       const Eigen::MatrixBase<Derived>& matrix) {
  const DcmSecondRate<A, B, S> Rddot_a_from_b{detail::trusted, matrix};
  attitude_acceleration(R_a_from_b, Rdot_a_from_b, Rddot_a_from_b, in<B>);
  return Rddot_a_from_b;
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const DcmRate<A, B, S>& Rdot_a_from_b) {
  return detail::print_square(out, Rdot_a_from_b.matrix()) << " 1/s" << detail::print_to_from<A, B>;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const DcmSecondRate<A, B, S>& Rddot_a_from_b) {
  return detail::print_square(out, Rddot_a_from_b.matrix()) << " 1/s^2" << detail::print_to_from<A, B>;
}

}  // namespace vectrix
