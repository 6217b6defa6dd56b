#include <gtest/gtest.h>

#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>

#include "parameter_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace parameter_rates_test {
namespace {

constexpr int instances = 200;

const auto sigma_of = [](const auto& numbers) {
  return modified_rodrigues(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Gcrf>, numbers));
};
const auto gibbs_of = [](const auto& numbers) {
  return gibbs_vector(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Body>, numbers));
};
const auto axis_angle_of = [](const auto& numbers) {
  using S = typename std::decay_t<decltype(numbers)>::Scalar;
  const Eigen::Matrix<S, 3, 1> axis = numbers.template tail<3>();
  return axis_angle(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Gcrf>, axis),
                    Quantity<si::angle, S>::from_value(numbers(0)));
};

template <int N, class Door>
MovingNumbers<N> moving(const Eigen::Matrix<Dual2, N, 1>& numbers, const Door& door) {
  return {numbers, dcm(door(numbers))};
}

// Short rotations and long ones, some beyond half a turn, where the shadow set is shorter.
TEST(ModifiedRodriguesRate, IsTheDerivativeInBothFramesAndBothWays) {
  std::mt19937_64 random(20261104);
  for (int i = 0; i < instances; ++i) {
    const auto numbers = moving<3>(quadratics(random, i % 2 == 0 ? 0.5 : 3.0), sigma_of);
    const double amplified = 1 + numbers.value.squaredNorm();
    expect_their_kinematics(sigma_of(numbers.value), numbers, amplified);
  }
}

TEST(GibbsRate, IsTheDerivativeInBothFramesAndBothWays) {
  std::mt19937_64 random(20261105);
  for (int i = 0; i < instances; ++i) {
    const auto numbers = moving<3>(quadratics(random, i % 2 == 0 ? 0.5 : 3.0), gibbs_of);
    const double amplified = 1 + numbers.value.squaredNorm();
    expect_their_kinematics(gibbs_of(numbers.value), numbers, amplified);
  }
}

// The angle is up to three turns; the axis stays a unit vector.
TEST(AxisAngleRate, IsTheDerivativeInBothFramesAndBothWays) {
  std::mt19937_64 random(20261106);
  for (int i = 0; i < instances; ++i) {
    const auto angle = quadratics(random, 18.0);
    const auto way = quadratics(random, 2.0);  // longitude and latitude of the axis
    Eigen::Matrix<Dual2, 4, 1> four;
    four << angle(0), Dual2(cos(way(0)) * cos(way(1))), Dual2(sin(way(0)) * cos(way(1))), Dual2(sin(way(1)));
    const auto numbers = moving<4>(four, axis_angle_of);
    const auto x = axis_angle_of(numbers.value);
    const double away = x.distance_from_singularity().value();
    if (away > 0.05) expect_their_kinematics(x, numbers, 2 / away);
  }
}

TEST(AxisAngleRate, AtTheSingularityIsBadInputThatSaysHowNear) {
  const auto text = message<BadInput>([] {
    rate(axis_angle_of(Eigen::Vector4d(1e-16, 0, 1, 0)), omega_of<Body>({1, 2, 3}));
  });
  EXPECT_TRUE(contains(text, "rate(angle and axis of ")) << text;
  EXPECT_TRUE(contains(text, "Gcrf): 1e-16 rad from the singularity, no turn or a full one")) << text;
  EXPECT_NE(message<BadInput>([] {
              second_rate(axis_angle_of(Eigen::Vector4d(2 * std::numbers::pi, 0, 1, 0)),
                          omega_of<Body>({1, 2, 3}), alpha_of<Body>({1, 2, 3}));
            }),
            "");
  const auto x = axis_angle_of(Eigen::Vector4d(1e-12, 0, 1, 0));
  const Eigen::Vector3d w(0.3, -0.7, 0.5);
  const auto back = angular_velocity_from(x, rate(x, omega_of<Gcrf>(w)), in<Gcrf>);
  EXPECT_LE(distance(back.coordinates(), w), rounding);
}

TEST(AxisAngleRate, ItsDoorKeepsTheAxisAUnitVector) {
  const auto x = axis_angle_of(Eigen::Vector4d(1, 0, 1, 0));
  EXPECT_EQ(parameter_rate(x, Eigen::Vector4d(5, 1, 0, 2)).coordinates(), Eigen::Vector4d(5, 1, 0, 2));
  for (const double along : {0.25, -0.25}) {
    const auto text = message<BadInput>([&] { parameter_rate(x, Eigen::Vector4d(5, 1, along, 2)); });
    EXPECT_TRUE(contains(text, "parameter_rate(angle and axis of ")) << text;
    EXPECT_TRUE(contains(text, "the rate of the axis along the axis is " + detail::text(along) + " 1/s"))
        << text;
  }
}

