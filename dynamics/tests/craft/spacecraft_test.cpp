#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vectrix/dynamics/craft/graph.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "craft/random_spacecraft.hpp"

// The typed spacecraft: the numbers of NamedSpacecraft, its graph, its laws, and what it refuses at run time.
namespace vectrix_test::spacecraft_test {

const auto some_loads = [](const auto& now, auto& forces) {
  const auto F = vector<si::force>(in<Gcrf>, Eigen::Vector3d(1.0, -2.0, 0.5));
  const auto M = vector<si::torque>(in<Antenna>, Eigen::Vector3d(0.3, 0.2, -0.9));
  forces.torque(of<Boom>, M);
  forces.force(of<Probe>, now.position(of<Gyro>, relative_to<Probe>, in<Hub>), F);
  forces.force(of<Mass>, F);
  forces.effort(of<Boom>, 0.3 * si::newton_metre);
  forces.effort(of<Mass>, 0.4 * si::newton);
  forces.effort(of<Antenna>, 0.1 * si::newton_metre, 0.5 * si::newton_metre);
  forces.effort(of<Gyro>, M);
  forces.motor(of<WheelOfHub>, 0.7 * si::newton_metre);
  forces.modal(of<Blanket>, {0.2, -0.1});
  forces.field(vector<si::acceleration>(in<Mass>, Eigen::Vector3d(0.1, 0.2, 0.3)));
};

NamedLoads the_same_loads() {
  return [](const NamedNow& now, NamedForces& forces) {
    const auto name = [&](const std::string& frame) {
      return now.frame("vectrix_test::spacecraft_test::" + frame);
    };
    const auto full = [&](const char* part) { return "vectrix_test::spacecraft_test::" + std::string(part); };
    const auto F = vector<si::force>(In(name("Gcrf")), Eigen::Vector3d(1.0, -2.0, 0.5));
    const auto M = vector<si::torque>(In(name("Antenna")), Eigen::Vector3d(0.3, 0.2, -0.9));
    forces.torque(name("Boom"), M);
    forces.force(
        name("Probe"),
        vector<si::length>(
            In(name("Hub")),
            now.position(Of(name("Gyro")), RelativeTo(name("Probe")), In(name("Hub"))).coordinates()),
        F);
    forces.force(name("Mass"), F);
    forces.effort(full("Boom"), 0.3 * si::newton_metre);
    forces.effort(full("Mass"), 0.4 * si::newton);
    forces.effort(full("Antenna"), 0.1 * si::newton_metre, 1);
    forces.effort(full("Antenna"), 0.5 * si::newton_metre, 2);
    forces.effort(full("Gyro"), M);
    forces.motor(full("WheelOfHub"), 0.7 * si::newton_metre);
    forces.modal(full("Blanket 1"), 0.2);
    forces.modal(full("Blanket 2"), -0.1);
    forces.field(vector<si::acceleration>(In(name("Mass")), Eigen::Vector3d(0.1, 0.2, 0.3)));
  };
}

/// The named frame of a typed one.
template <Frame F> std::string named() {
  return frame_name<F>();
}

template <Frame B, Frame A, Frame O, Frame D>
void expect_same_places(const Now<Every>& now, const NamedNow& then) {
  const auto frame = [&](const std::string& name) { return then.frame(name); };
  const NamedFrame b = frame(named<B>()), a = frame(named<A>()), o = frame(named<O>()), d = frame(named<D>());
  EXPECT_LE(distance(now.rotation(to<B>, from<A>).matrix(), then.rotation(To(b), From(a)).matrix()),
            rounding_of_craft);
  expect_same(now.angular_velocity(of<B>, relative_to<A>, in<D>).coordinates(),
              then.angular_velocity(Of(b), RelativeTo(a), In(d)).coordinates());
  expect_same(now.position(of<B>, relative_to<A>, in<D>).coordinates(),
              then.position(Of(b), RelativeTo(a), In(d)).coordinates());
  expect_same(now.velocity(of<B>, relative_to<A>, observed_from<O>, in<D>).coordinates(),
              then.velocity(Of(b), RelativeTo(a), ObservedFrom(o), In(d)).coordinates());
}

template <Frame B> void expect_same_motion(const CraftMotion<Every>& motion, const NamedMotion& then) {
  const std::string b = named<B>(), hub = named<Hub>(), gcrf = named<Gcrf>();
  expect_same(motion.angular_acceleration(of<B>, in<Hub>).coordinates(),
              then.angular_acceleration(Of<std::string_view>{b}, In<std::string_view>{hub}).coordinates());
  expect_same(motion.acceleration(of<B>, in<Gcrf>).coordinates(),
              then.acceleration(Of<std::string_view>{b}, In<std::string_view>{gcrf}).coordinates());
  if constexpr (!std::is_same_v<B, Hub>) {
    expect_same(motion.joint_force(of<B>, in<B>).coordinates(),
                then.joint_force(Of<std::string_view>{b}, In<std::string_view>{b}).coordinates());
    expect_same(motion.joint_torque(of<B>, in<Hub>).coordinates(),
                then.joint_torque(Of<std::string_view>{b}, In<std::string_view>{hub}).coordinates());
  }
}

TEST(Spacecraft, HasTheNumbersOfTheNamedForm) {
  RandomCraft random(20260710);
  for (int trial = 0; trial < 20; ++trial) {
    const Every craft(random);
    const NamedSpacecraft same(plain(craft));
    ASSERT_EQ(same.state_size(), Every::state_size);
    const auto now = random_state(craft, random);
    const auto motion = vectrix::motion(craft, now, some_loads);
    const auto then = same.motion(same.state(now.numbers()), 3.0 * s, the_same_loads());
    for (std::size_t i = 0; i < Every::state_size; ++i)
      EXPECT_NEAR(motion.rates()[i], then.rates()[i], rounding_of_craft * (1.0 + std::abs(then.rates()[i])))
          << craft.core()->component_names[i];
    expect_same_places<Antenna, Probe, Gyro, Mass>(motion.now(), then.now());
    expect_same_places<Gcrf, Antenna, Boom, Gcrf>(motion.now(), then.now());
    expect_same_places<Box, Gcrf, Hub, Antenna>(motion.now(), then.now());
    expect_same_places<Hub, Mass, Probe, Hub>(motion.now(), then.now());
    expect_same_places<Gyro, Hub, Gcrf, Boom>(motion.now(), then.now());
    expect_same_motion<Hub>(motion, then);
    expect_same_motion<Boom>(motion, then);
    expect_same_motion<Antenna>(motion, then);
    expect_same_motion<Mass>(motion, then);
    expect_same_motion<Gyro>(motion, then);
    expect_same_motion<Box>(motion, then);
    expect_same_motion<Probe>(motion, then);
    EXPECT_NEAR(motion.energy().value(), then.now().energy().value(), 1e-10);
    expect_same(motion.momentum().coordinates(), then.now().momentum().coordinates());
    expect_same(motion.angular_momentum().coordinates(), then.now().angular_momentum().coordinates());
  }
}

TEST(Spacecraft, AStateSaysWhatItWasGiven) {
  RandomCraft random(20260711);
  const Every craft(random);
  const auto hub = moving<Gcrf, Hub>(random);
  const auto gyro = moving<Boom, Gyro>(random);
  const auto probe = moving<Box, Probe>(random);
  const auto now =
      state(craft, 3.0 * s, hub, starts(of<Boom>, 0.1 * rad, 0.2 * rad_s),
            starts(of<Antenna>, 0.3 * rad, 0.4 * rad_s, 0.5 * rad, 0.6 * rad_s),
            starts(of<Mass>, 0.7 * si::metre, 0.8 * m_s), starts(gyro.turning), starts(probe),
            deflects(of<Blanket>, std::array{0.9, 1.0}, std::array{1.1, 1.2}), deflects(of<Tank>, 1.3, 1.4),
            spins(of<WheelOfBoom>, 1.5 * rad_s), spins(of<WheelOfHub>, 1.6 * rad_s));
  EXPECT_EQ(now.time(), 3.0 * s);
  EXPECT_EQ(now.coordinate(of<Boom>), 0.1 * rad);
  EXPECT_EQ(now.speed(of<Boom>), 0.2 * rad_s);
  EXPECT_EQ(now.coordinate(of<Antenna>)[1], 0.5 * rad);
  EXPECT_EQ(now.speed(of<Antenna>)[0], 0.4 * rad_s);
  EXPECT_EQ(now.coordinate(of<Mass>), 0.7 * si::metre);
  EXPECT_EQ(now.speed(of<Mass>), 0.8 * m_s);
  EXPECT_EQ(now.deflections(of<Blanket>), (std::array{0.9, 1.0}));
  EXPECT_EQ(now.deflection_rates(of<Tank>), (std::array{1.4}));
  EXPECT_EQ(now.spin(of<WheelOfBoom>), 1.5 * rad_s);
  EXPECT_EQ(now.spin(of<WheelOfHub>), 1.6 * rad_s);

  // The graph gives back the motions of the hub and of the ball and free joints.
  const auto graph = frame_graph_of(craft);
  const auto at = graph.at(now);
  const auto expect_turns = [&]<Frame A, Frame B>(const MovingDcm<A, B>& X) {
    EXPECT_LE(distance(at.rotation(to<A>, from<B>).matrix(), X.rotation.matrix()), rounding_of_craft);
    expect_same(at.angular_velocity(of<B>, relative_to<A>, in<B>).coordinates(),
                X.angular_velocity.coordinates());
  };
  const auto expect_moves = [&]<Frame A, Frame B>(const MovingTransform<A, B>& X) {
    expect_turns(X.turning);
    expect_same(at.position(of<B>, relative_to<A>, in<A>).coordinates(), X.translation.coordinates());
    expect_same(at.velocity(of<B>, relative_to<A>, observed_from<A>, in<A>).coordinates(),
                X.velocity.coordinates());
  };
  expect_turns(gyro.turning);
  expect_moves(probe);
  expect_moves(hub);
}

TEST(Spacecraft, OneGraphJoinsTheCraftToOtherFrames) {
  RandomCraft random(20260712);
  const Every craft(random);
  const auto at_3_s = motion(craft, random_state(craft, random), some_loads);
  const auto earth = edge([](Quantity<si::time> t) {
    return MovingDcm{turned_z(to<Gcrf>, from<Lvlh>, 0.1 * rad_s * t),
                     angular_velocity(of<Lvlh>, relative_to<Gcrf>, 0.1 * rad_s * unit_z(in<Lvlh>))};
  });
  const auto graph = frame_graph_of(craft, earth);
  const Now<Every> now = at_3_s.now();
  const auto snapshot = graph.at(at_3_s);
  expect_same(snapshot.velocity(of<Camera>, relative_to<Probe>, observed_from<Gyro>, in<Boom>).coordinates(),
              now.velocity(of<Camera>, relative_to<Probe>, observed_from<Gyro>, in<Boom>).coordinates());
  EXPECT_LE(
      distance(snapshot.rotation(to<Lvlh>, from<Camera>).matrix(),
               (inverse(turned_z(to<Gcrf>, from<Lvlh>, 0.3 * rad)) * now.rotation(to<Gcrf>, from<Camera>))
                   .matrix()),
      rounding_of_craft);
  expect_same(snapshot.angular_velocity(of<Camera>, relative_to<Lvlh>, in<Camera>).coordinates(),
              now.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Camera>).coordinates() -
                  0.1 * now.rotation(to<Camera>, from<Gcrf>).matrix().col(2));

