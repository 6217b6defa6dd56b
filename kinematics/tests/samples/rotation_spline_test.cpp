#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <vectrix/kinematics/samples/rotation_spline.hpp>

#include "testing/motions.hpp"
#include "testing/trials.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rotation_spline_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Samples = std::vector<AttitudeSample<Gcrf, Body>>;
using Spline = RotationSpline<Gcrf, Body>;

constexpr auto longest_gap = 10.0 * si::second;
/// Turns of up to 1.5 rad in at least 0.5 s: rates of about 5 rad/s and accelerations of about 50 rad/s^2,
/// from a linear system with a condition number of about 3.
constexpr double rates_solved = 1e3 * epsilon;
constexpr double accelerations_solved = 1e4 * epsilon;

Quantity<si::time> seconds(double t) {
  return t * si::second;
}
Quaternion<Gcrf, Body> typed(const Quaterniond& q) {
  return nearest_quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z()).quaternion;
}
Quaterniond turn(const Vector3d& theta) {
  return Quaterniond(
      exp_quaternion(rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Body>, theta)))
          .eigen());
}
AngularVelocity<Gcrf, Body, In<Body>> rate(const Vector3d& w) {
  return angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w));
}
Vector3d w_of(const AcceleratingDcm<Gcrf, Body>& value) {
  return value.angular_velocity.coordinates();
}
Vector3d alpha_of(const AcceleratingDcm<Gcrf, Body>& value) {
  return value.angular_acceleration.coordinates();
}
Matrix3d R_of(const AcceleratingDcm<Gcrf, Body>& value) {
  return value.rotation.matrix();
}

/// Steps of 0.5 s to 1.5 s, each a turn of up to 1.5 rad.
Samples random_samples() {
  Samples list;
  double t = -3.0;
  Quaterniond q = *attitude();
  for (int i = 0; i < 6; ++i) {
    list.push_back({seconds(t), typed(q)});
    q = q * turn(1.5 / std::sqrt(3.0) * *triple());
    t += 1.0 + 0.5 * *coordinate();
  }
  return list;
}
Samples changed(const Samples& list, const Quaterniond& left, const Quaterniond& right) {
  Samples others;
  for (const auto& one : list) others.push_back({one.time, typed(left * one.q_a_from_b.eigen() * right)});
  return others;
}
double inside(const Samples& list) {
  const double first = list.front().time.value(), last = list.back().time.value();
  return first + (last - first) * (1 + *coordinate()) / 2;
}

RC_GTEST_PROP(RotationSpline, PassesThroughItsSamples, ()) {
  const auto list = random_samples();
  const Spline spline(list, longest_gap, natural_ends);
  for (const auto& one : list)
    RC_ASSERT(distance(R_of(spline(one.time)), dcm(one.q_a_from_b).matrix()) <= 4 * rounding);
}

// Rotation, rate and acceleration just before a sample equal those at the sample.
RC_GTEST_PROP(RotationSpline, IsTwiceDifferentiableAtItsSamples, ()) {
  const auto list = random_samples();
  const Spline spline(list, longest_gap, rate(*triple()), rate(*triple()));
  for (std::size_t i = 1; i + 1 < list.size(); ++i) {
    const double t = list[i].time.value();
    const auto here = spline(seconds(t)), before = spline(seconds(std::nextafter(t, -HUGE_VAL)));
    RC_ASSERT(distance(R_of(here), R_of(before)) <= 4 * rounding);
    RC_ASSERT(distance(w_of(here), w_of(before)) <= rates_solved);
    RC_ASSERT(distance(alpha_of(here), alpha_of(before)) <= accelerations_solved);
  }
}

