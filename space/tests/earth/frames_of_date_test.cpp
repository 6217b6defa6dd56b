#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <erfa.h>
#include <erfam.h>

#include <Eigen/Geometry>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>

#include "earth/any_epoch.hpp"

namespace vectrix::frames_of_date_test {
namespace {

using earth::Gcrf, earth::Itrf, earth::MeanOfDate, earth::TrueOfDate;
using earth_test::any_epoch, earth_test::any_part, earth_test::largest, earth_test::matrix_of,
    earth_test::Rows;
using Eigen::Vector3d;

constexpr double rounding = 1e-15;                 // of a matrix element
constexpr double arcsecond = 4.84813681109536e-6;  // rad
// rad: X and Y of the series eraXy06 and of precession and nutation agree to 3 microarcsec within 27 years of
// 2000 each; s follows from both.
constexpr double difference_of_series = 5e-6 * arcsecond;

RC_GTEST_PROP(MeanOfDate, IsErfasAndNutationIsWhatIsMissing, ()) {
  const Epoch t = any_epoch();
  const auto tt = t.tt_date();
  Rows rows;
  eraPmat06(tt.day, tt.fraction, rows);
  const Dcm<MeanOfDate, Gcrf> mean = mean_of_date_from_gcrf(t).rotation;
  RC_ASSERT(largest(mean.matrix() - matrix_of(rows)) <= rounding);
  eraNum06a(tt.day, tt.fraction, rows);
  const Dcm<TrueOfDate, MeanOfDate> nutation = true_of_date_from_gcrf(t).rotation * inverse(mean);
  RC_ASSERT(largest(nutation.matrix() - matrix_of(rows)) <= rounding);
  RC_ASSERT(Eigen::AngleAxisd(nutation.matrix()).angle() < 21.0 * arcsecond);
}

// Capitaine, Wallace and Chapront 2003 (IERS Conventions 2010, equation 5.40): R = R3(-z) R2(theta) R3(-zeta)
// with zeta = 2.650545" + 2306.083227" t, z = -2.650545" + 2306.077181" t, theta = 2004.191903" t at t = 0.
TEST(MeanOfDate, TurnsAtThePublishedRateOfPrecession) {
  const auto rate = mean_of_date_from_gcrf(Epoch::from_tt("2000-01-01T12:00:00")).angular_velocity;
  const double per_century = arcsecond / (ERFA_DJC * ERFA_DAYSEC);  // rad/s of an arcsec per century
  const Vector3d mean_relative_to_gcrf =
      per_century * Vector3d(2004.191903 * 2.650545 * arcsecond, 2004.191903, -2306.083227 - 2306.077181);
  // The axes differ by the bias, 23 mas, 1.2e-7 rad, and the digits by 1e-6" of 5000".
  constexpr double relative = 1.3e-7;
  EXPECT_LE((rate.coordinates() + mean_relative_to_gcrf).norm(), relative * mean_relative_to_gcrf.norm());
}

// By CIRF and TIRF, and by the equinox.
RC_GTEST_PROP(TrueOfDate, TurnsAsTheOtherWayToTheEarthDoes, ()) {
  const Epoch t = any_epoch();
  EarthOrientationParameters p{};
  p.pole_x = any_part() * 4e-6 * si::radian;
  p.pole_y = any_part() * 4e-6 * si::radian;
  p.ut1_minus_tai = 0.89 * any_part() * si::second - t.tai_minus_utc();
  p.ut1_gain = Quantity<si::dimensionless>{any_part() * 1e-7};
  p.pole_x_rate = any_part() * 1e-9 * (si::radian / si::second);
  p.pole_y_rate = any_part() * 1e-9 * (si::radian / si::second);
  const MovingDcm<Gcrf, Itrf> by_the_equinox =
      inverse(itrf_from_true_of_date(t, p) * true_of_date_from_gcrf(t));
  const MovingDcm<Gcrf, Itrf> by_the_origin = earth_rotation(t, p);
  RC_ASSERT(largest(by_the_equinox.rotation.matrix() - by_the_origin.rotation.matrix()) <=
            difference_of_series);
  // The series differ by terms of five days and more; 7e-5 rad/s is rounded to 1e-20.
  constexpr double rate_of_difference = difference_of_series * 2.0 * 3.14159265 / (5.0 * 86400.0);
  RC_ASSERT(
      (by_the_equinox.angular_velocity.coordinates() - by_the_origin.angular_velocity.coordinates()).norm() <=
      rate_of_difference);
}

TEST(FramesOfDate, AreEdgesOfAGraph) {
  const Epoch t = Epoch::from_utc("2022-04-14T10:22:11");
  EarthOrientationParameters p{};
  p.ut1_minus_tai = -37.1 * si::second;
  const auto graph = frame_graph(edge([](const Epoch& e) { return mean_of_date_from_gcrf(e); }),
                                 edge([](const Epoch& e) { return true_of_date_from_gcrf(e); }),
                                 edge([&](const Epoch& e) { return itrf_from_true_of_date(e, p); }));
  const auto found = graph.at(t).angular_velocity(of<Itrf>, relative_to<MeanOfDate>, in<Itrf>);
  const MovingDcm<MeanOfDate, Itrf> expected =
      mean_of_date_from_gcrf(t) * inverse(true_of_date_from_gcrf(t)) * inverse(itrf_from_true_of_date(t, p));
  constexpr double rate_rounding = 1e-19;  // rad/s, of 7e-5
  EXPECT_LE((found.coordinates() - expected.angular_velocity.coordinates()).norm(), rate_rounding);
}

}  // namespace
}  // namespace vectrix::frames_of_date_test