  // The accelerations of the chains of edges are those that the engine found.
  const auto moved = accelerating_frame_graph_of(craft);
  const auto with_rates = moved.at(at_3_s);
  const auto expect_accelerates = [&]<Frame B>(Of<B>) {
    expect_same(with_rates.angular_acceleration(of<B>, relative_to<Gcrf>, in<Hub>).coordinates(),
                at_3_s.angular_acceleration(of<B>, in<Hub>).coordinates());
    expect_same(
        with_rates.acceleration(of<B>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>).coordinates(),
        at_3_s.acceleration(of<B>, in<Gcrf>).coordinates());
  };
  expect_accelerates(of<Boom>);
  expect_accelerates(of<Antenna>);
  expect_accelerates(of<Mass>);
  expect_accelerates(of<Gyro>);
  expect_accelerates(of<Box>);
  expect_accelerates(of<Probe>);
}

TEST(Spacecraft, WhatActsOnAMountActsOnItsBody) {
  RandomCraft random(20260713);
  const Every craft(random);
  const auto now = random_state(craft, random);
  const auto F = vector<si::force>(in<Camera>, random.triple());
  const auto M = vector<si::torque>(in<Gcrf>, random.triple());
  const auto on_mount = motion(craft, now, [&](const auto& at, auto& forces) {
    forces.force(of<Camera>, F);
    forces.force(of<Camera>, at.position(of<Gyro>, relative_to<Camera>, in<Hub>), F);
    forces.torque(of<Camera>, M);
  });
  const auto on_body = motion(craft, now, [&](const auto& at, auto& forces) {
    const auto r = at.position(of<Camera>, relative_to<Antenna>, in<Antenna>);
    const auto F_a = at.rotation(to<Antenna>, from<Camera>) * F;
    forces.wrench(of<Antenna>, wrench(F_a, moment(r, F_a)));
    forces.force(of<Antenna>, at.position(of<Gyro>, relative_to<Antenna>, in<Hub>), F);
    forces.torque(of<Antenna>, M);
  });
  for (std::size_t i = 0; i < Every::state_size; ++i)
    EXPECT_NEAR(on_mount.rates()[i], on_body.rates()[i],
                rounding_of_craft * (1.0 + std::abs(on_body.rates()[i])));
  EXPECT_GT(std::abs(on_mount.rates()[4] - motion(craft, now).rates()[4]), 1e-4);
}

