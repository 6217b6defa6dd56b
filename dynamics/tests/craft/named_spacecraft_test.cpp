#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "craft/named_five.hpp"
#include "multibody/random_craft.hpp"

// NamedSpacecraft: the same numbers as the engine, and what is refused.
namespace vectrix_test::named_spacecraft_test {
namespace {

using namespace vectrix;
using namespace named_five;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The same craft in names: body 3 is "body 3", the hub "hub".
PlainSpacecraft named(const DescribedCraft& craft) {
  const auto name = [](int number) { return number == 0 ? "hub" : "body " + std::to_string(number); };
  PlainSpacecraft plain{"gcrf", "hub", HubMotion::free, craft.hub.m, craft.hub.c, craft.hub.J, {}, {}, {}};
  for (const Described& b : craft.bodies) {
    std::vector<Vector3d> axes;
    if (b.joint == JointKind::hinge || b.joint == JointKind::slider || b.joint == JointKind::gimbal)
      axes.push_back(b.axis_1);
    if (b.joint == JointKind::gimbal) axes.push_back(b.axis_2);
    plain.bodies.push_back({name(int(plain.bodies.size()) + 1), name(b.parent), b.joint, axes, b.R_p_from_b,
                            b.r_pb_p, b.m, b.c, b.J});
  }
  for (const auto& rotor : craft.rotors)
    plain.rotors.push_back(
        {"rotor " + std::to_string(plain.rotors.size()), name(rotor.body), eigen(rotor.axis), rotor.inertia});
  for (const auto& mode : craft.modes)
    plain.modes.push_back({"mode " + std::to_string(plain.modes.size()), name(mode.body),
                           eigen(mode.rotation), eigen(mode.translation), mode.frequency,
                           mode.damping_ratio});
  return plain;
}

TEST(NamedSpacecraft, GivesTheNumbersOfTheEngine) {
  RandomCraft random(20260320);
  for (int trial = 0; trial < 30; ++trial) {
    const DescribedCraft described = random.craft(random.below(20));
    const Lowered<double> made = lowered<double>(described, HubMotion::free);
    const mb::Tree<double> tree(made.numbers);
    const auto y = random.state(tree);
    std::vector<double> ydot(y.size());
    auto k = tree.work();
    tree.place(y.data(), k);
    tree.solve(y.data(), ydot.data(), k);
    const NamedSpacecraft craft(named(described));
    const auto motion = craft.motion(craft.state(y), 0.0 * si::second);
    double scale = 1.0;
    for (const double number : ydot) scale = std::max(scale, std::abs(number));
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(motion.rates()[i], ydot[i], 1e-10 * scale);
  }
}

TEST(NamedSpacecraft, AStateSaysWhatItWasGiven) {
  RandomCraft random(20260321);
  const NamedSpacecraft craft(five());
  const Matrix3d R = random.rotation();
  const NamedState state = state_of_five(craft, R);
  EXPECT_EQ(state.angle("antenna").value(), 0.1);
  EXPECT_EQ(state.angle_rate("antenna", 1).value(), 0.2);
  EXPECT_EQ(state.angle("antenna", 2).value(), 0.3);
  EXPECT_EQ(state.angle_rate("antenna", 2).value(), 0.4);
  EXPECT_EQ(state.angle("boom").value(), 0.5);
  EXPECT_EQ(state.length("mass").value(), 0.7);
  EXPECT_EQ(state.length_rate("mass").value(), 0.8);
  EXPECT_EQ(state.spin("wheel").value(), 9.0);
  EXPECT_EQ(state.deflection("first"), 0.01);
  EXPECT_EQ(state.deflection_rate("first"), -0.02);
  EXPECT_LE(distance(state.hub_motion().turning().rotation().matrix(), R), rounding);
  EXPECT_EQ(state.hub_motion().translation().coordinates(), Vector3d(7e6, 0.0, 0.0));

  const auto motion = craft.motion(state, 2.0 * si::second);
  const NamedNow now = motion.now();
  EXPECT_EQ(now.time().value(), 2.0);
  EXPECT_LE(distance(now.rotation(To("boom"), From("gyro")).matrix(), R), rounding);
  EXPECT_LE(distance(now.rotation(To("gcrf"), From("hub")).matrix(), R), rounding);
  const auto close = [](const auto& found, const Vector3d& wanted) {
    EXPECT_LE((found.coordinates() - wanted).norm(), 1e-14) << found;
  };
  close(now.position(Of("probe"), RelativeTo("box"), In("box")), {3.0, 2.0, 1.0});
  close(now.angular_velocity(Of("gyro"), RelativeTo("boom"), In("gyro")), {0.1, -0.2, 0.3});
  close(now.velocity(Of("probe"), RelativeTo("box"), ObservedFrom("box"), In("box")), {0.4, 0.5, -0.6});
  close(now.velocity(Of("mass"), RelativeTo("hub"), ObservedFrom("hub"), In("hub")), {0.8, 0.0, 0.0});
  close(now.angular_velocity(Of("hub"), RelativeTo("gcrf"), In("hub")), {0.1, -0.2, 0.3});
  close(now.velocity(Of("hub"), RelativeTo("gcrf"), ObservedFrom("gcrf"), In("gcrf")), {0.4, 0.5, -0.6});
  const Vector3d r = now.position(Of("hub"), RelativeTo("gcrf"), In("gcrf")).coordinates();
  EXPECT_LE((r - Vector3d(7e6, 0.0, 0.0)).norm(), 7e6 * rounding);
}

TEST(NamedSpacecraft, AVelocityIsTheRateOfThePositionThatItsObserverSees) {
  // The places, up to 7 m, are rounded some eight times; step^2 / 6 times a third derivative of order 1e3.
  constexpr double step = 1e-6, tolerance = 8 * 7.0 * epsilon / (2 * step) + step * step / 6 * 1e3;
  RandomCraft random(20260325);
  const NamedSpacecraft craft(five());
  auto y = state_of_five(craft, random.rotation()).numbers();
  y[7] = 1.0;  // near the origin, so that no digit is lost
  const auto motion = craft.motion(craft.state(y), 0.0 * si::second);
  const auto moved = [&](double h) {
    std::vector<double> z(y);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += h * motion.rates()[i];
    return craft.motion(craft.state(z), 0.0 * si::second);
  };
  const auto before = moved(-step), after = moved(step);
  const std::string names[]{"gcrf", "hub", "boom", "antenna", "mass", "gyro", "box", "probe"};
  for (const std::string& of : names) {
    for (const std::string& relative_to : names) {
      for (const std::string& observer : names) {
        if (of == relative_to) continue;
        const auto place = [&](const NamedMotion& at) {
          return Vector3d(at.now().position(Of(of), RelativeTo(relative_to), In(observer)).coordinates());
        };
        const Vector3d rate = (place(after) - place(before)) / (2.0 * step);
        const auto found =
            motion.now().velocity(Of(of), RelativeTo(relative_to), ObservedFrom(observer), In(observer));
        EXPECT_LE((found.coordinates() - rate).norm(), tolerance) << found;
      }
    }
  }
}

TEST(NamedSpacecraft, ARelativeVelocityHasNoDigitsOfTheSpeedInOrbit) {
  RandomCraft random(20260326);
  const NamedSpacecraft craft(five());
  auto y = state_of_five(craft, random.rotation()).numbers();
  const std::string names[]{"hub", "boom", "antenna", "mass", "gyro", "box", "probe"};
  const auto velocity = [&](const NamedMotion& at, const std::string& of, const std::string& relative_to) {
    const auto v = at.now().velocity(Of(of), RelativeTo(relative_to), ObservedFrom("hub"), In("boom"));
    return Vector3d(v.coordinates());
  };
  const auto slow = craft.motion(craft.state(y), 0.0 * si::second);
  y[10] += 7600.0, y[11] -= 3.3;
  const auto fast = craft.motion(craft.state(y), 0.0 * si::second);
  for (const std::string& of : names) {
    for (const std::string& relative_to : names) {
      if (of == relative_to) continue;
      EXPECT_EQ(velocity(fast, of, relative_to), velocity(slow, of, relative_to));
    }
  }
}

TEST(NamedSpacecraft, WhereATurningHubIsIsNotKnown) {
  PlainSpacecraft plain = five();
  plain.motion = HubMotion::turning;
  const NamedSpacecraft craft(plain);
  const NamedState state =
      craft.state(at_origin(craft.inertial(), craft.hub(), Matrix3d::Identity()).turning(),
                  starts_of_five(craft, Matrix3d::Identity()));
  const auto motion = craft.motion(state, 0.0 * si::second);
  const NamedNow now = motion.now();
  EXPECT_LE(now.momentum().coordinates().norm(), 1e-12);
  EXPECT_NEAR(now.position(Of("boom"), RelativeTo("hub"), In("gcrf")).coordinates().x(), 1.0, 1e-15);
  const std::string said =
      message<BadInput>([&] { (void)now.position(Of("boom"), RelativeTo("gcrf"), In("gcrf")); });
  EXPECT_TRUE(contains(said, "the hub \"hub\" is only turning, and where it is is not known")) << said;
  EXPECT_TRUE(contains(message<BadInput>([&] { (void)state.hub_motion(); }), "is only turning"));
}

TEST(NamedSpacecraft, LoadsActOnWhatTheyName) {
  RandomCraft random(20260322);
  const NamedSpacecraft craft(five());
  const Matrix3d R = random.rotation();
  const NamedState state = state_of_five(craft, R);
  const Vector3d F(1.0, -2.0, 0.5), r(0.2, 0.1, 0.7);
  const auto through = [&](const NamedLoads& loads) { return craft.motion(state, 0.0 * si::second, loads); };
  const auto pushed = through([&](const NamedNow& now, NamedForces& forces) {
    const NamedFrame boom = now.frame("boom");
    forces.force(boom, vector<si::length>(In(boom), r), vector<si::force>(In(now.frame("gcrf")), F));
  });
  const auto split = through([&](const NamedNow& now, NamedForces& forces) {
    const NamedFrame boom = now.frame("boom"), gcrf = now.frame("gcrf");
    const Vector3d F_b = now.rotation(To(boom), From(gcrf)).matrix() * F;
    forces.force(boom, vector<si::force>(In(boom), F_b));
    forces.torque(boom, vector<si::torque>(In(boom), Vector3d(r.cross(F_b))));
  });
  const auto alone = through({});
  double moved = 0.0;
  for (std::size_t i = 0; i < pushed.rates().size(); ++i) {
    EXPECT_NEAR(pushed.rates()[i], split.rates()[i], 1e-13);
    moved = std::max(moved, std::abs(pushed.rates()[i] - alone.rates()[i]));
  }
  EXPECT_GT(moved, 1e-3);

  // An effort is what the joint transmits about its axis; the field moves all alike.
  const auto held = through([&](const NamedNow& now, NamedForces& forces) {
    forces.effort("boom", 0.3 * si::newton_metre);
    forces.effort("mass", 0.4 * si::newton);
    forces.effort("antenna", 0.5 * si::newton_metre, 2);
    forces.effort("gyro", vector<si::torque>(In(now.frame("gyro")), F));
    forces.field(vector<si::acceleration>(In(now.frame("gcrf")), F));
  });
  EXPECT_NEAR(held.joint_torque(Of("boom"), In("hub")).coordinates().z(), 0.3, 1e-13);
  EXPECT_NEAR(held.joint_force(Of("mass"), In("hub")).coordinates().x(), 0.4, 1e-13);
  EXPECT_NEAR(held.joint_torque(Of("antenna"), In("antenna")).coordinates().y(), 0.5, 1e-13);
  EXPECT_LE((held.joint_torque(Of("gyro"), In("gyro")).coordinates() - F).norm(), 1e-13);
  const auto free = through([&](const NamedNow& now, NamedForces& forces) {
    forces.field(vector<si::acceleration>(In(now.frame("gcrf")), F));
  });
  const Vector3d difference = free.acceleration(Of("probe"), In("gcrf")).coordinates() -
                              alone.acceleration(Of("probe"), In("gcrf")).coordinates();
  EXPECT_LE((difference - F).norm(), 1e-13);
  EXPECT_LE((free.angular_acceleration(Of("boom"), In("hub")).coordinates() -
             alone.angular_acceleration(Of("boom"), In("hub")).coordinates())
                .norm(),
            1e-13);
}

TEST(NamedSpacecraft, PlainAndBack) {
  const NamedSpacecraft craft(five());
  const PlainSpacecraft plain = craft.plain();
  EXPECT_EQ(plain.bodies[0].name, "boom");  // parents first
  std::ostringstream once, twice;
  once << plain;
  twice << NamedSpacecraft(plain).plain();
  EXPECT_EQ(once.str(), twice.str());
  EXPECT_TRUE(
      contains(once.str(), "\"antenna\" on \"boom\", gimbal (1, 0, 0) (0, 1, 0) at (1, 0.2, 0) m: 2 kg at"));
  EXPECT_TRUE(contains(once.str(), "\"wheel\" in \"boom\", rotor (0, 1, 0): 0.1 kg m^2"));
}

TEST(NamedSpacecraft, OfTypedParts) {
  const auto kg_m2 = si::kilogram_square_metre;
  const auto centre = displacement(of<CentreOfMassOf<ThisBody>>, relative_to<ThisBody>,
                                   vector<si::length>(in<ThisBody>, Vector3d(0.1, 0.0, 0.3)));
  const auto mass =
      mass_properties(2.0 * si::kilogram, centre,
                      inertia_from_principal_moments(in<ThisBody>, 0.5 * kg_m2, 0.6 * kg_m2, 0.7 * kg_m2));
  const Transform<ParentBody, ThisBody> mount{
      turned_z(to<ParentBody>, from<ThisBody>, 0.3 * rad),
      displacement(of<ThisBody>, relative_to<ParentBody>,
                   vector<si::length>(in<ParentBody>, Vector3d(1.0, 2.0, 3.0)))};
  const NamedSpacecraft craft(
      {"hub", "gcrf", HubMotion::turning, mass}, {{"panel", "hub", mass, hinge(mount, unit_y(in<ThisBody>))}},
      {{"wheel", "hub", unit_x(in<ThisBody>), 0.01 * kg_m2}},
      {{"bend", "panel", Vector3d(0.1, 0.0, 0.0), Vector3d::Zero(), 2.0 * rad_s, 0.0}});
  const PlainSpacecraft plain = craft.plain();
  EXPECT_EQ(plain.bodies[0].R_p_from_b, turned_z(to<ParentBody>, from<ThisBody>, 0.3 * rad).matrix());
  EXPECT_EQ(plain.bodies[0].r_pb_p, Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(plain.bodies[0].axes_b[0], Vector3d::UnitY());
  EXPECT_EQ(plain.bodies[0].J_c_b(1, 1), 0.6);
  EXPECT_EQ(plain.modes[0].frequency, 2.0);
}

template <class Change> std::string refused_craft(const Change& change) {
  PlainSpacecraft plain = five();
  change(plain);
  return message<BadInput>([&] { NamedSpacecraft{plain}; });
}

TEST(NamedSpacecraft, RefusesWhatNoCraftHas) {
  const auto refused = [](const auto& change, const std::string& said) {
    const std::string text = refused_craft(change);
    EXPECT_TRUE(contains(text, said)) << text;
  };
  EXPECT_EQ(refused_craft([](auto&) {}), "");
  refused([](auto& craft) { craft.mass = -1.0; }, "\"hub\": mass_properties");
  refused([](auto& craft) { craft.bodies[1].mass = 0.0; },
          "\"boom\": mass_properties(\"boom\"): the mass is 0 kg");
  refused([](auto& craft) { craft.bodies[1].J_c_b(0, 0) = 9.0; }, "\"boom\": inertia_from_tensor");
  refused([](auto& craft) { craft.bodies[1].J_c_b(0, 1) = 0.1; }, "differ by 0.1 kg m^2");
  refused([](auto& craft) { craft.J_c_h(2, 2) = nan; },
          "\"hub\": inertia_from_tensor(in \"hub\"): entry (3, 3) of the tensor is nan kg m^2");
  refused(
      [](auto& craft) {
        craft.J_c_h = Eigen::Vector3d(25.0, 25.0, 25.0).asDiagonal();
        craft.rotors = {{"w1", "hub", Eigen::Vector3d::UnitZ(), 13.0},
                        {"w2", "hub", Eigen::Vector3d::UnitZ(), 13.0}};
      },
      "rotor \"w2\": with it, the rotors of its body \"hub\" have 26 kg m^2 about one axis, the body 25");
  refused([](auto& craft) { craft.bodies[1].r_bc_b.x() = nan; }, "\"boom\": vector(in \"boom\")");
  refused([](auto& craft) { craft.bodies[1].r_pb_p.x() = nan; },
          "\"boom\": the position on the parent (nan, 0.2, 0) is not finite");
  refused([](auto& craft) { craft.bodies[1].R_p_from_b(0, 1) = 0.1; },
          "\"boom\": dcm(to \"hub\", from \"boom\")");
  refused([](auto& craft) { craft.bodies[1].axes_b[0] *= 0.0; },
          "\"boom\": the axis (0, 0, 0) is not a unit vector, its norm is 0");
  refused([](auto& craft) { craft.bodies[1].axes_b[0].x() = nan; }, "not a unit vector");
  for (const double off : {-unit_norm_tolerance, unit_norm_tolerance}) {
    EXPECT_EQ(refused_craft([&](auto& craft) { craft.bodies[1].axes_b[0] *= 1.0 + 0.999 * off; }), "");
    refused([&](auto& craft) { craft.bodies[1].axes_b[0] *= 1.0 + 1.001 * off; }, "not a unit vector");
  }
  refused([](auto& craft) { craft.bodies[1].axes_b.clear(); }, "a hinge joint has 1 axes, not 0");
  refused([](auto& craft) { craft.bodies[0].axes_b[1] = craft.bodies[0].axes_b[0]; },
          "the axes of the gimbal are parallel");
  refused([](auto& craft) { craft.bodies[1].name = "bom"; },
          "\"antenna\": there is no body \"boom\"; the nearest name is \"bom\"");
  refused([](auto& craft) { craft.bodies[1].parent = "hab"; },
          "\"boom\": there is no body \"hab\"; the nearest name is \"hub\"");
  refused([](auto& craft) { craft.bodies[1].parent = "antenna"; },
          "in a loop, \"antenna\" - \"boom\" - \"antenna\"");
  refused([](auto& craft) { craft.bodies[1].parent = "boom"; }, "in a loop, \"boom\" - \"boom\"");
  refused([](auto& craft) { craft.rotors[0].name = "boom"; },
          "the name \"boom\" is that of a body and of a rotor");
  refused([](auto& craft) { craft.inertial = ""; }, "the inertial frame has no name");
  refused([](auto& craft) { craft.rotors[0].body = "whel"; }, "rotor \"wheel\": there is no body \"whel\"");
  refused([](auto& craft) { craft.rotors[0].inertia = 3.0; },
          "its inertia, 3 kg m^2, is more than that of its body \"boom\"");
  refused([](auto& craft) { craft.rotors[0].inertia = nan; }, "its inertia is nan kg m^2");
  refused([](auto& craft) { craft.modes[0].frequency = 0.0; }, "its frequency is 0 rad/s");
  refused([](auto& craft) { craft.modes[0].damping_ratio = -0.1; }, "its damping ratio is -0.1");
  refused([](auto& craft) { craft.modes[0].translation_b.y() = 1.5; },
          "more mass takes part in modes than its body \"antenna\" has");
  refused(
      [](auto& craft) {
        craft.bodies[1].J_c_b = Vector3d(0.5, 0.5, 0.0).asDiagonal();
        craft.bodies[1].r_bc_b = {0.0, 0.0, 1.0};
        craft.rotors.clear();
      },
      "\"boom\": its inertia about the axis of its hinge is 0 kg m^2");
}

// Of three such numbers the product overflows or underflows: the inverse of an inertia was zero.
TEST(NamedSpacecraft, RefusesSizesThatTheEquationsDoNotTake) {
  const auto refused = [](const auto& change, const std::string& said) {
    const std::string text = refused_craft(change);
    EXPECT_TRUE(contains(text, said + "; the equations take 1e-90 to 1e+90")) << text;
  };
  const std::string moments = "the sum of its moments of inertia about its origin is ";
  refused([](auto& craft) { craft.J_c_h = 1e103 * Matrix3d::Identity(); },
          "\"hub\": " + moments + "3e+103 kg m^2");
  refused([](auto& craft) { craft.J_c_h = 1e-105 * Matrix3d::Identity(); },
          "\"hub\": " + moments + "3e-105 kg m^2");
  refused([](auto& craft) { craft.mass = 1e103; }, "\"hub\": its mass is 1e+103 kg");
  refused([](auto& craft) { craft.bodies[3].mass = 1e-103; }, "\"gyro\": its mass is 1e-103 kg");
  refused(
      [](auto& craft) {
        craft.bodies[3].r_bc_b = {0.0, 0x1p200, 0.0};
      },
      "\"gyro\": " + moments + detail::text(0x1p402) + " kg m^2");
  refused([](auto& craft) { craft.rotors[0].inertia = 1e-103; },
          "rotor \"wheel\": its inertia is 1e-103 kg m^2");

  const NamedSpacecraft craft(five());
  auto starts = starts_of_five(craft, Matrix3d::Identity());
  starts[2] = vectrix::starts("mass", 1e60 * si::metre, 0.0 * m_s);
  const std::string far = message<BadInput>([&] {
    (void)craft.motion(craft.state(at_origin(craft.inertial(), craft.hub(), Matrix3d::Identity()), starts),
                       0.0 * si::second);
  });
  EXPECT_TRUE(contains(far, "as it stands, the sum of its moments of inertia about the hub's origin is"))
      << far;
}

// In the range the motion has the digits of the same craft in another unit of mass.
TEST(NamedSpacecraft, MovesAlikeInAnyUnitOfMass) {
  const auto accelerations = [](double unit) {
    PlainSpacecraft plain = five();
    plain.mass *= unit, plain.J_c_h *= unit;
    for (auto& body : plain.bodies) body.mass *= unit, body.J_c_b *= unit;
    plain.rotors[0].inertia *= unit;
    plain.modes.clear();
    const NamedSpacecraft craft(plain);
    auto starts = starts_of_five(craft, Matrix3d::Identity());
    starts.pop_back();
    const auto now =
        craft.motion(craft.state(at_origin(craft.inertial(), craft.hub(), Matrix3d::Identity()), starts),
                     0.0 * si::second);
    return now.angular_acceleration(Of("gyro"), In("gyro")).coordinates().eval();
  };
  const Vector3d usual = accelerations(1.0);
  for (const int power : {-290, 290}) EXPECT_EQ(accelerations(std::ldexp(1.0, power)), usual) << power;
}

TEST(NamedSpacecraft, RefusesStartsThatDoNotFit) {
  const NamedSpacecraft craft(five());
  const Matrix3d unit = Matrix3d::Identity();
  const auto refused = [&](const auto& change, const std::string& said) {
    const std::string text = message<BadInput>([&] {
      auto starts = starts_of_five(craft, unit);
      change(starts);
      (void)craft.state(at_origin(craft.inertial(), craft.hub(), unit), starts);
    });
    EXPECT_TRUE(contains(text, said)) << text;
  };
  refused([](auto& starts) { starts.pop_back(); }, "state: \"first\" has no start");
  refused([](auto& starts) { starts.erase(starts.begin() + 2, starts.end()); },
          "\"mass\" has no start, nor have 4 others");
  refused([](auto& starts) { starts.push_back(starts[1]); }, "the start of \"boom\" is given twice");
  refused([](auto& list) { list[1] = starts("bom", 0.0 * rad, 0.0 * rad_s); },
          "no joint \"bom\" in the craft, which has 6; the nearest name is \"boom\"");
  refused([](auto& list) { list[1] = starts("boom", 0.0 * si::metre, 0.0 * m_s); },
          "the start of \"boom\" is that of a slider, its joint is a hinge");
  refused([](auto& list) { list[1] = starts("boom", nan * rad, 0.0 * rad_s); },
          "position 1 of \"boom\" is nan");
  refused([&](auto& list) { list[3] = starts(at_origin(craft.hub(), craft.frame("gyro"), unit).turning()); },
          "is relative to \"hub\", and it hangs on \"boom\"");
  const auto said = [](const auto& action) { return message<BadInput>(action); };
  EXPECT_TRUE(
      contains(said([&] { (void)craft.state(at_origin(craft.inertial(), craft.hub(), unit).turning(), {}); }),
               "its position and velocity are missing"));
  EXPECT_TRUE(
      contains(said([&] { (void)craft.state(at_origin(craft.hub(), craft.frame("boom"), unit), {}); }),
               "\"hub\" and \"gcrf\" are two frames"));
  EXPECT_TRUE(contains(said([&] { (void)craft.state(std::vector<double>(3)); }),
                       "3 numbers; the craft of \"hub\" has 44"));
  const NamedState state = state_of_five(craft, unit);
  const auto changed = [&](std::size_t at, std::size_t count, double number) {
    auto numbers = state.numbers();
    std::fill_n(numbers.begin() + std::ptrdiff_t(at), count, number);
    return said([&] { (void)craft.state(numbers); });
  };
  // The hub has 13 numbers, then come a hinge, a gimbal and a slider with four positions, the gyro, the
  // probe.
  EXPECT_EQ(changed(5, 1, nan), "state of the craft of \"hub\": wy is nan");
  EXPECT_EQ(changed(0, 4, 0.0), "state of the craft of \"hub\": the quaternion from q0 on has the norm 0");
  EXPECT_TRUE(contains(changed(17, 4, 0.0), "the quaternion from position 1 of \"gyro\" on has the norm 0"));
  EXPECT_TRUE(
      contains(changed(21, 4, 1e200), "the quaternion from position 1 of \"probe\" on has the norm 2e+200"));
  EXPECT_EQ(changed(0, 4, 0.1), "");
  EXPECT_TRUE(
      contains(said([&] { (void)state.angle("mass"); }), "angle 1 of \"mass\": its joint is a slider"));
  EXPECT_TRUE(
      contains(said([&] { (void)state.angle("boom", 2); }), "angle 2 of \"boom\": its joint is a hinge"));
  EXPECT_TRUE(contains(said([&] { (void)state.spin("whee"); }), "the nearest name is \"wheel\""));
  EXPECT_TRUE(contains(said([&] {
                         (void)craft.motion(state, 0.0 * si::second, [](const auto&, auto& forces) {
                           forces.effort("boom", 1.0 * si::newton);
                         });
                       }),
                       "a force along an axis on \"boom\", whose joint is a hinge"));
  const NamedSpacecraft other(five());
  EXPECT_TRUE(
      contains(said([&] { (void)other.motion(state, 0.0 * si::second); }), "the state is of another craft"));
}

}  // namespace
}  // namespace vectrix_test::named_spacecraft_test
