#pragma once

#include <gtest/gtest.h>

#include <vectrix/dynamics/craft/state.hpp>

#include "multibody/random_craft.hpp"
#include "short_units.hpp"
#include "testing/attitudes.hpp"

/// A typed spacecraft with every kind of joint, of random numbers, and a random state of it.
namespace vectrix_test::spacecraft_test {

using namespace vectrix;
using namespace vectrix_test::short_units;

struct Gcrf : inertial_frame {};
struct Lvlh : moving_frame {};
struct Hub : moving_frame {};
struct Boom : moving_frame {};
struct Antenna : moving_frame {};
struct Mass : moving_frame {};
struct Gyro : moving_frame {};
struct Box : moving_frame {};
struct Probe : moving_frame {};
struct Both : moving_frame {};
struct Camera : moving_frame {};
struct WheelOfBoom : named_point {};
struct WheelOfHub : named_point {};
struct Blanket : named_point {};
struct Tank : named_point {};

template <Frame B> MassProperties<B> mass(RandomCraft& random, double scale) {
  const Described b = random.body(0, JointKind::free, scale);
  return mass_properties(b.m * si::kilogram,
                         displacement(of<CentreOfMassOf<B>>, relative_to<B>, vector<si::length>(in<B>, b.c)),
                         trust_inertia(in<B>, b.J));
}
template <Frame P, Frame B> Transform<P, B> place(RandomCraft& random) {
  return {dcm(to<P>, from<B>, random.rotation()),
          displacement(of<B>, relative_to<P>, vector<si::length>(in<P>, random.triple()))};
}
template <Frame B> Vector<B, si::dimensionless> axis(RandomCraft& random) {
  return direction(vector<si::length>(in<B>, random.triple()));
}
template <Frame B> FlexibleMode<B> mode(RandomCraft& random) {
  return {0.01 * random.triple(), 0.1 * random.triple(), random.between(0.5, 3.0) * rad_s,
          random.between(0.0, 0.1)};
}

/// Every kind of joint, in a tree; rotors and modes on the hub and on a body; a mount. `place_of_boom` draws
/// where the boom hangs on the hub.
template <class Place> auto make_craft(RandomCraft& random, const Place& place_of_boom) {
  return spacecraft(body(mass<Hub>(random, 10.0), free_in<Gcrf>),
                    body(mass<Boom>(random, 3.0), hinge(place_of_boom(random), axis<Boom>(random))),
                    rotor(of<WheelOfBoom>, axis<Boom>(random), 0.01 * kg_m2),
                    body(mass<Antenna>(random, 10.0),
                         gimbal(place<Boom, Antenna>(random), axis<Antenna>(random), axis<Antenna>(random))),
                    modes(of<Blanket>, on<Antenna>, mode<Antenna>(random), mode<Antenna>(random)),
                    body(mass<Mass>(random, 3.0), slider(place<Hub, Mass>(random), axis<Mass>(random))),
                    body(mass<Gyro>(random, 3.0), ball(place<Boom, Gyro>(random))),
                    mount(place<Antenna, Camera>(random)),
                    body(mass<Box>(random, 3.0), fixed_joint(place<Mass, Box>(random))),
                    modes(of<Tank>, on<Hub>, mode<Hub>(random)),
                    body(mass<Probe>(random, 3.0), free_joint(place<Box, Probe>(random))),
                    rotor(of<WheelOfHub>, axis<Hub>(random), 0.01 * kg_m2));
}
inline auto make_craft(RandomCraft& random) {
  return make_craft(random, place<Hub, Boom>);
}
using RandomBase = decltype(make_craft(std::declval<RandomCraft&>()));
struct Every : RandomBase {
  explicit Every(RandomCraft& random) : RandomBase(make_craft(random)) {}
};

template <Frame A, Frame B> MovingTransform<A, B> moving(RandomCraft& random, double far = 1.0) {
  return {moving_dcm(
              dcm(to<A>, from<B>, random.rotation()),
              angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, random.triple()))),
          displacement(of<B>, relative_to<A>, vector<si::length>(in<A>, far * random.triple())),
          velocity(of<B>, relative_to<A>, observed_from<A>, vector<si::velocity>(in<A>, random.triple()))};
}
inline CraftState<Every> random_state(const Every& craft, RandomCraft& random) {
  return state(craft, 3.0 * s, moving<Gcrf, Hub>(random, 10.0),
               starts(of<Boom>, random.normal() * rad, random.normal() * rad_s),
               spins(of<WheelOfHub>, random.normal() * rad_s),
               starts(of<Antenna>, random.normal() * rad, random.normal() * rad_s, random.normal() * rad,
                      random.normal() * rad_s),
               starts(of<Mass>, random.normal() * si::metre, random.normal() * m_s),
               starts(moving<Boom, Gyro>(random).turning), starts(moving<Box, Probe>(random)),
               deflects(of<Blanket>, std::array{0.1, -0.2}, std::array{0.3, 0.05}),
               deflects(of<Tank>, 0.02, 0.04), spins(of<WheelOfBoom>, random.normal() * rad_s));
}

inline constexpr double rounding_of_craft = 1e-12;  // of sums of some ten products of numbers near 1

inline void expect_same(const Eigen::Vector3d& found, const Eigen::Vector3d& wanted) {
  EXPECT_LE((found - wanted).norm(), rounding_of_craft * (1.0 + wanted.norm()));
}

/// A hub that is only turning, with a panel and a wheel.
inline auto make_turning() {
  RandomCraft random(20260714);
  return spacecraft(body(mass<Hub>(random, 10.0), turning_in<Gcrf>),
                    body(mass<Boom>(random, 1.0), hinge(place<Hub, Boom>(random), axis<Boom>(random))),
                    rotor(of<WheelOfHub>, axis<Hub>(random), 0.05 * kg_m2));
}
struct Turning : decltype(make_turning()) {
  Turning() : decltype(make_turning())(make_turning()) {}
};

}  // namespace vectrix_test::spacecraft_test
