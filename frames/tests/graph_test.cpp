#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace graph_test {
namespace {

/// Edge function that counts its evaluations.
template <class A, class B> struct Counting {
  Dcm<A, B> value;
  int* count;

  Dcm<A, B> operator()(Quantity<si::time>) const {
    ++*count;
    return value;
  }
};

template <class B, class A> Dcm<B, A> any_dcm() {
  return trust_dcm(to<B>, from<A>, *rotation_matrix());
}

constexpr auto now = Quantity<si::time>{};

// Gcrf -- Itrf -- Ground; Gcrf -- Body -- Camera; Body -- Wheel<1>; Body -- Wheel<2>. Edges have both
// directions.
struct Tree {
  Dcm<Itrf, Gcrf> itrf_from_gcrf = any_dcm<Itrf, Gcrf>();
  Dcm<Ground, Itrf> ground_from_itrf = any_dcm<Ground, Itrf>();
  Dcm<Gcrf, Body> gcrf_from_body = any_dcm<Gcrf, Body>();
  Dcm<Camera, Body> camera_from_body = any_dcm<Camera, Body>();
  Dcm<Body, Wheel<1>> body_from_wheel_1 = any_dcm<Body, Wheel<1>>();
  Dcm<Wheel<2>, Body> wheel_2_from_body = any_dcm<Wheel<2>, Body>();
  mutable int itrf = 0, body = 0, wheel = 0;

