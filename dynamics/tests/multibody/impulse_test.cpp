#include <gtest/gtest.h>

#include <limits>
#include <vectrix/dynamics/multibody/impulse.hpp>

#include "random_craft.hpp"
#include "testing/trials.hpp"

// Impulses that stop joints and rotors: what they keep, and Carnot's theorem.
namespace vectrix_test::impulse_test {
namespace {

using mb::InImpulse;

/// As in the tests of what accelerations keep: thirty links, rotors and modes with a hundred operations each.
constexpr double tolerance = 30 * 100 * std::numeric_limits<double>::epsilon();

mb::Conserved<double> conserved(const mb::Tree<double>& tree, const std::vector<double>& y,
                                const Vector3d& about) {
  auto k = tree.work();
  tree.place(y.data(), k);
  return tree.conserved(y.data(), plain_column<double>(about), k);
}

// The impulses do no work on the speeds after them: what is free has none along its freedoms, and what is
// stopped or keeps its speed, zero here, does not move along its own.
TEST(Impulse, KeepsMomentumAndLosesTheEnergyOfTheLostSpeeds) {
  RandomCraft random(20261129);
  for (int trial = 0; trial < trials(100); ++trial) {
    const DescribedCraft craft = random.craft(random.below(12));
    const bool free = trial % 2 == 0;
    const mb::Tree<double> tree(
        lowered<double>(craft, free ? mb::HubMotion::free : mb::HubMotion::turning).numbers);
    const auto& layout = tree.layout();
    auto before = random.state(tree);
    const auto any = [&] { return InImpulse(random.below(3)); };
    std::vector<InImpulse> links(layout.speed_at.size()), rotors(layout.rotors);
    std::vector<char> given(layout.size(), 0);  // what does not move afterwards
    for (std::size_t i = 0; i < links.size(); ++i) {
      links[i] = any();
      const std::size_t end = i + 1 < links.size() ? layout.speed_at[i + 1] : layout.rotors_begin();
      for (std::size_t n = layout.speed_at[i]; n < end; ++n) {
        given[n] = links[i] != InImpulse::is_free;
        if (links[i] == InImpulse::keeps_speed) before[n] = 0.0;
      }
    }
    for (std::size_t i = 0; i < rotors.size(); ++i) {
      rotors[i] = any();
      const std::size_t n = layout.rotors_begin() + i;
      given[n] = rotors[i] != InImpulse::is_free;
      if (rotors[i] == InImpulse::keeps_speed) before[n] = 0.0;
    }
    auto after = before;
    mb::stop(tree, links, rotors, after.data());

    auto changes = before, rest = before;
    const auto is_place = [&](std::size_t n) {
      return n < 4 || (free && n >= 7 && n < 10) || (n >= layout.hub && n < layout.speeds_begin()) ||
             (n >= layout.modes_begin() && n < layout.modes_begin() + layout.modes);
    };
    for (std::size_t n = 0; n < before.size(); ++n) {
      if (is_place(n)) {
        EXPECT_EQ(after[n], before[n]) << n;
        continue;
      }
      changes[n] = after[n] - before[n], rest[n] = 0.0;
      if (given[n]) {
        EXPECT_EQ(after[n], 0.0) << n;
      }
    }
    const Vector3d about = random.triple();
    const auto was = conserved(tree, before, about), is = conserved(tree, after, about);
    const double scale = was.energy + eigen(was.momentum).norm() + eigen(was.angular_momentum).norm();
    EXPECT_LT((eigen(is.momentum) - eigen(was.momentum)).norm(), tolerance * scale);
    EXPECT_LT((eigen(is.angular_momentum) - eigen(was.angular_momentum)).norm(), tolerance * scale);
    const double lost = conserved(tree, changes, about).energy - conserved(tree, rest, about).energy;
    EXPECT_NEAR(was.energy - is.energy, lost, tolerance * scale);
  }
}

// A joint that keeps its speed transmits the impulse as if it were at rest: the changes are the same.
TEST(Impulse, ASpeedThatIsKeptDoesNotMatter) {
  RandomCraft random(20261130);
  DescribedCraft craft = random.craft(0);
  for (int i = 0; i < 2; ++i) craft.bodies.push_back(random.body(i, JointKind::hinge, 1.0));
  const mb::Tree<double> tree(lowered<double>(craft, mb::HubMotion::free).numbers);
  const std::size_t first = tree.layout().speeds_begin();
  const std::vector<InImpulse> links{InImpulse::keeps_speed, InImpulse::stops},
      rotors(tree.layout().rotors, InImpulse::is_free);
  auto moving = random.state(tree), still = moving;
  still[first] = 0.0;
  const auto before = moving;
  mb::stop(tree, links, rotors, moving.data());
  mb::stop(tree, links, rotors, still.data());
  EXPECT_EQ(moving[first], before[first]);
  EXPECT_EQ(moving[first + 1], 0.0);
  for (std::size_t n = 0; n < moving.size(); ++n)
    if (n != first) {
      EXPECT_EQ(moving[n], still[n]) << n;
    }
  EXPECT_NE(moving[4], before[4]);
}

}  // namespace
}  // namespace vectrix_test::impulse_test
