#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <vectrix/kinematics/named/dcm_doors.hpp>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace values_test {
namespace {

/// Four frames, and values that relate them.
struct Values {
  NamedGraph graph;
  NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  NamedFrame c = graph.add_frame("c", FrameMotion::moving);
  NamedFrame d = graph.add_frame("d", FrameMotion::moving);
  Eigen::Matrix3d R1 = *rotation_matrix(), R2 = *rotation_matrix();
  Eigen::Vector3d v1 = *triple(), v2 = *triple();

  NamedAngularVelocity w(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                         const Eigen::Vector3d& v) const {
    return angular_velocity(Of(of), RelativeTo(relative_to), vector<si::angular_velocity>(In(in), v));
  }
  NamedAngularAcceleration alpha(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                                 const Eigen::Vector3d& v) const {
    return angular_acceleration(Of(of), RelativeTo(relative_to), vector<si::angular_acceleration>(In(in), v));
  }
};

template <class Action> std::string refusal(const Action& action) {
  return message<BadInput>(action);
}

RC_GTEST_PROP(NamedDcm, FollowsTheLawsOfDcm, ()) {
  const Values x;
  const NamedDcm R_c_from_b = dcm(To(x.c), From(x.b), x.R1);
  const NamedDcm R_b_from_a = dcm(To(x.b), From(x.a), x.R2);
  const NamedDcm R_c_from_a = R_c_from_b * R_b_from_a;
  RC_ASSERT(R_c_from_a.to() == x.c && R_c_from_a.from() == x.a);
  RC_ASSERT(distance(R_c_from_a.matrix(), x.R1 * x.R2) <= rounding);
  RC_ASSERT(inverse(R_c_from_b).to() == x.b && inverse(R_c_from_b).from() == x.c);
  RC_ASSERT(inverse(R_c_from_b).matrix() == x.R1.transpose());
  const auto r_a = vector<si::length>(In(x.a), x.v1);
  const NamedVector<si::length> r_b = R_b_from_a * r_a;
  RC_ASSERT(r_b.in() == x.b && distance(r_b.coordinates(), x.R2 * x.v1) <= rounding);
  RC_ASSERT(distance((r_b + r_b - -r_b).coordinates(), 3 * r_b.coordinates()) <= rounding);
  RC_ASSERT(distance(dcm(quaternion(R_c_from_b)).matrix(), x.R1) <= rounding);
}

RC_GTEST_PROP(NamedDcm, InnerFramesThatDifferAreRefused, ()) {
  const Values x;
  const NamedDcm R = dcm(To(x.c), From(x.b), x.R1);
  RC_ASSERT(refusal([&] { R* dcm(To(x.a), From(x.b), x.R2); }) ==
            R"(product of R to "c" from "b" and R to "a" from "b": "b" and "a" are two frames)");
  RC_ASSERT(refusal([&] { R* vector<si::length>(In(x.c), x.v1); }) ==
            R"(product of R to "c" from "b" and a vector in "c": "b" and "c" are two frames)");
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), x.v1) + vector<si::length>(In(x.c), x.v1); }) ==
            R"(sum of two vectors: "a" and "c" are two frames)");
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), x.v1) - vector<si::length>(In(x.c), x.v1); }) ==
            R"(difference of two vectors: "a" and "c" are two frames)");
  const Values other;
  RC_ASSERT(refusal([&] { R* dcm(To(other.b), From(other.a), x.R2); }) ==
            R"(product of R to "c" from "b" and R to "b" from "a": "b" and "b" are frames of two graphs)");
}

