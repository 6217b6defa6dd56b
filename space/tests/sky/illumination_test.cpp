#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics.hpp>
#include <vectrix/space/sky/ephemeris.hpp>
#include <vectrix/space/sky/illumination.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"
#include "testing/trials.hpp"

namespace vectrix::illumination_test {
namespace {

using earth::Gcrf;
using earth::Itrf;
using sky::Moon;
using sky::Sun;
using vectrix_test::triple;

struct Satellite : moving_frame {};

constexpr double au = 1.495978707e11;        // m
constexpr double equatorial = 6378137.0;     // m
constexpr double polar = 6356752.314245179;  // m
const double sun_radius = sky::sun_radius.value();

// c at which the part is asked: places the body along x and the Sun at c from it.
struct Lines {
  Eigen::Vector3d sun, body;
};
Lines lines(double c, double distance) {
  return {au * Eigen::Vector3d(std::cos(c), std::sin(c), 0.0), distance * Eigen::Vector3d::UnitX()};
}
double seen_past_sphere(const Lines& at, double radius) {
  return visible_sun(displacement(of<Sun>, relative_to<Satellite>, vector<si::length>(in<Gcrf>, at.sun)),
                     displacement(of<Moon>, relative_to<Satellite>, vector<si::length>(in<Gcrf>, at.body)),
                     radius * si::metre);
}
double seen_past_earth(const Lines& at) {
  return wgs84::visible_sun(
      displacement(of<Sun>, relative_to<Satellite>, vector<si::length>(in<Itrf>, at.sun)),
      displacement(of<Gcrf>, relative_to<Satellite>, vector<si::length>(in<Itrf>, at.body)));
}

/// The part of the Sun's disc seen past the ellipsoid with these semi-axes, along spokes from the centre of
/// the disc: a spoke enters and leaves the ellipsoid where the rays touch it, which is exact; the spokes are
/// counted. With M = (A b)(A b)^T - (b.A b - 1) A a ray u meets the ellipsoid at b if u.M u > 0 and u.A b >
/// 0.
double by_spokes(const Lines& at, const Eigen::Vector3d& axes, int spokes) {
  const Eigen::Vector3d A = axes.cwiseAbs2().cwiseInverse();
  const Eigen::Vector3d Ab = A.cwiseProduct(at.body);
  const Eigen::Matrix3d M = Ab * Ab.transpose() - (at.body.dot(Ab) - 1.0) * Eigen::Matrix3d(A.asDiagonal());
  const Eigen::Vector3d u = at.sun.normalized();
  const Eigen::Vector3d x = u.unitOrthogonal();
  const Eigen::Vector3d y = u.cross(x);
  const double a = std::asin(sun_radius / at.sun.norm());
  const auto versine = [](double angle) { return 2.0 * std::pow(std::sin(0.5 * angle), 2); };
  double seen = 0.0;
  for (int j = 0; j < spokes; ++j) {
    const double phi = 2.0 * std::numbers::pi * (j + 0.5) / spokes;
    const Eigen::Vector3d w = std::cos(phi) * x + std::sin(phi) * y;
    std::vector<double> cuts{0.0, a};
    const double uMw = u.dot(M * w);
    const double wMw = w.dot(M * w);
    const double discriminant = uMw * uMw - u.dot(M * u) * wMw;
    if (discriminant > 0.0) {
      for (const double sign : {-1.0, 1.0}) {
        const double cut = std::atan((-uMw + sign * std::sqrt(discriminant)) / wMw);
        if (cut > 0.0 && cut < a) cuts.push_back(cut);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
      const Eigen::Vector3d ray = std::cos(middle) * u + std::sin(middle) * w;
      const bool blocked = ray.dot(Ab) > 0.0 && ray.dot(M * ray) > 0.0;
      if (!blocked) seen += versine(cuts[i + 1]) - versine(cuts[i]);
    }
  }
  return seen / (spokes * versine(a));
}

/// The same for a sphere of angular radius b, c away, |a - b| < c < a + b, as an integral over rings of the
/// Sun's disc. Of the ring at rho = |c - b| + e the angle 2 theta is covered,
///     tan^2(theta/2) = sin((b + rho - c)/2) sin((b - rho + c)/2) / (sin((rho + c + b)/2) sin((rho + c -
///     b)/2))
/// Double-exponential quadrature in long double.
double by_rings(long double a, long double b, long double c) {
  using Real = long double;
  const Real pi = std::numbers::pi_v<Real>;
  const auto versine = [](Real x) { return 2 * std::pow(std::sin(x / 2), 2); };
  const bool centre_is_free = c > b;
  const Real gap = std::abs(c - b);
  const auto ring = [&](Real e) {
    const Real grows = std::sin(e / 2) * std::sin(std::min(b, c) - e / 2);
    const Real falls = std::sin(std::max(b, c) + e / 2) * std::sin(gap + e / 2);
    const Real theta = 2 * (centre_is_free ? std::atan(std::sqrt(grows / falls))
                                           : std::atan(std::sqrt(std::sin(gap + e / 2) * std::sin(c - e / 2) /
                                                                 (std::sin(b + e / 2) * std::sin(e / 2)))));
    return 2 * theta * std::sin(gap + e);
  };
  Real covered = centre_is_free ? Real{0} : 2 * pi * versine(gap);
  const Real half = (a - gap) / 2;
  constexpr Real step = 1 / Real{64};
  for (int k = -4 * 64; k <= 4 * 64; ++k) {
    const Real bend = pi / 2 * std::sinh(k * step);
    const Real weight = step * pi / 2 * std::cosh(k * step) / std::pow(std::cosh(bend), 2);
    covered += half * weight * ring(2 * half / (1 + std::exp(-2 * bend)));
  }
  return static_cast<double>(1 - covered / (2 * pi * versine(a)));
}

const double a_of_sun = std::asin(sun_radius / au);
// The angle c has the rounding of a double, of which the Sun's disc has 4e13; the excess loses as much again.
constexpr double disc_rounding = 2e-13;

// From the ground to the Moon's distance: the angular radius b of the Earth is asin(R/d).
RC_GTEST_PROP(Illumination, PartIsTheIntegralOverRings, ()) {
  const double radius = 6.371e6;
  const double distance = radius * std::pow(10.0, *rc::gen::inRange(1, 2400) / 1000.0);
  const double b = std::asin(radius / distance);
  const double least = std::abs(a_of_sun - b);
  const double c = least + (a_of_sun + b - least) * *rc::gen::inRange(1, 1000) / 1000.0;
  RC_ASSERT(std::abs(seen_past_sphere(lines(c, distance), radius) - by_rings(a_of_sun, b, c)) <
            disc_rounding);
}

TEST(Illumination, EndsAreExactAndSmooth) {
  for (const double distance : {6.5e6, 7e6, 4.2e7, 4e8, 1.3e9, 1.5e9, 4e9}) {
    const double radius = 6.371e6;
    const double b = std::asin(radius / distance);
    const double whole_disc = std::pow(std::sin(b / 2) / std::sin(a_of_sun / 2), 2);
    const double inside = std::max(0.0, 1.0 - whole_disc);
    const auto seen = [&](double c) { return seen_past_sphere(lines(c, distance), radius); };
    EXPECT_EQ(seen(b + a_of_sun + 1e-9), 1.0);
    EXPECT_EQ(seen(3.0), 1.0);
    EXPECT_NEAR(seen(0.0), inside, disc_rounding);
    EXPECT_NEAR(seen(std::abs(b - a_of_sun) * (1 - 1e-9)), inside, disc_rounding);
    // At a depth d behind a contact the lens is (32/9)^(1/2) (k d)^(1/2) d, k = ab/(a + b) outside, ab/|a -
    // b| inside.
    const double depth = 1e-7 * std::min(a_of_sun, b);
    const auto grown = [&](double k) {
      return std::sqrt(32.0 / 9.0 * k * depth) * depth / (std::numbers::pi * a_of_sun * a_of_sun);
    };
    const double product = a_of_sun * b;
    EXPECT_NEAR(seen(b + a_of_sun - depth), 1.0, 1.01 * grown(product / (a_of_sun + b)));
    EXPECT_NEAR(seen(std::abs(b - a_of_sun) + depth), inside,
                1.01 * grown(product / std::abs(b - a_of_sun)) + disc_rounding);
    double before = inside;
    for (int k = 0; k <= 1000; ++k) {
      const double now = seen(std::abs(b - a_of_sun) + 2.0 * std::min(a_of_sun, b) * k / 1000.0);
      EXPECT_GE(now, before - disc_rounding) << distance << ' ' << k;
      EXPECT_LE(now, before + 0.003) << distance << ' ' << k;
      before = now;
    }
  }
}

// One body of half the Sun's angular radius in front of its centre.
TEST(Illumination, AnnularAndBehind) {
  const double b = 0.5 * a_of_sun;
  const double distance = 1e9;
  const double ring = 1.0 - std::pow(std::sin(b / 2) / std::sin(a_of_sun / 2), 2);
  EXPECT_NEAR(seen_past_sphere(lines(0.0, distance), distance * std::sin(b)), ring, disc_rounding);
  EXPECT_NEAR(ring, 0.75, 1e-5);
  EXPECT_EQ(seen_past_sphere(lines(0.0, 2.0 * au), 1e9), 1.0);  // beyond the Sun
  EXPECT_EQ(seen_past_sphere(lines(std::numbers::pi, 7e6), 6.371e6), 1.0);
}

// From the ground to four times the distance of the Moon, where the Earth is smaller than the Sun.
struct Height {
  double distance;   // m
  double tolerance;  // what the header says, without the counting of the spokes
};
TEST(Illumination, TheEarthsEllipsoidIsThatOfTheSpokes) {
  constexpr int spokes = vectrix_test::trials(5000);
  constexpr double counting = 0.5 / spokes;
  for (const auto& [distance, tolerance] :
       {Height{6.4e6, 3e-5}, Height{7e6, 3e-5}, Height{2.6e7, 3e-5}, Height{4.2e7, 3e-5}, Height{4e8, 3e-4},
        Height{1e9, 1e-3}, Height{1.5e9, 4e-3}}) {
    const double b = std::asin(6.371e6 / std::max(distance, 6.371e6));
    for (int k = 0; k < vectrix_test::trials(60); ++k) {
      const Eigen::Vector3d n =
          Eigen::Vector3d(std::sin(3.0 * k), std::cos(7.0 * k), std::sin(5.0 * k)).normalized();
      const Eigen::Vector3d across = n.cross(Eigen::Vector3d(std::cos(k), std::sin(k), 0.3)).normalized();
      const double c = std::max(0.0, b + a_of_sun * ((k % 30) / 12.5 - 1.2));
      const Lines at{au * (std::cos(c) * n + std::sin(c) * across), distance * n};
      const double expected = by_spokes(at, {equatorial, equatorial, polar}, spokes);
      EXPECT_NEAR(seen_past_earth(at), expected, tolerance + counting) << distance << ' ' << k;
      const double past_sphere = by_spokes(at, {6.371e6, 6.371e6, 6.371e6}, spokes);
      if (distance > 6.4e6) {
        EXPECT_NEAR(seen_past_sphere(at, 6.371e6), past_sphere, counting) << k;
      }
    }
  }
}

// Rays one by one, each to a piece of the disc of the same solid angle: the limb passes through 2 of the 100
// pieces across it, more or less.
TEST(Illumination, TheEarthsEllipsoidIsThatOfTheRays) {
  constexpr int rings = 100;
  const Eigen::Vector3d A = Eigen::Vector3d(equatorial, equatorial, polar).cwiseAbs2().cwiseInverse();
  const double disc = 2.0 * std::pow(std::sin(a_of_sun / 2), 2);
  const Eigen::Vector3d body = Eigen::Vector3d(3e6, -2e6, -5.9e6);
  const Eigen::Vector3d n = body.normalized();
  const Eigen::Vector3d across = n.cross(Eigen::Vector3d(0.2, 1.0, 0.1)).normalized();
  double partial = 0.0;
  for (int k = -12; k <= 12; ++k) {
    const double c = std::asin(6.365e6 / body.norm()) + 0.1 * k * a_of_sun;
    const Eigen::Vector3d u = std::cos(c) * n + std::sin(c) * across;
    const Eigen::Vector3d x = u.unitOrthogonal();
    const Eigen::Vector3d y = u.cross(x);
    int missed = 0;
    for (int i = 0; i < rings; ++i) {
      const double cosine = 1.0 - disc * (i + 0.5) / rings;
      const double sine = std::sqrt(1.0 - cosine * cosine);
      for (int j = 0; j < 4 * rings; ++j) {
        const double phi = 2.0 * std::numbers::pi * (j + std::fmod(0.618034 * i, 1.0)) / (4 * rings);
        const Eigen::Vector3d ray = cosine * u + sine * (std::cos(phi) * x + std::sin(phi) * y);
        const double rb = ray.dot(A.cwiseProduct(body));
        const double bb = body.dot(A.cwiseProduct(body)) - 1.0;
        missed += rb <= 0.0 || rb * rb < ray.dot(A.cwiseProduct(ray)) * bb ? 1 : 0;
      }
    }
    const double expected = missed / (4.0 * rings * rings);
    EXPECT_NEAR(seen_past_earth({au * u, body}), expected, 0.5 / rings) << k;
    partial += expected > 0.05 && expected < 0.95 ? 1.0 : 0.0;
  }
  EXPECT_GT(partial, 10.0);
}

RC_GTEST_PROP(Illumination, AnEllipsoidOfOneRadiusIsASphere, ()) {
  const double radius = 6.371e6;
  const Eigen::Vector3d direction = *triple();
  RC_PRE(direction.norm() > 0.1);
  const Eigen::Vector3d body =
      direction.normalized() * radius * std::pow(10.0, *rc::gen::inRange(0, 2000) / 1000.0);
  const double b = std::asin(std::min(1.0, radius / body.norm()));
  const double c = b + a_of_sun * *rc::gen::inRange(-1000, 1000) / 1000.0;
  const Eigen::Vector3d n = body.normalized();
  const Eigen::Vector3d sun = au * (std::cos(c) * n + std::sin(c) * n.unitOrthogonal());
  RC_PRE(body.norm() >= radius * (1 + 1e-9));
  // At the ground the limb is 1e-8 sensitive to the rounding of the distance.
  const double rounding = 1e-13 / std::sqrt(body.norm() / radius - 1.0);
  RC_ASSERT(std::abs(detail::visible_past_ellipsoid(sun, body, radius, radius, sun_radius) -
                     detail::visible_past_sphere(sun, body, radius, sun_radius)) < disc_rounding + rounding);
}

// The Sun straight behind the centre: every plane through it is that of the limb.
TEST(Illumination, TheSunMayBeOnTheAxis) {
  for (const Eigen::Vector3d& n :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0)}) {
    EXPECT_EQ(seen_past_earth({au * n, 7e6 * n}), 0.0);
    EXPECT_EQ(seen_past_earth({-au * n, 7e6 * n}), 1.0);
    const double annular = seen_past_earth({au * n, 2e9 * n});
    EXPECT_TRUE(annular > 0.5 && annular < 0.6) << annular;
  }
}

// Published with Orekit's tests (EclipseDetectorTest, Apache-2.0): an orbit in 1969, two bodies alone, a
// spherical Earth of 6400 km and a Sun of 696000 km, entering the umbra after 2303.1835 s and leaving the
// penumbra after 4388.155852 s. With the Sun of eraEpv00, geometric, an independent integration found
// 2303.183486 s and 4388.155843 s.
class LowOrbit : public ::testing::Test {
 protected:
  LowOrbit() {
    constexpr double mu = 3.9860047e14;
    const auto slope = [](const Eigen::Matrix<double, 6, 1>& y) {
      const Eigen::Vector3d r = y.head<3>();
      return (Eigen::Matrix<double, 6, 1>() << y.tail<3>(), -mu / std::pow(r.norm(), 3) * r).finished();
    };
    Eigen::Matrix<double, 6, 1> y;
    y << -6142438.668, 3492467.56, -25767.2568, 505.8479685, 942.7809215, 7435.922231;
    states.push_back(y);
    for (int i = 0; i < 9000; ++i) {  // Runge-Kutta of order 4, half a second: 1e-6 m after an orbit
      const Eigen::Matrix<double, 6, 1> k1 = slope(y);
      const Eigen::Matrix<double, 6, 1> k2 = slope(y + 0.5 * step * k1);
      const Eigen::Matrix<double, 6, 1> k3 = slope(y + 0.5 * step * k2);
      const Eigen::Matrix<double, 6, 1> k4 = slope(y + step * k3);
      y += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      states.push_back(y);
    }
  }

