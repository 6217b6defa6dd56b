#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>
#include <vectrix/space/earth/teme.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "earth/any_epoch.hpp"
#include "temporary_file.hpp"

namespace vectrix::earth_orientation_test {
namespace {

using earth_test::largest;

const std::filesystem::path source{VECTRIX_SOURCE_DIR};
const auto april_2022 = source / "examples/data/finals2000A_april_2022.txt";
const auto leap_second_2016 = source / "space/tests/data/finals2000A_leap_second_2016.txt";

// Per element, against matrices of the same models from another program.
constexpr double model_tolerance = 1e-12;
// X and Y from their own series, or from the matrix of precession and nutation: they differ by 7e-12 at these
// epochs.
constexpr double difference_of_series = 1e-11;
// The Julian dates of the reference are rounded to 1e-16 day.
constexpr double date_rounding = 3e-16;
constexpr double arcsecond = 4.84813681109536e-6;  // rad
constexpr double parameter_rounding = 1e-15;       // of numbers up to 1
// eraEra00 is rounded at 22 turns, in 2022: to 2e-14 rad at both ends of two minutes.
constexpr double difference_error = 1e-15;  // rad/s

Eigen::Matrix3d matrix(const CsvTable& table, std::size_t row, const std::string& letter) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = table.number(row, letter + std::to_string(i + 1) + std::to_string(j + 1));
    }
  }
  return result;
}

TEST(EarthRotation, AgreesWithTwentyReferenceMatrices) {
  const auto table = CsvTable::read(source / "space/tests/data/gcrs_to_itrs_20_epochs.csv", {});
  ASSERT_EQ(table.rows(), 20U);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto number = [&](const char* column) { return table.number(i, column); };
    const auto angle = [&](double arcseconds) { return convert<si::angle>(arcseconds * si::arcsecond); };
    const auto epoch = Epoch::from_utc_mjd(static_cast<int>(number("mjd_utc_int")), number("frac_day_utc"));
    EXPECT_EQ(epoch.tt_date().day, number("tt_jd1"));
    EXPECT_NEAR(epoch.tt_date().fraction, number("tt_jd2"), date_rounding);

    EarthOrientationParameters observed{angle(number("xp_arcsec")),
                                        angle(number("yp_arcsec")),
                                        number("dut1_s") * si::second - epoch.tai_minus_utc(),
                                        Quantity<si::dimensionless>{0.0},
                                        angle(1e-3 * number("dX_mas")),
                                        angle(1e-3 * number("dY_mas"))};
    const auto with_offsets = inverse(earth_rotation(epoch, observed).rotation);
    EXPECT_LT(largest(with_offsets.matrix() - matrix(table, i, "C")), model_tolerance) << "row " << i;

    const auto true_of_date = true_of_date_from_gcrf(epoch).rotation;
    EXPECT_LT(largest(true_of_date.matrix() - matrix(table, i, "B")), model_tolerance) << "row " << i;
    const auto by_the_equinox = itrf_from_true_of_date(epoch, observed).rotation * true_of_date;
    EXPECT_LT(largest(by_the_equinox.matrix() - matrix(table, i, "N")), model_tolerance) << "row " << i;

    observed.dX = observed.dY = 0.0 * si::radian;
    const auto without_offsets = inverse(earth_rotation(epoch, observed).rotation);
    EXPECT_LT(largest(without_offsets.matrix() - by_the_equinox.matrix()), difference_of_series)
        << "row " << i;
  }
}

