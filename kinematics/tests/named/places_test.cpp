#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tuple>
#include <utility>
#include <vectrix/frames/graph/frame_graph.hpp>

#include "random_tree.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace named_places_test {
namespace {

constexpr auto now = 0.0 * si::second;

/// Every frame of the tree as p, q, a and c.
constexpr std::size_t most_frames = 5;
/// Two differentiated chains of up to four edges. Each edge multiplies the derivatives by up to 10 and 100:
/// accelerations reach 1e5 m/s^2, of which a hundred roundings are 1e-9.
constexpr double place_tolerance = 2e-9;

NamedAcceleratingTransform named(NamedFrame a, NamedFrame b, const AcceleratingTransform<Gcrf, Body>& X) {
  const auto& w = X.turning.angular_velocity.coordinates();
  const auto& alpha = X.turning.angular_acceleration.coordinates();
  return {
      accelerating_dcm(
          dcm(To(a), From(b), X.turning.rotation.matrix()),
          angular_velocity(Of(b), RelativeTo(a), vector<si::angular_velocity>(In(b), w)),
          angular_acceleration(Of(b), RelativeTo(a), vector<si::angular_acceleration>(In(b), alpha))),
      displacement(Of(b), RelativeTo(a), vector<si::length>(In(a), X.translation.coordinates())),
      velocity(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::velocity>(In(a), X.velocity.coordinates())),
      acceleration(Of(b), RelativeTo(a), ObservedFrom(a),
                   vector<si::acceleration>(In(a), X.acceleration.coordinates()))};
}
constexpr auto add_accelerating = [](NamedGraph& graph, NamedFrame a, NamedFrame b,
                                     const RandomTree::Placed& X) {
  graph.add_edge(
      edge(To(a), From(b), [value = named(a, b, motion(X))](Quantity<si::time>) { return value; }));
};
constexpr auto add_moving = [](NamedGraph& graph, NamedFrame a, NamedFrame b, const RandomTree::Placed& X) {
  const auto whole = named(a, b, motion(X));
  const NamedMovingTransform value{moving_dcm(whole.turning().rotation(), whole.turning().angular_velocity()),
                                   whole.translation(), whole.velocity()};
  graph.add_edge(edge(To(a), From(b), [value](Quantity<si::time>) { return value; }));
};
constexpr auto add_static = [](NamedGraph& graph, NamedFrame a, NamedFrame b, const RandomTree::Placed& X) {
  const auto whole = named(a, b, motion(X));
  graph.add_edge(static_edge(NamedTransform{whole.turning().rotation(), whole.translation()}));
};

template <class Answer>
void check(const Answer& answer, NamedFrame q, NamedFrame p, NamedFrame c, const Eigen::Vector3d& expected) {
  RC_ASSERT(answer.of() == q && answer.relative_to() == p && answer.in() == c);
  RC_ASSERT(distance(answer.coordinates(), expected) <= place_tolerance);
}

/// Calls use(p, q, a, c) with all p and q that differ.
template <class Use> void for_all(const RandomTree& tree, const Use& use) {
  tree.for_all([&](std::size_t p, std::size_t q) {
    if (p == q) return;
    tree.for_all([&](std::size_t a, std::size_t c) { use(p, q, a, c); });
  });
}

RC_GTEST_PROP(NamedPlaces, AreTheDerivativesForEveryObserver, ()) {
  const RandomTree tree(most_frames, add_accelerating);
  const NamedSnapshot snapshot = tree.graph.at(now);
  for_all(tree, [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    const NamedFrame p = tree.frames[i], q = tree.frames[j], a = tree.frames[k], c = tree.frames[l];
    const auto expected = tree.track(i, j, k);
    const Eigen::Matrix3d R_c_from_a = tree.rotation(l, k);
    check(snapshot.position(Of(q), RelativeTo(p), In(c)), q, p, c, R_c_from_a * expected.r);
    check(tree.graph.at(now).position(Of(q), RelativeTo(p), In(c)), q, p, c, R_c_from_a * expected.r);
    const NamedVelocity v = snapshot.velocity(Of(q), RelativeTo(p), ObservedFrom(a), In(c));
    check(v, q, p, c, R_c_from_a * expected.v);
    const NamedAcceleration acc = snapshot.acceleration(Of(q), RelativeTo(p), ObservedFrom(a), In(c));
    check(acc, q, p, c, R_c_from_a * expected.a);
    RC_ASSERT(v.observed_from() == a && acc.observed_from() == a);
  });
}

// Edges know no more than the question needs: the numbers of the other levels are not used.
RC_GTEST_PROP(NamedPlaces, NeedOnlyTheirLevel, ()) {
  const RandomTree fixed(most_frames, add_static);
  for_all(fixed, [&](std::size_t i, std::size_t j, std::size_t, std::size_t l) {
    const NamedFrame p = fixed.frames[i], q = fixed.frames[j], c = fixed.frames[l];
    check(fixed.graph.at(now).position(Of(q), RelativeTo(p), In(c)), q, p, c, fixed.track(i, j, l).r);
  });
  const RandomTree moving(most_frames, add_moving);
  for_all(moving, [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    const NamedFrame p = moving.frames[i], q = moving.frames[j], a = moving.frames[k], c = moving.frames[l];
    const auto v = moving.graph.at(now).velocity(Of(q), RelativeTo(p), ObservedFrom(a), In(c));
    check(v, q, p, c, moving.rotation(l, k) * moving.track(i, j, k).v);
  });
}

RC_GTEST_PROP(NamedPlaces, TheTransformIsRotationAndPosition, ()) {
  const RandomTree tree(most_frames, add_accelerating);
  const NamedSnapshot snapshot = tree.graph.at(now);
  tree.for_all([&](std::size_t i, std::size_t j) {
    const NamedFrame b = tree.frames[i], a = tree.frames[j];
    for (const NamedTransform& X :
         {snapshot.transform(To(b), From(a)), tree.graph.at(now).transform(To(b), From(a))}) {
      RC_ASSERT(X.rotation().to() == b && X.rotation().from() == a);
      RC_ASSERT(distance(X.rotation().matrix(), tree.rotation(i, j)) <= place_tolerance);
      check(X.translation(), a, b, b, tree.track(i, j, i).r);
    }
  });
}

template <class A, class B> auto placed(const Transform<A, B, Dual2>& X) {
  return edge([value = motion(X)](Quantity<si::time>) { return value; });
}
auto turned(const Dcm<Body, Ground, Dual2>& R) {
  return edge([value = Motion(R).accelerating()](Quantity<si::time>) { return value; });
}

/// gcrf - body - camera, the second edge in the opposite direction; and ground, of which body knows the
/// rotation alone, at every level. As a typed and as a named graph.
struct Both {
  Dual2 t = instant(*coordinate());
  Transform<Gcrf, Body, Dual2> gcrf_body = travelling<Gcrf, Body>(0.7, t);
  Transform<Camera, Body, Dual2> camera_body = travelling<Camera, Body>(-1.3, t);
  Dcm<Body, Ground, Dual2> body_ground = turning<Body, Ground>(0.4, t);

