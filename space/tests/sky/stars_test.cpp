#include <erfa.h>
#include <erfam.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <vectrix/kinematics.hpp>
#include <vectrix/space/earth/eme2000.hpp>
#include <vectrix/space/sky/stars.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::stars_test {
namespace {

using earth::Gcrf;
using vectrix_test::triple;

struct Tracker : moving_frame {};

constexpr double arcsec = ERFA_DAS2R, mas = ERFA_DMAS2R, degree = ERFA_DD2R;
constexpr double year = 365.25 * 86400.0;  // s
const auto span = from_until(Epoch::from_tt("2022-01-01T00:00:00"), Epoch::from_tt("2022-12-31T00:00:00"));
const Stars stars(span);

Epoch julian_epoch(double years) {
  return Epoch::from_julian_date(scale::tdb, ERFA_DJ00, (years - 2000.0) * ERFA_DJY);
}

// As ERFA takes it: rad, rad/year without the cosine, arcsec, km/s.
struct Entry {
  double ra, dec, ra_rate, dec_rate, parallax, radial_velocity, year;
};
Star star_of(const Entry& s) {
  return {in<Gcrf>,
          {s.ra * si::radian, s.dec * si::radian},
          proper_motion_without_cos_declination(s.ra_rate / year * (si::radian / si::second),
                                                s.dec_rate / year * (si::radian / si::second)),
          s.parallax * arcsec * si::radian,
          s.radial_velocity * 1e3 * (si::metre / si::second),
          julian_epoch(s.year)};
}
// Faster than Barnard's star, nearer than Proxima, up to 0.06 arcsec from a pole.
Entry any_star() {
  const Eigen::Vector3d a = *triple(), b = *triple();
  const double dec = (std::numbers::pi / 2.0 - 3e-7) * std::sin(3.0 * a.x());
  return {6.0 * a.y(),
          dec,
          10.0 * arcsec * a.z() / std::cos(dec),
          10.0 * arcsec * b.x(),
          std::abs(b.y()) / 2.0,
          300.0 * b.z(),
          1991.25};
}
Eigen::Vector3d unit(double ra, double dec) {
  return {std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)};
}
double angle(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

rc::Gen<Epoch> epoch_of_span() {
  return rc::gen::map(rc::gen::inRange(0, 1'000'000'000),
                      [](int part) { return span.start() + (part / 1e9) * (span.end() - span.start()); });
}
PointMotion<Gcrf, Tracker, Gcrf> moving(const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
  return point_motion(of<Tracker>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}

struct EarthByErfa {
  double heliocentric[2][3], barycentric[2][3];
  explicit EarthByErfa(const Epoch& t) {
    eraEpv00(t.tt_date().day, t.tt_date().fraction, heliocentric, barycentric);
  }
};

// The direction of the sum is rounded before it is unit; the times of both differ by 1e-8 s.
constexpr double rounding = 1e-14;  // rad

RC_GTEST_PROP(Stars, LightTimeIsPlaceMotionAndParallaxOfErfa, ()) {
  const auto s = any_star();
  const auto t = *epoch_of_span();
  const Eigen::Vector3d r = 5e8 * *triple();
  const EarthByErfa earth(t);
  Eigen::Vector3d observer;
  for (int i = 0; i < 3; ++i) observer[i] = earth.barycentric[0][i] + r[i] / ERFA_DAU;
  Eigen::Vector3d expected;
  eraPmpx(s.ra, s.dec, s.ra_rate, s.dec_rate, s.parallax, s.radial_velocity,
          (t - julian_epoch(s.year)).value() / year, observer.data(), expected.data());
  const auto found = stars.direction(star_of(s), t, moving(r, r), light_time);
  RC_ASSERT((found.coordinates() - expected).norm() < rounding);
  const auto position = moving(r, r).position;
  RC_ASSERT(stars.direction(star_of(s), t, position, light_time).coordinates() == found.coordinates());
}

// eraAb has the potential of the Sun in the aberration, 2e-12 rad; the velocity of the Earth's pieces is
// 3e-4 m/s off at a join, 1e-12 rad.
RC_GTEST_PROP(Stars, ApparentIsTheChainOfErfa, ()) {
  constexpr double aberration_error = 3e-12 + 1e-12;
  const auto s = any_star();
  const auto t = *epoch_of_span();
  const Eigen::Vector3d r = 5e7 * *triple(), v = 8e3 * *triple();
  const EarthByErfa earth(t);
  double pv[2][3];
  double heliocentric[3];
  double barycentric[2][3];
  for (int i = 0; i < 3; ++i) {
    pv[0][i] = r[i];
    pv[1][i] = v[i];
    heliocentric[i] = earth.heliocentric[0][i];
    for (int k = 0; k < 2; ++k) barycentric[k][i] = earth.barycentric[k][i];
  }
  const auto tdb = t.julian_date(scale::tdb);
  eraASTROM astrom;
  eraApcs(tdb.day, tdb.fraction, pv, barycentric, heliocentric, &astrom);
  astrom.pmt = (t - julian_epoch(s.year)).value() / year;  // eraApcs counts from 2000
  double ra;
  double dec;
  eraAtciq(s.ra, s.dec, s.ra_rate, s.dec_rate, s.parallax, s.radial_velocity, &astrom, &ra, &dec);
  const auto found = stars.direction(star_of(s), t, moving(r, v), apparent);
  RC_ASSERT((found.coordinates() - unit(ra, dec)).norm() < aberration_error + rounding);
}

// Straight in space, as eraPmsafe has it. That also takes the star's own light time out of its rates and puts
// it back, which is of the second order: (v_r/c) times the curvature of the path on the sky.
TEST(Stars, MovesAsErfasStars) {
  const Entry s{269.452 * degree, 4.693 * degree, -0.80 * arcsec, 10.33 * arcsec, 0.547, -110.6, 2000.0};
  for (const double years : {-50.0, -10.0, 0.0, 30.0, 100.0}) {
    double ra;
    double dec;
    double unused[4];
    ASSERT_EQ(
        eraPmsafe(s.ra, s.dec, s.ra_rate, s.dec_rate, s.parallax, s.radial_velocity, ERFA_DJ00, 0.0,
                  ERFA_DJ00, years * ERFA_DJY, &ra, &dec, &unused[0], &unused[1], &unused[2], &unused[3]),
        0);
    const auto found = star_of(s).direction_from_barycentre(julian_epoch(2000.0 + years)).coordinates();
    const double turned = 10.4 * arcsec * years;
    const double perspective = 2.0 * 110.6e3 * (0.547 * arcsec / ERFA_DAU) * std::abs(years) * year;
    EXPECT_LT(angle(found, unit(ra, dec)), std::abs(turned) * perspective * 110.6e3 / ERFA_CMPS + rounding)
        << years;
  }
}

Star with_cosine(const RightAscensionDeclination& place, double ra_mas, double dec_mas, double parallax_mas,
                 double km_s, double years) {
  return {in<Gcrf>,
          place,
          proper_motion_with_cos_declination(ra_mas * mas / year * (si::radian / si::second),
                                             dec_mas * mas / year * (si::radian / si::second)),
          parallax_mas * mas * si::radian,
          km_s * 1e3 * (si::metre / si::second),
          julian_epoch(years)};
}
RightAscensionDeclination in_degrees(double ra, double dec) {
  return {convert<si::angle>(ra * si::degree), convert<si::angle>(dec * si::degree)};
}

// Polaris of the Hipparcos catalogue (1997), at 1991.25, moved to 2000, against SIMBAD's place there, which
// rests on the reduction of 2007: the two rates differ by 0.26 mas/year. The cosine is 0.0128, and with the
// wrong word the star would be off by 30 arcsec.
TEST(Stars, PolarisHasTheCosine) {
  const auto polaris = with_cosine(in_degrees(37.94614689, 89.26413805), 44.22, -11.74, 7.56, -17.0, 1991.25);
  const auto place = right_ascension_declination(polaris.direction_from_barycentre(julian_epoch(2000.0)));
  const double ra = (2.0 + 31.0 / 60.0 + 49.09456 / 3600.0) * 15.0 * degree;
  const double dec = (89.0 + 15.0 / 60.0 + 50.7923 / 3600.0) * degree;
  constexpr double two_reductions = 0.3 * 8.75 * mas + 1.0 * mas;
  EXPECT_LT(angle(unit(place.right_ascension.value(), place.declination.value()), unit(ra, dec)),
            two_reductions);
}

// Barnard's star of Gaia DR3, at 2016, moved back to 1991.25, where Hipparcos saw it. Hipparcos' place has an
// error of 1.5 mas. Its approach quickens the proper motion by 1.2 mas/year^2, 0.38 arcsec in this time.
TEST(Stars, BarnardsStarApproaches) {
  const auto barnard = with_cosine(in_degrees(269.44850252543836, 4.739420051112412), -801.551, 10362.394,
                                   546.976, -110.5, 2016.0);
  const auto found = barnard.direction_from_barycentre(julian_epoch(1991.25)).coordinates();
  constexpr double hipparcos_and_gaia = 10.0 * mas;
  EXPECT_LT(angle(found, unit(269.45402305 * degree, 4.66828815 * degree)), hipparcos_and_gaia);
}

// A parallax moves the star to the observer's opposite side by p for each au: half a year apart, by 2p
// across.
TEST(Stars, ParallaxIsSeenOverAYear) {
  const auto pole = with_cosine(in_degrees(270.0, 66.56), 0.0, 0.0, 500.0, 0.0, 2022.0);
  const auto seen = [&](const Epoch& t) {
    return stars.direction(pole, t, moving(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()), light_time)
        .coordinates();
  };
  const auto t = span.start() + 10.0 * 86400.0 * si::second;
  const auto later = t + year / 2.0 * si::second;
  // At the pole of the ecliptic the path is a circle of radius p, within the eccentricity of 0.017.
  EXPECT_NEAR(angle(seen(t), seen(later)), 1000.0 * mas, 0.017 * 1000.0 * mas);
  const Eigen::Vector3d earth = geocentric(of<sky::Sun>, t).position.coordinates();
  EXPECT_GT((seen(t) - seen(later)).dot(earth), 0.0);  // towards the Sun, away from the Earth
}

TEST(Stars, AnswerInTheWordsOfAGraph) {
  const auto star = with_cosine(in_degrees(101.28715533, -16.71611586), -546.0, -1223.0, 379.2, -5.5, 2000.0);
  const auto t = Epoch::from_utc("2022-04-14T10:22:11");
  const auto state = moving(Eigen::Vector3d(7e6, -1e6, 2e6), Eigen::Vector3d(1e3, 7e3, -5e2));
  const auto turning = moving_dcm(turned_z(to<Gcrf>, from<Tracker>, 0.7 * si::radian),
                                  at_rest(of<Tracker>, relative_to<Gcrf>, in<Tracker>));
  const auto graph = frame_graph(edge([&](const Epoch&) {
    return MovingTransform{turning, state.position, state.velocity};
  }));
  const auto now = graph.at(t);
  const auto agree = [&](auto correction) {
    const auto expected = inverse(turning.rotation) * stars.direction(star, t, state, correction);
    const auto found = stars.direction(star, now, seen_from<Tracker>, correction, in<Tracker>);
    static_assert(std::same_as<decltype(found), const Vector<Tracker, si::dimensionless>>);
    EXPECT_LT((found.coordinates() - expected.coordinates()).norm(), 1e-15);
    const auto still = moving(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    EXPECT_EQ(stars.direction(star, now, seen_from<Gcrf>, correction, in<Gcrf>).coordinates(),
              stars.direction(star, t, still, correction).coordinates());
  };
  agree(light_time);
  agree(apparent);
}

TEST(Stars, RefuseWhatIsNoStar) {
  const auto place = in_degrees(10.0, 20.0);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto said = [](auto call, const std::string& text) {
    const auto found = complaint(call);
    EXPECT_TRUE(vectrix_test::contains(found, text)) << found;
  };
  said([&] { (void)with_cosine(place, 0, 0, -0.21, 0, 2000.0); }, "Star: the parallax -1.0");
  said([&] { (void)with_cosine(place, 0, 0, 1000.1, 0, 2000.0); }, "is not between 0 and 4.85e-6 rad");
  said([&] { (void)with_cosine(place, 0, 0, nan, 0, 2000.0); }, "Star: the parallax nan");
  said([&] { (void)with_cosine(place, 0, 0, 1, nan, 2000.0); }, "Star: the radial velocity is nan m/s");
  said([&] { (void)with_cosine(place, 0, 0, 1, 1e6, 2000.0); },
       "Star: the radial velocity is 1e+09 m/s; it must be below the speed of light");
  said([&] { (void)with_cosine(place, nan, 0, 1, 0, 2000.0); }, "the rate of right ascension, rad/s, nan");
  said([&] { (void)with_cosine(place, 0, nan, 1, 0, 2000.0); }, "the rate of declination, rad/s, nan");
  said([&] { (void)with_cosine(place, 0, -1.01e5, 1, 0, 2000.0); },
       "rad/s; it must be below 1.54e-11 rad/s, 100 arcsec a year");
  EXPECT_NO_THROW((void)with_cosine(place, 0, -0.99e5, 1, 0, 2000.0));
  said([&] { (void)with_cosine(in_degrees(10.0, 91.0), 0, 0, 1, 0, 2000.0); }, "Star: the declination 1.58");
  said([&] { (void)with_cosine(in_degrees(nan, 9.0), 0, 0, 1, 0, 2000.0); }, "Star: the right ascension nan");
  const auto star = with_cosine(place, 0, 0, 1, 0, 2000.0);
  const auto still = moving(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  const Eigen::Vector3d nowhere(nan, 0.0, 0.0);
  said([&] { (void)star.direction_from(detail::trusted, span.start(), nowhere); }, "Star: seen from nan m");
  said([&] { (void)stars.direction(star, julian_epoch(2000.0), still, apparent); }, "Stars: the epoch 2000");
  said([&] { (void)stars.direction(star, julian_epoch(2000.0), still, light_time); },
       "Stars: the epoch 2000");
  said([&] { Stars(from_until(Epoch::from_tt("2100-01-01T12:00:00"), 1.0 * si::second)); },
       "Stars: the epoch 2100");
}

template <class... Given>
concept Sees = requires(const Given&... given) {
  { stars.direction(given...) } -> std::same_as<Vector<Gcrf, si::dimensionless>>;
};
using Position = Displacement<Gcrf, Tracker, In<Gcrf>>;
using Motion = PointMotion<Gcrf, Tracker, Gcrf>;
static_assert(Sees<Star, Epoch, Position, LightTime> && Sees<Star, Epoch, Motion, Apparent>);
static_assert(!Sees<Star, Epoch, Motion>);              // no correction
static_assert(!Sees<Star, Epoch, Motion, Geometric>);   // a catalogue does not say where a star is
static_assert(!Sees<Star, Epoch, Position, Apparent>);  // no velocity
using Rate = Quantity<si::angular_velocity>;
static_assert(!std::is_constructible_v<ProperMotion, Rate, Rate>);
static_assert(!std::is_constructible_v<Star, In<earth::Eme2000>, RightAscensionDeclination, ProperMotion,
                                       Quantity<si::angle>, Quantity<si::velocity>, Epoch>);

}  // namespace
}  // namespace vectrix::stars_test
