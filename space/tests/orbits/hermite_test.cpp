#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <vectrix/space/orbits/hermite.hpp>

namespace vectrix::hermite_test {
namespace {

struct Fixed : moving_frame {};

// Rounding of numbers of the size 100.
constexpr double rounding = 1e-13;

PositionVelocity<Fixed> sample(const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
  return {vector<si::length>(in<Fixed>, r), vector<si::velocity>(in<Fixed>, v)};
}

// r(t) = (t^3, 1 - t^2, t), which a cubic has to reproduce.
PositionVelocity<Fixed> cubic(double t) {
  return sample({t * t * t, 1.0 - t * t, t}, {3.0 * t * t, -2.0 * t, 1.0});
}

TEST(Hermite, ReproducesCubics) {
  for (const double t : {0.0, 0.3, 2.0, 3.7, 4.0}) {
    const auto found = hermite(cubic(1.0), cubic(5.0), 4.0 * si::second, t * si::second);
    const auto exact = cubic(1.0 + t);
    EXPECT_LT(norm(found.position - exact.position).value(), rounding) << t;
    EXPECT_LT(norm(found.velocity - exact.velocity).value(), rounding) << t;
  }
}

TEST(Hermite, IsOffACircleByItsFourthDerivative) {
  const auto circle = [](double t) {
    return sample({std::cos(t), std::sin(t), 0.0}, {-std::sin(t), std::cos(t), 0.0});
  };
  const double h = 0.1;
  const auto middle = hermite(circle(0.0), circle(h), h * si::second, 0.5 * h * si::second);
  const double error = norm(middle.position - circle(0.5 * h).position).value();
  const double law = std::pow(h, 4) / 384.0;
  const double next_order = 0.01;  // h^2, the relative size of what the law leaves out
  EXPECT_NEAR(error, law, next_order * law);
}

TEST(Hermite, RefusesTimesOutside) {
  for (const double t : {-0.1, 4.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(hermite(cubic(1.0), cubic(5.0), 4.0 * si::second, t * si::second), BadInput) << t;
  }
  EXPECT_THROW(hermite(cubic(1.0), cubic(5.0), 0.0 * si::second, 0.0 * si::second), BadInput);
  EXPECT_THROW(
      hermite(cubic(1.0), cubic(5.0), std::numeric_limits<double>::infinity() * si::second, 1.0 * si::second),
      BadInput);
}

}  // namespace
}  // namespace vectrix::hermite_test
