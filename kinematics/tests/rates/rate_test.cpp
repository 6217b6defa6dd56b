#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rate_test {
namespace {

Motion<Gcrf, Body> any_motion() {
  return Motion<Gcrf, Body>(turning<Gcrf, Body>(0.7, instant(*coordinate())));
}

// d/dt R_b^a = R_b^a [w_ab^b]x = [w_ab^a]x R_b^a.
RC_GTEST_PROP(DcmRate, BodyAndReferenceFormAreTheDerivative, ()) {
  const auto ab = any_motion();
  const DcmRate<Gcrf, Body> body = rate(ab.rotation(), ab.w_ab_b());
  const DcmRate<Gcrf, Body> reference = rate(ab.rotation(), ab.rotation() * ab.w_ab_b());
  RC_ASSERT(distance(body.matrix(), ab.Rdot) <= motion_tolerance);
  RC_ASSERT(distance(reference.matrix(), ab.Rdot) <= motion_tolerance);
}

RC_GTEST_PROP(DcmRate, FormsAreTheProductsWithTheHat, ()) {
  const auto R = trust_dcm(to<Gcrf>, from<Body>, *rotation_matrix());
  const Eigen::Vector3d w = *triple();
  const auto w_b = angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w));
  const auto w_a = angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Gcrf>, w));
  RC_ASSERT(distance(rate(R, w_b).matrix(), R.matrix() * hat(w)) <= rounding);
  RC_ASSERT(distance(rate(R, w_a).matrix(), hat(w) * R.matrix()) <= rounding);
}

RC_GTEST_PROP(DcmRate, AngularVelocityUndoesRate, ()) {
  const auto ab = any_motion();
  const auto Rdot = rate(ab.rotation(), ab.w_ab_b());
  const AngularVelocity<Gcrf, Body, In<Body>> w_b = angular_velocity_from(ab.rotation(), Rdot, in<Body>);
  const AngularVelocity<Gcrf, Body, In<Gcrf>> w_a = angular_velocity_from(ab.rotation(), Rdot, in<Gcrf>);
  RC_ASSERT(distance(w_b.coordinates(), ab.w_ab_b().coordinates()) <= motion_tolerance);
  RC_ASSERT(distance(w_a.coordinates(), ab.w_a()) <= motion_tolerance);
}

RC_GTEST_PROP(DcmRate, TimesAFixedVectorIsItsVelocity, ()) {
  const auto ab = any_motion();
  const auto r_b = vector<si::length>(in<Body>, *triple());
  const Vector<Gcrf, si::velocity> v_a = rate(ab.rotation(), ab.w_ab_b()) * r_b;
  const auto w_a = ab.rotation() * ab.w_ab_b();
  RC_ASSERT(distance(v_a.coordinates(), cross(w_a.vector(), ab.rotation() * r_b).coordinates()) <=
            motion_tolerance);
}

TEST(DcmRate, ItsDoorTakesOnlyADerivativeOfThatRotation) {
  const Motion<Gcrf, Body> ab(turning<Gcrf, Body>(0.7, instant(0.3)));
  EXPECT_EQ(dcm_rate(ab.rotation(), ab.Rdot).matrix(), ab.Rdot);
  EXPECT_EQ(dcm_rate(ab.rotation(), Eigen::Matrix3d::Zero()).matrix(), Eigen::Matrix3d::Zero());
  const std::string door = "dcm_rate(R to " + frame_name<Gcrf>() + " from " + frame_name<Body>() + "): ";
  const std::string other = message<BadInput>([&] { dcm_rate(ab.rotation(), ab.R); });
  EXPECT_TRUE(contains(other, door) && contains(other, "the matrix is not skew")) << other;
  Eigen::Matrix3d bad = ab.Rdot;
  bad(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message<BadInput>([&] { dcm_rate(ab.rotation(), bad); }), door + "entry (2, 2) is inf");
}

TEST(DcmRate, OfAnotherRotationIsBadInput) {
  const Motion<Gcrf, Body> ab(turning<Gcrf, Body>(0.7, instant(0.3)));
  const Motion<Gcrf, Body> later(turning<Gcrf, Body>(0.7, instant(0.9)));
  const auto Rdot = rate(ab.rotation(), ab.w_ab_b());
  EXPECT_TRUE(contains(message<BadInput>([&] { angular_velocity_from(later.rotation(), Rdot, in<Body>); }),
                       "the matrix is not skew"));
}

