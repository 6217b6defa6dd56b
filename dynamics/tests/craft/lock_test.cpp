#include <gtest/gtest.h>

#include <vectrix/dynamics/craft/motion.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "craft/random_spacecraft.hpp"

// Joints and rotors that a load locks.
namespace vectrix_test::spacecraft_test::lock_test {
namespace {

using namespace vectrix;

const auto push = [](const auto& now, auto& forces) {
  forces.torque(of<Boom>, vector<si::torque>(in<Antenna>, Eigen::Vector3d(0.3, 0.2, -0.9)));
  forces.force(of<Probe>, now.position(of<Gyro>, relative_to<Probe>, in<Hub>),
               vector<si::force>(in<Gcrf>, Eigen::Vector3d(1.0, -2.0, 0.5)));
  forces.effort(of<Boom>, 0.3 * si::newton_metre);
  forces.motor(of<WheelOfHub>, 0.7 * si::newton_metre);
  forces.motor(of<WheelOfBoom>, -0.2 * si::newton_metre);
};
template <class... B> auto locking(Of<B>...) {
  return [](const Now<Every>&, Forces<Every>& forces) { (forces.lock(of<B>), ...); };
}
template <class B> std::string name_of(Of<B>) {
  return frame_name<B>();
}
void expect_same_rates(const auto& found, const auto& wanted) {
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NEAR(found[i], wanted[i], rounding_of_craft * (1.0 + std::abs(wanted[i]))) << i;
}

// As the named craft locks them, which prescribes an acceleration of zero.
TEST(Lock, AJointKeepsItsSpeed) {
  RandomCraft random(20261127);
  for (int trial = 0; trial < 10; ++trial) {
    const Every craft(random);
    const NamedSpacecraft same(plain(craft));
    const auto now = random_state(craft, random);
    const auto compare = [&](const auto&... body) {
      const auto found = motion(craft, now, locking(body...)).rates();
      const auto wanted =
          same.motion(same.state(now.numbers()), 3.0 * s, {}, {locked(name_of(body))...}).rates();
      expect_same_rates(found, wanted);
    };
    compare(of<Boom>);
    compare(of<Antenna>);
    compare(of<Mass>, of<Gyro>);
    compare(of<Probe>, of<Boom>);
  }
}

// The motor torque J_s n.alpha keeps the speed too: the hub and the boom have the same accelerations.
TEST(Lock, ARotorHasTheTorqueThatKeepsItsSpeed) {
  RandomCraft random(20261128);
  for (int trial = 0; trial < 10; ++trial) {
    const Every craft(random);
    const auto now = random_state(craft, random);
    const auto with_lock = motion(craft, now, push, locking(of<WheelOfHub>, of<WheelOfBoom>));
    const auto rotors = plain(craft).rotors;
    const auto needed = [&](const PlainRotor& rotor, const Eigen::Vector3d& alpha_b) {
      return rotor.inertia * rotor.axis_b.dot(alpha_b) * si::newton_metre;
    };
    const auto of_boom = needed(rotors[0], with_lock.angular_acceleration(of<Boom>, in<Boom>).coordinates());
    const auto of_hub = needed(rotors[1], with_lock.angular_acceleration(of<Hub>, in<Hub>).coordinates());
    const auto instead = [&](const Now<Every>&, Forces<Every>& forces) {
      forces.motor(of<WheelOfBoom>, of_boom + 0.2 * si::newton_metre);
      forces.motor(of<WheelOfHub>, of_hub - 0.7 * si::newton_metre);
    };
    expect_same_rates(with_lock.rates(), motion(craft, now, push, instead).rates());
  }
}

// A hub without joints has an inverse of its own in the engine.
TEST(Lock, ALockedRotorOfARigidHubIsPartOfIt) {
  RandomCraft random(20261126);
  const auto properties = mass<Hub>(random, 10.0);
  const auto with_wheels =
      spacecraft(body(properties, free_in<Gcrf>), rotor(of<WheelOfHub>, axis<Hub>(random), 0.3 * kg_m2),
                 rotor(of<WheelOfBoom>, axis<Hub>(random), 0.2 * kg_m2));
  const auto alone = spacecraft(body(properties, free_in<Gcrf>));
  const auto X_i_from_h = moving<Gcrf, Hub>(random);
  const auto pushed = [](const auto&, auto& forces) {
    forces.force(of<Hub>, vector<si::force>(in<Gcrf>, Eigen::Vector3d(1.0, -2.0, 0.5)));
  };
  const auto locks = [](const auto&, auto& forces) {
    forces.lock(of<WheelOfHub>), forces.lock(of<WheelOfBoom>);
  };
  const auto found = motion(with_wheels,
                            state(with_wheels, 0.0 * s, X_i_from_h, spins(of<WheelOfHub>, 0.0 * rad_s),
                                  spins(of<WheelOfBoom>, 0.0 * rad_s)),
                            pushed, locks);
  const auto wanted = motion(alone, state(alone, 0.0 * s, X_i_from_h), pushed);
  for (std::size_t i = 0; i < 13; ++i)
    EXPECT_NEAR(found.rates()[i], wanted.rates()[i], rounding_of_craft) << i;
  EXPECT_EQ(found.rates()[13], 0.0);
  EXPECT_EQ(found.rates()[14], 0.0);
}

}  // namespace
}  // namespace vectrix_test::spacecraft_test::lock_test
