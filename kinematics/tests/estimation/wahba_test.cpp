#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "observed_attitudes.hpp"
#include "testing/trials.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace wahba_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Observations = std::vector<Observation<Body, Gcrf>>;

constexpr int draws = trials(4000);

// Three perpendicular directions, one error: P = sigma^2/2 I. For any axis, 2/3 of the weight is sensitive to
// a turn about it.
TEST(Wahba, ThreeOrthogonalObservations) {
  const auto R = body_from_gcrf(Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
  const auto found =
      wahba(to<Body>, from<Gcrf>,
            std::vector{seen(R, Vector3d::UnitX()), seen(R, Vector3d::UnitY()), seen(R, Vector3d::UnitZ())});
  EXPECT_LE(distance(found.rotation.matrix(), R.matrix()), rounding);
  EXPECT_LE(distance(found.covariance.matrix(), 5e-5 * Matrix3d::Identity()), 1e-4 * rounding);
  EXPECT_NEAR(found.observability, 2.0 / 3.0, rounding);
  EXPECT_LE(found.loss, rounding * rounding / 1e-4);
}

// Two perpendicular directions. A turn about one of them is seen by the other alone, a turn about the third
// axis by both.
TEST(Wahba, TwoOrthogonalObservations) {
  const auto found = wahba(to<Body>, from<Gcrf>,
                           std::vector{observation(unit_x(in<Body>), unit_y(in<Gcrf>), rad(0.01)),
                                       observation(unit_y(in<Body>), -unit_x(in<Gcrf>), rad(0.03))});
  const Vector3d variances(9e-4, 1e-4, 1e-4 / (1 + 1.0 / 9));
  EXPECT_LE(distance(found.covariance.matrix(), Matrix3d(variances.asDiagonal())), 1e-3 * rounding);
  EXPECT_NEAR(found.observability, 0.1, rounding);
  EXPECT_NEAR(std::abs(found.least_observed.x().value()), 1.0, rounding);
}

// Two observations with the same error are fitted alike: each has half of the mismatch.
TEST(Wahba, TwoObservationsShareTheirMismatch) {
  const double angle = 1.0, wider = 1.002;
  const auto in_plane = [](double a) { return Vector3d(std::cos(a), std::sin(a), 0); };
  const auto found =
      wahba(to<Body>, from<Gcrf>,
            std::vector{weighted_observation(unit_x(in<Body>), unit_x(in<Gcrf>), 2.0),
                        weighted_observation(measured(in_plane(wider)), reference(in_plane(angle)), 2.0)});
  EXPECT_LE(distance(found.rotation.matrix().col(0), in_plane((wider - angle) / 2)), rounding);
  EXPECT_NEAR(found.loss, 2 * 2.0 * (1 - std::cos((wider - angle) / 2)), rounding);
}

// wahba(Q b, a) = Q wahba(b, a) and wahba(b, Q^T a) = wahba(b, a) Q; the order of observations has no effect.
RC_GTEST_PROP(Wahba, AChangeOfEitherFrameTurnsTheAnswer, ()) {
  const Matrix3d Q = *rotation_matrix();
  Matrix3d reference_columns = *rotation_matrix();
  Matrix3d measured_columns = *rotation_matrix() * reference_columns;
  for (int i = 0; i < 3; ++i) {  // errors of up to 0.3 rad: still observable
    reference_columns.col(i) += 0.3 / std::sqrt(3.0) * *triple();
    measured_columns.col(i) += 0.3 / std::sqrt(3.0) * *triple();
  }
  const auto solve = [&](const Matrix3d& of_b, const Matrix3d& of_a, bool reversed) {
    Observations list;
    for (int i = 0; i < 3; ++i) {
      list.push_back(observation(measured(of_b * measured_columns.col(i)),
                                 reference(of_a * reference_columns.col(i)), rad(0.1 + 0.1 * i)));
    }
    list.back() = observation(list.back().measured(), list.back().reference(), rad(0.3), 20.0);
    if (reversed) std::reverse(list.begin(), list.end());
    return wahba(to<Body>, from<Gcrf>, list);
  };
  const Matrix3d I = Matrix3d::Identity();
  const auto plain = solve(I, I, false);
  const auto turned = solve(Q, I, true);
  RC_ASSERT(distance(turned.rotation.matrix(), Q * plain.rotation.matrix()) <= solved);
  RC_ASSERT(distance(turned.covariance.matrix(), Q * plain.covariance.matrix() * Q.transpose()) <= solved);
  RC_ASSERT(distance(solve(I, Q.transpose(), false).rotation.matrix(), plain.rotation.matrix() * Q) <=
            solved);
  RC_ASSERT(std::abs(turned.loss - plain.loss) <= solved * (1 + plain.loss));
}

// No rotation has a smaller loss, even with large errors: the gradient vanishes, and all around it is larger.
RC_GTEST_PROP(Wahba, TheLossIsLeast, ()) {
  const auto known = two_directions(), seen_in_b = two_directions();
  const std::vector list{weighted_observation(measured(seen_in_b.first), reference(known.first), 1.0),
                         weighted_observation(measured(seen_in_b.second), reference(known.second), 3.0)};
  const auto loss = [&](const Matrix3d& R) {
    return (seen_in_b.first.normalized() - R * known.first.normalized()).squaredNorm() / 2 +
           3 * (seen_in_b.second.normalized() - R * known.second.normalized()).squaredNorm() / 2;
  };
  const AttitudeFit<Body, Gcrf> found = wahba(to<Body>, from<Gcrf>, list);
  RC_ASSERT(std::abs(found.loss - loss(found.rotation.matrix())) <= rounding);
  const Matrix3d R = found.rotation.matrix();
  const Vector3d gradient = (R * known.first.normalized()).cross(seen_in_b.first.normalized()) +
                            3 * (R * known.second.normalized()).cross(seen_in_b.second.normalized());
  RC_ASSERT(gradient.norm() <= solved);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double turn : {-1e-3, 1e-3}) {
      RC_ASSERT(loss(Eigen::AngleAxisd(turn, Vector3d::Unit(axis)).matrix() * R) >= found.loss - rounding);
    }
  }
  const Matrix3d other = *rotation_matrix();
  RC_ASSERT(found.loss <= loss(other) + rounding);
}

