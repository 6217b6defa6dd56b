#include <gtest/gtest.h>

#include <functional>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace integration_test {
namespace {

using Rotation = Dcm<Gcrf, Body>;
using BodyRate = AngularVelocity<Gcrf, Body, In<Body>>;
using Time = Quantity<si::time>;

const Eigen::Vector3d w0(0.5, 0.0, 1.0);
constexpr double turning = 20.0;  // rad/s

Rotation start() {
  return aligned(to<Gcrf>, from<Body>);
}
Eigen::Matrix3d turn(const Eigen::Vector3d& theta) {
  return Eigen::AngleAxisd(theta.norm(), theta.stableNormalized()).matrix();
}

/// w_ab^b = S w0, S = exp(20 t [e3]x): then (R S)' = (R S) [w0 + 20 e3]x, in closed form
///     R = exp(t [w0 + 20 e3]x) exp(-20 t [e3]x)
BodyRate coning(const Time& t) {
  const double angle = turning * t.value();
  return angular_velocity(of<Body>, relative_to<Gcrf>,
                          vector<si::angular_velocity>(
                              in<Body>, Eigen::Vector3d(0.5 * std::cos(angle), 0.5 * std::sin(angle), 1.0)));
}
Eigen::Matrix3d coned(double t) {
  return turn(t * (w0 + turning * Eigen::Vector3d::UnitZ())) * turn(-t * turning * Eigen::Vector3d::UnitZ());
}

/// R = exp(t a) exp(t b) exp(t c), whose rate, written so that it depends on the attitude, is
///     w_ab^b = R^T a + exp(-t c) b + c
const Eigen::Vector3d a(3.0, -2.0, 1.0), b(1.0, 4.0, -2.0), c(-2.0, 1.0, 5.0);
Eigen::Matrix3d three_turns(double t) {
  return turn(t * a) * turn(t * b) * turn(t * c);
}
BodyRate rate_of_three_turns(const Time& t, const Rotation& R_a_from_b) {
  return angular_velocity(
      of<Body>, relative_to<Gcrf>,
      inverse(R_a_from_b) * vector<si::angular_velocity>(in<Gcrf>, a) +
          vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(turn(c * -t.value()) * b + c)));
}

using Step = std::function<Rotation(const Rotation&, const Time& t, const Time& dt)>;

double error_after_one_second(const Step& step, const Eigen::Matrix3d& exact, int steps) {
  Rotation R_a_from_b = start();
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) R_a_from_b = step(R_a_from_b, i * h * si::second, h * si::second);
  EXPECT_LE(distance(R_a_from_b.matrix().transpose() * R_a_from_b.matrix(), Eigen::Matrix3d::Identity()),
            steps * rounding);
  return (R_a_from_b.matrix() - exact).norm();
}

/// Halving the step reduces the error according to the order, within a third.
void expect_order(int order, const Step& step, const Eigen::Matrix3d& exact, int steps) {
  const double coarse = error_after_one_second(step, exact, steps);
  const double fine = error_after_one_second(step, exact, 2 * steps);
  EXPECT_NEAR(std::log2(coarse / fine), order, 0.34) << coarse << " and " << fine;
  EXPECT_GT(fine, 1e-12) << "rounding, not the order, is seen";
}

TEST(ExponentialStep, IsExactForAConstantRateAndElseOfOrderOneOrTwo) {
  const BodyRate w = coning(0.3 * si::second);
  const Rotation constant = exponential_step(start(), w, 2.0 * si::second);
  EXPECT_LE(distance(constant.matrix(), turn(2.0 * w.coordinates())), rounding);
  const Quaternion<Gcrf, Body> q = exponential_step(quaternion(start()), w, 2.0 * si::second);
  EXPECT_LE(distance(dcm(q).matrix(), constant.matrix()), rounding);
  expect_order(
      1, [](auto& R, auto& t, auto& dt) { return exponential_step(R, coning(t), dt); }, coned(1.0), 512);
  expect_order(
      2, [](auto& R, auto& t, auto& dt) { return exponential_step(R, coning(t + dt / 2.0), dt); }, coned(1.0),
      128);
}

