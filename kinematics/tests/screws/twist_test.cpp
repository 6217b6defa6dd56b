#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/screws/twist.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace twist_test {
namespace {

struct Tip : named_point {};

template <class A, class B, class P, class C> Twist<A, B, At<P>, In<C>> any_twist() {
  return twist(at<P>, angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<C>, *triple())),
               vector<si::velocity>(in<C>, *triple()));
}
template <class B, class A> Transform<B, A> any_transform() {
  return {trust_dcm(to<B>, from<A>, *rotation_matrix()),
          displacement(of<A>, relative_to<B>, vector<si::length>(in<B>, *triple()))};
}

RC_GTEST_PROP(Twist, ChainsAtOnePoint, ()) {
  const auto ab = any_twist<Gcrf, Body, Tip, Camera>();
  const auto bd = any_twist<Body, Wheel<1>, Tip, Camera>();
  const Twist<Gcrf, Wheel<1>, At<Tip>, In<Camera>> ad = ab + bd;
  RC_ASSERT(ad.coordinates() == ab.coordinates() + bd.coordinates());
  const Twist<Body, Gcrf, At<Tip>, In<Camera>> ba = -ab;
  RC_ASSERT(ba.coordinates() == -ab.coordinates());
}

RC_GTEST_PROP(Twist, DifferencesAtOnePointCancelTheCommonFrame, ()) {
  const auto ab = any_twist<Gcrf, Body, Tip, Camera>();
  const auto ad = any_twist<Gcrf, Wheel<1>, Tip, Camera>();
  const Twist<Body, Wheel<1>, At<Tip>, In<Camera>> bd = ad - ab;
  RC_ASSERT(bd.coordinates() == (-ab + ad).coordinates());
  const Twist<Gcrf, Body, At<Tip>, In<Camera>> again = ad - bd;
  RC_ASSERT(again.coordinates() == (ad + -bd).coordinates());
}

// If the chain holds at one point, it holds at every point.
RC_GTEST_PROP(Twist, ShiftCommutesWithTheChain, ()) {
  const auto ab = any_twist<Gcrf, Body, Tip, Camera>();
  const auto bd = any_twist<Body, Wheel<1>, Tip, Camera>();
  const auto r = displacement(of<Camera>, relative_to<Tip>, vector<si::length>(in<Camera>, *triple()));
  RC_ASSERT(distance(shift(ab + bd, r).coordinates(), (shift(ab, r) + shift(bd, r)).coordinates()) <=
            rounding);
  RC_ASSERT(distance(shift(shift(ab, r), -r).coordinates(), ab.coordinates()) <= rounding);
}

// A transform shifts and re-expresses, in either order; this equals the product with Ad.
RC_GTEST_PROP(Twist, TheTransformIsTheAdjoint, ()) {
  const auto V_b = any_twist<Gcrf, Wheel<1>, Body, Body>();
  const auto X_c_from_b = any_transform<Camera, Body>();
  const Twist<Gcrf, Wheel<1>, At<Camera>, In<Camera>> V_c = X_c_from_b * V_b;
  RC_ASSERT(distance(V_c.coordinates(), adjoint(X_c_from_b) * V_b.coordinates()) <= rounding);
  const auto r_bc_b = inverse(X_c_from_b).translation;
  RC_ASSERT(distance((X_c_from_b.rotation * shift(V_b, r_bc_b)).coordinates(), V_c.coordinates()) <=
            rounding);
  RC_ASSERT(distance((inverse(X_c_from_b) * V_c).coordinates(), V_b.coordinates()) <= rounding);
}

// Ad of a product is the product of the two Ad.
RC_GTEST_PROP(Twist, TheAdjointIsAHomomorphism, ()) {
  const auto X_cb = any_transform<Camera, Body>();
  const auto X_ba = any_transform<Body, Gcrf>();
  RC_ASSERT(distance(adjoint(X_cb * X_ba), adjoint(X_cb) * adjoint(X_ba)) <= rounding);
}

// A wheel of radius 0.5 m rolls along x at 3 m/s: its contact point is at rest, its top moves at 6 m/s.
TEST(Twist, TheContactOfARollingWheelRests) {
  const auto rolling =
      twist(at<Wheel<1>>,
            angular_velocity(of<Wheel<1>>, relative_to<Gcrf>,
                             vector<si::angular_velocity>(in<Gcrf>, Eigen::Vector3d(0, 6, 0))),
            vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(3, 0, 0)));
  const auto down =
      displacement(of<Tip>, relative_to<Wheel<1>>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(0, 0, -0.5)));
  EXPECT_EQ(shift(rolling, down).velocity().coordinates(), Eigen::Vector3d::Zero());
  const auto up =
      displacement(of<Tip>, relative_to<Wheel<1>>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(0, 0, 0.5)));
  EXPECT_EQ(shift(rolling, up).velocity().coordinates(), Eigen::Vector3d(6, 0, 0));
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class Left, class Right>
concept Shifts = requires(const Left& left, const Right& right) {
  shift(left, right);
};
template <class A, class B, class P, class C> using V = Twist<A, B, At<P>, In<C>>;
static_assert(!Adds<V<Gcrf, Body, Tip, Body>, V<Body, Camera, Camera, Body>>);
static_assert(!Adds<V<Gcrf, Body, Tip, Body>, V<Body, Camera, Tip, Gcrf>>);
static_assert(!Adds<V<Gcrf, Body, Tip, Body>, V<Gcrf, Camera, Tip, Body>>);
static_assert(Shifts<V<Gcrf, Body, Tip, Body>, Displacement<Tip, Camera, In<Body>>>);
static_assert(!Shifts<V<Gcrf, Body, Tip, Body>, Displacement<Camera, Tip, In<Body>>>);
static_assert(!Shifts<V<Gcrf, Body, Tip, Body>, Displacement<Tip, Camera, In<Camera>>>);

}  // namespace
}  // namespace twist_test
