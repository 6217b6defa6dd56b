#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/elements.hpp>
#include <vectrix/space/orbit/modified_equinoctial.hpp>

#include "temporary_file.hpp"

namespace vectrix::elements_test {
namespace {

using Eigen::Vector3d;

struct Gcrf : inertial_frame {};
struct Ship : moving_frame {};
using Orbit = PointMotion<Gcrf, Ship, Gcrf>;

constexpr double pi = std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);

// Elements of a motion and back: some ten roundings of r and v.
constexpr double round_trip = 16 * epsilon;

Orbit orbit(const Vector3d& r, const Vector3d& v) {
  return point_motion(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}
auto keplerian(double p, double e, double i, double node, double w, double nu) {
  return keplerian_elements(of<Ship>, relative_to<Gcrf>, in<Gcrf>, p * si::metre, e, i * si::radian,
                            node * si::radian, w * si::radian, TrueAnomaly{nu * si::radian});
}
double angle_off(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * pi));
}
// The largest relative error of position and velocity.
void expect_same(const Orbit& one, const Orbit& other, double tolerance, const char* what) {
  const auto off = [](const Vector3d& x, const Vector3d& y) { return (x - y).norm() / y.norm(); };
  EXPECT_LE(off(one.position.coordinates(), other.position.coordinates()), tolerance) << what;
  EXPECT_LE(off(one.velocity.coordinates(), other.velocity.coordinates()), tolerance) << what;
}

template <class Sense> void expect_equinoctial_round_trip(Sense sense, const Orbit& start, double tolerance) {
  const auto elements = modified_equinoctial(sense, mu, start);
  expect_same(point_motion(mu, elements), start, tolerance, "equinoctial");
}

// Long, narrow orbits, s the sine of the angle between r and v: r and v come back as well as is said, or not
// at all.
TEST(Elements, GiveNarrowOrbitsBackAsTheySay) {
  // e, nu, their product and sum, and what they came from: some halves of an ulp each.
  constexpr double times_the_law = 4.0;
  for (const double s : {0.1, 1e-2, 1e-3, 1e-4, 6e-5}) {
    for (const double v : {3e3, -9e3, 2e4}) {
      const Orbit start = orbit(Vector3d(7e6, 1e5, 0), v * Vector3d(1, s, 0.3 * s));
      const auto x = keplerian_elements(mu, start);
      const double law =
          epsilon * (1.0 + x.eccentricity()) * norm(start.position).value() / x.semi_latus_rectum().value();
      expect_same(point_motion(mu, x), start, times_the_law * law, "keplerian");
      expect_equinoctial_round_trip(prograde, start, times_the_law * law);
    }
  }
  for (const double s : {2e-7, 1e-5}) {
    const Orbit start = orbit(Vector3d(7e6, 0, 0), Vector3d(3e3, 3e3 * s, 0));
    for (const auto& said : {complaint([&] { (void)keplerian_elements(mu, start); }),
                             complaint([&] { (void)modified_equinoctial(prograde, mu, start); })})
      EXPECT_NE(said.find("m: |r| = p/(1 + e cos nu) would come back from the elements with an error of "),
                std::string::npos)
          << said;
  }
}

// Every degenerate case and its neighbourhood.
TEST(Elements, ToAndFromTheMotionInEveryCase) {
  std::mt19937_64 random(20270131);
  std::uniform_real_distribution<double> angle(-pi, pi), unit(-0.95, 0.95);
  for (const double e : {0.0, 1e-16, 1e-9, 0.01, 0.7, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.5, 20.0}) {
    for (const double i : {0.0, 1e-16, 1e-9, 1e-4, 0.5, pi / 2, 2.0, pi - 1e-4, pi - 1e-9, pi}) {
      for (int k = 0; k < 5; ++k) {
        const double limit = e < 1.0 ? pi : e > 1.0 ? std::acos(-1.0 / e) : pi;
        const double nu = limit * unit(random), p = 1e7 * (1.0 + e);
        const Orbit start = point_motion(mu, keplerian(p, e, i, angle(random), angle(random), nu));
        // Elements near their singularity are poorly defined, but lead back to the motion as accurately.
        // An error of e cos nu changes r by r/p of it.
        const double tolerance = round_trip * (1.0 + e) / (1.0 + e * std::cos(nu));
        expect_same(point_motion(mu, keplerian_elements(mu, start)), start, tolerance, "keplerian");
        if (i < pi - 1e-10) expect_equinoctial_round_trip(prograde, start, tolerance);
        if (i > 1e-10) expect_equinoctial_round_trip(retrograde, start, tolerance);
      }
    }
  }
}

