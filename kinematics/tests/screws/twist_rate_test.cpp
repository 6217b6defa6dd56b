// Twists and their rates for frames that rotate and move, compared with the derivatives of the homogeneous
// matrix.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "points/moving_points.hpp"
#include "rigid_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace twist_rate_test {
namespace {

struct Tip : named_point {};

/// Derivatives reach 1e3 m/s^2 where three motions are chained; each product adds about ten roundings.
constexpr double chain_tolerance = 1e-11;

/// X_b^a(t) and the derivatives of its matrix.
template <class A, class B> struct Journey {
  Transform<A, B, Dual2> X;
  Eigen::Matrix4d G, Gdot, Gddot;
  AcceleratingTransform<A, B> now;

  Journey(double seed, const Dual2& t) : Journey(travelling<A, B>(seed, t)) {}
  explicit Journey(const Transform<A, B, Dual2>& moving) : X(moving), now(motion(moving)) {
    const auto matrix = homogeneous_matrix(moving);
    G = matrix.unaryExpr([](const Dual2& x) { return value(x); });
    Gdot = matrix.unaryExpr([](const Dual2& x) { return first(x); });
    Gddot = matrix.unaryExpr([](const Dual2& x) { return second(x); });
  }

  Transform<A, B> place() const { return transform_of(now); }
  /// V^ = Gdot G^-1, at a's origin in a's axes, and its derivative.
  Eigen::Matrix4d V_hat() const { return Gdot * G.inverse(); }
  Eigen::Matrix4d Vdot_hat() const { return Gddot * G.inverse() - V_hat() * V_hat(); }
};

/// The six numbers of [[w]x v; 0 0].
Eigen::Matrix<double, 6, 1> six(const Eigen::Matrix4d& m) {
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), 2 * m.topRightCorner<3, 1>();
  return numbers / 2;
}

// V_ab(a)^a = Gdot G^-1 and V_ab(b)^b = G^-1 Gdot.
RC_GTEST_PROP(Twist, IsTheDerivativeOfTheTransform, ()) {
  const Journey<Gcrf, Body> ab(0.7, instant(*coordinate()));
  const Twist<Gcrf, Body, At<Body>, In<Body>> V_b = twist_of(ab.now);
  RC_ASSERT(distance(V_b.coordinates(), six(ab.G.inverse() * ab.Gdot)) <= chain_tolerance);
  RC_ASSERT(distance((ab.place() * V_b).coordinates(), six(ab.V_hat())) <= chain_tolerance);
}

// Vdot at a in a is the derivative of the six numbers of V there; at b in b, of the six numbers there.
RC_GTEST_PROP(TwistRate, IsTheDerivativeOfTheTwistInEitherFrame, ()) {
  const Journey<Gcrf, Body> ab(0.7, instant(*coordinate()));
  const TwistRate<Gcrf, Body, At<Body>, In<Body>> Vdot_b = twist_rate_of(ab.now);
  RC_ASSERT(distance((ab.place() * Vdot_b).coordinates(), six(ab.Vdot_hat())) <= chain_tolerance);
  const Eigen::Matrix4d V_hat_b = ab.G.inverse() * ab.Gdot;
  RC_ASSERT(distance(Vdot_b.coordinates(), six(ab.G.inverse() * ab.Gddot - V_hat_b * V_hat_b)) <=
            chain_tolerance);
}

// d/dt Ad(X) = Ad(X) ad(V_b) = ad(V_a) Ad(X), by a difference over 2h: h^2 times a third derivative of 1e3.
RC_GTEST_PROP(Bracket, DrivesTheAdjoint, ()) {
  constexpr double h = 1e-5;
  constexpr double difference_tolerance = 1e-6;
  const double t = *coordinate();
  const Journey<Gcrf, Body> ab(0.7, instant(t));
  const auto Ad = [](double at) { return adjoint(Journey<Gcrf, Body>(0.7, instant(at)).place()); };
  const Eigen::Matrix<double, 6, 6> slope = (Ad(t + h) - Ad(t - h)) / (2 * h);
  const auto V_b = twist_of(ab.now);
  RC_ASSERT(distance(slope, Ad(t) * ad(V_b)) <= difference_tolerance);
  RC_ASSERT(distance(slope, ad(ab.place() * V_b) * Ad(t)) <= difference_tolerance);
}

