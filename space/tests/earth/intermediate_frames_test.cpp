#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <erfa.h>
#include <erfam.h>

#include <Eigen/Geometry>
#include <cmath>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>

#include "earth/any_epoch.hpp"

namespace vectrix::intermediate_frames_test {
namespace {

using earth::Gcrf, earth::Cirf, earth::Tirf, earth::Itrf;
using earth_test::any_epoch, earth_test::any_part, earth_test::largest, earth_test::matrix_of,
    earth_test::Rows;
using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double rounding = 1e-15;  // of a matrix element
// rad, of eraEra00 in 2027: half a unit in the last place of the days, 2.5e-15 turns of 27, of two
// sums, 1.8e-15 turns each, and of 2 pi times them, 1.4e-14 rad.
constexpr double angle_rounding = 5.2e-14;

// Larger than observed, so that a wrong sign shows.
EarthOrientationParameters any_parameters(const Epoch& epoch) {
  const auto angle = [](double largest) { return any_part() * largest * si::radian; };
  const auto rate = [](double largest) { return any_part() * largest * (si::radian / si::second); };
  return {angle(4e-6),
          angle(4e-6),
          0.89 * any_part() * si::second - epoch.tai_minus_utc(),
          Quantity<si::dimensionless>{any_part() * 1e-7},
          angle(5e-9),
          angle(5e-9),
          rate(1e-9),
          rate(1e-9),
          rate(1e-11),
          rate(1e-11)};
}
// What the parameters are a little later.
EarthOrientationParameters later(EarthOrientationParameters p, double seconds) {
  const auto h = seconds * si::second;
  p.pole_x = p.pole_x + p.pole_x_rate.value() * seconds * si::radian;
  p.pole_y = p.pole_y + p.pole_y_rate.value() * seconds * si::radian;
  p.dX = p.dX + p.dX_rate.value() * seconds * si::radian;
  p.dY = p.dY + p.dY_rate.value() * seconds * si::radian;
  p.ut1_minus_tai = p.ut1_minus_tai + p.ut1_gain.value() * h;
  return p;
}

RC_GTEST_PROP(IntermediateFrames, AreErfas, ()) {
  const Epoch t = any_epoch();
  const auto p = any_parameters(t);
  const auto tt = t.tt_date();
  const auto ut1 = t.julian_date(scale::Ut1::minus_tai(p.ut1_minus_tai));
  double x = 0.0;
  double y = 0.0;
  eraXy06(tt.day, tt.fraction, &x, &y);
  Rows rows;
  eraC2ixys(x + p.dX.value(), y + p.dY.value(), eraS06(tt.day, tt.fraction, x, y), rows);
  const Matrix3d cirf_from_gcrf = matrix_of(rows);
  RC_ASSERT(largest(inverse(gcrf_from_cirf(t, p).rotation).matrix() - cirf_from_gcrf) <= rounding);
  const Matrix3d turn =
      Eigen::AngleAxisd(-eraEra00(ut1.day, ut1.fraction), Vector3d::UnitZ()).toRotationMatrix();
  RC_ASSERT(largest(inverse(cirf_from_tirf(t, p).rotation).matrix() - turn) <= rounding);
  eraPom00(p.pole_x.value(), p.pole_y.value(), eraSp00(tt.day, tt.fraction), rows);
  RC_ASSERT(largest(inverse(tirf_from_itrf(t, p).rotation).matrix() - matrix_of(rows)) <= rounding);
}

RC_GTEST_PROP(IntermediateFrames, ChainIsTheRotationOfTheEarth, ()) {
  const Epoch t = any_epoch();
  const auto p = any_parameters(t);
  const auto whole = earth_rotation(t, p);
  const auto chain = gcrf_from_cirf(t, p) * cirf_from_tirf(t, p) * tirf_from_itrf(t, p);
  RC_ASSERT(largest(whole.rotation.matrix() - chain.rotation.matrix()) <= rounding);
  RC_ASSERT((whole.angular_velocity.coordinates() - chain.angular_velocity.coordinates()).norm() <=
            rounding * 7.3e-5);

  const auto tt = t.tt_date();
  const auto ut1 = t.julian_date(scale::Ut1::minus_tai(p.ut1_minus_tai));
  double x = 0.0;
  double y = 0.0;
  eraXy06(tt.day, tt.fraction, &x, &y);
  Rows cirs;
  Rows polar_motion;
  Rows all;
  eraC2ixys(x + p.dX.value(), y + p.dY.value(), eraS06(tt.day, tt.fraction, x, y), cirs);
  eraPom00(p.pole_x.value(), p.pole_y.value(), eraSp00(tt.day, tt.fraction), polar_motion);
  eraC2tcio(cirs, eraEra00(ut1.day, ut1.fraction), polar_motion, all);
  RC_ASSERT(largest(inverse(whole.rotation).matrix() - matrix_of(all)) <= rounding);
}

// The mean rate from t - h to t + h, from the turn of R_a^b, in b.
template <class Edge>
Vector3d mean_rate(Edge edge, const Epoch& t, const EarthOrientationParameters& p, double h) {
  const auto at = [&](double seconds) -> Matrix3d {
    return edge(t + seconds * si::second, later(p, seconds)).rotation.matrix();
  };
  const Matrix3d turn = at(-h).transpose() * at(h);
  const Vector3d twice_sine(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double sine = 0.5 * twice_sine.norm();
  const double per_sine = sine < 1e-3 ? 1.0 + sine * sine / 6.0 : std::asin(sine) / sine;
  return per_sine * twice_sine / (4.0 * h);
}
// d/dt R_a^b = R_a^b [w_ab^b]x: two mean rates, without their error of the order h^2. An error e of the turn
// becomes 1.5 e/h.
template <class Edge>
double rate_error(Edge edge, const Epoch& t, const EarthOrientationParameters& p, double h) {
  const Vector3d w = (4.0 * mean_rate(edge, t, p, h) - mean_rate(edge, t, p, 2.0 * h)) / 3.0;
  return (w - edge(t, p).angular_velocity.coordinates()).norm();
}

RC_GTEST_PROP(IntermediateFrames, RatesAreTheDerivatives, ()) {
  const Epoch t = any_epoch();
  const auto p = any_parameters(t);
  constexpr double hour = 3600.0, ten_minutes = 600.0;
  // The rate of the pole is a difference over 864 s to both sides: 864^2/6 of the third derivative of ERFA's
  // X and Y, which reaches 1.6e-22 rad/s^3 from 1973 to 2027, and half as much again.
  constexpr double of_pole = 1.5 * 864.0 * 864.0 / 6.0 * 1.6e-22;
  RC_ASSERT(rate_error(gcrf_from_cirf, t, p, hour) <= of_pole);
  // s' is taken as constant, 47 microarcsec a century.
  RC_ASSERT(rate_error(tirf_from_itrf, t, p, hour) <= 1e-19);
  RC_ASSERT(rate_error(cirf_from_tirf, t, p, hour) <= 1.5 * angle_rounding / hour);
  // In axes that turn by x from the middle to each end, a motion of the pole at the rate v across the axis
  // gives the mean rate v x cot x = v (1 - x^2/3 - x^4/45 - ...), of which 4/45 x^4 v are left. It is largest
  // for the motion in the Earth, given above; that of X and Y is 1.5e-11 rad/s and gives 7/90.
  constexpr double x = 7.2921150e-5 * ten_minutes;
  const double of_order =
      4.0 / 45.0 * std::pow(x, 4) * (std::hypot(p.pole_x_rate.value(), p.pole_y_rate.value()) + 1.5e-11);
  RC_ASSERT(rate_error(earth_rotation, t, p, ten_minutes) <=
            1.5 * angle_rounding / ten_minutes + of_pole + of_order);
}

// The definition of the celestial intermediate origin, up to the observed offsets. eraS06 leaves out terms
// below 0.1 microarcsec, so that CIRF turns by less than a microarcsec a day.
RC_GTEST_PROP(IntermediateFrames, CirfDoesNotTurnAboutItsPole, ()) {
  const Epoch t = any_epoch();
  auto p = any_parameters(t);
  p.dX = p.dY = 0.0 * si::radian;
  p.dX_rate = p.dY_rate = 0.0 * (si::radian / si::second);
  constexpr double microarcsec_a_day = 5.6e-17;  // rad/s
  RC_ASSERT(std::abs(gcrf_from_cirf(t, p).angular_velocity.coordinates().z()) <= microarcsec_a_day);
}

TEST(IntermediateFrames, AreEdgesOfAGraph) {
  const Epoch t = Epoch::from_utc("2022-04-14T10:22:11");
  EarthOrientationParameters p{};
  p.ut1_minus_tai = -37.1 * si::second;
  const auto graph = frame_graph(edge([&](const Epoch& e) { return gcrf_from_cirf(e, p); }),
                                 edge([&](const Epoch& e) { return cirf_from_tirf(e, p); }),
                                 edge([&](const Epoch& e) { return tirf_from_itrf(e, p); }));
  const auto now = graph.at(t);
  EXPECT_LE(largest(now.rotation(to<Gcrf>, from<Itrf>).matrix() - earth_rotation(t, p).rotation.matrix()),
            rounding);
  EXPECT_LE((now.angular_velocity(of<Itrf>, relative_to<Gcrf>, in<Itrf>).coordinates() -
             earth_rotation(t, p).angular_velocity.coordinates())
                .norm(),
            rounding * 7.3e-5);
}

}  // namespace
}  // namespace vectrix::intermediate_frames_test