// Rdot = R [w]x and alpha = d/dt w in b, by automatic differentiation.
RC_GTEST_PROP(RotationSpline, ItsRatesAreDerivatives, ()) {
  const auto list = random_samples();
  const auto dual = [](double x) { return Dual(x, Eigen::Matrix<double, 1, 1>(0.0)); };
  const auto time = [](const Dual& t) { return Quantity<si::time, Dual>::from_value(t); };
  std::vector<AttitudeSample<Gcrf, Body, Quantity<si::time, Dual>>> duals;
  for (const auto& one : list) {
    const auto [w, x, y, z] = one.q_a_from_b.scalar_first();
    duals.push_back({time(dual(one.time.value())),
                     quaternion_scalar_first(to<Gcrf>, from<Body>, dual(w), dual(x), dual(y), dual(z))});
  }
  const RotationSpline<Gcrf, Body, Quantity<si::time, Dual>> differentiable(duals, time(dual(10.0)),
                                                                            natural_ends);
  const double t = inside(list);
  const auto at = differentiable(time(Dual(t, 1, 0)));
  const auto rate_of = [](const Dual& x) { return x.derivatives()(0); };
  const Matrix3d Rdot = at.rotation.matrix().unaryExpr(rate_of);
  const Vector3d wdot = at.angular_velocity.coordinates().unaryExpr(rate_of);
  const auto here = Spline(list, longest_gap, natural_ends)(seconds(t));
  RC_ASSERT(distance(R_of(here) * hat(w_of(here)), Rdot) <= rates_solved);
  RC_ASSERT(distance(alpha_of(here), wdot) <= accelerations_solved);
}

// A constant change of a rotates R alone; one of b rotates the rates too; the signs of quaternions have no
// effect.
RC_GTEST_PROP(RotationSpline, AChangeOfEitherFrameTurnsTheSpline, ()) {
  const auto list = random_samples();
  const auto t = seconds(inside(list));
  const Quaterniond p = *attitude(), I = Quaterniond::Identity();
  const Matrix3d P = p.toRotationMatrix();
  const auto at = [&](const Samples& samples) { return Spline(samples, longest_gap, natural_ends)(t); };
  const auto plain = at(list), of_a = at(changed(list, p, I)), of_b = at(changed(list, I, p));
  RC_ASSERT(distance(R_of(of_a), P * R_of(plain)) <= rates_solved);
  RC_ASSERT(distance(w_of(of_a), w_of(plain)) <= rates_solved);
  RC_ASSERT(distance(alpha_of(of_a), alpha_of(plain)) <= accelerations_solved);
  RC_ASSERT(distance(R_of(of_b), R_of(plain) * P) <= rates_solved);
  RC_ASSERT(distance(w_of(of_b), P.transpose() * w_of(plain)) <= rates_solved);
  RC_ASSERT(distance(alpha_of(of_b), P.transpose() * alpha_of(plain)) <= accelerations_solved);
  Samples flipped = list;
  for (auto& one : flipped) {
    if (*rc::gen::arbitrary<bool>()) one.q_a_from_b = typed(Quaterniond(-one.q_a_from_b.eigen().coeffs()));
  }
  RC_ASSERT(distance(R_of(at(flipped)), R_of(plain)) <= rates_solved);
  RC_ASSERT(distance(w_of(at(flipped)), w_of(plain)) <= rates_solved);
}

// The spline of the inverse samples is the inverse motion.
RC_GTEST_PROP(RotationSpline, OfInversesIsTheInverse, ()) {
  const auto list = random_samples();
  const auto t = seconds(inside(list));
  std::vector<AttitudeSample<Body, Gcrf>> inverses;
  for (const auto& one : list) inverses.push_back({one.time, inverse(one.q_a_from_b)});
  const auto plain = Spline(list, longest_gap, natural_ends)(t);
  const auto back = inverse(RotationSpline<Body, Gcrf>(inverses, longest_gap, natural_ends)(t));
  RC_ASSERT(distance(R_of(back), R_of(plain)) <= rates_solved);
  RC_ASSERT(distance(w_of(back), w_of(plain)) <= rates_solved);
  RC_ASSERT(distance(alpha_of(back), alpha_of(plain)) <= accelerations_solved);
}

