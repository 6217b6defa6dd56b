#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/points/parallel.hpp>

#include "moving_points.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace moving_transform_test {
namespace {

struct Tip : named_point {};
struct TipFrame : moving_frame {};

/// Derivatives reach 1e3 m/s^2 where three motions are chained; each product adds about ten roundings.
constexpr double chain_tolerance = 1e-11;

/// The point at the tip of an arm that moves in b, which turns in a: seen from both, expressed in b.
struct Arm {
  Dual2 t = instant(*coordinate());
  Dcm<Gcrf, Body, Dual2> R = turning<Gcrf, Body>(0.7, t);
  Displacement<Camera, Tip, In<Body>, Dual2> r_b = moving<Camera, Tip, Body>(-0.4, t);
  Motion<Gcrf, Body> ab{R};
  Track<Camera, Tip, Body> seen_from_b{r_b};
  Track<Camera, Tip, Gcrf> seen_from_a{R * r_b};
  Dcm<Body, Gcrf> R_b_from_a = inverse(ab.rotation());
};

RC_GTEST_PROP(Velocity, TransportIsTheDerivativeSeenFromTheOtherFrame, ()) {
  const Arm arm;
  const auto v_b = arm.seen_from_b.velocity();
  const auto r_b = arm.seen_from_b.displacement();
  const Velocity<Camera, Tip, ObservedFrom<Gcrf>, In<Body>> v_a =
      transport(observed_from<Gcrf>, v_b, r_b, arm.ab.w_ab_b());
  RC_ASSERT(distance((arm.ab.rotation() * v_a).coordinates(), arm.seen_from_a.v) <= chain_tolerance);
  const auto back = transport(observed_from<Body>, v_a, r_b, -arm.ab.w_ab_b());
  RC_ASSERT(distance(back.coordinates(), arm.seen_from_b.v) <= chain_tolerance);
}

RC_GTEST_PROP(Acceleration, TransportIsTheSecondDerivativeSeenFromTheOtherFrame, ()) {
  const Arm arm;
  const Acceleration<Camera, Tip, ObservedFrom<Gcrf>, In<Body>> a_a =
      transport(observed_from<Gcrf>, arm.seen_from_b.acceleration(), arm.seen_from_b.velocity(),
                arm.seen_from_b.displacement(), arm.ab.alpha_ab_b(), arm.ab.w_ab_b());
  RC_ASSERT(distance((arm.ab.rotation() * a_a).coordinates(), arm.seen_from_a.a) <= chain_tolerance);
}

// a_pq|b = a_pq|a + Euler + Coriolis + centrifugal
RC_GTEST_PROP(Acceleration, TheApparentAccelerationsAreWhatTheTurningObserverAdds, ()) {
  const Arm arm;
  const auto r_b = arm.seen_from_b.displacement();
  const auto w_ab_b = arm.ab.w_ab_b();
  const auto a_a = arm.R_b_from_a * arm.seen_from_a.acceleration();
  const Vector<Body, si::acceleration> a_b = a_a.vector() + euler_acceleration(arm.ab.alpha_ab_b(), r_b) +
                                             coriolis_acceleration(w_ab_b, arm.seen_from_b.velocity()) +
                                             centrifugal_acceleration(w_ab_b, r_b);
  RC_ASSERT(distance(a_b.coordinates(), arm.seen_from_b.a) <= chain_tolerance);
}

// A carousel turns about z at 2 rad/s. A stone is 3 m out on x and rolls inwards along x at 1 m/s.
TEST(Acceleration, TheApparentAccelerationsPointAsInTheTextbook) {
  const auto w = angular_velocity(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0, 0, 2)));
  const auto alpha = angular_acceleration(
      of<Body>, relative_to<Gcrf>, vector<si::angular_acceleration>(in<Body>, Eigen::Vector3d(0, 0, 5)));
  const auto r =
      displacement(of<Tip>, relative_to<Body>, vector<si::length>(in<Body>, Eigen::Vector3d(3, 0, 0)));
  const auto v = velocity(of<Tip>, relative_to<Body>, observed_from<Body>,
                          vector<si::velocity>(in<Body>, Eigen::Vector3d(-1, 0, 0)));
  EXPECT_EQ(centrifugal_acceleration(w, r).coordinates(), Eigen::Vector3d(12, 0, 0));  // outwards
  EXPECT_EQ(coriolis_acceleration(w, v).coordinates(), Eigen::Vector3d(0, 4, 0));      // along the rotation
  EXPECT_EQ(euler_acceleration(alpha, r).coordinates(), Eigen::Vector3d(0, -15, 0));   // against the rotation
}