// A start at rest in the local frame of an orbit: the rate relative to inertial axes is the orbit's.
TEST(Spacecraft, AStartRelativeToAnyFrameIsAProduct) {
  RandomCraft random(20260716);
  const Every craft(random);
  const auto X_i_from_lvlh = moving<Gcrf, Lvlh>(random, 1e3);
  const MovingTransform<Lvlh, Hub> X_lvlh_from_hub{
      moving_dcm(dcm(to<Lvlh>, from<Hub>, random.rotation()), at_rest(of<Hub>, relative_to<Lvlh>, in<Hub>)),
      coincident(of<Hub>, relative_to<Lvlh>, in<Lvlh>),
      at_rest(of<Hub>, relative_to<Lvlh>, observed_from<Lvlh>, in<Lvlh>)};
  const auto start = state(
      craft, 0.0 * s, X_i_from_lvlh * X_lvlh_from_hub, starts(of<Boom>, 0.1 * rad, 0.2 * rad_s),
      starts(of<Antenna>, 0.3 * rad, 0.4 * rad_s, 0.5 * rad, 0.6 * rad_s),
      starts(of<Mass>, 0.7 * si::metre, 0.8 * m_s), starts(moving<Boom, Gyro>(random).turning),
      starts(moving<Box, Probe>(random)), deflects(of<Blanket>, std::array{0.0, 0.0}, std::array{0.0, 0.0}),
      deflects(of<Tank>, 0.0, 0.0), spins(of<WheelOfBoom>, 0.0 * rad_s), spins(of<WheelOfHub>, 0.0 * rad_s));
  const auto graph = frame_graph_of(craft, edge([&](const CraftState<Every>&) { return X_i_from_lvlh; }));
  EXPECT_LE(graph.at(start).angular_velocity(of<Hub>, relative_to<Lvlh>, in<Hub>).coordinates().norm(),
            rounding_of_craft);
  EXPECT_LE(graph.at(start)
                .velocity(of<Hub>, relative_to<Lvlh>, observed_from<Lvlh>, in<Lvlh>)
                .coordinates()
                .norm(),
            1e-11);  // of a difference of rates near 1 rad/s times 1e3 m
  expect_same(start.turning().angular_velocity.coordinates(),
              X_lvlh_from_hub.turning.rotation.matrix().transpose() *
                  X_i_from_lvlh.turning.angular_velocity.coordinates());
}