RC_GTEST_PROP(RotationSpline, TheEndsAreAsSaid, ()) {
  const auto list = random_samples();
  const Vector3d first = *triple(), last = *triple();
  const Spline natural(list, longest_gap, natural_ends);
  RC_ASSERT(alpha_of(natural(list.front().time)).norm() <= accelerations_solved);
  RC_ASSERT(alpha_of(natural(list.back().time)).norm() <= accelerations_solved);
  const Spline given(list, longest_gap, rate(first), rate(last));
  RC_ASSERT(distance(w_of(given(list.front().time)), first) <= rates_solved);
  RC_ASSERT(distance(w_of(given(list.back().time)), last) <= rates_solved);
}

// About one axis it is the cubic spline of the angle: of 0, 0, 1 at 0, 1, 2 s with natural ends alpha = 6/4
// t, then 6/4 (2 - t), and w(1) = 1/2.
TEST(RotationSpline, AboutOneAxisIsTheCubicSpline) {
  const Vector3d n = Vector3d(2, -1, 2) / 3;
  const Samples list{
      {seconds(0), typed(turn(0 * n))}, {seconds(1), typed(turn(0 * n))}, {seconds(2), typed(turn(n))}};
  const Spline spline(list, longest_gap, natural_ends);
  EXPECT_LE(distance(w_of(spline(seconds(0))), -0.25 * n), rounding);
  EXPECT_LE(distance(w_of(spline(seconds(1))), 0.5 * n), rounding);
  EXPECT_LE(distance(w_of(spline(seconds(2))), 1.25 * n), rounding);
  EXPECT_LE(distance(alpha_of(spline(seconds(0.5))), 0.75 * n), rounding);
  EXPECT_LE(distance(alpha_of(spline(seconds(1.25))), 1.125 * n), rounding);
  EXPECT_LE(distance(R_of(spline(seconds(0.5))), turn(-0.09375 * n).toRotationMatrix()), rounding);
}

TEST(RotationSpline, OfTwoSamplesWithNaturalEndsIsTheSlerp) {
  const Quaterniond q0 = turn({0.3, -2.0, 0.4}), q1 = turn({1.0, 0.5, -0.2});
  const Spline spline({{seconds(1), typed(q0)}, {seconds(3), typed(q1)}}, longest_gap, natural_ends);
  const Slerp<Gcrf, Body> slerp(seconds(1), typed(q0), seconds(3), typed(q1));
  EXPECT_LE(distance(R_of(spline(seconds(1.7))), slerp(seconds(1.7)).rotation.matrix()), rounding);
  EXPECT_LE(distance(w_of(spline(seconds(1.7))), slerp(seconds(1.7)).angular_velocity.coordinates()),
            rounding);
  EXPECT_LE(alpha_of(spline(seconds(1.7))).norm(), rounding);
}

/// The largest errors of R, w and alpha between `from` and `until`, of a spline through a smooth motion.
Vector3d errors(int steps, bool natural, double from, double until) {
  const auto at = [](double t) { return Motion<Gcrf, Body>(turning<Gcrf, Body>(0.4, instant(t))); };
  Samples list;
  for (int i = 0; i <= steps; ++i) {
    const double t = 2.0 * i / steps;
    list.push_back({seconds(t), quaternion(at(t).rotation())});
  }
  const auto spline = natural ? Spline(list, longest_gap, natural_ends)
                              : Spline(list, longest_gap, at(0.0).w_ab_b(), at(2.0).w_ab_b());
  Vector3d worst = Vector3d::Zero();
  for (int i = 0; i <= 8 * steps; ++i) {
    const double t = 2.0 * i / (8 * steps);
    if (t < from || t > until) continue;
    const auto here = spline(seconds(t));
    const auto there = at(t);
    worst = worst.cwiseMax(Vector3d(distance(R_of(here), there.R),
                                    distance(w_of(here), there.w_ab_b().coordinates()),
                                    distance(alpha_of(here), there.alpha_ab_b().coordinates())));
  }
  return worst;
}
/// The order, from halving the step once; it is reached to 0.1 or 0.2.
Vector3d order(bool natural, double from, double until) {
  const Vector3d coarse = errors(40, natural, from, until), fine = errors(80, natural, from, until);
  return {std::log2(coarse(0) / fine(0)), std::log2(coarse(1) / fine(1)), std::log2(coarse(2) / fine(2))};
}
constexpr double order_reached = 0.25;

