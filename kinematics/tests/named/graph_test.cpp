#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/units/systems/si/time.hpp>

#include "random_tree.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace graph_test {
namespace {

constexpr auto now = 0.0 * si::second;

/// A path of up to eleven products of rotations, compared with up to twenty-two of the reference.
constexpr double long_rounding = 128 * epsilon;
/// The same with derivatives: each step multiplies them by factors up to 10 and 100.
constexpr double long_motion_tolerance = 100 * motion_tolerance;

constexpr std::size_t most_frames = 11;

NamedAcceleratingDcm accelerating(NamedFrame a, NamedFrame b, const Motion<Gcrf, Body>& m) {
  return accelerating_dcm(
      dcm(To(a), From(b), m.R),
      angular_velocity(Of(b), RelativeTo(a), vector<si::angular_velocity>(In(a), m.w_a())),
      angular_acceleration(Of(b), RelativeTo(a), vector<si::angular_acceleration>(In(a), m.alpha_a())));
}
constexpr auto add_accelerating = [](NamedGraph& graph, NamedFrame a, NamedFrame b,
                                     const RandomTree::Placed& X) {
  const Motion m(X.rotation);
  graph.add_edge(edge(To(a), From(b), [=](Quantity<si::time>) { return accelerating(a, b, m); }));
};
constexpr auto add_static = [](NamedGraph& graph, NamedFrame a, NamedFrame b, const RandomTree::Placed& X) {
  graph.add_edge(static_edge(dcm(To(a), From(b), Motion(X.rotation).R)));
};

// Its edges are functions of seconds: no other instant, and no plain number.
template <class Instant>
concept AnswersAt = requires(const NamedGraph& graph, const Instant& t) {
  graph.at(t);
};
struct Clock {};
static_assert(AnswersAt<Quantity<si::time>> && !AnswersAt<Clock> && !AnswersAt<double>);
static_assert(AnswersAt<boost::units::quantity<boost::units::si::time>>);

RC_GTEST_PROP(NamedGraph, RotationsAreTheProductsOfThePath, ()) {
  const RandomTree fixed(most_frames, add_static);
  const RandomTree moving(most_frames, add_accelerating);
  for (const RandomTree* tree : {&fixed, &moving}) {
    tree->for_all([&](std::size_t i, std::size_t j) {
      const NamedFrame a = tree->frames[i], b = tree->frames[j];
      const NamedDcm R = tree->graph.at(now).rotation(To(a), From(b));
      RC_ASSERT(R.to() == a && R.from() == b);
      RC_ASSERT(distance(R.matrix(), tree->motion(i, j).R) <= long_rounding);
    });
  }
}

RC_GTEST_PROP(NamedGraph, RatesAndAccelerationsAreThoseOfTheDifferentiatedPath, ()) {
  const RandomTree tree(most_frames, add_accelerating);
  const NamedSnapshot snapshot = tree.graph.at(now);
  tree.for_all([&](std::size_t i, std::size_t j) {
    if (i == j) return;
    const NamedFrame a = tree.frames[i], b = tree.frames[j];
    const auto expected = tree.motion(i, j);
    for (std::size_t k = 0; k < tree.frames.size(); ++k) {
      const NamedFrame c = tree.frames[k];
      const Eigen::Matrix3d R_c_from_a = tree.rotation(k, i);
      for (const auto& w : {snapshot.angular_velocity(Of(b), RelativeTo(a), In(c)),
                            tree.graph.at(now).angular_velocity(Of(b), RelativeTo(a), In(c))}) {
        RC_ASSERT(w.of() == b && w.relative_to() == a && w.in() == c);
        RC_ASSERT(distance(w.coordinates(), R_c_from_a * expected.w_a()) <= long_motion_tolerance);
      }
      for (const auto& alpha : {snapshot.angular_acceleration(Of(b), RelativeTo(a), In(c)),
                                tree.graph.at(now).angular_acceleration(Of(b), RelativeTo(a), In(c))}) {
        RC_ASSERT(alpha.of() == b && alpha.relative_to() == a && alpha.in() == c);
        RC_ASSERT(distance(alpha.coordinates(), R_c_from_a * expected.alpha_a()) <= long_motion_tolerance);
      }
    }
  });
}

// Handles, names and a mixture give the same query.
RC_GTEST_PROP(NamedGraph, NamesAskWhatHandlesAsk, ()) {
  const RandomTree tree(most_frames, add_accelerating);
  const NamedSnapshot snapshot = tree.graph.at(now);
  const NamedFrame a = tree.frames.front(), b = tree.frames.back();
  RC_ASSERT(snapshot.rotation(To(b.name()), From("frame 0")).matrix() ==
            snapshot.rotation(To(b), From(a)).matrix());
  RC_ASSERT(
      snapshot.angular_velocity(Of(b.name()), RelativeTo(a), In(std::string_view("frame 0"))).coordinates() ==
      snapshot.angular_velocity(Of(b), RelativeTo(a), In(a)).coordinates());
  RC_ASSERT(tree.graph.frame(b.name()) == b);
  RC_ASSERT(tree.graph.frames() == tree.frames);
}

/// gcrf -- body -- camera, and itrf without an edge.
struct Small {
  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame("gcrf", FrameMotion::inertial);
  NamedFrame body = graph.add_frame("body", FrameMotion::moving);
  NamedFrame camera = graph.add_frame("camera", FrameMotion::moving);
  NamedFrame itrf = graph.add_frame("itrf", FrameMotion::moving);
  int evaluations = 0;

