#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <vectrix/kinematics.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace angular_velocity_test {
namespace {

template <class A, class B, class C> AngularVelocity<A, B, In<C>> any_rate() {
  return angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<C>, *triple()));
}
template <class A, class B, class C> AngularAcceleration<A, B, In<C>> any_acceleration() {
  return angular_acceleration(of<B>, relative_to<A>, vector<si::angular_acceleration>(in<C>, *triple()));
}
template <class B, class A> Dcm<B, A> any_dcm() {
  return trust_dcm(to<B>, from<A>, *rotation_matrix());
}

// 1. w_ab^c + w_bd^c = w_ad^c, in either order.
RC_GTEST_PROP(AngularVelocity, Law1SumsChain, ()) {
  const auto w_ab = any_rate<Gcrf, Body, Camera>();
  const auto w_bd = any_rate<Body, Wheel<1>, Camera>();
  const AngularVelocity<Gcrf, Wheel<1>, In<Camera>> w_ad = w_ab + w_bd;
  const AngularVelocity<Gcrf, Wheel<1>, In<Camera>> exchanged = w_bd + w_ab;
  RC_ASSERT(w_ad.coordinates() == w_ab.coordinates() + w_bd.coordinates());
  RC_ASSERT(exchanged.coordinates() == w_ad.coordinates());
  const AngularVelocity<Gcrf, Gcrf, In<Camera>> none = w_ab + -w_ab;
  RC_ASSERT(none.coordinates() == Eigen::Vector3d::Zero());
}

// w_ib^c - w_il^c = w_lb^c, compared with the derivative of R_b^l = R_i^l R_b^i; w_ib^c - w_lb^c = w_il^c.
RC_GTEST_PROP(AngularVelocity, DifferencesCancelTheCommonFrame, ()) {
  const Dual2 t = instant(*coordinate());
  const auto R_il = turning<Gcrf, Camera>(0.7, t);
  const auto R_ib = turning<Gcrf, Body>(-1.3, t);
  const Motion<Gcrf, Camera> il(R_il);
  const Motion<Gcrf, Body> ib(R_ib);
  const Motion<Camera, Body> lb(inverse(R_il) * R_ib);
  const auto w_il_i = il.rotation() * il.w_ab_b();
  const auto w_ib_i = ib.rotation() * ib.w_ab_b();
  const AngularVelocity<Camera, Body, In<Gcrf>> w_lb_i = w_ib_i - w_il_i;
  RC_ASSERT(distance((inverse(il.rotation()) * w_lb_i).coordinates(), lb.w_a()) <= motion_tolerance);
  const AngularVelocity<Gcrf, Camera, In<Gcrf>> again = w_ib_i - w_lb_i;
  RC_ASSERT(distance(again.coordinates(), w_il_i.coordinates()) <= motion_tolerance);
  const Vector<Gcrf, si::angular_velocity> error = error_between(again, w_il_i);
  RC_ASSERT(error.coordinates() == again.coordinates() - w_il_i.coordinates());
}

template <class Left, class Right>
concept Subtracts = requires(const Left& left, const Right& right) {
  left - right;
};
using BodyInGcrf = AngularVelocity<Gcrf, Body, In<Gcrf>>;
static_assert(!Subtracts<BodyInGcrf, BodyInGcrf>);
static_assert(!Subtracts<BodyInGcrf, AngularVelocity<Body, Camera, In<Gcrf>>>);
static_assert(!Subtracts<BodyInGcrf, AngularVelocity<Gcrf, Camera, In<Body>>>);
static_assert(
    !Subtracts<AngularAcceleration<Gcrf, Body, In<Gcrf>>, AngularAcceleration<Gcrf, Camera, In<Gcrf>>>);

TEST(AngularVelocity, TimesATypedGainIsATorque) {
  const auto w_b = angular_velocity(of<Body>, relative_to<Gcrf>,
                                    vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(1, -2, 3)));
  const auto k = 0.5 * (si::newton_metre / (si::radian / si::second));
  const Vector<Body, si::torque> damping = -k * w_b;
  EXPECT_EQ(damping.coordinates(), Eigen::Vector3d(-0.5, 1.0, -1.5));
  const Vector<Body, si::torque> same = -(0.5 * (si::newton_metre * si::second)) * w_b;
  EXPECT_EQ(same.coordinates(), damping.coordinates());
  const Vector<Body, si::angular_momentum> H = 2.0 * si::kilogram_square_metre * w_b;
  EXPECT_EQ(H.coordinates(), Eigen::Vector3d(2, -4, 6));
}