  NamedGraph graph;

  Both() {
    graph.add_frame<Gcrf>("gcrf");
    graph.add_frame<Body>("body");
    graph.add_frame<Camera>("camera");
    graph.add_frame<Ground>("ground");
    graph.add_edge(placed(camera_body));
    graph.add_edge(turned(body_ground));
    graph.add_edge(placed(gcrf_body));
  }
  auto types() const { return frame_graph(placed(gcrf_body), placed(camera_body), turned(body_ground)); }
};

/// The same numbers as the typed graph, for each p and q with a place and each observer; the axes are c's.
template <class P, class Q, class A, class C>
void answers_alike(const NamedSnapshot& named, const auto& typed) {
  const auto alike = [](const auto& x, const auto& y) {
    static_assert(std::same_as<decltype(x), decltype(y)>);
    RC_ASSERT(distance(x.coordinates(), y.coordinates()) <= place_tolerance);
  };
  alike(named.position(of<Q>, relative_to<P>, in<C>), typed.position(of<Q>, relative_to<P>, in<C>));
  alike(named.velocity(of<Q>, relative_to<P>, observed_from<A>, in<C>),
        typed.velocity(of<Q>, relative_to<P>, observed_from<A>, in<C>));
  alike(named.acceleration(of<Q>, relative_to<P>, observed_from<A>, in<C>),
        typed.acceleration(of<Q>, relative_to<P>, observed_from<A>, in<C>));
}
template <class P, class Q> void every_observer_alike(const NamedSnapshot& named, const auto& typed) {
  answers_alike<P, Q, Gcrf, Camera>(named, typed);
  answers_alike<P, Q, Body, Ground>(named, typed);
  answers_alike<P, Q, Camera, Gcrf>(named, typed);
  answers_alike<P, Q, Ground, Body>(named, typed);
  const Transform<P, Q> X = named.transform(to<P>, from<Q>);
  const Transform<P, Q> Y = typed.transform(to<P>, from<Q>);
  RC_ASSERT(distance(homogeneous_matrix(X), homogeneous_matrix(Y)) <= place_tolerance);
}

RC_GTEST_PROP(NamedPlaces, AreThoseOfTheTypedGraph, ()) {
  const Both both;
  const auto types = both.types();
  const auto typed = types.at(now);
  const NamedSnapshot named = both.graph.at(now);
  every_observer_alike<Gcrf, Body>(named, typed);
  every_observer_alike<Gcrf, Camera>(named, typed);
  every_observer_alike<Body, Gcrf>(named, typed);
  every_observer_alike<Body, Camera>(named, typed);
  every_observer_alike<Camera, Gcrf>(named, typed);
  every_observer_alike<Camera, Body>(named, typed);
}

// Handles, names and types ask the same; if all are types, the answer is typed.
RC_GTEST_PROP(NamedPlaces, TypesNamesAndHandlesMix, ()) {
  const Both both;
  const NamedSnapshot at = both.graph.at(now);
  const NamedFrame camera = both.graph.frame("camera");
  const NamedVelocity v = at.velocity(Of(camera), relative_to<Gcrf>, ObservedFrom("body"), In("ground"));
  RC_ASSERT(v.coordinates() ==
            at.velocity(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Ground>).coordinates());
  const NamedAcceleration a =
      at.acceleration(of<Camera>, RelativeTo("gcrf"), observed_from<Body>, In(camera));
  RC_ASSERT(a.coordinates() ==
            at.acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Camera>).coordinates());
  const NamedDisplacement r = at.position(Of(camera), RelativeTo("gcrf"), in<Ground>);
  RC_ASSERT(r.coordinates() == at.position(of<Camera>, relative_to<Gcrf>, in<Ground>).coordinates());
  const NamedTransform X = at.transform(To("gcrf"), from<Camera>);
  RC_ASSERT(X.translation().coordinates() == at.transform(to<Gcrf>, from<Camera>).translation.coordinates());
}

