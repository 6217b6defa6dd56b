#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/estimation.hpp>
#include <vectrix/kinematics/named/steps.hpp>

#include "words.hpp"

namespace named_estimation_words_test {
using namespace named_words;
namespace {

constexpr auto sigma = 0.01 * si::radian;

RC_GTEST_PROP(NamedCovariance, LawsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const Eigen::Vector3d v = *triple(), u = *triple();
  const Eigen::Matrix3d square = v * v.transpose() + u * u.transpose() + Eigen::Matrix3d::Identity();
  words.agree([&](const auto& in_a) { return covariance<si::length>(in_a, square); }, in<A>);
  words.agree([&](const auto& in_a) { return covariance<si::length>(in_a, Eigen::Matrix3d(-square)); },
              in<A>);
  words.agree([&](const auto& in_a) { return trust_covariance<si::length>(in_a, square); }, in<A>);
  const auto spread = [&](const auto& in_a) {
    return covariance_from_standard_deviations(in_a, v.x() * si::metre, v.y() * si::metre, v.z() * si::metre);
  };
  words.agree(spread, in<A>);
  const auto P_a = covariance<si::length>(in<A>, square);
  words.agree([](const auto& R, const auto& P) { return R * P; }, any_rotation(to<B>, from<A>), P_a);
  words.agree([](const auto& P, const auto& Q) { return P + Q; }, P_a, P_a);
  words.agree([](const auto&... x) { return variance_along(x...); }, P_a, unit_y(in<A>));
  words.agree([](const auto&... x) { return mahalanobis_distance(x...); }, P_a, vector_in<si::length>(in<A>));
}

RC_GTEST_PROP(NamedEstimation, AttitudesOfDirectionsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R_a_from_b = any_rotation(to<A>, from<B>);
  const auto b1 = unit_x(in<B>), b2 = unit_y(in<B>);
  const auto a1 = R_a_from_b * b1, a2 = R_a_from_b * direction(b1 + 100.0 * b2);
  words.agree([](const auto&... x) { return observation(x..., sigma, 2.0).measured(); }, b1, a1);
  words.agree([](const auto&... x) { return observation(x..., sigma, 2.0).reference(); }, b1, a1);
  words.agree([](const auto&... x) { return observation(x..., sigma, -1.0).weight(); }, b1, a1);
  words.agree([](const auto&... x) { return observation(x..., -sigma).deviation(); }, b1, a1);
  words.agree([](const auto&... x) { return triad(x...); }, to<B>, from<A>, b1, a1, b2, a2);
  const std::vector first{observation(b1, a1, sigma), observation(b2, a2, sigma, 2.0)};
  const auto by_two = [](const auto& b, const auto& a, const auto& list) {
    const auto fit = triad(b, a, list[0], list[1]);
    return std::tuple(fit.rotation, fit.covariance, fit.mismatch);
  };
  const auto best = [](const auto&... x) {
    const auto fit = wahba(x...);
    return std::tuple(fit.rotation, fit.loss, fit.observability, fit.least_observed);
  };
  const auto sure = [](const auto&... x) { return wahba(x...).covariance; };
  words.agree(by_two, to<B>, from<A>, first);
  words.agree(best, to<B>, from<A>, first);
  words.agree(sure, to<B>, from<A>, first);
  words.agree(best, to<B>, from<A>,
              std::vector{weighted_observation(b1, a1, 1.0), weighted_observation(b2, a2, 3.0)});
  words.agree(best, to<B>, from<A>, std::vector<Observation<B, A>>{});
}

RC_GTEST_PROP(NamedEstimation, MeansOfRotationsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R = any_rotation(to<B>, from<A>), S = any_rotation(to<B>, from<A>);
  const auto mean = [](const auto&... x) {
    const auto found = mean_rotation(x...);
    return std::tuple(found.rotation, found.scatter, found.agreement);
  };
  words.agree(mean, to<B>, from<A>, std::vector{R, S});
  words.agree(mean, to<B>, from<A>, std::vector{quaternion(R), quaternion(S)});
  words.agree(mean, to<B>, from<A>, std::vector{weighted(R, 2.0), weighted(quaternion(S), 3.0)});
  words.agree([](const auto& b, const auto& a,
                 const auto& x) { return mean_rotation(b, a, std::vector{weighted(x, -1.0)}).agreement; },
              to<B>, from<A>, R);
}

RC_GTEST_PROP(NamedEstimation, MotionOfSamplesIsThatOfTypes, ()) {
  const Words words(sometimes());
  std::vector<AttitudeSample<A, B>> samples;
  for (int i = 0; i < 5; ++i)
    samples.push_back({i * si::second, quaternion(turned_z(to<A>, from<B>, 0.1 * i * i * si::radian))});
  words.agree(
      [](const auto& x) {
        const auto found = estimate_motion<2>(x, 2.1 * si::second, 3.0 * si::second, sigma);
        return std::tuple(found.motion, found.attitude_covariance, found.rate_covariance,
                          found.acceleration_covariance, found.loss, found.freedom);
      },
      samples);
}

// The rate is (t k)^b: of the time, and of the attitude that the step has reached.
RC_GTEST_PROP(NamedStep, StepsByAFunctionAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R = any_rotation(to<A>, from<B>);
  const auto k_a = vector_in<si::angular_velocity>(in<A>);
  const auto k_b = vector_in<si::angular_velocity>(in<B>), l_b = vector_in<si::angular_velocity>(in<B>);
  const auto t = 0.7 * si::second, dt = 0.1 * si::second;
  const auto agree = [&](const auto& step) {
    words.agree(
        [&](const auto& b, const auto& a, const auto& rotation, const auto& k) {
          return step(
              [&](const Quantity<si::time>& now, const auto& reached) {
                return angular_velocity(b, a, now.value() * (inverse(reached) * k));
              },
              rotation);
        },
        of<B>, relative_to<A>, R, k_a);
  };
  agree([&](const auto& rate, const auto& start) { return munthe_kaas_step<4>(rate, start, t, dt); });
  agree([&](const auto& rate, const auto& start) { return munthe_kaas_step<5>(rate, start, t, dt); });
  agree([&](const auto& rate, const auto& start) { return munthe_kaas_step<4>(rate, start, t, 1e3 * dt); });
  agree([&](const auto& rate, const auto& start) { return commutator_free_step(rate, start, t, dt); });
  const auto increment = [&](const auto& sum) {
    words.agree(
        [&](const auto& b, const auto& a, const auto& k, const auto& l) {
          return sum(
              [&](const Quantity<si::time>& now) { return angular_velocity(b, a, k + now.value() * l); });
        },
        of<B>, relative_to<A>, k_b, l_b);
  };
  increment([&](const auto& rate) { return magnus_increment<2>(rate, t, dt); });
  increment([&](const auto& rate) { return magnus_increment<4>(rate, t, dt); });
  increment([&](const auto& rate) { return magnus_increment<6>(rate, t, dt); });
}

// A rate whose frames change with the time.
TEST(NamedStep, TheFramesOfARateStay) {
  const Words words;
  const NamedFrame a = words.graph.frame("a"), b = words.graph.frame("b"), c = words.graph.frame("c");
  const auto rate = [&](const Quantity<si::time>& t) {
    return angular_velocity(Of(b), RelativeTo(t.value() < 0.5 ? a : c), zero<si::angular_velocity>(In(b)));
  };
  const std::string said =
      message<BadInput>([&] { magnus_increment<4>(rate, 0.0 * si::second, 1.0 * si::second); });
  EXPECT_TRUE(contains(said, R"(magnus_increment(w of "b" relative to ")")) << said;
  EXPECT_TRUE(contains(said, R"("a" and "c" are)") || contains(said, R"("c" and "a" are)")) << said;
}

RC_GTEST_PROP(NamedStep, StepsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto R = any_rotation(to<A>, from<B>);
  const auto q = quaternion(R);
  const auto w = any_rate(of<B>, relative_to<A>, in<B>);
  const auto dt = 0.1 * si::second;
  const auto theta = turned_by(w, dt);
  const auto step = [&](const auto&... x) { return exponential_step(x..., dt); };
  words.agree([](const auto&... x) { return advance(x...); }, R, theta);
  words.agree([](const auto&... x) { return advance(x...); }, q, theta);
  words.agree([&](const auto& x) { return turned_by(x, dt); }, w);
  words.agree(step, R, w);
  words.agree(step, q, w);
  words.agree([](const auto&... x) { return exponential_step(x..., no_number * si::second); }, R, w);
  words.agree([&](const auto&... x) { return first_order_step(x..., dt); }, R, w);
  words.agree([](const auto& x) { return nearest_dcm(x).dcm; }, first_order_step(R, w, dt));
  words.agree([](const auto&... x) { return angle_increment(x...); }, of<B>, relative_to<A>,
              vector_in<si::angle>(in<B>));
  const auto count = [] { return angle_increment(of<B>, relative_to<A>, vector_in<si::angle>(in<B>)); };
  const auto corrected = [](const auto&... x) { return coning_corrected(x...); };
  const auto after = [](const auto&... x) { return coning_corrected_after(x...); };
  words.agree([](const auto& x, const auto& y) { return x + y; }, count(), count());
  words.agree(corrected, count(), count());
  words.agree(corrected, count(), count(), count());
  words.agree(corrected, count(), dt, count(), 2.0 * dt);
  words.agree(after, count(), count());
  words.agree(after, count(), dt, count(), 2.0 * dt);
}

}  // namespace
}  // namespace named_estimation_words_test