TEST(EarthOrientation, HasTheRowsOfTheSeries) {
  const auto orientation = EarthOrientation::read(april_2022);
  EXPECT_EQ(orientation.first().utc(0), "2022-04-11T00:00:00");
  EXPECT_EQ(orientation.last().utc(0), "2022-04-17T00:00:00");
  const auto row = orientation.parameters(Epoch::from_utc("2022-04-14T00:00:00"));
  EXPECT_NEAR(row.pole_x.value(), 0.056532 * arcsecond, parameter_rounding);
  EXPECT_NEAR(row.pole_y.value(), 0.452863 * arcsecond, parameter_rounding);
  EXPECT_NEAR(row.ut1_minus_tai.value(), -0.0965616 - 37.0, 37.0 * parameter_rounding);
  EXPECT_NEAR(row.dX.value(), 0.328e-3 * arcsecond, parameter_rounding);
  EXPECT_NEAR(row.dY.value(), -0.128e-3 * arcsecond, parameter_rounding);
}

// At a row from both sides: value, rate and, by the rate's difference, the second derivative. The third one
// jumps, except at the second row and the last but one.
TEST(EarthOrientation, IsASplineThroughTheRows) {
  const auto orientation = EarthOrientation::read(april_2022);
  const auto around = [&](const Epoch& row, auto value) {
    const auto at = [&](double seconds) { return value(orientation.parameters(row + seconds * si::second)); };
    constexpr double h = 7200.0;  // s
    const double before = at(-2 * h) - 2 * at(-h) + at(0.0), after = at(0.0) - 2 * at(h) + at(2 * h);
    const double far_before = at(-h) - 2 * at(-2 * h) + at(-3 * h),
                 far_after = at(h) - 2 * at(2 * h) + at(3 * h);
    struct {
      double second, third;  // the jumps, times h^2 and h^3
    } const jump{(2 * after - far_after) - (2 * before - far_before),
                 (far_after - after) - (before - far_before)};
    return jump;
  };
  const auto x_rate = [](const EarthOrientationParameters& p) { return p.pole_x.value(); };
  const auto ut1 = [](const EarthOrientationParameters& p) { return p.ut1_minus_tai.value(); };
  const auto row = [&](int i) { return orientation.first() + 86400.0 * i * si::second; };
  // Second differences of cubics are linear in time, so that these jumps are exact up to rounding.
  constexpr double angle_rounding = 1e-20, time_rounding = 2e-13;
  for (int i = 1; i < 6; ++i) {
    EXPECT_NEAR(around(row(i), x_rate).second, 0.0, angle_rounding) << i;
    EXPECT_NEAR(around(row(i), ut1).second, 0.0, time_rounding) << i;
  }
  for (const int i : {1, 5}) EXPECT_NEAR(around(row(i), x_rate).third, 0.0, angle_rounding) << i;
  EXPECT_GT(std::abs(around(row(3), x_rate).third), 100.0 * angle_rounding);
}

// The rates are those of the curves.
TEST(EarthOrientation, RatesOfParametersAreTheirDerivatives) {
  const auto orientation = EarthOrientation::read(april_2022);
  const double h = 1.0;  // s: differences of cubics, whose third derivative times h^2/6 is 1e-25 rad/s
  for (int hour = 1; hour < 144; hour += 7) {
    const auto t = orientation.first() + 3600.0 * hour * si::second;
    const auto before = orientation.parameters(t - h * si::second),
               after = orientation.parameters(t + h * si::second), now = orientation.parameters(t);
    const auto slope = [&](auto member) { return (after.*member - before.*member).value() / (2.0 * h); };
    using P = EarthOrientationParameters;
    constexpr double angle_rounding = 1e-21, time_rounding = 1e-14;
    EXPECT_NEAR(slope(&P::pole_x), now.pole_x_rate.value(), angle_rounding);
    EXPECT_NEAR(slope(&P::pole_y), now.pole_y_rate.value(), angle_rounding);
    EXPECT_NEAR(slope(&P::dX), now.dX_rate.value(), angle_rounding);
    EXPECT_NEAR(slope(&P::dY), now.dY_rate.value(), angle_rounding);
    EXPECT_NEAR(slope(&P::ut1_minus_tai), now.ut1_gain.value(), time_rounding);
  }
}

