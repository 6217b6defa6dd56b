#include <gtest/gtest.h>

#include <erfa.h>

#include <Eigen/Geometry>
#include <cmath>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>
#include <vectrix/space/earth/eme2000.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>
#include <vectrix/space/earth/teme.hpp>
#include <vectrix/space/sky/bodies.hpp>
#include <vectrix/space/sky/iau_frames.hpp>

#include "temporary_file.hpp"

namespace vectrix::earth_frames_test {
namespace {

using earth::Eme2000, earth::Gcrf, earth::Itrf, earth::Teme, earth::TrueOfDate;

constexpr double arcsecond = 4.84813681109536e-6;  // rad

// The angles are printed to a microarcsecond; their products, which the matrix to first order omits, are
// below.
constexpr double printed_bias = 5e-7 * arcsecond + 1e-14;
constexpr double printed_bias_of_equinox = 5e-5 * arcsecond;

// g++ leaves out the namespace of the library, clang writes it: messages do not.
TEST(EarthFrames, HaveTheSameNamesWithAllCompilers) {
  EXPECT_EQ(frame_name<earth::Gcrf>(), "earth::Gcrf");
  EXPECT_EQ((frame_name<sky::Image<sky::Sun, Apparent>>()), "sky::Image<sky::Sun, Apparent>");
}

TEST(Eme2000, HasThePublishedBias) {
  const Eigen::Matrix3d R = eme2000_from_gcrf().matrix();
  constexpr double xi = -0.016617 * arcsecond, eta = -0.006819 * arcsecond, da = -0.0146 * arcsecond;
  EXPECT_NEAR(R(2, 0), xi, printed_bias);
  EXPECT_NEAR(R(2, 1), eta, printed_bias);
  EXPECT_NEAR(R(0, 1), da, printed_bias_of_equinox);
  EXPECT_NEAR(R(1, 0), -da, printed_bias_of_equinox);
  constexpr double rounding = 1e-15;
  EXPECT_LE((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), rounding);
  EXPECT_GT(R.determinant(), 0.0);
}

TEST(Eme2000, IsAnInertialFrameOfTheGraph) {
  static_assert(InertialFrame<Eme2000>);
  const auto graph = frame_graph(rigid_edge(eme2000_from_gcrf()));
  EXPECT_EQ(graph.at(Epoch::from_tt("2000-01-01T12:00:00"))
                .angular_velocity(of<Gcrf>, relative_to<Eme2000>, in<Gcrf>)
                .coordinates()
                .norm(),
            0.0);
}

// The rotation vector of a turn that is not small and not half.
Eigen::Vector3d log_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

// Vallado, Crawford, Hujsak, Kelso, Revisiting Spacetrack Report #3 (AIAA 2006-6753, revision 2), appendix C,
// with the length of the day of 86400.0015563 s. Its UT1 is a Julian date in one double, rounded to 40
// microseconds, which would be 13 mm: so it is here.
struct Published {
  Epoch epoch = Epoch::from_utc("2004-04-06T07:51:28.386009");
  EarthOrientationParameters observed{-0.140682 * arcsecond * si::radian,
                                      0.333309 * arcsecond* si::radian,
                                      (-0.4399619 - 32.0) * si::second,
                                      Quantity<si::dimensionless>{-0.0015563 / 86400.0},
                                      0.0 * si::radian,
                                      0.0 * si::radian};
  Eigen::Vector3d r_teme{5094180.16210, 6127644.65950, 6380344.53270};   // m
  Eigen::Vector3d v_teme{-4746.131487, 785.818041, 5531.931288};         // m/s
  Eigen::Vector3d r_itrf{-1033479.38300, 7901295.27540, 6380356.59580};  // m
  Eigen::Vector3d v_itrf{-3225.636520, -2872.451450, 5531.924446};       // m/s

