#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tuple>
#include <utility>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace bridge_test {
namespace {

constexpr auto now = 0.0 * si::second;

template <class A, class B> auto constant_edge(const Dcm<A, B, Dual2>& R_a_from_b) {
  return edge([value = Motion(R_a_from_b).accelerating()](Quantity<si::time>) { return value; });
}

/// Gcrf -- Body -- Camera -- Wheel<1>, and Gcrf -- Ground, edges in both directions, as a typed graph and as
/// a named graph.
struct Both {
  Dual2 t = instant(*coordinate());
  Dcm<Gcrf, Body, Dual2> gcrf_from_body = turning<Gcrf, Body>(0.7, t);
  Dcm<Camera, Body, Dual2> camera_from_body = turning<Camera, Body>(-1.3, t);
  Dcm<Camera, Wheel<1>, Dual2> camera_from_wheel = turning<Camera, Wheel<1>>(0.2, t);
  Dcm<Gcrf, Ground> gcrf_from_ground = trust_dcm(to<Gcrf>, from<Ground>, *rotation_matrix());

  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame<Gcrf>("gcrf");
  NamedFrame body = graph.add_frame<Body>("body");
  NamedFrame camera = graph.add_frame<Camera>("camera");
  NamedFrame wheel = graph.add_frame<Wheel<1>>("wheel 1");
  NamedFrame ground = graph.add_frame<Ground>("ground");

  Both() {
    graph.add_edge(constant_edge(camera_from_body));
    graph.add_edge(rigid_edge(gcrf_from_ground));
    graph.add_edge(constant_edge(gcrf_from_body));
    graph.add_edge(constant_edge(camera_from_wheel));
  }
  auto types() const {
    return frame_graph(constant_edge(gcrf_from_body), constant_edge(camera_from_body),
                       constant_edge(camera_from_wheel), rigid_edge(gcrf_from_ground));
  }
};

template <std::size_t n>
using FrameOf = std::tuple_element_t<n, std::tuple<Gcrf, Body, Camera, Wheel<1>, Ground>>;

/// The b-th and a-th of the frames, and a third.
template <std::size_t b, std::size_t a> struct Triple {
  using B = FrameOf<b>;
  using A = FrameOf<a>;
  using C = FrameOf<(b + a) % 5>;
};
/// Calls check with each two frames in one order, each frame as often first as last, and with a frame twice.
template <class Check> void for_pairs_of_types(const Check& check) {
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    ((check(Triple<n, (n + 1) % 5>{}), check(Triple<n, (n + 2) % 5>{})), ...);
  }
  (std::make_index_sequence<5>{});
  check(Triple<2, 2>{});
}

// The same numbers as in the typed graph, at every level, from typed edges, with queries by type and by
// handle. What a query by handle answers of two frames in the other order is the opposite.
RC_GTEST_PROP(NamedBridge, AnswersAsTheGraphOfTypesDoes, ()) {
  const Both both;
  const auto types = both.types();
  const auto typed = types.at(now);
  const NamedSnapshot named = both.graph.at(now);
  for_pairs_of_types([&]<class Triple>(Triple) {
    using B = typename Triple::B;
    using A = typename Triple::A;
    using C = typename Triple::C;
    const Dcm<B, A> R = named.rotation(to<B>, from<A>);
    RC_ASSERT(distance(R.matrix(), typed.rotation(to<B>, from<A>).matrix()) <= motion_tolerance);
    const NamedFrame b = both.graph.frame<B>(), a = both.graph.frame<A>(), c = both.graph.frame<C>();
    RC_ASSERT(named.rotation(To(b), From(a)).matrix() == R.matrix());
    RC_ASSERT(distance(named.rotation(To(a), From(b)).matrix(), R.matrix().transpose()) <= motion_tolerance);
    if constexpr (!std::same_as<A, B>) {
      const AngularVelocity<A, B, In<C>> w = named.angular_velocity(of<B>, relative_to<A>, in<C>);
      const auto w_typed = typed.angular_velocity(of<B>, relative_to<A>, in<C>);
      RC_ASSERT(distance(w.coordinates(), w_typed.coordinates()) <= motion_tolerance);
      RC_ASSERT(named.angular_velocity(Of(b), RelativeTo(a), In(c)).coordinates() == w.coordinates());
      RC_ASSERT(distance(named.angular_velocity(Of(a), RelativeTo(b), In(c)).coordinates(),
                         -w.coordinates()) <= motion_tolerance);
      const AngularAcceleration<A, B, In<C>> alpha = named.angular_acceleration(of<B>, relative_to<A>, in<C>);
      const auto alpha_typed = typed.angular_acceleration(of<B>, relative_to<A>, in<C>);
      RC_ASSERT(distance(alpha.coordinates(), alpha_typed.coordinates()) <= motion_tolerance);
      RC_ASSERT(named.angular_acceleration(Of(b), RelativeTo(a), In(c)).coordinates() == alpha.coordinates());
      RC_ASSERT(distance(named.angular_acceleration(Of(a), RelativeTo(b), In(c)).coordinates(),
                         -alpha.coordinates()) <= motion_tolerance);
    }
  });
}

