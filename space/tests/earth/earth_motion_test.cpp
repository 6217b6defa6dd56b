#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/space/earth/earth_motion.hpp>

#include "temporary_file.hpp"

namespace vectrix::earth_motion_test {
namespace {

using earth::Gcrf, earth::Itrf;
using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double microarcsecond = 4.84813681109536e-12;  // rad
// The quintics are off by 0.1 microarcsec in X and Y, with what remains of the nutation of some days. A row
// is half a minute after the end of a piece, where the third derivative jumps.
constexpr double rotation_error = 0.3 * microarcsecond;
constexpr double rate_error = 1e-16;          // rad/s: 2e-16 of 14 days' nutation h^2/6, and the quintics
constexpr double acceleration_error = 2e-19;  // rad/s^2

const std::filesystem::path source{VECTRIX_SOURCE_DIR};

TimeSpan rows_of(const EarthOrientation& orientation) {
  return from_until(orientation.first(), orientation.last());
}
// One for each file, when a test asks for it: building takes longer than asking.
const EarthOrientation& april_2022() {
  static const auto rows = EarthOrientation::read(source / "examples/data/finals2000A_april_2022.txt");
  return rows;
}
const EarthOrientation& leap_second() {
  static const auto rows =
      EarthOrientation::read(source / "space/tests/data/finals2000A_leap_second_2016.txt");
  return rows;
}
const EarthMotion& motion_2022() {
  static const EarthMotion earth(april_2022(), rows_of(april_2022()));
  return earth;
}
const EarthMotion& motion_2016() {
  static const EarthMotion earth(leap_second(), rows_of(leap_second()));
  return earth;
}
const EarthMotion& with_tides() {
  static const EarthMotion earth(april_2022(), rows_of(april_2022()), subdaily_tides);
  return earth;
}

double any_part() {
  return *rc::gen::inRange(0, 1'000'000'001) * 1e-9;
}
Epoch any_epoch(const TimeSpan& span) {
  return span.start() + any_part() * (span.end() - span.start());
}

// The angle from one matrix to the other, small.
double apart(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).norm() / std::sqrt(2.0);
}
template <class A, class B> double distance(const A& a, const B& b) {
  return (a.coordinates() - b.coordinates()).norm();
}

// Against R and w of `exact` at t, and the derivative of its w over two minutes.
template <class Exact> void follows(const EarthMotion& earth, Exact exact, const Epoch& t) {
  const auto found = earth.at(t);
  const MovingDcm<Gcrf, Itrf> expected = exact(t);
  RC_ASSERT(apart(found.rotation.matrix(), expected.rotation.matrix()) <= rotation_error);
  RC_ASSERT(distance(found.angular_velocity, expected.angular_velocity) <= rate_error);
  constexpr double rounding = 5e-15;  // of the angle of a day, 6 to 12 rad, summed in another order
  RC_ASSERT(apart(earth.rotation(t).matrix(), found.rotation.matrix()) <= rounding);
  const auto h = 60.0 * si::second;
  if (!earth.span().contains(t - h) || !earth.span().contains(t + h)) return;
  const Vector3d change =
      exact(t + h).angular_velocity.coordinates() - exact(t - h).angular_velocity.coordinates();
  RC_ASSERT((change / (2.0 * h.value()) - found.angular_acceleration.coordinates()).norm() <=
            acceleration_error);
}

RC_GTEST_PROP(EarthMotion, FollowsTheExactRotation, ()) {
  follows(
      motion_2022(), [](const Epoch& t) { return april_2022().at(t); }, any_epoch(motion_2022().span()));
  follows(
      motion_2016(), [](const Epoch& t) { return leap_second().at(t); }, any_epoch(motion_2016().span()));
}

RC_GTEST_PROP(EarthMotion, FollowsTheExactRotationWithTides, ()) {
  const auto exact = [](const Epoch& t) {
    return earth_rotation(t, april_2022().parameters(t, subdaily_tides));
  };
  follows(with_tides(), exact, any_epoch(with_tides().span()));
}

// The rotation in TEME against that of the parameters, which is GMST82 and polar motion.
template <class Parameters> void follows_in_teme(const EarthMotion& earth, Parameters parameters) {
  const Epoch t = any_epoch(earth.span());
  const auto exact = [&](const Epoch& epoch) { return teme_from_itrf(epoch, parameters(epoch)); };
  const auto found = teme_from_itrf(t, earth);
  RC_ASSERT(apart(found.rotation.matrix(), exact(t).rotation.matrix()) <= rotation_error);
  RC_ASSERT(distance(found.angular_velocity, exact(t).angular_velocity) <= rate_error);
  const auto h = 60.0 * si::second;
  if (!earth.span().contains(t - h) || !earth.span().contains(t + h)) return;
  const Vector3d change =
      exact(t + h).angular_velocity.coordinates() - exact(t - h).angular_velocity.coordinates();
  RC_ASSERT((change / (2.0 * h.value()) - found.angular_acceleration.coordinates()).norm() <=
            acceleration_error);
}
RC_GTEST_PROP(EarthMotion, FollowsTheExactRotationInTeme, ()) {
  follows_in_teme(motion_2022(), [](const Epoch& t) { return april_2022().parameters(t); });
  follows_in_teme(motion_2016(), [](const Epoch& t) { return leap_second().parameters(t); });
  follows_in_teme(with_tides(), [](const Epoch& t) { return april_2022().parameters(t, subdaily_tides); });
}

// X, Y and s of the years with data, a day at a time.
RC_GTEST_PROP(EarthMotion, FollowsTheExactRotationInAllYears, ()) {
  const auto all = from_until(Epoch::from_utc("1973-01-02T00:00:00"), Epoch::from_utc("2026-11-01T00:00:00"));
  const auto start = any_epoch(all);
  const auto span = from_until(start, 86400.0 * si::second);
  const auto orientation = EarthOrientation::unobserved(span, 0.0 * si::second);
  follows(
      EarthMotion(orientation, span), [&](const Epoch& t) { return orientation.at(t); }, any_epoch(span));
}

// d/dt R_i^g = R_i^g [w_gi^i]x and dw/dt = alpha, of one polynomial: the rounding of the angle in it is 2e-15
// rad. With tides there are 16 a day; where two days join, the angle jumps by the rounding of eraEra00.
RC_GTEST_PROP(EarthMotion, RatesAreTheDerivativesOfItsOwnRotation, ()) {
  const auto h = 30.0 * si::second;
  const bool tides = *rc::gen::arbitrary<bool>();
  const auto& earth = tides ? with_tides() : motion_2022();
  const auto midnight = Epoch::from_modified_julian_date(scale::tai, 59681.0 + *rc::gen::inRange(0, 5));
  const auto piece = midnight + *rc::gen::inRange(0, 16) * 5400.0 * si::second;
  const auto t = any_epoch(from_until(piece + h, piece + 5400.0 * si::second - h));
  const auto before = earth.at(t - h), now = earth.at(t), after = earth.at(t + h);
  const Matrix3d turn = before.rotation.matrix().transpose() * after.rotation.matrix();
  const Vector3d twice_sine(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double sine = 0.5 * twice_sine.norm();
  const Vector3d w = std::asin(sine) / sine * twice_sine / (4.0 * h.value());
  constexpr double of_w = 1e-14 / 60.0;  // rad/s: of two rotations, over the minute
  RC_ASSERT((w - now.angular_velocity.coordinates()).norm() <= of_w);
  const Vector3d alpha =
      (after.angular_velocity.coordinates() - before.angular_velocity.coordinates()) / (2.0 * h.value());
  // A unit of the last place of w, 1.4e-20 rad/s.
  RC_ASSERT((alpha - now.angular_acceleration.coordinates()).norm() <= 2e-20);
}

TEST(EarthMotion, DoesNotDependOnTheSpan) {
  const auto t = Epoch::from_utc("2022-04-14T10:22:11.874999");
  const auto short_span = from_until(t - 100.0 * si::second, 200.0 * si::second);
  const auto agree = [&](const EarthMotion& long_one, const EarthMotion& short_one) {
    const auto a = long_one.at(t), b = short_one.at(t);
    EXPECT_EQ(a.rotation.matrix(), b.rotation.matrix());
    EXPECT_EQ(a.angular_velocity.coordinates(), b.angular_velocity.coordinates());
    EXPECT_EQ(a.angular_acceleration.coordinates(), b.angular_acceleration.coordinates());
  };
  agree(motion_2022(), EarthMotion(april_2022(), short_span));
  agree(with_tides(), EarthMotion(april_2022(), from_until(t, t), subdaily_tides));
}

// At midnight TAI, where pieces join, and at the rows' ends: no jump but the Earth's turn.
TEST(EarthMotion, IsContinuousWherePiecesJoin) {
  const EarthMotion tides(leap_second(), rows_of(leap_second()), subdaily_tides);
  constexpr double moment = 1e-3;  // s
  for (const auto* earth : {&motion_2016(), &tides}) {
    for (const double hour : {0.0, 1.5, 12.0, 24.0}) {
      const auto join = Epoch::from_julian_date(scale::tai, 2457753.5, hour / 24.0);
      const auto before = earth->at(join - moment * si::second), after = earth->at(join);
      const Matrix3d turn = before.rotation.matrix().transpose() * after.rotation.matrix();
      EXPECT_NEAR(turn(1, 0), before.angular_velocity.coordinates().z() * moment, 3e-14) << hour;
      EXPECT_LE(distance(before.angular_velocity, after.angular_velocity), 1e-18) << hour;
      EXPECT_LE(distance(before.angular_acceleration, after.angular_acceleration), 1e-20) << hour;
    }
  }
}

TEST(EarthMotion, IsAnEdgeOfAGraph) {
  const auto& earth = motion_2022();
  const auto graph = frame_graph(edge(earth), edge(teme(earth)));
  const auto t = Epoch::from_utc("2022-04-14T10:22:11");
  const auto now = graph.at(t);
  EXPECT_EQ(now.rotation(to<Gcrf>, from<Itrf>).matrix(), earth.at(t).rotation.matrix());
  EXPECT_EQ(now.angular_acceleration(of<Itrf>, relative_to<Gcrf>, in<Itrf>).coordinates(),
            earth.at(t).angular_acceleration.coordinates());
  const auto in_teme = teme_from_itrf(t, earth);
  EXPECT_EQ(now.rotation(to<earth::Teme>, from<Itrf>).matrix(), in_teme.rotation.matrix());
  EXPECT_EQ(now.angular_acceleration(of<Itrf>, relative_to<earth::Teme>, in<Itrf>).coordinates(),
            in_teme.angular_acceleration.coordinates());
  EXPECT_EQ(now.position(of<Itrf>, relative_to<Gcrf>, in<Itrf>).coordinates(), Vector3d::Zero());
}

TEST(EarthMotion, RefusesSpansOutsideTheRowsAndEpochsOutsideTheSpan) {
  const auto rows = rows_of(april_2022());
  const auto second = 1.0 * si::second;
  EXPECT_EQ(complaint([&] { EarthMotion(april_2022(), from_until(rows.start(), rows.end() + second)); }),
            "EarthOrientation: the epoch 2022-04-17T00:00:01.000000 UTC is outside the data, which span "
            "2022-04-11T00:00:00.000000 UTC to 2022-04-17T00:00:00.000000 UTC");
  EXPECT_THROW(EarthMotion(april_2022(), from_until(rows.start() - second, rows.end())), BadInput);
  const EarthMotion earth(april_2022(), from_until(rows.start() + second, rows.end() - second));
  EXPECT_NO_THROW((void)earth.at(rows.start() + second));
  EXPECT_NO_THROW((void)earth.rotation(rows.end() - second));
  EXPECT_EQ(complaint([&] { (void)earth.at(rows.end()); }),
            "EarthMotion: the epoch 2022-04-17T00:00:00.000000 UTC is outside the span, "
            "2022-04-11T00:00:01.000000 UTC to 2022-04-16T23:59:59.000000 UTC");
  EXPECT_THROW((void)earth.rotation(rows.start()), BadInput);
  EXPECT_EQ(complaint([&] { (void)earth.at(rows.end() - 0.999999999 * second); }),
            "EarthMotion: the epoch 2022-04-16T23:59:59.000000 UTC is less than 1e-6 s outside the span, "
            "2022-04-11T00:00:01.000000 UTC to 2022-04-16T23:59:59.000000 UTC");
}

// 0 for a UT1-UTC that is not known crosses a leap second.
TEST(EarthMotion, UnobservedMayCrossALeapSecond) {
  const auto year =
      from_until(Epoch::from_utc("2016-07-01T00:00:00"), Epoch::from_utc("2017-07-01T00:00:00"));
  const auto orientation = EarthOrientation::unobserved(year, 0.0 * si::second);
  EXPECT_NO_THROW((void)orientation.at(year.end()));
  EXPECT_NO_THROW(EarthMotion(orientation, year));
  // More of them are for EarthMotion alone.
  const auto years =
      from_until(Epoch::from_utc("2008-07-01T00:00:00"), Epoch::from_utc("2012-08-01T00:00:00"));
  const auto held = EarthOrientation::unobserved(years, 0.0 * si::second);
  EXPECT_THROW((void)held.at(years.end()), BadInput);
  EXPECT_NO_THROW(EarthMotion(held, from_until(years.end() - 10.0 * si::second, years.end())));
}

// Constant UT1-TAI over years of leap seconds: UT1-UTC is then more than it can be.
TEST(EarthMotion, RefusesUt1ThatIsSecondsOff) {
  const auto span =
      from_until(Epoch::from_utc("1972-07-02T00:00:00"), Epoch::from_utc("1978-02-01T00:00:00"));
  const auto orientation = EarthOrientation::unobserved(span, 0.3 * si::second);
  const std::string expected = "(UTC keeps it below 0.9 s";
  for (const auto& said : {complaint([&] { (void)orientation.at(span.end()); }),
                           complaint([&] { EarthMotion(orientation, span); })}) {
    EXPECT_NE(said.find(expected), std::string::npos) << said;
  }
}

// ORTHO_EOP of the IERS Conventions Center: the results that it states for the modified Julian date 47100.
TEST(SubdailyTides, HaveThePublishedValues) {
  const auto span =
      from_until(Epoch::from_utc("1987-11-01T00:00:00"), Epoch::from_utc("1987-11-03T00:00:00"));
  const auto orientation = EarthOrientation::unobserved(span, 0.0 * si::second);
  const auto ut1 = scale::Ut1::minus_tai(orientation.parameters(span.start()).ut1_minus_tai);
  const auto t = Epoch::from_modified_julian_date(ut1, 47100.0);
  const auto with = orientation.parameters(t, subdaily_tides), without = orientation.parameters(t);
  // The date is rounded to 1e-11 s; UT1-TAI, which the tide is added to, to 7e-15 s.
  constexpr double angle = 1e-6, time = 1e-8;  // microarcsec, microseconds
  EXPECT_NEAR((with.pole_x - without.pole_x).value() / microarcsecond, -162.8386373279636530, angle);
  EXPECT_NEAR((with.pole_y - without.pole_y).value() / microarcsecond, 117.7907525842668974, angle);
  EXPECT_NEAR((with.ut1_minus_tai - without.ut1_minus_tai).value() * 1e6, -23.39092370609808214, time);
  EXPECT_EQ(with.dX, without.dX);
}

RC_GTEST_PROP(SubdailyTides, RatesAreTheDerivativesAndAllIsSmall, ()) {
  const auto t = any_epoch(from_until(april_2022().first() + 60.0 * si::second, 5.9 * 86400.0 * si::second));
  const double h = 10.0;  // s
  const auto tide = [&](double later, auto member) {
    const auto at = t + later * si::second;
    return (april_2022().parameters(at, subdaily_tides).*member - april_2022().parameters(at).*member)
        .value();
  };
  const auto slope = [&](auto member) { return (tide(h, member) - tide(-h, member)) / (2.0 * h); };
  using P = EarthOrientationParameters;
  // w^3 h^2 / 6 of the half-daily tide, w = 1.4e-4 rad/s, 1e-9 rad and 1e-4 s; and rounding.
  constexpr double angle_rate = 2e-19, time_rate = 1e-14;
  RC_ASSERT(std::abs(slope(&P::pole_x) - tide(0.0, &P::pole_x_rate)) <= angle_rate);
  RC_ASSERT(std::abs(slope(&P::pole_y) - tide(0.0, &P::pole_y_rate)) <= angle_rate);
  RC_ASSERT(std::abs(slope(&P::ut1_minus_tai) - tide(0.0, &P::ut1_gain)) <= time_rate);
  RC_ASSERT(std::abs(tide(0.0, &P::pole_x)) <= 1000.0 * microarcsecond);
  RC_ASSERT(std::abs(tide(0.0, &P::pole_y)) <= 1000.0 * microarcsecond);
  RC_ASSERT(std::abs(tide(0.0, &P::ut1_minus_tai)) <= 100e-6);
}

}  // namespace
}  // namespace vectrix::earth_motion_test
