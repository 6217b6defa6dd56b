#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <erfa.h>
#include <erfam.h>

#include <Eigen/Geometry>
#include <cmath>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>
#include <vectrix/space/earth/mean_of_date.hpp>

namespace vectrix::intermediate_frames_test {
namespace {

using earth::Gcrf, earth::Cirf, earth::Tirf, earth::Itrf, earth::MeanOfDate;
using Eigen::Matrix3d, Eigen::Vector3d;
using Rows = double[3][3];

constexpr double rounding = 1e-15;        // of a matrix element
constexpr double angle_rounding = 3e-14;  // rad: eraEra00 at 27 turns, in 2027, twice

Matrix3d matrix_of(const Rows& rows) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&rows[0][0]);
}
double largest(const Matrix3d& m) {
  return m.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

rc::Gen<double> part() {
  return rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'001), [](int i) { return i * 1e-6; });
}
Epoch any_epoch() {
  return Epoch::from_tt("2000-01-01T12:00:00") + *part() * 27.0 * ERFA_DJY * ERFA_DAYSEC * si::second;
}
// Larger than observed, so that a wrong sign shows.
EarthOrientationParameters any_parameters(const Epoch& epoch) {
  const auto angle = [](double largest) { return *part() * largest * si::radian; };
  const auto rate = [](double largest) { return *part() * largest * (si::radian / si::second); };
  return {angle(4e-6),
          angle(4e-6),
          0.9 * *part() * si::second - epoch.tai_minus_utc(),
          Quantity<si::dimensionless>{*part() * 1e-7},
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

// d/dt R_a^b = R_a^b [w_ab^b]x: the turn over two hours, or minutes, against the rate in the middle.
template <class Edge>
double rate_error(Edge edge, const Epoch& t, const EarthOrientationParameters& p, double h) {
  const auto at = [&](double seconds) -> Matrix3d {
    return edge(t + seconds * si::second, later(p, seconds)).rotation.matrix();
  };
  const Matrix3d turn = at(-h).transpose() * at(h);
  const Vector3d twice_sine(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double sine = 0.5 * twice_sine.norm();
  const double per_sine = sine < 1e-3 ? 1.0 + sine * sine / 6.0 : std::asin(sine) / sine;
  return (per_sine * twice_sine / (4.0 * h) - edge(t, p).angular_velocity.coordinates()).norm();
}

RC_GTEST_PROP(IntermediateFrames, RatesAreTheDerivatives, ()) {
  const Epoch t = any_epoch();
  const auto p = any_parameters(t);
  // h^2/6 of the third derivative of the nutations of 5 to 14 days, in both coordinates, where they add up.
  // The rate itself is 1e-14 rad/s and more.
  constexpr double hour = 3600.0, pole_error = 1e-15;
  RC_ASSERT(rate_error(gcrf_from_cirf, t, p, hour) <= pole_error);
  RC_ASSERT(rate_error(tirf_from_itrf, t, p, hour) <= pole_error);
  constexpr double minute = 60.0;
  RC_ASSERT(rate_error(cirf_from_tirf, t, p, minute) <= (angle_rounding + 4 * rounding) / minute);
  // The turn of the rates that are 100 times too large, over the minute.
  RC_ASSERT(rate_error(earth_rotation, t, p, minute) <= angle_rounding / minute + 1e-14);
}

// The definition of the celestial intermediate origin, up to the observed offsets.
RC_GTEST_PROP(IntermediateFrames, CirfDoesNotTurnAboutItsPole, ()) {
  const Epoch t = any_epoch();
  auto p = any_parameters(t);
  p.dX = p.dY = 0.0 * si::radian;
  p.dX_rate = p.dY_rate = 0.0 * (si::radian / si::second);
  const Vector3d w = gcrf_from_cirf(t, p).angular_velocity.coordinates();
  // eraS06 leaves out terms of s below 0.1 microarcsec, some of them in eraXy06: 5e-13 rad in five days is
  // 7e-18 rad/s, and seven of them may add up. The pole itself moves by 1e-14 rad/s and more.
  constexpr double left_out = 5e-17;  // rad/s
  RC_ASSERT(std::abs(w.z()) <= left_out);
  RC_ASSERT(w.norm() >= 100 * left_out);
}

RC_GTEST_PROP(MeanOfDate, IsErfasAndNutationIsWhatIsMissing, ()) {
  const Epoch t = any_epoch();
  const auto tt = t.tt_date();
  Rows rows;
  eraPmat06(tt.day, tt.fraction, rows);
  const Matrix3d mean = mean_of_date_from_gcrf(t).matrix();
  RC_ASSERT(largest(mean - matrix_of(rows)) <= rounding);
  eraNum06a(tt.day, tt.fraction, rows);
  const Dcm<earth::TrueOfDate, MeanOfDate> nutation =
      true_of_date_from_gcrf(t) * inverse(mean_of_date_from_gcrf(t));
  RC_ASSERT(largest(nutation.matrix() - matrix_of(rows)) <= rounding);
  constexpr double arcsecond = 4.84813681109536e-6;  // rad
  RC_ASSERT(Eigen::AngleAxisd(nutation.matrix()).angle() < 21.0 * arcsecond);
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
