#include <gtest/gtest.h>

#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace graph_errors_test {
namespace {

constexpr auto now = 0.0 * si::second;
const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

/// gcrf -(rate)- body -(static)- camera; camera -(rigid)- lens; and itrf without an edge.
class NamedGraphErrors : public testing::Test {
 protected:
  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame("gcrf", FrameMotion::inertial);
  NamedFrame body = graph.add_frame("body", FrameMotion::moving);
  NamedFrame camera = graph.add_frame("camera", FrameMotion::moving);
  NamedFrame lens = graph.add_frame("lens", FrameMotion::moving);
  NamedFrame itrf = graph.add_frame("itrf", FrameMotion::moving);

  void SetUp() override {
    graph.add_edge(edge(To(gcrf), From(body), [this](Quantity<si::time>) { return spinning(gcrf, body); }));
    graph.add_edge(static_edge(aligned(To(body), From(camera))));
    graph.add_edge(rigid_edge(aligned(To(camera), From(lens))));
  }
  static NamedMovingDcm spinning(NamedFrame a, NamedFrame b) {
    const auto w = vector<si::angular_velocity>(In(b), Eigen::Vector3d(0, 0, 1));
    return moving_dcm(aligned(To(a), From(b)), angular_velocity(Of(b), RelativeTo(a), w));
  }
  template <class Action> static void expect(const char* text, const Action& action) {
    EXPECT_EQ(message<BadInput>(action), text);
  }
};

TEST_F(NamedGraphErrors, AnUnknownFrameSuggestsTheNearestName) {
  expect(R"(no frame "camrea" in the graph; the nearest name is "camera")",
         [&] { graph.at(now).rotation(To("camrea"), From(gcrf)); });
  expect(R"(no frame "GCRS" in the graph; the nearest name is "gcrf")", [&] { graph.frame("GCRS"); });
  expect(R"(no frame "star tracker" in the graph, which has 5 frames)", [&] { graph.frame("star tracker"); });
  expect(R"(no frame "" in the graph, which has 5 frames)",
         [&] { graph.at(now).angular_velocity(Of(body), RelativeTo(gcrf), In("")); });
  expect(R"(no frame "x" in the graph, which has 0 frames)", [&] { NamedGraph().frame("x"); });
}

TEST_F(NamedGraphErrors, TwoTreesHaveNoPathBetweenThem) {
  expect(R"(rotation(to "camera", from "itrf"): no path, "itrf" and "camera" are in two trees)",
         [&] { graph.at(now).rotation(To(camera), From("itrf")); });
  expect(
      R"(angular_velocity(of "body", relative to "itrf", in "body"): no path, "itrf" and "body" are in two trees)",
      [&] { graph.at(now).angular_velocity(Of(body), RelativeTo(itrf), In(body)); });
  expect(
      R"(angular_velocity(of "body", relative to "gcrf", in "itrf"): no path, "gcrf" and "itrf" are in two trees)",
      [&] { graph.at(now).angular_velocity(Of(body), RelativeTo(gcrf), In(itrf)); });
}

// The graph does not cache that there is no path.
TEST_F(NamedGraphErrors, APathIsFoundAsSoonAsThereIsOne) {
  const NamedSnapshot snapshot = graph.at(now);
  EXPECT_THROW(snapshot.rotation(To(camera), From(itrf)), BadInput);
  EXPECT_THROW(snapshot.rotation(To(camera), From(itrf)), BadInput);
  const auto R = turned_x(To(itrf), From(gcrf), 0.5 * si::radian);
  graph.add_edge(static_edge(R));
  EXPECT_EQ(snapshot.rotation(To(camera), From(itrf)).matrix(), inverse(R).matrix());
  EXPECT_EQ(graph.at(now).rotation(To(camera), From(itrf)).matrix(), inverse(R).matrix());
}

TEST_F(NamedGraphErrors, AnEdgeMustNotCloseACycle) {
  expect(R"(add_edge(to "gcrf", from "lens"): it would close a cycle, "gcrf" - "body" - "camera" - "lens")",
         [&] { graph.add_edge(static_edge(aligned(To(gcrf), From(lens)))); });
  expect(R"(add_edge(to "body", from "body"): an edge joins two frames)", [&] {
    graph.add_edge(edge(To(body), From(body), [this](Quantity<si::time>) { return spinning(gcrf, body); }));
  });
  // The refused edge has changed nothing.
  EXPECT_EQ(graph.at(now).rotation(To(gcrf), From(lens)).matrix(), Eigen::Matrix3d::Identity());
}

TEST_F(NamedGraphErrors, FramesAndEdgesAreAddedOnce) {
  expect(R"(add_frame: the graph has a frame "body" already)",
         [&] { graph.add_frame("body", FrameMotion::inertial); });
  expect("add_frame: the name is empty", [&] { graph.add_frame("", FrameMotion::moving); });
  for (const auto& [a, b] : {std::pair{body, camera}, std::pair{camera, body}})
    expect(("add_edge(to \"" + a.name() + "\", from \"" + b.name() +
            "\"): the graph has an edge between the two already")
               .c_str(),
           [&, a = a, b = b] { graph.add_edge(static_edge(aligned(To(a), From(b)))); });
  EXPECT_EQ(graph.frames().size(), 5U);
}

TEST_F(NamedGraphErrors, AMissingRateNamesItsEdge) {
  expect(
      R"(angular_velocity(of "lens", relative to "gcrf", in "body"): the edge "body" - "camera" has no rate)",
      [&] { graph.at(now).angular_velocity(Of(lens), RelativeTo(gcrf), In(body)); });
  expect(
      R"(angular_acceleration(of "body", relative to "gcrf", in "lens"): the edge "gcrf" - "body" has no acceleration)",
      [&] { graph.at(now).angular_acceleration(Of(body), RelativeTo(gcrf), In(lens)); });
  expect(
      R"(angular_acceleration(of "camera", relative to "body", in "lens"): the edge "body" - "camera" has no acceleration)",
      [&] { graph.at(now).angular_acceleration(Of(camera), RelativeTo(body), In(lens)); });
  // An edge that is not between the two frames may be static.
  EXPECT_EQ(graph.at(now).angular_velocity(Of(body), RelativeTo(gcrf), In(lens)).coordinates(),
            Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(graph.at(now).angular_acceleration(Of(lens), RelativeTo(camera), In(body)).coordinates(),
            Eigen::Vector3d::Zero());
}

TEST_F(NamedGraphErrors, AFrameDoesNotMoveRelativeToItself) {
  expect(
      R"(angular_velocity(of "body", relative to "body", in "gcrf"): a frame does not move relative to itself; ask for two frames)",
      [&] { graph.at(now).angular_velocity(Of(body), RelativeTo("body"), In(gcrf)); });
}

TEST_F(NamedGraphErrors, TheTimeIsFinite) {
  expect("NamedGraph: the time is nan s", [&] { graph.at(nan * si::second); });
  expect("NamedGraph: the time is -inf s", [&] { graph.at(-infinity * si::second); });
}

TEST_F(NamedGraphErrors, AFrameBelongsToItsGraph) {
  NamedGraph other;
  const NamedFrame stranger = other.add_frame("body", FrameMotion::moving);
  expect(R"(the frame "body" belongs to another graph)",
         [&] { graph.at(now).rotation(To(stranger), From(gcrf)); });
  expect(R"(the frame "body" belongs to another graph)",
         [&] { graph.add_edge(static_edge(aligned(To(itrf), From(stranger)))); });
  EXPECT_NE(stranger, body);
}

TEST_F(NamedGraphErrors, AFunctionMustReturnTheFramesOfItsEdge) {
  graph.add_edge(edge(To(gcrf), From(itrf), [this](Quantity<si::time>) { return spinning(itrf, gcrf); }));
  const char* const text =
      R"(the edge "gcrf" - "itrf" at 2 s: its function returned R to "itrf" from "gcrf")";
  expect(text, [&] { graph.at(2.0 * si::second).rotation(To(itrf), From(gcrf)); });
  expect(text, [&] { graph.at(2.0 * si::second).angular_velocity(Of(itrf), RelativeTo(gcrf), In(gcrf)); });
}

TEST_F(NamedGraphErrors, RotationsAreFinite) {
  const Eigen::Matrix3d bad = Eigen::Vector3d(1, 1, nan).asDiagonal();
  graph.add_edge(edge(To(gcrf), From(itrf),
                      [=, this](Quantity<si::time>) { return trust_dcm(To(gcrf), From(itrf), bad); }));
  expect(R"(the edge "gcrf" - "itrf" at 0 s: its function returned a rotation that is not finite)",
         [&] { graph.at(now).rotation(To(itrf), From(gcrf)); });
  const NamedFrame sun = graph.add_frame("sun", FrameMotion::moving);
  expect(R"(add_edge(to "gcrf", from "sun"): the rotation is not finite)",
         [&] { graph.add_edge(static_edge(trust_dcm(To(gcrf), From(sun), bad))); });
}

TEST_F(NamedGraphErrors, WhatIsNoRotationStopsAtTheDoor) {
  graph.add_edge(edge(To(gcrf), From(itrf), [this](Quantity<si::time>) {
    return dcm(To(gcrf), From(itrf), 2 * Eigen::Matrix3d::Identity());
  }));
  expect(
      R"(dcm(to "gcrf", from "itrf"): M^T M differs from the identity by 3, tolerance 1e-09; nearest_dcm() projects)",
      [&] { graph.at(now).rotation(To(itrf), From(gcrf)); });
}

// An exception of an edge function arrives unchanged, and is not cached.
TEST_F(NamedGraphErrors, WhatAFunctionThrowsArrivesUnchanged) {
  struct NoData {
    int code;
  };
  bool fails = true;
  graph.add_edge(edge(To(gcrf), From(itrf), [&](Quantity<si::time>) {
    if (fails) throw NoData{42};
    return spinning(gcrf, itrf);
  }));
  const NamedSnapshot snapshot = graph.at(now);
  for (int i = 0; i < 2; ++i) {
    try {
      (void)snapshot.rotation(To(itrf), From(camera));
      FAIL();
    } catch (const NoData& error) {
      EXPECT_EQ(error.code, 42);
    }
  }
  fails = false;
  EXPECT_EQ(snapshot.rotation(To(itrf), From(camera)).matrix(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(graph.at(now).rotation(To(itrf), From(camera)).matrix(), Eigen::Matrix3d::Identity());
}

// The cache stays within its bound. Queries without room in the cache are answered correctly too.
TEST(NamedGraphCache, IsBoundedAndCorrectBeyondItsBound) {
  for (const std::size_t bound : {0U, 1U, 5U, 1000U}) {
    NamedGraph graph(bound);
    constexpr std::size_t count = 12;
    std::vector<NamedFrame> frames;
    for (std::size_t i = 0; i < count; ++i) {
      frames.push_back(graph.add_frame("frame " + std::to_string(i), FrameMotion::moving));
      if (i > 0) graph.add_edge(rigid_edge(turned_z(To(frames[i]), From(frames[i - 1]), 0.1 * si::radian)));
    }
    for (int round = 0; round < 2; ++round) {
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
          if (i == j) continue;
          const double angle = 0.1 * (static_cast<double>(i) - static_cast<double>(j));
          const auto expected = turned_z(To(frames[i]), From(frames[j]), angle * si::radian);
          EXPECT_LE(
              distance(graph.at(now).rotation(To(frames[i]), From(frames[j])).matrix(), expected.matrix()),
              rounding);
          EXPECT_LE(graph.cached_paths(), bound);
        }
      }
    }
    EXPECT_EQ(graph.cached_paths(), std::min(bound, count * (count - 1)));
  }
}

}  // namespace
}  // namespace graph_errors_test
