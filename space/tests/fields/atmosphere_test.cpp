#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/fields/exponential_atmosphere.hpp>
#include <vectrix/space/fields/harris_priester.hpp>
#include <vectrix/space/sky/geocentric.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::atmosphere_test {
namespace {

using earth::Gcrf;
using earth::Itrf;
using vectrix_test::triple;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-14;

double exponential(const ExponentialAtmosphere& model, double km) {
  return model.density(1e3 * km * si::metre).value();
}
Vector<Itrf, si::length> above(double latitude, double longitude, double km) {
  return wgs84::position({GeodeticLatitude(latitude * degree * si::radian), longitude * degree * si::radian,
                          1e3 * km * si::metre});
}
Vector<Itrf, si::dimensionless> towards(double latitude, double longitude) {
  const double phi = latitude * degree, lambda = longitude * degree;
  return vector<si::dimensionless>(
      in<Itrf>,
      Eigen::Vector3d(std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda), std::sin(phi)));
}
double density(double exponent, const Vector<Itrf, si::length>& r,
               const Vector<Itrf, si::dimensionless>& sun) {
  return HarrisPriester(exponent).density(r, sun).value();
}

// At bases of the table; and Vallado's example 8-4, 2.1219854e-14 kg/m^3 at 747.2119 km.
TEST(ExponentialAtmosphere, HasTheLayersOfVallado) {
  const auto model = ExponentialAtmosphere::vallado();
  EXPECT_DOUBLE_EQ(exponential(model, 0.0), 1.225);
  EXPECT_DOUBLE_EQ(exponential(model, 200.0), 2.789e-10);
  EXPECT_NEAR(exponential(model, 747.2119), 2.1219854e-14, 1e-20);
  EXPECT_DOUBLE_EQ(exponential(model, 1268.0), 3.019e-15 * std::exp(-1.0));
  const auto r = above(51.6, -70.0, 420.0);
  EXPECT_NEAR(model.density(r).value(), exponential(model, 420.0), 1e-10 * exponential(model, 420.0));
}

// Each layer ends where the next begins: a figure that is not the table's would leave a step.
TEST(ExponentialAtmosphere, LayersMeet) {
  const auto model = ExponentialAtmosphere::vallado();
  double largest = 0.0;
  for (const double base : {25,  30,  40,  50,  60,  70,  80,  90,  100, 110, 120, 130, 140, 150,
                            180, 200, 250, 300, 350, 400, 450, 500, 600, 700, 800, 900, 1000}) {
    const double below = exponential(model, base - 1e-9), at = exponential(model, base);
    EXPECT_NE(below, at);
    largest = std::max(largest, std::abs(below / at - 1.0));
  }
  EXPECT_LT(largest, 4e-3);
  EXPECT_GT(largest, 1e-3);
}

TEST(ExponentialAtmosphere, OfOneLayer) {
  const auto rho0 = Quantity<si::density>::from_value(2e-12);
  const ExponentialAtmosphere model({rho0, 4e5 * si::metre, 6e4 * si::metre});
  EXPECT_DOUBLE_EQ(exponential(model, 400.0), 2e-12);
  EXPECT_DOUBLE_EQ(exponential(model, 340.0), 2e-12 * std::exp(1.0));
  EXPECT_DOUBLE_EQ(exponential(model, 520.0), 2e-12 * std::exp(-2.0));
}

TEST(ExponentialAtmosphere, RefusesWhatIsNoHeight) {
  const auto model = ExponentialAtmosphere::vallado();
  EXPECT_EQ(complaint([&] { (void)exponential(model, -1.0); }),
            "ExponentialAtmosphere: the height -1000 m is not above the ellipsoid");
  EXPECT_THROW((void)exponential(model, nan), BadInput);
  EXPECT_THROW((void)exponential(model, std::numeric_limits<double>::infinity()), BadInput);
  EXPECT_THROW((void)model.density(above(0.0, 0.0, -5.0)), BadInput);
  const auto layer = [](double density, double base, double scale_height) {
    return complaint([=] {
      (void)ExponentialAtmosphere(
          {Quantity<si::density>::from_value(density), base * si::metre, scale_height * si::metre});
    });
  };
  EXPECT_EQ(layer(0.0, 1.0, 1.0), "ExponentialAtmosphere: the density is 0 kg/m^3");
  EXPECT_EQ(layer(nan, 1.0, 1.0), "ExponentialAtmosphere: the density is nan kg/m^3");
  EXPECT_EQ(layer(1.0, nan, 1.0), "ExponentialAtmosphere: the base is nan m");
  EXPECT_EQ(layer(1.0, 1.0, -2.0), "ExponentialAtmosphere: the scale height is -2 m");
}

