// The rotation vector's rate and second rate, against the derivatives of the rotation alone.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motions.hpp"
#include "rigid_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace {

using Eigen::Vector3d;
using Theta = Eigen::Matrix<Dual2, 3, 1>;

/// A rotation vector in motion, and the motion of its exponential by automatic differentiation.
struct Sample {
  RotationVector<Gcrf, Body> theta;
  RotationVectorRate<Gcrf, Body> rate;
  RotationVectorAcceleration<Gcrf, Body> second;
  Motion<Gcrf, Body> motion;

  explicit Sample(const Theta& moving)
      : theta(turn_of(moving.unaryExpr([](const Dual2& x) { return value(x); }))),
        rate(rotation_vector_rate(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(
                                      in<Body>, moving.unaryExpr([](const Dual2& x) { return first(x); })))),
        second(rotation_vector_acceleration(
            of<Body>, relative_to<Gcrf>,
            vector<si::angular_acceleration>(
                in<Gcrf>, moving.unaryExpr([](const Dual2& x) { return vectrix_test::second(x); })))),
        motion(exp(rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, moving)))) {}
};

/// theta = size n + t (...) + t^2 (...), at t = 0.
Theta moving(const Vector3d& theta, const Vector3d& rate, const Vector3d& half_second) {
  const Dual2 t = instant(0.0);
  Theta moving;
  for (Eigen::Index i = 0; i < 3; ++i) {
    moving(i) = constant(theta(i)) + t * constant(rate(i)) + t * t * constant(half_second(i));
  }
  return moving;
}

std::vector<Sample> samples() {
  std::mt19937_64 random(20260301);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto triple = [&] { return Vector3d(number(random), number(random), number(random)); };
  std::vector<Sample> list;
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-5, 0.00999, 0.01001, 0.3, 1.0, 2.0, 2.9999, 3.0001,
                             std::numbers::pi, 4.0, 5.5, 6.2, 7.0, 20.0}) {
    for (int i = 0; i < 20; ++i) {
      list.emplace_back(moving(angle * triple().normalized(), triple(), triple()));
    }
  }
  return list;
}

/// Rates of order 1, through a dozen products; automatic differentiation of exp has as many roundings.
constexpr double rate_tolerance = 1e-13;
/// 2 pi over the distance from a full turn, 0.08 rad at 6.2 rad, twice over in the second rate.
constexpr double inverse_tolerance = 1e-11;

TEST(RotationVectorRate, TheJacobiansMakeItTheAngularVelocity) {
  for (const auto& s : samples()) {
    const AngularVelocity<Gcrf, Body, In<Body>> w_b = angular_velocity(s.theta, s.rate, in<Body>);
    const AngularVelocity<Gcrf, Body, In<Gcrf>> w_a = angular_velocity(s.theta, s.rate, in<Gcrf>);
    EXPECT_LE(distance(w_b.coordinates(), s.motion.w_ab_b().coordinates()), rate_tolerance) << s.theta;
    EXPECT_LE(distance(w_a.coordinates(), s.motion.w_a()), rate_tolerance) << s.theta;
    EXPECT_LE(distance(w_b.coordinates(), right_jacobian(s.theta) * s.rate.coordinates()), rate_tolerance);
    EXPECT_LE(distance(w_a.coordinates(), left_jacobian(s.theta) * s.rate.coordinates()), rate_tolerance);
  }
}

TEST(RotationVectorRate, TheRateOfARotationVectorUndoesThem) {
  for (const auto& s : samples()) {
    const RotationVectorRate<Gcrf, Body> by_b = rate(s.theta, s.motion.w_ab_b());
    const RotationVectorRate<Gcrf, Body> by_a = rate(s.theta, s.motion.rotation() * s.motion.w_ab_b());
    EXPECT_LE(distance(by_b.coordinates(), s.rate.coordinates()), inverse_tolerance) << s.theta;
    EXPECT_LE(distance(by_a.coordinates(), s.rate.coordinates()), inverse_tolerance) << s.theta;
    EXPECT_LE(distance(by_b.coordinates(), inverse_right_jacobian(s.theta) * s.motion.w_ab_b().coordinates()),
              inverse_tolerance);
  }
}

// Bortz 1971: theta_dot = w + theta x w/2 + (1 - |theta|/2 cot |theta|/2) theta x (theta x w)/|theta|^2.
TEST(RotationVectorRate, IsBortzsEquation) {
  const Vector3d theta(0.7, -1.1, 0.4);
  const Vector3d w(0.3, 0.9, -0.6);
  const double half = theta.norm() / 2;
  const Vector3d bortz = w + theta.cross(w) / 2 +
                         (1 - half / std::tan(half)) / theta.squaredNorm() * theta.cross(theta.cross(w));
  const auto w_ab_b =
      angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w));
  EXPECT_LE(distance(rate(turn_of(theta), w_ab_b).coordinates(), bortz), rate_tolerance);
  // In the other frame the sign of the second term is the other one.
  const auto w_ab_a =
      angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Gcrf>, w));
  EXPECT_GT(distance(rate(turn_of(theta), w_ab_a).coordinates(), bortz), visible);
}

