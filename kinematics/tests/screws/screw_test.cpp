// Screw motions: exp and log of SE(3) compared with power series in long double, constant twists, the axis.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rigid_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace screw_test {
namespace {

using std::numbers::pi;
using Six = Eigen::Matrix<double, 6, 1>;

/// Of the translation, relative to rho: as for the Jacobian from which it is computed.
constexpr double few_ulps = 4 * epsilon;
/// rho of log(exp()): theta goes through nine numbers, with an error of 16 ulps of half a turn.
constexpr double ulps_by_dcm = 32 * epsilon;

/// x|, also where its square overflows or underflows a double.
template <class Derived> double length(const Eigen::MatrixBase<Derived>& x) {
  return static_cast<double>(extended(x).norm());
}
double error(const Eigen::Vector3d& found, const ExtendedColumn<3>& exact) {
  return static_cast<double>((extended(found) - exact).norm());
}

TEST(Screw, ExpIsAccurateToRoundingForEveryAngleAndSize) {
  auto angles = angles_to_a_half_turn();
  for (const double angle : angles_beyond()) angles.push_back(angle);
  for (const double angle : angles) {
    for (const double size : {1.0, 1e-300, 1e300}) {
      for (const Six& xi : screws_of(angle, size)) {
        const ExtendedColumn<3> r = power_series<3>(skew(extended(xi.head<3>())), 1) * extended(xi.tail<3>());
        const auto X = exp(screw_of(xi));
        EXPECT_LE(error(X.translation.coordinates(), r), few_ulps * length(xi.tail<3>())) << xi.transpose();
        EXPECT_EQ(X.rotation.matrix(), exp(turn_of(xi.head<3>())).matrix());
      }
    }
  }
}

// A screw about the third axis, with any number of turns.
TEST(Screw, ExpOfManyTurnsClosesTheCircle) {
  for (const double angle : {1e2, 1e5, 1e8, 1e15}) {
    Six xi;
    xi << 0, 0, angle, 3, -4, 5;
    const long double t = angle;
    const long double s = std::sin(t) / t;
    const long double c = 2 * std::sin(t / 2) * std::sin(t / 2) / t;
    const ExtendedColumn<3> r(3 * s + 4 * c, 3 * c - 4 * s, 5);
    EXPECT_LE(error(exp(screw_of(xi)).translation.coordinates(), r), few_ulps * 8) << angle;
  }
}

TEST(Screw, OfNoTurnIsATranslationToTheBit) {
  for (const double size : {1e-300, 1.0, 1e308}) {
    Six xi;
    xi << 0, 0, 0, size, -0.3 * size, 0.7 * size;
    const auto X = exp(screw_of(xi));
    EXPECT_EQ(X.rotation.matrix(), Eigen::Matrix3d::Identity());
    EXPECT_EQ(X.translation.coordinates(), xi.tail<3>());
    EXPECT_EQ(log(X).coordinates(), xi);
  }
}

TEST(Screw, LogIsAccurateToRoundingForEveryAngleAndSize) {
  for (const double angle : angles_to_a_half_turn()) {
    for (const double size : {1.0, 1e-300, 1e300}) {
      for (const Six& xi : screws_of(angle, size)) {
        const auto X = exp(screw_of(xi));
        const auto found = log(X);
        // For the theta that the nine numbers contain, rho is known to rounding.
        const Eigen::Vector3d theta = found.rotation_vector().coordinates();
        EXPECT_EQ(theta, log(X.rotation).coordinates());
        const Eigen::Vector3d rho = found.coordinates().tail<3>();
        const ExtendedColumn<3> r = power_series<3>(skew(extended(theta)), 1) * extended(rho);
        EXPECT_LE(error(X.translation.coordinates(), r), few_ulps * length(rho)) << xi.transpose();
        // Within rounding of pi, nine numbers cannot distinguish +n from -n, and rho depends on n.
        if (angle > pi - 1e-14) continue;
        EXPECT_LE(length(rho - xi.tail<3>()), ulps_by_dcm * length(xi.tail<3>())) << xi.transpose();
        EXPECT_LE(length(theta - xi.head<3>()), ulps_by_dcm * length(xi.head<3>())) << xi.transpose();
      }
    }
  }
}

TEST(Screw, WhatOverflowsIsBadInput) {
  Six xi;
  xi << 1e200, 0, 0, 1, 2, 3;
  const auto text = message<BadInput>([&] { exp(screw_of(xi)); });
  EXPECT_TRUE(contains(text, "exp(screw of ") && contains(text, "|theta|^2 is inf")) << text;
  xi << 0, 0, 3, 1.7e308, 1.7e308, 1.7e308;
  const auto far = message<BadInput>([&] { exp(screw_of(xi)); });
  EXPECT_TRUE(contains(far, "relative to ") && contains(far, ") is not finite")) << far;
  xi << 1e300, 0, 0, 1, 0, 0;
  const auto V = twist_with<Gcrf, Body, Body, Body>(xi);
  EXPECT_TRUE(contains(message<BadInput>([&] { held(V, 1e10 * si::second); }), "held(screw of "));
  EXPECT_NE(message<BadInput>([&] { held(V, std::nan("") * si::second); }), "");
}

Six any_six() {
  Six xi;
  xi << 2 * *triple(), 3 * *triple();
  return xi;
}
template <class B, class A> Transform<B, A> any_transform() {
  return {trust_dcm(to<B>, from<A>, *rotation_matrix()),
          displacement(of<A>, relative_to<B>, vector<si::length>(in<B>, *triple()))};
}
/// Products of homogeneous matrices of order 10.
constexpr double tolerance = 1e-13;
template <class B, class A> Eigen::Matrix4d four(const Transform<B, A>& X) {
  return homogeneous_matrix(X);
}

RC_GTEST_PROP(Screw, ExpIsTheExponentialOfItsMatrix, ()) {
  const Six xi = any_six();
  RC_ASSERT(distance(four(exp(screw_of(xi))),
                     power_series<4>(four_by_four(extended(xi)), 0).cast<double>()) <= tolerance);
}

// exp(-xi) = exp(xi)^-1; Ad(exp(xi)) xi = xi.
RC_GTEST_PROP(Screw, ReversesAndKeepsItself, ()) {
  const Six xi = any_six();
  const Screw<Body, Gcrf> xi_ba = -screw_of(xi);
  RC_ASSERT(distance(four(exp(xi_ba)), four(inverse(exp(screw_of(xi))))) <= tolerance);
  RC_ASSERT(distance(adjoint(exp(screw_of(xi))) * xi, xi) <= tolerance);
}

RC_GTEST_PROP(Screw, ExpUndoesLog, ()) {
  const auto X = any_transform<Gcrf, Body>();
  const Screw<Gcrf, Body> xi_ab = log(X);
  RC_ASSERT(distance(four(exp(xi_ab)), four(X)) <= tolerance);
}

// exp(Ad(X) xi) = X exp(xi) X^-1: the same motion of two frames that are fixed to a and b in the same way.
RC_GTEST_PROP(Screw, OfAnotherFrameIsCarriedByTheAdjoint, ()) {
  const Six xi = any_six();
  const auto X_ca = any_transform<Camera, Gcrf>();
  const Eigen::Matrix4d same = four(X_ca) * four(exp(screw_of(xi))) * four(inverse(X_ca));
  RC_ASSERT(distance(four(exp(screw_of(adjoint(X_ca) * xi))), same) <= 10 * tolerance);
}

// X exp(V_b t) = exp(V_a t) X, and in between X_a_from_b moves with the constant twist.
RC_GTEST_PROP(HeldTwist, BodyAndReferenceFormAreOneMotion, ()) {
  const auto X = any_transform<Gcrf, Body>();
  const auto V_b = twist_with<Gcrf, Body, Body, Body>(any_six());
  const Twist<Gcrf, Body, At<Gcrf>, In<Gcrf>> V_a = X * V_b;
  const double t = *coordinate();
  const Transform<Gcrf, Body> later = moved(X, V_b, t * si::second);
  RC_ASSERT(distance(four(later), four(moved(X, V_a, t * si::second))) <= 10 * tolerance);
  RC_ASSERT(
      distance(
          four(later),
          four(X) * power_series<4>(four_by_four(extended(Six(t * V_b.coordinates()))), 0).cast<double>()) <=
      10 * tolerance);
  // The twist is constant: the twists at the end equal those at the start.
  RC_ASSERT(distance((later * V_b).coordinates(), V_a.coordinates()) <= 100 * tolerance);
  RC_ASSERT(distance(four(moved(later, V_b, -t * si::second)), four(X)) <= 10 * tolerance);
}

// If a and b coincide at the start, the body form and the reference form give the same screw.
RC_GTEST_PROP(HeldTwist, FromOneFrameBothFormsAreOneScrew, ()) {
  const Six V = any_six();
  const auto t = 0.7 * si::second;
  const Screw<Gcrf, Body> body = held(twist_with<Gcrf, Body, Body, Body>(V), t);
  const Screw<Gcrf, Body> reference = held(twist_with<Gcrf, Body, Gcrf, Gcrf>(V), t);
  RC_ASSERT(body.coordinates() == reference.coordinates());
  RC_ASSERT(distance(body.coordinates(), 0.7 * V) <= tolerance);
}

// A wheel of radius 0.5 m rolls along x at 3 m/s; its contact point is at rest at a's origin. A constant
// twist is not rolling: the contact point remains at rest, like a hinge.
TEST(HeldTwist, OfARollingWheelAtItsContactTipsIt) {
  const auto X = Transform{
      aligned(to<Gcrf>, from<Body>),
      displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(0, 0, 0.5)))};
  const auto rolling =
      twist(at<Gcrf>,
            angular_velocity(of<Body>, relative_to<Gcrf>,
                             vector<si::angular_velocity>(in<Gcrf>, Eigen::Vector3d(0, 6, 0))),
            vector<si::velocity>(in<Gcrf>, Eigen::Vector3d::Zero()));
  const auto tipped = moved(X, rolling, pi / 12 * si::second);
  EXPECT_LE(distance(tipped.translation.coordinates(), Eigen::Vector3d(0.5, 0, 0)), rounding);
}