// At the heights of the table, under the apex and opposite to it: 30 deg east of the Sun. Where the Sun is on
// the equator the position is too, so that geodetic and geocentric latitude agree.
TEST(HarrisPriester, HasTheTable) {
  for (const double n : {2.0, 3.5, 6.0}) {
    EXPECT_NEAR(density(n, above(0.0, 100.0, 400.0), towards(0.0, 70.0)), 7.492e-12, 7.492e-12 * 1e-9);
    EXPECT_NEAR(density(n, above(0.0, -80.0, 400.0), towards(0.0, 70.0)), 2.249e-12, 2.249e-12 * 1e-9);
    EXPECT_NEAR(density(n, above(0.0, 5.0, 800.0), towards(0.0, -25.0)), 8.059e-14, 8.059e-14 * 1e-9);
  }
  // between two heights, the geometric mean
  EXPECT_NEAR(density(4.0, above(0.0, 30.0, 410.0), towards(0.0, 0.0)), std::sqrt(7.492e-12 * 5.684e-12),
              1e-21);
  EXPECT_NEAR(density(2.0, above(0.0, 30.0, 100.0 + 1e-6), towards(0.0, 0.0)), 4.974e-7, 4.974e-7 * 1e-6);
  EXPECT_NEAR(density(2.0, above(0.0, 30.0, 1000.0 - 1e-6), towards(0.0, 0.0)), 1.810e-14, 1.810e-14 * 1e-6);
}

// rho = least + (most - least) c^n, c = cos(psi/2), so the exponents differ by the powers of c.
RC_GTEST_PROP(HarrisPriester, FollowsTheCosineOfHalfTheAngle, ()) {
  const Eigen::Vector3d u = *triple(), s = *triple();
  RC_PRE(u.norm() > 0.1 && s.norm() > 0.1);
  const auto km = *rc::gen::map(rc::gen::inRange(150, 950), [](int k) { return k + 0.37; });
  const auto geodetic = wgs84::geodetic(vector<si::length>(in<Itrf>, 7e6 * u.normalized()));
  const auto r = wgs84::position({geodetic.latitude, geodetic.longitude, 1e3 * km * si::metre});
  const auto sun = vector<si::length>(in<Itrf>, 1.5e11 * s.normalized());
  const Eigen::Vector3d apex = Eigen::AngleAxisd(30.0 * degree, Eigen::Vector3d::UnitZ()) * s.normalized();
  const double c2 = 0.5 * (1.0 + apex.dot(r.coordinates().normalized()));
  const auto rho = [&](double n) { return HarrisPriester(n).density(r, sun).value(); };
  RC_PRE(c2 < 0.999);
  const double least = (rho(4.0) - rho(2.0) * c2) / (1.0 - c2);
  RC_ASSERT(std::abs(rho(6.0) - (least + (rho(4.0) - least) * c2)) < rounding / (1.0 - c2) * rho(2.0));
}

// A published value: Orekit's HarrisPriesterTest (Apache-2.0), 2003 March 21, 1 h UTC, above latitude 0,
// longitude 0, at 500 km: 3.9237e-13 kg/m^3 with n = 4, and cos^2(psi/2) = 0.02163787 from n = 2, 4, 6. Its
// Earth is that of the IAU's elements, 2 arcmin from ITRF in longitude: 1e-3 rad sin(psi)/2 in the cosine.
TEST(HarrisPriester, IsThatOfOrekit) {
  const auto t = Epoch::from_utc("2003-03-21T01:00:00");
  EarthOrientationParameters parameters{};
  parameters.ut1_minus_tai = (-0.35 - 32.0) * si::second;
  const auto R_itrf_from_gcrf = inverse(earth_rotation(t, parameters).rotation);
  const auto sun = R_itrf_from_gcrf * geocentric(of<sky::Sun>, t).position;
  const auto r = above(0.0, 0.0, 500.0);
  const auto rho = [&](double n) { return HarrisPriester(n).density(r, sun).value(); };
  EXPECT_NEAR(rho(4.0), 3.9237e-13, 1e-17);
  EXPECT_NEAR((rho(6.0) - rho(2.0)) / (rho(4.0) - rho(2.0)) - 1.0, 0.02163787, 1e-3 * 0.29 / 2.0);
}