TEST(RotationVectorRate, TheAngularAccelerationIsItsDerivative) {
  for (const auto& s : samples()) {
    const AngularAcceleration<Gcrf, Body, In<Body>> alpha_b =
        angular_acceleration(s.theta, s.rate, s.second, in<Body>);
    const AngularAcceleration<Gcrf, Body, In<Gcrf>> alpha_a =
        angular_acceleration(s.theta, s.rate, s.second, in<Gcrf>);
    EXPECT_LE(distance(alpha_b.coordinates(), s.motion.alpha_ab_b().coordinates()), rate_tolerance)
        << s.theta;
    EXPECT_LE(distance(alpha_a.coordinates(), s.motion.alpha_a()), rate_tolerance) << s.theta;
  }
}

TEST(RotationVectorRate, TheSecondRateUndoesIt) {
  for (const auto& s : samples()) {
    const RotationVectorAcceleration<Gcrf, Body> by_b =
        second_rate(s.theta, s.motion.w_ab_b(), s.motion.alpha_ab_b());
    const auto R_a_from_b = s.motion.rotation();
    const auto by_a =
        second_rate(s.theta, R_a_from_b * s.motion.w_ab_b(), R_a_from_b * s.motion.alpha_ab_b());
    EXPECT_LE(distance(by_b.coordinates(), s.second.coordinates()), inverse_tolerance) << s.theta;
    EXPECT_LE(distance(by_a.coordinates(), s.second.coordinates()), inverse_tolerance) << s.theta;
  }
}

// theta_ba = -theta_ab, and so its rates; w_ba = -w_ab.
TEST(RotationVectorRate, Reverses) {
  for (const auto& s : samples()) {
    const RotationVectorRate<Body, Gcrf> back = -s.rate;
    EXPECT_LE(distance(angular_velocity(-s.theta, back, in<Body>).coordinates(),
                       -angular_velocity(s.theta, s.rate, in<Body>).coordinates()),
              rate_tolerance);
    const RotationVectorAcceleration<Body, Gcrf> second_back = -s.second;
    EXPECT_LE(distance(angular_acceleration(-s.theta, back, second_back, in<Gcrf>).coordinates(),
                       -angular_acceleration(s.theta, s.rate, s.second, in<Gcrf>).coordinates()),
              rate_tolerance);
  }
}

TEST(RotationVectorRate, AtAFullTurnIsBadInput) {
  const auto theta = turn_of({0, 0, 2 * std::numbers::pi});
  const auto w = angular_velocity(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Body>, Vector3d(1, 0, 0)));
  const auto alpha = unaccelerated(of<Body>, relative_to<Gcrf>, in<Body>);
  EXPECT_TRUE(contains(message<BadInput>([&] { rate(theta, w); }), "rate(rotation vector of "));
  EXPECT_TRUE(contains(message<BadInput>([&] { second_rate(theta, w, alpha); }), " of a full turn"));
}

TEST(RotationVectorRate, PrintsWhatItIs) {
  std::ostringstream out;
  out << rotation_vector_rate(of<Body>, relative_to<Gcrf>,
                              vector<si::angular_velocity>(in<Body>, Vector3d(1, 2, 3)));
  EXPECT_EQ(out.str(),
            "d/dt (1, 2, 3) rad/s of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>());
}

template <class T, class W>
concept Drives = requires(const T& theta, const W& w) {
  rate(theta, w);
};
template <class T, class R, class C>
concept Turns = requires(const T& theta, const R& theta_dot) {
  angular_velocity(theta, theta_dot, in<C>);
};
template <class A, class B, class C> using W = AngularVelocity<A, B, In<C>>;
using Turned = RotationVector<Gcrf, Body>;
static_assert(Drives<Turned, W<Gcrf, Body, Body>> && Drives<Turned, W<Gcrf, Body, Gcrf>>);
static_assert(!Drives<Turned, W<Gcrf, Body, Camera>> && !Drives<Turned, W<Body, Gcrf, Body>> &&
              !Drives<Turned, W<Gcrf, Camera, Gcrf>>);
static_assert(Turns<Turned, RotationVectorRate<Gcrf, Body>, Body> &&
              Turns<Turned, RotationVectorRate<Gcrf, Body>, Gcrf>);
static_assert(!Turns<Turned, RotationVectorRate<Gcrf, Body>, Camera> &&
              !Turns<Turned, RotationVectorRate<Body, Gcrf>, Body> &&
              !Turns<Turned, W<Gcrf, Body, Body>, Body>);
static_assert(!Drives<Dcm<Gcrf, Body>, RotationVectorRate<Gcrf, Body>>);
static_assert(!std::is_convertible_v<RotationVectorRate<Gcrf, Body>, W<Gcrf, Body, Body>>);

}  // namespace