// 2. w_ba^c = -w_ab^c.
RC_GTEST_PROP(AngularVelocity, Law2ReversalChangesTheSign, ()) {
  const auto w_ab = any_rate<Gcrf, Body, Camera>();
  const AngularVelocity<Body, Gcrf, In<Camera>> w_ba = -w_ab;
  RC_ASSERT(w_ba.coordinates() == -w_ab.coordinates());
}

// 3. w_ab^d = R_c^d w_ab^c.
RC_GTEST_PROP(AngularVelocity, Law3ReexpressionKeepsThePair, ()) {
  const auto w_ab_c = any_rate<Gcrf, Body, Camera>();
  const auto R_d_from_c = any_dcm<Ground, Camera>();
  const AngularVelocity<Gcrf, Body, In<Ground>> w_ab_d = R_d_from_c * w_ab_c;
  RC_ASSERT(w_ab_d.coordinates() == R_d_from_c.matrix() * w_ab_c.coordinates());
}

// Law 1, compared with the derivative of the product: vee(d/dt(R_b^a R_d^b) (R_b^a R_d^b)^T).
RC_GTEST_PROP(AngularVelocity, Law1IsThatOfTheDifferentiatedProduct, ()) {
  const Dual2 t = instant(*coordinate());
  const auto R_ab = turning<Gcrf, Body>(0.7, t);
  const auto R_bd = turning<Body, Camera>(-1.3, t);
  const Motion<Gcrf, Body> ab(R_ab);
  const Motion<Body, Camera> bd(R_bd);
  const Motion<Gcrf, Camera> ad(R_ab * R_bd);
  const auto w_ad_a = ab.rotation() * ab.w_ab_b() + ab.rotation() * (bd.rotation() * bd.w_ab_b());
  RC_ASSERT(distance(w_ad_a.coordinates(), ad.w_a()) <= motion_tolerance);
}

// Law 1 of the accelerations, with its cross term, compared with the second derivative of the product.
RC_GTEST_PROP(AngularAcceleration, Law1ChainIsThatOfTheTwiceDifferentiatedProduct, ()) {
  const Dual2 t = instant(*coordinate());
  const auto R_ab = turning<Gcrf, Body>(0.7, t);
  const auto R_bd = turning<Body, Camera>(-1.3, t);
  const Motion<Gcrf, Body> ab(R_ab);
  const Motion<Body, Camera> bd(R_bd);
  const Motion<Gcrf, Camera> ad(R_ab * R_bd);
  const auto R_a_from_b = ab.rotation();
  const auto R_a_from_d = R_a_from_b * bd.rotation();
  const AngularAcceleration<Gcrf, Camera, In<Gcrf>> alpha_ad_a =
      chain(R_a_from_b * ab.alpha_ab_b(), R_a_from_d * bd.alpha_ab_b(), R_a_from_b * ab.w_ab_b(),
            R_a_from_d * bd.w_ab_b());
  RC_ASSERT(distance(alpha_ad_a.coordinates(), ad.alpha_a()) <= motion_tolerance);
}

TEST(AngularAcceleration, Law1FailsWithoutItsCrossTerm) {
  const Dual2 t = instant(0.4);
  const auto R_ab = turning<Gcrf, Body>(0.7, t);
  const auto R_bd = turning<Body, Camera>(-1.3, t);
  const Motion<Gcrf, Body> ab(R_ab);
  const Motion<Body, Camera> bd(R_bd);
  const Motion<Gcrf, Camera> ad(R_ab * R_bd);
  EXPECT_GT(distance(ab.alpha_a() + ab.R * bd.alpha_a(), ad.alpha_a()), visible);
}

// 2. alpha_ba^c = -alpha_ab^c; also that of the differentiated inverse.
RC_GTEST_PROP(AngularAcceleration, Law2ReversalChangesTheSign, ()) {
  const auto alpha = any_acceleration<Gcrf, Body, Camera>();
  const AngularAcceleration<Body, Gcrf, In<Camera>> reversed = -alpha;
  RC_ASSERT(reversed.coordinates() == -alpha.coordinates());
  const auto R_ab = turning<Gcrf, Body>(0.7, instant(*coordinate()));
  const Motion<Gcrf, Body> ab(R_ab);
  const Motion<Body, Gcrf> ba(inverse(R_ab));
  RC_ASSERT(distance(ba.R * -ab.alpha_a(), ba.alpha_a()) <= motion_tolerance);
}

