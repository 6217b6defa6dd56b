#include <gtest/gtest.h>

#include <vectrix/kinematics/estimation/estimate_motion.hpp>

#include "observed_attitudes.hpp"
#include "testing/trials.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace estimate_motion_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Samples = std::vector<AttitudeSample<Gcrf, Body>>;

constexpr int draws = trials(4000);
/// A normal matrix with a condition number of about 1e4.
constexpr double fitted = 1e6 * epsilon;

Quantity<si::time> seconds(double t) {
  return t * si::second;
}
Quaterniond turn(const Vector3d& theta) {
  return exp_quaternion(rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Body>, theta)))
      .eigen();
}
AttitudeSample<Gcrf, Body> sample(double t, const Quaterniond& q) {
  return {seconds(t),
          nearest_quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z()).quaternion};
}

/// q0 exp(w t + alpha t^2 / 2): at t = 0 its rate is w and its acceleration alpha.
struct Truth {
  Quaterniond q0 = turn({0.4, -1.3, 2.0});
  Vector3d w{0.9, -1.5, 1.0};
  Vector3d alpha{-0.4, 0.3, 0.6};
  Quaterniond at(double t) const { return q0 * turn(w * t + alpha * t * t / 2); }
  /// Samples a tenth of a second apart around t = 0, more of them after it than before, each with an error in
  /// b.
  Samples samples(Noise& noise, double sigma) const {
    Samples list;
    for (int i = -6; i <= 8; ++i) list.push_back(sample(0.1 * i, at(0.1 * i) * turn(noise.column(sigma))));
    return list;
  }
};

double square(const auto& P, const auto& error) {
  return std::pow(mahalanobis_distance(P, error).value(), 2);
}

TEST(EstimateMotion, OfExactSamplesIsExact) {
  const Truth truth;
  Noise noise(1);
  const auto found = estimate_motion(truth.samples(noise, 0.0), seconds(0), seconds(0.85), rad(1e-3));
  EXPECT_LE(distance(found.motion.rotation.matrix(), truth.q0.toRotationMatrix()), fitted);
  EXPECT_LE(distance(found.motion.angular_velocity.coordinates(), truth.w), fitted);
  EXPECT_LE(distance(found.motion.angular_acceleration.coordinates(), truth.alpha), 10 * fitted);
  EXPECT_LE(found.loss, fitted);
  EXPECT_EQ(found.freedom, 3U * (15 - 4));
}

// A constant rate, requested at an instant other than the middle sample.
TEST(EstimateMotion, OfAConstantRate) {
  const Vector3d w(0.0, 0.3, -0.4);
  Samples list;
  for (int i = 0; i < 12; ++i) list.push_back(sample(10 + 0.5 * i, turn(w * (0.5 * i))));
  const auto found = estimate_motion<2>(list, seconds(11.8), seconds(1.6), rad(1e-3)).motion;
  EXPECT_LE(distance(found.rotation.matrix(), turn(1.8 * w).toRotationMatrix()), fitted);
  EXPECT_LE(distance(found.angular_velocity.coordinates(), w), fitted);
  EXPECT_LE(found.angular_acceleration.coordinates().norm(), fitted);
}

// For a body at rest it is the regression of three angles: the variance of a slope is sigma^2 / sum t^2.
TEST(EstimateMotion, AtRestTheCovarianceIsThatOfARegression) {
  Samples list;
  for (int i = -2; i <= 2; ++i) list.push_back(sample(i, turn({1.0, 2.0, 0.5})));
  const auto found = estimate_motion<2>(list, seconds(0), seconds(2), rad(0.01));
  const auto expect = [](const auto& P, double variance) {
    EXPECT_LE(distance(P.matrix(), 1e-4 * variance * Matrix3d::Identity()), fitted * variance);
  };
  expect(found.rate_covariance, 1.0 / 10);
  expect(found.attitude_covariance, 34.0 / 70);         // sum t^4 / (n sum t^4 - (sum t^2)^2)
  expect(found.acceleration_covariance, 4 * 5.0 / 70);  // 4 n / (n sum t^4 - (sum t^2)^2)
}

// The errors of all three agree with their covariances, and so does the loss.
TEST(EstimateMotion, TheCovariancesAreThoseOfItsErrors) {
  const Truth truth;
  Noise noise(20240606);
  const double sigma = 1e-3;
  ChiSquare attitudes(3), rates(3), accelerations(3), losses(3 * (15 - 4));
  for (int i = 0; i < draws; ++i) {
    const auto found = estimate_motion(truth.samples(noise, sigma), seconds(0), seconds(0.85), rad(sigma));
    const Quaternion<Gcrf, Body> q = quaternion(found.motion.rotation);
    const Vector3d e = detail::turn_between(q, sample(0, truth.q0).q_a_from_b);
    attitudes.add(square(found.attitude_covariance, vector<si::angle>(in<Body>, e)));
    rates.add(square(found.rate_covariance, found.motion.angular_velocity.vector() -
                                                vector<si::angular_velocity>(in<Body>, truth.w)));
    accelerations.add(
        square(found.acceleration_covariance, found.motion.angular_acceleration.vector() -
                                                  vector<si::angular_acceleration>(in<Body>, truth.alpha)));
    losses.add(2 * found.loss);
  }
  EXPECT_TRUE(attitudes.agrees()) << attitudes.mean();
  EXPECT_TRUE(rates.agrees()) << rates.mean();
  EXPECT_TRUE(accelerations.agrees()) << accelerations.mean();
  EXPECT_TRUE(losses.agrees()) << losses.mean();
}