// The body turns about one axis after another, so the order of the factors has an effect.
TEST(ExponentialStep, AdvancesOnTheRight) {
  const Rotation R0 = dcm(to<Gcrf>, from<Body>, turn({0.3, -0.8, 0.5}));
  const BodyRate w = coning(0.1 * si::second);
  const Increment<Gcrf, Body> theta = turned_by(w, 0.7 * si::second);
  EXPECT_LE(distance(advance(R0, theta).matrix(), R0.matrix() * turn(0.7 * w.coordinates())), rounding);
  EXPECT_GE(distance(advance(R0, theta).matrix(), turn(0.7 * w.coordinates()) * R0.matrix()), visible);
  EXPECT_LE(distance((before(R0) * exp(theta)).matrix(), advance(R0, theta).matrix()), rounding);
}

TEST(FirstOrderStep, LeavesTheGroupAndSaysByHowMuch) {
  const BodyRate w = coning(0.0 * si::second);
  const double h = 1e-2;
  const double square = w.coordinates().squaredNorm() * h * h;
  auto M = first_order_step(start(), w, h * si::second);
  EXPECT_NEAR(M.determinant(), 1.0 + square, rounding);
  EXPECT_NEAR(M.departure(), std::sqrt(2.0) * square, rounding);
  static_assert(!std::is_convertible_v<decltype(M), Rotation>);
  for (int i = 1; i < 100; ++i) M = first_order_step(M, coning(i * h * si::second), h * si::second);
  EXPECT_NEAR(M.determinant(), std::pow(1.0 + square, 100), 200 * rounding);
  EXPECT_GT(M.departure(), 0.01);
  const auto nearest = nearest_dcm(M);
  EXPECT_NEAR(nearest.distance, M.departure() / 2.0, 1e-4);  // |M - R| for M = R (I + E), M^T M = I + 2 E
  EXPECT_GT((nearest.dcm.matrix() - coned(1.0)).norm(), 1e-3);

  const auto projected = [](const Rotation& R, const Time& t, const Time& dt) {
    return nearest_dcm(first_order_step(R, coning(t), dt)).dcm;
  };
  expect_order(1, projected, coned(1.0), 512);
}

TEST(Magnus, ItsIncrementsHaveTheirOrders) {
  const auto by = [](auto order) -> Step {
    return [](const Rotation& R, const Time& t, const Time& dt) {
      return advance(R, magnus_increment<decltype(order)::value>(coning, t, dt));
    };
  };
  expect_order(2, by(std::integral_constant<int, 2>{}), coned(1.0), 64);
  expect_order(4, by(std::integral_constant<int, 4>{}), coned(1.0), 32);
  expect_order(6, by(std::integral_constant<int, 6>{}), coned(1.0), 16);
}

// A common statement is R(t + dt) = R(t) exp([int w]x). It is true only while w keeps its direction.
TEST(Magnus, TheExponentialOfTheIntegralIsNotTheRotation) {
  const Eigen::Vector3d integral(0.5 * std::sin(turning) / turning, 0.5 * (1.0 - std::cos(turning)) / turning,
                                 1.0);
  EXPECT_NEAR((turn(integral) - coned(1.0)).norm(), 0.024, 0.0005);
  // For each of 20 parts of a turn, one Magnus step of order 6 is more accurate by a factor of 1e5.
  Rotation R = start();
  for (int i = 0; i < 60; ++i) {
    R = advance(R, magnus_increment<6>(coning, i / 60.0 * si::second, 1.0 / 60.0 * si::second));
  }
  EXPECT_LE((R.matrix() - coned(1.0)).norm(), 1e-7);
}