// Frames with one origin, and a point that moves in one of them: its motion in the other is the transport of
// it, what the product of the two claims says.
RC_GTEST_PROP(MovingTransform, OfOneOriginTurnsTheMotionOfAPoint, ()) {
  const Arm arm;
  const auto turning = accelerating_dcm(arm.ab.rotation(), arm.ab.w_ab_b(), arm.ab.alpha_ab_b());
  const auto r_b = displacement(of<Tip>, relative_to<Body>, arm.seen_from_b.displacement().vector());
  const auto v_b =
      velocity(of<Tip>, relative_to<Body>, observed_from<Body>, arm.seen_from_b.velocity().vector());
  const auto a_b =
      acceleration(of<Tip>, relative_to<Body>, observed_from<Body>, arm.seen_from_b.acceleration().vector());
  const PointMotion<Body, TipFrame, Body> motion{
      displacement(of<TipFrame>, relative_to<Body>, r_b.vector()),
      velocity(of<TipFrame>, relative_to<Body>, observed_from<Body>, v_b.vector())};
  const auto carried =
      parallel(motion, acceleration(of<TipFrame>, relative_to<Body>, observed_from<Body>, a_b.vector()));
  const auto whole = product(coincident(turning), carried);
  RC_ASSERT(distance(whole.translation.coordinates(), arm.seen_from_a.r) <= chain_tolerance);
  RC_ASSERT(distance(whole.velocity.coordinates(), arm.seen_from_a.v) <= chain_tolerance);
  RC_ASSERT(distance(whole.acceleration.coordinates(), arm.seen_from_a.a) <= chain_tolerance);
  // The axes of the point do not turn in b: in a they turn as b does.
  RC_ASSERT(distance(whole.turning.angular_velocity.coordinates(), arm.ab.w_ab_b().coordinates()) == 0.0);
  const auto slower = product(coincident(without_acceleration(turning)), parallel(motion));
  RC_ASSERT(slower.velocity.coordinates() == whole.velocity.coordinates());
  RC_ASSERT(product(coincident(arm.ab.rotation()), transform_of(carried)).translation.coordinates() ==
            whole.translation.coordinates());
}

TEST(Velocity, RestIsClaimedByName) {
  EXPECT_EQ(at_rest(of<Tip>, relative_to<Body>, observed_from<Body>, in<Gcrf>).coordinates(),
            Eigen::Vector3d::Zero());
  EXPECT_EQ(unaccelerated(of<Tip>, relative_to<Body>, observed_from<Body>, in<Gcrf>).coordinates(),
            Eigen::Vector3d::Zero());
}

/// Three motions that do not commute, and the transforms whose derivatives they are.
struct Chain {
  Dual2 t = instant(*coordinate());
  Transform<Gcrf, Body, Dual2> ab = travelling<Gcrf, Body>(0.7, t);
  Transform<Body, Camera, Dual2> bc = travelling<Body, Camera>(-1.3, t);
};

RC_GTEST_PROP(MovingTransform, TheProductIsTheMotionOfTheProduct, ()) {
  const Chain chain;
  const auto ac = motion(chain.ab * chain.bc);
  RC_ASSERT(distance(motion(chain.ab) * motion(chain.bc), ac) <= chain_tolerance);
  RC_ASSERT(distance(moving_transform_of(motion(chain.ab)) * moving_transform_of(motion(chain.bc)),
                     moving_transform_of(ac)) <= chain_tolerance);
}

RC_GTEST_PROP(MovingTransform, TheInverseIsTheMotionOfTheInverse, ()) {
  const Chain chain;
  const auto ba = motion(inverse(chain.ab));
  RC_ASSERT(distance(inverse(motion(chain.ab)), ba) <= chain_tolerance);
  RC_ASSERT(distance(inverse(moving_transform_of(motion(chain.ab))), moving_transform_of(ba)) <=
            chain_tolerance);
}

template <class... Arguments>
concept Transports = requires(const Arguments&... arguments) {
  transport(arguments...);
};
template <class P, class Q, class A, class C> using V = Velocity<P, Q, ObservedFrom<A>, In<C>>;
template <class A, class B, class C> using W = AngularVelocity<A, B, In<C>>;
template <class P, class Q, class C> using R = Displacement<P, Q, In<C>>;
using SeenFromGcrf = ObservedFrom<Gcrf>;
static_assert(Transports<SeenFromGcrf, V<Body, Tip, Body, Body>, R<Body, Tip, Body>, W<Gcrf, Body, Body>>);
static_assert(!Transports<SeenFromGcrf, V<Body, Tip, Body, Body>, R<Body, Tip, Body>, W<Body, Gcrf, Body>>);
static_assert(!Transports<SeenFromGcrf, V<Body, Tip, Body, Body>, R<Body, Tip, Body>, W<Gcrf, Body, Gcrf>>);
static_assert(!Transports<SeenFromGcrf, V<Body, Tip, Body, Body>, R<Tip, Body, Body>, W<Gcrf, Body, Body>>);
static_assert(!Transports<SeenFromGcrf, V<Body, Tip, Camera, Body>, R<Body, Tip, Body>, W<Gcrf, Body, Body>>);

template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
static_assert(Multiplies<MovingTransform<Gcrf, Body>, MovingTransform<Body, Camera>>);
static_assert(!Multiplies<MovingTransform<Gcrf, Body>, MovingTransform<Gcrf, Body>>);
static_assert(!Multiplies<MovingTransform<Gcrf, Body>, Transform<Body, Camera>>);
static_assert(!Multiplies<AcceleratingTransform<Gcrf, Body>, MovingTransform<Body, Camera>>);
static_assert(!Multiplies<MovingTransform<Gcrf, Body>, MovingDcm<Body, Camera>>);

}  // namespace
}  // namespace moving_transform_test
