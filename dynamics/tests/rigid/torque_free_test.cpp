#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <vectrix/dynamics/rigid/torque_free.hpp>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/rates/hat.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "craft/rigid_craft.hpp"
#include "draw.hpp"
#include "testing/trials.hpp"

namespace vectrix::test::torque_free_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// rad: three products of quaternions and two of theta functions. The phases add to it with the angle turned.
constexpr double attitude_rounding = 4e-15;
constexpr double rate_rounding = 2e-15;  // of the rate

using Motion = TorqueFree<Gcrf, Body>;

Motion motion(const Eigen::Vector3d& moments, const Eigen::Vector3d& w) {
  return torque_free(tensor(moments.x(), moments.y(), moments.z()),
                     state_at(0.0, Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), w));
}

// torque_free_hard_exact.csv: Taylor series of Euler's equation and of the quaternion's equation, to degree
// 60, in 100 digits (40 and 40 for 1e5 s). The inputs are exactly the doubles of torque_free_hard_cases.csv;
// another degree and step give the same 20 digits. These cases are difficult for closed forms: near, on and
// within a rounding of the separatrix, a start 1e-30 from the unstable axis, nearly equal moments, nearly
// pure spins, and a run of 1e5 s.
TEST(TorqueFree, AgreesWithTwentyDigitsInEveryRegime) {
  const std::string data = std::string(VECTRIX_SOURCE_DIR) + "/dynamics/tests/data/";
  const CsvTable cases = CsvTable::read(
      data + "torque_free_hard_cases.csv",
      {"case", "I11", "I22", "I33", "I12", "I13", "I23", "wx0", "wy0", "wz0", "q0", "q1", "q2", "q3"});
  const CsvTable exact = CsvTable::read(data + "torque_free_hard_exact.csv",
                                        {"case", "t_s", "wx", "wy", "wz", "q0", "q1", "q2", "q3"});
  std::map<std::string, Motion, std::less<>> motions;
  for (std::size_t row = 0; row < cases.rows(); ++row) {
    const auto number = [&](const char* name) { return cases.number(row, name); };
    motions.emplace(
        cases.text(row, "case"),
        torque_free(
            tensor(number("I11"), number("I22"), number("I33"), number("I12"), number("I13"), number("I23")),
            state_at(0.0, Eigen::Quaterniond(number("q0"), number("q1"), number("q2"), number("q3")),
                     {number("wx0"), number("wy0"), number("wz0")})));
  }
  ASSERT_EQ(motions.size(), 24U);
  for (std::size_t row = 0; row < exact.rows(); ++row) {
    const auto number = [&](const char* name) { return exact.number(row, name); };
    const BodyState found = motions.find(exact.text(row, "case"))->second.at(seconds(number("t_s")));
    const Eigen::Vector3d w(number("wx"), number("wy"), number("wz"));
    const Eigen::Quaterniond q(number("q0"), number("q1"), number("q2"), number("q3"));
    EXPECT_LE(angle_between(found.q_i_from_b.eigen(), q), attitude_rounding)
        << exact.text(row, "case") << " at " << number("t_s") << " s";
    EXPECT_LE((found.w_ib_b.coordinates() - w).norm(), rate_rounding * w.norm())
        << exact.text(row, "case") << " at " << number("t_s") << " s";
    EXPECT_EQ(found.time.value(), number("t_s"));
  }
}

/// q_b^i after `end` s, by the classical Runge-Kutta method in long double, in steps of 4e-4 s.
Eigen::Quaterniond integrated(const Eigen::Vector3d& moments, const Eigen::Vector3d& w0, double end) {
  using Real = long double;
  using Seven = Eigen::Matrix<Real, 7, 1>;  // q, scalar last, and w
  const Eigen::Matrix<Real, 3, 1> J = moments.cast<Real>();
  const auto rate = [&](const Seven& y) {
    const Eigen::Quaternion<Real> q(y(3), y(0), y(1), y(2));
    const Eigen::Matrix<Real, 3, 1> w = y.tail<3>(), h = J.cwiseProduct(w);
    Seven ydot;
    ydot << (q * Eigen::Quaternion<Real>(0, w.x(), w.y(), w.z())).coeffs() / 2, -w.cross(h).cwiseQuotient(J);
    return ydot;
  };
  const int steps = static_cast<int>(end / 4e-4);
  const Real h = static_cast<Real>(end) / steps;
  Seven y;
  y << -0.5L, 0.5L, 0.5L, 0.5L, w0.cast<Real>();
  for (int i = 0; i < steps; ++i) {
    const Seven a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b), d = rate(y + h * c);
    y += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return Eigen::Quaternion<Real>(y(3), y(0), y(1), y(2)).normalized().cast<double>();
}