// n . n'' = -|n'|^2: of two second derivatives of a moving axis, one is valid.
TEST(AxisAngleRate, ASecondRateThatStretchesTheAxisIsBadInput) {
  const auto x = axis_angle(of<Body>, relative_to<Gcrf>, unit_x(in<Gcrf>), 1.0 * si::radian);
  const auto xdot = parameter_rate(x, Eigen::Vector4d(0, 0, 2, 0));
  const auto alpha = [&](double along) {
    return angular_acceleration_from(x, xdot, second_parameter_rate(x, Eigen::Vector4d(0, along, 0, 0)),
                                     in<Body>);
  };
  // alpha = s n'' (+ phi' terms, here zero) - (1 - c) n x n'' (along n, here zero): -4 sin 1 about x.
  EXPECT_LE(distance(alpha(-4).coordinates(), Eigen::Vector3d(-4 * std::sin(1.0), 0, 0)), rounding);
  const std::string text = message<BadInput>([&] { alpha(0); });
  EXPECT_TRUE(contains(text, "angular_acceleration(angle and axis of ") &&
              contains(text, "along the axis is 0 1/s^2; that of a unit vector is -|n'|^2, -4 1/s^2"))
      << text;
}

// At zero rotation the parameters are a quarter and half of the rotation vector, and their rates of its rate.
TEST(ModifiedRodriguesRate, AtNoTurnIsAQuarterOfTheRateAndOfGibbsHalf) {
  const Eigen::Vector3d w(0.25, -0.75, 0.5);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_EQ(rate(sigma_of(none), omega_of<Body>(w)).coordinates(), w / 4);
  EXPECT_EQ(rate(gibbs_of(none), omega_of<Body>(w)).coordinates(), w / 2);
}

TEST(ModifiedRodriguesRate, OfTheShadowIsThatOfTheSameRate) {
  const auto sigma = sigma_of(Eigen::Vector3d(0.9, -0.6, 0.4));
  const auto w = omega_of<Body>({0.3, -0.7, 0.5});
  const auto by_rate = rate(sigma.shadow(), w).coordinates();
  EXPECT_LE(distance(shadow_rate(sigma, rate(sigma, w)).coordinates(), by_rate), rounding);
  EXPECT_GT(distance(rate(sigma, w).coordinates(), by_rate), visible);
}

// A spin about one axis: sigma = tan(phi/4), g = tan(phi/2), in closed form.
TEST(ParameterRates, OfASpinAreThoseOfTheTangent) {
  const double phi = 2.2, spin = 0.7, growth = -0.4;
  const Eigen::Vector3d n = Eigen::Vector3d(2, -1, 2) / 3;
  const double quarter = std::tan(phi / 4), half = std::tan(phi / 2);
  const auto expect = [&](const auto& x, double k, double tangent) {
    const auto xdot = rate(x, omega_of<Gcrf>(spin * n));
    const auto xddot = second_rate(x, omega_of<Gcrf>(spin * n), alpha_of<Gcrf>(growth * n));
    const double slope = k * (1 + tangent * tangent);
    EXPECT_LE(distance(xdot.coordinates(), slope * spin * n), rounding);
    EXPECT_LE(distance(xddot.coordinates(), (slope * growth + 2 * k * slope * tangent * spin * spin) * n),
              rounding);
  };
  expect(sigma_of(Eigen::Vector3d(quarter * n)), 0.25, quarter);
  expect(gibbs_of(Eigen::Vector3d(half * n)), 0.5, half);
}

template <class X, class Rate, class C>
concept TakesBack = requires(const X& x, const Rate& xdot, C in_c) {
  angular_velocity_from(x, xdot, in_c);
};
template <class X, class W>
concept Drives = requires(const X& x, const W& w) {
  rate(x, w);
};
template <class X, class W, class Alpha>
concept DrivesTwice = requires(const X& x, const W& w, const Alpha& alpha) {
  second_rate(x, w, alpha);
};
using Sigma = ModifiedRodrigues<Gcrf, Body>;
using Gibbs = GibbsVector<Gcrf, Body>;
template <class C> using W = AngularVelocity<Gcrf, Body, In<C>>;
template <class C> using Alpha = AngularAcceleration<Gcrf, Body, In<C>>;

static_assert(TakesBack<Sigma, ParameterRate<Sigma>, In<Body>> &&
              TakesBack<Sigma, ParameterRate<Sigma>, In<Gcrf>>);
static_assert(!TakesBack<Gibbs, ParameterRate<Sigma>, In<Body>> &&
              !TakesBack<Sigma, ParameterRate<Sigma>, In<Camera>>);
static_assert(Drives<Gibbs, W<Body>> && Drives<Gibbs, W<Gcrf>> && !Drives<Gibbs, W<Camera>>);
static_assert(!Drives<Gibbs, AngularVelocity<Body, Gcrf, In<Body>>> && !Drives<Gibbs, Alpha<Body>>);
static_assert(DrivesTwice<Gibbs, W<Gcrf>, Alpha<Gcrf>> && !DrivesTwice<Gibbs, W<Gcrf>, Alpha<Body>>);
static_assert(!std::is_convertible_v<Sigma, Gibbs> && !std::is_convertible_v<Gibbs, Sigma>);

}  // namespace
}  // namespace parameter_rates_test
