#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/orbit/third_body.hpp>
#include <vectrix/space/sky/geocentric.hpp>

#include "temporary_file.hpp"

namespace vectrix::third_body_test {
namespace {

using earth::Gcrf;
using Eigen::Vector3d;

struct Ship : moving_frame {};

template <class Q> Displacement<Gcrf, Q, In<Gcrf>> at(const Vector3d& r) {
  return displacement(of<Q>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r));
}
template <class B> constexpr auto mu_of(double mu) {
  return gravitational_parameter(of<B>, Quantity<si::gravitational_parameter>::from_value(mu));
}

// Of 40 digits. Near the Earth the two attractions by the Sun differ by 1e-4 to 1e-5 of themselves.
struct Exact {
  double mu;
  Vector3d ship, body, a;
};
const std::vector<Exact> exact{
    {4902800118000.0,
     {3969510.0, -1036620.0, -1046040.0},
     {21415200.0, 282653000.0, -210601000.0},
     {-4.41780572504891465e-7, 1.1794641554245559e-7, 1.1458478326991428e-7}},
    {4902800118000.0,
     {18237500.0, 28171300.0, -771082.0},
     {429561000.0, 35621900.0, -9705930.0},
     {2.66539232677563435e-6, -1.65489378641478189e-6, -3.49621659274697416e-8}},
    {4902800118000.0,
     {-65718800.0, -199842000.0, -226277000.0},
     {132956000.0, -220176000.0, -82937800.0},
     {0.0000325413412587322171, 0.0000479821629322878056, 0.0000679082528055949838}},
    {1.3271244e+20,
     {-1281350.0, 276511.0, -5342340.0},
     {-143168000000.0, -21001500000.0, -15173400000.0},
     {-1.70961366829150054e-7, -4.50936422052719086e-8, 2.06240990299905891e-7}},
    {1.3271244e+20,
     {-21155600.0, -9996770.0, -50379400.0},
     {-6992920000.0, 20952700000.0, 66091700000.0},
     {0.0000140177626287239589, -0.0000132809624702112564, -0.0000345167689562420909}},
    {1.3271244e+20,
     {165227000.0, -330244000.0, 119784000.0},
     {-44321200000.0, -193309000000.0, -124906000000.0},
     {-2.74369320122940949e-6, -1.1102839206132973e-6, -4.1592998712798701e-6}}};

TEST(ThirdBody, FortyDigits) {
  constexpr double rounding = 1e-15;  // of some roundings
  for (const auto& [mu, ship, body, a] : exact) {
    const auto found = third_body_acceleration(mu_of<sky::Sun>(mu), at<Ship>(ship), at<sky::Sun>(body));
    EXPECT_LE((found.coordinates() - a).norm(), rounding * a.norm()) << body.transpose();
  }
}

// To first order in r/s: mu/s^3 (3 u (u.r) - r). The next order is r/s of it.
TEST(ThirdBody, NearTheCentreIsTheTide) {
  const Vector3d s(3e8, -2e8, 1e8), r(20.0, -50.0, 10.0), u = s.normalized();
  const auto found = third_body_acceleration(at<Ship>(r), at<sky::Moon>(s));
  const Vector3d tide = sky::moon_mu.value() / std::pow(s.norm(), 3) * (3 * u * u.dot(r) - r);
  EXPECT_LE((found.coordinates() - tide).norm(), 3.0 * r.norm() / s.norm() * tide.norm());
}

// The Moon raises a satellite at its distance by 1e-6 m/s^2 at 7000 km, the Sun by half of it.
TEST(ThirdBody, TakesSunAndMoon) {
  const auto t = Epoch::from_utc("2024-03-20T00:00:00");
  const auto r = at<Ship>(Vector3d(7e6, 0.0, 0.0));
  const auto sun = third_body_acceleration(r, geocentric(of<sky::Sun>, t).position);
  const auto moon = third_body_acceleration(r, geocentric(of<sky::Moon>, t).position);
  EXPECT_NEAR(norm(sun.vector()).value(), 5e-7, 3e-7);
  EXPECT_NEAR(norm(moon.vector()).value(), 1e-6, 6e-7);
}

// The mu of the Sun and of the Moon need not be said.
TEST(ThirdBody, KnowsSunAndMoon) {
  const auto r = at<Ship>(Vector3d(7e6, -2e6, 1e6));
  const Vector3d s(3e8, -2e8, 1e8);
  EXPECT_EQ(third_body_acceleration(r, at<sky::Sun>(s)).coordinates(),
            third_body_acceleration(gravitational_parameter(of<sky::Sun>, sky::sun_mu), r, at<sky::Sun>(s))
                .coordinates());
  EXPECT_EQ(third_body_acceleration(r, at<sky::Moon>(s)).coordinates(),
            third_body_acceleration(gravitational_parameter(of<sky::Moon>, sky::moon_mu), r, at<sky::Moon>(s))
                .coordinates());
}

TEST(ThirdBody, Refusals) {
  const Vector3d s(3e8, 0.0, 0.0);
  EXPECT_EQ(
      complaint([&] { (void)third_body_acceleration(at<Ship>(s), at<sky::Moon>(s)); }),
      "third_body_acceleration(" + frame_name<Ship>() +
          " relative to earth::Gcrf): mu is 4902800118000 m^3/s^2 and |r| 0 m; mu must be positive, mu/|r|^3 "
          "finite");
  EXPECT_THROW(
      (void)third_body_acceleration(mu_of<sky::Moon>(0.0), at<Ship>(Vector3d(1e6, 0, 0)), at<sky::Moon>(s)),
      BadInput);
  EXPECT_THROW((void)third_body_acceleration(at<Ship>(Vector3d(1e6, 0, 0)), at<sky::Moon>(Vector3d(0, 0, 0))),
               BadInput);
}

}  // namespace
}  // namespace vectrix::third_body_test