  // The position between two states: a cubic, which errs by 1e-4 (v h)^2/r, 1e-5 m.
  [[nodiscard]] Displacement<Gcrf, Satellite, In<Gcrf>> at(double t) const {
    const auto i = std::min(static_cast<std::size_t>(t / step), states.size() - 2);
    const double s = t / step - static_cast<double>(i);
    const Eigen::Vector3d r = (1 + 2 * s) * (1 - s) * (1 - s) * states[i].head<3>() +
                              s * (1 - s) * (1 - s) * step * states[i].tail<3>() +
                              s * s * (3 - 2 * s) * states[i + 1].head<3>() +
                              s * s * (s - 1) * step * states[i + 1].tail<3>();
    return displacement(of<Satellite>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r));
  }
  [[nodiscard]] double seen(double t) const {
    const auto r = at(t);
    return visible_sun(sun.line_of_sight(epoch + t * si::second, r, geometric), -r, 6.4e6 * si::metre,
                       6.96e8 * si::metre);
  }
  // The instant between two at which the answer changes.
  static double change(const std::function<bool(double)>& answer, double from, double to) {
    while (to - from > 1e-7) {
      const double middle = 0.5 * (from + to);
      (answer(middle) == answer(to) ? to : from) = middle;
    }
    return from;
  }

