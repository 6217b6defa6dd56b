#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/space/earth/ellipsoid.hpp>

#include "temporary_file.hpp"

namespace vectrix::ellipsoid_test {
namespace {

constexpr double a = 6378137.0;                        // m
constexpr double b = a * (1.0 - 1.0 / 298.257223563);  // m
constexpr double pi = std::numbers::pi;

constexpr double length_rounding = 5e-9;  // m: a few times 1e-16 of the Earth's radius
constexpr double angle_rounding = 1e-15;  // rad
// A ray from 1e7 m that meets the surface at an angle of 1 degree or more.
constexpr double ray_rounding = 1e-6;  // m

Vector<earth::Itrf, si::length> r(double x, double y, double z) {
  return vector(in<earth::Itrf>, x * si::metre, y * si::metre, z * si::metre);
}
Vector<earth::Itrf, si::dimensionless> d(double x, double y, double z) {
  return vector<si::dimensionless>(in<earth::Itrf>, Eigen::Vector3d(x, y, z));
}

void expect_geodetic(const Vector<earth::Itrf, si::length>& position, double latitude, double longitude,
                     double height) {
  const Geodetic g = wgs84::geodetic(position);
  EXPECT_NEAR(g.latitude.angle.value(), latitude, angle_rounding);
  EXPECT_NEAR(g.longitude.value(), longitude, angle_rounding);
  EXPECT_NEAR(g.height.value(), height, length_rounding);
}

TEST(Ellipsoid, GeodeticOnTheAxes) {
  expect_geodetic(r(a + 1000.0, 0.0, 0.0), 0.0, 0.0, 1000.0);
  expect_geodetic(r(0.0, a, 0.0), 0.0, pi / 2.0, 0.0);
  expect_geodetic(r(-a - 5.0, 0.0, 0.0), 0.0, pi, 5.0);
  expect_geodetic(r(0.0, -a + 1.0, 0.0), 0.0, -pi / 2.0, -1.0);
  expect_geodetic(r(0.0, 0.0, b + 2000.0), pi / 2.0, 0.0, 2000.0);
  expect_geodetic(r(0.0, 0.0, -b), -pi / 2.0, 0.0, 0.0);
}

// At geodetic latitude phi: N = a^2 / sqrt(a^2 cos^2 + b^2 sin^2), p = (N + h) cos, z = (N b^2/a^2 + h) sin.
TEST(Ellipsoid, GeodeticByItsDefinition) {
  const double phi = 0.9;
  const double lambda = -2.0;
  const double h = 700e3;
  const double N = a * a / std::hypot(a * std::cos(phi), b * std::sin(phi));
  const double p = (N + h) * std::cos(phi);
  const auto position =
      r(p * std::cos(lambda), p * std::sin(lambda), (N * b * b / (a * a) + h) * std::sin(phi));
  expect_geodetic(position, phi, lambda, h);
  const auto back = wgs84::position({GeodeticLatitude(phi * si::radian), lambda * si::radian, h * si::metre});
  EXPECT_LT(norm(back - position).value(), length_rounding);
  EXPECT_NEAR(wgs84::up(position).coordinates().z(), std::sin(phi), angle_rounding);
  EXPECT_NEAR(wgs84::up(position).coordinates().x(), std::cos(phi) * std::cos(lambda), angle_rounding);
}

// Nearest is what no other latitude is nearer than; the point lies on the normal there. Depths to the
// evolute, whose largest distances are 42.7 km in the equator and 42.8 km on the axis, and heights to the
// edge of the solar system.
TEST(Ellipsoid, GeodeticIsTheNearestPointEverywhere) {
  std::mt19937_64 random(20261128);
  std::uniform_real_distribution<double> exponent(-1.0, 13.0), angle(0.0, pi);
  const auto surface = [](double latitude) {
    return wgs84::position({GeodeticLatitude(latitude * si::radian), 0.0 * si::radian, 0.0 * si::metre});
  };
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, exponent(random)), at = angle(random);
    const auto position = r(size * std::sin(at), 0.0, size * std::cos(at));
    const Geodetic g = wgs84::geodetic(position);
    EXPECT_LE(norm(wgs84::position(g) - position).value(), length_rounding + angle_rounding * size)
        << size << " m at " << at;
    for (int k = -50; k <= 50; ++k) {
      EXPECT_GE(norm(surface(k * pi / 100) - position).value(),
                std::abs(g.height.value()) - length_rounding - angle_rounding * size)
          << size << " m at " << at;
    }
  }
}