TEST(Elements, FromElementsAndBack) {
  std::mt19937_64 random(20270132);
  std::uniform_real_distribution<double> angle(-pi, pi), unit(0.05, 0.95);
  for (int n = 0; n < 300; ++n) {
    const double e = n % 3 ? unit(random) : 1.0 + unit(random), i = pi * unit(random), node = angle(random),
                 w = angle(random), nu = 1.5 * unit(random), p = 7e6 * (1 + unit(random));
    const auto x = keplerian_elements(mu, point_motion(mu, keplerian(p, e, i, node, w, nu)));
    const double tolerance = 32 * epsilon / (0.05 * 0.05);  // e and sin i are at least 0.05 and 0.15
    EXPECT_NEAR(x.semi_latus_rectum().value(), p, 16 * epsilon * p);
    EXPECT_NEAR(x.eccentricity(), e, 16 * epsilon);
    EXPECT_NEAR(x.inclination().value(), i, 16 * epsilon);
    EXPECT_LE(angle_off(x.ascending_node().value(), node), tolerance);
    EXPECT_LE(angle_off(x.argument_of_periapsis().value(), w), tolerance);
    EXPECT_LE(angle_off(x.true_anomaly().angle.value(), nu), tolerance);
  }
}

TEST(Elements, DegenerateAnglesByConvention) {
  const double r = 7e6, v = std::sqrt(mu.value() / r);
  // A circle in the plane of x and y, a quarter turn after x; the same backwards.
  const auto forward = keplerian_elements(mu, orbit(Vector3d(0, r, 0), Vector3d(-1.2 * v, 0, 0)));
  EXPECT_EQ(forward.inclination().value(), 0.0);
  EXPECT_EQ(forward.ascending_node().value(), 0.0);
  EXPECT_NEAR(forward.argument_of_periapsis().value(), pi / 2, epsilon);
  EXPECT_EQ(forward.true_anomaly().angle.value(), 0.0);
  const auto backward = keplerian_elements(mu, orbit(Vector3d(0, r, 0), Vector3d(1.2 * v, 0, 0)));
  EXPECT_EQ(backward.inclination().value(), pi);
  EXPECT_EQ(backward.ascending_node().value(), 0.0);
  EXPECT_NEAR(backward.argument_of_periapsis().value(), -pi / 2, epsilon);
  // mu, r and v for which e is exactly zero: periapsis is at the node.
  const auto one = Quantity<si::gravitational_parameter>::from_value(1.0);
  const auto circle = keplerian_elements(one, orbit(Vector3d(0, 0, 1), Vector3d(0, -1, 0)));
  EXPECT_EQ(circle.eccentricity(), 0.0);
  EXPECT_EQ(circle.argument_of_periapsis().value(), 0.0);
  EXPECT_NEAR(circle.true_anomaly().angle.value(), pi / 2, epsilon);
  EXPECT_NEAR(angle_off(circle.ascending_node().value(), pi / 2), 0.0, epsilon);
}

TEST(Elements, SizeOfTheConic) {
  EXPECT_NEAR(keplerian(1.5e7, 0.5, 0, 0, 0, 0).semi_major_axis().value(), 2e7, 1e-8);
  EXPECT_NEAR(keplerian(1.5e7, 0.5, 0, 0, 0, 0).periapsis_distance().value(), 1e7, 1e-8);
  EXPECT_NEAR(keplerian(1.5e7, 2.0, 0, 0, 0, 0).semi_major_axis().value(), -5e6, 1e-8);
  EXPECT_TRUE(std::isinf(keplerian(1.5e7, 1.0, 0, 0, 0, 0).semi_major_axis().value()));
  EXPECT_NEAR(semi_latus_rectum(2e7 * si::metre, 0.5).value(), 1.5e7, 1e-8);
  EXPECT_NEAR(semi_latus_rectum(-5e6 * si::metre, 2.0).value(), 1.5e7, 1e-8);
  EXPECT_THROW(semi_latus_rectum(5e6 * si::metre, 2.0), BadInput);
  EXPECT_THROW(semi_latus_rectum(5e6 * si::metre, 1.0), BadInput);
}