TEST(ScrewAxis, IsALineWithATurnAndAnAdvance) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, -2, 2) / 3;
  const Eigen::Vector3d p(0.4, 0.1, -0.1);
  const ScrewAxis<Gcrf> axis{vector<si::dimensionless>(in<Gcrf>, n), vector<si::length>(in<Gcrf>, p),
                             1.1 * si::radian, 0.3 * si::metre};
  const auto xi_ab = screw_along(of<Body>, relative_to<Gcrf>, axis);
  // A point of the axis moves along it.
  const auto X = exp(xi_ab);
  EXPECT_LE(distance(X.rotation.matrix() * p + X.translation.coordinates(), p + 0.3 * n), rounding);
  EXPECT_LE(distance(X.rotation.matrix(), Eigen::AngleAxisd(1.1, n).toRotationMatrix()), rounding);
  const ScrewAxis<Gcrf> found = screw_axis(log(X));
  EXPECT_LE(distance(found.direction.coordinates(), n), rounding);
  EXPECT_LE(distance(found.place.coordinates(), p - n.dot(p) * n), rounding);
  EXPECT_NEAR(found.angle.value(), 1.1, rounding);
  EXPECT_NEAR(found.advance.value(), 0.3, rounding);
}

RC_GTEST_PROP(ScrewAxis, IsThatOfItsScrew, ()) {
  const auto xi_ab = screw_of(any_six());
  RC_PRE(xi_ab.rotation_vector().angle().value() > 1e-3);
  const auto again = screw_along(of<Body>, relative_to<Gcrf>, screw_axis(xi_ab));
  RC_ASSERT(distance(again.coordinates(), xi_ab.coordinates()) <= tolerance);
}