// 3. alpha_ab^d = R_c^d alpha_ab^c.
RC_GTEST_PROP(AngularAcceleration, Law3ReexpressionKeepsThePair, ()) {
  const auto alpha_c = any_acceleration<Gcrf, Body, Camera>();
  const auto R_d_from_c = any_dcm<Ground, Camera>();
  const AngularAcceleration<Gcrf, Body, In<Ground>> alpha_d = R_d_from_c * alpha_c;
  RC_ASSERT(alpha_d.coordinates() == R_d_from_c.matrix() * alpha_c.coordinates());
}

TEST(AngularVelocity, ClaimsOfRestAreZero) {
  EXPECT_EQ(at_rest(of<Body>, relative_to<Gcrf>, in<Camera>).coordinates(), Eigen::Vector3d::Zero());
  EXPECT_EQ(unaccelerated(of<Body>, relative_to<Gcrf>, in<Camera>).coordinates(), Eigen::Vector3d::Zero());
}

// hat(): 1. [x]x y = x x y  2. [R x]x = R [x]x R^T  3. ([x]x)^2 = x x^T - |x|^2 I.
RC_GTEST_PROP(Hat, Laws1To3, ()) {
  const Eigen::Vector3d x = *triple();
  const Eigen::Vector3d y = *triple();
  const Eigen::Matrix3d R = *rotation_matrix();
  RC_ASSERT(distance(hat(x) * y, x.cross(y)) <= rounding);
  RC_ASSERT(distance(hat(R * x), R * hat(x) * R.transpose()) <= rounding);
  RC_ASSERT(distance(hat(x) * hat(x), x * x.transpose() - x.squaredNorm() * Eigen::Matrix3d::Identity()) <=
            rounding);
  RC_ASSERT(vee(hat(x)) == x);
}