TEST(Ellipsoid, GeodeticNextToPolesAndEquator) {
  for (const double height : {-6.2e6, -1e5, 0.0, 5e5, 1e7, 1e12}) {
    for (const double off : {0.0, 1e-300, 1e-15, 1e-9, 1e-4, 1.0}) {
      for (const double latitude : {off, -off, pi / 2 - off, off - pi / 2}) {
        const Geodetic given{GeodeticLatitude(latitude * si::radian), 1.0 * si::radian, height * si::metre};
        const Geodetic g = wgs84::geodetic(wgs84::position(given));
        const double radius = a + height;  // that of the smallest circle through the point, or more
        EXPECT_NEAR(g.latitude.angle.value(), latitude, angle_rounding + 2 * length_rounding / radius)
            << height;
        EXPECT_NEAR(g.height.value(), height, length_rounding + angle_rounding * std::abs(height))
            << latitude;
      }
    }
  }
}

// Within the evolute, where the nearest point is on the other side of the equator for methods that iterate.
TEST(Ellipsoid, GeodeticDeepInside) {
  constexpr double printed_degrees = 5e-7, printed_metres = 5e-4;
  const auto expect = [](double x, double z, double degrees, double height) {
    const Geodetic g = wgs84::geodetic(r(x, 0.0, z));
    EXPECT_NEAR(g.latitude.angle.value() * 180 / pi, degrees, printed_degrees) << x << ", " << z;
    EXPECT_NEAR(g.height.value(), height, printed_metres) << x << ", " << z;
  };
  expect(3e4, 1e3, 47.180967, -6345516.306);
  expect(1e4, 1e4, 79.128216, -6345807.661);
  expect(1e5, 1e5, 53.333216, -6224458.123);
  EXPECT_NEAR(wgs84::geodetic(r(43000.0, 0.0, 10.0)).latitude.angle.value() * 180 / pi, 1.775059,
              printed_degrees);
  // On the disc and the axis: north on the disc, and continuous from the north.
  constexpr double next_to_disc = 1e-9;  // rad: 1e-6 m over the 4e4 m of the evolute, and more
  const double north = wgs84::geodetic(r(2e4, 0.0, 0.0)).latitude.angle.value();
  EXPECT_GT(north, 0.5);
  EXPECT_NEAR(wgs84::geodetic(r(2e4, 0.0, 1e-6)).latitude.angle.value(), north, next_to_disc);
  EXPECT_NEAR(wgs84::geodetic(r(2e4, 0.0, -1e-6)).latitude.angle.value(), -north, next_to_disc);
  EXPECT_EQ(wgs84::geodetic(r(0.0, 0.0, -1.0)).latitude.angle.value(), -pi / 2);
}

TEST(Ellipsoid, LongitudeIsAboveMinusPi) {
  EXPECT_EQ(wgs84::geodetic(r(-a, -0.0, 0.0)).longitude.value(), pi);
  EXPECT_EQ(wgs84::geodetic(r(-a, 0.0, 1.0)).longitude.value(), pi);
  EXPECT_EQ(wgs84::geodetic(r(-0.0, -0.0, b)).longitude.value(), 0.0);
}

TEST(Ellipsoid, RaysAlongTheAxes) {
  const auto expect_hit = [](const auto& origin, const auto& towards, const auto& point) {
    const auto hit = wgs84::first_intersection(origin, towards);
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(norm(*hit - point).value(), length_rounding);
  };
  expect_hit(r(7e6, 0.0, 0.0), d(-1.0, 0.0, 0.0), r(a, 0.0, 0.0));
  expect_hit(r(0.0, -9e6, 0.0), d(0.0, 0.3, 0.0), r(0.0, -a, 0.0));
  expect_hit(r(0.0, 0.0, 1e7), d(0.0, 0.0, -5.0), r(0.0, 0.0, b));
  // A point not on the axis: x^2/a^2 + z^2/b^2 = 1 at z = b/2.
  expect_hit(r(8e6, 0.0, b / 2.0), d(-1.0, 0.0, 0.0), r(a * std::sqrt(0.75), 0.0, b / 2.0));
}