TEST(EarthOrientation, IsContinuousOverALeapSecond) {
  const auto orientation = EarthOrientation::read(leap_second_2016);
  const auto ut1_minus_tai = [&](const char* utc) {
    return orientation.parameters(Epoch::from_utc(utc)).ut1_minus_tai.value();
  };
  const double before = -0.4077601 - 36.0;
  const double after = 0.5912821 - 37.0;
  EXPECT_NEAR(ut1_minus_tai("2016-12-31T00:00:00"), before, 37.0 * parameter_rounding);
  EXPECT_NEAR(ut1_minus_tai("2017-01-01T00:00:00"), after, 37.0 * parameter_rounding);
  // In the last second of the day the spline differs from the chord by 1 s times the difference of slopes.
  const double straight = before + (after - before) * 86400.0 / 86401.0;
  EXPECT_NEAR(ut1_minus_tai("2016-12-31T23:59:60"), straight, 2e-8);
  // After one more second, the Earth has turned by the angle of one second.
  const auto at = [&](const char* utc) { return orientation.at(Epoch::from_utc(utc)).rotation; };
  const Eigen::Matrix3d turn =
      at("2016-12-31T23:59:60").matrix().transpose() * at("2017-01-01T00:00:00").matrix();
  EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), 7.2921150e-5, 1e-11);
}

// d/dt R_i^g = R_i^g [w_gi^i]x: the rotation over two minutes, against the rate at the middle.
TEST(EarthOrientation, RateIsTheDerivativeOfTheRotation) {
  const double h = 60.0;  // s
  double largest_difference = 0.0;
  for (const auto& [file, first_hour] :
       {std::pair{april_2022, "2022-04-11T01:00:00"}, std::pair{leap_second_2016, "2016-12-29T01:00:00"}}) {
    const auto orientation = EarthOrientation::read(file);
    for (int hour = 0; hour < 96; hour += 5) {
      const auto epoch = Epoch::from_utc(first_hour) + (3600.0 * hour) * si::second;
      const auto before = orientation.at(epoch - h * si::second).rotation;
      const auto after = orientation.at(epoch + h * si::second).rotation;
      // Itrf has the same type at both instants: the increment is taken as plain numbers.
      const auto turn =
          log(trust_dcm(to<earth::Gcrf>, from<earth::Itrf>, before.matrix().transpose() * after.matrix()));
      const auto w = orientation.at(epoch).angular_velocity.coordinates();
      largest_difference =
          vectrix::detail::larger(largest_difference, (turn.coordinates() / (2.0 * h) - w).norm());
    }
  }
  EXPECT_LT(largest_difference, difference_error);
}

// dERA/dUT1 = 2 pi 1.00273781191135448 / 86400 s, along the pole, which polar motion keeps near z. Its own
// motion, 8.4e-12 rad/s at most from 1982 to 2025, is across it.
TEST(EarthOrientation, RateFollowsTheLengthOfTheDay) {
  constexpr double motion_of_the_pole = 1e-11 / 7.292e-5;
  const auto orientation = EarthOrientation::read(april_2022);
  const auto epoch = Epoch::from_utc("2022-04-14T06:00:00");
  const auto parameters = orientation.parameters(epoch);
  const auto w = orientation.at(epoch).angular_velocity.coordinates();
  const double nominal = 2.0 * 3.14159265358979324 * 1.00273781191135448 / 86400.0;
  EXPECT_NEAR(w.norm() / nominal - 1.0, parameters.ut1_gain.value(), motion_of_the_pole * motion_of_the_pole);
  EXPECT_NEAR(w.x() / w.z(), parameters.pole_x.value(), motion_of_the_pole);
  EXPECT_NEAR(w.y() / w.z(), -parameters.pole_y.value(), motion_of_the_pole);
  EXPECT_GT(std::abs(w.x() / w.z() - parameters.pole_x.value()), 1e-2 * motion_of_the_pole);
}