// An answer with a place can be an edge of a typed graph, at each level.
RC_GTEST_PROP(NamedPlaces, AnswersAreEdgesOfTheTypedGraph, ()) {
  const Both both;
  const auto expected = both.graph.at(now);
  const auto fixed = frame_graph(both.graph.typed_edge<Transform<Camera, Gcrf>>());
  const Transform<Camera, Gcrf> X = fixed.at(now).transform(to<Camera>, from<Gcrf>);
  RC_ASSERT(homogeneous_matrix(X) == homogeneous_matrix(expected.transform(to<Camera>, from<Gcrf>)));
  const auto alike = [](const auto& x, const auto& y) {
    RC_ASSERT(distance(x.coordinates(), y.coordinates()) <= place_tolerance);
  };
  const auto moving = frame_graph(both.graph.typed_edge<MovingTransform<Camera, Gcrf>>());
  alike(moving.at(now).velocity(of<Gcrf>, relative_to<Camera>, observed_from<Gcrf>, in<Gcrf>),
        expected.velocity(of<Gcrf>, relative_to<Camera>, observed_from<Gcrf>, in<Gcrf>));
  const auto whole = frame_graph(both.graph.typed_edge<AcceleratingTransform<Camera, Gcrf>>());
  alike(whole.at(now).acceleration(of<Gcrf>, relative_to<Camera>, observed_from<Gcrf>, in<Gcrf>),
        expected.acceleration(of<Gcrf>, relative_to<Camera>, observed_from<Gcrf>, in<Gcrf>));
  alike(whole.at(now).angular_acceleration(of<Gcrf>, relative_to<Camera>, in<Gcrf>),
        expected.angular_acceleration(of<Gcrf>, relative_to<Camera>, in<Gcrf>));
  const auto again = both.graph.typed_edge<Transform<Body, Gcrf>>();
  EXPECT_EQ(message<BadInput>([&] { again(std::numeric_limits<double>::infinity() * si::second); }),
            "NamedGraph: the time is inf s");
}

