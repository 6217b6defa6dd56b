#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <vectrix/space/earth/site.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::curvature_test {
namespace {

using vectrix_test::coordinate;

constexpr double pi = std::numbers::pi;
constexpr double published = 5e-4;  // m: of the last digit
constexpr double rounding = 1e-15;

struct Place : north_east_down_frame {};

Geodetic at(double latitude, double longitude = 0.0, double height = 0.0) {
  return {GeodeticLatitude(latitude * si::radian), longitude * si::radian, height * si::metre};
}
Quantity<si::angle> angle(double value) {
  return value * si::radian;
}
Geodetic any_place(double height) {
  return at(0.5 * pi * *coordinate(), pi * *coordinate(), height);
}

// Along the horizontal in an azimuth, and along the vertical downwards, in ITRF.
struct Axes {
  Eigen::Vector3d ahead, down, position;
};
Axes axes_of(const Geodetic& place, double azimuth) {
  const auto site = north_east_down(from<Place>, place);
  const Eigen::Matrix3d R = site.rotation.matrix();
  return {R * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0), R.col(2),
          wgs84::position(place).coordinates()};
}
std::optional<Vector<earth::Itrf, si::length>> seen(const Eigen::Vector3d& r, const Eigen::Vector3d& d) {
  return wgs84::first_intersection(vector<si::length>(in<earth::Itrf>, r),
                                   vector<si::dimensionless>(in<earth::Itrf>, d));
}

// DMA TR 8350.2: the semi-major axis, and the polar radius of curvature a^2 / b.
TEST(Curvature, HasThePublishedRadii) {
  const auto equator = wgs84::radii_of_curvature(at(0.0));
  EXPECT_EQ(equator.prime_vertical, wgs84::semi_major_axis);
  EXPECT_NEAR(equator.meridian.value(), 6335439.327, published);
  for (const double pole : {0.5 * pi, -0.5 * pi}) {
    const auto radii = wgs84::radii_of_curvature(at(pole));
    EXPECT_NEAR(radii.prime_vertical.value(), 6399593.626, published);
    EXPECT_NEAR(radii.meridian.value(), radii.prime_vertical.value(), 10.0 * rounding * 6.4e6);
  }
}

// |d position / d latitude| = M + h,  |d position / d longitude| = (N + h) cos(latitude)
RC_GTEST_PROP(Curvature, IsTheDerivativeOfThePosition, ()) {
  const double height = 1e6 * *coordinate(), latitude = 1.5 * *coordinate(), longitude = pi * *coordinate();
  const auto radii = wgs84::radii_of_curvature(at(latitude, longitude, height));
  const double step = 1e-4;  // rad: h^2/6 of the third derivative is 2e-9 of it, and rounding 1e-12
  const auto slope = [&](double up, double east) {
    return norm(wgs84::position(at(latitude + up * step, longitude + east * step, height)) -
                wgs84::position(at(latitude - up * step, longitude - east * step, height)))
               .value() /
           (2.0 * step);
  };
  constexpr double error = 1e-8;
  RC_ASSERT(std::abs(slope(1.0, 0.0) / (radii.meridian.value() + height) - 1.0) <= error);
  RC_ASSERT(std::abs(slope(0.0, 1.0) / ((radii.prime_vertical.value() + height) * std::cos(latitude)) -
                     1.0) <= error);
}

// The surface is s^2 / (2 R) below the horizontal plane at a distance s ahead and behind, in the mean.
RC_GTEST_PROP(Curvature, InAnAzimuthIsThatOfTheNormalSection, ()) {
  const auto place = any_place(0.0);
  const double azimuth = pi * *coordinate(), s = 2e4, up = 100.0;  // m
  const auto axes = axes_of(place, azimuth);
  const auto depth = [&](double ahead) {
    const Eigen::Vector3d r = axes.position + ahead * axes.ahead - up * axes.down;
    return (seen(r, axes.down)->coordinates() - r).norm() - up;
  };
  const double R = wgs84::radius_of_curvature(place, angle(azimuth)).value();
  constexpr double fourth_order = 1e-5;  // s^2 / 4 R^2 is 2.5e-6
  RC_ASSERT(std::abs(0.5 * (depth(s) + depth(-s)) * 2.0 * R / (s * s) - 1.0) <= fourth_order);
  const auto radii = wgs84::radii_of_curvature(place);
  RC_ASSERT(std::abs(wgs84::radius_of_curvature(place, angle(0.0)) / radii.meridian - 1.0) <= rounding);
  RC_ASSERT(std::abs(wgs84::radius_of_curvature(place, angle(0.5 * pi)) / radii.prime_vertical - 1.0) <=
            rounding);
}