class Estimates : public testing::Test {
 protected:
  const Dcm<Body, Gcrf> R = body_from_gcrf(Eigen::Quaterniond(0.3, -0.6, 0.2, 0.8).normalized());
  const std::vector<Vector3d> directions{
      {1.0, 0.2, 0.0}, {0.9, -0.4, 0.3}, {0.8, 0.1, -0.5}, {1.0, 0.6, 0.4}};
  const std::vector<double> sigmas{1e-3, 3e-3, 2e-4, 1e-3};

  Observations observe(Noise& noise, double weight_of_first = 0.0) const {
    Observations list;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto b = measured(noise.across(R.matrix() * directions[i], sigmas[i]));
      const auto a = reference(directions[i]);
      list.push_back(weight_of_first > 0.0 && i == 0 ? observation(b, a, rad(sigmas[i]), weight_of_first)
                                                     : observation(b, a, rad(sigmas[i])));
    }
    return list;
  }
  /// The small rotation in b from the true attitude to the estimated one, in its standard deviations.
  template <class Estimate> double square(const Estimate& found) const {
    const Matrix3d turn = found.rotation.matrix() * R.matrix().transpose();
    const Vector3d e = log(trust_dcm(to<Camera>, from<Body>, turn)).coordinates();
    return std::pow(mahalanobis_distance(found.covariance, vector<si::angle>(in<Body>, e)).value(), 2);
  }
};

TEST_F(Estimates, TheCovarianceOfWahbaIsThatOfItsErrors) {
  Noise noise(20240601);
  ChiSquare errors(3), losses(2 * 4 - 3), reweighted(3);
  for (int i = 0; i < draws; ++i) {
    const auto found = wahba(to<Body>, from<Gcrf>, observe(noise));
    errors.add(square(found));
    losses.add(2 * found.loss);
    reweighted.add(square(wahba(to<Body>, from<Gcrf>, observe(noise, 1e8))));  // a hundred times its due
  }
  EXPECT_TRUE(errors.agrees()) << errors.mean();
  EXPECT_TRUE(losses.agrees()) << losses.mean();
  EXPECT_TRUE(reweighted.agrees()) << reweighted.mean();
}