TEST(EarthOrientation, IsAnEdgeOfAGraph) {
  const auto orientation = EarthOrientation::read(april_2022);
  const auto graph = frame_graph(edge(orientation), edge(teme(orientation)));
  const auto epoch = Epoch::from_utc("2022-04-14T10:22:11.874999");
  EXPECT_EQ(graph.at(epoch).rotation(to<earth::Gcrf>, from<earth::Itrf>).matrix(),
            orientation.at(epoch).rotation.matrix());
  const auto w = graph.at(epoch).angular_velocity(of<earth::Itrf>, relative_to<earth::Gcrf>, in<earth::Itrf>);
  EXPECT_EQ(w.coordinates(), orientation.at(epoch).angular_velocity.coordinates());
  EXPECT_EQ(graph.at(epoch).rotation(to<earth::Teme>, from<earth::Itrf>).matrix(),
            teme_from_itrf(epoch, orientation.parameters(epoch)).rotation.matrix());
  EXPECT_EQ(
      graph.at(epoch).position(of<earth::Teme>, relative_to<earth::Gcrf>, in<earth::Gcrf>).coordinates(),
      Eigen::Vector3d::Zero());
}

// Twenty rows of real data, 1973 to 2023: how far the Earth without data is off, in arcsec.
TEST(EarthOrientation, UnobservedIsOffByWhatItsDocumentationSays) {
  const auto table = CsvTable::read(source / "space/tests/data/gcrs_to_itrs_20_epochs.csv", {});
  constexpr double of_the_pole = 0.61, of_the_offsets = 0.01, of_the_day = 4.1e-3 * 15.05;  // arcsec
  constexpr double of_ut1 = 0.9 * 15.05;
  double with_ut1 = 0.0, without_ut1 = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto epoch = Epoch::from_utc_mjd(static_cast<int>(table.number(i, "mjd_utc_int")),
                                           table.number(i, "frac_day_utc"));
    // UT1-UTC is known a day before.
    const auto span = from_until(epoch - 86400.0 * si::second, epoch);
    const auto off = [&](const EarthOrientation& orientation) {
      const Eigen::Matrix3d turn = matrix(table, i, "C") * orientation.at(epoch).rotation.matrix();
      return std::asin((turn - turn.transpose()).norm() / std::sqrt(8.0)) / arcsecond;
    };
    using vectrix::detail::larger;
    with_ut1 =
        larger(with_ut1, off(EarthOrientation::unobserved(span, table.number(i, "dut1_s") * si::second)));
    without_ut1 = larger(without_ut1, off(EarthOrientation::unobserved(span, 0.0 * si::second)));
  }
  EXPECT_LT(with_ut1, of_the_pole + of_the_offsets + of_the_day);
  EXPECT_GT(with_ut1, 0.5 * of_the_pole);
  EXPECT_LT(without_ut1, of_ut1 + of_the_pole + of_the_offsets);
  EXPECT_GT(without_ut1, 0.5 * of_ut1);
}

TEST(EarthOrientation, UnobservedStandsStillOverALeapSecond) {
  const auto span =
      from_until(Epoch::from_utc("2016-12-31T12:00:00"), Epoch::from_utc("2017-01-01T12:00:00"));
  const auto orientation = EarthOrientation::unobserved(span, -0.4 * si::second);
  EXPECT_EQ(orientation.first(), span.start());
  EXPECT_EQ(orientation.last(), span.end());
  for (const Epoch& t : every(3600.0 * si::second, span)) {
    const auto p = orientation.parameters(t);
    EXPECT_NEAR(p.ut1_minus_tai.value(), -36.4, 37.0 * parameter_rounding);
    EXPECT_NEAR(p.ut1_gain.value(), 0.0, 37.0 * parameter_rounding / 3600.0);
    EXPECT_EQ(p.pole_x.value(), 0.0);
    EXPECT_EQ(p.dY_rate.value(), 0.0);
  }
}