// The doors are those of Dcm, with the same errors.
RC_GTEST_PROP(NamedDcm, DoorsAreThoseOfDcm, ()) {
  const Values x;
  const auto angle = *coordinate() * si::radian;
  const auto b = To(x.b);
  const auto a = From(x.a);
  RC_ASSERT(turned_x(b, a, angle).matrix() == turned_x(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(turned_y(b, a, angle).matrix() == turned_y(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(turned_z(b, a, angle).matrix() == turned_z(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(aligned(b, a).matrix() == Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d rough = x.R1 + 1e-3 * x.R2;
  RC_ASSERT(trust_dcm(b, a, rough).matrix() == rough);
  const auto nearest = nearest_dcm(b, a, rough);
  const auto expected = nearest_dcm(to<Body>, from<Gcrf>, rough);
  RC_ASSERT(nearest.dcm.matrix() == expected.dcm.matrix() && nearest.distance == expected.distance);
  RC_ASSERT(nearest.dcm.to() == x.b && nearest.dcm.from() == x.a);
  RC_ASSERT(contains(refusal([&] { dcm(b, a, rough); }), R"(dcm(to<"b">, from<"a">): M^T M differs)"));
  RC_ASSERT(refusal([&] { nearest_dcm(b, a, Eigen::Matrix3d(-Eigen::Matrix3d::Identity())); }) ==
            R"(nearest_dcm(to<"b">, from<"a">): the determinant is -1; a rotation is right-handed)");
  const auto infinite = std::numeric_limits<double>::infinity() * si::radian;
  RC_ASSERT(refusal([&] { turned_z(b, a, infinite); }) ==
            R"(turned_z(to<"b">, from<"a">): the angle is inf)");
  RC_ASSERT(contains(refusal([&] { quaternion_scalar_first(b, a, 1.0, 1.0, 0.0, 0.0); }),
                     R"(quaternion_scalar_first(to<"b">, from<"a">): the norm differs)"));
  RC_ASSERT(quaternion_scalar_last(b, a, 1.0, 0.0, 0.0, 0.0).eigen().x() == 1.0);
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), Eigen::Vector3d(0, NAN, 1)); }) ==
            R"(vector(in<"a">): the coordinates (0, nan, 1) are not finite)");
}

RC_GTEST_PROP(NamedDcm, TheDoorsTakeTwoFrames, ()) {
  const Values x;
  const std::string one = R"(to "a", from "a": a door takes two frames, and these are one)";
  RC_ASSERT(refusal([&] { dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { nearest_dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { trust_dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { aligned(To(x.a), From(x.a)); }) == one);
  RC_ASSERT(refusal([&] { turned_z(To(x.a), From(x.a), 1.0 * si::radian); }) == one);
  RC_ASSERT(refusal([&] { quaternion_scalar_first(To(x.a), From(x.a), 1.0, 0.0, 0.0, 0.0); }) == one);
  const std::string still = R"(of "a" relative to "a": a frame does not move relative to itself)";
  RC_ASSERT(refusal([&] { x.w(x.a, x.a, x.c, x.v1); }) == still);
  RC_ASSERT(refusal([&] { x.alpha(x.a, x.a, x.c, x.v1); }) == still);
}

// A chain gives another quantity, as with types: w_ab += w_bc would be w_ac.
template <class Rate>
concept ChainsInPlace = requires(Rate& rate) {
  rate += rate;
};
static_assert(!ChainsInPlace<NamedAngularVelocity>);
// An edge refers to its graph, so the graph must have a name.
template <class Graph>
concept GivesAnEdge = requires(Graph&& graph) {
  std::forward<Graph>(graph).template typed_edge<Dcm<Gcrf, Body>>();
};
static_assert(GivesAnEdge<const NamedGraph&> && !GivesAnEdge<NamedGraph>);

RC_GTEST_PROP(NamedRate, FollowsTheLawsOfAngularVelocity, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  const auto w_bd_c = x.w(x.d, x.b, x.c, x.v2);
  for (const auto& w_ad_c : {w_ab_c + w_bd_c, w_bd_c + w_ab_c}) {
    RC_ASSERT(w_ad_c.of() == x.d && w_ad_c.relative_to() == x.a && w_ad_c.in() == x.c);
    RC_ASSERT(w_ad_c.coordinates() == x.v1 + x.v2);
  }
  const auto w_ba_c = -w_ab_c;
  RC_ASSERT(w_ba_c.of() == x.a && w_ba_c.relative_to() == x.b && w_ba_c.coordinates() == -x.v1);
  const auto w_ab_d = dcm(To(x.d), From(x.c), x.R1) * w_ab_c;
  RC_ASSERT(w_ab_d.of() == x.b && w_ab_d.in() == x.d);
  RC_ASSERT(distance(w_ab_d.coordinates(), x.R1 * x.v1) <= rounding);
  const auto alpha_ad_c = chain(x.alpha(x.b, x.a, x.c, x.v2), x.alpha(x.d, x.b, x.c, x.v1), w_ab_c, w_bd_c);
  RC_ASSERT(alpha_ad_c.of() == x.d && alpha_ad_c.relative_to() == x.a && alpha_ad_c.in() == x.c);
  RC_ASSERT(distance(alpha_ad_c.coordinates(), x.v2 + x.v1 + x.v1.cross(x.v2)) <= rounding);
}

RC_GTEST_PROP(NamedRate, PairsThatDoNotChainAreRefused, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  RC_ASSERT(
      refusal([&] { w_ab_c + x.w(x.d, x.c, x.c, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "d" relative to "c" in "c": "b" and "c" are two frames)");
  RC_ASSERT(
      refusal([&] { w_ab_c + x.w(x.d, x.b, x.a, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "d" relative to "b" in "a": "c" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] { dcm(To(x.d), From(x.a), x.R1) * w_ab_c; }) ==
      R"(product of R to "d" from "a" and w of "b" relative to "a" in "c": "a" and "c" are two frames)");
  const auto alpha_ab_c = x.alpha(x.b, x.a, x.c, x.v1), alpha_bd_c = x.alpha(x.d, x.b, x.c, x.v1);
  const auto w_bd_c = x.w(x.d, x.b, x.c, x.v2);
  const auto refused = [&](const auto& a1, const auto& a2, const auto& w1, const auto& w2) {
    return contains(refusal([&] { chain(a1, a2, w1, w2); }), "chain of alpha of ");
  };
  RC_ASSERT(refused(alpha_bd_c, alpha_ab_c, w_ab_c, w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_bd_c, w_ab_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_ab_c, x.w(x.d, x.b, x.a, x.v2)));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, x.w(x.b, x.a, x.a, x.v2), w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, x.alpha(x.d, x.b, x.a, x.v1), w_ab_c, w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, x.w(x.b, x.d, x.c, x.v2), w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_ab_c, x.w(x.a, x.b, x.c, x.v2)));
}

RC_GTEST_PROP(NamedMovingDcm, JoinsWhatBelongsTogether, ()) {
  const Values x;
  const NamedDcm R = dcm(To(x.a), From(x.b), x.R1);
  const auto in_b = accelerating_dcm(R, x.w(x.b, x.a, x.b, x.v1), x.alpha(x.b, x.a, x.b, x.v2));
  RC_ASSERT(in_b.angular_velocity().coordinates() == x.v1 &&
            in_b.angular_acceleration().coordinates() == x.v2);
  const auto in_a = accelerating_dcm(R, x.w(x.b, x.a, x.a, x.v1), x.alpha(x.b, x.a, x.a, x.v2));
  RC_ASSERT(in_a.angular_velocity().in() == x.b && in_a.angular_acceleration().in() == x.b);
  RC_ASSERT(distance(in_a.angular_velocity().coordinates(), x.R1.transpose() * x.v1) <= rounding);
  RC_ASSERT(distance(in_a.angular_acceleration().coordinates(), x.R1.transpose() * x.v2) <= rounding);
  RC_ASSERT(refusal([&] { moving_dcm(R, x.w(x.a, x.b, x.b, x.v1)); }) ==
            R"(moving_dcm(R to "a" from "b", w of "a" relative to "b" in "b"): "a" and "b" are two frames)");
  RC_ASSERT(refusal([&] { moving_dcm(R, x.w(x.b, x.a, x.c, x.v1)); }) ==
            R"(moving_dcm(R to "a" from "b", w of "b" relative to "a" in "c"): "b" and "c" are two frames)");
  RC_ASSERT(
      contains(refusal([&] { accelerating_dcm(R, x.w(x.b, x.a, x.b, x.v1), x.alpha(x.c, x.a, x.b, x.v1)); }),
               R"(accelerating_dcm(R to "a" from "b", alpha of "c" relative to "a" in "b"): )"));
}

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
static_assert(IsADoor<NamedFrame> && !IsADoor<std::string_view>);

}  // namespace
}  // namespace values_test
