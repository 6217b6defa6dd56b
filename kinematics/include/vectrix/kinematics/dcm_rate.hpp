#pragma once

#include <vectrix/kinematics/angular_velocity.hpp>
#include <vectrix/kinematics/hat.hpp>
#include <vectrix/kinematics/quaternion.hpp>

namespace vectrix {
namespace detail {

template <class Rotation, class Rate>
using DerivativeOf = decltype(attitude_rate(std::declval<const Rotation&>(), std::declval<const Rate&>()));

}  // namespace detail

/// Rdot_b^a, `Rdot_a_from_b`, of type DcmRate<A, B>: the time derivative of R_b^a, 1/s. Not a rotation, and
/// not convertible to one.
template <Frame A, Frame B, class S = double> class VECTRIX_QUANTITY DcmRate : public detail::Stamped {
 public:
  template <class Derived>
  DcmRate(detail::Trusted key, const Eigen::MatrixBase<Derived>& matrix)
      : detail::Stamped(key), matrix_(matrix) {}
  template <class First, class Second, class Third>
  DcmRate(detail::Trusted key, const Eigen::MatrixBase<First>& first_column,
          const Eigen::MatrixBase<Second>& second_column, const Eigen::MatrixBase<Third>& third_column)
      : detail::Stamped(key) {
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
// Inlined by force: g++ finds its two dozen instructions long enough to call.
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
/// The checked door for a derivative that comes as a matrix: Rdot_b^a = R_b^a [w]x for some w.
/// Throws BadInput when the matrix is not finite, or R^T Rdot is not skew (see vee()).
template <class A, class B, class Derived, class S>
DcmRate<A, B, S> dcm_rate(const Dcm<A, B, S>& R_a_from_b, const Eigen::MatrixBase<Derived>& matrix) {
  vee(R_a_from_b.matrix().transpose() * matrix);
  return {detail::trusted_like(R_a_from_b), matrix};
}

/// The inverse of rate(): w_ab^b = vee(R^T Rdot) in b, w_ab^a = vee(Rdot R^T) in a, for R = R_b^a.
/// Throws BadInput when the two do not belong together: the product is then not skew.
template <class A, class B, class S, class C>
  requires(std::same_as<C, A> || std::same_as<C, B>)
AngularVelocity<A, B, In<C>, S> angular_velocity(const Dcm<A, B, S>& R_a_from_b,
                                                 const DcmRate<A, B, S>& Rdot_a_from_b, In<C>) {
  const auto& R = R_a_from_b.matrix();
  const auto& Rdot = Rdot_a_from_b.matrix();
  const detail::Column<S> w = std::same_as<C, B> ? vee(R.transpose() * Rdot) : vee(Rdot * R.transpose());
  return AngularVelocity<A, B, In<C>, S>{detail::trusted_like(R_a_from_b, Rdot_a_from_b),
                                         vector<si::angular_velocity>(in<C>, w).coordinates()};
}

// Rdot_b^a r^b, the part of d/dt (R_b^a r^b) that the turning of b makes.
template <class A, class B, class U, class S>
Vector<A, unit_of_vector_quotient<U, si::time>, S> product(const DcmRate<A, B, S>& Rdot_a_from_b,
                                                           const Vector<B, U, S>& r_b) {
  return {detail::trusted, Rdot_a_from_b.matrix() * r_b.coordinates()};
}

/// The time derivative of q_b^a, four numbers, 1/s; not a rotation.
template <Frame A, Frame B, class S = double> class VECTRIX_QUANTITY QuaternionRate : public detail::Stamped {
 public:
  template <detail::Makes<Eigen::Quaternion<S>> Make>
  QuaternionRate(detail::Trusted key, const Make& make) : detail::Stamped(key), value_(make()) {}

  const Eigen::Quaternion<S>& eigen() const& { return value_; }
  Eigen::Quaternion<S> eigen() && { return value_; }
  std::array<S, 4> scalar_first() const { return {value_.w(), value_.x(), value_.y(), value_.z()}; }

 private:
  Eigen::Quaternion<S> value_;
};

// d/dt q_b^a = 1/2 q_b^a (0, w_ab^b) = 1/2 (0, w_ab^a) q_b^a
template <class A, class B, class S>
inline QuaternionRate<A, B, S> attitude_rate(const Quaternion<A, B, S>& q_a_from_b,
                                             const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  const detail::Column<S> h = w_ab_b.coordinates() / S(2);
  return {detail::trusted,
          [&] { return q_a_from_b.eigen() * Eigen::Quaternion<S>(S(0), h.x(), h.y(), h.z()); }};
}
template <class A, class B, class S>
  requires(!std::same_as<A, B>)
inline QuaternionRate<A, B, S> attitude_rate(const Quaternion<A, B, S>& q_a_from_b,
                                             const AngularVelocity<A, B, In<A>, S>& w_ab_a) {
  const detail::Column<S> h = w_ab_a.coordinates() / S(2);
  return {detail::trusted,
          [&] { return Eigen::Quaternion<S>(S(0), h.x(), h.y(), h.z()) * q_a_from_b.eigen(); }};
}

/// The derivative of a rotation, a DcmRate or a QuaternionRate:
///     Body form:       d/dt R_b^a = R_b^a [w_ab^b]x     d/dt q_b^a = 1/2 q_b^a (0, w_ab^b)
///     Reference form:  d/dt R_b^a = [w_ab^a]x R_b^a     d/dt q_b^a = 1/2 (0, w_ab^a) q_b^a
/// Any finite input is valid.
template <class Rotation, class Rate>
[[gnu::always_inline]] inline detail::DerivativeOf<Rotation, Rate> rate(const Rotation& rotation,
                                                                        const Rate& omega) {
  return VECTRIX_OF_ONE_INSTANT("rate", attitude_rate(rotation, omega), rotation, omega);
}
template <class Rotation, class Rate>
  requires(detail::FramedPair<Rotation, Rate> && !detail::Lawful<detail::DerivativeOf, Rotation, Rate>)
auto rate(  // rate(R_a_from_b, w_ab_b) or rate(R_a_from_b, w_ab_a)
    const Rotation&, const Rate&) -> Refused = delete;

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const DcmRate<A, B, S>& Rdot_a_from_b) {
  return detail::print_square(out, Rdot_a_from_b.matrix()) << " 1/s" << detail::print_to_from<A, B>;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const QuaternionRate<A, B, S>& qdot_a_from_b) {
  return detail::print_quaternion(out, qdot_a_from_b.eigen()) << " 1/s" << detail::print_to_from<A, B>;
}

}  // namespace vectrix