TEST(EarthOrientation, UnobservedRefusesBadInput) {
  const auto start = Epoch::from_utc("2030-01-01T00:00:00");
  const auto day = from_until(start, 86400.0 * si::second);
  EXPECT_EQ(complaint([&] { (void)EarthOrientation::unobserved(day, -37.1 * si::second); }),
            "EarthOrientation::unobserved: UT1-UTC is -37.1 s; UTC keeps it within 0.9 s");
  EXPECT_THROW((void)EarthOrientation::unobserved(day, std::nan("") * si::second), BadInput);
  EXPECT_EQ(
      complaint([&] { (void)EarthOrientation::unobserved(from_until(start, start), 0.0 * si::second); }),
      "EarthOrientation::unobserved: the span at 2030-01-01T00:00:00.000000 UTC has no duration");
  EXPECT_EQ(complaint([&] {
              (void)EarthOrientation::unobserved(from_until(start, 4e9 * si::second), 0.0 * si::second);
            }),
            "EarthOrientation::unobserved: the span has 4e+09 s; at most 100 years are allowed");
  const auto early = from_until(Epoch::from_tt("1950-01-01T00:00:00"), 86400.0 * si::second);
  EXPECT_THROW((void)EarthOrientation::unobserved(early, 0.0 * si::second), BadInput);
  const auto orientation = EarthOrientation::unobserved(day, 0.0 * si::second);
  EXPECT_THROW((void)orientation.at(day.end() + 1.0 * si::second), BadInput);
}

TEST(EarthRotation, RefusesUt1MinusUtcForUt1MinusTai) {
  const auto epoch = Epoch::from_utc("2022-04-14T00:00:00");
  EarthOrientationParameters parameters = EarthOrientation::read(april_2022).parameters(epoch);
  EXPECT_NO_THROW((void)earth_rotation(epoch, parameters));
  parameters.ut1_minus_tai = -0.0965616 * si::second;
  const auto said = complaint([&] { (void)earth_rotation(epoch, parameters); });
  EXPECT_TRUE(
      said.starts_with("Earth orientation at 2022-04-14T00:00:00.000000 UTC: UT1-TAI is -0.0965616 s, so "
                       "UT1-UTC 36.9034384 s; it must be within "))
      << said;
  EXPECT_THROW((void)earth_rotation(epoch, EarthOrientationParameters{}), BadInput);
  EXPECT_THROW((void)itrf_from_true_of_date(epoch, parameters), BadInput);
}

// One second is 465 m on the equator.
TEST(EarthRotation, RefusesALeapSecondTooManyWhereAllAreKnown) {
  const auto epoch = Epoch::from_utc("2008-09-20T12:25:40.104192");
  EarthOrientationParameters parameters{};
  parameters.ut1_minus_tai = (-0.5 - 33.0) * si::second;
  EXPECT_NO_THROW((void)earth_rotation(epoch, parameters));
  parameters.ut1_minus_tai = (-0.5 - 34.0) * si::second;
  const std::string reason =
      "Earth orientation at 2008-09-20T12:25:40.104192 UTC: UT1-TAI is -34.5 s, so UT1-UTC -1.5 s; it "
      "must be within 0.9 s (UTC keeps it below 0.9 s); UT1-TAI = (UT1-UTC) - (TAI-UTC)";
  EXPECT_EQ(complaint([&] { (void)earth_rotation(epoch, parameters); }), reason);
  EXPECT_EQ(complaint([&] { (void)teme_from_itrf(epoch, parameters); }), reason);
  EXPECT_EQ(complaint([&] { (void)itrf_from_true_of_date(epoch, parameters); }), reason);
  // Also where UT1-UTC is small, as it is from 2021 to 2026.
  parameters.ut1_minus_tai = (0.05 - 34.0) * si::second;
  EXPECT_THROW((void)earth_rotation(epoch, parameters), BadInput);
  parameters.ut1_minus_tai = (-0.05 - 32.0) * si::second;
  EXPECT_THROW((void)earth_rotation(epoch, parameters), BadInput);
}

