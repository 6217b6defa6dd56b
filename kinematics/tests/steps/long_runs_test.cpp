#include <gtest/gtest.h>

#include <random>
#include <vectrix/kinematics/steps/exponential_step.hpp>
#include <vectrix/kinematics/steps/group_runge_kutta.hpp>
#include <vectrix/kinematics/steps/gyro.hpp>

#include "testing/attitudes.hpp"
#include "testing/trials.hpp"

// The rounding of equal steps has a direction. It must not add up.
namespace vectrix_test::long_runs_test {
namespace {

using namespace vectrix;

constexpr int steps = trials(trials(1'000'000));  // a hundredth under the sanitizers
/// What one step leaves: a product of three rounded numbers in each entry, and the square of what was before.
constexpr double rounding_units = 16;

template <class S> double off_the_group(const Dcm<Gcrf, Body, S>& R) {
  return static_cast<double>((R.matrix().transpose() * R.matrix() - detail::Square<S>::Identity()).norm());
}
template <class S> double off_the_group(const Quaternion<Gcrf, Body, S>& q) {
  return static_cast<double>(std::abs(q.eigen().norm() - S(1)));
}

template <class S> class LongRuns : public testing::Test {
 protected:
  static constexpr double bound = rounding_units * static_cast<double>(std::numeric_limits<S>::epsilon());

  template <class Count> static auto advance_by(const Count& count) {
    Dcm<Gcrf, Body, S> R = aligned<S>(to<Gcrf>, from<Body>);
    Quaternion<Gcrf, Body, S> q{detail::trusted, Eigen::Quaternion<S>::Identity()};
    for (int i = 0; i < steps; ++i) {
      const Increment<Gcrf, Body, S> theta{detail::trusted, count()};
      R = advance(R, theta);
      q = advance(q, theta);
    }
    EXPECT_LE(off_the_group(R), bound);
    EXPECT_LE(off_the_group(q), bound);
    return std::pair{R, q};
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(LongRuns, Scalars);

TYPED_TEST(LongRuns, OfEqualCountsStayOnTheGroup) {
  using Column = detail::Column<TypeParam>;
  // The correction does not turn the attitude: the roundings of a million steps are independent turns, and
  // that of the count adds up.
  const double drift = steps * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()) / 10;
  for (const Column& count :
       {Column(TypeParam(0.01), 0, 0), Column(TypeParam(0.003), TypeParam(-0.007), TypeParam(0.011))}) {
    const auto [R, q] = this->advance_by([&] { return count; });
    const Eigen::Matrix<long double, 3, 1> total = count.template cast<long double>() * steps;
    const Eigen::Matrix<long double, 3, 3> exact =
        Eigen::AngleAxis<long double>(total.norm(), total.normalized()).toRotationMatrix();
    EXPECT_LE((R.matrix().template cast<long double>() - exact).norm(), drift);
    EXPECT_LE((dcm(q).matrix().template cast<long double>() - exact).norm(), drift);
  }
}

TYPED_TEST(LongRuns, OfRandomCountsStayOnTheGroup) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<TypeParam> number(TypeParam(-0.5), TypeParam(0.5));
  this->advance_by([&] { return detail::Column<TypeParam>(number(random), number(random), number(random)); });
}

TYPED_TEST(LongRuns, OfStepsStayOnTheGroup) {
  using S = TypeParam;
  const auto seconds = [](double t) { return Quantity<si::time, S>::from_value(static_cast<S>(t)); };
  const auto w =
      angular_velocity(of<Body>, relative_to<Gcrf>,
                       vector<si::angular_velocity>(in<Body>, detail::Column<S>(S(1), S(0), S(0))));
  const auto rate = [&](const auto&, const auto&) { return w; };
  const auto expect_on_group = [&](const auto& start, const auto& step) {
    auto attitude = start;
    for (int i = 0; i < steps / 4; ++i) attitude = step(attitude);
    EXPECT_LE(off_the_group(attitude), this->bound);
  };
  const Dcm<Gcrf, Body, S> R = aligned<S>(to<Gcrf>, from<Body>);
  const auto t = seconds(0), dt = seconds(0.01);
  expect_on_group(R, [&](const auto& R_i_from_b) { return exponential_step(R_i_from_b, w, dt); });
  expect_on_group(quaternion(R), [&](const auto& q_i_from_b) { return exponential_step(q_i_from_b, w, dt); });
  expect_on_group(R, [&](const auto& R_i_from_b) { return munthe_kaas_step<4>(rate, R_i_from_b, t, dt); });
  expect_on_group(R, [&](const auto& R_i_from_b) { return munthe_kaas_step<5>(rate, R_i_from_b, t, dt); });
  expect_on_group(R, [&](const auto& R_i_from_b) { return commutator_free_step(rate, R_i_from_b, t, dt); });
}

TYPED_TEST(LongRuns, OfAGyroStayOnTheGroup) {
  using S = TypeParam;
  const auto none = detail::Column<S>(detail::Column<S>::Zero());
  GyroAttitude<Gcrf, Body, S> attitude(
      {detail::trusted, Eigen::Quaternion<S>::Identity()},
      gyro_errors(vector<si::angular_velocity>(in<Body>, none), vector<si::dimensionless>(in<Body>, none),
                  Eigen::Matrix<S, 3, 2>(Eigen::Matrix<S, 3, 2>::Zero())));
  const auto count = measured(angle_increment(
      of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Body>, detail::Column<S>(S(0.01), S(0), S(0)))));
  for (int i = 0; i < steps; ++i) attitude.add(count, Quantity<si::time, S>::from_value(S(0.01)));
  EXPECT_LE(off_the_group(attitude.attitude()), this->bound);
}

}  // namespace
}  // namespace vectrix_test::long_runs_test