TEST(ScrewAxis, ATranslationHasNone) {
  Six xi;
  xi << 0, 0, 0, 1, 2, 3;
  EXPECT_TRUE(contains(message<BadInput>([&] { screw_axis(screw_of(xi)); }),
                       "|theta| is 0; a translation has no axis"));
  const ScrewAxis<Gcrf> long_one{vector<si::dimensionless>(in<Gcrf>, Eigen::Vector3d(1, 1, 0)),
                                 zero<si::length>(in<Gcrf>), 1.0 * si::radian, 0.0 * si::metre};
  EXPECT_TRUE(contains(message<BadInput>([&] { screw_along(of<Body>, relative_to<Gcrf>, long_one); }),
                       "the norm of its direction differs from 1 by 0.41"));
}

TEST(ScrewAxis, ItsDirectionIsOneToTheTolerance) {
  const auto said = [](double length) {
    const ScrewAxis<Gcrf> axis{length * unit_x(in<Gcrf>), zero<si::length>(in<Gcrf>), 1.0 * si::radian,
                               0.0 * si::metre};
    return message<BadInput>([&] { screw_along(of<Body>, relative_to<Gcrf>, axis); });
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(said(1.0 + sign * 0.999 * unit_norm_tolerance), "");
    EXPECT_NE(said(1.0 + sign * 1.001 * unit_norm_tolerance), "");
  }
}