  Published() {
    const auto date = ut1();
    const double one_number = date.day + date.fraction;
    observed.ut1_minus_tai =
        observed.ut1_minus_tai + ((one_number - date.day) - date.fraction) * 86400.0 * si::second;
  }
  [[nodiscard]] JulianDate<scale::Ut1> ut1() const {
    return epoch.julian_date(scale::Ut1::minus_tai(observed.ut1_minus_tai));
  }
};
// s', which the paper leaves out, is 1e-11 rad, 0.1 mm at 8000 km.
constexpr double published_place = 2e-4;     // m
constexpr double published_velocity = 1e-6;  // m/s: both vectors are printed to that

TEST(Teme, AgreesWithThePublishedExample) {
  const Published p;
  const auto teme = teme_from_itrf(p.epoch, p.observed);
  const auto r_itrf = inverse(teme.rotation) * vector<si::length>(in<Teme>, p.r_teme);
  EXPECT_LE((r_itrf.coordinates() - p.r_itrf).norm(), published_place);

  // The velocity of the paper is along the axes of Teme, and observed from a frame with the same z axis that
  // does not turn about it, which is Cirf: v|c = v|i + w_ci x r.
  const Eigen::Vector3d v_cirf = teme.rotation.matrix().transpose() * p.v_teme;
  const Eigen::Vector3d w_ci = (cirf_from_tirf(p.epoch, p.observed) * tirf_from_itrf(p.epoch, p.observed))
                                   .angular_velocity.coordinates();
  EXPECT_LE((v_cirf - w_ci.cross(r_itrf.coordinates()) - p.v_itrf).norm(), published_velocity);
  // Teme itself turns with the precession in right ascension, 46.1 arcsec a year.
  const Eigen::Vector3d w_ct = w_ci - teme.angular_velocity.coordinates();
  constexpr double year = 365.25 * 86400.0, precession = 46.1 * arcsecond / year;  // s, rad/s
  EXPECT_NEAR(w_ct.z(), -precession, 0.01 * precession);
}

TEST(Teme, RateIsTheDerivativeOfTheRotation) {
  Published p;
  const auto rotation_after = [&](double seconds) {
    EarthOrientationParameters then = p.observed;
    const auto later = seconds * si::second;
    then.ut1_minus_tai = then.ut1_minus_tai + p.observed.ut1_gain.value() * later;
    then.pole_x = then.pole_x + p.observed.pole_x_rate.value() * seconds * si::radian;
    then.pole_y = then.pole_y + p.observed.pole_y_rate.value() * seconds * si::radian;
    return teme_from_itrf(p.epoch + seconds * si::second, then).rotation;
  };
  const auto error = [&](double half) {
    const auto moved = log_of(rotation_after(-half).matrix().transpose() * rotation_after(half).matrix());
    const Eigen::Vector3d w = teme_from_itrf(p.epoch, p.observed).angular_velocity.coordinates();
    return (moved / (2 * half) - w).norm();
  };
  // Over 0.7 rad. Seconds of sidereal time are rounded to 6e-11 s, which is 4e-15 rad in 1e4 s.
  constexpr double rounding = 2e-18;  // rad/s
  EXPECT_LE(error(5000.0), rounding);

  // A pole that moves, a hundred times faster than observed. It turns by 0.004 rad in a minute, which squared
  // is the relative error of the difference.
  p.observed.pole_x_rate = 2e-11 * (si::radian / si::second);
  p.observed.pole_y_rate = -1e-11 * (si::radian / si::second);
  EXPECT_LE(error(60.0), 1e-15);
}

// What other treatments of the same vector cost, against the published place: each as large as its closed
// form says. With the frames in the types the first two do not compile.
TEST(Teme, MistakesAndWhatTheyCost) {
  const Published p;
  const double r = p.r_teme.norm(), across = p.r_teme.head<2>().norm();  // m: from the centre, from the axis
  const auto tt = p.epoch.tt_date();
  const double equinoxes = eraEqeq94(tt.day, tt.fraction);  // rad
  const double years = tt.day / 365.25 - 2451545.0 / 365.25;
  const auto miss = [&](const Eigen::Matrix3d& R_itrf_from_teme) {
    return (R_itrf_from_teme * p.r_teme - p.r_itrf).norm();
  };
  const auto R3 = [](double angle) -> Eigen::Matrix3d {
    return Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  };
  const auto itrf_from_teme = [&](const EarthOrientationParameters& observed) -> Eigen::Matrix3d {
    return teme_from_itrf(p.epoch, observed).rotation.matrix().transpose();
  };
  const Eigen::Matrix3d itrf_from_gcrf = earth_rotation(p.epoch, p.observed).rotation.matrix().transpose();
  const Eigen::Matrix3d itrf_from_true_of_date =
      vectrix::itrf_from_true_of_date(p.epoch, p.observed).rotation.matrix();

  // Taken for Gcrf: precession, 50.29 arcsec a year about the pole of the ecliptic, and nutation.
  constexpr double obliquity = 23.44 / 180.0 * 3.14159265, nutation = 20.0 * arcsecond;
  const Eigen::Vector3d precession =
      50.29 * arcsecond * years * Eigen::Vector3d(0.0, -std::sin(obliquity), std::cos(obliquity));
  EXPECT_NEAR(miss(itrf_from_gcrf), precession.cross(p.r_teme).norm(), nutation * r);

  // Taken for TrueOfDate: the equation of the equinoxes; with its sign wrong, twice that. The nutation of
  // 1980 differs from that of 2006 by some 0.05 arcsec.
  constexpr double nutation_1980 = 0.1 * arcsecond;
  EXPECT_LE(miss(itrf_from_true_of_date * R3(-equinoxes)), nutation_1980 * across);
  EXPECT_NEAR(miss(itrf_from_true_of_date), std::abs(equinoxes) * across, nutation_1980 * across);
  EXPECT_NEAR(miss(itrf_from_true_of_date * R3(equinoxes)), 2 * std::abs(equinoxes) * across,
              nutation_1980 * across);

  // UTC taken for UT1: 256 m.
  EarthOrientationParameters other = p.observed;
  other.ut1_minus_tai = -32.0 * si::second;
  constexpr double earth_rate = 7.292116e-5;  // rad/s
  EXPECT_NEAR(miss(itrf_from_teme(other)), -(p.observed.ut1_minus_tai.value() + 32.0) * earth_rate * across,
              published_place);
  // Without polar motion: 16 m.
  other = p.observed;
  other.pole_x = other.pole_y = 0.0 * si::radian;
  const Eigen::Vector3d turn(p.observed.pole_y.value(), p.observed.pole_x.value(), 0.0);
  EXPECT_NEAR(miss(itrf_from_teme(other)), turn.cross(p.r_itrf).norm(), published_place);

  // GMST of 2006 for that of 1982. ERA and both polynomials, with their published coefficients in exact
  // arithmetic, differ by 2.8353 milliarcsec at this instant, 0.11 m.
  constexpr double gmst06_minus_gmst82 = 1.374588e-8;  // rad
  const auto ut1 = p.ut1();
  const double given =
      eraGmst06(ut1.day, ut1.fraction, tt.day, tt.fraction) - eraGmst82(ut1.day, ut1.fraction);
  EXPECT_NEAR(miss(itrf_from_teme(p.observed) * R3(given)), gmst06_minus_gmst82 * across, published_place);
}

// The polynomials of precession grow without bound: they answer within 1000 years of 2000.
TEST(EarthFrames, RefuseDatesFarFrom2000) {
  const auto noon = Epoch::from_julian_date(JulianDate<scale::Tai>{2451545.0, 0.0});
  for (const double days : {365251.0, -365251.0, 1e200}) {
    const auto far = noon + 86400.0 * days * si::second;
    const auto place =
        "the Julian date " + detail::text(far.tai().day) + " is more than 1000 years from 2000";
    EXPECT_EQ(complaint([&] { (void)mean_of_date_from_gcrf(far); }), "mean_of_date_from_gcrf: " + place);
    EXPECT_EQ(complaint([&] { (void)true_of_date_from_gcrf(far); }), "true_of_date_from_gcrf: " + place);
    EXPECT_EQ(complaint([&] { (void)itrf_from_true_of_date(far, {}); }), "itrf_from_true_of_date: " + place);
    EXPECT_EQ(complaint([&] { (void)gcrf_from_cirf(far, {}); }), "gcrf_from_cirf: " + place);
    EXPECT_EQ(complaint([&] { (void)iau_rotation(of<moon::Iau>, far); }), "iau_rotation: " + place);
  }
  EXPECT_NO_THROW((void)mean_of_date_from_gcrf(
      Epoch::from_julian_date(JulianDate<scale::Tai>{2451545.0 - 365250.0, 0.0})));
}

}  // namespace
}  // namespace vectrix::earth_frames_test