// A turn changes as fast in a near sphere as in any body, but the phase of the Jacobi functions by little:
// the first must not be computed from the second.
TEST(TorqueFree, HoldsForEveryDifferenceOfTheMoments) {
  // The error of the reference, end |w|^5 h^4 / 120, and the roundings of both.
  constexpr double tolerance = 1e-13;
  std::mt19937_64 random(20261128);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (const int bits : vectrix_test::tried(std::vector{3, 8, 17, 26, 35, 44, 50, 52})) {
    const double less = std::ldexp(1.0, -bits), more = 3 * less;
    for (const Eigen::Vector3d& moments :
         {Eigen::Vector3d(1, 1 + less, 1 + more), Eigen::Vector3d(1 + less, 1 + more, 1),
          Eigen::Vector3d(1 + more, 1, 1 + less), Eigen::Vector3d(1 + more, 1 + 2 * less, 1)}) {
      for (int i = 0; i < vectrix_test::trials(4); ++i) {
        const Eigen::Vector3d w(number(random), number(random), number(random));
        const double end = 8.0;
        EXPECT_LE(angle_between(motion(moments, w).at(seconds(end)).q_i_from_b.eigen(),
                                integrated(moments, w, end)),
                  tolerance)
            << "differences of 2^-" << bits << ", w " << w.transpose();
      }
    }
  }
  const Eigen::Vector3d moments(1.0, 1 + std::ldexp(1.0, -52), 1 + 3 * std::ldexp(1.0, -52));
  const Eigen::Vector3d w(-0.081309025082797581, 1.8226509936367659, -0.32296814161923099);
  const double end = 7.6867399736902851;
  EXPECT_LE(
      angle_between(motion(moments, w).at(seconds(end)).q_i_from_b.eigen(), integrated(moments, w, end)),
      tolerance);
}

TEST(TorqueFree, TellsItsRegime) {
  const auto regime = [](double w1, double w2, double w3, double J3 = 2.25) {
    return motion({1.0, 2.0, J3}, {w1, w2, w3}).regime();
  };
  EXPECT_EQ(regime(0, 0, 0), Regime::at_rest);
  EXPECT_EQ(regime(1, 0, 0), Regime::steady);
  EXPECT_EQ(regime(0, -1, 0), Regime::steady);
  EXPECT_EQ(regime(0, 0.3, -1, 2.0), Regime::steady);  // in the plane of two equal moments
  // H^2 = 2 T J2, where J1 (J2 - J1) w1^2 = J3 (J3 - J2) w3^2
  EXPECT_EQ(regime(0.75, 0.4, -1), Regime::separatrix);
  EXPECT_EQ(regime(0.75, 0.4, -std::nextafter(1.0, 2.0)), Regime::short_axis);
  EXPECT_EQ(regime(std::nextafter(0.75, 1.0), 0.4, -1), Regime::long_axis);
  EXPECT_EQ(regime(1, 0.1, 0.1, 2.0), Regime::long_axis);
}

