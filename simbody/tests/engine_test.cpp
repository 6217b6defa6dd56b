#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>
#include <vectrix/simbody.hpp>

#include "every_joint.hpp"

// Accelerations of both engines at one state, under efforts of every joint, wrenches on every body, motors,
// forces on modes and a field, with joints that are locked and driven.
namespace vectrix_test::every_joint::engine_test {
namespace {

/// Of sums of some hundred products, relative to the largest acceleration.
constexpr double rounding = 1e-11;

struct Both {
  std::vector<double> ours, theirs;
};
bool stands(multibody::Hold held) {
  return held == multibody::Hold::locked || held == multibody::Hold::sticks;
}
/// `held`: the links and rotors that are held, and how, as a function of their number.
Both accelerations(unsigned long seed, double time_scale, multibody::Hold (*held)(std::size_t)) {
  RandomCraft random(seed);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  const auto& tree = craft.core()->tree;
  multibody::Work<double> applied = tree.work(), work = tree.work();
  const auto draw = [&](auto& numbers) {
    for (double& number : numbers) number = random.normal();
  };
  const auto column = [&] {
    return multibody::Column<double>{random.normal(), random.normal(), random.normal()};
  };
  const auto apply = [](const multibody::Work<double>& from, multibody::Work<double>& to) {
    to.efforts = from.efforts;
    to.motors = from.motors;
    to.modal = from.modal;
    to.field = from.field;
    to.held = from.held;
    to.given = from.given;
    to.held_rotors = from.held_rotors;
    to.given_spins = from.given_spins;
  };
  draw(applied.efforts);
  draw(applied.motors);
  draw(applied.modal);
  draw(applied.given);
  applied.field = column();
  const auto& layout = tree.layout();
  for (std::size_t i = 0; i < applied.held.size(); ++i) {
    applied.held[i] = held(i);
    if (!stands(applied.held[i])) continue;
    const std::size_t next = i + 1 < applied.held.size() ? layout.speed_at[i + 1] : layout.rotors_begin();
    for (std::size_t k = layout.speed_at[i]; k < next; ++k) applied.given[k - layout.speeds_begin()] = 0.0;
  }
  draw(applied.given_spins);
  for (std::size_t i = 0; i < applied.held_rotors.size(); ++i) {
    applied.held_rotors[i] = held(i);
    if (stands(applied.held_rotors[i])) applied.given_spins[i] = 0.0;
  }
  applied.hub.f = column();
  applied.hub.n = column();
  for (auto& link : applied.links) link.I.f = column(), link.I.n = column();
  applied.links[1].I.f = applied.links[1].I.n = multibody::zero_column<double>();  // the ring of the gimbal

  Both found;
  found.ours.resize(Craft::state_size);
  found.theirs.resize(Craft::state_size);
  tree.place(start.data(), work);
  apply(applied, work);
  tree.add_wrench(0, -applied.hub.f, -applied.hub.n, work);
  for (std::size_t i = 0; i < applied.links.size(); ++i)
    tree.add_wrench(static_cast<int>(i) + 1, -applied.links[i].I.f, -applied.links[i].I.n, work);
  tree.solve(start.data(), found.ours.data(), work);

  detail::SimbodyEngine engine(
      detail::simbody_craft(plain(craft)), SimbodyPair::merson, 1e-3, time_scale,
      [&](double, const double*, detail::SimbodyLoads& loads) { detail::copy_loads(applied, loads); });
  engine.rates(start_time.value(), start.data(), found.theirs.data());
  return found;
}
void expect_same(const Both& found) {
  double largest = 0.0;
  for (const double rate : found.ours) largest = detail::larger(largest, std::abs(rate));
  for (std::size_t i = 0; i < found.ours.size(); ++i)
    EXPECT_NEAR(found.theirs[i], found.ours[i], rounding * largest) << i;
}

TEST(SimbodyEngine, has_the_accelerations_of_ours_in_any_unit_of_time) {
  const auto none = [](std::size_t) { return multibody::Hold::none; };
  for (const unsigned long seed : {21UL, 22UL, 23UL, 24UL}) {
    expect_same(accelerations(seed, 1.0, none));
    expect_same(accelerations(seed, 0.3, none));
  }
}

TEST(SimbodyEngine, locks_and_drives_what_ours_does) {
  using multibody::Hold;
  for (const unsigned long seed : {25UL, 26UL})
    for (const double unit : {1.0, 0.3}) {
      expect_same(
          accelerations(seed, unit, [](std::size_t i) { return i % 2 == 0 ? Hold::locked : Hold::none; }));
      expect_same(
          accelerations(seed, unit, [](std::size_t i) { return i % 2 == 1 ? Hold::locked : Hold::none; }));
      expect_same(
          accelerations(seed, unit, [](std::size_t i) { return i % 3 == 0 ? Hold::locked : Hold::none; }));
      expect_same(
          accelerations(seed, unit, [](std::size_t i) { return i % 2 == 0 ? Hold::driven : Hold::none; }));
      expect_same(
          accelerations(seed, unit, [](std::size_t i) { return i % 2 == 1 ? Hold::driven : Hold::none; }));
      expect_same(accelerations(seed, unit, [](std::size_t i) {
        return std::array{Hold::none, Hold::sticks, Hold::locked, Hold::driven}[i % 4];
      }));
      expect_same(accelerations(seed, unit, [](std::size_t i) {
        return std::array{Hold::none, Hold::locked, Hold::driven}[i % 3];
      }));
    }
}

// What a load throws within Simbody's realization is kept there; it is thrown once.
TEST(SimbodyEngine, forgets_what_a_load_has_thrown) {
  RandomCraft random(27);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  detail::CraftRates<Craft> without_loads(craft);
  const multibody::Work<double> applied = without_loads.loads(start_time.value(), start.data());
  bool in_simbody = false, breaks = true;
  detail::SimbodyEngine engine(detail::simbody_craft(plain(craft)), SimbodyPair::merson, 1e-3, 1.0,
                               [&](double, const double*, detail::SimbodyLoads& loads) {
                                 if (breaks && std::exchange(in_simbody, true))
                                   throw std::domain_error("beyond the table");
                                 detail::copy_loads(applied, loads);
                               });
  std::vector<double> before(Craft::state_size), after(Craft::state_size);
  EXPECT_THROW(engine.rates(start_time.value(), start.data(), before.data()), std::domain_error);
  breaks = false;
  engine.rates(start_time.value(), start.data(), before.data());
  engine.start(start_time.value(), start.data(), start_time.value() + 1.0, 1.0);
  engine.rate(after.data());
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], rounding) << i;
}

}  // namespace
}  // namespace vectrix_test::every_joint::engine_test
