#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/pointing/earth_directions.hpp>
#include <vectrix/space/pointing/pointing.hpp>

#include "temporary_file.hpp"
#include "testing/motions.hpp"

namespace vectrix::earth_directions_test {
namespace {

using earth::Itrf;
using Eigen::Vector3d;
using vectrix_test::Dual2, vectrix_test::constant, vectrix_test::first, vectrix_test::second,
    vectrix_test::value;

struct Satellite : named_point {};
struct Body : moving_frame {};

constexpr double rounding = 4e-16;  // of a unit vector's coordinates
constexpr double a = wgs84::semi_major_axis.value(), b = a * (1 - wgs84::flattening);

template <class S> using ColumnOf = Eigen::Matrix<S, 3, 1>;

struct Path {
  Vector3d r, v, a;

  PointMotion<Itrf, Satellite, Itrf> motion() const {
    return point_motion(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>,
                        vector<si::length>(in<Itrf>, r), vector<si::velocity>(in<Itrf>, v));
  }
  Acceleration<Itrf, Satellite, ObservedFrom<Itrf>, In<Itrf>> acceleration() const {
    return vectrix::acceleration(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>,
                                 vector<si::acceleration>(in<Itrf>, a));
  }
};

// Latitude, longitude and height as functions of time; the normal and the place have closed forms.
TEST(MovingUp, IsTheDerivativeOfTheNormal) {
  std::mt19937_64 random(20270206);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Dual2 t = vectrix_test::instant(0.0);
  for (int i = 0; i < 200; ++i) {
    const auto moving = [&](double size, double rate) {
      return Dual2(constant(size * number(random)) +
                   t * (constant(rate * number(random)) + t * constant(rate * rate * number(random))));
    };
    // The first paths lead over a pole, where east and north are not defined.
    const Dual2 from_equator = moving(1.5, 1e-3), longitude = moving(3.0, 1e-3);
    const Dual2 latitude = i < 10 ? Dual2(constant(std::acos(-1.0) / 2) + t * constant(1e-3)) : from_equator;
    const Dual2 height = Dual2(constant(1e6) + moving(0.9, 1e-3) * constant(1e6));
    using std::sqrt, std::sin, std::cos;
    const ColumnOf<Dual2> n(Dual2(cos(latitude) * cos(longitude)), Dual2(cos(latitude) * sin(longitude)),
                            Dual2(sin(latitude)));
    const Dual2 s =
        sqrt(Dual2(constant(a * a) * (n(0) * n(0) + n(1) * n(1)) + constant(b * b) * n(2) * n(2)));
    const double squares[]{a * a, a * a, b * b};
    Path path;
    Vector3d up, rate, change;
    for (int k = 0; k < 3; ++k) {
      const Dual2 r = constant(squares[k]) * n(k) / s + height * n(k);
      path.r(k) = value(r), path.v(k) = first(r), path.a(k) = second(r);
      up(k) = value(n(k)), rate(k) = first(n(k)), change(k) = second(n(k));
    }
    const MovingDirection<Itrf, Level::acceleration> whole =
        wgs84::moving_up(path.motion(), path.acceleration());
    EXPECT_LE((whole.numbers()[0] - up).norm(), 4 * rounding);
    EXPECT_LE((whole.numbers()[1] - rate).norm(), 20 * rounding * 1e-3);
    EXPECT_LE((whole.numbers()[2] - change).norm(), 100 * rounding * 1e-6);
    const MovingDirection<Itrf, Level::rate> moving_normal = wgs84::moving_up(path.motion());
    EXPECT_EQ(moving_normal.numbers()[1], whole.numbers()[1]);
    const MovingDirection<Itrf, Level::rotation> normal = wgs84::moving_up(path.motion().position);
    EXPECT_EQ(normal.numbers()[0], wgs84::up(path.motion().position.vector()).coordinates());
  }
}

TEST(MovingUp, TheEvoluteIsRefused) {
  const double radius_of_curvature = b * b / a;  // of the meridian at the equator
  const Path path{{a - radius_of_curvature, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  EXPECT_THROW(static_cast<void>(wgs84::moving_up(path.motion())), BadInput);
  EXPECT_EQ(complaint([] {
              static_cast<void>(wgs84::moving_up(Path{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}.motion()));
            }),
            "wgs84::moving_up: the centre of the Earth has no latitude");
}

const Path low_orbit{{3.1e6, -4.2e6, 4.9e6}, {5.0e3, 5.2e3, 1.4e3}, {-3.7, 5.2, -6.4}};

auto towards(const Vector3d& u, const Vector3d& rate, const Vector3d& change) {
  return moving_direction(
      vector<si::length>(in<Itrf>, u),
      derivative<si::length>(observed_from<Itrf>, vector<si::velocity>(in<Itrf>, rate)),
      derivative<si::velocity>(observed_from<Itrf>, vector<si::acceleration>(in<Itrf>, change)));
}
Quantity<si::length> kilometres(double height) {
  return convert<si::length>(height * si::kilometre);
}

// The ray touches the ellipsoid, on the side of u, and where it does so WGS-84 is 100 km below, to 0.2 m.
TEST(Limb, TheRayTouchesTheEllipsoidAtTheHeight) {
  std::mt19937_64 random(20270207);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  double off = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Vector3d r = (6.7e6 + 4e7 * std::pow(number(random), 2)) *
                       Vector3d(number(random), number(random), number(random)).normalized();
    const Vector3d u(number(random), number(random), number(random));
    const auto place = displacement(of<Satellite>, relative_to<Itrf>, vector<si::length>(in<Itrf>, r));
    const Vector3d d =
        wgs84::limb(kilometres(100), moving_direction(vector<si::length>(in<Itrf>, u)), place).numbers()[0];
    // In their plane: down, and to the side of u.
    EXPECT_LE(std::abs(r.cross(u).normalized().dot(d.normalized())), 1e-14);
    EXPECT_LT(r.dot(d), 0.0);
    EXPECT_GT(r.cross(u).dot(r.cross(d)), 0.0);
    const Vector3d axes(a + 1e5, a + 1e5, b + 1e5);
    const Vector3d p = r.cwiseQuotient(axes), q = d.cwiseQuotient(axes);
    const double nearest = -p.dot(q) / q.squaredNorm();
    EXPECT_NEAR((p + nearest * q).norm(), 1.0, 1e-13);
    const auto touched = vector<si::length>(in<Itrf>, r + nearest * d);
    off = std::max(off, std::abs(wgs84::geodetic(touched).height.value() - 1e5));
  }
  EXPECT_LT(off, 0.2);
  EXPECT_GT(off, 0.05);
}

// Differences of five points: their error is 4e-14 of the first derivative, and rounding is amplified by
// 1/(n dt) and its square, n dt = 5e-4.
TEST(Limb, HasTheDerivativesOfItsDirection) {
  const Vector3d u(2e3, -1e3, 5e3), rate(-3.0, 7.0, 1.0), change(-2e-3, 1e-3, -5e-3);
  const auto at = [&](double t) {
    const Path& o = low_orbit;
    return wgs84::limb(
               kilometres(30),
               moving_direction(vector<si::length>(in<Itrf>, Vector3d(u + t * rate + t * t / 2 * change))),
               displacement(of<Satellite>, relative_to<Itrf>,
                            vector<si::length>(in<Itrf>, Vector3d(o.r + t * o.v + t * t / 2 * o.a))))
        .numbers()[0];
  };
  const double dt = 0.5;
  const Vector3d first_difference = (8 * (at(dt) - at(-dt)) - (at(2 * dt) - at(-2 * dt))) / (12 * dt);
  const Vector3d second_difference =
      (16 * (at(dt) + at(-dt)) - (at(2 * dt) + at(-2 * dt)) - 30 * at(0)) / (12 * dt * dt);
  const MovingDirection<Itrf, Level::acceleration> whole =
      wgs84::limb(kilometres(30), towards(u, rate, change), low_orbit.motion(), low_orbit.acceleration());
  EXPECT_EQ(whole.numbers()[0], at(0));
  EXPECT_LE((whole.numbers()[1] - first_difference).norm(), 1e-11 * first_difference.norm());
  EXPECT_LE((whole.numbers()[2] - second_difference).norm(), 1e-7 * second_difference.norm());
  // The lower level of the two.
  const MovingDirection<Itrf, Level::rate> moving =
      wgs84::limb(kilometres(30), towards(u, rate, change), low_orbit.motion());
  EXPECT_EQ(moving.numbers()[1], whole.numbers()[1]);
  const MovingDirection<Itrf, Level::rotation> held =
      wgs84::limb(kilometres(30), moving_direction(vector<si::length>(in<Itrf>, u)), low_orbit.motion(),
                  low_orbit.acceleration());
  EXPECT_EQ(held.numbers()[0], whole.numbers()[0]);
}

std::string refusal(double height, const Vector3d& r, const Vector3d& u) {
  return complaint([&] {
    wgs84::limb(kilometres(height), moving_direction(vector<si::length>(in<Itrf>, u)),
                displacement(of<Satellite>, relative_to<Itrf>, vector<si::length>(in<Itrf>, r)));
  });
}

TEST(Limb, RefusesAPlaceBelowItAndADirectionAlongTheVertical) {
  EXPECT_EQ(refusal(100, {a + 101e3, 0, 0}, {0, 1, 0}), "nothing was thrown");
  const std::string below = refusal(100, {a + 99e3, 0, 0}, {0, 1, 0});
  EXPECT_NE(below.find("wgs84::limb: the height of the limb is 1e+05 m, and |r| is 6477137 m"),
            std::string::npos)
      << below;
  for (const double height : {std::nan(""), -7000.0})
    EXPECT_NE(refusal(height, {a + 99e3, 0, 0}, {0, 1, 0}).find("the height of the limb is"),
              std::string::npos);
  EXPECT_NE(refusal(100, {7e6, 0, 0}, {-1, 1e-8, 0}).find("one direction"), std::string::npos);
}

// Geodetic nadir pointing, as a user writes it.
TEST(MovingUp, PointsABodyToTheGeodeticNadir) {
  const auto up = wgs84::moving_up(low_orbit.motion(), low_orbit.acceleration());
  const MovingDcm<Itrf, Body> now = pointing(
      align(unit_z(in<Body>), -up),
      constrain(unit_x(in<Body>), moving_direction(low_orbit.motion().velocity, low_orbit.acceleration())));
  EXPECT_LE((now.rotation.matrix().col(2) + up.numbers()[0]).norm(), 4 * rounding);
  // d/dt z = w x z
  const Vector3d w = now.rotation.matrix() * now.angular_velocity.coordinates();
  EXPECT_LE((w.cross(-up.numbers()[0]) + up.numbers()[1]).norm(), 1e-15 * w.norm());
}

}  // namespace
}  // namespace vectrix::earth_directions_test