// A handle, a name and a type may be mixed in one query; the answer is then named.
RC_GTEST_PROP(NamedBridge, TypesNamesAndHandlesMix, ()) {
  const Both both;
  const NamedSnapshot named = both.graph.at(now);
  const NamedDcm R = named.rotation(to<Camera>, From("gcrf"));
  RC_ASSERT(R.to() == both.camera && R.from() == both.gcrf);
  RC_ASSERT(R.matrix() == named.rotation(to<Camera>, from<Gcrf>).matrix());
  const NamedAngularVelocity w = named.angular_velocity(Of(both.camera), relative_to<Gcrf>, in<Camera>);
  RC_ASSERT(w.coordinates() ==
            named.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Camera>).coordinates());
}

// An answer of the run-time graph can be an edge of a typed graph, at each level.
RC_GTEST_PROP(NamedBridge, AnswersAreEdgesOfTheGraphOfTypes, ()) {
  const Both both;
  const auto R_itrf_from_wheel = turned_x(to<Itrf>, from<Wheel<1>>, 0.4 * si::radian);
  const auto expected = both.graph.at(now);
  const auto R_itrf_from_ground = R_itrf_from_wheel * expected.rotation(to<Wheel<1>>, from<Ground>);
  const auto fixed =
      frame_graph(both.graph.typed_edge<Dcm<Ground, Wheel<1>>>(), static_edge(R_itrf_from_wheel));
  RC_ASSERT(distance(fixed.at(now).rotation(to<Itrf>, from<Ground>).matrix(), R_itrf_from_ground.matrix()) <=
            motion_tolerance);
  const auto moving =
      frame_graph(both.graph.typed_edge<MovingDcm<Ground, Wheel<1>>>(), rigid_edge(R_itrf_from_wheel));
  const auto w = expected.angular_velocity(of<Wheel<1>>, relative_to<Ground>, in<Ground>);
  RC_ASSERT(distance(moving.at(now).angular_velocity(of<Itrf>, relative_to<Ground>, in<Ground>).coordinates(),
                     w.coordinates()) <= motion_tolerance);
  const auto accelerating =
      frame_graph(both.graph.typed_edge<AcceleratingDcm<Ground, Wheel<1>>>(), rigid_edge(R_itrf_from_wheel));
  const auto alpha = expected.angular_acceleration(of<Wheel<1>>, relative_to<Ground>, in<Ground>);
  RC_ASSERT(
      distance(
          accelerating.at(now).angular_acceleration(of<Itrf>, relative_to<Ground>, in<Ground>).coordinates(),
          alpha.coordinates()) <= 10 * motion_tolerance);
}