TEST(RotationSpline, ConvergesInOrderFourThreeTwoWithGivenEnds) {
  EXPECT_LE(distance(order(false, 0.0, 2.0), Vector3d(4, 3, 2)), order_reached) << order(false, 0.0, 2.0);
}
TEST(RotationSpline, NaturalEndsCostTwoOrdersNextToThem) {
  EXPECT_LE(distance(order(true, 0.0, 2.0), Vector3d(2, 1, 0)), order_reached) << order(true, 0.0, 2.0);
  EXPECT_LE(distance(order(true, 0.7, 1.3), Vector3d(4, 3, 2)), order_reached) << order(true, 0.7, 1.3);
}

TEST(RotationSpline, IsAnAcceleratingEdge) {
  const Vector3d n = Vector3d::UnitY();
  const Samples list{
      {seconds(0), typed(turn(0 * n))}, {seconds(1), typed(turn(0 * n))}, {seconds(2), typed(turn(n))}};
  const auto graph = frame_graph(edge(RotationSpline(list, longest_gap, natural_ends)),
                                 rigid_edge(turned_x(to<Camera>, from<Body>, 0.5 * si::radian)));
  const auto alpha =
      graph.at(seconds(0.5)).angular_acceleration(of<Camera>, relative_to<Gcrf>, in<Body>).coordinates();
  EXPECT_LE(distance(alpha, 0.75 * n), rounding);
}

// A change of the unit of time, to 2^-400 s or 2^400 s, changes no digit of the attitude.
TEST(RotationSpline, HasTheSameAttitudesInAnyUnitOfTime) {
  const auto in_units_of = [](double unit) {
    Samples list;
    for (int i = 0; i < 5; ++i)
      list.push_back({seconds(unit * i), typed(turn(Vector3d(0.3 * i, 0.1 * i * i, -0.2 * i)))});
    return R_of(Spline(list, seconds(2.0 * unit), natural_ends)(seconds(1.5 * unit)));
  };
  for (const int power : {-400, 400})
    EXPECT_EQ(in_units_of(std::ldexp(1.0, power)), in_units_of(1.0)) << power;
}

TEST(RotationSpline, BadSamplesAreRefused) {
  const auto said = [](const Samples& list, double gap = 10.0) {
    return message<BadInput>([&] { Spline(list, seconds(gap), natural_ends); });
  };
  const auto at = [](double t, double angle = 0.0) {
    return AttitudeSample<Gcrf, Body>{seconds(t), typed(turn({angle, 0.0, 0.0}))};
  };
  const std::string place = detail::samples_place<Gcrf, Body>("RotationSpline") + ": ";
  EXPECT_EQ(said({}), place + "the number of samples is 0, at least 2 are needed");
  EXPECT_EQ(said({at(0)}), place + "the number of samples is 1, at least 2 are needed");
  EXPECT_EQ(said({at(0), at(1), at(1)}), place + "samples 1 and 2 have one time, 1 s");
  EXPECT_EQ(said({at(0), at(2), at(1)}),
            place + "the time of sample 2, 1 s, is before that of sample 1, 2 s");
  EXPECT_EQ(said({at(0), at(1e-200)}), place + "samples 0 and 1 are 1e-200 s apart");
  EXPECT_EQ(said({at(0), at(std::nan(""))}), place + "the time of sample 1 is nan s");
  EXPECT_EQ(said({at(-HUGE_VAL), at(0)}), place + "the time of sample 0 is -inf s");
  EXPECT_EQ(said({at(0), at(1), at(8)}, 5.0),
            place + "samples 1 and 2 are 7 s apart; the longest allowed is 5 s");
  EXPECT_EQ(said({at(0), at(5), at(10)}, 5.0), "");
  EXPECT_EQ(said({at(0), at(1)}, 0.0), place + "the longest gap is 0 s");
  EXPECT_EQ(said({at(0), at(1)}, HUGE_VAL), place + "the longest gap is inf s");
  EXPECT_TRUE(
      contains(said({at(0), at(1, std::numbers::pi)}), "samples 0 and 1 are half a turn apart, 3.14159"));
  EXPECT_EQ(said({at(0), at(1, std::numbers::pi - 1.01 * nearly_half_a_turn)}), "");
  EXPECT_NE(said({at(0), at(1, std::numbers::pi - 0.99 * nearly_half_a_turn)}), "");
  const Spline spline({at(10), at(14)}, longest_gap, natural_ends);
  const auto ask = [&](double t) { return message<BadInput>([&] { spline(seconds(t)); }); };
  EXPECT_EQ(ask(9.5), place + "the time 9.5 s is outside the samples, [10 s, 14 s]");
  EXPECT_TRUE(contains(ask(14.5), "outside") && contains(ask(std::nan("")), "time nan s is outside"));
  EXPECT_EQ(ask(10) + ask(14), "");
}

