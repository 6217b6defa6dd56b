#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <string_view>

#include "named_values.hpp"

namespace values_test {
namespace {

TEST(NamedValues, PrintWithTheirFrames) {
  NamedGraph graph;
  const NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  const NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  Eigen::Matrix3d quarter_turn;  // about z
  quarter_turn << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  const NamedDcm R_a_from_b = dcm(To(a), From(b), quarter_turn);
  const Eigen::Vector3d v(1, 0, -2);
  const auto w_ab_b = angular_velocity(Of(b), RelativeTo(a), vector<si::angular_velocity>(In(b), v));
  const auto alpha_ab_b =
      angular_acceleration(Of(b), RelativeTo(a), vector<si::angular_acceleration>(In(b), v));
  const auto printed = [](const auto& value) {
    std::ostringstream out;
    out << value;
    return out.str();
  };
  EXPECT_EQ(printed(vector<si::length>(In(a), v)), R"((1, 0, -2) m in "a")");
  EXPECT_EQ(printed(quaternion_scalar_first(To(a), From(b), 1.0, 0.0, 0.0, 0.0)),
            R"((1; 0, 0, 0) to "a" from "b")");
  EXPECT_EQ(printed(accelerating_dcm(R_a_from_b, w_ab_b, alpha_ab_b)),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) rad/s of "b" relative to "a" in "b"; )"
            R"((1, 0, -2) rad/s^2 of "b" relative to "a" in "b")");
  const auto r_ab_a = displacement(Of(b), RelativeTo(a), vector<si::length>(In(a), v));
  const auto v_ab_a = velocity(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::velocity>(In(a), v));
  const auto a_ab_a = acceleration(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::acceleration>(In(a), v));
  EXPECT_EQ(printed(NamedTransform{R_a_from_b, r_ab_a}),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) m of "b" relative to "a" in "a")");
  const std::string moving = printed(moving_dcm(R_a_from_b, w_ab_b)) +
                             R"(; (1, 0, -2) m of "b" relative to "a" in "a"; )"
                             R"((1, 0, -2) m/s of "b" relative to "a" observed from "a" in "a")";
  EXPECT_EQ(printed(NamedMovingTransform{moving_dcm(R_a_from_b, w_ab_b), r_ab_a, v_ab_a}), moving);
  const auto whole = accelerating_dcm(R_a_from_b, w_ab_b, alpha_ab_b);
  EXPECT_EQ(printed(NamedAcceleratingTransform{whole, r_ab_a, v_ab_a, a_ab_a}),
            printed(whole) + moving.substr(moving.find("; (1, 0, -2) m of")) +
                R"(; (1, 0, -2) m/s^2 of "b" relative to "a" observed from "a" in "a")");
  EXPECT_EQ(printed(moving_dcm(R_a_from_b, w_ab_b)),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) rad/s of "b" relative to "a" in "b")");
}

// Typed and named values do not mix. A door does not take a name, because a name does not belong to a graph
// yet.
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class Frame>
concept IsADoor = requires(Frame b, const Eigen::Matrix3d& m) {
  dcm(To(b), From(b), m);
};
static_assert(Multiplies<NamedDcm, NamedDcm> && Multiplies<Dcm<Body, Gcrf>, Dcm<Gcrf, Itrf>>);
static_assert(!Multiplies<NamedDcm, Dcm<Gcrf, Itrf>> && !Multiplies<Dcm<Body, Gcrf>, NamedDcm>);
static_assert(!Multiplies<NamedDcm, Vector<Gcrf, si::length>>);
static_assert(!Multiplies<NamedTransform, Displacement<Gcrf, Body, In<Gcrf>>>);
static_assert(IsADoor<NamedFrame> && !IsADoor<std::string_view>);

}  // namespace
}  // namespace values_test