TEST_F(Estimates, TheCovarianceOfTriadIsThatOfItsErrors) {
  Noise noise(20240602);
  ChiSquare errors(3), mismatches(1);
  for (int i = 0; i < draws; ++i) {
    const auto list = observe(noise);
    const auto found = triad(to<Body>, from<Gcrf>, list[0], list[1]);
    errors.add(square(found));
    mismatches.add(std::pow(found.mismatch.value() / std::hypot(sigmas[0], sigmas[1]), 2));
  }
  EXPECT_TRUE(errors.agrees()) << errors.mean();
  EXPECT_TRUE(mismatches.agrees()) << mismatches.mean();
}

// Wahba's estimate is the best one: about every axis its uncertainty is at most that of triad from the same
// two observations. With measured vectors the errors would be as large as the difference, so both covariances
// are evaluated at the true vectors.
TEST_F(Estimates, WahbaIsNeverWorseThanTriad) {
  constexpr double decomposed = 1e-12;  // thousands of roundings: eigenvalue problem and inverse
  Observations list;
  for (std::size_t i = 0; i < 2; ++i) {
    list.push_back(
        observation(measured(R.matrix() * directions[i]), reference(directions[i]), rad(sigmas[i])));
  }
  const Matrix3d best = wahba(to<Body>, from<Gcrf>, list).covariance.matrix();
  const Matrix3d plain = triad(to<Body>, from<Gcrf>, list[0], list[1]).covariance.matrix();
  const Eigen::Vector3d more = Eigen::SelfAdjointEigenSolver<Matrix3d>(plain - best).eigenvalues();
  EXPECT_GE(more(0), -decomposed * plain.norm());
  // About the normal of the two, triad does not use the second vector: its variance is sigma1^2. Wahba's
  // combines sigma1^2 and sigma2^2.
  const double s1 = sigmas[0] * sigmas[0], s2 = sigmas[1] * sigmas[1];
  EXPECT_NEAR(more(2), s1 - s1 * s2 / (s1 + s2), decomposed * plain.norm());
}

