#include <gtest/gtest.h>

#include <random>

#include "batches.hpp"
#include "testing/any_scalar.hpp"

// The library's own sine, cosine and arc tangent, compared with long double.
namespace vectrix_test::lane_angles_test {
namespace {

constexpr int instances = 20000;
/// One rounding of the angle minus its quarter turns, and one of each of the last two operations.
constexpr double sine_ulp = 2.0;
/// Half an ulp for each of: difference, sum and quotient, which have at most that effect in the result; the
/// series; pi/4, pi/2 or pi; and the sum with it.
constexpr double arc_tangent_ulp = 3.0;

double ulp_error(double found, long double wanted) {
  const double near = std::abs(static_cast<double>(wanted));
  const double ulp = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
  return static_cast<double>(std::abs(found - wanted) / ulp);
}

template <class S> struct LaneAngles : testing::Test {};
TYPED_TEST_SUITE(LaneAngles, Batches);

/// Angles of every size up to `largest`, and angles next to a multiple of a quarter turn.
std::vector<double> hard_angles(double largest) {
  std::mt19937_64 random(20261123);
  std::uniform_real_distribution<double> exponent(-30.0, std::log10(largest)), sign(-1.0, 1.0);
  std::vector<double> angles{0.0, 5e-324, 1e-300, largest, -largest};
  for (int i = 0; i < instances; ++i) {
    angles.push_back(std::copysign(std::min(largest, std::pow(10.0, exponent(random))), sign(random)));
    const double quarters = std::round(sign(random) * largest / 1.6);
    angles.push_back(quarters * 1.5707963267948966);
  }
  return angles;
}

TYPED_TEST(LaneAngles, SineAndCosineAreAccurateToRounding) {
  using S = TypeParam;
  const auto angles = hard_angles(detail::batch_angle_limit);
  for (std::size_t i = 0; i + S::size() <= angles.size(); i += S::size()) {
    const S x([&](auto lane) { return angles[i + lane]; });
    const auto [sine, cosine] = detail::sine_cosine(x);
    for (std::size_t lane = 0; lane < S::size(); ++lane) {
      const long double angle = angles[i + lane];
      ASSERT_LE(ulp_error(sine[lane], std::sin(angle)), sine_ulp) << angles[i + lane];
      ASSERT_LE(ulp_error(cosine[lane], std::cos(angle)), sine_ulp) << angles[i + lane];
    }
  }
}

TYPED_TEST(LaneAngles, SineOfALargeAngleIsThatOfADouble) {
  using S = TypeParam;
  for (const double angle : {1.0000001e6, -4e9, 1e15, 1e300}) {
    S x(0.3);
    x[S::size() - 1] = angle;
    const auto [sine, cosine] = detail::sine_cosine(x);
    EXPECT_EQ(double(sine[S::size() - 1]), std::sin(angle));
    EXPECT_EQ(double(cosine[S::size() - 1]), std::cos(angle));
  }
  const auto [sine, cosine] = detail::sine_cosine(S(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(none_of(sine == sine) && none_of(cosine == cosine));
}

/// (y, x) in every quadrant, on the axes, and of every size.
std::vector<std::pair<double, double>> hard_points() {
  std::vector<std::pair<double, double>> points;
  for (const double angle : hard_angles(M_PI)) points.emplace_back(std::sin(angle), std::cos(angle));
  for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300}) points.emplace_back(y, x);
  }
  return points;
}

void expect_arc_tangent(double found, double y, double x) {
  const long double wanted = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  EXPECT_LE(ulp_error(found, wanted), arc_tangent_ulp) << y << ", " << x;
  EXPECT_EQ(std::signbit(found), std::signbit(wanted)) << y << ", " << x;
}

TYPED_TEST(LaneAngles, ArcTangentIsAccurateToRoundingInEveryQuadrant) {
  using S = TypeParam;
  const auto points = hard_points();
  for (std::size_t i = 0; i + S::size() <= points.size(); i += S::size()) {
    const S y([&](auto lane) { return points[i + lane].first; });
    const S x([&](auto lane) { return points[i + lane].second; });
    const S angle = detail::arc_tangent(y, x);
    for (std::size_t lane = 0; lane < S::size(); ++lane) expect_arc_tangent(angle[lane], y[lane], x[lane]);
  }
}

TEST(Angles, ArcTangentOfADoubleIsAccurateToRoundingInEveryQuadrant) {
  for (const auto& [y, x] : hard_points()) expect_arc_tangent(detail::arc_tangent(y, x), y, x);
}

}  // namespace
}  // namespace vectrix_test::lane_angles_test
