#include <gtest/gtest.h>

#include <vectrix/dynamics/multibody/tree.hpp>
#include <vectrix/frames/errors.hpp>

#include "dense.hpp"
#include "testing/trials.hpp"

namespace vectrix_test::tree_test {
namespace {

/// The most that a dense solution may err by its rounding: n epsilon times a condition of 4e4 for 100
/// unknowns. That of light bodies far from heavy ones is larger, but they are not the worst case.
constexpr double most_of_dense = 1e-9;
/// Sums along a chain of up to 200 bodies, and 3x3 systems, of numbers up to 10: some hundred roundings of
/// each.
constexpr double rounding = 1e-12;
/// Of forces and torques beside accelerations: masses up to 30 kg, on arms of some metres.
constexpr double of_wrench = 1e2;

/// A craft with random loads, a third of its joints held in motion.
struct Case {
  DescribedCraft craft;
  Lowered<double> made;
  mb::Tree<double> tree;
  std::vector<double> y, ydot;
  mb::Work<double> k;
  Acting acting;

  Case(RandomCraft& random, int bodies, mb::HubMotion motion = mb::HubMotion::free)
      : craft(random.craft(bodies)),
        made(lowered<double>(craft, motion)),
        tree(made.numbers),
        y(random.state(tree)),
        ydot(y.size()),
        k(tree.work()) {
    const auto numbers = [&](std::size_t count) {
      VectorXd v(static_cast<Eigen::Index>(count));
      for (double& x : v) x = random.normal();
      return v;
    };
    const auto& layout = tree.layout();
    acting.efforts = numbers(layout.speeds);
    acting.given = numbers(layout.speeds);
    acting.motors = numbers(layout.rotors);
    acting.modal = numbers(layout.modes);
    acting.field = random.triple();
    for (int i = 0; i <= bodies; ++i) {
      acting.force.push_back(random.triple());
      acting.torque.push_back(random.triple());
      acting.held.push_back(i > 0 && random.below(3) == 0);
    }
  }