TEST(GroupRungeKutta, ItsStepsHaveTheirOrders) {
  const auto rate = rate_of_three_turns;
  const Eigen::Matrix3d exact = three_turns(1.0);
  expect_order(
      4, [&](auto& R, auto& t, auto& dt) { return munthe_kaas_step<4>(rate, R, t, dt); }, exact, 64);
  expect_order(
      5, [&](auto& R, auto& t, auto& dt) { return munthe_kaas_step<5>(rate, R, t, dt); }, exact, 64);
  expect_order(
      4, [&](auto& R, auto& t, auto& dt) { return commutator_free_step(rate, R, t, dt); }, exact, 64);
}

// A rate of the time alone, with the closed-form factor of Bortz's equation, for steps of more than 0.2 rad.
TEST(GroupRungeKutta, TakesRatesOfTheTimeAndLongSteps) {
  const auto rate = [](const Time& t, const Rotation&) { return coning(t); };
  expect_order(
      4, [&](auto& R, auto& t, auto& dt) { return munthe_kaas_step<4>(rate, R, t, dt); }, coned(1.0), 64);
  expect_order(
      4, [&](auto& R, auto& t, auto& dt) { return commutator_free_step(rate, R, t, dt); }, coned(1.0), 64);
  const auto slow = [](const Time& t, const Rotation&) { return coning(t / 20.0); };
  const Eigen::Vector3d own(0.5, 0.0, 2.0);  // in 1 s: S turns by 1 rad
  const Eigen::Matrix3d exact = turn(2.0 * own) * turn(-2.0 * Eigen::Vector3d::UnitZ());
  Rotation R = start();
  for (const double t : {0.0, 0.5, 1.0, 1.5}) {
    R = munthe_kaas_step<5>(slow, R, t * si::second, 0.5 * si::second);
  }
  EXPECT_LE((R.matrix() - exact).norm(), 1e-5);
}

TEST(Steps, OfNoFiniteDurationAreBadInput) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    const auto dt = bad * si::second;
    const auto said = [&](const char* step) {
      return std::string{step} + "(of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>() +
             "): dt is " + detail::text(bad) + " s";
    };
    const BodyRate w = coning(0.0 * si::second);
    EXPECT_EQ(message<BadInput>([&] { exponential_step(start(), w, dt); }), said("exponential_step"));
    EXPECT_EQ(message<BadInput>([&] { first_order_step(start(), w, dt); }), said("first_order_step"));
    const auto once = first_order_step(start(), w, 0.1 * si::second);
    EXPECT_EQ(message<BadInput>([&] { first_order_step(once, w, dt); }), said("first_order_step"));
  }
}

// Where J_r^-1 is nearly singular, there is no correct shorter result: a rate of almost one turn per step.
TEST(GroupRungeKutta, AStageNearAFullTurnIsBadInput) {
  const auto spin = [](const Time& t, const Rotation&) {
    return angular_velocity(
        of<Body>, relative_to<Gcrf>,
        vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(1e-3 * t.value(), 0.0, 2 * std::numbers::pi)));
  };
  const auto step = [&](double dt) {
    return message<BadInput>([&] { munthe_kaas_step<4>(spin, start(), 0.0 * si::second, dt * si::second); });
  };
  EXPECT_TRUE(contains(step(1.0), "a stage turns by 6.283")) << step(1.0);
  EXPECT_EQ(step(0.9), "");
}

template <class Function, class... Given>
concept Takes = requires(const Function& f, const Given&... given) {
  f(given...);
};

TEST(Steps, AreRefusedWithRatesInOtherAxes) {
  const auto step = [](const auto& R, const auto& w) -> decltype(exponential_step(R, w, Time{})) {
    return exponential_step(R, w, Time{});
  };
  static_assert(Takes<decltype(step), Rotation, BodyRate>);
  static_assert(!Takes<decltype(step), Rotation, AngularVelocity<Gcrf, Body, In<Gcrf>>>);
  static_assert(!Takes<decltype(step), Rotation, AngularVelocity<Gcrf, Camera, In<Camera>>>);
  static_assert(!Takes<decltype(step), Dcm<Body, Gcrf>, BodyRate>);
}

}  // namespace
}  // namespace integration_test