TEST(Screw, PrintsWhatItIs) {
  Six xi;
  xi << 0, 0, 1, 2, 0, 0;
  std::ostringstream out;
  out << screw_of(xi);
  EXPECT_EQ(out.str(),
            "(0, 0, 1) rad; (2, 0, 0) m of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>());
}

template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class X, class V>
concept Moves = requires(const X& transform, const V& motion, Quantity<si::time> t) {
  moved(transform, motion, t);
};
template <class V>
concept Holds = requires(const V& motion, Quantity<si::time> t) {
  held(motion, t);
};
template <class T>
concept Exponential = requires(const T& value) {
  exp(value);
};
template <class A, class B, class P, class C> using V = Twist<A, B, At<P>, In<C>>;
static_assert(!Multiplies<Screw<Gcrf, Body>, Screw<Body, Camera>> &&
              !Adds<Screw<Gcrf, Body>, Screw<Body, Camera>> && !Adds<Screw<Gcrf, Body>, Screw<Gcrf, Body>>);
static_assert(!Multiplies<Transform<Gcrf, Body>, Screw<Body, Camera>>);
static_assert(Exponential<Screw<Gcrf, Body>> && Exponential<RotationVector<Gcrf, Body>> &&
              !Exponential<V<Gcrf, Body, Body, Body>> && !Exponential<Vector<Body, si::angle>>);
static_assert(Moves<Transform<Gcrf, Body>, V<Gcrf, Body, Body, Body>> &&
              Moves<Transform<Gcrf, Body>, V<Gcrf, Body, Gcrf, Gcrf>>);
static_assert(!Moves<Transform<Gcrf, Body>, V<Gcrf, Body, Body, Gcrf>> &&
              !Moves<Transform<Gcrf, Body>, V<Gcrf, Body, Gcrf, Body>> &&
              !Moves<Transform<Gcrf, Body>, V<Gcrf, Body, Camera, Camera>> &&
              !Moves<Transform<Gcrf, Body>, V<Body, Gcrf, Body, Body>> &&
              !Moves<Transform<Gcrf, Body>, V<Gcrf, Camera, Camera, Camera>>);

}  // namespace
}  // namespace screw_test