RC_GTEST_PROP(NamedBridge, ValuesGoBothWays, ()) {
  const Both both;
  const NamedSnapshot at = both.graph.at(now);
  const NamedGraph& graph = both.graph;
  const auto R = at.rotation(to<Camera>, from<Gcrf>);
  RC_ASSERT(graph.named(R).to() == both.camera && graph.named(R).from() == both.gcrf);
  RC_ASSERT(graph.typed(to<Camera>, from<Gcrf>, graph.named(R)).matrix() == R.matrix());
  const auto r = vector<si::length>(in<Body>, *triple());
  RC_ASSERT(graph.named(r).in() == both.body);
  RC_ASSERT(graph.typed(in<Body>, graph.named(r)).coordinates() == r.coordinates());
  const auto w = at.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Body>);
  const auto named_w = graph.named(w);
  RC_ASSERT(named_w.of() == both.camera && named_w.relative_to() == both.gcrf && named_w.in() == both.body);
  const AngularVelocity<Gcrf, Camera, In<Body>> w_again =
      graph.typed(of<Camera>, relative_to<Gcrf>, in<Body>, named_w);
  RC_ASSERT(w_again.coordinates() == w.coordinates());
  const auto alpha = at.angular_acceleration(of<Camera>, relative_to<Gcrf>, in<Body>);
  const auto named_alpha = graph.named(alpha);
  RC_ASSERT(named_alpha.of() == both.camera && named_alpha.relative_to() == both.gcrf);
  const AngularAcceleration<Gcrf, Camera, In<Body>> alpha_again =
      graph.typed(of<Camera>, relative_to<Gcrf>, in<Body>, named_alpha);
  RC_ASSERT(alpha_again.coordinates() == alpha.coordinates());
}

class NamedBridgeErrors : public testing::Test {
 protected:
  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame<Gcrf>("gcrf");
  NamedFrame body = graph.add_frame("body", FrameMotion::moving);
  NamedFrame camera = graph.add_frame("camera", FrameMotion::moving);

  template <class Action> static void expect(const std::string& text, const Action& action) {
    EXPECT_EQ(message<BadInput>(action), text);
  }
};
const std::string Body_ = frame_name<Body>();
const std::string Gcrf_ = frame_name<Gcrf>();
const std::string Itrf_ = frame_name<Itrf>();

TEST_F(NamedBridgeErrors, ATypeAndAFrameAreBoundOnce) {
  graph.bind<Body>("body");
  expect("bind<" + Body_ + R"(>("camera"): the type is bound to the frame "body" already)",
         [&] { graph.bind<Body>(camera); });
  expect("bind<" + frame_name<Camera>() + R"(>("body"): the frame is bound to a type already)",
         [&] { graph.bind<Camera>(body); });
  expect(R"(add_frame: the type is bound to the frame "body" already)",
         [&] { graph.add_frame<Body>("hull"); });
  expect(R"(no frame "hull" in the graph, which has 3 frames)", [&] { graph.bind<Camera>("hull"); });
  NamedGraph other;
  expect(R"(the frame "camera" belongs to another graph)", [&] { other.bind<Camera>(camera); });
  EXPECT_EQ(graph.frame<Body>(), body);
}

TEST_F(NamedBridgeErrors, TheMotionOfTypeAndFrameAgrees) {
  const NamedFrame icrf = graph.add_frame("icrf", FrameMotion::inertial);
  EXPECT_EQ(gcrf.motion(), FrameMotion::inertial);
  expect("bind<" + Body_ + R"(>("icrf"): the type is moving, the frame inertial)",
         [&] { graph.bind<Body>(icrf); });
  struct Icrf : inertial_frame {};
  expect("bind<" + frame_name<Icrf>() + R"(>("body"): the type is inertial, the frame moving)",
         [&] { graph.bind<Icrf>("body"); });
}

TEST_F(NamedBridgeErrors, AnUnboundTypeIsNoFrame) {
  expect("no frame of the graph is bound to the type " + Itrf_,
         [&] { graph.at(now).rotation(to<Itrf>, from<Gcrf>); });
  expect("no frame of the graph is bound to the type " + Itrf_,
         [&] { graph.add_edge(static_edge(aligned(to<Gcrf>, from<Itrf>))); });
  expect("no frame of the graph is bound to the type " + Itrf_,
         [&] { graph.named(aligned(to<Gcrf>, from<Itrf>)); });
}