  static constexpr double step = 0.5;                            // s
  static constexpr double published = 1e-3, found_again = 1e-5;  // s
  std::vector<Eigen::Matrix<double, 6, 1>> states;
  Epoch epoch = Epoch::from_tt("1969-07-28T04:00:00");
  Ephemeris<Sun> sun{from_until(epoch, 5000.0 * si::second)};
};

TEST_F(LowOrbit, EntersTheUmbraAndLeavesThePenumbra) {
  const auto dark = [&](double t) { return seen(t) == 0.0; };
  const auto bright = [&](double t) { return seen(t) == 1.0; };
  EXPECT_NEAR(change(bright, 2200.0, 2300.0), 2293.972284, found_again);
  const double entry = change(dark, 2200.0, 2400.0);
  EXPECT_NEAR(entry, 2303.183486, found_again);
  EXPECT_NEAR(entry, 2303.1835, published);
  EXPECT_NEAR(change(dark, 4300.0, 4385.0), 4378.946742, found_again);
  const double exit = change(bright, 4300.0, 4450.0);
  EXPECT_NEAR(exit, 4388.155843, found_again);
  EXPECT_NEAR(exit, 4388.155852, published);
}

// Published by NASA (F. Espenak): the total eclipse of 2017 August 21 was greatest at 18:25:32 UT at 36 deg
// 58.0' N, 87 deg 40.3' W, where it was total for 160.1 s. eraMoon98 is 15 km off at most, which the shadow
// passes in 25 s; the published duration is that of a slightly smaller Moon.
TEST(Illumination, OfTheGroundInTheEclipseOf2017) {
  const auto start = Epoch::from_utc("2017-08-21T16:00:00");
  const auto span = from_until(start, 6.0 * 3600.0 * si::second);
  const Ephemeris<Sun> sun(span);
  const Ephemeris<Moon> moon(span);
  const auto degrees = [](double x) { return convert<si::angle>(x * si::degree); };
  const auto r_itrf = wgs84::position(
      {GeodeticLatitude(degrees(36.0 + 58.0 / 60.0)), degrees(-87.0 - 40.3 / 60.0), 0.0 * si::metre});
  const EarthOrientationParameters earth{convert<si::angle>(0.229543 * si::arcsecond),
                                         convert<si::angle>(0.377302 * si::arcsecond),
                                         (0.3399683 - 37.0) * si::second,
                                         0.0 * (si::second / si::second),
                                         0.0 * si::radian,
                                         0.0 * si::radian};
  const auto ground = displacement(of<Satellite>, relative_to<Itrf>, r_itrf);
  const auto graph = frame_graph(edge([&](const Epoch& t) { return coincident(earth_rotation(t, earth)); }),
                                 rigid_edge(Transform{aligned(to<Itrf>, from<Satellite>), ground}));
  const auto seen = [&](const Epoch& t) {
    const auto now = graph.at(t);
    return visible_sun(sun.line_of_sight(now, seen_from<Satellite>, apparent, in<Gcrf>),
                       moon.line_of_sight(now, seen_from<Satellite>, apparent, in<Gcrf>), sky::moon_radius);
  };
  double dark = 0.0;
  double middle = 0.0;
  int partial = 0;
  for (const Epoch& t :
       every(1.0 * si::second, from_until(Epoch::from_utc("2017-08-21T18:20:00"), 720.0 * si::second))) {
    if (seen(t) == 0.0) {
      dark += 1.0;
      middle += (t - start).value();
    }
  }
  for (const Epoch& t : every(60.0 * si::second, span)) partial += seen(t) < 1.0 ? 1 : 0;
  EXPECT_NEAR(dark, 160.1, 5.0);
  EXPECT_NEAR(middle / dark, 2.0 * 3600.0 + 25.0 * 60.0 + 32.0, 25.0);
  EXPECT_NEAR(partial, 172.0, 10.0);  // the partial phase takes about 2 h 52 min there
}

