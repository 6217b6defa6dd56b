#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <unsupported/Eigen/AutoDiff>
#include <vectrix/dynamics/multibody/any_scalar.hpp>

#include "random_craft.hpp"
#include "testing/trials.hpp"

// What a craft keeps. At an instant: the derivatives of momentum and energy along the equations of motion, by
// automatic differentiation, are the forces and their power. Over a run: to the order of the method.
namespace vectrix_test::conservation_test {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

/// The momenta see what the equations of motion leave over, not the error of the accelerations, so that the
/// condition of the joints does not count: thirty links, rotors and modes with a hundred operations each.
constexpr double instant_tolerance = 30 * 100 * std::numeric_limits<double>::epsilon();

Vector3d rate_of(const mb::Column<Dual>& v) {
  return {v.x.derivatives()[0], v.y.derivatives()[0], v.z.derivatives()[0]};
}

TEST(Conservation, MomentumChangesByTheForcesAndEnergyByTheirPower) {
  RandomCraft random(20260310);
  for (int trial = 0; trial < trials(100); ++trial) {
    const DescribedCraft craft = random.craft(random.below(12));
    const auto motion = trial % 2 == 0 ? mb::HubMotion::free : mb::HubMotion::turning;
    const mb::Tree<double> tree(lowered<double>(craft, motion).numbers);
    const auto& layout = tree.layout();
    auto y = random.state(tree);
    // Kinetic energy counts the quaternion's direction alone; its norm may be any.
    std::vector<double> ydot(y.size());
    auto k = tree.work();
    tree.place(y.data(), k);
    double power = 0.0, mass = 0.0;
    const Matrix3d R = eigen(k.R_i_from_h);
    const Vector3d about = random.triple();
    const bool free = motion == mb::HubMotion::free;
    const Vector3d r_h = free ? Vector3d(Eigen::Map<const Vector3d>(&y[7]) - about) : Vector3d::Zero();
    Vector3d first = Vector3d::Zero();  // the first moment about that point, in inertial axes
    for (std::size_t i = 0; i < k.efforts.size(); ++i) {
      k.efforts[i] = random.normal();
      power += k.efforts[i] * y[layout.speeds_begin() + i];
    }
    for (std::size_t i = 0; i < k.motors.size(); ++i) {
      k.motors[i] = random.normal();
      power += k.motors[i] * y[layout.rotors_begin() + i];
    }
    for (std::size_t i = 0; i < k.modal.size(); ++i) {
      const auto& mode = tree.numbers().modes[i];
      const double eta = y[layout.modes_begin() + i], rate = y[layout.modes_begin() + layout.modes + i];
      first += eta * R * eigen(tree.rotation(mode.body, k) * mode.translation);
      k.modal[i] = random.normal();
      power += (k.modal[i] - 2.0 * mode.damping_ratio * mode.frequency * rate) * rate;
    }
    Vector3d force = Vector3d::Zero(), torque = force;
    for (int body = 0; body <= static_cast<int>(k.links.size()); ++body) {
      const mb::Mass<double>& own =
          body == 0 ? tree.numbers().hub : tree.numbers().links[std::size_t(body) - 1].mass;
      const Vector3d r = r_h + R * eigen(tree.position(body, k));
      mass += own.m;
      first += own.m * r + R * eigen(tree.rotation(body, k) * own.mc);
      const Vector3d F = free ? random.triple() : Vector3d::Zero(), T = random.triple();
      tree.add_wrench(body, plain_column<double>(F), plain_column<double>(T), k);
      power += F.dot(eigen(tree.velocity(body, y.data(), k))) + T.dot(eigen(tree.angular_velocity(body, k)));
      force += R * F;
      torque += R * T + r.cross(R * F);
    }
    const auto now = tree.conserved(y.data(), plain_column<double>(about), k);
    if (free) {  // a uniform field acts on every mass
      const Vector3d g = random.triple();
      k.field = plain_column<double>(g);
      force += mass * g;
      torque += first.cross(g);
      power += g.dot(eigen(now.momentum));
    }
    tree.solve(y.data(), ydot.data(), k);

    const mb::Tree<Dual> along(lowered<Dual>(craft, motion).numbers);
    std::vector<Dual> z;
    for (std::size_t i = 0; i < y.size(); ++i) z.emplace_back(y[i], Eigen::Matrix<double, 1, 1>(ydot[i]));
    auto j = along.work();
    along.place(z.data(), j);
    const auto kept = along.conserved(z.data(), plain_column<Dual>(about), j);
    const double size = 1.0 + std::abs(now.energy) + std::abs(power) + torque.norm();
    double scale = size;
    for (const double rate : ydot)
      scale = std::max(scale, std::abs(rate));  // the terms that cancel each other
    EXPECT_NEAR(kept.energy.derivatives()[0], power, instant_tolerance * scale) << "of " << scale;
    EXPECT_LE((rate_of(kept.momentum) - force).norm(), instant_tolerance * scale);
    EXPECT_LE((rate_of(kept.angular_momentum) - torque).norm(), instant_tolerance * scale);
    if (!free) {
      EXPECT_LE(eigen(now.momentum).norm(), instant_tolerance * size);
    }
  }
}

/// The classical Runge-Kutta method of order 4.
std::vector<double> run(const mb::Tree<double>& tree, std::vector<double> y, double end, int steps) {
  auto k = tree.work();
  std::vector<double> stage(y), slope(y.size()), sum(y.size());
  const double h = end / steps;
  for (int step = 0; step < steps; ++step) {
    constexpr double at[]{0.0, 0.5, 0.5, 1.0}, weight[]{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    sum = y;
    for (int s = 0; s < 4; ++s) {
      for (std::size_t i = 0; i < y.size(); ++i) stage[i] = y[i] + (s == 0 ? 0.0 : h * at[s] * slope[i]);
      tree.place(stage.data(), k);
      tree.solve(stage.data(), slope.data(), k);
      for (std::size_t i = 0; i < y.size(); ++i) sum[i] += h * weight[s] * slope[i];
    }
    y = sum;
  }
  return y;
}

TEST(Conservation, OverARunImprovesWithTheOrderOfTheMethod) {
  constexpr int steps = 200;
  constexpr double end = 1.0, halved = 12.0;  // half the step: 16 times less, at least
  RandomCraft random(20260311);
  for (int trial = 0; trial < 3; ++trial) {
    DescribedCraft craft = random.craft(5);
    for (auto& mode : craft.modes) mode.damping_ratio = 0.0;
    const mb::Tree<double> tree(lowered<double>(craft, mb::HubMotion::free).numbers);
    auto y = random.state(tree);
    for (double& number : y) number *= 0.3;
    auto k = tree.work();
    const auto conserved = [&](const std::vector<double>& at) {
      tree.place(at.data(), k);
      const auto now = tree.conserved(at.data(), {1.0, -2.0, 3.0}, k);
      Eigen::Matrix<double, 7, 1> all;
      all << eigen(now.momentum), eigen(now.angular_momentum), now.energy;
      return all;
    };
    const auto start = conserved(y);
    const auto coarse = (conserved(run(tree, y, end, steps)) - start).eval();
    const auto fine = (conserved(run(tree, y, end, 2 * steps)) - start).eval();
    for (int part = 0; part < 3; ++part) {
      const auto of = [&](const auto& v) {
        return part == 2 ? std::abs(v[6]) : Vector3d(v.template segment<3>(3 * part)).norm();
      };
      EXPECT_LT(of(fine), of(coarse) / halved + 1e-12 * of(start)) << part;
      EXPECT_LT(of(fine), 1e-4 * of(start)) << part;
    }
  }
}

TEST(Conservation, NothingButThePositionDependsOnASteadySpeed) {
  RandomCraft random(20260312);
  const mb::Tree<double> tree(lowered<double>(random.craft(5), mb::HubMotion::free).numbers);
  auto y = random.state(tree);
  const auto slow = run(tree, y, 1.0, 100);
  y[10] += 7500.0;
  const auto fast = run(tree, y, 1.0, 100);
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (i >= 7 && i < 13) continue;
    EXPECT_EQ(slow[i], fast[i]);
  }
}

}  // namespace
}  // namespace vectrix_test::conservation_test