TEST(Hat, VeeRefusesWhatIsNotSkew) {
  Eigen::Matrix3d matrix = hat(Eigen::Vector3d(1, 2, 4));
  matrix(0, 0) = 0.5;
  EXPECT_EQ(message<BadInput>([&] { vee(matrix); }),
            "vee(matrix): the symmetric part reaches 0.5 beside entries of 4; the matrix is not skew");
  matrix(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message<BadInput>([&] { vee(matrix); }), "vee(matrix): entry (1, 1) is nan");
  EXPECT_EQ(vee(Eigen::Matrix3d(Eigen::Matrix3d::Zero())), Eigen::Vector3d::Zero());
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class A, class B, class C> using W = AngularVelocity<A, B, In<C>>;
template <class A, class B, class C> using Alpha = AngularAcceleration<A, B, In<C>>;

static_assert(Adds<W<Gcrf, Body, Body>, W<Body, Camera, Body>>);
static_assert(Adds<W<Body, Camera, Body>, W<Gcrf, Body, Body>>);
static_assert(!Adds<W<Gcrf, Body, Body>, W<Gcrf, Camera, Body>>);
static_assert(!Adds<W<Gcrf, Body, Body>, W<Body, Camera, Camera>>);
static_assert(!Adds<W<Gcrf, Body, Body>, W<Ground, Camera, Body>>);
static_assert(!Adds<Alpha<Gcrf, Body, Body>, Alpha<Body, Camera, Body>>);
static_assert(!Adds<Alpha<Gcrf, Body, Body>, W<Body, Camera, Body>>);
static_assert(Multiplies<Dcm<Gcrf, Body>, W<Gcrf, Body, Body>>);
static_assert(!Multiplies<Dcm<Gcrf, Body>, W<Gcrf, Body, Gcrf>>);
static_assert(Multiplies<Dcm<Gcrf, Body>, Alpha<Gcrf, Body, Body>>);
static_assert(!Multiplies<Dcm<Gcrf, Body>, Alpha<Gcrf, Body, Gcrf>>);
static_assert(!std::is_convertible_v<W<Gcrf, Body, Body>, W<Body, Gcrf, Body>>);
static_assert(!std::is_convertible_v<W<Gcrf, Body, Body>, W<Gcrf, Body, Gcrf>>);
static_assert(!std::is_convertible_v<W<Gcrf, Body, Body>, Vector<Body, si::angular_velocity>>);
static_assert(!std::is_convertible_v<Vector<Body, si::angular_velocity>, W<Gcrf, Body, Body>>);
static_assert(!std::is_convertible_v<Alpha<Gcrf, Body, Body>, W<Gcrf, Body, Body>>);
static_assert(!std::is_default_constructible_v<W<Gcrf, Body, Body>>);
static_assert(sizeof(W<Gcrf, Body, Body>) == 3 * sizeof(double));

template <class Left, class Right>
concept AddsInPlace = requires(Left left, Right right) {
  left += right;
};
static_assert(!AddsInPlace<W<Gcrf, Body, Body>, W<Body, Camera, Body>>);
static_assert(!AddsInPlace<W<Gcrf, Body, Body>, W<Gcrf, Body, Body>>);

RC_GTEST_PROP(AngularVelocity, NormAndDotAreThoseOfTheCoordinates, ()) {
  const auto w = any_rate<Gcrf, Body, Body>();
  const auto alpha = any_acceleration<Gcrf, Body, Body>();
  const auto h = vector<si::angular_momentum>(in<Body>, *triple());
  const Quantity<si::angular_velocity> speed = norm(w);
  const Quantity<si::angular_acceleration> change = norm(alpha);
  const Quantity<si::energy> energy = dot(w, h);
  RC_ASSERT(speed.value() == w.coordinates().norm());
  RC_ASSERT(change.value() == alpha.coordinates().norm());
  RC_ASSERT(energy.value() == w.coordinates().dot(h.coordinates()));
  RC_ASSERT(dot(h, w).value() == energy.value());
}

// q and R re-express in the same way.
RC_GTEST_PROP(AngularVelocity, AQuaternionReexpressesAsItsMatrix, ()) {
  const auto R = any_dcm<Camera, Body>();
  const auto q = quaternion(R);
  const auto w = any_rate<Gcrf, Body, Body>();
  const auto alpha = any_acceleration<Gcrf, Body, Body>();
  const AngularVelocity<Gcrf, Body, In<Camera>> w_camera = q * w;
  const AngularAcceleration<Gcrf, Body, In<Camera>> alpha_camera = q * alpha;
  constexpr double rounding = 16 * epsilon;  // two products of some ten operations each
  RC_ASSERT(distance(w_camera.coordinates(), (R * w).coordinates()) <= rounding);
  RC_ASSERT(distance(alpha_camera.coordinates(), (R * alpha).coordinates()) <= rounding);
}

template <class T> std::string printed(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Print, rates_and_quaternions_say_their_frames) {
  const auto w = angular_velocity(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Camera>, Eigen::Vector3d{1.0, 2.0, 3.0}));
  const auto q = quaternion_scalar_first(to<Body>, from<Gcrf>, 1.0, 0.0, 0.0, 0.0);
  const std::string body = frame_name<Body>();
  const std::string gcrf = frame_name<Gcrf>();
  const std::string rate =
      "(1, 2, 3) rad/s of " + body + " relative to " + gcrf + " in " + frame_name<Camera>();
  EXPECT_EQ(printed(w), rate);
  EXPECT_EQ(printed(q), "(1; 0, 0, 0) to " + body + " from " + gcrf);
  const auto R = aligned(to<Gcrf>, from<Body>);
  const std::string rotation = "[1 0 0; 0 1 0; 0 0 1] to " + gcrf + " from " + body;
  const std::string still = "(0, 0, 0) rad/s of " + body + " relative to " + gcrf + " in " + body;
  const auto rest = at_rest(of<Body>, relative_to<Gcrf>, in<Body>);
  EXPECT_EQ(printed(moving_dcm(R, rest)), rotation + "; " + still);
  const auto place = coincident(of<Body>, relative_to<Gcrf>, in<Gcrf>);
  const std::string here = "(0, 0, 0) m of " + body + " relative to " + gcrf + " in " + gcrf;
  EXPECT_EQ(printed(Transform{R, place}), rotation + "; " + here);
  const auto speed = at_rest(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
  EXPECT_EQ(printed(speed),
            "(0, 0, 0) m/s of " + body + " relative to " + gcrf + " observed from " + gcrf + " in " + gcrf);
  EXPECT_EQ(printed(MovingTransform{moving_dcm(R, rest), place, speed}),
            rotation + "; " + still + "; " + here + "; " + printed(speed));
  EXPECT_EQ(printed(derivative<si::length>(observed_from<Gcrf>, speed.vector())),
            "(0, 0, 0) m/s in " + gcrf + " observed from " + gcrf);
  EXPECT_EQ(printed(twist(at<Camera>, rest, zero<si::velocity>(in<Body>))),
            still + "; (0, 0, 0) m/s in " + body + " at " + frame_name<Camera>());
  EXPECT_EQ(printed(vectrix::rate(R, rest)), "[0 0 0; 0 0 0; 0 0 0] 1/s to " + gcrf + " from " + body);
}

}  // namespace
}  // namespace angular_velocity_test