  auto graph() const {
    return frame_graph(edge(Counting<Itrf, Gcrf>{itrf_from_gcrf, &itrf}), static_edge(ground_from_itrf),
                       edge(Counting<Gcrf, Body>{gcrf_from_body, &body}), static_edge(camera_from_body),
                       edge(Counting<Body, Wheel<1>>{body_from_wheel_1, &wheel}),
                       static_edge(wheel_2_from_body));
  }
};

template <class B, class A> void agree(const Dcm<B, A>& left, const Dcm<B, A>& right) {
  RC_ASSERT(distance(left.matrix(), right.matrix()) <= rounding);
}

RC_GTEST_PROP(FrameGraph, PathsAreTheProductsOfTheirEdgesInBothDirections, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const auto snapshot = graph.at(now);
  agree<Camera, Ground>(snapshot.rotation(to<Camera>, from<Ground>),
                        tree.camera_from_body * inverse(tree.gcrf_from_body) * inverse(tree.itrf_from_gcrf) *
                            inverse(tree.ground_from_itrf));
  agree<Ground, Camera>(
      snapshot.rotation(to<Ground>, from<Camera>),
      tree.ground_from_itrf * tree.itrf_from_gcrf * tree.gcrf_from_body * inverse(tree.camera_from_body));
  agree<Wheel<2>, Wheel<1>>(snapshot.rotation(to<Wheel<2>>, from<Wheel<1>>),
                            tree.wheel_2_from_body * tree.body_from_wheel_1);
  agree<Wheel<1>, Itrf>(
      snapshot.rotation(to<Wheel<1>>, from<Itrf>),
      inverse(tree.body_from_wheel_1) * inverse(tree.gcrf_from_body) * inverse(tree.itrf_from_gcrf));
}

RC_GTEST_PROP(FrameGraph, OneEdgeIsItsValueOrItsInverse, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const auto snapshot = graph.at(now);
  RC_ASSERT(snapshot.rotation(to<Gcrf>, from<Body>).matrix() == tree.gcrf_from_body.matrix());
  RC_ASSERT(snapshot.rotation(to<Body>, from<Gcrf>).matrix() == tree.gcrf_from_body.matrix().transpose());
  RC_ASSERT(snapshot.rotation(to<Ground>, from<Itrf>).matrix() == tree.ground_from_itrf.matrix());
}

RC_GTEST_PROP(FrameGraph, ResultsOfQueriesChain, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const auto snapshot = graph.at(now);
  agree<Camera, Itrf>(
      snapshot.rotation(to<Camera>, from<Itrf>),
      snapshot.rotation(to<Camera>, from<Wheel<1>>) * snapshot.rotation(to<Wheel<1>>, from<Itrf>));
}

RC_GTEST_PROP(FrameGraph, EachEdgeOnThePathIsEvaluatedOnceASnapshotAndNoOther, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const auto snapshot = graph.at(now);
  RC_ASSERT(tree.itrf + tree.body + tree.wheel == 0);
  (void)snapshot.rotation(to<Camera>, from<Gcrf>);
  RC_ASSERT(tree.body == 1 && tree.itrf == 0 && tree.wheel == 0);
  (void)snapshot.rotation(to<Gcrf>, from<Camera>);
  (void)snapshot.rotation(to<Ground>, from<Camera>);
  RC_ASSERT(tree.body == 1 && tree.itrf == 1 && tree.wheel == 0);
  (void)graph.at(now).rotation(to<Body>, from<Gcrf>);
  RC_ASSERT(tree.body == 2 && tree.itrf == 1);
}

TEST(FrameGraph, AFrameIsAlignedWithItself) {
  const auto graph = frame_graph(static_edge(turned_x(to<Body>, from<Gcrf>, 0.5 * si::radian)));
  const Dcm<Body, Body> same = graph.at(now).rotation(to<Body>, from<Body>);
  EXPECT_EQ(same.matrix(), Eigen::Matrix3d::Identity());
}

TEST(FrameGraph, EdgesAreEvaluatedAtTheInstantOfTheSnapshot) {
  const auto rate = 0.25 * si::radian / si::second;
  const auto graph = frame_graph(edge(
      [=](Quantity<si::time> t) { return turned_z(to<Itrf>, from<Gcrf>, Quantity<si::angle>(rate * t)); }));
  const auto t = 3.0 * si::second;
  EXPECT_EQ(graph.at(t).rotation(to<Itrf>, from<Gcrf>).matrix(),
            turned_z(to<Itrf>, from<Gcrf>, 0.75 * si::radian).matrix());
}

TEST(FrameGraph, AnInstantMayBeAStateOfTheUsers) {
  struct State {
    double attitude;
  };
  const auto graph = frame_graph(
      edge([](const State& s) { return turned_y(to<Body>, from<Gcrf>, s.attitude * si::radian); }),
      static_edge(aligned(to<Camera>, from<Body>)));
  EXPECT_EQ(graph.at(State{0.25}).rotation(to<Camera>, from<Gcrf>).matrix(),
            turned_y(to<Camera>, from<Gcrf>, 0.25 * si::radian).matrix());
}

// A path of many edges, listed in any order and with both directions.
TEST(FrameGraph, LongPathsAreFound) {
  const auto angle = 0.1 * si::radian;
  const auto graph = frame_graph(static_edge(turned_z(to<Wheel<3>>, from<Wheel<2>>, angle)),
                                 static_edge(turned_z(to<Wheel<1>>, from<Wheel<0>>, angle)),
                                 static_edge(inverse(turned_z(to<Wheel<5>>, from<Wheel<4>>, angle))),
                                 static_edge(turned_z(to<Wheel<2>>, from<Wheel<1>>, angle)),
                                 static_edge(inverse(turned_z(to<Wheel<4>>, from<Wheel<3>>, angle))));
  EXPECT_LE(distance(graph.at(now).rotation(to<Wheel<5>>, from<Wheel<0>>).matrix(),
                     turned_z(to<Wheel<5>>, from<Wheel<0>>, 0.5 * si::radian).matrix()),
            rounding);
}

// The frame of the sun sensor follows from the other frames: z along the z axis of Itrf, x as near as
// possible to that of Body.
Dcm<Gcrf, Camera> follows(const Dcm<Gcrf, Itrf>& R_gcrf_from_itrf, const Dcm<Gcrf, Body>& R_gcrf_from_body) {
  const auto z = R_gcrf_from_itrf * unit_z(in<Itrf>);
  const auto y = direction(cross(z, R_gcrf_from_body * unit_x(in<Body>)));
  return inverse(dcm_from_axes(to<Camera>, cross(y, z), y, z));
}
template <class Tree> auto with_follower(const Tree& tree) {
  return frame_graph(edge(Counting<Itrf, Gcrf>{tree.itrf_from_gcrf, &tree.itrf}),
                     edge(Counting<Gcrf, Body>{tree.gcrf_from_body, &tree.body}), edge(follows),
                     edge(Counting<Body, Wheel<1>>{tree.body_from_wheel_1, &tree.wheel}));
}

RC_GTEST_PROP(FrameGraph, AnEdgeMayFollowFromTheEdgesBeforeIt, ()) {
  const Tree tree;
  const auto graph = with_follower(tree);
  agree<Wheel<1>, Camera>(graph.at(now).rotation(to<Wheel<1>>, from<Camera>),
                          inverse(tree.gcrf_from_body * tree.body_from_wheel_1) *
                              follows(inverse(tree.itrf_from_gcrf), tree.gcrf_from_body));
}

// For a snapshot with a name and one without.
TEST(FrameGraph, WhatEdgesShareIsEvaluatedOnce) {
  const Tree tree{.itrf_from_gcrf = turned_x(to<Itrf>, from<Gcrf>, 0.3 * si::radian),
                  .ground_from_itrf = aligned(to<Ground>, from<Itrf>),
                  .gcrf_from_body = turned_y(to<Gcrf>, from<Body>, 0.4 * si::radian),
                  .camera_from_body = aligned(to<Camera>, from<Body>),
                  .body_from_wheel_1 = turned_z(to<Body>, from<Wheel<1>>, 0.5 * si::radian),
                  .wheel_2_from_body = aligned(to<Wheel<2>>, from<Body>)};
  const auto graph = with_follower(tree);
  (void)graph.at(now).rotation(to<Itrf>, from<Camera>);
  EXPECT_EQ(tree.itrf, 1);
  EXPECT_EQ(tree.body, 1);
  EXPECT_EQ(tree.wheel, 0);
  const auto snapshot = graph.at(now);
  (void)snapshot.rotation(to<Wheel<1>>, from<Camera>);
  (void)snapshot.rotation(to<Camera>, from<Itrf>);
  EXPECT_EQ(tree.itrf, 2);
  EXPECT_EQ(tree.body, 2);
  EXPECT_EQ(tree.wheel, 1);
}

TEST(FrameGraph, AnEdgeMayTakeTheInstantToo) {
  const auto graph =
      frame_graph(static_edge(turned_x(to<Body>, from<Gcrf>, 0.5 * si::radian)),
                  edge([](const Dcm<Body, Gcrf>& R_b_from_i, Quantity<si::time> t) -> Dcm<Camera, Body> {
                    return turned_z(to<Camera>, from<Gcrf>, t.value() * si::radian) * inverse(R_b_from_i);
                  }));
  EXPECT_LE(distance(graph.at(0.25 * si::second).rotation(to<Camera>, from<Gcrf>).matrix(),
                     turned_z(to<Camera>, from<Gcrf>, 0.25 * si::radian).matrix()),
            rounding);
}

// A query that the graph cannot answer is refused by overload resolution.
template <class Snapshot, class B, class A>
concept Answers = requires(const Snapshot& snapshot) {
  snapshot.rotation(to<B>, from<A>);
};
template <class Snapshot, class B, class A, class C>
concept AnswersRate = requires(const Snapshot& snapshot) {
  snapshot.angular_velocity(of<B>, relative_to<A>, in<C>);
};
template <class... Edges>
concept Joins = requires(Edges... edges) {
  frame_graph(edges...);
};
template <class B, class A> using Fixed = ConstantEdge<Dcm<B, A>>;

using TwoTrees = GraphSnapshot<double, Fixed<Gcrf, Itrf>, Fixed<Body, Camera>>;
static_assert(Answers<TwoTrees, Itrf, Gcrf> && Answers<TwoTrees, Body, Camera>);
static_assert(!Answers<TwoTrees, Camera, Gcrf> && !Answers<TwoTrees, Ground, Gcrf>);
static_assert(!AnswersRate<TwoTrees, Itrf, Gcrf, Gcrf>);

// An edge may ask the edges before it, but not itself or those after it.
template <class Function> using Follows = FunctionEdge<Function>;
using OfItrf = Dcm<Gcrf, Body> (*)(const Dcm<Gcrf, Itrf>&);
using OfItself = Dcm<Gcrf, Body> (*)(const Dcm<Gcrf, Body>&);
static_assert(Joins<Fixed<Gcrf, Itrf>, Follows<OfItrf>> && Joins<Fixed<Itrf, Gcrf>, Follows<OfItrf>>);
static_assert(!Joins<Follows<OfItrf>, Fixed<Gcrf, Itrf>> && !Joins<Follows<OfItrf>>);
static_assert(!Joins<Fixed<Gcrf, Itrf>, Follows<OfItself>>);
static_assert(Joins<Fixed<Gcrf, Body>, Fixed<Body, Camera>> && Joins<Fixed<Gcrf, Itrf>, Fixed<Body, Camera>>);
static_assert(!Joins<>);
static_assert(!Joins<Fixed<Gcrf, Body>, Fixed<Gcrf, Body>> && !Joins<Fixed<Gcrf, Body>, Fixed<Body, Gcrf>>);
static_assert(!Joins<Fixed<Gcrf, Body>, Fixed<Body, Camera>, Fixed<Camera, Gcrf>>);
static_assert(!Joins<Fixed<Body, Body>>);

}  // namespace
}  // namespace graph_test