RC_GTEST_PROP(NamedPlaces, ValuesGoBothWays, ()) {
  const Both both;
  const NamedGraph& graph = both.graph;
  const NamedSnapshot at = graph.at(now);
  const auto same = [](const NamedFrame& frame, const char* name) { RC_ASSERT(frame.name() == name); };
  const auto r = at.position(of<Camera>, relative_to<Gcrf>, in<Body>);
  const NamedDisplacement named_r = graph.named(r);
  same(named_r.of(), "camera"), same(named_r.relative_to(), "gcrf"), same(named_r.in(), "body");
  const Displacement<Gcrf, Camera, In<Body>> r_again =
      graph.typed(of<Camera>, relative_to<Gcrf>, in<Body>, named_r);
  RC_ASSERT(r_again.coordinates() == r.coordinates());
  const auto v = at.velocity(of<Camera>, relative_to<Gcrf>, observed_from<Ground>, in<Body>);
  const NamedVelocity named_v = graph.named(v);
  same(named_v.of(), "camera"), same(named_v.relative_to(), "gcrf"), same(named_v.in(), "body");
  same(named_v.observed_from(), "ground");
  const Velocity<Gcrf, Camera, ObservedFrom<Ground>, In<Body>> v_again =
      graph.typed(of<Camera>, relative_to<Gcrf>, observed_from<Ground>, in<Body>, named_v);
  RC_ASSERT(v_again.coordinates() == v.coordinates());
  const auto a = at.acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Ground>, in<Body>);
  const NamedAcceleration named_a = graph.named(a);
  same(named_a.of(), "camera"), same(named_a.relative_to(), "gcrf"), same(named_a.in(), "body");
  same(named_a.observed_from(), "ground");
  const Acceleration<Gcrf, Camera, ObservedFrom<Ground>, In<Body>> a_again =
      graph.typed(of<Camera>, relative_to<Gcrf>, observed_from<Ground>, in<Body>, named_a);
  RC_ASSERT(a_again.coordinates() == a.coordinates());
  const auto X = at.transform(to<Camera>, from<Gcrf>);
  const Transform<Camera, Gcrf> X_again = graph.typed(to<Camera>, from<Gcrf>, graph.named(X));
  RC_ASSERT(homogeneous_matrix(X_again) == homogeneous_matrix(X));
  const auto refused = [](const auto& action) {
    return contains(message<BadInput>(action), "typed: the type " + frame_name<Body>() + " is bound to");
  };
  RC_ASSERT(refused([&] { graph.typed(of<Body>, relative_to<Gcrf>, in<Body>, named_r); }));
  RC_ASSERT(refused([&] { graph.typed(of<Camera>, relative_to<Body>, in<Body>, named_r); }));
  RC_ASSERT(
      refused([&] { graph.typed(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Body>, named_v); }));
  RC_ASSERT(
      refused([&] { graph.typed(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Body>, named_a); }));
  RC_ASSERT(refused([&] { graph.typed(to<Body>, from<Gcrf>, graph.named(X)); }));
}

}  // namespace
}  // namespace named_places_test
