#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vectrix/kinematics.hpp>
#include <vectrix/space/sky/iau_frames.hpp>

namespace vectrix::iau_frames_test {
namespace {

using earth::Gcrf;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double day = 86400.0;  // s

struct Base : moving_frame {};

template <class F, class B> struct Fixed {
  using Frame = F;
  using Centre = B;
};
using Sun = Fixed<sun::Iau, sky::Sun>;
using Mercury = Fixed<mercury::Iau, sky::Mercury>;
using Venus = Fixed<venus::Iau, sky::Venus>;
using Moon = Fixed<moon::Iau, sky::Moon>;
using Mars = Fixed<mars::Iau, sky::Mars>;
using Jupiter = Fixed<jupiter::Iau, sky::Jupiter>;
using Saturn = Fixed<saturn::Iau, sky::Saturn>;
using Uranus = Fixed<uranus::Iau, sky::Uranus>;
using Neptune = Fixed<neptune::Iau, sky::Neptune>;

template <class F> Eigen::Matrix3d R_at(const Epoch& t) {
  return iau_rotation(of<F>, t).rotation.matrix();
}
Eigen::Vector3d vee(const Eigen::Matrix3d& m) {
  return {m(2, 1), m(0, 2), m(1, 0)};
}

template <class B> struct OfABody : ::testing::Test {};
using All = ::testing::Types<Sun, Mercury, Venus, Moon, Mars, Jupiter, Saturn, Uranus, Neptune>;
TYPED_TEST_SUITE(OfABody, All);

// w_ab^b = vee(R^T Rdot), by differences of five points over h, whose error is h^4/30 of the fifth
// derivative: (w h)^4/30 of w. TDB runs by 3.3e-10 faster and slower than TAI in which h is measured.
TYPED_TEST(OfABody, RateIsTheDerivative) {
  using F = typename TypeParam::Frame;
  const auto t = Epoch::from_tt("2021-05-06T07:08:09");
  const auto now = iau_rotation(of<F>, t);
  const Eigen::Vector3d w = now.angular_velocity.coordinates();
  const double h = 1e-2 / w.norm();
  const auto at = [&](double k) { return R_at<F>(t + k * h * si::second); };
  const Eigen::Matrix3d Rdot = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * h);
  const Eigen::Vector3d expected = vee(now.rotation.matrix().transpose() * Rdot);
  constexpr double truncation = 1e-8 / 30.0, slow_clock = 4e-10, rounding = 1e-10;
  EXPECT_LT((w - expected).norm(), (truncation + slow_clock + rounding) * w.norm());
}

// alpha_ab^b = d/dt w_ab^b, by the same differences; the fastest terms are four times as fast as w. The Sun,
// Venus and Uranus turn evenly.
TYPED_TEST(OfABody, AccelerationIsTheDerivativeOfTheRate) {
  using F = typename TypeParam::Frame;
  const auto t = Epoch::from_tt("2021-05-06T07:08:09");
  const auto now = iau_rotation(of<F>, t);
  const double rate = now.angular_velocity.coordinates().norm(), h = 0.03 / rate;
  const auto w = [&](double k) -> Eigen::Vector3d {
    return iau_rotation(of<F>, t + k * h * si::second).angular_velocity.coordinates();
  };
  const Eigen::Vector3d expected = (8.0 * (w(1) - w(-1)) - (w(2) - w(-2))) / (12.0 * h);
  const Eigen::Vector3d alpha = now.angular_acceleration.coordinates();
  constexpr double truncation = 0.12 * 0.12 * 0.12 * 0.12 / 30.0, roundings = 20.0 * 1.1e-16;
  EXPECT_LT((alpha - expected).norm(), truncation * alpha.norm() + roundings * rate / h);
}

// Published (NASA's planetary fact sheets): the obliquity, in degrees, and the sidereal period, in hours; the
// Sun's is that of Carrington, Neptune's that of the report. The north pole is that of the invariable plane.
template <class B> void turns(double obliquity, double hours) {
  const auto t = Epoch::from_tt("2000-01-01T12:00:00");
  const auto now = iau_rotation(of<typename B::Frame>, t);
  if constexpr (!std::same_as<B, Sun>) {
    const auto about = [&](auto centre) { return geocentric(centre, t); };
    const auto body = about(of<typename B::Centre>);
    const auto sun = about(of<sky::Sun>);
    const Eigen::Vector3d r = body.position.coordinates() - sun.position.coordinates();
    const Eigen::Vector3d v = body.velocity.coordinates() - sun.velocity.coordinates();
    const Eigen::Vector3d pole = now.rotation.matrix().col(2);
    constexpr double printed = 0.02;
    EXPECT_NEAR(std::acos(pole.dot(r.cross(v).normalized())) / degree, obliquity, printed);
  }
  constexpr double printed = 1e-3;
  const double rate = now.angular_velocity.coordinates().z();
  EXPECT_NEAR(2.0 * std::numbers::pi / rate / 3600.0 / hours, 1.0, printed);
}
TEST(IauFrames, HaveThePublishedPolesAndPeriods) {
  turns<Sun>(0.0, 609.12);
  turns<Mercury>(0.034, 1407.6);
  turns<Venus>(180.0 - 177.36, -5832.6);
  turns<Mars>(25.19, 24.6229);
  turns<Jupiter>(3.13, 9.9250);
  turns<Saturn>(26.73, 10.656);
  turns<Uranus>(180.0 - 97.77, -17.24);
  turns<Neptune>(28.32, 15.9663);
}

// Where the line from the body's centre to the Sun or the Earth leaves it, deg; that to the Earth when the
// light leaves it.
struct Place {
  double latitude, longitude;
};
template <class F> Place place(const Eigen::Vector3d& r_gcrf, const Epoch& t) {
  const Eigen::Vector3d n = R_at<F>(t).transpose() * r_gcrf.normalized();
  return {std::asin(n.z()) / degree, std::atan2(n.y(), n.x()) / degree};
}
template <class B> Place below_the_earth(const Epoch& t) {
  constexpr double light = 299792458.0;
  const double away = norm(geocentric(of<typename B::Centre>, t).position).value();
  const auto left = t - away / light * si::second;
  const Eigen::Vector3d way = geocentric(of<sky::Sun>, t).position.coordinates() -
                              geocentric(of<sky::Sun>, left).position.coordinates();
  return place<typename B::Frame>(way - geocentric(of<typename B::Centre>, left).position.coordinates(),
                                  left);
}
template <class B> Place below_the_sun(const Epoch& t) {
  return place<typename B::Frame>(geocentric(of<sky::Sun>, t).position.coordinates() -
                                      geocentric(of<typename B::Centre>, t).position.coordinates(),
                                  t);
}

// CSPICE's rotation and its derivative per day from IAU_MOON to J2000 at 14,610 days TDB after 2000, from the
// figures of pck00011.tpc.
TEST(IauFrames, MoonIsThatOfSpice) {
  const auto t = Epoch::from_julian_date(scale::tdb, 2451545.0, 14610.0);
  Eigen::Matrix3d R;
  Eigen::Matrix3d Rdot;
  R << 0.5720547105837333, 0.8198082524397307, -0.025842548842481546,  //
      -0.761073769862349, 0.5187960000245592, -0.38938082539594815,    //
      -0.30581060303147345, 0.2424152214491336, 0.9207142528946177;
  Rdot << 0.18855164996747234, -0.13156983000119996, -6.688769342283353e-06,  //
      0.11933846256680424, 0.17502552166445587, -5.863938867503373e-05,       //
      0.05570927164739238, 0.07037302263184936, -2.4987023214960146e-05;
  const auto found = iau_rotation(of<moon::Iau>, t);
  constexpr double rounding = 1e-11;  // of an angle of 1.9e5 deg, and of the clock
  EXPECT_LT((found.rotation.matrix() - R).norm(), rounding);
  const Eigen::Vector3d w = vee(R.transpose() * Rdot) / day;
  EXPECT_LT((found.angular_velocity.coordinates() - w).norm(), rounding * w.norm());
}

// x is defined by the mean Earth: libration takes the Earth up to 8.1 deg away in longitude and 6.9 in
// latitude. The mean is over a turn of the node, 18.6 years.
TEST(IauFrames, TheMoonFacesTheEarth) {
  const auto span = from_until(Epoch::from_tt("2000-01-01T00:00:00"), 6798.4 * day * si::second);
  Place mean{0.0, 0.0}, largest{0.0, 0.0};
  const auto epochs = every((span.end() - span.start()) / 800.0, span);
  for (const Epoch& t : epochs) {
    const auto p = place<moon::Iau>(-geocentric(of<sky::Moon>, t).position.coordinates(), t);
    mean.latitude += p.latitude / static_cast<double>(epochs.size());
    mean.longitude += p.longitude / static_cast<double>(epochs.size());
    largest.latitude = std::max(largest.latitude, std::abs(p.latitude));
    largest.longitude = std::max(largest.longitude, std::abs(p.longitude));
  }
  constexpr double sampling = 0.02;  // deg: 800 samples do not end with a month
  EXPECT_NEAR(mean.latitude, 0.0, sampling);
  EXPECT_NEAR(mean.longitude, 0.0, sampling);
  EXPECT_LT(largest.longitude, 8.1);
  EXPECT_GT(largest.longitude, 7.0);
  EXPECT_LT(largest.latitude, 6.9);
  EXPECT_GT(largest.latitude, 6.5);
}

// Meeus, Astronomical Algorithms, example 29.a: 1992 October 13, 0 h TD, B0 = 5.99 deg, L0 = 238.63 deg.
TEST(IauFrames, TheSunTurnsByCarrington) {
  const auto p = below_the_earth<Sun>(Epoch::from_tt("1992-10-13T00:00:00"));
  EXPECT_NEAR(p.latitude, 5.99, 0.01);
  EXPECT_NEAR(p.longitude + 360.0, 238.63, 0.01);
}

// Meeus, example 42.a: Mars on 1992 November 9, 0 h UT, D_E = 12.44 deg, D_S = -2.76 deg and the central
// meridian 111.55 deg west, with the elements of that time: since then pole and meridian have moved by 0.3
// deg.
TEST(IauFrames, MarsTurnsAsInMeeus) {
  const auto t = Epoch::from_utc("1992-11-09T00:00:00");
  constexpr double old_elements = 0.3;
  EXPECT_NEAR(below_the_earth<Mars>(t).latitude, 12.44, old_elements);
  EXPECT_NEAR(-below_the_earth<Mars>(t).longitude, 111.55, old_elements);
  EXPECT_NEAR(below_the_sun<Mars>(t).latitude, -2.76, old_elements);
}

// Meeus, examples 43.a and 45.a, 1992 December 16, 0 h UT: the Earth over Jupiter's equator, D_E = -2.48 deg,
// the Sun, D_S = -2.20; the Earth over Saturn's rings, B = 16.442 deg, the Sun, B' = 14.679 deg.
TEST(IauFrames, JupiterAndSaturnInclineAsInMeeus) {
  const auto t = Epoch::from_utc("1992-12-16T00:00:00");
  constexpr double printed = 0.01, places_of_the_planets = 0.03;
  EXPECT_NEAR(below_the_earth<Jupiter>(t).latitude, -2.48, printed + places_of_the_planets);
  EXPECT_NEAR(below_the_sun<Jupiter>(t).latitude, -2.20, printed + places_of_the_planets);
  EXPECT_NEAR(below_the_earth<Saturn>(t).latitude, 16.442, places_of_the_planets);
  EXPECT_NEAR(below_the_sun<Saturn>(t).latitude, 14.679, places_of_the_planets);
}

// Mercury turns three times in two years, so that at perihelion the Sun is over the prime meridian or
// opposite to it: over longitude 0 or 180, within its libration and the older definition by a crater, 0.2
// deg.
TEST(IauFrames, MercuryTurnsItsMeridianToTheSunAtPerihelion) {
  const auto distance = [](const Epoch& t) {
    return (geocentric(of<sky::Mercury>, t).position.coordinates() -
            geocentric(of<sky::Sun>, t).position.coordinates())
        .norm();
  };
  Epoch perihelion = Epoch::from_tt("2010-01-01T00:00:00");
  for (const Epoch& t : every(0.25 * day * si::second, from_until(perihelion, 88.0 * day * si::second))) {
    if (distance(t) < distance(perihelion)) perihelion = t;
  }
  EXPECT_NEAR(std::sin(below_the_sun<Mercury>(perihelion).longitude * degree) / degree, 0.0, 0.2);
  EXPECT_LT(std::abs(below_the_sun<Mercury>(perihelion).latitude), 0.05);
}

// Published: the equinox of Uranus, 2007 December. The Sun moves by 0.012 deg a day there.
TEST(IauFrames, UranusHadItsEquinoxIn2007) {
  EXPECT_NEAR(below_the_sun<Uranus>(Epoch::from_tt("2007-12-10T00:00:00")).latitude, 0.0, 0.15);
}

// The origin is the body's centre; a place that is fixed to the body moves with w x r.
TEST(IauFrames, MoveWithTheirBody) {
  const auto t = Epoch::from_tt("2021-05-06T07:08:09");
  const auto h = 10.0 * si::second;
  const Ephemeris<sky::Moon> moon(from_until(t - h, t + h));
  const auto r_base = vector<si::length>(in<moon::Iau>, Eigen::Vector3d(1e6, 1e6, 1e6));
  const auto graph = frame_graph(
      edge([&](const Epoch& at) { return iau_motion(of<moon::Iau>, moon, at); }),
      rigid_edge(Transform<moon::Iau, Base>{aligned(to<moon::Iau>, from<Base>),
                                            displacement(of<Base>, relative_to<moon::Iau>, r_base)}));
  const auto at = [&](const Epoch& epoch) {
    return graph.at(epoch).position(of<Base>, relative_to<Gcrf>, in<Gcrf>).coordinates();
  };
  const auto now = graph.at(t);
  const auto centre = now.position(of<moon::Iau>, relative_to<Gcrf>, in<Gcrf>);
  EXPECT_EQ(centre.coordinates(), moon.motion(t).position.coordinates());
  const Eigen::Vector3d v =
      now.velocity(of<Base>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>).coordinates();
  // m/s: of positions of 4e8 m over 20 s; h^2/6 of the third derivative, 1e3 m/s (2.7e-6/s)^2
  constexpr double rounding = 4e8 * 1.1e-16 * 4.0 / 20.0, truncation = 100.0 / 6.0 * 1e3 * 7.3e-12;
  const Eigen::Vector3d moved = at(t + h) - at(t - h);
  EXPECT_LT((moved / (2.0 * h.value()) - v).norm(), rounding + truncation);
  EXPECT_GT((v - moon.motion(t).velocity.coordinates()).norm(), 1.0);  // w x r is 4 m/s
}

template <class F>
concept Turns = requires(const Epoch& t) {
  { iau_rotation(of<F>, t) } -> std::same_as<AcceleratingDcm<Gcrf, F>>;
};
static_assert(Turns<mars::Iau> && Turns<sun::Iau>);
static_assert(!Turns<sky::Mars> && !Turns<earth::Itrf>);
template <class F, class B>
concept Moves = requires(const Ephemeris<B>& body, const Epoch& t) {
  { iau_motion(of<F>, body, t) } -> std::same_as<MovingTransform<Gcrf, F>>;
};
static_assert(Moves<mars::Iau, sky::Mars> && !Moves<mars::Iau, sky::Venus>);

}  // namespace
}  // namespace vectrix::iau_frames_test