struct Tip : moving_frame {};
auto make_tether(double J_hub, const Vector3d& along) {
  const auto n = direction(vector<si::length>(in<Tip>, along));
  const auto point = [](auto B, double kg, double J) {
    using F = decltype(B);
    return mass_properties(kg * si::kilogram, coincident(of<CentreOfMassOf<F>>, relative_to<F>, in<F>),
                           inertia_from_principal_moments(in<F>, J * kg_m2, J * kg_m2, J * kg_m2));
  };
  return spacecraft(
      body(point(Hub{}, 500.0, J_hub), free_in<Gcrf>),
      body(point(Tip{}, 20.0, 0.0), slider(Transform{aligned(to<Hub>, from<Tip>),
                                                     displacement(of<Tip>, relative_to<Hub>,
                                                                  vector<si::length>(in<Hub>, 1e5 * along))},
                                           n)));
}
// Two point masses on a line do not turn about it; beside 1e5 m a small satellite does, and so does a body
// far off on a free joint.
TEST(Spacecraft, MassOnALineIsRefused) {
  const auto at_origin = MovingTransform<Gcrf, Hub>{
      moving_dcm(aligned(to<Gcrf>, from<Hub>), at_rest(of<Hub>, relative_to<Gcrf>, in<Hub>)),
      coincident(of<Hub>, relative_to<Gcrf>, in<Gcrf>),
      at_rest(of<Hub>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
  const auto start = [&](const auto& craft) {
    return state(craft, 0.0 * s, at_origin, starts(of<Tip>, 0.0 * si::metre, 0.0 * m_s));
  };
  for (const Vector3d& along :
       {Vector3d(1.0, 0.0, 0.0), Vector3d(0.36, 0.48, 0.8), Vector3d(0.6, 0.0, 0.8)}) {
    const std::string said = message<BadInput>([&] { (void)start(make_tether(0.0, along)); });
    EXPECT_TRUE(contains(said, "Hub\": as it stands, it has no inertia about the axis (")) << said;
    const auto thin = make_tether(1.0, along);
    EXPECT_NO_THROW((void)motion(thin, start(thin)));
  }
}

TEST(Spacecraft, BadNumbersAreRefusedWithTheFrame) {
  RandomCraft random(20260717);
  const auto refused = [](const auto& call, const std::string& said) {
    const std::string text = message<BadInput>(call);
    EXPECT_TRUE(contains(text, said)) << text;
  };
  const auto hub = body(mass<Hub>(random, 10.0), turning_in<Gcrf>);
  const auto boom = place<Hub, Boom>(random);
  const auto boom_mass = mass<Boom>(random, 1.0);
  refused([&] { spacecraft(hub, rotor(of<WheelOfHub>, unit_x(in<Hub>), 1e6 * kg_m2)); },
          "Spacecraft: rotor \"vectrix_test::spacecraft_test::WheelOfHub\": its inertia, 1e+06 kg m^2");
  refused([&] { spacecraft(hub, body(boom_mass, hinge(boom, 2.0 * unit_x(in<Boom>)))); },
          "the axis (2, 0, 0) is not a unit vector");
  const Turning craft;
  const auto R = moving<Gcrf, Hub>(random).turning;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused(
      [&] {
        state(craft, 0.0 * s, R, starts(of<Boom>, 0.0 * rad, nan * rad_s),
              spins(of<WheelOfHub>, 0.0 * rad_s));
      },
      "speed 1 of \"vectrix_test::spacecraft_test::Boom\" is nan");
  const auto start =
      state(craft, 0.0 * s, R, starts(of<Boom>, 0.0 * rad, 0.0 * rad_s), spins(of<WheelOfHub>, 0.0 * rad_s));
  auto numbers = start.numbers();
  EXPECT_EQ(state_from_numbers(craft, 1.0 * s, numbers).numbers(), numbers);
  refused([&] { state_from_numbers(craft, nan * s, numbers); }, "the time is nan s");
  numbers[5] = nan;
  refused([&] { state_from_numbers(craft, 1.0 * s, numbers); }, "Hub\": wy is nan");
  numbers = {0.0, 0.0, 0.0, 0.0, 1.0};
  refused([&] { state_from_numbers(craft, 1.0 * s, numbers); }, "the quaternion from q0 on has the norm 0");
  refused(
      [&] {
        motion(craft, start,
               [&](const auto&, auto& forces) { forces.motor(of<WheelOfHub>, nan * si::newton_metre); });
      },
      "at 0 s: the derivative of ");
}

}  // namespace vectrix_test::spacecraft_test