  void solve() {
    tree.place(y.data(), k);
    for (std::size_t i = 1; i < made.number.size(); ++i) {
      if (!acting.held[i]) continue;
      const auto link = static_cast<std::size_t>(made.number[i]) - 1;
      k.held[link] = mb::Hold::driven;
      if (craft.bodies[i - 1].joint == JointKind::gimbal) k.held[link - 1] = mb::Hold::driven;
    }
    k.given.assign(acting.given.begin(), acting.given.end());
    k.efforts.assign(acting.efforts.begin(), acting.efforts.end());
    k.motors.assign(acting.motors.begin(), acting.motors.end());
    k.modal.assign(acting.modal.begin(), acting.modal.end());
    k.field = plain_column<double>(acting.field);
    const Matrix3d R = turn(y.data());
    for (std::size_t i = 0; i < made.number.size(); ++i) {
      tree.add_wrench(made.number[i], plain_column<double>(R.transpose() * acting.force[i]),
                      plain_column<double>(R.transpose() * acting.torque[i]), k);
    }
    tree.solve(y.data(), ydot.data(), k);
  }
};

TEST(Tree, ArticulatedBodiesGiveWhatTheDenseMassMatrixGives) {
  RandomCraft random(20260301);
  for (int trial = 0; trial < trials(300); ++trial) {
    Case c(random, trial == 0 ? 199 : 1 + random.below(29));
    c.solve();
    const DenseMotion dense = dense_motion(c.craft, c.y.data(), c.acting);
    const double scale = std::max({1.0, dense.accelerations.cwiseAbs().maxCoeff(), dense.a_i.norm()});
    const double tolerance = std::min(dense.rounding, most_of_dense) * scale;
    const auto& layout = c.tree.layout();

    EXPECT_LE((Eigen::Map<const Vector3d>(&c.ydot[4]) - dense.alpha_h).norm(), tolerance);
    EXPECT_LE((Eigen::Map<const Vector3d>(&c.ydot[10]) - dense.a_i).norm(), tolerance);
    for (std::size_t i = 0; i < layout.speeds + layout.rotors; ++i)
      EXPECT_NEAR(c.ydot[layout.speeds_begin() + i], dense.accelerations[Eigen::Index(i)], tolerance);
    for (std::size_t i = 0; i < layout.modes; ++i) {
      const std::size_t at = layout.modes_begin() + i;
      EXPECT_EQ(c.ydot[at], c.y[at + layout.modes]);
      EXPECT_NEAR(c.ydot[at + layout.modes],
                  dense.accelerations[Eigen::Index(layout.speeds + layout.rotors + i)], tolerance);
    }
    const Matrix3d R = turn(c.y.data());
    for (std::size_t i = 0; i < c.made.number.size(); ++i) {
      const int number = c.made.number[i];
      const DenseBody& b = dense.bodies[i];
      const auto moved = c.tree.accelerations(number, c.k);
      EXPECT_LE((R * eigen(moved.alpha) - b.alpha).norm(), tolerance);
      EXPECT_LE((R * eigen(moved.a) - b.a).norm(), tolerance);
      EXPECT_LE((R * eigen(c.tree.position(number, c.k)) + dense.bodies[0].r - b.r).norm(), rounding);
      if (i == 0) continue;
      const auto transmitted = c.tree.reaction(number, c.k);
      EXPECT_LE((R * eigen(transmitted.force) - dense.force[i]).norm(), of_wrench * tolerance);
      EXPECT_LE((R * eigen(transmitted.torque) - dense.torque[i]).norm(), of_wrench * tolerance);
    }
  }
}

TEST(Tree, ATurningHubTurnsAsAFreeOneDoes) {
  RandomCraft random(20260302);
  for (int trial = 0; trial < trials(50); ++trial) {
    Case c(random, 1 + random.below(9));
    c.solve();
    const mb::Tree<double> turning(lowered<double>(c.craft, mb::HubMotion::turning).numbers);
    std::vector<double> y(c.y);
    y.erase(y.begin() + 7, y.begin() + 13);
    std::vector<double> ydot(y.size());
    auto k = turning.work();
    turning.place(y.data(), k);
    k.held = c.k.held, k.given = c.k.given;
    k.efforts = c.k.efforts, k.motors = c.k.motors, k.modal = c.k.modal;
    const Matrix3d R = turn(y.data());
    for (std::size_t i = 0; i < c.made.number.size(); ++i)
      turning.add_wrench(c.made.number[i], plain_column<double>(R.transpose() * c.acting.force[i]),
                         plain_column<double>(R.transpose() * c.acting.torque[i]), k);
    turning.solve(y.data(), ydot.data(), k);
    std::vector<double> wanted(c.ydot);
    wanted.erase(wanted.begin() + 7, wanted.begin() + 13);
    EXPECT_EQ(ydot, wanted);
  }
}

TEST(Tree, WithoutJointsTheConstantInverseIsTheGeneralSolution) {
  RandomCraft random(20260303);
  for (int trial = 0; trial < trials(100); ++trial) {
    Case c(random, 0);
    c.craft.modes.clear();
    c.acting.modal.resize(0);
    c.made = lowered<double>(c.craft, mb::HubMotion::free);
    c.tree = mb::Tree<double>(c.made.numbers);
    c.k = c.tree.work();
    c.solve();
    const DenseMotion dense = dense_motion(c.craft, c.y.data(), c.acting);
    const double tolerance = rounding * std::max(1.0, dense.alpha_h.norm() + dense.a_i.norm());
    EXPECT_LE((Eigen::Map<const Vector3d>(&c.ydot[4]) - dense.alpha_h).norm(), tolerance);
    EXPECT_LE((Eigen::Map<const Vector3d>(&c.ydot[10]) - dense.a_i).norm(), tolerance);
    for (Eigen::Index i = 0; i < dense.accelerations.size(); ++i)
      EXPECT_NEAR(c.ydot[13 + std::size_t(i)], dense.accelerations[i], tolerance);
  }
}

TEST(Tree, PositionsChangeAtTheirSpeeds) {
  // d/dt of the place of every body by central differences along the rates of the positions.
  constexpr double step = 1e-6, tolerance = 1e-8;  // step^2 times a third derivative of order 1e3
  RandomCraft random(20260304);
  for (int trial = 0; trial < trials(30); ++trial) {
    Case c(random, 1 + random.below(9));
    c.solve();
    const auto moved = [&](double h) {
      std::vector<double> y(c.y);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * c.ydot[i];
      return y;
    };
    const auto before = moved(-step), after = moved(step);
    auto k0 = c.tree.work(), k1 = c.tree.work();
    c.tree.place(before.data(), k0);
    c.tree.place(after.data(), k1);
    for (const int number : c.made.number) {
      const auto place = [&](const std::vector<double>& y, const mb::Work<double>& k) -> Vector3d {
        return turn(y.data()) * eigen(c.tree.position(number, k)) + Eigen::Map<const Vector3d>(&y[7]);
      };
      const Vector3d rate = (place(after, k1) - place(before, k0)) / (2.0 * step);
      const Matrix3d R = turn(c.y.data());
      EXPECT_LE((R * eigen(c.tree.velocity(number, c.y.data(), c.k)) - rate).norm(), tolerance * 10.0);
    }
  }
}

TEST(Tree, AHeldHingeAtRestIsAFixedJoint) {
  RandomCraft random(20260305);
  for (int trial = 0; trial < trials(50); ++trial) {
    DescribedCraft craft = random.craft(6);
    craft.bodies[3].joint = JointKind::hinge;
    const mb::Tree<double> tree(lowered<double>(craft, mb::HubMotion::free).numbers);
    auto y = random.state(tree);
    const std::size_t link =
        static_cast<std::size_t>(lowered<double>(craft, mb::HubMotion::free).number[4]) - 1;
    y[tree.layout().speed_at[link]] = 0.0;
    auto k = tree.work();
    std::vector<double> ydot(y.size());
    tree.place(y.data(), k);
    k.held[link] = mb::Hold::locked;
    tree.solve(y.data(), ydot.data(), k);

    DescribedCraft welded = craft;
    welded.bodies[3].joint = JointKind::fixed;
    welded.bodies[3].R_p_from_b *=
        Eigen::AngleAxisd(y[tree.layout().position_at[link]], craft.bodies[3].axis_1).toRotationMatrix();
    const mb::Tree<double> other(lowered<double>(welded, mb::HubMotion::free).numbers);
    std::vector<double> z(y);
    z.erase(z.begin() + std::ptrdiff_t(tree.layout().speed_at[link]));
    z.erase(z.begin() + std::ptrdiff_t(tree.layout().position_at[link]));
    auto j = other.work();
    std::vector<double> zdot(z.size());
    other.place(z.data(), j);
    other.solve(z.data(), zdot.data(), j);
    ydot.erase(ydot.begin() + std::ptrdiff_t(tree.layout().speed_at[link]));
    ydot.erase(ydot.begin() + std::ptrdiff_t(tree.layout().position_at[link]));
    double scale = 1.0;
    for (const double x : ydot) scale = std::max(scale, std::abs(x));
    for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(ydot[i], zdot[i], 10.0 * rounding * scale);
  }
}

// A motor that gives the torque of the drive makes the same motion.
TEST(Tree, AHeldRotorTakesTheTorqueOfItsDrive) {
  RandomCraft random(20260308);
  for (int trial = 0; trial < trials(100); ++trial) {
    Case c(random, 1 + random.below(9));
    const std::vector<double> motors(c.acting.motors.begin(), c.acting.motors.end());
    const auto solve = [&](const std::vector<double>& torques, const std::vector<mb::Hold>& held) {
      c.tree.place(c.y.data(), c.k);
      for (std::size_t i = 0; i < torques.size(); ++i) c.k.motors[i] = torques[i];
      for (std::size_t i = 0; i < held.size(); ++i) {
        c.k.held_rotors[i] = held[i];
        if (held[i] == mb::Hold::driven) c.k.given_spins[i] = motors[i] - 1.0;
      }
      c.tree.solve(c.y.data(), c.ydot.data(), c.k);
      return c.ydot;
    };
    std::vector<mb::Hold> held(motors.size());
    for (auto& hold : held) hold = mb::Hold(random.below(3));
    std::vector<double> torques = motors;
    const auto driven = solve(torques, held);
    double scale = 1.0;
    for (const double x : driven) scale = std::max(scale, std::abs(x));
    for (std::size_t i = 0; i < held.size(); ++i) {
      const double given = held[i] == mb::Hold::driven ? motors[i] - 1.0 : 0.0;
      if (held[i] != mb::Hold::none) {
        EXPECT_EQ(driven[c.tree.layout().rotors_begin() + i], given);
      }
      torques[i] += c.tree.holding_torque(i, c.k);
    }
    const auto moved = solve(torques, std::vector<mb::Hold>(held.size()));
    for (std::size_t i = 0; i < driven.size(); ++i)
      EXPECT_NEAR(moved[i], driven[i], 100.0 * rounding * scale) << i;
  }
}

// A lock is for one solution, whatever acceleration was given before.
TEST(Tree, ALockedLinkKeepsItsSpeedOnce) {
  RandomCraft random(20260307);
  for (int trial = 0; trial < trials(30); ++trial) {
    Case c(random, 6);
    auto k = c.tree.work();
    const auto solve = [&](std::size_t locked) {
      c.tree.place(c.y.data(), k);
      if (locked < k.held.size()) k.held[locked] = mb::Hold::locked;
      c.tree.solve(c.y.data(), c.ydot.data(), k);
      return c.ydot;
    };
    const auto free = solve(k.held.size());
    for (std::size_t link = 0; link < k.held.size(); ++link) {
      const auto locked = solve(link);
      for (double& given : k.given) given = 1.0;
      EXPECT_EQ(solve(link), locked);
      EXPECT_EQ(solve(k.held.size()), free);
    }
  }
}

TEST(Tree, RefusesATreeOutOfOrder) {
  RandomCraft random(20260306);
  const auto numbers = lowered<double>(random.craft(3), mb::HubMotion::free).numbers;
  const auto refused = [&](const auto& change) {
    auto changed = numbers;
    change(changed);
    EXPECT_THROW(mb::Tree<double>{changed}, vectrix::BadInput);
  };
  refused([](auto& tree) { tree.links.front().parent = 1; });
  refused([](auto& tree) { tree.links.front().parent = -1; });
  refused([](auto& tree) { tree.rotors.front().body = 100; });
  refused([](auto& tree) { tree.modes.front().body = -1; });
}

}  // namespace
}  // namespace vectrix_test::tree_test
