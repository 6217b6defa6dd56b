#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "craft/named_five.hpp"

// Latches and brakes of a craft with names.
namespace vectrix_test::named_latch_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;
using named_five::five;
using named_five::state_of_five;

const NamedSpacecraft craft(five());
const NamedState moving =
    state_of_five(craft, Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.36, 0.48, 0.8)).toRotationMatrix());

struct Kept {
  Eigen::Vector3d momentum, angular_momentum;
  double energy;
};
Kept kept(const NamedState& state) {
  const auto motion = craft.motion(state, 0.0 * s);
  const auto now = motion.now();
  return {now.momentum().coordinates(), now.angular_momentum().coordinates(), now.energy().value()};
}
/// Of numbers up to those of an orbit, 7e6 m times some 100 N s.
constexpr double rounding = 1e-13;

TEST(NamedLatch, StopsWhatItNamesAndKeepsMomentum) {
  const NamedState after = craft.stopped(moving, {"boom", "wheel", "antenna"}, {locked("mass")});
  EXPECT_EQ(after.angle_rate("boom").value(), 0.0);
  EXPECT_EQ(after.angle_rate("antenna", 1).value(), 0.0);
  EXPECT_EQ(after.angle_rate("antenna", 2).value(), 0.0);
  EXPECT_EQ(after.spin("wheel").value(), 0.0);
  EXPECT_EQ(after.length_rate("mass"), moving.length_rate("mass"));
  EXPECT_EQ(after.angle("boom"), moving.angle("boom"));
  EXPECT_EQ(after.length("mass"), moving.length("mass"));
  EXPECT_NE(after.deflection_rate("first"), moving.deflection_rate("first"));

  const Kept before = kept(moving), then = kept(after);
  EXPECT_LE((then.momentum - before.momentum).norm(), rounding * before.momentum.norm());
  EXPECT_LE((then.angular_momentum - before.angular_momentum).norm(),
            rounding * 7e6 * before.momentum.norm());
  EXPECT_LT(then.energy, before.energy);
}

// One axis of a gimbal keeps its speed, the other gives way.
TEST(NamedLatch, AnAxisKeepsItsSpeed) {
  const auto still = [](const Quantity<si::time>&) { return 0.0 * rad_s / s; };
  const NamedState after = craft.stopped(moving, {"boom"}, {prescribed("antenna", 2, still)});
  EXPECT_EQ(after.angle_rate("antenna", 2), moving.angle_rate("antenna", 2));
  EXPECT_NE(after.angle_rate("antenna", 1), moving.angle_rate("antenna", 1));
}

TEST(NamedLatch, RefusesWhatTheCraftHasNot) {
  const auto refused = [](const std::vector<std::string>& names, const std::vector<NamedHeld>& held = {}) {
    return message<BadInput>([&] { (void)craft.stopped(moving, names, held); });
  };
  EXPECT_TRUE(contains(refused({"bom"}), "\"boom\"")) << refused({"bom"});
  EXPECT_EQ(refused({"boom"}, {locked("boom")}), "the joint of \"boom\" is held twice");
  EXPECT_EQ(refused({"wheel", "wheel"}), "the rotor \"wheel\" is held twice");
  const auto still = [](const Quantity<si::time>&) { return 0.0 * rad_s / s; };
  EXPECT_EQ(refused({}, {prescribed("antenna", 2, still), prescribed("antenna", 2, still)}),
            "the joint of \"antenna\" is held twice");
  EXPECT_EQ(refused({}, {prescribed("antenna", 2, still), prescribed("antenna", 1, still)}), "");
  EXPECT_EQ(refused({}, {prescribed("antenna", 3, still)}),
            "prescribed(\"antenna\"): a gimbal has the axes 1 and 2, not 3");
  EXPECT_EQ(refused({}, {prescribed("boom", 1, still)}),
            "prescribed(\"boom\"): its joint is a hinge, and the acceleration that of a gimbal");
  EXPECT_EQ(refused({}, {prescribed("wheel", 1, still)}),
            "prescribed(\"wheel\"): it is a rotor, and the acceleration that of a gimbal");
  using Rate = std::function<Quantity<si::angular_acceleration>(const Quantity<si::time>&)>;
  using Slide = std::function<Quantity<si::acceleration>(const Quantity<si::time>&)>;
  using Both = std::function<std::array<Quantity<si::angular_acceleration>, 2>(const Quantity<si::time>&)>;
  const auto empty = [](const auto& door) { return message<BadInput>([&] { (void)door(); }); };
  EXPECT_EQ(empty([] { return prescribed("boom", Rate{}); }), "prescribed(\"boom\"): the function is empty");
  EXPECT_EQ(empty([] { return prescribed("mass", Slide{}); }), "prescribed(\"mass\"): the function is empty");
  EXPECT_EQ(empty([] { return prescribed("antenna", Both{}); }),
            "prescribed(\"antenna\"): the function is empty");
  EXPECT_EQ(empty([] { return prescribed("antenna", 1, Rate{}); }),
            "prescribed(\"antenna\"): the function is empty");
  const NamedSpacecraft other(five());
  EXPECT_EQ(message<BadInput>([&] { (void)other.stopped(moving, {"boom"}); }),
            "stopped: the state is of another craft");
}

}  // namespace
}  // namespace vectrix_test::named_latch_test
