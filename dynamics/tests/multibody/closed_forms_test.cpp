#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <vectrix/dynamics/multibody/tree.hpp>

#include "random_craft.hpp"

// Motions whose equations can be written down.
namespace vectrix_test::closed_forms_test {
namespace {

/// Some hundred operations on numbers of order 1, each half a spacing.
constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();
/// Of numbers up to some 30: weights, moments, products of rates.
constexpr double rounding_of_30 = 30 * rounding;

mb::Mass<double> balanced(double m, double x, double y, double z) {
  return {m, {0.0, 0.0, 0.0}, {x, y, z, 0.0, 0.0, 0.0}};
}
mb::Mass<double> off_centre(double m, const mb::Column<double>& c, double x, double y, double z) {
  const auto J = [&](double own, double a, double b) { return own + m * (a * a + b * b); };
  return {m,
          c * m,
          {J(x, c.y, c.z), J(y, c.x, c.z), J(z, c.x, c.y), -m * c.x * c.y, -m * c.x * c.z, -m * c.y * c.z}};
}
const mb::Square<double> aligned = mb::identity<double>();
const mb::Column<double> origin{0.0, 0.0, 0.0}, x_axis{1.0, 0.0, 0.0}, z_axis{0.0, 0.0, 1.0};

/// ydot at y, with the efforts on the joints.
std::vector<double> rates(const mb::Tree<double>& tree, const std::vector<double>& y,
                          const std::vector<double>& efforts = {}) {
  auto k = tree.work();
  std::vector<double> ydot(y.size());
  tree.place(y.data(), k);
  for (std::size_t i = 0; i < efforts.size(); ++i) k.efforts[i] = efforts[i];
  tree.solve(y.data(), ydot.data(), k);
  return ydot;
}
std::vector<double> at_rest(const mb::Tree<double>& tree) {
  std::vector<double> y(tree.layout().size());
  y[0] = 1.0;
  return y;
}

TEST(ClosedForms, TwoBodiesOnAHingeInAPlane) {
  // The hinge is at a from the centre of the hub and at b from that of the panel, mu = m1 m2 / (m1 + m2):
  //   (J1 + mu a^2) w' + mu a b (cos q (w + u)' - sin q (w + u)^2) = -tau
  //   (J2 + mu b^2) (w + u)' + mu a b (cos q w' + sin q w^2) = tau
  const double m1 = 7.0, m2 = 2.0, J1 = 5.0, J2 = 1.5, a = 1.2, b = 0.7, mu = m1 * m2 / (m1 + m2);
  const mb::Tree<double> tree(
      {mb::HubMotion::free,
       balanced(m1, 4.0, 6.0, J1),
       {{0, mb::hinge(aligned, z_axis, {a, 0.0, 0.0}), off_centre(m2, {b, 0.0, 0.0}, 1.0, 2.0, J2)}},
       {},
       {}});
  RandomCraft random(1);
  for (int trial = 0; trial < 20; ++trial) {
    auto y = at_rest(tree);
    const double w = y[6] = random.normal(), q = y[13] = random.normal(), u = y[14] = random.normal();
    const double tau = random.normal();
    const auto ydot = rates(tree, y, {tau});
    const double w1 = ydot[6], w2 = w1 + ydot[14], c = std::cos(q), s = std::sin(q);
    EXPECT_NEAR((J1 + mu * a * a) * w1 + mu * a * b * (c * w2 - s * (w + u) * (w + u)), -tau, rounding_of_30);
    EXPECT_NEAR((J2 + mu * b * b) * w2 + mu * a * b * (c * w1 + s * w * w), tau, rounding_of_30);
    EXPECT_EQ(ydot[13], u);
  }
}

TEST(ClosedForms, APendulumOnAHeavyHub) {
  // J q'' = -m g l sin q for a hub that nothing moves, and the joint carries the weight.
  constexpr double heavy = 1e18, m = 2.0, l = 0.8, J = 0.3, g = 9.8;
  const mb::Tree<double> tree(
      {mb::HubMotion::free,
       balanced(heavy, heavy, heavy, heavy),
       {{0, mb::hinge(aligned, z_axis, origin), off_centre(m, {l, 0.0, 0.0}, J, J, J)}},
       {},
       {}});
  auto y = at_rest(tree);
  for (const double q : {0.0, 1e-3, 1.0, 3.0}) {
    y[13] = q;
    auto k = tree.work();
    std::vector<double> ydot(y.size());
    tree.place(y.data(), k);
    const mb::Column<double> weight{m * g, 0.0, 0.0}, centre{l * std::cos(q), l * std::sin(q), 0.0};
    tree.add_wrench(1, weight, mb::cross(centre, weight), k);
    tree.solve(y.data(), ydot.data(), k);
    const double angular = -m * g * l * std::sin(q) / (J + m * l * l);
    EXPECT_NEAR(ydot[14], angular, rounding_of_30);
    const auto held = tree.reaction(1, k);  // m a_c - weight
    EXPECT_NEAR(held.force.x, -m * g - m * l * std::sin(q) * angular, rounding_of_30);
    EXPECT_NEAR(held.force.y, m * l * std::cos(q) * angular, rounding_of_30);
  }
}

TEST(ClosedForms, TwoMassesOnASpring) {
  // q'' = -k q (1/m1 + 1/m2)
  const double m1 = 3.0, m2 = 0.5, k = 4.0, q = 0.2;
  const mb::Tree<double> tree({mb::HubMotion::free,
                               balanced(m1, 1.0, 1.0, 1.0),
                               {{0, mb::slider(aligned, x_axis, origin), balanced(m2, 0.1, 0.1, 0.1)}},
                               {},
                               {}});
  auto y = at_rest(tree);
  y[13] = q;
  EXPECT_NEAR(rates(tree, y, {-k * q})[14], -k * q * (1.0 / m1 + 1.0 / m2), rounding);
}

TEST(ClosedForms, ABalancedRotorIsAHingedWheel) {
  // A wheel that is symmetric about its axis, and at the end of a boom: the rotor's body contains its mass.
  const double m = 2.0, spin = 0.4, across = 0.25;
  const mb::Mass<double> hub = off_centre(9.0, {0.1, -0.2, 0.3}, 5.0, 6.0, 7.0);
  const mb::Column<double> place{0.3, 0.5, -0.4};
  RandomCraft random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3d axes = random.rotation();
    const Vector3d n = axes.col(2);
    const mb::Square<double> R = plain_square<double>(axes);
    const mb::Mass<double> wheel = balanced(m, across, across, spin);
    const mb::Tree<double> hinged(
        {mb::HubMotion::free, hub, {{0, mb::hinge(R, z_axis, place), wheel}}, {}, {}});
    mb::Mass<double> whole = hub;  // with the wheel at its place
    const mb::Mass<double> moved = off_centre(m, place, 0.0, 0.0, 0.0);
    whole.m += m, whole.mc += moved.mc, whole.J += moved.J, whole.J += mb::rotated(R, wheel.J);
    const mb::Tree<double> balanced_rotor(
        {mb::HubMotion::free, whole, {}, {{0, plain_column<double>(n), spin}}, {}});
    auto y = random.state(hinged);
    auto z = y;
    z.erase(z.begin() + 13);  // the angle
    const double tau = random.normal();
    const auto ydot = rates(hinged, y, {tau});
    auto k = balanced_rotor.work();
    std::vector<double> zdot(z.size());
    balanced_rotor.place(z.data(), k);
    k.motors[0] = tau;
    balanced_rotor.solve(z.data(), zdot.data(), k);
    for (std::size_t i = 4; i < 13; ++i) EXPECT_NEAR(ydot[i], zdot[i], rounding_of_30);
    EXPECT_NEAR(ydot[14], zdot[13], rounding_of_30);
  }
}

TEST(ClosedForms, AModeOnAFreeHub) {
  // eta'' (1 - d_t^2 / m) = -W^2 eta; about an axis through the centre, eta'' (1 - d_r^2 / J) = -W^2 eta.
  const double m = 5.0, J = 3.0, W = 1.7, t = 1.1, r = 0.9, eta = 0.01;
  for (const bool turning : {false, true}) {
    const mb::Mode<double> mode{0, turning ? z_axis * r : origin, turning ? origin : x_axis * t, W, 0.0};
    const mb::Tree<double> tree({mb::HubMotion::free, balanced(m, J, J, J), {}, {}, {mode}});
    auto y = at_rest(tree);
    y[13] = eta;
    const double coupling = turning ? r * r / J : t * t / m;
    EXPECT_NEAR(rates(tree, y)[14], -W * W * eta / (1.0 - coupling), rounding);
  }
}

/// The roots of cos b cosh b = -1: the clamped modes of a uniform beam.
double clamped_root(int n) {
  double b = (n + 0.5) * std::numbers::pi;
  for (int i = 0; i < 50; ++i)
    b = (n + 0.5) * std::numbers::pi + (n % 2 == 0 ? 1.0 : -1.0) * std::asin(1.0 / std::cosh(b));
  return b;
}

TEST(ClosedForms, AUniformBeamOnAHub) {
  // A beam of mass m and unit length and stiffness, clamped to a hub of mass M that only moves across it.
  // With W^2 = b^4 / m its lowest frequency is the root of M b (1 + cos b cosh b) + m (sin b cosh b + cos b
  // sinh b) between that of the free craft without a hub, 2.3650, and the clamped beam's, 1.8751.
  const double m = 1.0, M = 0.6;
  constexpr int modes = 12;
  mb::TreeNumbers<double> numbers{mb::HubMotion::free, balanced(m + M, 1e6, 1e6, 1e6), {}, {}, {}};
  double left = m;
  for (int n = 0; n < modes; ++n) {
    const double b = clamped_root(n);
    const double ratio = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
    const double across = 2.0 * ratio / b * std::sqrt(m);  // the integral of the mode, of norm 1
    left -= across * across;
    numbers.modes.push_back({0, origin, x_axis * across, b * b / std::sqrt(m), 0.0});
  }
  // The participations of all modes make the mass; those left out, n >= N, are the sum of
  // 4 m / ((n + 1/2) pi)^2, which is 4 m / pi^2 (1/N - 1/(12 N^3) + 7/(240 N^5) - ...).
  const double pi_2 = std::numbers::pi * std::numbers::pi, N = modes, N_3 = N * N * N, N_5 = N_3 * N * N;
  EXPECT_NEAR(left, m * 4.0 / pi_2 * (1.0 / N - 1.0 / (12.0 * N_3)), m * 4.0 / pi_2 * 7.0 / (240.0 * N_5));
  const mb::Tree<double> tree(numbers);
  Eigen::Matrix<double, modes, modes> K;  // eta'' = -K eta
  for (int n = 0; n < modes; ++n) {
    auto y = at_rest(tree);
    y[13 + std::size_t(n)] = 1.0;
    const auto ydot = rates(tree, y);
    for (int i = 0; i < modes; ++i) K(i, n) = -ydot[13 + modes + std::size_t(i)];
  }
  Eigen::Matrix<double, modes, 1> eta = Eigen::Matrix<double, modes, 1>::Unit(0);
  for (int i = 0; i < 30; ++i) eta = K.partialPivLu().solve(eta).normalized();  // to the lowest
  const double found = std::pow(m * eta.dot(K * eta), 0.25);

  double low = 1.8751, high = 2.3650;
  const auto equation = [&](double b) {
    return M * b * (1.0 + std::cos(b) * std::cosh(b)) +
           m * (std::sin(b) * std::cosh(b) + std::cos(b) * std::sinh(b));
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (equation(middle) > 0.0 ? low : high) = middle;
  }
  // A mode that is left out takes part with (W / W_n)^2 of its mass, together m times the sum of 4 b^4 /
  // b_n^6, less than 4 b^4 / (5 pi^6 N^5). The hub, whose motion it changes, has the mass M, and b goes with
  // the fourth root of W^2.
  const double b_4 = std::pow(low, 4.0);
  EXPECT_NEAR(found, low, low / 4.0 * (m / M) * 4.0 * b_4 / (5.0 * pi_2 * pi_2 * pi_2 * N_5));
}

}  // namespace
}  // namespace vectrix_test::closed_forms_test
