#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

#include "moving_points.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace graph_places_test {
namespace {

/// Two differentiated chains of up to three edges, with derivatives up to 1e3 m/s^2.
constexpr double place_tolerance = 1e-10;

struct Far : moving_frame {};

/// A tree: gcrf - body - camera - wheel 1 and gcrf - wheel 2; the second edge is given in the opposite
/// direction. And far: body knows its rotation alone, at every level.
struct Tree {
  Dual2 t = instant(*coordinate());
  Transform<Gcrf, Body, Dual2> gcrf_body = travelling<Gcrf, Body>(0.7, t);
  Transform<Camera, Body, Dual2> camera_body = travelling<Camera, Body>(-1.3, t);
  Transform<Camera, Wheel<1>, Dual2> camera_wheel = travelling<Camera, Wheel<1>>(0.2, t);
  Transform<Gcrf, Wheel<2>, Dual2> gcrf_wheel = travelling<Gcrf, Wheel<2>>(1.9, t);
  Dcm<Body, Far, Dual2> body_far = turning<Body, Far>(0.4, t);

  auto graph() const {
    const auto place = [](const auto& X) { return edge([value = motion(X)](double) { return value; }); };
    return frame_graph(place(gcrf_body), place(camera_body), place(camera_wheel), place(gcrf_wheel),
                       edge([value = Motion<Body, Far>(body_far).accelerating()](double) { return value; }));
  }

  // X_f^gcrf(t); the position of far is never requested.
  template <class F> Transform<Gcrf, F, Dual2> from_gcrf() const {
    const auto nowhere = coincident<Gcrf, Gcrf, Gcrf, Dual2>(of<Gcrf>, relative_to<Gcrf>, in<Gcrf>);
    if constexpr (std::is_same_v<F, Gcrf>) {
      return {turning<Gcrf, Body>(0.0, t) * inverse(turning<Gcrf, Body>(0.0, t)), nowhere};
    } else if constexpr (std::is_same_v<F, Body>) {
      return gcrf_body;
    } else if constexpr (std::is_same_v<F, Camera>) {
      return gcrf_body * inverse(camera_body);
    } else if constexpr (std::is_same_v<F, Wheel<1>>) {
      return from_gcrf<Camera>() * camera_wheel;
    } else if constexpr (std::is_same_v<F, Wheel<2>>) {
      return gcrf_wheel;
    } else {
      const auto r = gcrf_body.translation.coordinates();
      return {gcrf_body.rotation * body_far,
              displacement(of<Far>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r))};
    }
  }

  // r_pq^a(t), from which follows the motion seen from a.
  template <class P, class Q, class A> Track<P, Q, A> seen() const {
    const auto r_pq_i = -from_gcrf<P>().translation + from_gcrf<Q>().translation;
    return Track<P, Q, A>(inverse(from_gcrf<A>().rotation) * r_pq_i);
  }
};

/// The graph's answer for q relative to p, seen from a, expressed in c, must be the derivative of r_pq^a.
template <class P, class Q, class A, class C> void check(const Tree& tree) {
  const auto graph = tree.graph();
  const auto now = graph.at(0.0);
  const Track<P, Q, A> seen = tree.seen<P, Q, A>();
  const auto R_c_from_a = now.rotation(to<C>, from<A>).matrix();
  const Displacement<P, Q, In<C>> r = now.position(of<Q>, relative_to<P>, in<C>);
  const Velocity<P, Q, ObservedFrom<A>, In<C>> v =
      now.velocity(of<Q>, relative_to<P>, observed_from<A>, in<C>);
  const Acceleration<P, Q, ObservedFrom<A>, In<C>> a =
      now.acceleration(of<Q>, relative_to<P>, observed_from<A>, in<C>);
  RC_ASSERT(distance(r.coordinates(), R_c_from_a * seen.r) <= place_tolerance);
  RC_ASSERT(distance(v.coordinates(), R_c_from_a * seen.v) <= place_tolerance);
  RC_ASSERT(distance(a.coordinates(), R_c_from_a * seen.a) <= place_tolerance);
}

RC_GTEST_PROP(GraphPlaces, AreTheDerivativesForEveryObserver, ()) {
  const Tree tree;
  check<Gcrf, Body, Gcrf, Gcrf>(tree);                // along one edge
  check<Body, Camera, Body, Gcrf>(tree);              // against one edge
  check<Gcrf, Wheel<1>, Gcrf, Body>(tree);            // seen from the near end
  check<Gcrf, Wheel<1>, Wheel<1>, Gcrf>(tree);        // seen from the far end
  check<Wheel<2>, Wheel<1>, Camera, Wheel<2>>(tree);  // seen from a frame on the path
  check<Body, Wheel<1>, Wheel<2>, Camera>(tree);      // seen from beyond the path
  check<Wheel<1>, Gcrf, Far, Far>(tree);              // seen from a frame without a position
}

