#include <gtest/gtest.h>

#include <vector>
#include <vectrix/kinematics/named/graph.hpp>
#include <vectrix/kinematics/samples/sampled_position.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rigid_arm_test {
namespace {

constexpr auto now = 0.0 * si::second;

/// A camera on an arm of 2 m along x of a body that turns about z at 3 rad/s; the body's place in gcrf is not
/// known.
struct Arm {
  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame("gcrf", FrameMotion::inertial);
  NamedFrame body = graph.add_frame("body", FrameMotion::moving);
  NamedFrame camera = graph.add_frame("camera", FrameMotion::moving);
  NamedFrame lens = graph.add_frame("lens", FrameMotion::moving);
  NamedFrame itrf = graph.add_frame("itrf", FrameMotion::moving);
  int evaluations = 0;

  Arm() {
    graph.add_edge(edge(To(gcrf), From(body), [this](Quantity<si::time>) {
      ++evaluations;
      return accelerating_dcm(
          aligned(To(gcrf), From(body)),
          angular_velocity(Of(body), RelativeTo(gcrf),
                           vector<si::angular_velocity>(In(body), Eigen::Vector3d(0, 0, 3))),
          angular_acceleration(Of(body), RelativeTo(gcrf),
                               vector<si::angular_acceleration>(In(body), Eigen::Vector3d::Zero())));
    }));
    graph.add_edge(rigid_edge(NamedTransform{aligned(To(body), From(camera)), arm(camera, body, 2.0)}));
    graph.add_edge(static_edge(NamedTransform{aligned(To(lens), From(camera)), arm(camera, lens, -1.0)}));
  }
  Arm(const Arm&) = delete;

