#pragma once

#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/rates/angular_acceleration.hpp>

namespace vectrix {

/// The time derivative of q_b^a, four numbers, 1/s; not a rotation.
template <Frame A, Frame B, class S = double> class QuaternionRate {
 public:
  template <detail::Makes<Eigen::Quaternion<S>> Make>
  QuaternionRate(detail::Trusted, const Make& make) : value_(make()) {}

  const Eigen::Quaternion<S>& eigen() const& { return value_; }
  Eigen::Quaternion<S> eigen() && { return value_; }
  std::array<S, 4> scalar_first() const { return {value_.w(), value_.x(), value_.y(), value_.z()}; }

 private:
  Eigen::Quaternion<S> value_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<QuaternionRate<A, B, S>> = true;

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

namespace detail {

/// 2 q* x (in b) or 2 x q* (in a). Its vector part is the rate, or the angular acceleration.
template <bool expressed_in_turned, class S>
Eigen::Quaternion<S> turning_part(const Eigen::Quaternion<S>& q, const Eigen::Quaternion<S>& x) {
  const Eigen::Quaternion<S> product = expressed_in_turned ? q.conjugate() * x : x * q.conjugate();
  return Eigen::Quaternion<S>(product.coeffs() * S(2));
}

/// Throws BadInput unless the scalar part agrees with norm 1 of the quaternion. The vector part is free.
template <class A, class B, class S>
void require_on_sphere(const Eigen::Quaternion<S>& part, const S& scalar, const char* derivative) {
  const double tolerance = door_tolerance<S>(1e-9);
  const auto name = [&] {
    return std::string{derivative} + " of q(" + frame_name<A>() + " from " + frame_name<B>() + "): ";
  };
  if (!all_finite(part.coeffs())) {
    throw BadInput(name() + "the numbers of 2 q* times it, scalar first, (" + text(part.w()) + ", " +
                   text(part.x()) + ", " + text(part.y()) + ", " + text(part.z()) + ") are not finite");
  }
  const S error = select(part.w() < scalar, S(scalar - part.w()), S(part.w() - scalar));
  const S largest = part.coeffs().cwiseAbs().maxCoeff();
  if (!all(error <= number<S>(tolerance) * largest)) {
    throw BadInput(name() + "the norm of q would leave 1: the scalar part of 2 q* times it differs from " +
                   text(scalar) + " by " + text(error) + " beside numbers of " + text(largest));
  }
}

}  // namespace detail

// (0, w_ab^b) = 2 q* qdot, (0, w_ab^a) = 2 qdot q*. The scalar part must be 0 to 1e-9 of the largest number.
template <class A, class B, class S, class C>
  requires(std::same_as<C, A> || std::same_as<C, B>)
AngularVelocity<A, B, In<C>, S> attitude_velocity(const Quaternion<A, B, S>& q_a_from_b,
                                                  const QuaternionRate<A, B, S>& qdot_a_from_b, In<C>) {
  const auto w = detail::turning_part<std::same_as<C, B>>(q_a_from_b.eigen(), qdot_a_from_b.eigen());
  detail::require_on_sphere<A, B>(w, S(0), "derivative");
  return AngularVelocity<A, B, In<C>, S>{detail::trusted, w.vec()};
}

/// The checked doors for a derivative given in numbers, 1/s. Throw BadInput when a number is not finite, or
/// the derivative has a component along q, so that the norm would not stay 1.
template <class A, class B, class S>
QuaternionRate<A, B, S> quaternion_rate_scalar_first(const Quaternion<A, B, S>& q_a_from_b,
                                                     const std::type_identity_t<S>& w,
                                                     const std::type_identity_t<S>& x,
                                                     const std::type_identity_t<S>& y,
                                                     const std::type_identity_t<S>& z) {
  const QuaternionRate<A, B, S> qdot_a_from_b{detail::trusted,
                                              [&] { return Eigen::Quaternion<S>(w, x, y, z); }};
  attitude_velocity(q_a_from_b, qdot_a_from_b, in<B>);
  return qdot_a_from_b;
}
template <class A, class B, class S>
QuaternionRate<A, B, S> quaternion_rate_scalar_last(const Quaternion<A, B, S>& q_a_from_b,
                                                    const std::type_identity_t<S>& x,
                                                    const std::type_identity_t<S>& y,
                                                    const std::type_identity_t<S>& z,
                                                    const std::type_identity_t<S>& w) {
  return quaternion_rate_scalar_first(q_a_from_b, w, x, y, z);
}

/// The second time derivative of q_b^a, four numbers, 1/s^2; made by second_rate(q_a_from_b, w_ab_c,
/// alpha_ab_c), or from numbers by quaternion_second_rate_scalar_first().
template <Frame A, Frame B, class S = double> class QuaternionSecondRate {
 public:
  template <detail::Makes<Eigen::Quaternion<S>> Make>
  QuaternionSecondRate(detail::Trusted, const Make& make) : value_(make()) {}

  const Eigen::Quaternion<S>& eigen() const& { return value_; }
  Eigen::Quaternion<S> eigen() && { return value_; }
  std::array<S, 4> scalar_first() const { return {value_.w(), value_.x(), value_.y(), value_.z()}; }

 private:
  Eigen::Quaternion<S> value_;
};

template <class A, class B, class S>
inline constexpr bool detail::is_framed<QuaternionSecondRate<A, B, S>> = true;

// d2/dt2 q_b^a = q_b^a (-|w|^2/4, alpha_ab^b/2) = (-|w|^2/4, alpha_ab^a/2) q_b^a
template <class A, class B, class C, class S>
  requires(std::same_as<C, A> || std::same_as<C, B>)
QuaternionSecondRate<A, B, S> attitude_second_rate(const Quaternion<A, B, S>& q_a_from_b,
                                                   const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                                   const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  const detail::Column<S> h = alpha_ab_c.coordinates() / S(2);
  const Eigen::Quaternion<S> turn(-w_ab_c.coordinates().squaredNorm() / S(4), h.x(), h.y(), h.z());
  return {detail::trusted, [&]() -> Eigen::Quaternion<S> {
            return std::same_as<C, B> ? q_a_from_b.eigen() * turn : turn * q_a_from_b.eigen();
          }};
}

// (-|w|^2/2, alpha_ab^b) = 2 q* qddot, and 2 qddot q* in a. The scalar part must be right to 1e-9 of the
// largest number.
template <class A, class B, class S, class C>
  requires(std::same_as<C, A> || std::same_as<C, B>)
AngularAcceleration<A, B, In<C>, S> attitude_acceleration(const Quaternion<A, B, S>& q_a_from_b,
                                                          const QuaternionRate<A, B, S>& qdot_a_from_b,
                                                          const QuaternionSecondRate<A, B, S>& qddot_a_from_b,
                                                          In<C> in_c) {
  const S square = attitude_velocity(q_a_from_b, qdot_a_from_b, in_c).coordinates().squaredNorm();
  const auto alpha = detail::turning_part<std::same_as<C, B>>(q_a_from_b.eigen(), qddot_a_from_b.eigen());
  detail::require_on_sphere<A, B>(alpha, S(-square / S(2)), "second derivative");
  return AngularAcceleration<A, B, In<C>, S>{detail::trusted, alpha.vec()};
}

/// The checked doors for a second derivative given in numbers, 1/s^2. Throw BadInput when a number is not
/// finite, or the norm of q would not stay 1 at this rate.
template <class A, class B, class S>
QuaternionSecondRate<A, B, S> quaternion_second_rate_scalar_first(
    const Quaternion<A, B, S>& q_a_from_b, const QuaternionRate<A, B, S>& qdot_a_from_b,
    const std::type_identity_t<S>& w, const std::type_identity_t<S>& x, const std::type_identity_t<S>& y,
    const std::type_identity_t<S>& z) {
  const QuaternionSecondRate<A, B, S> qddot_a_from_b{detail::trusted,
                                                     [&] { return Eigen::Quaternion<S>(w, x, y, z); }};
  attitude_acceleration(q_a_from_b, qdot_a_from_b, qddot_a_from_b, in<B>);
  return qddot_a_from_b;
}
template <class A, class B, class S>
QuaternionSecondRate<A, B, S> quaternion_second_rate_scalar_last(const Quaternion<A, B, S>& q_a_from_b,
                                                                 const QuaternionRate<A, B, S>& qdot_a_from_b,
                                                                 const std::type_identity_t<S>& x,
                                                                 const std::type_identity_t<S>& y,
                                                                 const std::type_identity_t<S>& z,
                                                                 const std::type_identity_t<S>& w) {
  return quaternion_second_rate_scalar_first(q_a_from_b, qdot_a_from_b, w, x, y, z);
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const QuaternionSecondRate<A, B, S>& qddot_a_from_b) {
  return detail::print_quaternion(out, qddot_a_from_b.eigen()) << " 1/s^2" << detail::print_to_from<A, B>;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const QuaternionRate<A, B, S>& qdot_a_from_b) {
  return detail::print_quaternion(out, qdot_a_from_b.eigen()) << " 1/s" << detail::print_to_from<A, B>;
}

}  // namespace vectrix