// Never a step, and always less further up.
// What a graph answers is taken as it is.
TEST(HarrisPriester, TakesADisplacementFromTheCentreOfTheEarth) {
  struct Satellite : moving_frame {};
  const auto r = above(20.0, 90.0, 400.0);
  const auto r_eq = displacement(of<Satellite>, relative_to<earth::Itrf>, r);
  const auto sun = towards(10.0, 40.0);
  EXPECT_EQ(HarrisPriester(3.0).density(r_eq, sun).value(), HarrisPriester(3.0).density(r, sun).value());
  EXPECT_EQ(ExponentialAtmosphere::vallado().density(r_eq).value(),
            ExponentialAtmosphere::vallado().density(r).value());
}
TEST(HarrisPriester, DecreasesUpwards) {
  const HarrisPriester model(3.0);
  const auto sun = towards(10.0, 40.0);
  double before = model.density(above(20.0, 90.0, 100.001), sun).value();
  for (double km = 101.0; km < 1000.0; km += 1.0) {
    const double here = model.density(above(20.0, 90.0, km), sun).value();
    EXPECT_LT(here, before) << km;
    EXPECT_GT(here, 0.85 * before) << km;
    const double just_above = model.density(above(20.0, 90.0, km + 1e-9), sun).value();
    EXPECT_NEAR(just_above, here, 1e-8 * here);
    before = here;
  }
}

TEST(HarrisPriester, RefusesWhatItDoesNotKnow) {
  const auto sun = towards(0.0, 0.0);
  EXPECT_EQ(
      complaint([] { (void)HarrisPriester(1.0); }),
      "HarrisPriester: the exponent is 1; it must be from 2, for a low inclination, to 6, for a polar orbit");
  EXPECT_THROW(HarrisPriester(6.1), BadInput);
  EXPECT_THROW(HarrisPriester{nan}, BadInput);
  const auto said = [&](double km) {
    return complaint([&] { (void)density(3.0, above(0.0, 0.0, km), sun); });
  };
  EXPECT_TRUE(vectrix_test::contains(said(50.0), "HarrisPriester: the height 50000"));
  EXPECT_TRUE(vectrix_test::contains(said(1001.0), "HarrisPriester: the height 1001000"));
  EXPECT_TRUE(vectrix_test::contains(said(1001.0), " m is outside the table, 100 to 1000 km"));
  const auto zero = vector<si::dimensionless>(in<Itrf>, Eigen::Vector3d::Zero());
  EXPECT_EQ(complaint([&] { (void)density(3.0, above(0.0, 0.0, 500.0), zero); }),
            "HarrisPriester::density(vector in " + frame_name<Itrf>() +
                "): |r| is 0; a zero vector has no direction");
}

template <class... Given>
concept HasDensity = requires(const HarrisPriester& model, const Given&... given) {
  { model.density(given...) } -> std::same_as<Quantity<si::density>>;
};
template <class A> using Position = Vector<A, si::length>;
template <class A, class S> using To = Displacement<Gcrf, S, In<A>>;
static_assert(HasDensity<Position<Itrf>, Position<Itrf>> && HasDensity<Position<Itrf>, To<Itrf, sky::Sun>>);
static_assert(HasDensity<Position<Itrf>, To<Itrf, sky::Image<sky::Sun, Apparent>>>);
static_assert(!HasDensity<Position<Itrf>, To<Gcrf, sky::Sun>> &&
              !HasDensity<Position<Gcrf>, To<Gcrf, sky::Sun>>);
static_assert(!HasDensity<Position<Itrf>, To<Itrf, sky::Moon>> && !HasDensity<Position<Itrf>>);

}  // namespace
}  // namespace vectrix::atmosphere_test
