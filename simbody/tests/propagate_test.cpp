#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vectrix/simbody.hpp>

#include "every_joint.hpp"

// Our trajectories and Simbody's, of the same scenario.
namespace vectrix_test::every_joint::propagate_test {
namespace {

/// That the difference is Simbody's: a hundred times tighter accuracy must reduce it at least ten times.
constexpr double largest_ratio = 0.1;
/// A difference of this size is one of mechanics, not of integration.
constexpr double other_mechanics = 1e-3;

constexpr auto end = 7.0 * s;

std::array<double, 14> sizes(const CraftComparison<Craft>& found) {
  return {found.attitude(of<Hub>).size.value(),
          found.rate(of<Hub>).size.value(),
          found.position(of<Hub>).size.value(),
          found.velocity(of<Hub>).size.value(),
          found.coordinate(of<Boom>).size.value(),
          found.speed(of<Boom>).size.value(),
          found.coordinate(of<Antenna>).size.value(),
          found.coordinate(of<Mass>).size.value(),
          found.attitude(of<Gyro>).size.value(),
          found.position(of<Probe>).size.value(),
          found.spin(of<WheelOfHub>).size.value(),
          found.spin(of<WheelOfBoom>).size.value(),
          found.momentum().size.value(),
          found.angular_momentum().size.value()};
}

TEST(PropagateWithSimbody, differs_by_the_accuracy_of_simbody_alone) {
  for (const unsigned long seed : {1UL, 2UL, 3UL}) {
    RandomCraft random(seed);
    const Craft craft(random);
    const auto start = start_of(craft, random);
    const auto flight = flight_of(craft);
    const auto ours = propagate(flight, start, exact_until(end));
    const auto differences = [&](double accuracy) {
      return sizes(
          compare(craft, ours, propagate_with_simbody(flight, start, {.end = end, .accuracy = accuracy})));
    };
    const auto loose = differences(1e-5), middle = differences(1e-7), tight = differences(1e-9);
    for (std::size_t i = 0; i < loose.size(); ++i) {
      EXPECT_LT(middle[i], largest_ratio * loose[i]) << seed << ", quantity " << i;
      EXPECT_LT(tight[i], largest_ratio * middle[i]) << seed << ", quantity " << i;
    }
  }
}

TEST(PropagateWithSimbody, the_pair_of_order_five_comes_to_the_same) {
  RandomCraft random(4);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  const auto flight = flight_of(craft);
  const auto ours = propagate(flight, start, exact_until(end));
  const auto difference = [&](double accuracy) {
    const SimbodyPropagation how{.end = end, .accuracy = accuracy, .pair = SimbodyPair::feldberg};
    return compare(craft, ours, propagate_with_simbody(flight, start, how)).attitude(of<Hub>).size.value();
  };
  EXPECT_LT(difference(1e-9), largest_ratio * difference(1e-7));
}

TEST(Compare, sees_a_transposed_frame_of_a_joint) {
  RandomCraft random(5);
  const Craft craft(random), wrong(random, true);
  const auto start = start_of(craft, random);
  const SimbodyPropagation how{.end = end, .accuracy = 1e-8};
  const auto ours = propagate(flight_of(craft), start, exact_until(end));
  const auto right = compare(craft, ours, propagate_with_simbody(flight_of(craft), start, how));
  const auto found = compare(craft, ours, propagate_with_simbody(flight_of(wrong), start, how));
  for (std::size_t i = 0; i < sizes(found).size(); ++i) {
    if (i == 12) continue;  // the momentum does not depend on where a joint is
    EXPECT_GT(sizes(found)[i], other_mechanics) << i;
    EXPECT_LT(sizes(right)[i], largest_ratio * other_mechanics) << i;
  }
}

TEST(PropagateWithSimbody, starts_from_quaternions_of_any_norm) {
  RandomCraft random(6);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  auto numbers = start.numbers();
  for (std::size_t i = 0; i < 4; ++i) numbers[i] *= 3.0;
  const auto longer = state_from_numbers(craft, start_time, numbers);
  const auto flight = flight_of(craft);
  const SimbodyPropagation how{.end = 4.0 * s, .accuracy = 1e-8};
  const auto found =
      compare(craft, propagate_with_simbody(flight, start, how), propagate_with_simbody(flight, longer, how));
  EXPECT_LT(found.attitude(of<Hub>).size.value(), 1e-12);  // some hundred roundings
}

// The node that ends a step is Simbody's; between the nodes, the polynomial adds no more than that.
TEST(PropagateWithSimbody, is_as_accurate_between_its_nodes) {
  RandomCraft random(7);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  const auto flight = flight_of(craft);
  const auto ours = propagate(flight, start, exact_until(end));
  const auto theirs = propagate_with_simbody(flight, start, {.end = end, .accuracy = 1e-8});
  const auto off = [&](const Quantity<si::time>& t) {
    const auto a = ours.at(t).numbers(), b = theirs.at(t).numbers();
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = detail::larger(largest, std::abs(a[i] - b[i]));
    return largest;
  };
  double at_nodes = 0.0, between = 0.0;
  for (std::size_t i = 1; i < theirs.node_count(); ++i) {
    const auto before = theirs.node(i - 1).time(), now = theirs.node(i).time();
    at_nodes = detail::larger(at_nodes, off(now));
    between = detail::larger(between, off(before + 0.37 * (now - before)));
  }
  EXPECT_LT(between, 2.0 * at_nodes);
}

TEST(PropagateWithSimbody, gives_the_states_at_the_output_times) {
  RandomCraft random(8);
  const Craft craft(random);
  const auto start = start_of(craft, random);
  const auto theirs = propagate_with_simbody(
      flight_of(craft), start, {.end = end, .accuracy = 1e-6, .output_times = {3.25 * s, 6.9 * s}});
  ASSERT_EQ(theirs.outputs().size(), 2U);
  EXPECT_EQ(theirs.outputs()[1].numbers(), theirs.at(6.9 * s).numbers());
  EXPECT_EQ(theirs.start(), start_time);
  EXPECT_EQ(theirs.end(), end);
}

const auto push_boom = [](const Now<Turning>& now, Forces<Turning>& forces) {
  forces.force(of<Boom>, vector(in<Hub>, 0.3 * N, 0.2 * N, -0.5 * N));
  forces.effort(of<Boom>, -2.0 * now.coordinate(of<Boom>).value() * N_m);
};
CraftState<Turning> turning_start(const Turning& craft) {
  RandomCraft random(9);
  return state(craft, 2.0 * s, moving<Gcrf, Hub>(random).turning, starts(of<Boom>, 0.2 * rad, 0.1 * rad_s),
               spins(of<WheelOfHub>, 40.0 * rad_s));
}

// The unit of time in which Simbody bounds its errors is none of the mechanics.
TEST(PropagateWithSimbody, turns_a_hub_without_a_place) {
  const Turning craft;
  const auto flight = scenario(craft, push_boom);
  const auto ours = propagate(flight, turning_start(craft), exact_until(6.0 * s));
  const auto difference = [&](double accuracy, const Quantity<si::time>& scale) {
    const SimbodyPropagation how{.end = 6.0 * s, .accuracy = accuracy, .time_scale = scale};
    const auto found = compare(craft, ours, propagate_with_simbody(flight, turning_start(craft), how));
    return std::max(found.attitude(of<Hub>).size.value(), found.spin(of<WheelOfHub>).size.value());
  };
  for (const auto scale : {1.0 * s, 0.3 * s})
    EXPECT_LT(difference(1e-9, scale), largest_ratio * difference(1e-7, scale)) << scale.value();
}

// A craft whose place is not a state may fall far: that costs no step.
TEST(PropagateWithSimbody, does_not_follow_a_hub_without_a_place) {
  const Turning craft;
  const auto steps = [&](double g) {
    const auto flight = scenario(craft, push_boom, [g](const Now<Turning>&, Forces<Turning>& forces) {
      forces.field(vector(in<Gcrf>, 0.0 * (m_s / s), 0.0 * (m_s / s), g * (m_s / s)));
    });
    return propagate_with_simbody(flight, turning_start(craft), {.end = 6.0 * s, .accuracy = 1e-10})
        .solution()
        .statistics()
        .steps;
  };
  EXPECT_EQ(steps(9.8e6), steps(0.0));
}

// In a long segment the angle of a fast wheel has millions of radians: its rounding, 4e-10 rad here, must not
// be an error of the step. The turn is smooth, and the hub so light that the rounding of the wheel's
// gyroscopic torque does not matter either: then hardly a step is refused.
TEST(PropagateWithSimbody, does_not_shorten_its_steps_for_a_fast_wheel) {
  const auto craft = spacecraft(
      body(
          mass_properties(10.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                          inertia_from_principal_moments(in<Hub>, 1.0 * kg_m2, 1.3 * kg_m2, 1.5 * kg_m2)),
          turning_in<Gcrf>),
      rotor(of<WheelOfHub>, unit_z(in<Hub>), 1e-5 * kg_m2));
  const MovingDcm turning{
      aligned(to<Gcrf>, from<Hub>),
      angular_velocity(of<Hub>, relative_to<Gcrf>, vector(in<Hub>, 0.1 * rad_s, -0.2 * rad_s, 0.3 * rad_s))};
  const auto start = state(craft, 0.0 * s, turning, spins(of<WheelOfHub>, 1e5 * rad_s));
  const auto flown = propagate_with_simbody(scenario(craft), start, {.end = 30.0 * s, .accuracy = 1e-11});
  const auto done = flown.solution().statistics();
  EXPECT_LT(200 * done.error_test_failures, done.steps);
}

}  // namespace
}  // namespace vectrix_test::every_joint::propagate_test
