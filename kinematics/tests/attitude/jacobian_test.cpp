// The Jacobians of SO(3) and SE(3) in closed form, compared with power series in long double, which contain
// no closed form.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "screws/rigid_motions.hpp"
#include "testing/trials.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace jacobian_test {
namespace {

using std::numbers::pi;
using Six = Eigen::Matrix<double, 6, 1>;
using SixBySix = Eigen::Matrix<double, 6, 6>;

/// Entries of order 1: products of two cross matrices and a coefficient, which has two roundings.
constexpr double few = 4;
/// The inverse in closed form has one more quotient; its lower block has three products of matrices.
constexpr double inverse_few = 6;
constexpr double many = 24;

std::vector<double> all_angles() {
  auto angles = angles_to_a_half_turn();
  for (const double angle : angles_beyond()) angles.push_back(angle);
  return angles;
}

TEST(Jacobian, OfRotationsIsThePowerSeries) {
  for (const double angle : all_angles()) {
    for (const Six& xi : screws_of(angle, 1.0)) {
      const Eigen::Vector3d theta = xi.head<3>();
      const auto exact = power_series<3>(skew(extended(theta)), 1);
      EXPECT_LE(roundings(left_jacobian(turn_of(theta)), exact), few) << theta.transpose();
      EXPECT_LE(roundings(right_jacobian(turn_of(theta)), exact.transpose()), few) << theta.transpose();
    }
  }
}

// J_l is the mean of the rotations exp(s theta) along the way: their integral for s from 0 to 1.
TEST(Jacobian, OfManyTurnsIsTheMeanRotation) {
  for (const double angle : {1e2, 1e5, 1e8, 1e150}) {
    const auto J = left_jacobian(turn_of({0, 0, angle}));
    const long double t = angle;
    const long double s = std::sin(t) / t;
    const long double c = 2 * std::sin(t / 2) * std::sin(t / 2) / t;
    ExtendedMatrix<3> exact;
    exact << s, -c, 0, c, s, 0, 0, 0, 1;
    EXPECT_LE(distance(J, exact.cast<double>()), few * epsilon) << angle;
  }
}

TEST(Jacobian, ItsInverseIsAccurateToAHalfTurn) {
  for (const double angle : angles_to_a_half_turn()) {
    for (const Six& xi : screws_of(angle, 1.0)) {
      const Eigen::Vector3d theta = xi.head<3>();
      const ExtendedMatrix<3> exact = power_series<3>(skew(extended(theta)), 1).inverse();
      EXPECT_LE(roundings(inverse_left_jacobian(turn_of(theta)), exact), inverse_few) << theta.transpose();
      EXPECT_LE(roundings(inverse_right_jacobian(turn_of(theta)), exact.transpose()), inverse_few)
          << theta.transpose();
    }
  }
}

// Beyond that, the error is the rounding of |theta| divided by the distance from the full turn.
TEST(Jacobian, ItsInverseLosesWhatTheDistanceFromAFullTurnLoses) {
  for (double distance_left = 1.0; distance_left > 1e-13; distance_left /= 10) {
    for (const double angle : {2 * pi - distance_left, 2 * pi + distance_left, 4 * pi - distance_left}) {
      const Eigen::Vector3d theta = angle * Eigen::Vector3d(-1, 2, 2) / 3;
      const ExtendedMatrix<3> K = skew(extended(theta));
      const long double t = extended(theta).norm();
      const ExtendedMatrix<3> exact =
          ExtendedMatrix<3>::Identity() - K / 2 + (1 - t / 2 / std::tan(t / 2)) / (t * t) * K * K;
      const double lost = 1 + angle / distance_left;
      EXPECT_LE(roundings(inverse_left_jacobian(turn_of(theta)), exact), inverse_few * lost) << angle;
    }
  }
}

TEST(Jacobian, OfAFullTurnHasNoInverse) {
  for (const double turns : {1.0, 2.0, 3.0}) {
    const Eigen::Vector3d theta(0, 2 * pi * turns, 0);
    const auto text = message<BadInput>([&] { inverse_left_jacobian(turn_of(theta)); });
    EXPECT_TRUE(contains(text, "inverse_left_jacobian(rotation vector of ")) << text;
    EXPECT_TRUE(contains(text, " rad from the singularity, a full turn")) << text;
    EXPECT_NE(message<BadInput>([&] { inverse_right_jacobian(turn_of(theta)); }), "");
    Six xi;
    xi << theta, 1, 2, 3;
    EXPECT_TRUE(contains(message<BadInput>([&] { inverse_left_jacobian(screw_of(xi)); }),
                         "inverse_left_jacobian(screw of "));
    EXPECT_NE(message<BadInput>([&] { inverse_right_jacobian(screw_of(xi)); }), "");
  }
  const auto how_near = message<BadInput>([] { inverse_left_jacobian(turn_of({0, 0, 2 * pi})); });
  EXPECT_TRUE(contains(how_near, "Gcrf): 2.44929359829470")) << how_near;
  EXPECT_TRUE(contains(how_near, "e-16 rad from the singularity, a full turn")) << how_near;
}

TEST(Jacobian, OfAnOverflowingAngleIsBadInput) {
  EXPECT_TRUE(contains(message<BadInput>([] { left_jacobian(turn_of({1e200, 0, 0})); }), "|theta|^2 is inf"));
  EXPECT_TRUE(contains(message<BadInput>([] {
                         inverse_right_jacobian(turn_of({1e200, 0, 0}));
                       }),
                       "|theta|^2 is inf"));
}

TEST(Jacobian, OfScrewsIsThePowerSeriesOfTheBracket) {
  for (const double angle : tried(all_angles())) {
    for (const double size : {1.0, 1e9}) {
      for (const Six& xi : screws_of(angle, size)) {
        const auto exact = power_series<6>(bracket(extended(xi)), 1);
        const SixBySix left = left_jacobian(screw_of(xi));
        EXPECT_LE(roundings(left.topLeftCorner<3, 3>(), exact.topLeftCorner<3, 3>()), few);
        EXPECT_EQ((left.topRightCorner<3, 3>()), Eigen::Matrix3d::Zero());
        EXPECT_EQ((left.bottomRightCorner<3, 3>()), (left.topLeftCorner<3, 3>()));
        const double rho = xi.tail<3>().norm();
        const double error = static_cast<double>((extended(left) - exact)
                                                     .bottomLeftCorner<3, 3>()
                                                     .cwiseAbs()
                                                     .template maxCoeff<Eigen::PropagateNaN>());
        EXPECT_LE(error, few * epsilon * rho) << xi.transpose();
        const auto other = power_series<6>(bracket(extended(Six(-xi))), 1);
        const double other_error = static_cast<double>((extended(right_jacobian(screw_of(xi))) - other)
                                                           .bottomLeftCorner<3, 3>()
                                                           .cwiseAbs()
                                                           .template maxCoeff<Eigen::PropagateNaN>());
        EXPECT_LE(other_error, few * epsilon * rho) << xi.transpose();
      }
    }
  }
}

// The integral of exp(s A), s from 0 to 1: for 2A it is half that of A plus half of exp(A) times that of A.
ExtendedMatrix<6> doubled_power_series(const ExtendedMatrix<6>& A, int doublings) {
  const ExtendedMatrix<6> part = A / std::ldexp(1.0L, doublings);
  ExtendedMatrix<6> exponential = power_series<6>(part, 0);
  ExtendedMatrix<6> integral = power_series<6>(part, 1);
  for (int i = 0; i < doublings; ++i) {
    integral = ((integral + exponential * integral) / 2).eval();
    exponential = (exponential * exponential).eval();
  }
  return integral;
}

// Its lower block contains derivatives of coefficients, in which terms of order |theta|^2 cancel.
TEST(Jacobian, OfScrewsKeepsItsDigitsOverManyTurns) {
  for (const double angle : {6.0, 20.0, 85.0, 1000.0}) {
    for (const Six& xi : screws_of(angle, 1.0)) {
      const auto exact = doubled_power_series(bracket(extended(xi)), 10);
      const double error = static_cast<double>((extended(left_jacobian(screw_of(xi))) - exact)
                                                   .bottomLeftCorner<3, 3>()
                                                   .cwiseAbs()
                                                   .template maxCoeff<Eigen::PropagateNaN>());
      EXPECT_LE(error, few * epsilon * xi.tail<3>().norm()) << xi.transpose();
    }
  }
}

TEST(Jacobian, TheInverseOfThatOfScrewsIsAccurateToAHalfTurn) {
  const ExtendedMatrix<6> one = ExtendedMatrix<6>::Identity();
  for (const double angle : tried(angles_to_a_half_turn())) {
    for (const Six& xi : screws_of(angle, 1.0)) {
      const auto left = power_series<6>(bracket(extended(xi)), 1);
      EXPECT_LE(roundings(extended(inverse_left_jacobian(screw_of(xi))) * left, one), many) << xi.transpose();
      const auto right = power_series<6>(bracket(extended(Six(-xi))), 1);
      EXPECT_LE(roundings(extended(inverse_right_jacobian(screw_of(xi))) * right, one), many)
          << xi.transpose();
    }
  }
}

Six any_six() {
  Six xi;
  xi << 2 * *triple(), 3 * *triple();
  return xi;
}
/// Products of matrices of order 10.
constexpr double tolerance = 1e-13;

// J_l(theta) = R J_r(theta), J_l(xi) = Ad(exp(xi)) J_r(xi).
RC_GTEST_PROP(Jacobian, TheLeftOneIsTheRightOneTurned, ()) {
  const Six xi = any_six();
  const auto theta_ab = turn_of(xi.head<3>());
  RC_ASSERT(distance(left_jacobian(theta_ab), exp(theta_ab).matrix() * right_jacobian(theta_ab)) <=
            tolerance);
  const auto xi_ab = screw_of(xi);
  RC_ASSERT(distance(left_jacobian(xi_ab), adjoint(exp(xi_ab)) * right_jacobian(xi_ab)) <= tolerance);
}

// exp(ad(xi)) = Ad(exp(xi)); J_l(xi) ad(xi) = Ad(exp(xi)) - I.
RC_GTEST_PROP(Bracket, ItsExponentialIsTheAdjoint, ()) {
  const auto xi_ab = screw_of(any_six());
  const SixBySix Ad = adjoint(exp(xi_ab));
  RC_ASSERT(distance(power_series<6>(extended(ad(xi_ab)), 0).cast<double>(), Ad) <= tolerance);
  RC_ASSERT(distance(left_jacobian(xi_ab) * ad(xi_ab), Ad - SixBySix::Identity()) <= tolerance);
}

// ad(Ad(X) V) = Ad(X) ad(V) Ad(X)^-1; ad(V) W = -ad(W) V; Jacobi's identity.
RC_GTEST_PROP(Bracket, IsCarriedByTheAdjointAndIsALieBracket, ()) {
  const auto V = twist_with<Gcrf, Wheel<1>, Body, Body>(any_six());
  const auto W = twist_with<Gcrf, Camera, Body, Body>(any_six());
  const Transform<Camera, Body> X{
      trust_dcm(to<Camera>, from<Body>, *rotation_matrix()),
      displacement(of<Body>, relative_to<Camera>, vector<si::length>(in<Camera>, *triple()))};
  RC_ASSERT(distance(ad(X * V), adjoint(X) * ad(V) * adjoint(inverse(X))) <= tolerance);
  RC_ASSERT(distance(ad(V) * W.coordinates(), -ad(W) * V.coordinates()) <= tolerance);
  RC_ASSERT((ad(V) * V.coordinates()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>() <= tolerance);
  const Six VW = ad(V) * W.coordinates();
  const auto bracket_VW = ad(twist_with<Gcrf, Wheel<1>, Body, Body>(VW));
  RC_ASSERT(distance(bracket_VW, ad(V) * ad(W) - ad(W) * ad(V)) <= tolerance);
}

}  // namespace
}  // namespace jacobian_test