TEST(Illumination, RefusesPointsInside) {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([] { (void)seen_past_sphere(lines(1.0, 6e6), 6.371e6); }),
            "visible_sun: the body, of radius 6371000 m, is 6e+06 m away");
  EXPECT_THROW((void)seen_past_sphere(lines(1.0, 7e6), 0.0), BadInput);
  EXPECT_THROW((void)seen_past_sphere(lines(1.0, 7e6), not_a_number), BadInput);
  EXPECT_EQ(complaint([] { (void)seen_past_earth(lines(1.0, 6.3e6)); }),
            "visible_sun: the point is inside the ellipsoid, 6300000 m from its centre");
  EXPECT_EQ(complaint([] {
              (void)seen_past_earth({{5e8, 0.0, 0.0}, {7e6, 0.0, 0.0}});
            }),
            "visible_sun: the Sun, of radius 695700000 m, is 5e+08 m away");
  EXPECT_THROW(
      (void)visible_sun(displacement(of<Sun>, relative_to<Satellite>, (au * si::metre) * unit_x(in<Gcrf>)),
                        displacement(of<Moon>, relative_to<Satellite>, (4e8 * si::metre) * unit_x(in<Gcrf>)),
                        sky::moon_radius, -1.0 * si::metre),
      BadInput);
}

}  // namespace
}  // namespace vectrix::illumination_test
