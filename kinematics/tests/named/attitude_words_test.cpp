#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/attitude.hpp>

#include "words.hpp"

namespace named_attitude_words_test {
using namespace named_words;
namespace {

/// The derivatives of an attitude of b relative to a, and back, in either frame.
template <class X> void agree_on_derivatives(const Words& words, const X& x) {
  const auto first = [](const auto&... y) { return rate(y...); };
  const auto second = [](const auto&... y) { return second_rate(y...); };
  const auto velocity = [](const auto&... y) { return angular_velocity_from(y...); };
  const auto acceleration = [](const auto&... y) { return angular_acceleration_from(y...); };
  const auto w_b = any_rate(of<B>, relative_to<A>, in<B>);
  const auto w_a = any_rate(of<B>, relative_to<A>, in<A>);
  words.agree(first, x, w_b);
  words.agree(first, x, w_a);
  words.agree(second, x, w_b, any_change(of<B>, relative_to<A>, in<B>));
  words.agree(second, x, w_a, any_change(of<B>, relative_to<A>, in<A>));
  const auto xdot = rate(x, w_b);
  const auto xddot = second_rate(x, w_b, any_change(of<B>, relative_to<A>, in<B>));
  words.agree(velocity, x, xdot, in<B>);
  words.agree(velocity, x, xdot, in<A>);
  words.agree(acceleration, x, xdot, xddot, in<B>);
  words.agree(acceleration, x, xdot, xddot, in<A>);
}

/// Far from every singularity, unlike any_rotation().
Dcm<A, B> tame_rotation() {
  const Eigen::Vector3d v = *triple();
  return exp(rotation_vector(
      of<B>, relative_to<A>,
      vector<si::angle>(in<A>, Eigen::Vector3d(0.9, 0.3 + 0.1 * v.x() / (1.0 + std::abs(v.x())),
                                               0.4 + 0.1 * v.y() / (1.0 + std::abs(v.y()))))));
}

RC_GTEST_PROP(NamedAttitude, ParametersOfARotationAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R = any_rotation(to<A>, from<B>);
  const auto q = quaternion(R);
  const auto all = [&](const auto& word) {
    words.agree(word, R);
    words.agree(word, q);
  };
  all([](const auto& x) { return log(x); });
  all([](const auto& x) { return axis_angle(x); });
  all([](const auto& x) { return gibbs_vector(x); });
  all([](const auto& x) { return modified_rodrigues(x); });
  all([](const auto& x) { return euler_angles(intrinsic<3, 2, 1>, x); });
  all([](const auto& x) { return euler_angles(extrinsic<3, 1, 3>, x); });
}

RC_GTEST_PROP(NamedAttitude, RotationsOfParametersAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto v = vector_in<si::dimensionless>(in<A>);
  const auto theta = rotation_vector(of<B>, relative_to<A>, vector_in<si::angle>(in<A>));
  const auto to_dcm = [](const auto& x) { return dcm(x); };
  const auto to_quaternion = [](const auto& x) { return quaternion(x); };
  const auto reversed = [](const auto& x) { return -x; };
  words.agree([](const auto& x) { return exp(x); }, theta);
  words.agree([](const auto& x) { return exp_quaternion(x); }, theta);
  words.agree(reversed, theta);
  const auto agree = [&](const auto& x) {
    words.agree(to_dcm, x);
    words.agree(to_quaternion, x);
    words.agree([](const auto& y) { return y.distance_from_singularity(); }, x);
    words.agree([](const auto& y) { return y.coordinates().transpose().eval(); }, x);
  };
  const auto sigma = modified_rodrigues(of<B>, relative_to<A>, v);
  agree(sigma);
  words.agree(reversed, sigma);
  words.agree([](const auto& x) { return x.in_reference(); }, sigma);
  words.agree([](const auto& x) { return x.in_turned(); }, sigma);
  agree(gibbs_vector(of<B>, relative_to<A>, v));
  agree(axis_angle(of<B>, relative_to<A>, unit_y(in<B>), 0.3 * si::radian));
  agree(euler_angles(intrinsic<1, 2, 3>, of<B>, relative_to<A>, 0.1 * si::radian, 0.2 * si::radian,
                     0.3 * si::radian));
}

RC_GTEST_PROP(NamedAttitude, DoorsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto v_a = vector_in<si::dimensionless>(in<A>);
  const auto v_b = vector_in<si::dimensionless>(in<B>);
  const auto theta = [](const auto&... x) { return rotation_vector(x...); };
  words.agree(theta, of<B>, relative_to<A>, vector_in<si::angle>(in<A>));
  words.agree(theta, of<B>, relative_to<A>, vector_in<si::angle>(in<B>));
  const auto all = [&](const auto& word) {
    words.agree(word, of<B>, relative_to<A>, v_a);
    words.agree(word, of<B>, relative_to<A>, v_b);
  };
  all([](const auto&... x) { return gibbs_vector(x...); });
  all([](const auto&... x) { return modified_rodrigues(x...); });
  all([](const auto&... x) { return axis_angle(x..., 0.7 * si::radian); });  // refused: of no unit length
  words.agree([](const auto&... x) { return axis_angle(x..., 0.7 * si::radian); }, of<B>, relative_to<A>,
              unit_z(in<A>));
  words.agree(
      [](const auto&... x) {
        return euler_angles(extrinsic<3, 2, 1>, x..., 0.1 * si::radian, 0.2 * si::radian,
                            no_number * si::radian);
      },
      of<B>, relative_to<A>);
  const NamedFrame a = words.graph.frame("a");
  RC_ASSERT(message<BadInput>([&] { rotation_vector(Of(a), RelativeTo(a), zero<si::angle>(In(a))); }) ==
            R"(rotation_vector(of "a", relative to "a"): a door takes two frames, and these are one)");
}

RC_GTEST_PROP(NamedAttitude, DerivativesAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R = tame_rotation();
  agree_on_derivatives(words, R);
  agree_on_derivatives(words, quaternion(R));
  agree_on_derivatives(words, log(R));
  agree_on_derivatives(words, modified_rodrigues(R));
  agree_on_derivatives(words, euler_angles(intrinsic<3, 2, 1>, R));
}

RC_GTEST_PROP(NamedAttitude, DerivativesInNumbersAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const Eigen::Vector3d v = *triple();
  const auto R = tame_rotation();
  const auto q = quaternion(R);
  const auto w = any_rate(of<B>, relative_to<A>, in<B>);
  const auto sigma = modified_rodrigues(R);
  words.agree([&](const auto& x) { return parameter_rate(x, v); }, sigma);
  words.agree([&](const auto& x) { return second_parameter_rate(x, v); }, sigma);
  words.agree([&](const auto& x) { return dcm_rate(x, rate(R, w).matrix()); }, R);
  words.agree([&](const auto& x) { return dcm_rate(x, R.matrix()); }, R);  // refused: not skew
  const auto alpha = any_change(of<B>, relative_to<A>, in<B>);
  words.agree([&](const auto&... x) { return dcm_second_rate(x..., second_rate(R, w, alpha).matrix()); }, R,
              rate(R, w));
  const auto n = rate(q, w).scalar_first();
  words.agree([&](const auto& x) { return quaternion_rate_scalar_first(x, n[0], n[1], n[2], n[3]); }, q);
  words.agree([&](const auto& x) { return quaternion_rate_scalar_last(x, n[1], n[2], n[3], n[0]); }, q);
  const auto m = second_rate(q, w, alpha).scalar_first();
  words.agree(
      [&](const auto&... x) { return quaternion_second_rate_scalar_first(x..., m[0], m[1], m[2], m[3]); }, q,
      rate(q, w));
  words.agree([](const auto& x, const auto& y) { return x * y; }, rate(R, w), vector_in<si::length>(in<B>));
}

RC_GTEST_PROP(NamedAttitude, ShadowsAndJacobiansAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto sigma = modified_rodrigues(of<B>, relative_to<A>, vector_in<si::dimensionless>(in<A>));
  words.agree([](const auto& x) { return switch_to_shadow(x).parameters; }, sigma);
  words.agree([](const auto& x) { return switch_to_shadow(x).switched; }, sigma);
  words.agree([](const auto& x) { return x.shadow(); }, sigma);
  const auto R = tame_rotation();
  const auto tame = modified_rodrigues(R);
  words.agree([](const auto&... x) { return shadow_rate(x...); }, tame,
              rate(tame, any_rate(of<B>, relative_to<A>, in<B>)));
  const auto theta = log(R);
  words.agree([](const auto& x) { return left_jacobian(x); }, theta);
  words.agree([](const auto& x) { return right_jacobian(x); }, theta);
  words.agree([](const auto& x) { return inverse_left_jacobian(x); }, theta);
  words.agree([](const auto& x) { return inverse_right_jacobian(x); }, theta);
}

}  // namespace
}  // namespace named_attitude_words_test