// Eutelsat W4: state and elements of an example of CCSDS' orbit data messages, as Orekit (CS-SI, Apache-2.0)
// tests it. The state has eight digits.
TEST(Elements, PublishedStateOfEutelsatW4) {
  const auto x = keplerian_elements(mu, orbit(1e3 * Vector3d(6655.9942, -40218.5751, -82.9177),
                                              1e3 * Vector3d(3.11548208, 0.47042605, -0.00101495)));
  const auto degrees = [](const Quantity<si::angle>& angle) { return angle.value() * 180 / pi; };
  EXPECT_NEAR(x.semi_major_axis().value(), 41399.5123e3, 1.0);
  EXPECT_NEAR(x.eccentricity(), 0.020842611, 2e-8);
  EXPECT_NEAR(degrees(x.inclination()), 0.117746, 1e-6);
  EXPECT_NEAR(degrees(x.ascending_node()), 17.604721, 1e-5);
  EXPECT_NEAR(degrees(x.argument_of_periapsis()), 218.242943 - 360, 1e-4);
  // The message calls 41.922339 deg the true anomaly. It is the mean anomaly of the state.
  const auto M = mean_anomaly(eccentric_anomaly(x.true_anomaly(), x.eccentricity()), x.eccentricity());
  EXPECT_NEAR(degrees(M.angle), 41.922339, 1e-4);
}

TEST(ModifiedEquinoctial, PublishedElements) {
  constexpr double published = 1e-14;             // sixteen printed digits; r x v is a difference
  constexpr double published_longitude = 2.2e-8;  // rad: that of one case is inaccurate, see the table
  constexpr auto gmat_mu = Quantity<si::gravitational_parameter>::from_value(3.986004418e14);
  const auto table = CsvTable::read(
      VECTRIX_SOURCE_DIR "/space/tests/data/modified_equinoctial.csv",
      {"case", "x_km", "y_km", "z_km", "vx_km_s", "vy_km_s", "vz_km_s", "p_km", "f", "g", "h", "k", "L_deg"});
  ASSERT_GE(table.rows(), 6u);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto at = [&](const char* column) { return table.number(row, column); };
    const Orbit state = orbit(1e3 * Vector3d(at("x_km"), at("y_km"), at("z_km")),
                              1e3 * Vector3d(at("vx_km_s"), at("vy_km_s"), at("vz_km_s")));
    const auto x = modified_equinoctial(prograde, gmat_mu, state);
    EXPECT_NEAR(x.semi_latus_rectum().value(), 1e3 * at("p_km"), published * 1e3 * at("p_km"));
    EXPECT_NEAR(x.f(), at("f"), published);
    EXPECT_NEAR(x.g(), at("g"), published);
    EXPECT_NEAR(x.h(), at("h"), published);
    EXPECT_NEAR(x.k(), at("k"), published);
    EXPECT_LE(angle_off(x.true_longitude().value(), at("L_deg") * pi / 180), published_longitude);
    const auto given = modified_equinoctial(prograde, of<Ship>, relative_to<Gcrf>, in<Gcrf>,
                                            1e3 * at("p_km") * si::metre, at("f"), at("g"), at("h"), at("k"),
                                            convert<si::angle>(at("L_deg") * si::degree));
    expect_same(point_motion(gmat_mu, given), state, published_longitude, "published");
  }
}

// f = e cos(w + I Om), h = tan^I(i/2) cos Om, L = nu + w + I Om.
template <class Sense> void expect_definition(Sense sense) {
  std::mt19937_64 random(20270133);
  std::uniform_real_distribution<double> angle(-pi, pi), unit(0.05, 0.95);
  for (int n = 0; n < 200; ++n) {
    const double e = unit(random), i = pi * unit(random), node = angle(random), w = angle(random),
                 nu = angle(random);
    const double I = Sense::factor, tangent = std::pow(std::tan(i / 2), I);
    const auto x = modified_equinoctial(sense, mu, point_motion(mu, keplerian(9e6, e, i, node, w, nu)));
    const double tolerance = 64 * epsilon / (1.0 - e), tilt = 64 * epsilon * (1 + tangent * tangent);
    EXPECT_NEAR(x.f(), e * std::cos(w + I * node), tolerance);
    EXPECT_NEAR(x.g(), e * std::sin(w + I * node), tolerance);
    EXPECT_NEAR(x.h(), tangent * std::cos(node), tilt);
    EXPECT_NEAR(x.k(), tangent * std::sin(node), tilt);
    EXPECT_LE(angle_off(x.true_longitude().value(), nu + w + I * node), tolerance);
    EXPECT_NEAR(x.distance_from_singularity().value(), I > 0 ? pi - i : i, 16 * epsilon);
  }
}
TEST(ModifiedEquinoctial, ByTheirDefinition) {
  expect_definition(prograde);
  expect_definition(retrograde);
}