TEST(EarthRotation, RefusesParametersThatNobodyObserves) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto epoch = Epoch::from_utc("2022-04-14T00:00:00");
  const auto good = EarthOrientation::read(april_2022).parameters(epoch);
  const auto refusal = [&](const EarthOrientationParameters& parameters) {
    const std::string place = "Earth orientation at 2022-04-14T00:00:00.000000 UTC: ";
    const auto by_rotation = complaint([&] { (void)earth_rotation(epoch, parameters); });
    EXPECT_EQ(complaint([&] { (void)teme_from_itrf(epoch, parameters); }), by_rotation);
    EXPECT_EQ(complaint([&] { (void)itrf_from_true_of_date(epoch, parameters); }), by_rotation);
    EXPECT_TRUE(by_rotation.starts_with(place)) << by_rotation;
    return by_rotation.substr(std::min(place.size(), by_rotation.size()));
  };
  auto bad = good;
  bad.pole_x = nan * si::radian;
  EXPECT_EQ(refusal(bad), "pole_x is nan rad; it must be within 60 arcsec");
  bad = good;
  bad.pole_y = 0.3 * si::radian;  // arcsec
  EXPECT_EQ(refusal(bad), "pole_y is 0.3 rad; it must be within 60 arcsec");
  bad = good;
  bad.dX_rate = nan * (si::radian / si::second);
  EXPECT_EQ(refusal(bad), "dX_rate is nan rad/s; it must be within 60 arcsec a day");
  bad = good;
  bad.pole_y_rate = 3e-3 * (si::radian / si::second);  // arcsec a day
  EXPECT_EQ(refusal(bad), "pole_y_rate is 0.003 rad/s; it must be within 60 arcsec a day");
  bad = good;
  bad.ut1_gain = Quantity<si::dimensionless>{1.00000001};  // of the ratio of UT1 and TAI
  EXPECT_EQ(refusal(bad), "d(UT1-TAI)/dTAI is 1.00000001; it must be within 1e-6");
  bad = good;
  bad.ut1_gain = Quantity<si::dimensionless>{nan};
  EXPECT_EQ(refusal(bad), "d(UT1-TAI)/dTAI is nan; it must be within 1e-6");
  bad = good;
  bad.ut1_minus_tai = nan * si::second;
  EXPECT_EQ(refusal(bad), "UT1-TAI is nan s");
  EXPECT_EQ(complaint([&] { (void)earth_rotation(Epoch::from_tt("1950-01-01T00:00:00"), bad); }),
            "Earth orientation at 1950-01-01T00:00:00.000000 TT: UT1-TAI is nan s");
}

TEST(EarthOrientation, RefusesEpochsOutsideTheData) {
  const auto orientation = EarthOrientation::read(april_2022);
  EXPECT_NO_THROW((void)orientation.at(orientation.first()));
  EXPECT_NO_THROW((void)orientation.at(orientation.last()));
  EXPECT_EQ(complaint([&] { (void)orientation.at(Epoch::from_utc("2022-04-17T00:00:00.000001")); }),
            "EarthOrientation: the epoch 2022-04-17T00:00:00.000001 UTC is outside the data, which span "
            "2022-04-11T00:00:00.000000 UTC to 2022-04-17T00:00:00.000000 UTC");
  EXPECT_EQ(complaint([&] { (void)orientation.at(Epoch::from_tt("1950-01-01T00:00:00")); }),
            "EarthOrientation: the epoch 1950-01-01T00:00:00.000000 TT is outside the data, which span "
            "2022-04-11T00:00:00.000000 UTC to 2022-04-17T00:00:00.000000 UTC");
}

}  // namespace
}  // namespace vectrix::earth_orientation_test
