#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace moving_dcm_test {
namespace {

template <class A, class B> bool same(const MovingDcm<A, B>& left, const Motion<A, B>& right) {
  return distance(left.rotation.matrix(), right.R) <= motion_tolerance &&
         distance(left.angular_velocity.coordinates(), right.w_ab_b().coordinates()) <= motion_tolerance;
}
template <class A, class B> bool same(const AcceleratingDcm<A, B>& left, const Motion<A, B>& right) {
  return same(without_acceleration(left), right) &&
         distance(left.angular_acceleration.coordinates(), right.alpha_ab_b().coordinates()) <=
             motion_tolerance;
}

// A tree of moving frames at one instant: Gcrf -- Body -- Camera, Camera -- Wheel<1>, and Gcrf -- Wheel<2>.
struct Motions {
  Dual2 t = instant(*coordinate());
  Dcm<Gcrf, Body, Dual2> gcrf_from_body = turning<Gcrf, Body>(0.7, t);
  Dcm<Camera, Body, Dual2> camera_from_body = turning<Camera, Body>(-1.3, t);
  Dcm<Camera, Wheel<1>, Dual2> camera_from_wheel = turning<Camera, Wheel<1>>(0.2, t);
  Dcm<Gcrf, Wheel<2>, Dual2> gcrf_from_wheel = turning<Gcrf, Wheel<2>>(1.9, t);
};

RC_GTEST_PROP(MovingDcm, TheProductIsTheMotionOfTheProduct, ()) {
  const Motions m;
  const auto R_body_from_camera = inverse(m.camera_from_body);
  const Motion<Gcrf, Body> ab(m.gcrf_from_body);
  const Motion<Body, Camera> bd(R_body_from_camera);
  const Motion<Gcrf, Camera> ad(m.gcrf_from_body * R_body_from_camera);
  RC_ASSERT(same(ab.moving() * bd.moving(), ad));
  RC_ASSERT(same(ab.accelerating() * bd.accelerating(), ad));
}

RC_GTEST_PROP(MovingDcm, TheInverseIsTheMotionOfTheInverse, ()) {
  const Motions m;
  const Motion<Gcrf, Body> ab(m.gcrf_from_body);
  const Motion<Body, Gcrf> ba(inverse(m.gcrf_from_body));
  RC_ASSERT(same(inverse(ab.moving()), ba));
  RC_ASSERT(same(inverse(ab.accelerating()), ba));
}

RC_GTEST_PROP(MovingDcm, TheRateMayBeGivenInEitherFrame, ()) {
  const Motions m;
  const Motion<Gcrf, Body> ab(m.gcrf_from_body);
  RC_ASSERT(same(moving_dcm(ab.rotation(), ab.rotation() * ab.w_ab_b()), ab));
}

/// Edge function that counts its evaluations.
template <class Value> struct Counting {
  Value value;
  int* count;

  Value operator()(Quantity<si::time>) const {
    ++*count;
    return value;
  }
};

RC_GTEST_PROP(FrameGraph, RatesAndAccelerationsAreThoseOfTheDifferentiatedPath, ()) {
  const Motions m;
  int evaluations[4] = {};
  const auto graph = frame_graph(
      edge(Counting<AcceleratingDcm<Gcrf, Body>>{Motion(m.gcrf_from_body).accelerating(), &evaluations[0]}),
      edge(Counting<AcceleratingDcm<Camera, Body>>{Motion(m.camera_from_body).accelerating(),
                                                   &evaluations[1]}),
      edge(Counting<AcceleratingDcm<Camera, Wheel<1>>>{Motion(m.camera_from_wheel).accelerating(),
                                                       &evaluations[2]}),
      edge(Counting<MovingDcm<Gcrf, Wheel<2>>>{Motion(m.gcrf_from_wheel).moving(), &evaluations[3]}));
  const auto snapshot = graph.at(0.0 * si::second);

  // Along a branch, in both directions.
  const Motion<Gcrf, Wheel<1>> down(m.gcrf_from_body * inverse(m.camera_from_body) * m.camera_from_wheel);
  const AngularVelocity<Gcrf, Wheel<1>, In<Gcrf>> w =
      snapshot.angular_velocity(of<Wheel<1>>, relative_to<Gcrf>, in<Gcrf>);
  RC_ASSERT(distance(w.coordinates(), down.w_a()) <= motion_tolerance);
  const AngularAcceleration<Gcrf, Wheel<1>, In<Gcrf>> alpha =
      snapshot.angular_acceleration(of<Wheel<1>>, relative_to<Gcrf>, in<Gcrf>);
  RC_ASSERT(distance(alpha.coordinates(), down.alpha_a()) <= motion_tolerance);
  const auto w_back = snapshot.angular_velocity(of<Gcrf>, relative_to<Wheel<1>>, in<Gcrf>);
  RC_ASSERT(distance(w_back.coordinates(), -down.w_a()) <= motion_tolerance);
  const auto alpha_back = snapshot.angular_acceleration(of<Gcrf>, relative_to<Wheel<1>>, in<Gcrf>);
  RC_ASSERT(distance(alpha_back.coordinates(), -down.alpha_a()) <= motion_tolerance);
  RC_ASSERT(evaluations[0] == 1 && evaluations[1] == 1 && evaluations[2] == 1 && evaluations[3] == 0);

  // Across branches, expressed in a frame that is not on the path.
  const Motion<Wheel<2>, Camera> across(inverse(m.gcrf_from_wheel) * m.gcrf_from_body *
                                        inverse(m.camera_from_body));
  const auto w_off = snapshot.angular_velocity(of<Camera>, relative_to<Wheel<2>>, in<Wheel<1>>);
  const auto R_off = snapshot.rotation(to<Wheel<1>>, from<Wheel<2>>);
  RC_ASSERT(distance(w_off.coordinates(), R_off.matrix() * across.w_a()) <= motion_tolerance);
  RC_ASSERT(evaluations[0] == 1 && evaluations[3] == 1);

  // The same by hand: w_2c = w_2g + w_gb + w_bc.
  const auto w_gb = snapshot.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
  const auto w_bc = snapshot.angular_velocity(of<Camera>, relative_to<Body>, in<Body>);
  const auto w_2g = snapshot.angular_velocity(of<Gcrf>, relative_to<Wheel<2>>, in<Body>);
  const auto by_hand = snapshot.rotation(to<Wheel<1>>, from<Body>) * (w_2g + w_gb + w_bc);
  RC_ASSERT(distance(by_hand.coordinates(), w_off.coordinates()) <= motion_tolerance);
}

// For every point where the paths to b and to c separate; also for a snapshot without a name, which caches
// nothing.
RC_GTEST_PROP(FrameGraph, MotionsAreExpressedInAnyFrameEachEdgeEvaluatedOnce, ()) {
  const Motions m;
  int evaluations[3] = {};
  const auto graph = frame_graph(
      edge(Counting<AcceleratingDcm<Gcrf, Body>>{Motion(m.gcrf_from_body).accelerating(), &evaluations[0]}),
      edge(Counting<AcceleratingDcm<Camera, Body>>{Motion(m.camera_from_body).accelerating(),
                                                   &evaluations[1]}),
      edge(Counting<AcceleratingDcm<Camera, Wheel<1>>>{Motion(m.camera_from_wheel).accelerating(),
                                                       &evaluations[2]}));
  const auto t = 0.0 * si::second;
  const Motion<Gcrf, Wheel<1>> whole(m.gcrf_from_body * inverse(m.camera_from_body) * m.camera_from_wheel);
  const auto check = [&]<class C>(In<C> expressed) {
    const auto R_c_from_a = graph.at(t).rotation(to<C>, from<Gcrf>).matrix();
    std::fill(std::begin(evaluations), std::end(evaluations), 0);
    const auto w = graph.at(t).angular_velocity(of<Wheel<1>>, relative_to<Gcrf>, expressed);
    RC_ASSERT(distance(w.coordinates(), R_c_from_a * whole.w_a()) <= motion_tolerance);
    RC_ASSERT(evaluations[0] == 1 && evaluations[1] == 1 && evaluations[2] == 1);
    const auto alpha = graph.at(t).angular_acceleration(of<Wheel<1>>, relative_to<Gcrf>, expressed);
    RC_ASSERT(distance(alpha.coordinates(), R_c_from_a * whole.alpha_a()) <= motion_tolerance);
    RC_ASSERT(evaluations[0] == 2 && evaluations[1] == 2 && evaluations[2] == 2);
  };
  check(in<Gcrf>);
  check(in<Body>);
  check(in<Camera>);
  check(in<Wheel<1>>);
}

TEST(FrameGraph, ARigidEdgeIsAtRest) {
  const auto mounting = turned_x(to<Body>, from<Camera>, 0.3 * si::radian);
  const auto w = vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(1, 2, 3));
  const auto graph = frame_graph(edge([=](Quantity<si::time>) {
                                   return moving_dcm(aligned(to<Gcrf>, from<Body>),
                                                     angular_velocity(of<Body>, relative_to<Gcrf>, w));
                                 }),
                                 rigid_edge(mounting));
  const auto snapshot = graph.at(0.0 * si::second);
  EXPECT_EQ(snapshot.angular_velocity(of<Camera>, relative_to<Body>, in<Camera>).coordinates(),
            Eigen::Vector3d::Zero());
  EXPECT_EQ(snapshot.angular_acceleration(of<Camera>, relative_to<Body>, in<Gcrf>).coordinates(),
            Eigen::Vector3d::Zero());
  EXPECT_LE(distance(snapshot.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Camera>).coordinates(),
                     (inverse(mounting) * w).coordinates()),
            rounding);
}