RC_GTEST_PROP(GraphPlaces, TheTransformIsTheProduct, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const auto oracle = motion(tree.from_gcrf<Wheel<1>>());
  const Transform<Gcrf, Wheel<1>> X = graph.at(0.0).transform(to<Gcrf>, from<Wheel<1>>);
  const Transform<Wheel<1>, Gcrf> back = graph.at(0.0).transform(to<Wheel<1>>, from<Gcrf>);
  RC_ASSERT(distance(X.rotation.matrix(), oracle.turning.rotation.matrix()) <= place_tolerance);
  RC_ASSERT(distance(X.translation.coordinates(), oracle.translation.coordinates()) <= place_tolerance);
  RC_ASSERT(distance(homogeneous_matrix(back) * homogeneous_matrix(X), Eigen::Matrix4d::Identity()) <=
            place_tolerance);
}

RC_GTEST_PROP(GraphPlaces, RotationsAndRatesAreThoseOfTheTurning, ()) {
  const Tree tree;
  const auto graph = tree.graph();
  const Motion<Gcrf, Wheel<1>> oracle(tree.from_gcrf<Wheel<1>>().rotation);
  const auto w = graph.at(0.0).angular_velocity(of<Wheel<1>>, relative_to<Gcrf>, in<Gcrf>);
  const auto alpha = graph.at(0.0).angular_acceleration(of<Wheel<1>>, relative_to<Gcrf>, in<Gcrf>);
  RC_ASSERT(distance(w.coordinates(), oracle.w_a()) <= place_tolerance);
  RC_ASSERT(distance(alpha.coordinates(), oracle.alpha_a()) <= place_tolerance);
}

// A camera on an arm of 2 m along x of a body that turns about z at 3 rad/s: 6 m/s along y, 18 m/s^2 inwards.
TEST(GraphPlaces, ARigidlyMountedCameraIsCarriedAround) {
  const auto spinning = edge([](Quantity<si::time>) {
    return accelerating_dcm(
        aligned(to<Gcrf>, from<Body>),
        angular_velocity(of<Body>, relative_to<Gcrf>,
                         vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0, 0, 3))),
        unaccelerated(of<Body>, relative_to<Gcrf>, in<Body>));
  });
  const Transform arm{aligned(to<Body>, from<Camera>),
                      displacement(of<Camera>, relative_to<Body>,
                                   vector(in<Body>, 2.0 * si::metre, 0.0 * si::metre, 0.0 * si::metre))};
  const auto graph = frame_graph(spinning, rigid_edge(arm));
  const auto now = graph.at(0.0 * si::second);
  EXPECT_EQ(now.velocity(of<Camera>, relative_to<Body>, observed_from<Gcrf>, in<Gcrf>).coordinates(),
            Eigen::Vector3d(0, 6, 0));
  EXPECT_EQ(now.acceleration(of<Camera>, relative_to<Body>, observed_from<Gcrf>, in<Gcrf>).coordinates(),
            Eigen::Vector3d(-18, 0, 0));
  EXPECT_EQ(now.velocity(of<Camera>, relative_to<Body>, observed_from<Body>, in<Gcrf>).coordinates(),
            Eigen::Vector3d::Zero());
}

// Each edge is evaluated once per instant, also if the path to the result's frame shares edges.
TEST(GraphPlaces, EachEdgeIsEvaluatedOnce) {
  int evaluations = 0;
  const Transform place{
      aligned(to<Gcrf>, from<Body>),
      displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(1, 2, 3)))};
  const auto value = rigid_edge(place).value();
  const auto graph = frame_graph(edge([&](double) {
                                   ++evaluations;
                                   return value;
                                 }),
                                 rigid_edge(aligned(to<Body>, from<Camera>)));
  graph.at(0.0).acceleration(of<Body>, relative_to<Gcrf>, observed_from<Camera>, in<Gcrf>);
  EXPECT_EQ(evaluations, 1);
}

template <class Graph>
concept KnowsPlace = requires(const Graph& graph) {
  graph.position(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
};
template <class Graph>
concept KnowsVelocity = requires(const Graph& graph) {
  graph.velocity(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
};
template <class Graph>
concept KnowsAcceleration = requires(const Graph& graph) {
  graph.acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
};
template <class First, class Second>
using Of2 = GraphSnapshot<double, ConstantEdge<First>, ConstantEdge<Second>>;
using Turned = Of2<AcceleratingTransform<Gcrf, Body>, AcceleratingDcm<Body, Camera>>;
using Fixed = Of2<AcceleratingTransform<Gcrf, Body>, Transform<Body, Camera>>;
using Moving = Of2<AcceleratingTransform<Gcrf, Body>, MovingTransform<Body, Camera>>;
using Whole = Of2<AcceleratingTransform<Gcrf, Body>, AcceleratingTransform<Body, Camera>>;
static_assert(!KnowsPlace<Turned> && KnowsPlace<Fixed> && KnowsPlace<Moving>);
static_assert(!KnowsVelocity<Turned> && !KnowsVelocity<Fixed> && KnowsVelocity<Moving>);
static_assert(!KnowsAcceleration<Moving> && KnowsAcceleration<Whole>);

// The identity also has the scalar of the graph.
using OfFloats = GraphSnapshot<double, ConstantEdge<Transform<Gcrf, Body, float>>>;
static_assert(std::is_same_v<decltype(std::declval<const OfFloats&>().transform(to<Gcrf>, from<Gcrf>)),
                             Transform<Gcrf, Gcrf, float>>);

}  // namespace
}  // namespace graph_places_test