TEST(Wahba, WhatFixesNoRotationIsRefused) {
  const auto R = body_from_gcrf(Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
  const auto said = [](const Observations& list) {
    return message<BadInput>([&] { wahba(to<Body>, from<Gcrf>, list); });
  };
  const std::string place = detail::dcm_door<Body, Gcrf>("wahba");
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  EXPECT_EQ(said({}), place + "the number of observations is 0; two directions fix a rotation");
  EXPECT_TRUE(contains(said({seen(R, x)}), "the number of observations is 1"));
  const std::string parallel = said({seen(R, x), seen(R, 2 * x), seen(R, -3 * x)});
  EXPECT_TRUE(contains(parallel, place + "only the share ") && contains(parallel, "feels a turn about ("))
      << parallel;
  EXPECT_TRUE(contains(said({seen(R, x), seen(R, x + 0.5e-9 * y)}), "at least 2.5e-19 is needed"));
  EXPECT_EQ(said({seen(R, x), seen(R, x + 2e-9 * y)}), "");
  // A mirror image: every half turn fits equally well.
  const auto mirrored = [](const Vector3d& r) { return observation(measured(-r), reference(r), rad(0.01)); };
  EXPECT_TRUE(contains(said({mirrored(x), mirrored(y), mirrored(z)}), "contradict each other"));
  // For float the bound is that of its rounding, and the message says so.
  const auto one_of_float = [](const Vector3d& r, float weight) {
    const Eigen::Vector3f direction = r.cast<float>();
    return weighted_observation(vector<si::dimensionless>(in<Body>, direction),
                                vector<si::dimensionless>(in<Gcrf>, direction), weight);
  };
  const auto of_float = [&](const Vector3d& second, float weight) {
    return message<BadInput>([&] {
      wahba(to<Body>, from<Gcrf>, std::vector{one_of_float(x, 1.0f), one_of_float(second, weight)});
    });
  };
  EXPECT_TRUE(contains(of_float(x + 1e-6 * y, 1.0f), "at least 9.094947e-13 is needed"))
      << of_float(x + 1e-6 * y, 1.0f);
  EXPECT_EQ(of_float(y, 1e-6f), "");
  // The ratio of the weights is larger than the square of the bound.
  EXPECT_TRUE(contains(said({seen(R, x, 1e-10), seen(R, y, 1.0)}), "outweighs the rest"));
  EXPECT_EQ(said({seen(R, x, 1e-8), seen(R, y, 1.0)}), "");
}

/// Noisy stars in a narrow field, as S and as long double.
template <class S> struct NarrowField {
  std::vector<Observation<Body, Gcrf, S>> given;
  std::vector<Observation<Body, Gcrf, long double>> exact;

  NarrowField(double width, std::size_t stars, Noise& noise) {
    using Exact = Eigen::Matrix<long double, 3, 1>;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.6, 0.2, 0.8).normalized();
    for (std::size_t i = 0; i < stars; ++i) {
      const double angle = 2.4 * static_cast<double>(i), sigma = 0.01 * width;
      const Vector3d star = Vector3d(1, -0.4, 0.3).normalized() +
                            width / 2 * Vector3d(0.3 * std::sin(angle), std::cos(angle), std::sin(angle));
      const Eigen::Matrix<S, 3, 1> a = star.normalized().cast<S>();
      const Eigen::Matrix<S, 3, 1> b = noise.across(turn * star.normalized(), sigma).cast<S>();
      const auto seen_as = [&]<class T>(const T&, const auto& in_b, const auto& in_a) {
        return observation(vector<si::dimensionless>(in<Body>, in_b),
                           vector<si::dimensionless>(in<Gcrf>, in_a),
                           Quantity<si::angle, T>::from_value(static_cast<T>(static_cast<S>(sigma))));
      };
      given.push_back(seen_as(S{}, b, a));
      exact.push_back(
          seen_as(0.0L, Exact(b.template cast<long double>()), Exact(a.template cast<long double>())));
    }
  }
};

/// The directions are rounded once, by up to half a rounding each way; a field of the width w sees this as a
/// turn of rounding / w. The sums over a few stars add theirs.
template <class S> void expect_accurate_in_narrow_fields(const std::vector<double>& widths) {
  const double rounding_of_s = static_cast<double>(std::numeric_limits<S>::epsilon());
  Noise noise(20241103);
  for (const double width : widths) {
    for (std::size_t stars = 2; stars < 8; ++stars) {
      const NarrowField<S> field(width, stars, noise);
      const auto found = wahba(to<Body>, from<Gcrf>, field.given);
      const auto exact = wahba(to<Body>, from<Gcrf>, field.exact);
      const double bound = 16 * rounding_of_s / width;
      const auto off =
          (found.rotation.matrix().template cast<long double>() - exact.rotation.matrix()).eval();
      EXPECT_LE(static_cast<double>(off.norm()), bound) << width << ", " << stars << " stars";
      const auto P = found.covariance.matrix().template cast<long double>().eval();
      EXPECT_LE(
          static_cast<double>((P - exact.covariance.matrix()).norm() / exact.covariance.matrix().norm()),
          bound)
          << width << ", " << stars << " stars";
    }
  }
}

// A singular value decomposition alone loses rounding / width^2.
TEST(Wahba, NarrowFieldsAreFittedToTheirRounding) {
  expect_accurate_in_narrow_fields<double>({1e-1, 1e-2, 1e-3, 1e-5, 1e-6, 1e-7});
  expect_accurate_in_narrow_fields<float>({1e-1, 1e-2, 1e-3, 1e-4});
}

