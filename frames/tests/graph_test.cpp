#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace graph_test {
namespace {

/// An edge's function that counts its evaluations.
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

// Gcrf -- Itrf -- Ground; Gcrf -- Body -- Camera; Body -- Wheel<1>; Body -- Wheel<2>. Edges point both ways.
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

// A path of many edges, listed out of order and pointing both ways.
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

// What the graph does not know, overload resolution refuses.
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
static_assert(Joins<Fixed<Gcrf, Body>, Fixed<Body, Camera>> && Joins<Fixed<Gcrf, Itrf>, Fixed<Body, Camera>>);
static_assert(!Joins<>);
static_assert(!Joins<Fixed<Gcrf, Body>, Fixed<Gcrf, Body>> && !Joins<Fixed<Gcrf, Body>, Fixed<Body, Gcrf>>);
static_assert(!Joins<Fixed<Gcrf, Body>, Fixed<Body, Camera>, Fixed<Camera, Gcrf>>);
static_assert(!Joins<Fixed<Body, Body>>);

}  // namespace
}  // namespace graph_test