TEST(TorqueFree, ItsRateRepeatsAfterThePeriod) {
  // An axisymmetric body, J = (a, a, c): 2 pi / |n (1 - c/a)|.
  const AxisymmetricBody top;
  const Motion spun = torque_free(tensor(top.a, top.a, top.c), state_at(0.0, top.q0, top.w0));
  EXPECT_NEAR(spun.period().value(), 2.0 * std::numbers::pi / std::abs(0.5 * (1.0 - 1.5)), 1e-13);
  for (const double t : {-7.0, 1.0, 300.0}) {
    EXPECT_LE(error(spun.at(seconds(t)), top.exact(t)), 100.0 * attitude_rounding) << t;  // rounding of t w
  }

  for (const double w3 : {0.1, 0.9, 1.1, 3.0}) {
    const Motion any = motion({1.0, 2.0, 2.25}, {0.75, 0.4, w3});
    const double period = any.period().value();
    const auto now = any.at(seconds(2.0)).w_ib_b.coordinates();
    EXPECT_LE((any.at(seconds(2.0 + period)).w_ib_b.coordinates() - now).norm(), 20.0 * rate_rounding);
    EXPECT_GE((any.at(seconds(2.0 + period / 2.0)).w_ib_b.coordinates() - now).norm(), 0.1);
  }
  EXPECT_EQ(motion({1.0, 2.0, 2.25}, {0.75, 0.4, 1.0}).period().value(), infinity);
  EXPECT_EQ(motion({1.0, 2.0, 2.25}, {0.0, 0.0, 1.0}).period().value(), infinity);
}

// On the separatrix the spin approaches the intermediate axis, with all of the angular momentum, and stays
// there.
TEST(TorqueFree, EndsAtTheIntermediateAxisOnTheSeparatrix) {
  const Motion last_flip = motion({1.0, 2.0, 2.25}, {0.75, 0.4, 1.0});
  const double H = Eigen::Vector3d(0.75, 0.8, 2.25).norm();
  for (const double t : {1e3, 1e9, 1e300}) {
    EXPECT_LE((last_flip.at(seconds(t)).w_ib_b.coordinates() - Eigen::Vector3d(0, H / 2.0, 0)).norm(),
              4.0 * rate_rounding);
    EXPECT_LE((last_flip.at(seconds(-t)).w_ib_b.coordinates() - Eigen::Vector3d(0, -H / 2.0, 0)).norm(),
              4.0 * rate_rounding);
  }
}

// For any tensor in any axes and any state: the motion through one of its own states is the same motion;
// momentum and energy are constant; the motion at the start is the given state.
TEST(TorqueFree, IsAFlow) {
  constexpr double passed_on = 1e-12;  // rounding of the state, which grows over 30 rad
  Draw draw(20260101);
  for (int i = 0; i < 300; ++i) {
    // Principal moments of a box with sides a, b, c.
    const Eigen::Array3d side = draw.triple().array().square() + 0.01;
    const Eigen::Vector3d moments(side(1) + side(2), side(2) + side(0), side(0) + side(1));
    const Eigen::Matrix3d axes = draw.rotation();
    const Eigen::Matrix3d J = axes * moments.asDiagonal() * axes.transpose();
    const Eigen::Quaterniond q(draw.rotation());
    const Inertia<Body> J_b = tensor(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
    const BodyState start{seconds(5.0), attitude(q), rate_body(draw.triple())};
    const Motion first = torque_free(J_b, start);
    EXPECT_LE(error(first.at(seconds(5.0)), start), attitude_rounding);
    const BodyState middle = first.at(seconds(-6.0));
    const BodyState end = first.at(seconds(25.0));
    EXPECT_LE(error(torque_free(J_b, middle).at(seconds(25.0)), end), passed_on);
    const auto momentum = [&](const BodyState& state) {
      return (state.R_i_from_b() * (J_b * state.w_ib_b)).coordinates();
    };
    const Eigen::Vector3d h = momentum(start);
    EXPECT_LE((momentum(end) - h).norm(), 4.0 * attitude_rounding * h.norm());
    const double energy = kinetic_energy(J_b, start.w_ib_b).value();
    EXPECT_NEAR(kinetic_energy(J_b, end.w_ib_b).value(), energy, 10.0 * rate_rounding * energy);
  }
}

TEST(TorqueFree, IsWhatTheIntegratorFinds) {
  constexpr double integrated = 1e-11;  // tolerances of 1e-14 over 1e3 rad
  CraftPropagation how = rigid_craft::until(1000.0);
  how.relative_tolerance = 1e-14;
  how.absolute_tolerances.angle = 1e-14 * si::radian;
  const Inertia<Body> J_b = tensor(5.0, 4.0, 3.0, 0.4, -0.3, 0.2);
  const BodyState start = state_at(0.0, {0.5, 0.5, -0.5, 0.5}, {0.6, -0.7, 0.5});
  const rigid_craft::Turning craft(J_b);
  const auto trajectory = propagate(scenario(craft), rigid_craft::start_of(craft, start), how);
  const Motion motion = torque_free(J_b, start);
  for (const double t : {1.0, 77.7, 1000.0}) {
    EXPECT_LE(error(rigid_craft::body_state(trajectory.at(seconds(t))), motion.at(seconds(t))), integrated)
        << t;
  }
}

TEST(TorqueFree, IsAnEdgeWithRateAndAcceleration) {
  const Motion turning = motion({1.0, 2.0, 2.25}, {0.75, 0.4, 0.3});
  const auto graph = frame_graph(edge(turning));
  const double h = 1e-5;
  constexpr double difference_quotient = 1e-9;  // h^2 and rounding / h
  const auto matrix = [&](double t) { return dcm(turning.at(seconds(t)).q_i_from_b).matrix(); };
  const auto w = [&](double t) { return turning.at(seconds(t)).w_ib_b.coordinates(); };
  const auto now = graph.at(seconds(3.0));
  const Eigen::Matrix3d R = now.rotation(to<Gcrf>, from<Body>).matrix();
  const Eigen::Vector3d w_now = now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>).coordinates();
  EXPECT_EQ(R, matrix(3.0));
  EXPECT_LE((R * hat(w_now) - (matrix(3.0 + h) - matrix(3.0 - h)) / (2.0 * h)).norm(), difference_quotient);
  EXPECT_LE((now.angular_acceleration(of<Body>, relative_to<Gcrf>, in<Body>).coordinates() -
             (w(3.0 + h) - w(3.0 - h)) / (2.0 * h))
                .norm(),
            difference_quotient);
}