TEST_F(NamedBridgeErrors, AValueOfOtherFramesIsNotTyped) {
  graph.bind<Body>(body);
  const auto typed_error = [](const std::string& type, const std::string& bound, const std::string& given) {
    return "typed: the type " + type + " is bound to the frame \"" + bound + "\", the value carries \"" +
           given + "\"";
  };
  const NamedDcm R = aligned(To(camera), From(gcrf));
  expect(typed_error(Body_, "body", "camera"), [&] { graph.typed(to<Body>, from<Gcrf>, R); });
  expect(typed_error(Body_, "body", "camera"), [&] { graph.typed(to<Gcrf>, from<Body>, inverse(R)); });
  const auto v = vector<si::angular_velocity>(In(body), Eigen::Vector3d(1, 2, 3));
  expect(typed_error(Gcrf_, "gcrf", "body"), [&] { graph.typed(in<Gcrf>, v); });
  const auto w = angular_velocity(Of(body), RelativeTo(gcrf), v);
  expect(typed_error(Body_, "body", "gcrf"), [&] { graph.typed(of<Gcrf>, relative_to<Body>, in<Body>, w); });
  expect(typed_error(Gcrf_, "gcrf", "body"), [&] { graph.typed(of<Gcrf>, relative_to<Gcrf>, in<Body>, w); });
  expect(typed_error(Body_, "body", "gcrf"), [&] { graph.typed(of<Body>, relative_to<Body>, in<Body>, w); });
  expect(typed_error(Gcrf_, "gcrf", "body"), [&] { graph.typed(of<Body>, relative_to<Gcrf>, in<Gcrf>, w); });
  NamedGraph other;
  const NamedFrame stranger = other.add_frame("body", FrameMotion::moving);
  expect(typed_error(Body_, "body", "body") + " of another graph",
         [&] { graph.typed(to<Body>, from<Gcrf>, aligned(To(stranger), From(gcrf))); });
}

TEST_F(NamedBridgeErrors, AnEdgeThatCannotAnswerIsRefusedAtOnce) {
  graph.bind<Body>(body);
  expect(
      R"(typed_edge(of "body", relative to "gcrf", in "gcrf"): no path, "gcrf" and "body" are in two trees)",
      [&] { graph.typed_edge<MovingDcm<Gcrf, Body>>(); });
  graph.add_edge(static_edge(aligned(to<Body>, from<Gcrf>)));
  expect(R"(typed_edge(of "body", relative to "gcrf", in "gcrf"): the edge "body" - "gcrf" has no rate)",
         [&] { graph.typed_edge<MovingDcm<Gcrf, Body>>(); });
  EXPECT_NO_THROW((graph.typed_edge<Dcm<Gcrf, Body>>()));
  expect("no frame of the graph is bound to the type " + Itrf_,
         [&] { graph.typed_edge<MovingDcm<Gcrf, Itrf>>(); });
}

// A typed edge keeps its level, and its numbers must be finite here too.
TEST_F(NamedBridgeErrors, TypedEdgesKeepTheirLevel) {
  graph.bind<Body>(body);
  graph.bind<Camera>(camera);
  graph.add_edge(static_edge(aligned(to<Body>, from<Gcrf>)));
  expect(
      R"(angular_velocity(of "body", relative to "gcrf", in "gcrf"): the edge "body" - "gcrf" has no rate)",
      [&] { graph.at(now).angular_velocity(of<Body>, relative_to<Gcrf>, in<Gcrf>); });
  const Eigen::Matrix3d bad = Eigen::Matrix3d::Constant(NAN);
  graph.add_edge(edge([=](Quantity<si::time>) { return trust_dcm(to<Camera>, from<Body>, bad); }));
  expect(R"(the edge "camera" - "body" at 0 s: its function returned a rotation that is not finite)",
         [&] { graph.at(now).rotation(to<Camera>, from<Gcrf>); });
}

}  // namespace
}  // namespace bridge_test
