#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <vectrix/frames.hpp>
#include <vectrix/frames/scalar/dual.hpp>

// The derivative of each function against differences of long double, and the algebra of frames in duals.
namespace vectrix::dual_test {
namespace {

struct A : inertial_frame {};
struct B : moving_frame {};

struct Law {
  const char* name;
  std::function<Dual(Dual)> of_dual;
  std::function<long double(long double)> exact;
};
#define LAW(expression)                                                                                      \
  {                                                                                                          \
#expression, [](auto x) -> Dual { return expression; }, [](auto x) -> long double { return expression; } \
  }

// A central difference is off by h^2 f'''/6, here below 1e-9, and its rounding 1e-19/h.
TEST(Dual, HasTheDerivativesOfFunctions) {
  using std::abs, std::sqrt, std::cbrt, std::sin, std::cos, std::tan, std::asin, std::acos, std::atan,
      std::atan2, std::exp, std::expm1, std::log, std::sinh, std::cosh, std::tanh, std::pow;
  const std::vector<Law> laws{
      LAW(x + x * x), LAW(2.0 - x),    LAW(x / (1.0 + x)), LAW(-x),      LAW(3.0 / x),
      LAW(abs(-x)),   LAW(sqrt(x)),    LAW(cbrt(x)),       LAW(sin(x)),  LAW(cos(x)),
      LAW(tan(x)),    LAW(asin(x)),    LAW(acos(x)),       LAW(atan(x)), LAW(atan2(x, 2.0 - x * x)),
      LAW(exp(x)),    LAW(expm1(x)),   LAW(log(x)),        LAW(sinh(x)), LAW(cosh(x)),
      LAW(tanh(x)),   LAW(pow(x, 2.5))};
  constexpr long double h = 1e-5L;
  for (const Law& law : laws) {
    for (const double at : {0.3, 0.75}) {
      const Dual found = law.of_dual(Dual(at, 2.0));
      const long double slope = (law.exact(at + h) - law.exact(at - h)) / (2 * h);
      EXPECT_NEAR(found.value(), static_cast<double>(law.exact(at)), 4e-16 * (1.0 + std::abs(found.value())))
          << law.name;
      EXPECT_NEAR(found.derivatives(), 2.0 * static_cast<double>(slope), 1e-7) << law.name << " at " << at;
    }
  }
}

#undef LAW

TEST(Dual, WhereTheDerivativeIsNotFiniteItSaysSo) {
  EXPECT_FALSE(isfinite(sqrt(Dual(0.0, 1.0))));
  EXPECT_TRUE(isfinite(sqrt(Dual(0.0))));  // a constant has no derivative
  EXPECT_FALSE(isfinite(Dual(0.0, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(Dual(1.0, 5.0) == Dual(1.0));
  EXPECT_TRUE(Dual(1.0) < 2.0 && 2.0 > Dual(1.0));
}

// As of sqrt: where a function has no slope, what does not move has still the derivative zero; and a power of
// zero is a constant.
TEST(Dual, WhatDoesNotMoveHasNoDerivativeWhereThereIsNoSlope) {
  for (const double end : {-1.0, 1.0}) {
    EXPECT_EQ(asin(Dual(end)).derivatives(), 0.0);
    EXPECT_EQ(acos(Dual(end)).derivatives(), 0.0);
    EXPECT_FALSE(isfinite(asin(Dual(end, 1.0))));
    EXPECT_FALSE(isfinite(acos(Dual(end, 1.0))));
  }
  EXPECT_FALSE(isfinite(asin(Dual(2.0))));
  EXPECT_FALSE(isfinite(sqrt(Dual(-1.0))));
  EXPECT_EQ(atan2(Dual(0.0), Dual(0.0)).derivatives(), 0.0);
  EXPECT_FALSE(isfinite(atan2(Dual(0.0, 1.0), Dual(0.0))));
  EXPECT_EQ(pow(Dual(0.0, 1.0), 0.0).derivatives(), 0.0);
  EXPECT_EQ(pow(Dual(0.0, 1.0), 1.0).derivatives(), 1.0);
}

// b turned about z by an angle gives a, so that w_ab = -angle' z: d/dt R_b^a r = R_b^a (w_ab x r + r')
TEST(Dual, RunsThroughTheAlgebraOfFrames) {
  const Eigen::Vector3d r(0.3, -1.2, 0.8), rdot(-0.4, 0.1, 2.0);
  const double angle = 0.7, rate = 1.3;
  const auto R_a_from_b = turned_z(to<A>, from<B>, Quantity<si::angle, Dual>::from_value(Dual(angle, rate)));
  Eigen::Matrix<Dual, 3, 1> dual;
  for (Eigen::Index i = 0; i < 3; ++i) dual[i] = Dual(r[i], rdot[i]);
  const auto r_a = R_a_from_b * vector<si::length>(in<B>, dual);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d wanted = R * (-rate * Eigen::Vector3d::UnitZ().cross(r) + rdot);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(r_a.coordinates()[i].derivatives(), wanted[i], 1e-14);
  const Eigen::Matrix<Dual, 3, 1> scaled = 2.0 * dual - dual * 0.5;
  EXPECT_EQ(scaled[2].derivatives(), 3.0);
}

}  // namespace
}  // namespace vectrix::dual_test