TEST(Ellipsoid, RaysThatMiss) {
  EXPECT_FALSE(wgs84::first_intersection(r(7e6, 0.0, 0.0), d(1.0, 0.0, 0.0)));
  EXPECT_FALSE(wgs84::first_intersection(r(7e6, 0.0, 0.0), d(0.0, 1.0, 0.0)));
  EXPECT_FALSE(wgs84::first_intersection(r(7e6, 0.0, b + 0.01), d(-1.0, 0.0, 0.0)));
  EXPECT_TRUE(wgs84::first_intersection(r(7e6, 0.0, b - 0.01), d(-1.0, 0.0, 0.0)));
}

// Each ray is aimed at a known point of the near side and must find it.
TEST(Ellipsoid, RaysFindThePointTheyAreAimedAt) {
  std::mt19937_64 random(20220414);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int aimed = 0;
  while (aimed < 1000) {
    const auto point = wgs84::position({GeodeticLatitude(std::asin(part(random)) * si::radian),
                                        pi * part(random) * si::radian, 0.0 * si::metre});
    const auto origin =
        point +
        vector<si::length>(in<earth::Itrf>,
                           Eigen::Vector3d(1e7 * Eigen::Vector3d(part(random), part(random), part(random))));
    const auto ray = direction(point - origin);
    const double cosine_from_normal = -dot(ray, wgs84::up(point)).value();
    if (cosine_from_normal < std::sin(pi / 180.0)) continue;
    ++aimed;
    const auto hit = wgs84::first_intersection(origin, ray);
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(norm(*hit - point).value(), ray_rounding);
  }
}

TEST(Ellipsoid, AnOriginOnTheSurfaceIsTheAnswer) {
  const auto point = wgs84::position({GeodeticLatitude(0.7 * si::radian), 1.0 * si::radian, 0.0 * si::metre});
  for (const auto& towards : {d(0.0, 0.0, 1.0), d(0.0, 0.0, -1.0)}) {
    const auto hit = wgs84::first_intersection(point, towards);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->coordinates(), point.coordinates());
  }
}

TEST(Ellipsoid, RefusesBadInput) {
  EXPECT_EQ(complaint([] { wgs84::geodetic(r(0.0, 0.0, 0.0)); }),
            "wgs84::geodetic: the centre of the Earth has no latitude");
  EXPECT_EQ(complaint([] { wgs84::up(r(0.0, 0.0, 0.0)); }),
            "wgs84::up: the centre of the Earth has no latitude");
  EXPECT_EQ(complaint([] { wgs84::first_intersection(r(0.0, 0.0, 0.0), d(1.0, 0.0, 0.0)); }),
            "wgs84::first_intersection: the origin lies inside the ellipsoid, at a height of " +
                detail::text(-b) + " m");
  EXPECT_THROW(wgs84::first_intersection(r(a - 1.0, 0.0, 0.0), d(1.0, 0.0, 0.0)), BadInput);
  EXPECT_THROW(wgs84::first_intersection(r(7e6, 0.0, 0.0), d(0.0, 0.0, 0.0)), BadInput);
  const auto at = [](double latitude, double height) {
    return wgs84::position({GeodeticLatitude(latitude * si::radian), 0.0 * si::radian, height * si::metre});
  };
  EXPECT_EQ(complaint([&] { at(1.6, 0.0); }),
            "wgs84::position: the latitude 1.6 rad is not in [-pi/2, pi/2]");
  EXPECT_THROW(at(std::numeric_limits<double>::quiet_NaN(), 0.0), BadInput);
  EXPECT_EQ(complaint([&] { at(1.0, std::numeric_limits<double>::infinity()); }),
            "wgs84::position: the height inf m is not finite");
}