// V^dot + V^ V^: the acceleration of the particle that is at a's origin now, rddot - ([alpha]x + [w]x^2) r.
RC_GTEST_PROP(TwistRate, AndTwistMakeTheAccelerationOfTheParticle, ()) {
  const Journey<Gcrf, Body> ab(0.7, instant(*coordinate()));
  const auto V_a = ab.place() * twist_of(ab.now);
  const auto Vdot_a = ab.place() * twist_rate_of(ab.now);
  const Vector<Gcrf, si::acceleration> a = particle_acceleration(V_a, Vdot_a);
  const Eigen::Matrix4d spatial = ab.Vdot_hat() + ab.V_hat() * ab.V_hat();
  RC_ASSERT(distance(a.coordinates(), spatial.topRightCorner<3, 1>()) <= chain_tolerance);
  const Eigen::Vector3d w = V_a.coordinates().head<3>();
  const Eigen::Vector3d alpha = Vdot_a.coordinates().head<3>();
  const Eigen::Vector3d r = ab.G.topRightCorner<3, 1>();
  const Eigen::Vector3d rddot = ab.Gddot.topRightCorner<3, 1>();
  RC_ASSERT(distance(a.coordinates(), rddot - alpha.cross(r) - w.cross(w.cross(r))) <= chain_tolerance);
}

// A point fixed in b, by its twist and by its trajectory: velocity and acceleration relative to a's origin.
RC_GTEST_PROP(TwistRate, MovesAPointOfTheBodyAsItsTrackSays, ()) {
  const Dual2 t = instant(*coordinate());
  const Journey<Gcrf, Body> ab(0.7, t);
  const Eigen::Vector3d place = *triple();
  const auto r_bq_b = displacement(of<Tip>, relative_to<Body>, vector<si::length>(in<Body>, place));
  const auto fixed = displacement(
      of<Tip>, relative_to<Body>,
      vector<si::length>(in<Body>,
                         Eigen::Matrix<Dual2, 3, 1>(place.unaryExpr([](double x) { return constant(x); }))));
  const Track<Gcrf, Tip, Gcrf> track(ab.X * fixed);
  const auto V_q = shift(twist_of(ab.now), r_bq_b);
  const auto Vdot_q = shift(twist_rate_of(ab.now), r_bq_b);
  const auto& R_a_from_b = rotation_of(ab.now);
  const Velocity<Gcrf, Tip, ObservedFrom<Gcrf>, In<Gcrf>> v = R_a_from_b * point_velocity(of<Tip>, V_q);
  const Acceleration<Gcrf, Tip, ObservedFrom<Gcrf>, In<Gcrf>> a =
      R_a_from_b * point_acceleration(of<Tip>, V_q, Vdot_q);
  RC_ASSERT(distance(v.coordinates(), track.v) <= chain_tolerance);
  RC_ASSERT(distance(a.coordinates(), track.a) <= chain_tolerance);
  // The same from transport() of a point at rest.
  const auto w_ab_b = twist_of(ab.now).angular_velocity();
  const auto alpha_ab_b = twist_rate_of(ab.now).angular_acceleration();
  const auto a_bq_a_b = transport(
      observed_from<Gcrf>, unaccelerated(of<Tip>, relative_to<Body>, observed_from<Body>, in<Body>),
      at_rest(of<Tip>, relative_to<Body>, observed_from<Body>, in<Body>), r_bq_b, alpha_ab_b, w_ab_b);
  RC_ASSERT(distance((ab.now.acceleration + R_a_from_b * a_bq_a_b).coordinates(), track.a) <=
            chain_tolerance);
}