  static NamedDisplacement arm(NamedFrame q, NamedFrame p, double x) {
    return displacement(Of(q), RelativeTo(p), vector<si::length>(In(p), Eigen::Vector3d(x, 0, 0)));
  }
  template <class Action> static void expect(const char* text, const Action& action) {
    EXPECT_EQ(message<BadInput>(action), text);
  }
};

// 6 m/s along y, 18 m/s^2 inwards.
TEST(NamedPlaces, ARigidlyMountedCameraIsCarriedAround) {
  const Arm x;
  const NamedSnapshot at = x.graph.at(now);
  const auto q = Of(x.camera);
  const auto p = RelativeTo(x.body);
  EXPECT_EQ(at.velocity(q, p, ObservedFrom(x.gcrf), In(x.gcrf)).coordinates(), Eigen::Vector3d(0, 6, 0));
  EXPECT_EQ(at.acceleration(q, p, ObservedFrom(x.gcrf), In(x.gcrf)).coordinates(),
            Eigen::Vector3d(-18, 0, 0));
  EXPECT_EQ(at.velocity(q, p, ObservedFrom(x.body), In(x.gcrf)).coordinates(), Eigen::Vector3d::Zero());
  EXPECT_EQ(at.position(Of(x.lens), p, In(x.gcrf)).coordinates(), Eigen::Vector3d(3, 0, 0));
}

TEST(NamedPlaces, AMissingPlaceOrRateNamesItsEdge) {
  const Arm x;
  const NamedSnapshot at = x.graph.at(now);
  Arm::expect(
      R"(position(of "camera", relative to "gcrf", in "body"): the edge "gcrf" - "body" has no position)",
      [&] { at.position(Of(x.camera), RelativeTo(x.gcrf), In(x.body)); });
  Arm::expect(R"(transform(to "gcrf", from "lens"): the edge "gcrf" - "body" has no position)",
              [&] { at.transform(To(x.gcrf), From(x.lens)); });
  Arm::expect(
      R"(velocity(of "gcrf", relative to "camera", observed from "camera", in "body"): the edge "gcrf" - "body" has no position)",
      [&] { at.velocity(Of(x.gcrf), RelativeTo(x.camera), ObservedFrom(x.camera), In(x.body)); });
  Arm::expect(
      R"(velocity(of "lens", relative to "body", observed from "gcrf", in "body"): the edge "lens" - "camera" has no rate)",
      [&] { at.velocity(Of(x.lens), RelativeTo(x.body), ObservedFrom(x.gcrf), In(x.body)); });
  Arm::expect(
      R"(acceleration(of "camera", relative to "body", observed from "lens", in "body"): the edge "lens" - "camera" has no acceleration)",
      [&] { at.acceleration(Of(x.camera), RelativeTo(x.body), ObservedFrom(x.lens), In(x.body)); });
  // What is not between the points and the observer needs neither.
  EXPECT_NO_THROW(at.position(Of(x.lens), RelativeTo(x.body), In(x.gcrf)));
  EXPECT_NO_THROW(at.acceleration(Of(x.camera), RelativeTo(x.body), ObservedFrom(x.gcrf), In(x.lens)));
}

TEST(NamedPlaces, TwoFramesOfOneTreeAreAskedFor) {
  const Arm x;
  const NamedSnapshot at = x.graph.at(now);
  Arm::expect(
      R"(position(of "body", relative to "body", in "gcrf"): a frame does not move relative to itself; ask for two frames)",
      [&] { at.position(Of(x.body), RelativeTo("body"), In(x.gcrf)); });
  Arm::expect(R"(transform(to "body", from "itrf"): no path, "itrf" and "body" are in two trees)",
              [&] { at.transform(To(x.body), From(x.itrf)); });
  Arm::expect(
      R"(position(of "lens", relative to "itrf", in "body"): no path, "body" and "itrf" are in two trees)",
      [&] { at.position(Of(x.lens), RelativeTo(x.itrf), In(x.body)); });
  Arm::expect(
      R"(velocity(of "camera", relative to "body", observed from "itrf", in "body"): no path, "itrf" and "body" are in two trees)",
      [&] { at.velocity(Of(x.camera), RelativeTo(x.body), ObservedFrom(x.itrf), In(x.body)); });
  Arm::expect(
      R"(acceleration(of "camera", relative to "body", observed from "body", in "itrf"): no path, "body" and "itrf" are in two trees)",
      [&] { at.acceleration(Of(x.camera), RelativeTo(x.body), ObservedFrom(x.body), In(x.itrf)); });
  Arm::expect(R"(no frame "lense" in the graph; the nearest name is "lens")",
              [&] { at.velocity(Of(x.camera), RelativeTo(x.body), ObservedFrom("lense"), In(x.itrf)); });
}

TEST(NamedPlaces, ATransformToItselfIsTheIdentity) {
  const Arm x;
  const NamedTransform X = x.graph.at(now).transform(To(x.itrf), From(x.itrf));
  EXPECT_EQ(X.rotation().matrix(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(X.translation().coordinates(), Eigen::Vector3d::Zero());
}

// Each edge is evaluated once per instant, also if the path to the result's frame shares edges.
TEST(NamedPlaces, EachEdgeIsEvaluatedOnce) {
  Arm x;
  const auto of_camera = Of(x.camera);
  const auto relative_to_body = RelativeTo(x.body);
  (void)x.graph.at(now).position(of_camera, relative_to_body, In(x.gcrf));
  EXPECT_EQ(x.evaluations, 1);
  (void)x.graph.at(now).acceleration(of_camera, relative_to_body, ObservedFrom(x.gcrf), In(x.camera));
  EXPECT_EQ(x.evaluations, 2);
  const NamedSnapshot at = x.graph.at(now);
  (void)at.velocity(of_camera, relative_to_body, ObservedFrom(x.gcrf), In(x.gcrf));
  (void)at.angular_velocity(of_camera, RelativeTo(x.gcrf), In(x.gcrf));
  (void)at.rotation(To(x.camera), From(x.gcrf));
  EXPECT_EQ(x.evaluations, 3);
}

TEST(NamedPlaces, PlacesAreFinite) {
  Arm x;
  const auto far = Arm::arm(x.itrf, x.gcrf, 1e308);
  const auto farther = Arm::arm(x.gcrf, x.lens, 1e308);
  const NamedDisplacement infinite = aligned(To(x.gcrf), From(x.lens)) * farther + far;
  const NamedTransform X{aligned(To(x.lens), From(x.itrf)), aligned(To(x.lens), From(x.gcrf)) * infinite};
  Arm::expect(R"(add_edge(to "lens", from "itrf"): the position is not finite)",
              [&] { x.graph.add_edge(static_edge(X)); });
  x.graph.add_edge(edge(To(x.lens), From(x.itrf), [X](Quantity<si::time>) { return X; }));
  Arm::expect(R"(the edge "lens" - "itrf" at 0 s: its function returned a position that is not finite)",
              [&] { x.graph.at(now).position(Of(x.itrf), RelativeTo(x.lens), In(x.lens)); });
}

TEST(NamedPlaces, AFunctionMustReturnTheFramesOfItsEdge) {
  Arm x;
  const NamedTransform X{aligned(To(x.itrf), From(x.gcrf)), Arm::arm(x.gcrf, x.itrf, 1.0)};
  x.graph.add_edge(edge(To(x.gcrf), From(x.itrf), [X](Quantity<si::time>) { return X; }));
  Arm::expect(R"(the edge "gcrf" - "itrf" at 2 s: its function returned R to "itrf" from "gcrf")",
              [&] { x.graph.at(2.0 * si::second).transform(To(x.gcrf), From(x.itrf)); });
}

// A typed orbit file is an edge as well.
TEST(NamedPlaces, ATypedSampledPositionIsAnEdge) {
  NamedGraph graph;
  graph.add_frame<Gcrf>("gcrf");
  graph.add_frame<Body>("body");
  const auto sample = [](double t) {
    return PositionSample{t * si::second,
                          point_motion(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>,
                                       vector<si::length>(in<Gcrf>, Eigen::Vector3d(5 * t, 0, 1)),
                                       vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(5, 0, 0)))};
  };
  graph.add_edge(sampled_edge(std::vector{sample(0.0), sample(2.0)}, 10.0 * si::second));
  const NamedSnapshot at = graph.at(1.0 * si::second);
  EXPECT_EQ(at.position(Of("body"), RelativeTo("gcrf"), In("gcrf")).coordinates(), Eigen::Vector3d(5, 0, 1));
  EXPECT_EQ(at.velocity(Of("body"), RelativeTo("gcrf"), ObservedFrom("gcrf"), In("gcrf")).coordinates(),
            Eigen::Vector3d(5, 0, 0));
}

TEST(NamedPlaces, AnEdgeThatCannotAnswerIsRefusedAtOnce) {
  Arm x;
  x.graph.bind<Gcrf>("gcrf");
  x.graph.bind<Body>("body");
  x.graph.bind<Camera>("camera");
  Arm::expect(
      R"(typed_edge(of "camera", relative to "gcrf", in "gcrf"): the edge "gcrf" - "body" has no position)",
      [&] { x.graph.typed_edge<Transform<Gcrf, Camera>>(); });
  EXPECT_NO_THROW((x.graph.typed_edge<AcceleratingTransform<Body, Camera>>()));
}

}  // namespace
}  // namespace rigid_arm_test