// A vector is finite when it is made, but not what is calculated of it.
TEST(Ellipsoid, RefusesPositionsThatAreNotFinite) {
  const auto far = 1e308 * r(10.0, -1e-300, 10.0), none = far - far;
  EXPECT_EQ(complaint([&] { (void)wgs84::geodetic(far); }),
            "wgs84::geodetic: the position (inf, -1e+08, inf) m is not finite, or too far");
  EXPECT_THROW((void)wgs84::geodetic(r(0.0, 1e200, 0.0)), BadInput);
  EXPECT_THROW((void)wgs84::geodetic(none), BadInput);
  EXPECT_THROW((void)wgs84::up(none), BadInput);
  EXPECT_THROW((void)earth::spherical(far), BadInput);
}

TEST(Ellipsoid, RefusesRaysFromTooFar) {
  EXPECT_EQ(complaint([] { (void)wgs84::first_intersection(r(1e200, 0.0, 0.0), d(-1.0, 0.0, 0.0)); }),
            "wgs84::first_intersection: |r| is 1e+200 m; the origin is too far");
}

// r = d (cos phi cos lambda, cos phi sin lambda, sin phi), and back.
TEST(Ellipsoid, SphericalCoordinates) {
  std::mt19937_64 random(20270503);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double phi = 0.5 * pi * part(random), lambda = pi * part(random), size = 1e7 * (1.1 + part(random));
    const auto at = earth::position(
        earth::Spherical{GeocentricLatitude(phi * si::radian), lambda * si::radian, size * si::metre});
    const Eigen::Vector3d expected = size * Eigen::Vector3d(std::cos(phi) * std::cos(lambda),
                                                            std::cos(phi) * std::sin(lambda), std::sin(phi));
    EXPECT_LE((at.coordinates() - expected).norm(), angle_rounding * size);
    const earth::Spherical back = earth::spherical(at);
    EXPECT_NEAR(back.latitude.angle.value(), phi, angle_rounding);
    EXPECT_LE(std::abs(back.longitude.value() - lambda) * std::cos(phi), angle_rounding);
    EXPECT_NEAR(back.distance.value(), size, angle_rounding * size);
  }
}

// On the surface tan(geocentric) = (1 - f)^2 tan(geodetic); they differ most, by 0.1924 deg, near 45 deg.
TEST(Ellipsoid, GeocentricLatitudeOfThePlaceOfAGeodeticOne) {
  const auto geocentric = [](double geodetic) {
    return earth::spherical(
               wgs84::position({GeodeticLatitude(geodetic * si::radian), 0.5 * si::radian, 0.0 * si::metre}))
        .latitude.angle.value();
  };
  for (const double phi : {-1.5, -0.7, -1e-3, 0.0, 0.3, 1.0, 1.57}) {
    EXPECT_NEAR(geocentric(phi), std::atan(b / a * (b / a) * std::tan(phi)), angle_rounding) << phi;
  }
  EXPECT_NEAR((pi / 4 - geocentric(pi / 4)) * 180 / pi, 0.1924, 5e-5);  // as printed
}

TEST(Ellipsoid, RefusesBadSphericalCoordinates) {
  const auto at = [](double latitude, double longitude, double distance) {
    return complaint([&] {
      (void)earth::position(earth::Spherical{GeocentricLatitude(latitude * si::radian),
                                             longitude * si::radian, distance * si::metre});
    });
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(at(1.6, 0.0, 1.0), "earth::position: the latitude 1.6 rad is not in [-pi/2, pi/2]");
  EXPECT_EQ(at(0.0, infinity, 1.0), "earth::position: the longitude inf rad is not finite");
  EXPECT_EQ(at(0.0, 0.0, -1.0), "earth::position: the distance is -1 m; it must be finite and not negative");
  EXPECT_EQ(at(0.0, 0.0, infinity),
            "earth::position: the distance is inf m; it must be finite and not negative");
  EXPECT_EQ(complaint([] { (void)earth::spherical(r(0.0, 0.0, 0.0)); }),
            "earth::spherical: the centre of the Earth has no latitude");
}

}  // namespace
}  // namespace vectrix::ellipsoid_test
