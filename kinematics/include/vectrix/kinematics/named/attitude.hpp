#pragma once

#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/euler_angles.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/jacobian.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>
#include <vectrix/kinematics/named/algebra.hpp>
#include <vectrix/kinematics/rates/euler_rates.hpp>
#include <vectrix/kinematics/rates/rate.hpp>

namespace vectrix {

// Attitude parameters between frames known at run time, and the derivatives of all attitudes: the words of
// kinematics/attitude/ and kinematics/rates/, with the same laws, ranges and errors.

using NamedRotationVector = Named<RotationVector<Some<'a'>, Some<'b'>>>;
using NamedAxisAngle = Named<AxisAngle<Some<'a'>, Some<'b'>>>;
using NamedGibbsVector = Named<GibbsVector<Some<'a'>, Some<'b'>>>;
using NamedModifiedRodrigues = Named<ModifiedRodrigues<Some<'a'>, Some<'b'>>>;
using NamedDcmRate = Named<DcmRate<Some<'a'>, Some<'b'>>>;
using NamedDcmSecondRate = Named<DcmSecondRate<Some<'a'>, Some<'b'>>>;
using NamedQuaternionRate = Named<QuaternionRate<Some<'a'>, Some<'b'>>>;
using NamedQuaternionSecondRate = Named<QuaternionSecondRate<Some<'a'>, Some<'b'>>>;
template <EulerSequence Sequence> using NamedEulerAngles = Named<EulerAngles<Sequence, Some<'a'>, Some<'b'>>>;

namespace detail {

template <class X> inline constexpr bool is_named_rotation = false;
template <> inline constexpr bool is_named_rotation<NamedDcm> = true;
template <> inline constexpr bool is_named_rotation<NamedQuaternion> = true;
template <class X> inline constexpr bool is_named_parameters = false;
template <class Form> inline constexpr bool is_named_parameters<Named<Form>> = Parameters<Form>;

/// R_b^a or q_b^a; parameters x_ab; any of them. Their forms are of b relative to a.
template <class X>
concept NamedRotation = is_named_rotation<X>;
template <class X>
concept NamedParameters = is_named_parameters<X>;
template <class X>
concept NamedAttitude = NamedRotation<X> || NamedParameters<X>;

template <class In> using RateIn = AngularVelocity<Some<'a'>, Some<'b'>, In>;
template <class In> using ChangeIn = AngularAcceleration<Some<'a'>, Some<'b'>, In>;
/// The form of the first and of the second derivative of a form.
template <class Form>
using FormOfRate = decltype(rate(std::declval<const Form&>(), std::declval<const RateIn<In<Some<'b'>>>&>()));
template <class Form>
using FormOfSecondRate =
    decltype(second_rate(std::declval<const Form&>(), std::declval<const RateIn<In<Some<'b'>>>&>(),
                         std::declval<const ChangeIn<In<Some<'b'>>>&>()));
template <class X> using NamedRateOf = Named<FormOfRate<FormOfNamed<X>>>;
template <class X> using NamedSecondRateOf = Named<FormOfSecondRate<FormOfNamed<X>>>;

/// A door for a vector expressed in b or in a.
template <class U, class Word>
auto in_either(std::string_view name, const Word& word, Of<NamedFrame> b, RelativeTo<NamedFrame> a,
               const NamedVector<U>& x) {
  using namespace letters;
  return typed_law<Law<Of<B>, RelativeTo<A>, Vector<B, U>>, Law<Of<B>, RelativeTo<A>, Vector<A, U>>>(
      name, word, b, a, x);
}

}  // namespace detail

inline NamedRotationVector rotation_vector(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                           const NamedVector<si::angle>& theta) {
  return detail::in_either(
      "rotation_vector", [](const auto&... x) { return rotation_vector(x...); }, b, a, theta);
}
inline NamedGibbsVector gibbs_vector(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                     const NamedVector<si::dimensionless>& g) {
  return detail::in_either(
      "gibbs_vector", [](const auto&... x) { return gibbs_vector(x...); }, b, a, g);
}
inline NamedModifiedRodrigues modified_rodrigues(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                                 const NamedVector<si::dimensionless>& sigma) {
  return detail::in_either(
      "modified_rodrigues", [](const auto&... x) { return modified_rodrigues(x...); }, b, a, sigma);
}
inline NamedAxisAngle axis_angle(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                 const NamedVector<si::dimensionless>& axis,
                                 const Quantity<si::angle>& angle) {
  return detail::in_either(
      "axis_angle", [&](const auto&... x) { return axis_angle(x..., angle); }, b, a, axis);
}
template <EulerSequence Sequence>
NamedEulerAngles<Sequence> euler_angles(Sequence sequence, Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                        const Quantity<si::angle>& first, const Quantity<si::angle>& second,
                                        const Quantity<si::angle>& third) {
  using namespace detail::letters;
  return typed_law<Law<Of<B>, RelativeTo<A>>>(
      "euler_angles",
      [&](const auto& of_b, const auto& relative_to_a) {
        return euler_angles(sequence, of_b, relative_to_a, first, second, third);
      },
      b, a);
}

// Of R_b^a or q_b^a
template <detail::NamedRotation R> NamedRotationVector log(const R& R_a_from_b) {
  return detail::of_one(
      "log", [](const auto& x) { return log(x); }, R_a_from_b);
}
template <detail::NamedRotation R> NamedAxisAngle axis_angle(const R& R_a_from_b) {
  return detail::of_one(
      "axis_angle", [](const auto& x) { return axis_angle(x); }, R_a_from_b);
}
template <detail::NamedRotation R> NamedGibbsVector gibbs_vector(const R& R_a_from_b) {
  return detail::of_one(
      "gibbs_vector", [](const auto& x) { return gibbs_vector(x); }, R_a_from_b);
}
template <detail::NamedRotation R> NamedModifiedRodrigues modified_rodrigues(const R& R_a_from_b) {
  return detail::of_one(
      "modified_rodrigues", [](const auto& x) { return modified_rodrigues(x); }, R_a_from_b);
}
template <EulerSequence Sequence, detail::NamedRotation R>
NamedEulerAngles<Sequence> euler_angles(Sequence sequence, const R& R_a_from_b) {
  return detail::of_one(
      "euler_angles", [&](const auto& x) { return euler_angles(sequence, x); }, R_a_from_b);
}

// R_b^a and q_b^a of parameters; of a rotation vector exp() and exp_quaternion() instead
template <detail::NamedParameters X>
  requires(!std::same_as<X, NamedRotationVector>)
NamedDcm dcm(const X& x_ab) {
  return detail::of_one(
      "dcm", [](const auto& x) { return dcm(x); }, x_ab);
}
template <detail::NamedParameters X>
  requires(!std::same_as<X, NamedRotationVector>)
NamedQuaternion quaternion(const X& x_ab) {
  return detail::of_one(
      "quaternion", [](const auto& x) { return quaternion(x); }, x_ab);
}
inline NamedDcm exp(const NamedRotationVector& theta_ab) {
  return detail::of_one(
      "exp", [](const auto& theta) { return exp(theta); }, theta_ab);
}
inline NamedQuaternion exp_quaternion(const NamedRotationVector& theta_ab) {
  return detail::of_one(
      "exp_quaternion", [](const auto& theta) { return exp_quaternion(theta); }, theta_ab);
}

struct SwitchedNamedRodrigues {
  NamedModifiedRodrigues parameters;
  /// Whether these are the shadow of the given parameters.
  bool switched;
};
[[nodiscard]] inline SwitchedNamedRodrigues switch_to_shadow(const NamedModifiedRodrigues& sigma_ab) {
  const auto found = switch_to_shadow(sigma_ab.value());
  return {{detail::trusted, sigma_ab.frames(), found.parameters}, found.switched};
}
inline auto shadow_rate(const NamedModifiedRodrigues& sigma_ab,
                        const detail::NamedRateOf<NamedModifiedRodrigues>& sigmadot_ab) {
  using namespace detail::letters;
  using Form = ModifiedRodrigues<A, B>;
  return typed_law<Law<Form, ParameterRate<Form>>>(
      "shadow_rate", [](const auto&... x) { return shadow_rate(x...); }, sigma_ab, sigmadot_ab);
}

/// The Jacobians of SO(3), and of SE(3) for a screw, as bare matrices.
template <class Form> auto left_jacobian(const Named<Form>& theta_ab) {
  return detail::of_one(
      "left_jacobian", [](const auto& x) { return left_jacobian(x); }, theta_ab);
}
template <class Form> auto right_jacobian(const Named<Form>& theta_ab) {
  return detail::of_one(
      "right_jacobian", [](const auto& x) { return right_jacobian(x); }, theta_ab);
}
template <class Form> auto inverse_left_jacobian(const Named<Form>& theta_ab) {
  return detail::of_one(
      "inverse_left_jacobian", [](const auto& x) { return inverse_left_jacobian(x); }, theta_ab);
}
template <class Form> auto inverse_right_jacobian(const Named<Form>& theta_ab) {
  return detail::of_one(
      "inverse_right_jacobian", [](const auto& x) { return inverse_right_jacobian(x); }, theta_ab);
}

// rate(x_ab, w_ab_c), with c = b or a
template <detail::NamedAttitude X>
detail::NamedRateOf<X> attitude_rate(const X& x_ab, const NamedAngularVelocity& w_ab_c) {
  using namespace detail::letters;
  using Form = detail::FormOfNamed<X>;
  return typed_law<Law<Form, detail::RateIn<In<B>>>, Law<Form, detail::RateIn<In<A>>>>(
      "rate", [](const auto&... x) { return rate(x...); }, x_ab, w_ab_c);
}
// second_rate(x_ab, w_ab_c, alpha_ab_c)
template <detail::NamedAttitude X>
detail::NamedSecondRateOf<X> attitude_second_rate(const X& x_ab, const NamedAngularVelocity& w_ab_c,
                                                  const NamedAngularAcceleration& alpha_ab_c) {
  using namespace detail::letters;
  using Form = detail::FormOfNamed<X>;
  return typed_law<Law<Form, detail::RateIn<In<B>>, detail::ChangeIn<In<B>>>,
                   Law<Form, detail::RateIn<In<A>>, detail::ChangeIn<In<A>>>>(
      "second_rate", [](const auto&... x) { return second_rate(x...); }, x_ab, w_ab_c, alpha_ab_c);
}
// angular_velocity_from(x_ab, xdot_ab, In(c)) and angular_acceleration_from(x_ab, xdot_ab, xddot_ab, In(c))
template <detail::NamedAttitude X>
NamedAngularVelocity attitude_velocity(const X& x_ab, const detail::NamedRateOf<X>& xdot_ab,
                                       In<NamedFrame> c) {
  using namespace detail::letters;
  using Form = detail::FormOfNamed<X>;
  using Rate = detail::FormOfRate<Form>;
  return typed_law<Law<Form, Rate, In<B>>, Law<Form, Rate, In<A>>>(
      "angular_velocity_from", [](const auto&... x) { return angular_velocity_from(x...); }, x_ab, xdot_ab,
      c);
}
template <detail::NamedAttitude X>
NamedAngularAcceleration attitude_acceleration(const X& x_ab, const detail::NamedRateOf<X>& xdot_ab,
                                               const detail::NamedSecondRateOf<X>& xddot_ab,
                                               In<NamedFrame> c) {
  using namespace detail::letters;
  using Form = detail::FormOfNamed<X>;
  using Rate = detail::FormOfRate<Form>;
  using Second = detail::FormOfSecondRate<Form>;
  return typed_law<Law<Form, Rate, Second, In<B>>, Law<Form, Rate, Second, In<A>>>(
      "angular_acceleration_from", [](const auto&... x) { return angular_acceleration_from(x...); }, x_ab,
      xdot_ab, xddot_ab, c);
}

// The checked doors for derivatives in numbers
template <detail::NamedParameters X, class Derived>
detail::NamedRateOf<X> parameter_rate(const X& x_ab, const Eigen::MatrixBase<Derived>& numbers) {
  return detail::of_one(
      "parameter_rate", [&](const auto& x) { return parameter_rate(x, numbers); }, x_ab);
}
template <detail::NamedParameters X, class Derived>
detail::NamedSecondRateOf<X> second_parameter_rate(const X& x_ab, const Eigen::MatrixBase<Derived>& numbers) {
  return detail::of_one(
      "second_parameter_rate", [&](const auto& x) { return second_parameter_rate(x, numbers); }, x_ab);
}
template <class Derived>
NamedDcmRate dcm_rate(const NamedDcm& R_a_from_b, const Eigen::MatrixBase<Derived>& matrix) {
  return detail::of_one(
      "dcm_rate", [&](const auto& R) { return dcm_rate(R, matrix); }, R_a_from_b);
}
template <class Derived>
NamedDcmSecondRate dcm_second_rate(const NamedDcm& R_a_from_b, const NamedDcmRate& Rdot_a_from_b,
                                   const Eigen::MatrixBase<Derived>& matrix) {
  using namespace detail::letters;
  return typed_law<Law<Dcm<A, B>, DcmRate<A, B>>>(
      "dcm_second_rate", [&](const auto&... x) { return dcm_second_rate(x..., matrix); }, R_a_from_b,
      Rdot_a_from_b);
}
inline NamedQuaternionRate quaternion_rate_scalar_first(const NamedQuaternion& q_a_from_b, double w, double x,
                                                        double y, double z) {
  return detail::of_one(
      "quaternion_rate_scalar_first",
      [&](const auto& q) { return quaternion_rate_scalar_first(q, w, x, y, z); }, q_a_from_b);
}
inline NamedQuaternionRate quaternion_rate_scalar_last(const NamedQuaternion& q_a_from_b, double x, double y,
                                                       double z, double w) {
  return quaternion_rate_scalar_first(q_a_from_b, w, x, y, z);
}
inline NamedQuaternionSecondRate quaternion_second_rate_scalar_first(const NamedQuaternion& q_a_from_b,
                                                                     const NamedQuaternionRate& qdot_a_from_b,
                                                                     double w, double x, double y, double z) {
  using namespace detail::letters;
  return typed_law<Law<Quaternion<A, B>, QuaternionRate<A, B>>>(
      "quaternion_second_rate_scalar_first",
      [&](const auto&... qs) { return quaternion_second_rate_scalar_first(qs..., w, x, y, z); }, q_a_from_b,
      qdot_a_from_b);
}
inline NamedQuaternionSecondRate quaternion_second_rate_scalar_last(const NamedQuaternion& q_a_from_b,
                                                                    const NamedQuaternionRate& qdot_a_from_b,
                                                                    double x, double y, double z, double w) {
  return quaternion_second_rate_scalar_first(q_a_from_b, qdot_a_from_b, w, x, y, z);
}

// Rdot_b^a r^b
template <class U>
NamedVector<unit_of_vector_quotient<U, si::time>> product(const NamedDcmRate& Rdot_a_from_b,
                                                          const NamedVector<U>& r_b) {
  using namespace detail::letters;
  return typed_law<Law<DcmRate<A, B>, Vector<B, U>>>(
      "product", [](const auto& Rdot, const auto& r) { return Rdot * r; }, Rdot_a_from_b, r_b);
}

}  // namespace vectrix