// Vdot_ad = Vdot_ab + Vdot_bd + ad(V_ab) V_bd, at d in d; it equals the chain of the motions.
RC_GTEST_PROP(TwistRate, ChainsWithTheBracket, ()) {
  const Dual2 t = instant(*coordinate());
  const Journey<Gcrf, Body> ab(0.7, t);
  const Journey<Body, Camera> bd(-0.4, t);
  const auto X_d_from_b = inverse(bd.place());
  const auto V_ab = X_d_from_b * twist_of(ab.now);
  const auto Vdot_ab = X_d_from_b * twist_rate_of(ab.now);
  const auto V_bd = twist_of(bd.now);
  const auto Vdot_bd = twist_rate_of(bd.now);
  const TwistRate<Gcrf, Camera, At<Camera>, In<Camera>> Vdot_ad = chain(Vdot_ab, Vdot_bd, V_ab, V_bd);
  const auto ad_motion = ab.now * bd.now;
  RC_ASSERT(distance((V_ab + V_bd).coordinates(), twist_of(ad_motion).coordinates()) <= chain_tolerance);
  RC_ASSERT(distance(Vdot_ad.coordinates(), twist_rate_of(ad_motion).coordinates()) <= chain_tolerance);
  const Eigen::Matrix<double, 6, 1> sum =
      Vdot_ab.coordinates() + Vdot_bd.coordinates() + ad(V_ab) * V_bd.coordinates();
  RC_ASSERT(distance(Vdot_ad.coordinates(), sum) <= chain_tolerance);
}

// Vdot_ba = -Vdot_ab: the motion of a seen from b.
RC_GTEST_PROP(TwistRate, Reverses, ()) {
  const Journey<Gcrf, Body> ab(0.7, instant(*coordinate()));
  const TwistRate<Body, Gcrf, At<Gcrf>, In<Gcrf>> Vdot_ba = -(ab.place() * twist_rate_of(ab.now));
  RC_ASSERT(distance(twist_rate_of(inverse(ab.now)).coordinates(), Vdot_ba.coordinates()) <= chain_tolerance);
}

// A transform shifts and re-expresses, in either order; this equals the product with Ad.
RC_GTEST_PROP(TwistRate, TheTransformIsTheAdjoint, ()) {
  const Dual2 t = instant(*coordinate());
  const auto Vdot_b = twist_rate_of(Journey<Gcrf, Body>(0.7, t).now);
  const auto X_d_from_b = inverse(Journey<Body, Camera>(-0.4, t).place());
  const TwistRate<Gcrf, Body, At<Camera>, In<Camera>> Vdot_d = X_d_from_b * Vdot_b;
  RC_ASSERT(distance(Vdot_d.coordinates(), adjoint(X_d_from_b) * Vdot_b.coordinates()) <= chain_tolerance);
  const auto r_bd_b = inverse(X_d_from_b).translation;
  RC_ASSERT(distance((X_d_from_b.rotation * shift(Vdot_b, r_bd_b)).coordinates(), Vdot_d.coordinates()) <=
            chain_tolerance);
}

// A top of radius 2 m spins at a constant 3 rad/s: its rim accelerates towards the axis, and the velocity at
// a point fixed in the room does not change.
TEST(TwistRate, OfASteadySpinIsZeroAndItsParticlesAccelerate) {
  const auto w = angular_velocity(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Gcrf>, Eigen::Vector3d(0, 0, 3)));
  const auto V = twist(at<Tip>, w, vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(0, 6, 0)));
  const auto inwards = vector<si::acceleration>(in<Gcrf>, Eigen::Vector3d(-18, 0, 0));
  const auto Vdot = twist_rate(V, unaccelerated(of<Body>, relative_to<Gcrf>, in<Gcrf>), inwards);
  EXPECT_EQ(Vdot.coordinates(), (Eigen::Matrix<double, 6, 1>::Zero()));
  EXPECT_EQ(particle_acceleration(V, Vdot).coordinates(), inwards.coordinates());
}