  Small() {
    graph.add_edge(edge(To(gcrf), From(body), [this](Quantity<si::time> t) {
      ++evaluations;
      const auto w = vector<si::angular_velocity>(In(body), Eigen::Vector3d(0, 0, 0.5));
      return moving_dcm(turned_z(To(gcrf), From(body), Quantity<si::angle>::from_value(-0.5 * t.value())),
                        angular_velocity(Of(body), RelativeTo(gcrf), w));
    }));
    graph.add_edge(rigid_edge(turned_x(To(camera), From(body), 0.3 * si::radian)));
  }
  Small(const Small&) = delete;
};

TEST(NamedGraph, AFrameIsAlignedWithItself) {
  const Small s;
  EXPECT_EQ(s.graph.at(now).rotation(To(s.itrf), From(s.itrf)).matrix(), Eigen::Matrix3d::Identity());
}

TEST(NamedGraph, OneEdgeIsItsValueOrItsInverse) {
  NamedGraph graph;
  const NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  const NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.1, -0.7, 0.4, 0.3).normalized().toRotationMatrix();
  graph.add_edge(static_edge(dcm(To(a), From(b), R)));
  EXPECT_EQ(graph.at(now).rotation(To(a), From(b)).matrix(), R);
  EXPECT_EQ(graph.at(now).rotation(To(b), From(a)).matrix(), R.transpose());
}

TEST(NamedGraph, EdgesAreEvaluatedAtTheInstantOfTheSnapshotOnceEach) {
  Small s;
  const auto t = 3.0 * si::second;
  const NamedSnapshot snapshot = s.graph.at(t);
  EXPECT_EQ(s.evaluations, 0);
  const auto R = snapshot.rotation(To(s.gcrf), From(s.body));
  EXPECT_EQ(R.matrix(), turned_z(To(s.gcrf), From(s.body), -1.5 * si::radian).matrix());
  (void)snapshot.angular_velocity(Of(s.camera), RelativeTo(s.gcrf), In(s.body));
  EXPECT_EQ(s.evaluations, 1);
  (void)s.graph.at(t).angular_velocity(Of(s.camera), RelativeTo(s.gcrf), In(s.body));
  EXPECT_EQ(s.evaluations, 2);
  (void)s.graph.at(t).rotation(To(s.camera), From(s.body));
  EXPECT_EQ(s.evaluations, 2);
}

TEST(NamedGraph, ARigidEdgeIsAtRest) {
  const Small s;
  const NamedSnapshot snapshot = s.graph.at(now);
  EXPECT_EQ(snapshot.angular_velocity(Of(s.camera), RelativeTo(s.body), In(s.gcrf)).coordinates(),
            Eigen::Vector3d::Zero());
  EXPECT_EQ(snapshot.angular_acceleration(Of(s.camera), RelativeTo(s.body), In(s.body)).coordinates(),
            Eigen::Vector3d::Zero());
}

TEST(NamedGraph, FramesKeepTheirNameAndMotion) {
  const Small s;
  EXPECT_EQ(s.gcrf.name(), "gcrf");
  EXPECT_EQ(s.gcrf.motion(), FrameMotion::inertial);
  EXPECT_EQ(s.graph.frame("body").motion(), FrameMotion::moving);
}

TEST(NamedGraph, MovesWithItsFrames) {
  const auto load = [](NamedFrame& a, NamedFrame& b) {
    NamedGraph graph;
    a = graph.add_frame("a", FrameMotion::moving);
    b = graph.add_frame("b", FrameMotion::moving);
    graph.add_edge(static_edge(turned_y(To(a), From(b), 0.1 * si::radian)));
    return graph;
  };
  Small other;
  NamedFrame a = other.gcrf, b = other.gcrf;
  const NamedGraph graph = load(a, b);
  EXPECT_EQ(graph.at(now).rotation(To(a), From("b")).matrix(),
            turned_y(To(a), From(b), 0.1 * si::radian).matrix());
}

// Thousands of names: the index grows several times and still finds each name.
TEST(NamedGraph, ManyFramesAreFoundByName) {
  NamedGraph graph;
  constexpr unsigned count = 5000;
  for (unsigned i = 0; i < count; ++i) graph.add_frame("wheel " + std::to_string(i), FrameMotion::moving);
  for (unsigned i = 0; i < count; ++i)
    ASSERT_EQ(graph.frame("wheel " + std::to_string(i)).record().number, i);
}

}  // namespace
}  // namespace graph_test
