#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>
#include <vectrix/space/sky/ephemeris.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::ephemeris_test {
namespace {

using earth::Gcrf;
using sky::Moon;
using sky::Sun;
using vectrix_test::triple;

struct Satellite : moving_frame {};

constexpr double light = 299792458.0;  // m/s
// What the header promises of the pieces. ERFA's series themselves are 4 km and 15 km from the truth.
constexpr double sun_error = 10.0, moon_error = 0.01;  // m
// A difference of positions over 2 minutes: h^2/6 of the third derivative, 1e3 m/s (2.7e-6/s)^2; and at the
// join of two pieces of the Sun, where its velocity jumps.
constexpr double difference_error = 1e-5, join_error = 3e-4;  // m/s
// The velocity of eraMoon98 leaves out that the axes precess, by 7.7e-12 rad/s.
constexpr double precession_at_the_moon = 7.8e-12 * 4.07e8;  // m/s

const auto span = from_until(Epoch::from_tt("2021-12-20T00:00:00"), Epoch::from_tt("2023-02-01T00:00:00"));
// Built by the first test that asks: all tests of the program start with this file's constants.
const Ephemeris<Sun>& the_sun() {
  static const Ephemeris<Sun> sun(span);
  return sun;
}
const Ephemeris<Moon>& the_moon() {
  static const Ephemeris<Moon> moon(span);
  return moon;
}

// eraEpv00 is meant for TDB. The docs say how far TT in its place is off: 1.7 ms of 30.3 km/s.
TEST(Ephemeris, TtForTdbMovesTheSunByMetres) {
  constexpr double said = 51.0, seconds_of_tdb = 1.6e-3, slowest_earth = 29.2e3;  // m, s, m/s
  double largest = 0.0;
  for (int month = 0; month < 12; ++month) {
    const auto t = Epoch::from_utc_mjd(59215 + 30 * month);
    const auto tdb = t.julian_date(scale::tdb);
    double heliocentric[2][3], barycentric[2][3];
    eraEpv00(tdb.day, tdb.fraction, heliocentric, barycentric);
    const Eigen::Vector3d sun(-heliocentric[0][0], -heliocentric[0][1], -heliocentric[0][2]);
    const auto given = geocentric(of<Sun>, t).position.coordinates();
    largest = std::max(largest, (given - ERFA_DAU * sun).norm());
  }
  EXPECT_LT(largest, said);
  EXPECT_GT(largest, seconds_of_tdb * slowest_earth);
}

rc::Gen<Epoch> epoch_of_span() {
  return rc::gen::map(rc::gen::inRange(0, 1'000'000'000),
                      [](int part) { return span.start() + (part / 1e9) * (span.end() - span.start()); });
}

// Position, m, and velocity, m/s, by ERFA's own numbers.
struct Motion {
  Eigen::Vector3d r, v;
};
Motion in_metres(const double (&pv)[2][3]) {
  return {ERFA_DAU * Eigen::Vector3d(pv[0][0], pv[0][1], pv[0][2]),
          ERFA_DAU / ERFA_DAYSEC * Eigen::Vector3d(pv[1][0], pv[1][1], pv[1][2])};
}
Motion sun_by_erfa(const Epoch& t) {
  double heliocentric[2][3];
  double barycentric[2][3];
  eraEpv00(t.tt_date().day, t.tt_date().fraction, heliocentric, barycentric);
  const auto earth_from_sun = in_metres(heliocentric);
  return {-earth_from_sun.r, -earth_from_sun.v};
}
Motion earth_by_erfa(const Epoch& t) {
  double heliocentric[2][3];
  double barycentric[2][3];
  eraEpv00(t.tt_date().day, t.tt_date().fraction, heliocentric, barycentric);
  return in_metres(barycentric);
}
Motion moon_by_erfa(const Epoch& t) {
  double pv[2][3];
  eraMoon98(t.tt_date().day, t.tt_date().fraction, pv);
  return in_metres(pv);
}

template <class B> Eigen::Vector3d r_of(const PointMotion<Gcrf, B, Gcrf>& motion) {
  return motion.position.coordinates();
}
template <class B> Eigen::Vector3d v_of(const PointMotion<Gcrf, B, Gcrf>& motion) {
  return motion.velocity.coordinates();
}

RC_GTEST_PROP(Ephemeris, GeocentricIsErfas, ()) {
  const auto t = *epoch_of_span();
  constexpr double rounding = 1e-15;
  const auto near = [](const Eigen::Vector3d& found, const Eigen::Vector3d& expected) {
    return (found - expected).norm() <= rounding * expected.norm();
  };
  RC_ASSERT(near(r_of(geocentric(of<Sun>, t)), sun_by_erfa(t).r));
  RC_ASSERT(near(v_of(geocentric(of<Sun>, t)), sun_by_erfa(t).v));
  RC_ASSERT(near(r_of(geocentric(of<Moon>, t)), moon_by_erfa(t).r));
  RC_ASSERT(near(v_of(geocentric(of<Moon>, t)), moon_by_erfa(t).v));
}

RC_GTEST_PROP(Ephemeris, FollowsTheSeries, ()) {
  const auto t = *epoch_of_span();
  RC_ASSERT((r_of(the_sun().motion(t)) - sun_by_erfa(t).r).norm() < sun_error);
  RC_ASSERT((r_of(the_moon().motion(t)) - moon_by_erfa(t).r).norm() < moon_error);
}

// v = dr/dt
RC_GTEST_PROP(Ephemeris, VelocityIsTheDerivativeOfThePosition, ()) {
  const auto t = *epoch_of_span();
  const auto h = 60.0 * si::second;
  RC_PRE(span.contains(t - h) && span.contains(t + h));
  const auto difference = [&](const auto& body) {
    const Eigen::Vector3d moved = r_of(body.motion(t + h)) - r_of(body.motion(t - h));
    return (moved / (2.0 * h.value()) - v_of(body.motion(t))).norm();
  };
  RC_ASSERT(difference(the_sun()) < join_error);
  RC_ASSERT(difference(the_moon()) < difference_error);
  RC_ASSERT((v_of(the_sun().motion(t)) - sun_by_erfa(t).v).norm() < join_error);
  RC_ASSERT((v_of(the_moon().motion(t)) - moon_by_erfa(t).v).norm() < precession_at_the_moon);
}

// The pieces begin at days of TAI whose number since 2000 January 1 is a multiple of 16, or of 4.
TEST(Ephemeris, IsContinuousBetweenPieces) {
  const auto join = Epoch::from_julian_date(scale::tai, 2451544.5 + 16.0 * 504.0);
  ASSERT_TRUE(span.contains(join));
  const auto before = join - 1e-6 * si::second;
  constexpr double moved = 1e-6 * 1.2e3 + 1e-4;  // m: the Moon's path in between, and the rounding of 1e11 m
  EXPECT_LT((r_of(the_moon().motion(join)) - r_of(the_moon().motion(before))).norm(), moved);
  EXPECT_LT((r_of(the_sun().motion(join)) - r_of(the_sun().motion(before))).norm(), moved + 1e-6 * 3e4);
}

TEST(Ephemeris, DoesNotDependOnTheSpan) {
  const auto t = Epoch::from_utc("2022-07-03T04:05:06.789");
  const auto shorter = from_until(t - 100.0 * si::second, 200.0 * si::second);
  EXPECT_EQ(r_of(Ephemeris<Sun>(shorter).motion(t)), r_of(the_sun().motion(t)));
  EXPECT_EQ(v_of(Ephemeris<Moon>(shorter).motion(t)), v_of(the_moon().motion(t)));
  const auto instant = from_until(t, t);
  EXPECT_EQ(r_of(Ephemeris<Moon>(instant).motion(t)), r_of(the_moon().motion(t)));
}

// Published: Earth at perihelion on 2022 January 4, 6:55 UTC, 0.9833365 au away; Meeus' example 47.a, the
// Moon at 368409.7 km on 1992 April 12, 0 h TD.
TEST(Ephemeris, KnownDistances) {
  const auto perihelion = Epoch::from_utc("2022-01-04T06:55:00");
  const auto distance = [&](double minutes) {
    return norm(the_sun().motion(perihelion + minutes * 60.0 * si::second).position).value();
  };
  EXPECT_NEAR(distance(0.0) / ERFA_DAU, 0.9833365, 5e-8);
  EXPECT_GT(distance(-20.0), distance(0.0));
  EXPECT_GT(distance(20.0), distance(0.0));
  const auto moon = geocentric(of<Moon>, Epoch::from_tt("1992-04-12T00:00:00"));
  EXPECT_NEAR(norm(moon.position).value(), 368409.7e3, 0.1e3);
}

Displacement<Gcrf, Satellite, In<Gcrf>> at(const Eigen::Vector3d& r) {
  return displacement(of<Satellite>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r));
}
PointMotion<Gcrf, Satellite, Gcrf> moving(const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
  return point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}

// The light left the body at t - |d|/c, where the series put it relative to the barycentre. The Earth's
// pieces are at both instants wrong by the same, to 1e-4 m/s.
template <class B, class Series>
void obeys_the_light_time(const Ephemeris<B>& body, Series series, double error, const Epoch& t,
                          const Eigen::Vector3d& r) {
  const auto d = body.line_of_sight(t, at(r), light_time).coordinates();
  const auto left = t - (d.norm() / light) * si::second;
  const Eigen::Vector3d way_of_the_earth = earth_by_erfa(left).r - earth_by_erfa(t).r;
  RC_ASSERT((d - (way_of_the_earth + series(left).r - r)).norm() < error);
  const auto here = body.line_of_sight(t, at(r), geometric).coordinates();
  RC_ASSERT((here - (r_of(body.motion(t)) - r)).norm() == 0.0);
}

RC_GTEST_PROP(Ephemeris, LightTimeIsWhereTheLightLeft, ()) {
  const auto t = *epoch_of_span();
  const Eigen::Vector3d r = 5e8 * *triple();
  obeys_the_light_time(the_sun(), sun_by_erfa, sun_error, t, r);
  obeys_the_light_time(the_moon(), moon_by_erfa, moon_error, t, r);
}

RC_GTEST_PROP(Ephemeris, ApparentIsTheAberrationOfErfa, ()) {
  const auto t = *epoch_of_span();
  const Eigen::Vector3d r = 5e7 * *triple();
  const Eigen::Vector3d v = 8e3 * *triple();
  const Eigen::Vector3d seen = the_sun().line_of_sight(t, moving(r, v), apparent).coordinates();
  const Eigen::Vector3d left = the_sun().line_of_sight(t, moving(r, v), light_time).coordinates();
  Eigen::Vector3d natural = left.normalized();
  Eigen::Vector3d velocity = (earth_by_erfa(t).v + v) / light;
  Eigen::Vector3d expected;
  eraAb(natural.data(), velocity.data(), left.norm() / ERFA_DAU, std::sqrt(1.0 - velocity.squaredNorm()),
        expected.data());
  constexpr double potential_of_the_sun = 3e-12;  // rad: eraAb has it, 2e-8 of the aberration
  RC_ASSERT((seen.normalized() - expected).norm() < potential_of_the_sun);
  RC_ASSERT(std::abs(seen.norm() / left.norm() - 1.0) < 1e-15 * 4.0);
}

// An observer in the centre of the Earth shares its motion with the Moon: aberration and the way of both
// during the light time cancel. What is left is the Moon's own way in the light time, and (v/c)^2.
RC_GTEST_PROP(Ephemeris, ApparentMoonIsBehindByItsOwnMotionOnly, ()) {
  const auto t = *epoch_of_span();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d seen = the_moon().line_of_sight(t, moving(zero, zero), apparent).coordinates();
  const auto left = t - (seen.norm() / light) * si::second;
  const Eigen::Vector3d there = moon_by_erfa(left).r.normalized();
  constexpr double second_order = 2e-8;  // rad
  RC_ASSERT((seen.normalized() - there).norm() < second_order);
  RC_ASSERT((seen.normalized() - moon_by_erfa(t).r.normalized()).norm() > 2e-6);
}

// Published: March equinox of 2022 at 15:33 UTC, December solstice at 21:48 UTC. At the equinox the apparent
// Sun is on the true equator of date. In half a minute it moves by 0.5 arcsec in declination; without
// aberration it would be 8 minutes late.
TEST(Ephemeris, TheApparentSunCrossesTheEquatorAtTheEquinox) {
  const auto declination = [&](const char* utc) {
    const auto t = Epoch::from_utc(utc);
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const auto line = the_sun().line_of_sight(t, moving(zero, zero), apparent);
    return std::asin(direction((true_of_date_from_gcrf(t).rotation * line).vector()).z().value());
  };
  EXPECT_LT(declination("2022-03-20T15:33:00"), 0.0);
  EXPECT_GT(declination("2022-03-20T15:34:00"), 0.0);
  EXPECT_LT(declination("2022-12-21T21:48:00"), declination("2022-12-21T12:00:00"));
  EXPECT_LT(declination("2022-12-21T21:48:00"), declination("2022-12-22T09:36:00"));
}

TEST(Ephemeris, AnswersInTheWordsOfAGraph) {
  const auto t = Epoch::from_utc("2022-04-14T10:22:11");
  const Eigen::Vector3d r(7e6, -1e6, 2e6);
  const Eigen::Vector3d v(1e3, 7e3, -5e2);
  const auto turning =
      moving_dcm(turned_z(to<Gcrf>, from<Satellite>, 0.7 * si::radian),
                 angular_velocity(of<Satellite>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Satellite>, Eigen::Vector3d(0, 0, 1e-3))));
  const auto state = moving(r, v);
  const auto graph = frame_graph(edge([&](const Epoch&) {
    return MovingTransform{turning, state.position, state.velocity};
  }));
  const auto now = graph.at(t);
  EXPECT_EQ(now.instant(), t);
  const auto agree = [&](const auto& body, auto correction) {
    const auto expected = inverse(turning.rotation) * body.line_of_sight(t, state, correction);
    const auto found = body.line_of_sight(now, seen_from<Satellite>, correction, in<Satellite>);
    static_assert(std::same_as<decltype(found), decltype(expected)>);
    EXPECT_LT((found.coordinates() - expected.coordinates()).norm(), 1e-15 * norm(expected).value());
    const auto n = body.direction(now, seen_from<Satellite>, correction, in<Satellite>);
    EXPECT_LT((n.coordinates() - found.coordinates().normalized()).norm(), 4e-16);
    const auto central = body.line_of_sight(now, seen_from<Gcrf>, correction, in<Gcrf>);
    const auto still = moving(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    EXPECT_EQ(central.coordinates(), body.line_of_sight(t, still, correction).coordinates());
  };
  agree(the_sun(), geometric);
  agree(the_sun(), light_time);
  agree(the_sun(), apparent);
  agree(the_moon(), apparent);
}

TEST(Ephemeris, RefusesEpochsOutsideTheSpan) {
  EXPECT_NO_THROW((void)the_sun().motion(span.start()));
  EXPECT_NO_THROW((void)the_moon().motion(span.end()));
  EXPECT_EQ(complaint([] { (void)the_moon().motion(Epoch::from_utc("2024-01-01T00:00:00")); }),
            "Ephemeris<Moon>: the epoch 2024-01-01T00:00:00.000000 UTC is outside the span, "
            "2021-12-19T23:58:50.816000 UTC to 2023-01-31T23:58:50.816000 UTC");
  const auto early = span.start() - 1e-6 * si::second;
  const Eigen::Vector3d r(7e6, 0, 0);
  EXPECT_THROW((void)the_sun().motion(early), BadInput);
  EXPECT_THROW((void)the_sun().line_of_sight(early, at(r), geometric), BadInput);
  EXPECT_THROW((void)the_sun().line_of_sight(early, at(r), light_time), BadInput);
  EXPECT_THROW((void)the_sun().line_of_sight(early, moving(r, r), apparent), BadInput);
  EXPECT_NO_THROW((void)the_sun().line_of_sight(span.start(), moving(r, r), apparent));
}

TEST(Ephemeris, RefusesYearsThatTheSeriesDoesNotHave) {
  const auto late = Epoch::from_tt("2100-01-01T12:00:00");
  EXPECT_EQ(complaint([&] { (void)geocentric(of<Sun>, late); }),
            "geocentric(of<Sun>): the epoch 2100-01-01T12:00:00 TT is outside the years of the series, 1900 "
            "to 2099");
  EXPECT_THROW((void)geocentric(of<Moon>, Epoch::from_tt("1899-12-31T12:00:00")), BadInput);
  EXPECT_THROW(Ephemeris<Sun>(from_until(late - 3e5 * si::second, late)), BadInput);
  EXPECT_THROW(Ephemeris<Moon>(from_until(Epoch::from_tt("1890-01-01T00:00:00"), late)), BadInput);
}

TEST(Ephemeris, RefusesAnObserverFarAway) {
  const auto far = at(Eigen::Vector3d(0.0, 0.0, 1e12));
  EXPECT_TRUE(
      vectrix_test::contains(complaint([&] { (void)the_moon().line_of_sight(span.end(), far, light_time); }),
                             "Ephemeris<Moon>: the light takes 33"));
  EXPECT_NO_THROW((void)the_moon().line_of_sight(span.end(), far, geometric));
}

template <class... Given>
concept Sees = requires(const Ephemeris<Sun>& sun, const Given&... given) {
  { sun.line_of_sight(given...) } -> std::derived_from<detail::RelativeVector<Gcrf, si::length, double>>;
};
using Position = Displacement<Gcrf, Satellite, In<Gcrf>>;
static_assert(Sees<Epoch, Position, Geometric> && Sees<Epoch, PointMotion<Gcrf, Satellite, Gcrf>, Apparent>);
static_assert(!Sees<Epoch, Position>);                                            // no correction
static_assert(!Sees<Epoch, Position, Apparent>);                                  // no velocity
static_assert(!Sees<Epoch, Displacement<Satellite, Gcrf, In<Gcrf>>, Geometric>);  // the other way
static_assert(!Sees<Quantity<si::time>, Position, Geometric>);
// An image is another point than the body: its displacement adds to no other.
static_assert(!std::same_as<Seen<Sun, Apparent>, Seen<Sun, LightTime>>);
static_assert(std::same_as<Seen<Sun, Geometric>, Sun>);

}  // namespace
}  // namespace vectrix::ephemeris_test