// d/dt q = 1/2 q (0, w^b) = 1/2 (0, w^a) q: the derivative of dcm(q) in this direction is that of the DCM.
RC_GTEST_PROP(QuaternionRate, BodyAndReferenceFormAreTheDerivative, ()) {
  const auto ab = any_motion();
  const auto q = quaternion(ab.rotation());
  const QuaternionRate<Gcrf, Body> body = rate(q, ab.w_ab_b());
  const QuaternionRate<Gcrf, Body> reference = rate(q, ab.rotation() * ab.w_ab_b());
  RC_ASSERT(distance(body.eigen().coeffs(), reference.eigen().coeffs()) <= motion_tolerance);
  const auto dual = [&](int i) {
    return Dual(q.scalar_first()[std::size_t(i)],
                Eigen::Matrix<double, 1, 1>(body.scalar_first()[std::size_t(i)]));
  };
  const Eigen::Quaternion<Dual> moving(dual(0), dual(1), dual(2), dual(3));
  const Eigen::Matrix<Dual, 3, 3> R = moving.toRotationMatrix();
  const Eigen::Matrix3d Rdot = R.unaryExpr([](const Dual& x) { return x.derivatives()(0); });
  RC_ASSERT(distance(Rdot, ab.Rdot) <= motion_tolerance);
}

// d/dt|_a r = d/dt|_b r + w_ab x r, against the derivative of R_b^a r^b.
RC_GTEST_PROP(Transport, IsTheDerivativeSeenFromTheOtherFrame, ()) {
  const Dual2 t = instant(*coordinate());
  const auto R_ab = turning<Gcrf, Body>(0.7, t);
  const Motion<Gcrf, Body> ab(R_ab);
  const Eigen::Matrix<Dual2, 3, 1> r_b_of_t(t, t * t, constant(1.0) - t);
  const auto r_a_of_t = R_ab * vector<si::length>(in<Body>, r_b_of_t);
  const auto values = [](const auto& column) {
    return column.unaryExpr([](const Dual2& x) { return value(x); });
  };
  const auto rates = [](const auto& column) {
    return column.unaryExpr([](const Dual2& x) { return first(x); });
  };
  const Eigen::Vector3d r = values(r_b_of_t);
  const Eigen::Vector3d rdot_b = rates(r_b_of_t);
  const Eigen::Vector3d rdot_a = rates(r_a_of_t.coordinates());

  const auto seen_from_b =
      derivative<si::length>(observed_from<Body>, vector<si::velocity>(in<Body>, rdot_b));
  const Derivative<Gcrf, Body, si::length> seen_from_a =
      transport(observed_from<Gcrf>, seen_from_b, vector<si::length>(in<Body>, r), ab.w_ab_b());
  RC_ASSERT(distance(seen_from_a.vector().coordinates(), ab.R.transpose() * rdot_a) <= motion_tolerance);
  const auto back =
      transport(observed_from<Body>, seen_from_a, vector<si::length>(in<Body>, r), -ab.w_ab_b());
  RC_ASSERT(distance(back.vector().coordinates(), rdot_b) <= motion_tolerance);
}

template <class R, class W>
concept Drives = requires(const R& rotation, const W& w) {
  rate(rotation, w);
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class R, class W>
concept Joins = requires(const R& rotation, const W& w) {
  moving_dcm(rotation, w);
};
template <class A, class B, class C> using W = AngularVelocity<A, B, In<C>>;

static_assert(Drives<Dcm<Gcrf, Body>, W<Gcrf, Body, Body>> && Drives<Dcm<Gcrf, Body>, W<Gcrf, Body, Gcrf>>);
static_assert(!Drives<Dcm<Gcrf, Body>, W<Body, Gcrf, Body>> &&
              !Drives<Dcm<Gcrf, Body>, W<Gcrf, Body, Camera>>);
static_assert(!Drives<Dcm<Gcrf, Body>, W<Gcrf, Camera, Body>>);
static_assert(!Drives<Dcm<Gcrf, Body>, AngularAcceleration<Gcrf, Body, In<Body>>>);
static_assert(Drives<Quaternion<Gcrf, Body>, W<Gcrf, Body, Body>>);
static_assert(!Drives<Quaternion<Gcrf, Body>, W<Body, Gcrf, Body>>);
static_assert(!Drives<Quaternion<Gcrf, Body>, W<Gcrf, Body, Camera>>);
static_assert(Joins<Dcm<Gcrf, Body>, W<Gcrf, Body, Gcrf>> && !Joins<Dcm<Gcrf, Body>, W<Gcrf, Body, Camera>>);
static_assert(!Multiplies<DcmRate<Gcrf, Body>, Dcm<Body, Camera>>);
static_assert(!Multiplies<Dcm<Gcrf, Body>, DcmRate<Body, Camera>>);
static_assert(!Multiplies<DcmRate<Gcrf, Body>, Vector<Gcrf, si::length>>);
static_assert(!std::is_convertible_v<DcmRate<Gcrf, Body>, Dcm<Gcrf, Body>>);

}  // namespace
}  // namespace rate_test
