#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <vectrix/space/sky/bodies.hpp>
#include <vectrix/space/sky/limb.hpp>
#include <vectrix/space/time/events.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::limb_test {
namespace {

using earth::Gcrf;
using earth::Itrf;
using vectrix_test::triple;

struct Satellite : moving_frame {};

constexpr double pi = std::numbers::pi;
constexpr double a = wgs84::semi_major_axis.value(), b = a * (1.0 - wgs84::flattening);
constexpr double rounding = 4e-15;  // rad: the difference of two angles up to pi

template <class C> auto to_body(const Eigen::Vector3d& r) {
  return displacement(of<Gcrf>, relative_to<Satellite>, vector<si::length>(in<C>, r));
}
template <class C> auto along(const Eigen::Vector3d& n) {
  return direction(vector<si::dimensionless>(in<C>, n));
}

double from_sphere(const Eigen::Vector3d& n, const Eigen::Vector3d& r, double radius) {
  return angle_from_limb(along<Gcrf>(n), to_body<Gcrf>(r), radius * si::metre).value();
}
double from_earth(const Eigen::Vector3d& n, const Eigen::Vector3d& r) {
  return wgs84::angle_from_limb(along<Itrf>(n), to_body<Itrf>(r)).value();
}
bool meets_the_earth(const Eigen::Vector3d& n, const Eigen::Vector3d& r) {
  return wgs84::first_intersection(vector<si::length>(in<Itrf>, -r), along<Itrf>(n)).has_value();
}

// n turned from r by the angle of the limb and c more.
RC_GTEST_PROP(Limb, IsASphericalCap, ()) {
  const Eigen::Vector3d r = 1e8 * *triple();
  const double radius = r.norm() * *rc::gen::map(rc::gen::inRange(1, 1000), [](int k) { return k / 1000.0; });
  const double c = *rc::gen::map(rc::gen::inRange(0, 1000), [](int k) { return k / 1000.0; });
  const double limb = std::asin(radius / r.norm()), turned = c * pi;
  const Eigen::Vector3d n = std::cos(turned) * r.normalized() + std::sin(turned) * r.unitOrthogonal();
  RC_ASSERT(std::abs(from_sphere(n, r, radius) - (turned - limb)) < rounding);
  RC_ASSERT(std::abs(angular_radius(to_body<Gcrf>(r), radius * si::metre).value() - limb) < rounding);
  // a displacement serves as a direction, whatever its length
  const auto there =
      displacement(of<sky::Moon>, relative_to<Satellite>, vector<si::length>(in<Gcrf>, 3e7 * n));
  RC_ASSERT(std::abs(angle_from_limb(there, to_body<Gcrf>(r), radius * si::metre).value() - (turned - limb)) <
            rounding);
}

TEST(Limb, OfSunAndMoonFromTheEarth) {
  const auto arcseconds = [](double distance, const Quantity<si::length>& radius) {
    return angular_radius(to_body<Gcrf>({distance, 0.0, 0.0}), radius).in(si::arcsecond);
  };
  // Published: the Sun's semidiameter of 959.63 arcsec at one au, of the old radius 696,000 km; the Moon's of
  // 15 arcmin 32.6 arcsec at 384,400 km.
  EXPECT_NEAR(arcseconds(149597870700.0, 6.96e8 * si::metre), 959.63, 0.02);
  EXPECT_NEAR(arcseconds(384400e3, sky::moon_radius), 15.0 * 60.0 + 32.6, 0.5);
}

// Where the sign changes is where the ray along n leaves the Earth.
RC_GTEST_PROP(Limb, OfTheEarthIsWhereRaysMissIt, ()) {
  const double height =
      1e5 * std::pow(10.0, 3.0 * *rc::gen::map(rc::gen::inRange(0, 1000), [](int k) { return k / 1000.0; }));
  const Eigen::Vector3d r = (a + height) * (*triple()).normalized();
  const Eigen::Vector3d u = r.normalized(), side = u.cross(*triple());
  RC_PRE(side.norm() > 0.1);
  const Eigen::Vector3d across = side.normalized();
  const auto n = [&](double turned) -> Eigen::Vector3d {
    return std::cos(turned) * u + std::sin(turned) * across;
  };
  const double limb = 1.0 - from_earth(n(1.0), r);
  constexpr double little = 1e-10;  // rad
  RC_ASSERT(std::abs(from_earth(n(limb), r)) < rounding);
  RC_ASSERT(meets_the_earth(n(limb - little), r) && !meets_the_earth(n(limb + little), r));
  // it depends on the plane of n and r alone, and on the side
  RC_ASSERT(std::abs(from_earth(n(0.3), r) - (0.3 - limb)) < rounding);
  RC_ASSERT(std::abs(from_earth(n(3.0), r) - (3.0 - limb)) < rounding);
}

// Next to the centre, too, the limb is that of the plane of n and r. The plane of a direction that is c away
// from the centre is rounded by 1e-16/c; over the whole turn of the plane the limb changes by `planes`.
TEST(Limb, OfTheEarthDependsOnThePlaneNextToItsCentre) {
  constexpr double planes = 2e-3;  // rad: of the flattening
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const double r = 7e6;
  const double along_equator = std::asin(a / r), along_meridian = std::atan2(b, std::sqrt(r * r - a * a));
  ASSERT_GT(along_equator - along_meridian, planes / 2);
  for (const double c : {1e-3, 1e-6, 1e-9, 1e-11, 1e-13, 1e-15, 1e-200, 4e-324}) {
    const Eigen::Vector3d east(1.0, c, 0.0), north(1.0, 0.0, c);
    EXPECT_NEAR(from_earth(east, r * x), std::atan(c) - along_equator, rounding) << c;
    EXPECT_NEAR(from_earth(north, r * x), std::atan(c) - along_meridian, rounding) << c;
  }
  // in axes in which the numbers are rounded
  const Eigen::Vector3d u = Eigen::Vector3d(0.6, -0.5, 0.3).normalized(), v = u.unitOrthogonal();
  const Eigen::Vector3d across = std::cos(0.7) * v + std::sin(0.7) * u.cross(v);
  const double limb = 1.0 - from_earth(std::cos(1.0) * u + std::sin(1.0) * across, r * u);
  for (const double c : {1e-4, 1e-7, 1e-10, 1e-13})
    EXPECT_NEAR(from_earth(u + c * across, r * u), std::atan(c) - limb, rounding + planes * 1e-15 / c) << c;
}
// 1 mm above the surface the horizon in the east dips by (2 h/N)^1/2, N the radius of curvature, apart from
// the square of the angle between the plumb line and the centre, 1e-5 of it. 1 mm below there is no horizon.
TEST(Limb, OfTheEarthFromItsSurface) {
  constexpr double h = 1e-3, off = 1e-9;  // m, rad
  constexpr double e2 = (a - b) * (a + b) / (a * a);
  for (const double latitude : {0.0, 0.5, 1.2}) {
    const double N = a / std::sqrt(1.0 - e2 * std::sin(latitude) * std::sin(latitude));
    const Eigen::Vector3d up(std::cos(latitude), 0.0, std::sin(latitude)), east(0.0, 1.0, 0.0);
    const Eigen::Vector3d foot = N * Eigen::Vector3d(up.x(), 0.0, (1.0 - e2) * up.z());
    EXPECT_NEAR(from_earth(east, -(foot + h * up)), std::sqrt(2.0 * h / N), off) << latitude;
    EXPECT_THROW((void)from_earth(east, -(foot - h * up)), BadInput) << latitude;
  }
}

// Seen from a point of the axis the limb is a circle; from a point of the equator it is the limb of a circle
// along the equator, and that of an ellipse along the meridian.
TEST(Limb, OfTheEarthInClosedForm) {
  const double z = 7e6;
  EXPECT_NEAR(from_earth({0.0, 1.0, 0.0}, {0.0, 0.0, -z}), pi / 2 - std::atan2(a, std::sqrt(z * z - b * b)),
              rounding);
  EXPECT_NEAR(from_earth({0.0, 1.0, 0.0}, {z, 0.0, 0.0}), pi / 2 - std::asin(a / z), rounding);
  EXPECT_NEAR(from_earth({0.0, 0.0, 1.0}, {z, 0.0, 0.0}), pi / 2 - std::atan2(b, std::sqrt(z * z - a * a)),
              rounding);
  EXPECT_NEAR(from_earth({0.0, 0.0, 1.0}, {0.0, 0.0, z}), -std::atan2(a, std::sqrt(z * z - b * b)), rounding);
}

// What the header promises: 1e-3 deg from the nearest point of the limb, which is sought among many; their
// spacing adds its square.
TEST(Limb, OfTheEarthIsNearlyTheNearestPoint) {
  constexpr int points = 720;
  constexpr double promised = 1e-3 / 180.0 * pi, spacing = 2.0 * pi / points;
  const Eigen::Vector3d r = -(a + 2e5) * Eigen::Vector3d(0.7, 0.0, 0.7).normalized();
  const Eigen::Vector3d u = r.normalized(), e = u.unitOrthogonal(), f = u.cross(e);
  const auto beside = [&](double azimuth, double c) -> Eigen::Vector3d {
    const Eigen::Vector3d across = std::cos(azimuth) * e + std::sin(azimuth) * f;
    const double turned = 1.0 - from_earth(std::cos(1.0) * u + std::sin(1.0) * across, r) + c;
    return std::cos(turned) * u + std::sin(turned) * across;
  };
  const double far = 80.0 / 180.0 * pi;
  double largest = 0.0;
  for (double azimuth = 0.1; azimuth < 6.3; azimuth += 0.3) {
    const Eigen::Vector3d n = beside(azimuth, far);
    double nearest = pi;
    for (int k = 0; k < points; ++k) {
      nearest = std::min(nearest, std::acos(n.dot(beside(k * spacing, 0.0))));
    }
    EXPECT_NEAR(nearest, far, promised + spacing * spacing);
    largest = std::max(largest, far - nearest);
  }
  EXPECT_GT(largest, promised / 4.0);  // so it is not the nearest point itself
}

// A boresight along x on a circular orbit in the plane of x and y meets the Earth's limb, of radius R, at the
// phase pi - asin(R/r), and leaves it at pi + asin(R/r).
TEST(Limb, IsCrossedAtTheTimeOfTheClosedForm) {
  constexpr double radius = 6378e3, orbit = 7e6, rate = 1e-3;  // m, m, rad/s
  const auto start = Epoch::from_tt("2025-01-01T00:00:00");
  const auto span = from_until(start, 6000.0 * si::second);
  const auto crossings = events(span, 60.0 * si::second, [&](const Epoch& t) {
    const double phase = rate * (t - start).value();
    return from_sphere({1.0, 0.0, 0.0}, -orbit * Eigen::Vector3d(std::cos(phase), std::sin(phase), 0.0),
                       radius);
  });
  ASSERT_EQ(crossings.size(), 2U);
  constexpr double tolerance = 1e-9 + 1e-11;  // s: of events(), and of the clock
  EXPECT_EQ(crossings[0].direction, Crossing::falling);
  EXPECT_NEAR((crossings[0].epoch - start).value(), (pi - std::asin(radius / orbit)) / rate, tolerance);
  EXPECT_NEAR((crossings[1].epoch - start).value(), (pi + std::asin(radius / orbit)) / rate, tolerance);
}

TEST(Limb, RefusesPointsInsideAndNoDirections) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d x(1.0, 0.0, 0.0);
  EXPECT_EQ(complaint([&] { (void)from_sphere(x, 6e6 * x, 6.378e6); }),
            "angle_from_limb: the body, of radius 6378000 m, is 6e+06 m away");
  EXPECT_EQ(complaint([&] { (void)angular_radius(to_body<Gcrf>(6e6 * x), 6.378e6 * si::metre); }),
            "angular_radius: the body, of radius 6378000 m, is 6e+06 m away");
  EXPECT_THROW((void)from_sphere(x, 6e6 * x, 0.0), BadInput);
  EXPECT_THROW((void)from_sphere(x, 6e6 * x, nan), BadInput);
  EXPECT_THROW((void)from_sphere(x, nan * x, 1.0), BadInput);
  EXPECT_EQ(complaint([&] { (void)from_earth(x, 6.3e6 * x); }),
            "angle_from_limb: the point is inside the ellipsoid, 6300000 m from its centre");
  EXPECT_THROW((void)from_earth(x, nan * x), BadInput);
  const auto zero = vector<si::dimensionless>(in<Itrf>, Eigen::Vector3d::Zero());
  EXPECT_THROW((void)wgs84::angle_from_limb(zero, to_body<Itrf>(7e6 * x)), BadInput);
  EXPECT_NO_THROW((void)from_sphere(x, 6e6 * x, 6e6));
}

template <class... Given>
concept HasLimb = requires(const Given&... given) {
  { angle_from_limb(given...) } -> std::same_as<Quantity<si::angle>>;
};
template <class C> using Direction = Vector<C, si::dimensionless>;
template <class C> using ToBody = Displacement<Satellite, Gcrf, In<C>>;
static_assert(HasLimb<Direction<Gcrf>, ToBody<Gcrf>, Quantity<si::length>>);
static_assert(!HasLimb<Direction<Itrf>, ToBody<Gcrf>, Quantity<si::length>>);
static_assert(!HasLimb<Direction<Gcrf>, ToBody<Gcrf>, Quantity<si::angle>>);

}  // namespace
}  // namespace vectrix::limb_test