// Next to the singularity the tilt is tan((pi - near)/2) = cot(near/2). Its relative error is that of `near`.
template <class Sense> void expect_tilt(Sense sense) {
  constexpr double I = Sense::factor, node = 0.7;
  for (double near = 0.1; near > 1e-7; near /= 10) {
    const double i = I > 0 ? pi - near : near, cotangent = 1.0 / std::tan((I > 0 ? pi - i : i) / 2);
    const auto x = modified_equinoctial(sense, mu, point_motion(mu, keplerian(9e6, 0.1, i, node, 0.2, 0.3)));
    EXPECT_NEAR(std::hypot(x.h(), x.k()), cotangent, 64 * epsilon / near * cotangent) << near;
    EXPECT_NEAR(x.k() / x.h(), std::tan(node), 64 * epsilon / near) << near;
  }
}
TEST(ModifiedEquinoctial, NextToTheSingularity) {
  expect_tilt(prograde);
  expect_tilt(retrograde);
}

TEST(Elements, RefuseWhatIsNoOrbit) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto said = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("Ship relative to"), std::string::npos) << message;
  };
  const auto made = [](double p, double e, double i, double nu) {
    return complaint([=] { return keplerian(p, e, i, 0, 0, nu); });
  };
  said(made(0, 0.1, 0, 0), "the semi-latus rectum is 0 m");
  said(made(nan, 0.1, 0, 0), "the semi-latus rectum is nan m");
  said(made(7e6, -0.1, 0, 0), "the eccentricity is -0.1");
  said(made(7e6, 0.1, -0.1, 0), "the inclination is -0.1 rad, not in [0, pi]");
  said(made(7e6, 0.1, 3.2, 0), "the inclination is 3.2 rad");
  said(made(7e6, 0.1, 1, nan), "an angle is nan rad");
  said(made(7e6, 2.0, 1, 2.5), "the true anomaly is 2.5 rad, not inside the asymptotes");
  const double asymptote = std::acos(-1.0 / 2.0), little = 1e-9;  // of e = 2
  for (const double nu : {asymptote - little, little - asymptote})
    EXPECT_EQ(made(7e6, 2.0, 1, nu), "nothing was thrown");
  said(made(7e6, 2.0, 1, asymptote + little), "not inside the asymptotes");

  const auto of_motion = [](const Vector3d& r, const Vector3d& v, double gravity) {
    return complaint([=] {
      return keplerian_elements(Quantity<si::gravitational_parameter>::from_value(gravity), orbit(r, v));
    });
  };
  said(of_motion({1, 0, 0}, {1, 1e-8, 0}, 1), "the sine of the angle between them 1e-08");
  said(of_motion({0, 0, 0}, {1, 0, 0}, 1), "|r| is 0 m");
  said(of_motion({1, 0, 0}, {0, 0, 0}, 1), "|v| 0 m/s; without both there is no orbital plane");
  said(of_motion({1, 0, 0}, {0, 1, 0}, 0), "mu is 0 m^3/s^2");

  const auto equatorial = [](double y) { return orbit(Vector3d(7e6, 0, 0), Vector3d(0, y, 0)); };
  said(complaint([&] { return modified_equinoctial(prograde, mu, equatorial(-7e3)); }),
       "the inclination is pi: a singularity of prograde elements");
  said(complaint([&] { return modified_equinoctial(retrograde, mu, equatorial(7e3)); }),
       "the inclination is 0: a singularity of retrograde elements");
  const auto given = [](double f, double L) {
    return complaint([=] {
      return modified_equinoctial(prograde, of<Ship>, relative_to<Gcrf>, in<Gcrf>, 7e6 * si::metre, f, 0.0,
                                  0.0, 0.0, L * si::radian);
    });
  };
  said(given(nan, 0), "an element is nan");
  said(given(2.0, pi), "1 + f cos L + g sin L is -1");
  EXPECT_EQ(given(2.0, asymptote - little), "nothing was thrown");
  said(given(2.0, asymptote + little), "not inside the asymptotes");
}

}  // namespace
}  // namespace vectrix::elements_test
