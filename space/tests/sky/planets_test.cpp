#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <vectrix/space/sky/ephemeris.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::planets_test {
namespace {

using earth::Gcrf;

struct Satellite : moving_frame {};

constexpr double light = 299792458.0;  // m/s
// What the header promises of the pieces, and of eraPlan94's own velocities.
constexpr double piece_error = 1.0;      // m
constexpr double earth_error = 10.0;     // m: of the Earth relative to the barycentre
constexpr double velocity_error = 40.0;  // m/s
// A difference of positions over 2 minutes: the rounding of 5e12 m, 1e-3 m, over 120 s; and at the join of
// two pieces, where the velocity jumps.
constexpr double join_error = 3e-4;  // m/s

const auto span = from_until(Epoch::from_tt("2003-07-01T00:00:00"), Epoch::from_tt("2004-01-01T00:00:00"));

template <class B, int erfas_number> struct Planet {
  using Point = B;
  static constexpr int number = erfas_number;
};
using Planets = ::testing::Types<Planet<sky::Mercury, 1>, Planet<sky::Venus, 2>, Planet<sky::Mars, 4>,
                                 Planet<sky::Jupiter, 5>, Planet<sky::Saturn, 6>, Planet<sky::Uranus, 7>,
                                 Planet<sky::Neptune, 8>>;

Eigen::Vector3d column(const double (&x)[3]) {
  return {x[0], x[1], x[2]};
}

// By ERFA's own numbers, m and m/s: the planet relative to the Earth, and the Earth relative to the
// barycentre.
struct ByErfa {
  Eigen::Vector3d r, v, r_earth, v_earth;
};
ByErfa by_erfa(int number, const Epoch& t) {
  const auto tt = t.tt_date();
  double planet[2][3];
  double heliocentric[2][3];
  double barycentric[2][3];
  double bias[3][3];
  double precession[3][3];
  double both[3][3];
  EXPECT_EQ(eraPlan94(tt.day, tt.fraction, number, planet), 0);
  eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
  eraBp06(tt.day, tt.fraction, bias, precession, both);
  for (auto& row : planet) eraTrxp(bias, row, row);
  const double speed = ERFA_DAU / ERFA_DAYSEC;
  return {ERFA_DAU * (column(planet[0]) - column(heliocentric[0])),
          speed * (column(planet[1]) - column(heliocentric[1])), ERFA_DAU * column(barycentric[0]),
          speed * column(barycentric[1])};
}

std::vector<Epoch> epochs() {
  std::vector<Epoch> result;
  for (const Epoch& t : every(0.0371 * (span.end() - span.start()), span)) result.push_back(t);
  return result;
}

template <class P> struct OfAPlanet : ::testing::Test {};
TYPED_TEST_SUITE(OfAPlanet, Planets);

TYPED_TEST(OfAPlanet, GeocentricIsErfas) {
  constexpr double rounding = 1e-15;  // a rotation is three products, each of 2e-16
  for (const Epoch& t : epochs()) {
    const auto found = geocentric(of<typename TypeParam::Point>, t);
    const auto expected = by_erfa(TypeParam::number, t);
    // The terms of the difference are the largest: both are relative to the Sun.
    const double r = expected.r.norm() + ERFA_DAU, v = 1e5;
    EXPECT_LT((found.position.coordinates() - expected.r).norm(), rounding * r);
    EXPECT_LT((found.velocity.coordinates() - expected.v).norm(), rounding * v);
  }
}

TYPED_TEST(OfAPlanet, FollowsTheSeriesOverASpan) {
  const Ephemeris<typename TypeParam::Point> planet(span);
  const auto h = 60.0 * si::second;
  for (const Epoch& t : epochs()) {
    const auto found = planet.motion(t);
    const auto expected = by_erfa(TypeParam::number, t);
    EXPECT_LT((found.position.coordinates() - expected.r).norm(), piece_error);
    EXPECT_LT((found.velocity.coordinates() - expected.v).norm(), velocity_error);
    if (!span.contains(t - h) || !span.contains(t + h)) continue;
    const Eigen::Vector3d moved =
        planet.motion(t + h).position.coordinates() - planet.motion(t - h).position.coordinates();
    EXPECT_LT((moved / (2.0 * h.value()) - found.velocity.coordinates()).norm(), join_error);
  }
}

// The errors are the largest near perihelion, and the velocities differ in some years more than in others.
TYPED_TEST(OfAPlanet, FollowsTheSeriesInAllYears) {
  for (int year = 1900; year < 2100; year += 10) {
    const auto t =
        Epoch::from_tt(std::to_string(year) + "-01-01T00:00:00") + 6.3e5 * (year % 49) * si::second;
    const auto found = Ephemeris<typename TypeParam::Point>(from_until(t, t)).motion(t);
    const auto expected = by_erfa(TypeParam::number, t);
    EXPECT_LT((found.position.coordinates() - expected.r).norm(), piece_error) << t;
    EXPECT_LT((found.velocity.coordinates() - expected.v).norm(), velocity_error) << t;
  }
}

// |r_planet(t - d/c) - r_observer(t)| = d, relative to the barycentre; then the aberration by the motion of
// the observer, which eraAb gives with the potential of the Sun, 3e-12 rad.
TYPED_TEST(OfAPlanet, LightTimeAndAberrationObeyTheirLaws) {
  constexpr double rounding = 4e-16, potential_of_the_sun = 3e-12;  // rad
  const Ephemeris<typename TypeParam::Point> planet(span);
  const Eigen::Vector3d r(4e7, -1e7, 2e7), v(-1e3, 3e3, 5e2);
  const auto state = point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                                  vector<si::length>(in<Gcrf>, r), vector<si::velocity>(in<Gcrf>, v));
  for (const Epoch& t : epochs()) {
    const Eigen::Vector3d d = planet.line_of_sight(t, state, light_time).coordinates();
    const auto now = by_erfa(TypeParam::number, t);
    const auto then = by_erfa(TypeParam::number, t - (d.norm() / light) * si::second);
    EXPECT_LT((d - (then.r_earth + then.r - now.r_earth - r)).norm(),
              piece_error + earth_error + rounding * d.norm());
    const Eigen::Vector3d seen = planet.line_of_sight(t, state, apparent).coordinates();
    Eigen::Vector3d natural = d.normalized();
    Eigen::Vector3d velocity = (now.v_earth + v) / light;
    Eigen::Vector3d expected;
    eraAb(natural.data(), velocity.data(), 1.0, std::sqrt(1.0 - velocity.squaredNorm()), expected.data());
    constexpr double slow_join = 2.0 * join_error / light;
    EXPECT_LT((seen.normalized() - expected).norm(), 3.0 * potential_of_the_sun + slow_join);
    EXPECT_EQ(planet.line_of_sight(t, state.position, geometric).coordinates(),
              planet.motion(t).position.coordinates() - r);
  }
}