TEST(TorqueFree, TakesRatesOfEverySize) {
  for (const double scale : {1e-150, 1e-20, 1e20, 1e150}) {
    const auto unit = motion({1.0, 2.0, 2.25}, {0.75, 0.4, 0.3}).at(seconds(2.0));
    const auto scaled =
        motion({1.0, 2.0, 2.25}, scale * Eigen::Vector3d(0.75, 0.4, 0.3)).at(seconds(2.0 / scale));
    EXPECT_LE(angle_between(scaled.q_i_from_b.eigen(), unit.q_i_from_b.eigen()), attitude_rounding);
    EXPECT_LE((scaled.w_ib_b.coordinates() / scale - unit.w_ib_b.coordinates()).norm(), 2.0 * rate_rounding);
  }
}

TEST(TorqueFree, RefusesBadInput) {
  const BodyState start = state_at(0.0, Eigen::Quaterniond::Identity(), {0.1, 0.2, 0.3});
  const auto of_tensor = [&](double xx, double yy, double zz) {
    torque_free(trust_inertia(in<Body>, Eigen::Matrix3d(Eigen::Vector3d(xx, yy, zz).asDiagonal())), start);
  };
  expect_bad_input([&] { of_tensor(1.0, nan, 1.0); }, "an entry of the inertia tensor is not finite");
  expect_bad_input([&] { of_tensor(1.0, -2.0, 1.0); }, "the smallest principal moment is -2 kg m^2");
  expect_bad_input([&] { of_tensor(0.0, 2.0, 1.0); }, "the smallest principal moment is 0 kg m^2");
  const Inertia<Body> J = tensor(1.0, 2.0, 2.25);
  BodyState wrong = start;
  wrong.time = seconds(infinity);
  expect_bad_input([&] { torque_free(J, wrong); }, "the initial time is inf s");
  wrong = start;
  wrong.w_ib_b = AngularVelocity<Gcrf, Body, In<Body>>{detail::trusted, Eigen::Vector3d(0.0, nan, 1.0)};
  expect_bad_input([&] { torque_free(J, wrong); }, "the rate (0, nan, 1) rad/s is not finite");
  for (const double t : {nan, infinity}) {
    expect_bad_input([&] { torque_free(J, start).at(seconds(t)); }, "the time is ");
    expect_bad_input([&] { torque_free(J, start)(seconds(t)); }, "TorqueFree of ");
  }
}

}  // namespace
}  // namespace vectrix::test::torque_free_test
