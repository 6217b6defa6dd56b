#pragma once

#include <vectrix/kinematics/rates/rate.hpp>

namespace vectrix {

template <class X> class ParameterRate;
template <class X> class SecondParameterRate;

namespace detail {

/// The equations between the rate and the derivatives of parameters X, on bare numbers; specialised beside
/// each X.
///     rate(x, w), velocity(x, xdot), second_rate(x, xdot, w, alpha), acceleration(x, xdot, xddot)
/// for a rate expressed in b if expressed_in_turned, else in a.
template <class X, bool expressed_in_turned> struct KinematicsOf;

template <class C, class... Fs> inline constexpr bool is_one_of = (std::same_as<C, Fs> || ...);
template <class C, class A, class B, class Result>
using InOneOf = std::enable_if_t<is_one_of<C, A, B>, Result>;

/// x_ab, parameters of the attitude of b relative to a: turning a by them gives b, dcm(x_ab) is R_a_from_b.
/// This is the base of their class X.
template <class X, class A, class B, class S, int count> class AttitudeParameters {
 public:
  using reference = A;
  using turned = B;
  using scalar = S;
  using numbers = Eigen::Matrix<S, count, 1>;

  AttitudeParameters() = delete;
  template <class Derived>
  AttitudeParameters(Trusted, const Eigen::MatrixBase<Derived>& values) : numbers_(values) {}

  /// The bare numbers.
  const numbers& coordinates() const& { return numbers_; }
  numbers coordinates() && { return numbers_; }

 private:
  numbers numbers_;
};

template <class X>
concept Parameters =
    std::derived_from<X, AttitudeParameters<X, typename X::reference, typename X::turned, typename X::scalar,
                                            X::numbers::RowsAtCompileTime>>;

/// The type of the rates of X, expressed in C.
template <class X, class C>
using RateOf = InOneOf<C, typename X::reference, typename X::turned,
                       AngularVelocity<typename X::reference, typename X::turned, In<C>, typename X::scalar>>;
template <class X, class C>
using AccelerationOf =
    InOneOf<C, typename X::reference, typename X::turned,
            AngularAcceleration<typename X::reference, typename X::turned, In<C>, typename X::scalar>>;
template <class X, class Rate, class C>
using SecondRateOf =
    std::enable_if_t<Parameters<X> && std::same_as<Rate, RateOf<X, C>>, SecondParameterRate<X>>;

template <class A, class B, class S>
const Quaternion<A, B, S>& as_quaternion(const Quaternion<A, B, S>& q_a_from_b) {
  return q_a_from_b;
}
template <class A, class B, class S> Quaternion<A, B, S> as_quaternion(const Dcm<A, B, S>& R_a_from_b) {
  return quaternion(R_a_from_b);
}
template <class A, class B, class S> const Dcm<A, B, S>& as_dcm(const Dcm<A, B, S>& R_a_from_b) {
  return R_a_from_b;
}
template <class A, class B, class S> Dcm<A, B, S> as_dcm(const Quaternion<A, B, S>& q_a_from_b) {
  return dcm(q_a_from_b);
}

/// The distance, rad, within which a parametrisation counts as singular: there no derivative digit is
/// correct, and rounding decides how the turn is divided among the parameters.
template <class S> S singular_angle() {
  return number<S>(8 * static_cast<double>(Eigen::NumTraits<S>::epsilon()));
}

template <class X> std::string parameters_name(const char* action) {
  return std::string{action} + "(" + X::name() + " of " + frame_name<typename X::turned>() + " relative to " +
         frame_name<typename X::reference>() + "): ";
}
template <class X, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_singular(S distance, const char* action) {
  throw BadInput(parameters_name<X>(action) + text(select(distance < S(0), S(-distance), distance)) +
                 " rad from the singularity, " + X::singularity());
}
/// Whether a distance from the singularity, of either sign, exceeds singular_angle().
template <class S> bool is_regular(const S& distance) {
  return all(distance > singular_angle<S>() || distance < -singular_angle<S>());
}
template <class X> void require_regular(const typename X::scalar& distance, const char* action) {
  if (!is_regular(distance)) refuse_singular<X>(without_derivatives(distance), action);
}
template <class X> void require_finite(const typename X::numbers& numbers, const char* door) {
  if (!all_finite(numbers)) {
    std::string list;
    for (const auto& number : numbers) list += (list.empty() ? "" : ", ") + text(number);
    throw BadInput(parameters_name<X>(door) + "the numbers (" + list + ") are not finite");
  }
}

}  // namespace detail

/// xdot_ab, the time derivative of the parameters x_ab; not parameters itself. In rad/s where they are
/// angles, else in 1/s. X is EulerAngles, ModifiedRodrigues, GibbsVector, AxisAngle or RotationVector. Made
/// by rate(x_ab, w_ab_c), or from numbers by parameter_rate().
template <class X> class ParameterRate {
 public:
  using scalar = typename X::scalar;

  template <class Derived>
  ParameterRate(detail::Trusted, const Eigen::MatrixBase<Derived>& numbers) : numbers_(numbers) {}

  /// In the order of those of X.
  const typename X::numbers& coordinates() const& { return numbers_; }
  typename X::numbers coordinates() && { return numbers_; }

 private:
  typename X::numbers numbers_;
};

/// xddot_ab, the second time derivative of the parameters x_ab, in rad/s^2 or 1/s^2; made by
/// second_rate(x_ab, w_ab_c, alpha_ab_c), or from numbers by second_parameter_rate().
template <class X> class SecondParameterRate {
 public:
  using scalar = typename X::scalar;

  template <class Derived>
  SecondParameterRate(detail::Trusted, const Eigen::MatrixBase<Derived>& numbers) : numbers_(numbers) {}

  /// In the order of those of X.
  const typename X::numbers& coordinates() const& { return numbers_; }
  typename X::numbers coordinates() && { return numbers_; }

 private:
  typename X::numbers numbers_;
};

template <class X> inline constexpr bool detail::is_framed<ParameterRate<X>> = true;
template <class X> inline constexpr bool detail::is_framed<SecondParameterRate<X>> = true;

/// Claims that the bare numbers, in 1/s or rad/s, are the derivatives of the numbers of x_ab. Throws BadInput
/// when one is not finite.
template <detail::Parameters X, class Derived>
  requires(std::same_as<typename Derived::PlainObject, typename X::numbers>)
ParameterRate<X> parameter_rate(const X&, const Eigen::MatrixBase<Derived>& numbers) {
  detail::require_finite<X>(numbers, "parameter_rate");
  return {detail::trusted, numbers};
}
/// The same for the second derivative, in 1/s^2 or rad/s^2.
template <detail::Parameters X, class Derived>
  requires(std::same_as<typename Derived::PlainObject, typename X::numbers>)
SecondParameterRate<X> second_parameter_rate(const X&, const Eigen::MatrixBase<Derived>& numbers) {
  detail::require_finite<X>(numbers, "second_parameter_rate");
  return {detail::trusted, numbers};
}

// Implements rate(x_ab, w_ab_c): the derivative of the parameters, for a rate expressed in b or in a. Throws
// BadInput with the distance at the singularity.
template <detail::Parameters X, class A, class B, class C, class S>
  requires(std::same_as<AngularVelocity<A, B, In<C>, S>, detail::RateOf<X, C>>)
ParameterRate<X> attitude_rate(const X& x_ab, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  using Kinematics = detail::KinematicsOf<X, std::same_as<C, B>>;
  return {detail::trusted, Kinematics::rate(x_ab, w_ab_c.coordinates())};
}

// What angular_velocity_from(x_ab, xdot_ab, in<B>) is, or in<A>.
template <detail::Parameters X, class C>
detail::RateOf<X, C> attitude_velocity(const X& x_ab, const ParameterRate<X>& xdot_ab, In<C>) {
  using Kinematics = detail::KinematicsOf<X, std::same_as<C, typename X::turned>>;
  return detail::RateOf<X, C>{detail::trusted, Kinematics::velocity(x_ab, xdot_ab.coordinates())};
}

// What angular_acceleration_from(x_ab, xdot_ab, xddot_ab, in<B>) is, or in<A>.
template <detail::Parameters X, class C>
detail::AccelerationOf<X, C> attitude_acceleration(const X& x_ab, const ParameterRate<X>& xdot_ab,
                                                   const SecondParameterRate<X>& xddot_ab, In<C>) {
  using Kinematics = detail::KinematicsOf<X, std::same_as<C, typename X::turned>>;
  return detail::AccelerationOf<X, C>{
      detail::trusted, Kinematics::acceleration(x_ab, xdot_ab.coordinates(), xddot_ab.coordinates())};
}

// Implements second_rate(x_ab, w_ab_c, alpha_ab_c). Throws BadInput with the distance at the singularity.
template <class X, class A, class B, class C, class S>
detail::SecondRateOf<X, AngularVelocity<A, B, In<C>, S>, C> attitude_second_rate(
    const X& x_ab, const AngularVelocity<A, B, In<C>, S>& w_ab_c,
    const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  using Kinematics = detail::KinematicsOf<X, std::same_as<C, B>>;
  const auto& w = w_ab_c.coordinates();
  return {detail::trusted,
          Kinematics::second_rate(x_ab, Kinematics::rate(x_ab, w), w, alpha_ab_c.coordinates())};
}

namespace detail {

template <class X, class Numbers>
std::ostream& print_parameters(std::ostream& out, const Numbers& numbers, const char* unit) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) out << (i == 0 ? "(" : ", ") << printable(numbers(i));
  out << ')' << (*unit ? " " : "") << unit;
  return out << ", " << X::name() << print_of_relative_to<typename X::turned, typename X::reference>;
}

}  // namespace detail

template <detail::Parameters X> std::ostream& print_framed(std::ostream& out, const X& x_ab) {
  return detail::print_parameters<X>(out, x_ab.coordinates(), X::unit_symbol(0));
}
template <class X> std::ostream& print_framed(std::ostream& out, const ParameterRate<X>& xdot_ab) {
  return detail::print_parameters<X>(out, xdot_ab.coordinates(), X::unit_symbol(1));
}
template <class X> std::ostream& print_framed(std::ostream& out, const SecondParameterRate<X>& xddot_ab) {
  return detail::print_parameters<X>(out, xddot_ab.coordinates(), X::unit_symbol(2));
}

}  // namespace vectrix
