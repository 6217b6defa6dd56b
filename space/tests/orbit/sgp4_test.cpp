#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/elements.hpp>
#include <vectrix/space/orbit/sgp4.hpp>

#include "temporary_file.hpp"

namespace vectrix::sgp4_test {
namespace {

using Eigen::Vector3d;

struct Ship : moving_frame {};
using Orbit = Sgp4<Ship>;
using Motion = PointMotion<earth::Teme, Ship, earth::Teme>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// The published states have 8 decimals of a km and 9 of a km/s. 1e-7 km is the agreement that AIAA 2006-6753
// asks of an implementation.
constexpr double published_position = 1e-4, published_velocity = 1e-6;  // m, m/s
// What half a unit in the last place of the mean motion and of the time changes after t, of the way v t, in
// their program and in ours.
constexpr double published_phase = 2 * epsilon;
// Their program kept the epoch as a Julian date in one double: half a unit in its last place.
constexpr Quantity<si::time> rounding_of_julian_date = 20.1e-6 * si::second;

const std::filesystem::path data = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data";
const AtMost ten_days = at_most(240.0 * si::hour), four_years = at_most(35064.0 * si::hour);

std::vector<TwoLineElements> sets() {
  return TwoLineElements::read(data / "sgp4_sets.tle");
}
std::vector<TwoLineElements> later_sets() {
  return TwoLineElements::read(data / "sgp4_later_sets.tle");
}
MeanElements elements_of(int catalogue_number) {
  for (const auto& set : sets()) {
    if (set.catalogue_number() == catalogue_number) return set.mean_elements();
  }
  throw BadInput("no set " + std::to_string(catalogue_number));
}
Epoch after(const MeanElements& elements, double minutes) {
  return elements.epoch + convert<si::time>(minutes * si::minute);
}
bool same_bits(const Motion& a, const Motion& b) {
  return a.position.coordinates() == b.position.coordinates() &&
         a.velocity.coordinates() == b.velocity.coordinates();
}

void expect_published(const std::vector<TwoLineElements>& sets, const CsvTable& table) {
  std::map<int, Orbit> orbits, later_orbits;
  for (const auto& set : sets) {
    orbits.emplace(set.catalogue_number(), Orbit(set, four_years));
    MeanElements later = set.mean_elements();
    later.epoch = later.epoch + rounding_of_julian_date;
    later_orbits.emplace(set.catalogue_number(), Orbit(later, four_years));
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const int number = static_cast<int>(table.number(i, "norad"));
    const Orbit &orbit = orbits.at(number), &later = later_orbits.at(number);
    const double t = table.number(i, "t_min");
    const auto km = [&](const char* x, const char* y, const char* z) {
      return Vector3d(1000.0 * Vector3d(table.number(i, x), table.number(i, y), table.number(i, z)));
    };
    const auto motion = orbit.at(after(orbit.elements(), t));
    const Vector3d v = km("vx_kms", "vy_kms", "vz_kms");
    const double way = v.norm() * 60.0 * std::abs(t);
    const double by_epoch =
        (later.at(after(later.elements(), t)).position.coordinates() - motion.position.coordinates()).norm();
    EXPECT_LE((motion.position.coordinates() - km("x_km", "y_km", "z_km")).norm(),
              published_position + published_phase * way + by_epoch)
        << table.text(i, "norad") << " at " << t << " min";
    EXPECT_LE((motion.velocity.coordinates() - v).norm(), published_velocity)
        << table.text(i, "norad") << " at " << t << " min";
  }
}

TEST(Sgp4, PublishedStates) {
  ASSERT_EQ(sets().size(), 11U);
  const auto table = CsvTable::read(data / "sgp4_states.csv", {"norad", "t_min"});
  ASSERT_EQ(table.rows(), 266U);
  expect_published(sets(), table);
}
TEST(Sgp4, PublishedStatesOfTheOtherSets) {
  ASSERT_EQ(later_sets().size(), 18U);
  const auto table = CsvTable::read(data / "sgp4_later_states.csv", {"norad", "t_min"});
  ASSERT_EQ(table.rows(), 37U);
  expect_published(later_sets(), table);
}

// Three of the published tables end with an error of the authors' program.
TEST(Sgp4, EndsWhereTheVerificationEnds) {
  const auto last = [](int number, double minutes) {
    for (const auto& set : later_sets()) {
      if (set.catalogue_number() != number) continue;
      return complaint([&] { (void)Orbit(set, ten_days).at(after(set.mean_elements(), minutes)); });
    }
    return std::string{"no set"};
  };
  EXPECT_NE(last(22312, 494.2028672).find("the mean eccentricity is -0.001"), std::string::npos);
  EXPECT_NE(last(28872, 55.0).find("decayed"), std::string::npos);
  EXPECT_NE(last(29141, 440.0).find("decayed"), std::string::npos);
}

// Elements that differ by whole turns are the same: also near the equator, where the theory has a term that
// is not periodic in the node.
TEST(Sgp4, WholeTurnsChangeNothing) {
  const auto turn = convert<si::angle>(1.0 * si::revolution);
  // Angles of up to 500 rad, rounded, and what e = 0.8 makes of them near perigee.
  constexpr double rounding = 500 * 10 * epsilon;
  for (const auto& set : sets()) {
    const MeanElements& x = set.mean_elements();
    MeanElements node = x, perigee = x, anomaly = x;
    node.ascending_node -= turn;
    perigee.argument_of_perigee += turn;
    anomaly.mean_anomaly.angle -= 2.0 * turn;
    for (double t = -3000.0; t <= 3000.0; t += 500.0) {
      const Vector3d r = Orbit(x, ten_days).at(after(x, t)).position.coordinates();
      for (const MeanElements& same : {node, perigee, anomaly}) {
        const Vector3d other = Orbit(same, ten_days).at(after(x, t)).position.coordinates();
        EXPECT_LE((other - r).norm(), rounding * r.norm()) << set.catalogue_number() << " at " << t << " min";
      }
    }
  }
}

// A node too little below zero to differ from it is zero, not a whole turn.
TEST(Sgp4, ANodeJustBelowZeroIsZero) {
  MeanElements zero = elements_of(23599), below = zero;  // deep space, near the equator
  zero.ascending_node = 0.0 * si::radian;
  below.ascending_node = -1e-17 * si::radian;
  for (const double t : {0.0, 1.0, 500.0}) {
    const auto r = [&](const MeanElements& x) -> Vector3d {
      return Orbit(x, ten_days).at(after(x, t)).position.coordinates();
    };
    EXPECT_EQ(r(below), r(zero)) << t;
  }
}

// The state of the resonance is local to a call.
TEST(Sgp4, DependsOnTheEpochAlone) {
  std::mt19937_64 random(20270203);
  for (const auto& set : sets()) {
    const Orbit orbit(set, ten_days);
    std::vector<Epoch> epochs;
    std::vector<Motion> in_order;
    for (int k = -40; k <= 40; ++k) {
      epochs.push_back(after(orbit.elements(), 71.0 * k));
      in_order.push_back(orbit.at(epochs.back()));
    }
    std::vector<std::size_t> order(epochs.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), random);
    const Orbit copy = orbit;
    for (const std::size_t k : order) {
      EXPECT_TRUE(same_bits(orbit.at(epochs[k]), in_order[k])) << set.catalogue_number();
      EXPECT_TRUE(same_bits(copy.at(epochs[k]), in_order[k])) << set.catalogue_number();
    }
  }
}

// Each derivative against differences of sixth order of the one before it, over 30 s. The angles count up to
// 1e3 rad in ten days, so that a position of 1e7 m is rounded by some 1e-6 m, and each derivative by 1e-2 of
// the one before it, of 1/s at most.
TEST(Sgp4, PathHasTheDerivativesOfThePosition) {
  constexpr double h = 5.0, position_rounding = 2e-6;  // s, m
  for (const auto& set : sets()) {
    const Orbit orbit(set, ten_days);
    for (int k = -20; k <= 20; ++k) {
      const Epoch t = after(orbit.elements(), 701.0 * k + 13.0);  // min, no multiple of the resonance's 720
      const auto now = orbit.path(t);
      EXPECT_LE((now.motion.position.coordinates() - orbit.at(t).position.coordinates()).norm(),
                position_rounding);
      const auto slope = [&](const auto& of) -> Vector3d {
        const auto change = [&](double seconds) -> Vector3d {
          const auto d = seconds * si::second;
          return of(orbit.path(t + d)) - of(orbit.path(t - d));
        };
        return (45.0 * change(h) - 9.0 * change(2.0 * h) + change(3.0 * h)) / (60.0 * h);
      };
      const auto r = [](const auto& path) { return path.motion.position.coordinates(); };
      const auto v = [](const auto& path) { return path.motion.velocity.coordinates(); };
      const auto a = [](const auto& path) { return path.acceleration.coordinates(); };
      EXPECT_LE((v(now) - slope(r)).norm(), position_rounding) << set.catalogue_number() << ", " << k;
      EXPECT_LE((a(now) - slope(v)).norm(), 1e-2 * position_rounding) << set.catalogue_number() << ", " << k;
      EXPECT_LE((now.jerk.vector().coordinates() - slope(a)).norm(), 1e-4 * position_rounding)
          << set.catalogue_number() << ", " << k;
    }
  }
}

TEST(Sgp4, IsAnEdgeOfAGraphAndSoIsItsPath) {
  const auto set = sets().front();
  const Orbit orbit(set, ten_days);
  const Epoch t = after(orbit.elements(), 100.0);
  using earth::Teme;
  const auto velocity = [&](const auto& graph) {
    return graph.at(t).velocity(of<Ship>, relative_to<Teme>, observed_from<Teme>, in<Teme>).coordinates();
  };
  const auto published = frame_graph(edge(orbit));
  EXPECT_EQ(published.at(t).position(of<Ship>, relative_to<Teme>, in<Teme>).coordinates(),
            orbit.at(t).position.coordinates());
  EXPECT_EQ(velocity(published), orbit.at(t).velocity.coordinates());
  EXPECT_EQ(published.at(t).rotation(to<Teme>, from<Ship>).matrix(), Eigen::Matrix3d::Identity());
  for (const auto& each : sets()) {  // the edge is computed without the jerk
    const Orbit moving(each, ten_days);
    const auto exact = frame_graph(edge(path(moving)));
    const Epoch later = after(moving.elements(), 100.0);
    const auto now = moving.path(later);
    const auto at = exact.at(later);
    EXPECT_EQ(at.position(of<Ship>, relative_to<Teme>, in<Teme>).coordinates(),
              now.motion.position.coordinates());
    EXPECT_EQ(at.velocity(of<Ship>, relative_to<Teme>, observed_from<Teme>, in<Teme>).coordinates(),
              now.motion.velocity.coordinates());
    EXPECT_EQ(at.acceleration(of<Ship>, relative_to<Teme>, observed_from<Teme>, in<Teme>).coordinates(),
              now.acceleration.coordinates());
  }
}

// What is published as velocity is not the derivative of the position, and how far it is from it.
TEST(Sgp4, VelocityIsThatOfTheTheory) {
  const auto apart = [](int number, double minutes) {
    const Orbit orbit(elements_of(number), ten_days);
    const Epoch t = after(orbit.elements(), minutes);
    return (orbit.path(t).motion.velocity.coordinates() - orbit.at(t).velocity.coordinates()).norm();
  };
  for (double minutes = -1400.0; minutes <= 1400.0; minutes += 7.0) {
    EXPECT_LE(apart(6251, minutes), 0.1);    // m/s; a low orbit
    EXPECT_LE(apart(11801, minutes), 25.0);  // of 10 h, e = 0.73
  }
}

// The terms of J2 grow with 1/p^2: deep inside the Earth the position is no motion, though the theory has
// one.
TEST(Sgp4, NoPathDeepThroughTheEarth) {
  MeanElements elements = elements_of(11801);
  EXPECT_NO_THROW((void)Orbit(elements, ten_days).path(elements.epoch));
  elements.mean_anomaly.angle = convert<si::angle>(180.0 * si::degree);  // far from the perigee
  elements.eccentricity = 0.98;
  const Orbit orbit(elements, ten_days);
  EXPECT_NO_THROW((void)orbit.at(elements.epoch));
  const double n = elements.mean_motion.value(), mu = 3.986008e14;
  const double p = std::cbrt(mu / (n * n)) * (1.0 - 0.98 * 0.98) / 1e3;
  const std::string said = complaint([&] { (void)orbit.path(elements.epoch); });
  const std::size_t at = said.find("p = a (1 - e^2) is ");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_NEAR(std::stod(said.substr(at + 19)), p, 0.02 * p) << said;  // J2 changes a of the theory by 1/p^2
  EXPECT_NE(said.find("above 0.01 the derivatives of the position are no motion"), std::string::npos) << said;
}

TEST(Sgp4, ThreadsShareOne) {
  const Orbit orbit(elements_of(8195), ten_days);
  constexpr int count = 400;
  const auto epoch_of = [&](int k) { return after(orbit.elements(), 31.0 * (k - count / 2)); };
  std::vector<Motion> alone;
  for (int k = 0; k < count; ++k) alone.push_back(orbit.at(epoch_of(k)));
  std::vector<int> different(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < different.size(); ++thread) {
    threads.emplace_back([&, thread] {
      for (int n = 0; n < count; ++n) {
        const int k = (n * 7 + static_cast<int>(thread) * 101) % count;
        if (!same_bits(orbit.at(epoch_of(k)), alone[static_cast<std::size_t>(k)])) ++different[thread];
      }
    });
  }
  for (auto& thread : threads) thread.join();
  for (const int count_of_thread : different) EXPECT_EQ(count_of_thread, 0);
}

// The theory's velocity leaves out of the derivative: terms of J2 times e and of J2^2; the shrinking of the
// orbit by drag; the changes of the elements by the Sun and the Moon, GM/(d^3 n^2) in a radian, GM/d^3
// together 1.3e-13/s^2.
TEST(Sgp4, VelocityIsTheDerivativeOfThePosition) {
  constexpr double J2 = 1.0826e-3, earth_radius = 6378135.0, mu = 3.986008e14, third_bodies = 1.3e-13;
  constexpr double terms_of_a_kind = 5.0;  // that may add up
  for (const auto& set : sets()) {
    const Orbit orbit(set, ten_days);
    const double n = orbit.elements().mean_motion.value(), e = orbit.elements().eccentricity;
    const double a = std::cbrt(mu / (n * n)), p = a * (1.0 - e * e) / earth_radius, flattening = J2 / (p * p);
    const double shrinking = 2.0 / 3.0 * set.mean_motion_rate().value() / n * a;
    for (int k = -60; k <= 60; ++k) {
      const Epoch epoch = after(orbit.elements(), 23.0 * k);
      const auto h = 1.0 * si::second;  // (n h)^2/6 of v is 4e-7, in a low orbit
      const Motion now = orbit.at(epoch), before = orbit.at(epoch - h), later = orbit.at(epoch + h);
      const Vector3d difference = (later.position.coordinates() - before.position.coordinates()) / 2.0;
      const double v = now.velocity.coordinates().norm(), r = now.position.coordinates().norm();
      EXPECT_LE((difference - now.velocity.coordinates()).norm(),
                terms_of_a_kind * (v * flattening * (e + flattening) + std::abs(shrinking) +
                                   third_bodies / (n * n) * (v + n * r)))
          << set.catalogue_number() << " at " << epoch;
    }
  }
}

TEST(Sgp4, AnswersToItsLongestAge) {
  const MeanElements elements = elements_of(6251);
  const Orbit orbit(elements, at_most(3.0 * si::hour));
  EXPECT_EQ(orbit.longest_age().value(), 10800.0);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_NO_THROW(static_cast<void>(orbit.at(elements.epoch + sign * orbit.longest_age())));
    EXPECT_THROW(static_cast<void>(orbit.at(elements.epoch + sign * 10800.001 * si::second)), BadInput);
  }
  EXPECT_EQ(complaint([&] { static_cast<void>(orbit.at(elements.epoch + 14400.0 * si::second)); }),
            "Sgp4(" + frame_name<Ship>() +
                "): 2006-06-25T23:46:43.980096 UTC is 14400 s from the epoch "
                "of the elements, 2006-06-25T19:46:43.980096 UTC; at most 10800 s were allowed");
  for (const double age : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(Orbit(elements, at_most(age * si::second)), BadInput) << age;
}

TEST(Sgp4, ElementsOutOfRange) {
  const double bad = std::nan("");
  const auto refused = [](auto change) {
    MeanElements elements = elements_of(6251);
    change(elements);
    return complaint([&] { Orbit(elements, ten_days); });
  };
  const auto rate = [](double x) { return Quantity<si::angular_velocity>::from_value(x); };
  for (const double n : {0.0, -1e-3, bad, std::numeric_limits<double>::infinity()})
    EXPECT_NE(refused([&](auto& x) { x.mean_motion = rate(n); }).find("the mean motion of"),
              std::string::npos);
  for (const double e : {-1e-9, 1.0, 1.5, bad})
    EXPECT_NE(refused([&](auto& x) { x.eccentricity = e; }).find("the eccentricity of"), std::string::npos);
  for (const double i : {-1e-9, 3.1416, bad})
    EXPECT_NE(refused([&](auto& x) { x.inclination = i * si::radian; }).find("the inclination of"),
              std::string::npos);
  EXPECT_NE(refused([&](auto& x) { x.ascending_node = bad * si::radian; }).find("node"), std::string::npos);
  EXPECT_NE(refused([&](auto& x) { x.argument_of_perigee = bad * si::radian; }).find("perigee"),
            std::string::npos);
  EXPECT_NE(refused([&](auto& x) { x.mean_anomaly.angle = bad * si::radian; }).find("anomaly"),
            std::string::npos);
  for (const double wrong : {bad, 1e9, -101.0})
    EXPECT_NE(refused([&](auto& x) { x.bstar = wrong * bstar_unit; }).find("B*"), std::string::npos) << wrong;
  // 15 rev/day written as rad/s, rad/min, rad/h; and a unit too slow.
  for (const double n : {15.0, 15.0 / 60, 15.0 / 3600})
    EXPECT_NE(refused([&](auto& x) { x.mean_motion = rate(n); }).find("; the orbit is inside the Earth"),
              std::string::npos);
  EXPECT_NE(
      refused([&](auto& x) { x.mean_motion = rate(1.1e-3 / 3600); }).find("; the Earth holds no satellite"),
      std::string::npos);
  for (const double n : {1.24e-3, 4e-7})
    EXPECT_EQ(refused([&](auto& x) { x.mean_motion = rate(n), x.eccentricity = 0.01; }), "nothing was thrown")
        << n;
  EXPECT_EQ(refused([](auto& x) { x.eccentricity = 1.5; }),
            "Sgp4(" + frame_name<Ship>() + "): the eccentricity of the elements is 1.5, not in [0, 1)");
}

TEST(Sgp4, EndsOfTheTheory) {
  struct End {
    int catalogue_number;
    double bstar_factor, eccentricity, days;
    const char* message;
  };
  for (const End& end : {End{6251, 1.0, 0.3, -1.0, "less than one Earth radius: decayed"},
                         End{6251, 1000.0, 0.003, 9.0, "the terms of drag leave no orbit"},
                         End{5, 100.0, 0.3, -1e4, "the mean eccentricity is 3.6"},
                         End{5, -10.0, 0.3, -1e4, "the mean eccentricity is -0.03"},
                         End{8195, 1.0, 0.7, -7200.0, "with the terms of the Sun and the Moon is 1.0"},
                         End{6251, 10.0, 0.99, 1.0, "the eccentricity with the terms of J3 is 1.02"}}) {
    MeanElements elements = elements_of(end.catalogue_number);
    elements.bstar = end.bstar_factor * elements.bstar;
    elements.eccentricity = end.eccentricity;
    const Orbit orbit(elements, at_most(1e6 * si::hour));
    const auto text = complaint([&] { static_cast<void>(orbit.at(after(elements, 1440.0 * end.days))); });
    EXPECT_NE(text.find(detail::text(1440.0 * end.days) + " min from the epoch of the elements: "),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(end.message), std::string::npos) << text;
  }
  EXPECT_NE(complaint([] { Orbit(sets().front(), at_most(0.0 * si::hour)); }).find("catalogue number 5, "),
            std::string::npos);
}

// The mean elements are not those of the motion.
TEST(Sgp4, MeanElementsAreNotOsculating) {
  const MeanElements mean = elements_of(6251);
  const auto mu = Quantity<si::gravitational_parameter>::from_value(3.986008e14);
  const auto osculating = keplerian_elements(mu, Orbit(mean, ten_days).at(mean.epoch));
  const double n = mean.mean_motion.value(), a = std::cbrt(mu.value() / (n * n));
  EXPECT_GT(std::abs(osculating.semi_major_axis().value() - a), 1e3);
  EXPECT_LT(std::abs(osculating.semi_major_axis().value() - a), 2e4);
}

}  // namespace
}  // namespace vectrix::sgp4_test