// A ray below the horizon meets the ground, one above does not, from 1 m to 1e8 m.
RC_GTEST_PROP(HorizonDip, IsWhereTheGroundEnds, ()) {
  const double height = std::pow(10.0, 4.0 + 4.0 * *coordinate());
  const auto place = any_place(height);
  const double azimuth = pi * *coordinate();
  const double dip = wgs84::horizon_dip(place, angle(azimuth)).value();
  const auto axes = axes_of(place, azimuth);
  const auto meets = [&](double below) {
    return seen(axes.position, std::cos(below) * axes.ahead + std::sin(below) * axes.down).has_value();
  };
  // The position is rounded to 2e-9 m or 2e-16 of it: of the height of 1 m, whose dip is 6e-4, 1e-12.
  constexpr double error = 1e-11;
  RC_ASSERT(meets(dip + error));
  RC_ASSERT(!meets(dip - error));
}

TEST(HorizonDip, ClosedForms) {
  EXPECT_EQ(wgs84::horizon_dip(at(0.7, 0.1, 0.0), angle(1.0)).value(), 0.0);
  // To the east on the equator the Earth is a circle.
  const double a = wgs84::semi_major_axis.value(), h = 700e3;
  EXPECT_NEAR(wgs84::horizon_dip(at(0.0, 2.0, h), angle(0.5 * pi)).value(), std::acos(a / (a + h)),
              4 * rounding);
  // At a pole it is the same all round; elsewhere it is not.
  EXPECT_NEAR(wgs84::horizon_dip(at(0.5 * pi, 0.0, h), angle(0.3)).value(),
              wgs84::horizon_dip(at(0.5 * pi, 0.0, h), angle(2.3)).value(), 4 * rounding);
  EXPECT_GT(wgs84::horizon_dip(at(0.8, 0.0, h), angle(pi)).value() -
                wgs84::horizon_dip(at(0.8, 0.0, h), angle(0.0)).value(),
            1e-4);
}

TEST(Curvature, RefusesBadInput) {
  const double nan = std::nan("");
  EXPECT_EQ(complaint([&] { (void)wgs84::radii_of_curvature(at(1.6)); }),
            "wgs84::radii_of_curvature: the latitude 1.6 rad is not in [-pi/2, pi/2]");
  EXPECT_THROW((void)wgs84::radius_of_curvature(at(nan), angle(0.0)), BadInput);
  EXPECT_EQ(complaint([&] { (void)wgs84::radius_of_curvature(at(0.1), angle(nan)); }),
            "wgs84::radius_of_curvature: the azimuth is nan rad");
  EXPECT_EQ(complaint([&] { (void)wgs84::horizon_dip(at(0.1, 0.0, -1.0), angle(0.0)); }),
            "wgs84::horizon_dip: the height is -1 m; there is no horizon");
  const double infinity = std::numeric_limits<double>::infinity();
  // Also the numbers that the radii do not need.
  EXPECT_EQ(complaint([&] { (void)wgs84::radii_of_curvature(at(0.1, nan, 0.0)); }),
            "wgs84::radii_of_curvature: the longitude nan rad is not finite");
  EXPECT_EQ(complaint([&] { (void)wgs84::radius_of_curvature(at(0.1, 0.0, -infinity), angle(0.0)); }),
            "wgs84::radius_of_curvature: the height -inf m is not finite");
  EXPECT_EQ(complaint([&] { (void)wgs84::horizon_dip(at(0.1, infinity, 1.0), angle(0.0)); }),
            "wgs84::horizon_dip: the longitude inf rad is not finite");
  EXPECT_THROW((void)wgs84::horizon_dip(at(0.1, 0.0, infinity), angle(0.0)), BadInput);
  EXPECT_THROW((void)wgs84::horizon_dip(at(0.1, 0.0, 1.0), angle(infinity)), BadInput);
}

}  // namespace
}  // namespace vectrix::curvature_test