// The signs of the samples, and a constant change of a, have no effect; a constant change of b rotates rate
// and covariance.
TEST(EstimateMotion, AChangeOfEitherFrameTurnsTheEstimate) {
  const Truth truth;
  Noise noise(20240607);
  const auto list = truth.samples(noise, 1e-3);
  const Quaterniond p = turn({-0.3, 1.0, 0.6});
  const Matrix3d P = p.toRotationMatrix();
  Samples of_a, of_b;
  for (const auto& one : list) {
    of_a.push_back(sample(one.time.value(), Quaterniond(-(p * one.q_a_from_b.eigen()).coeffs())));
    of_b.push_back(sample(one.time.value(), one.q_a_from_b.eigen() * p));
  }
  const auto at = [](const Samples& samples) {
    return estimate_motion(samples, seconds(0.1), seconds(0.75), rad(1e-3));
  };
  const auto plain = at(list), a = at(of_a), b = at(of_b);
  const auto w = [](const auto& found) { return found.motion.angular_velocity.coordinates(); };
  EXPECT_LE(distance(w(a), w(plain)), fitted);
  EXPECT_LE(distance(a.motion.rotation.matrix(), P * plain.motion.rotation.matrix()), fitted);
  EXPECT_LE(distance(w(b), P.transpose() * w(plain)), fitted);
  EXPECT_LE(distance(b.rate_covariance.matrix(), P.transpose() * plain.rate_covariance.matrix() * P),
            fitted * plain.rate_covariance.matrix().norm());
}

TEST(EstimateMotion, WhatCannotBeEstimatedIsRefused) {
  Samples list;
  for (int i = 0; i <= 20; ++i) list.push_back(sample(i, turn({0.3 * i, 0.0, 0.0})));
  const auto said = [&](double t, double width, double sigma = 1e-3) {
    return message<BadInput>([&] { estimate_motion(list, seconds(t), seconds(width), rad(sigma)); });
  };
  const std::string place = detail::samples_place<Gcrf, Body>("estimate_motion") + ": ";
  EXPECT_EQ(said(10, 2), "");
  EXPECT_EQ(said(20.5, 2), place + "the time 20.5 s is outside the samples, [0 s, 20 s]");
  EXPECT_EQ(said(std::nan(""), 2), place + "the time nan s is outside the samples, [0 s, 20 s]");
  EXPECT_EQ(said(10, 1),
            place + "the number of samples within 1 s of 10 s is 3; a polynomial of degree 3 needs 4");
  EXPECT_EQ(said(10.5, 0.1),
            place + "the number of samples within 0.1 s of 10.5 s is 0; a polynomial of degree 3 needs 4");
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(said(10, bad), place + "the half width is " + detail::text(bad) + " s");
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-200})
    EXPECT_EQ(said(10, 2, bad), place + "the standard deviation is " + detail::text(bad) + " rad");
  EXPECT_TRUE(contains(said(10, 8), "from the middle of the window to its end b turns by 2.4"))
      << said(10, 8);
  const auto of = [](const Samples& samples) {
    return message<BadInput>([&] { estimate_motion(samples, seconds(1), seconds(2), rad(1e-3)); });
  };
  EXPECT_EQ(of({}), place + "the number of samples is 0, at least 4 are needed");
  EXPECT_EQ(of({list[0], list[1], list[1], list[2]}), place + "samples 1 and 2 have one time, 1 s");
  const Quaterniond q = Quaterniond::Identity();
  const auto clustered = of({sample(0, q), sample(1, q), sample(1 + 1e-7, q), sample(1 + 2e-7, q)});
  EXPECT_TRUE(contains(clustered, "do not fix a polynomial of degree 3: the share ")) << clustered;
}

template <int degree, class Sigma>
concept Estimates = requires(const Samples& samples, Quantity<si::time> t, const Sigma& sigma) {
  estimate_motion<degree>(samples, t, t, sigma);
};
static_assert(Estimates<2, Quantity<si::angle>>);
static_assert(!Estimates<1, Quantity<si::angle>>);  // this has no acceleration
static_assert(!Estimates<3, Quantity<si::angular_velocity>>);

}  // namespace
}  // namespace estimate_motion_test