// The strong one is met, and the weak one decides the turn about it.
TEST(Wahba, WeightsOfVeryDifferentSizeAreBothUsed) {
  const auto R = body_from_gcrf(Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
  for (const double sigma : {1e-4, 1e-6, 1e-8}) {
    const auto found = wahba(to<Body>, from<Gcrf>,
                             std::vector{seen(R, Vector3d::UnitX(), sigma), seen(R, Vector3d::UnitY(), 1.0)});
    EXPECT_LE(distance(found.rotation.matrix(), R.matrix()), 64 * rounding) << sigma;
    const Vector3d first = (R * reference(Vector3d::UnitX())).coordinates();
    EXPECT_NEAR(variance_along(found.covariance, vector<si::dimensionless>(in<Body>, first)).value(), 1.0,
                64 * rounding);
  }
}

TEST(Observation, WhatIsNoneIsRefused) {
  const auto x_b = unit_x(in<Body>);
  const auto y_a = unit_y(in<Gcrf>);
  const std::string frames = "(in<" + frame_name<Body>() + ">, in<" + frame_name<Gcrf>() + ">): ";
  const auto sigma = [&](double value) {
    return message<BadInput>([&] { observation(x_b, y_a, rad(value)); });
  };
  EXPECT_EQ(sigma(0.0),
            "observation" + frames +
                "the standard deviation is 0 rad; it is positive, with a square that a number can hold");
  for (const double value : {-1.0, std::nan(""), HUGE_VAL, 1e-200, 1e200}) {
    EXPECT_TRUE(contains(sigma(value), "the standard deviation is " + detail::text(value) + " rad")) << value;
  }
  EXPECT_EQ(observation(x_b, y_a, rad(1), 2).weight(), 2.0);
  EXPECT_EQ(weighted_observation(x_b, y_a, 2.0f).weight(), 2.0);
  for (const double value : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const std::string said = "the weight is " + detail::text(value) + "; it is positive and finite";
    EXPECT_EQ(message<BadInput>([&] { observation(x_b, y_a, rad(1), value); }),
              "observation" + frames + said);
    EXPECT_EQ(message<BadInput>([&] { weighted_observation(x_b, y_a, value); }),
              "weighted_observation" + frames + said);
  }
  const auto none = zero<si::length>(in<Body>);
  const auto x_a = vector<si::length>(in<Gcrf>, Vector3d::UnitX());
  const std::string no_direction = "observation(vector in " + frame_name<Body>() + "): |r| is 0";
  EXPECT_TRUE(message<BadInput>([&] { observation(none, x_a, rad(1)); }).starts_with(no_direction));
  EXPECT_TRUE(message<BadInput>([&] { observation(none, x_a, rad(1), 2); }).starts_with(no_direction));
  EXPECT_TRUE(
      message<BadInput>([&] { weighted_observation(none, x_a, 2); }).starts_with("weighted_" + no_direction));
}

// Weights of any size: their sum does not overflow.
TEST(Wahba, HugeAndTinyWeights) {
  const auto R = body_from_gcrf(Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
  for (const double weight : {1e308, 1e-308}) {
    const auto pair = [&](const Vector3d& r) {
      return weighted_observation(R * reference(r), reference(r), weight);
    };
    const auto found =
        wahba(to<Body>, from<Gcrf>, std::vector{pair(Vector3d::UnitX()), pair(Vector3d::UnitY())});
    EXPECT_LE(distance(found.rotation.matrix(), R.matrix()), rounding);
  }
}

template <class... Given>
concept Observes = requires(const Given&... given) {
  observation(given...);
};
using Rad = Quantity<si::angle>;
static_assert(Observes<Vector<Body, si::length>, Vector<Gcrf, si::length>, Rad>);
static_assert(!Observes<Vector<Body, si::length>, Vector<Gcrf, si::force>, Rad>);
static_assert(!Observes<Vector<Body, si::length>, Vector<Body, si::length>, Rad>);
static_assert(!Observes<Vector<Body, si::length>, Vector<Gcrf, si::length>, Quantity<si::time>>);

template <class To, class From, class List>
concept Solves = requires(const To& b, const From& a, const List& list) {
  wahba(b, a, list);
};
static_assert(Solves<vectrix::To<Body>, vectrix::From<Gcrf>, Observations>);
static_assert(!Solves<vectrix::To<Gcrf>, vectrix::From<Body>, Observations>);
static_assert(!Solves<vectrix::To<Camera>, vectrix::From<Gcrf>, Observations>);

}  // namespace
}  // namespace wahba_test