// A query for what an edge does not know is refused by overload resolution.
template <class Snapshot, class B, class A, class C>
concept AnswersRate = requires(const Snapshot& snapshot) {
  snapshot.angular_velocity(of<B>, relative_to<A>, in<C>);
};
template <class Snapshot, class B, class A, class C>
concept AnswersAcceleration = requires(const Snapshot& snapshot) {
  snapshot.angular_acceleration(of<B>, relative_to<A>, in<C>);
};
using Levels = GraphSnapshot<double, ConstantEdge<Dcm<Gcrf, Body>>, ConstantEdge<MovingDcm<Body, Camera>>,
                             ConstantEdge<AcceleratingDcm<Camera, Wheel<1>>>>;
static_assert(!AnswersRate<Levels, Body, Gcrf, Gcrf> && !AnswersRate<Levels, Camera, Gcrf, Gcrf>);
static_assert(AnswersRate<Levels, Camera, Body, Gcrf> && AnswersRate<Levels, Body, Wheel<1>, Camera>);
static_assert(!AnswersAcceleration<Levels, Camera, Body, Body>);
static_assert(AnswersAcceleration<Levels, Wheel<1>, Camera, Gcrf>);
static_assert(!AnswersRate<Levels, Ground, Body, Body> && !AnswersRate<Levels, Camera, Body, Ground>);
static_assert(!AnswersRate<Levels, Camera, Camera, Body> &&
              !AnswersAcceleration<Levels, Camera, Camera, Body>);

template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
static_assert(Multiplies<MovingDcm<Gcrf, Body>, MovingDcm<Body, Camera>>);
static_assert(!Multiplies<MovingDcm<Gcrf, Body>, MovingDcm<Gcrf, Body>>);
static_assert(!Multiplies<MovingDcm<Gcrf, Body>, Dcm<Body, Camera>>);
static_assert(!Multiplies<AcceleratingDcm<Gcrf, Body>, AcceleratingDcm<Camera, Body>>);
static_assert(!Multiplies<AcceleratingDcm<Gcrf, Body>, MovingDcm<Body, Camera>>);

}  // namespace
}  // namespace moving_dcm_test