double angle(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}
template <class B> Eigen::Vector3d seen_from_the_earth(const Epoch& t) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const auto state = point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                                  vector<si::length>(in<Gcrf>, zero), vector<si::velocity>(in<Gcrf>, zero));
  return Ephemeris<B>(from_until(t, t)).line_of_sight(t, state, apparent).coordinates();
}
constexpr double arcsec = ERFA_DAS2R;

// Published: Mars on 2003 August 27, 9:51 UTC, 55,758,006 km away, the least in 60,000 years. The series has
// an error of 7690 km in three coordinates (rms).
TEST(Planets, MarsIsNearIn2003) {
  const auto distance = [](double days) {
    const auto t = Epoch::from_utc("2003-08-27T09:51:00") + days * 86400.0 * si::second;
    return norm(geocentric(of<sky::Mars>, t).position).value();
  };
  EXPECT_NEAR(distance(0.0), 55758006e3, 7690e3);
  EXPECT_GT(distance(-0.5), distance(0.0));
  EXPECT_GT(distance(0.5), distance(0.0));
}

// Published (NASA): the transit of Venus of 2012, least distance of the centres 554.4 arcsec at 01:29:36 UT.
// Venus' own error, 5 arcsec, is 2.5 times as large from the Earth, where Venus is 0.29 au away.
TEST(Planets, VenusCrossesTheSunIn2012) {
  const auto apart = [](double minutes) {
    const auto t = Epoch::from_utc("2012-06-06T01:29:36") + minutes * 60.0 * si::second;
    return angle(seen_from_the_earth<sky::Venus>(t), seen_from_the_earth<sky::Sun>(t)) / arcsec;
  };
  EXPECT_NEAR(apart(0.0), 554.4, 2.5 * 5.0);
  EXPECT_GT(apart(-20.0), apart(0.0));
  EXPECT_GT(apart(20.0), apart(0.0));
}

// Published: the great conjunction of 2020 December 21, 18:20 UTC, 6.1 arcmin. The errors of the two are 71
// and 81 arcsec in longitude, 5 and 13 across, where this conjunction is.
TEST(Planets, JupiterMeetsSaturnIn2020) {
  const auto t = Epoch::from_utc("2020-12-21T18:20:00");
  const double apart = angle(seen_from_the_earth<sky::Jupiter>(t), seen_from_the_earth<sky::Saturn>(t));
  EXPECT_NEAR(apart / arcsec, 6.1 * 60.0, 18.0 + 3.0);
}

TEST(Planets, RefusesWhatIsTooFarOrTooLate) {
  const Ephemeris<sky::Neptune> neptune(from_until(span.start(), span.start()));
  const auto at = [](double z) {
    return displacement(of<Satellite>, relative_to<Gcrf>,
                        vector<si::length>(in<Gcrf>, Eigen::Vector3d(0.0, 0.0, z)));
  };
  EXPECT_NO_THROW((void)neptune.line_of_sight(span.start(), at(1e11), light_time));
  EXPECT_TRUE(vectrix_test::contains(
      complaint([&] { (void)neptune.line_of_sight(span.start(), at(1e13), light_time); }),
      "Ephemeris<Neptune>: the light takes 40126"));
  EXPECT_TRUE(vectrix_test::contains(complaint([&] { (void)neptune.motion(span.end()); }),
                                     "Ephemeris<Neptune>: the epoch 2003-12-31T23:58:55.816000 UTC is "
                                     "outside the span"));
  EXPECT_TRUE(vectrix_test::contains(
      complaint([] { (void)geocentric(of<sky::Uranus>, Epoch::from_tt("2100-01-01T12:00:00")); }),
      "geocentric(of<Uranus>): the epoch 2100-01-01T12:00:00 TT is outside"));
}

// The Earth is no planet of the sky: it is where the others are seen from.
static_assert(SkyBody<sky::Mars> && SkyBody<sky::Sun> && !SkyBody<Gcrf> && !SkyBody<Satellite>);

}  // namespace
}  // namespace vectrix::planets_test