// w_ab and v of a screw that changes, compared with the derivatives of its exponential.
RC_GTEST_PROP(ScrewRate, TheJacobiansMakeItTheTwist, ()) {
  const Dual2 t = instant(0.0);
  const auto numbers = [&](double size) {
    const Eigen::Vector3d start = *triple();
    const Eigen::Vector3d rate = *triple();
    Eigen::Matrix<Dual2, 3, 1> moving;
    for (Eigen::Index i = 0; i < 3; ++i) moving(i) = constant(size * start(i)) + t * constant(rate(i));
    return moving;
  };
  const auto theta = numbers(*rc::gen::element(0.0, 1e-9, 1.0, 2.5));
  const auto rho = numbers(3.0);
  const auto values = [](const auto& column) -> Eigen::Vector3d {
    return column.unaryExpr([](const Dual2& x) { return value(x); });
  };
  const auto rates = [](const auto& column) -> Eigen::Vector3d {
    return column.unaryExpr([](const Dual2& x) { return first(x); });
  };
  const auto moving = homogeneous_matrix(exp(screw(
      of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta), vector<si::length>(in<Gcrf>, rho))));
  const Eigen::Matrix4d G = moving.unaryExpr([](const Dual2& x) { return value(x); });
  const Eigen::Matrix4d Gdot = moving.unaryExpr([](const Dual2& x) { return first(x); });
  Eigen::Matrix<double, 6, 1> xi;
  xi << values(theta), values(rho);
  const auto xi_ab = screw_of(xi);
  const auto xidot_ab =
      screw_rate(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, rates(theta)),
                 vector<si::velocity>(in<Body>, rates(rho)));
  const Twist<Gcrf, Body, At<Body>, In<Body>> V_b = twist_from(xi_ab, xidot_ab, in<Body>);
  const Twist<Gcrf, Body, At<Gcrf>, In<Gcrf>> V_a = twist_from(xi_ab, xidot_ab, in<Gcrf>);
  RC_ASSERT(distance(V_b.coordinates(), six(G.inverse() * Gdot)) <= chain_tolerance);
  RC_ASSERT(distance(V_a.coordinates(), six(Gdot * G.inverse())) <= chain_tolerance);
  RC_ASSERT(distance(V_b.coordinates(), right_jacobian(xi_ab) * xidot_ab.coordinates()) <= chain_tolerance);
  RC_ASSERT(distance(V_a.coordinates(), left_jacobian(xi_ab) * xidot_ab.coordinates()) <= chain_tolerance);
  const ScrewRate<Gcrf, Body> by_b = rate(xi_ab, V_b);
  const ScrewRate<Gcrf, Body> by_a = rate(xi_ab, V_a);
  RC_ASSERT(distance(by_b.coordinates(), xidot_ab.coordinates()) <= chain_tolerance);
  RC_ASSERT(distance(by_a.coordinates(), xidot_ab.coordinates()) <= chain_tolerance);
  const ScrewRate<Body, Gcrf> back = -xidot_ab;
  RC_ASSERT(distance(twist_from(-xi_ab, back, in<Body>).coordinates(), -V_b.coordinates()) <=
            chain_tolerance);
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class Motion, class Change>
concept Accelerates = requires(const Motion& V, const Change& Vdot) {
  particle_acceleration(V, Vdot);
};
template <class Xi, class Motion>
concept Drives = requires(const Xi& screw, const Motion& V) {
  rate(screw, V);
};
template <class A, class B, class P, class C> using V = Twist<A, B, At<P>, In<C>>;
template <class A, class B, class P, class C> using Vdot = TwistRate<A, B, At<P>, In<C>>;
static_assert(!Adds<Vdot<Gcrf, Body, Tip, Body>, Vdot<Body, Camera, Tip, Body>>);
static_assert(Accelerates<V<Gcrf, Body, Tip, Body>, Vdot<Gcrf, Body, Tip, Body>>);
static_assert(!Accelerates<V<Gcrf, Body, Tip, Body>, Vdot<Gcrf, Body, Camera, Body>> &&
              !Accelerates<V<Gcrf, Body, Tip, Body>, Vdot<Gcrf, Body, Tip, Gcrf>> &&
              !Accelerates<V<Gcrf, Body, Tip, Body>, Vdot<Body, Gcrf, Tip, Body>>);
static_assert(Drives<Screw<Gcrf, Body>, V<Gcrf, Body, Body, Body>> &&
              Drives<Screw<Gcrf, Body>, V<Gcrf, Body, Gcrf, Gcrf>>);
static_assert(!Drives<Screw<Gcrf, Body>, V<Gcrf, Body, Body, Gcrf>> &&
              !Drives<Screw<Gcrf, Body>, V<Body, Gcrf, Body, Body>> &&
              !Drives<Screw<Gcrf, Body>, AngularVelocity<Gcrf, Body, In<Body>>>);

}  // namespace
}  // namespace twist_rate_test