// In float the bound is that of a door: 16 roundings.
TEST(RotationSpline, HalfATurnInFloatIsRefused) {
  using Seconds = Quantity<si::time, float>;
  constexpr float rounding_of_turns = std::numeric_limits<float>::epsilon();
  const auto said = [](float angle) {
    const auto at = [](float t, float turned) {
      return AttitudeSample<Gcrf, Body, Seconds>{
          Seconds::from_value(t), quaternion_scalar_first(to<Gcrf>, from<Body>, std::cos(turned / 2),
                                                          std::sin(turned / 2), 0.0F, 0.0F)};
    };
    return message<BadInput>([&] {
      RotationSpline<Gcrf, Body, Seconds>({at(0.0F, 0.0F), at(1.0F, angle)}, Seconds::from_value(2.0F),
                                          natural_ends);
    });
  };
  constexpr float half_a_turn = std::numbers::pi_v<float>;
  EXPECT_TRUE(contains(said(half_a_turn - 8 * rounding_of_turns), "half a turn apart"));
  EXPECT_EQ(said(half_a_turn - 24 * rounding_of_turns), "");
}

// Turns of 3 rad about random axes after random times: for some of them the rates do not converge.
TEST(RotationSpline, RatesThatDoNotSettleAreRefused) {
  std::mt19937_64 random(20240605);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  constexpr int lists = vectrix_test::trials(100);
  std::vector<std::string> refusals;
  for (int trial = 0; trial < lists; ++trial) {
    Samples list;
    double t = 0.0;
    Quaterniond q = Quaterniond::Identity();
    for (int i = 0; i < 10; ++i) {
      list.push_back({seconds(t), typed(q)});
      q = q * turn(3.0 * Vector3d(number(random), number(random), number(random)).normalized());
      t += 1.1 + number(random);
    }
    const auto said = message<BadInput>([&] { Spline(list, longest_gap, natural_ends); });
    if (!said.empty()) {
      refusals.push_back(said);
      continue;
    }
    const Spline spline(list, longest_gap, natural_ends);  // finite, and twice differentiable
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      const auto here = spline(list[i].time);
      ASSERT_TRUE(w_of(here).allFinite() && alpha_of(here).allFinite()) << trial;
      if (i == 0) continue;
      const auto before = spline(seconds(std::nextafter(list[i].time.value(), -HUGE_VAL)));
      EXPECT_LE(distance(alpha_of(here), alpha_of(before)),
                accelerations_solved * (1 + alpha_of(here).norm()))
          << trial;
    }
  }
  EXPECT_GT(refusals.size(), 0U);
  EXPECT_LT(refusals.size(), std::size_t{lists});
  for (const auto& said : refusals)
    EXPECT_TRUE(contains(said, "the rates at the samples do not settle, they still change by ")) << said;
}

}  // namespace
}  // namespace rotation_spline_test
