#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/space/pointing/line_of_sight_error.hpp>

namespace vectrix::line_of_sight_error_test {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

struct Camera : moving_frame {};
struct Bench : moving_frame {};
struct Body : moving_frame {};

// Closed forms agree to the quadrature's share of a probability, divided by its density at the quantile.
constexpr double exact = 1e-8;

Covariance<Body, si::angle> deviations(double x, double y, double z) {
  return covariance_from_standard_deviations(in<Body>, x * si::radian, y * si::radian, z * si::radian);
}
Vector<Body, si::angle> turn(double x, double y, double z) {
  return vector(in<Body>, x * si::radian, y * si::radian, z * si::radian);
}
Quantity<si::time> seconds(double t) {
  return t * si::second;
}
const auto z_axis = unit_z(in<Body>);
double cone(const LineOfSightError& error, double confidence) {
  return error.half_cone(confidence).value();
}

TEST(LineOfSightError, IsOfRayleighsLawIfAllDirectionsAreAlike) {
  const double s = 2e-5;
  // What turns about the axis does not move it.
  const auto error = absolute_error(constant_error(deviations(s, s, 1000.0 * s)), z_axis);
  for (const double p : {0.01, 0.393, 0.5, 0.95, 0.9973, 0.999999})
    EXPECT_NEAR(cone(error, p), s * std::sqrt(-2.0 * std::log1p(-p)), exact * s / (1.0 - p)) << p;
  EXPECT_NEAR(error.probability(3.0 * s * si::radian), 0.988891, 1e-6);
  EXPECT_NEAR(error.rms().value(), s * std::numbers::sqrt2, 1e-15);
}

// One number: 99.73 % are within three standard deviations.
TEST(LineOfSightError, IsHalfNormalIfOneDirectionIsExact) {
  const auto error = absolute_error(constant_error(deviations(1e-3, 0.0, 0.0)), z_axis);
  EXPECT_NEAR(cone(error, std::erf(3.0 / std::numbers::sqrt2)), 3e-3, exact * 3e-3);
  EXPECT_NEAR(cone(error, 0.5), 0.6744897501960817e-3, exact * 1e-3);
}

TEST(LineOfSightError, IsTheSameAtEachConfidenceIfItIsKnown) {
  const auto error = absolute_error(constant_error(turn(3e-3, -4e-3, 0.2)), z_axis);
  for (const double p : {1e-6, 0.5, 0.999}) EXPECT_NEAR(cone(error, p), 5e-3, 1e-14);
  // Those that are known add as vectors.
  const auto sum = constant_error(turn(3e-3, -4e-3, 0.2)) + constant_error(turn(-3e-3, 4e-3, 0.0));
  EXPECT_NEAR(cone(absolute_error(sum, z_axis), 0.9), 0.0, 1e-15);
}

// Rice: r^2/s^2 is of the non-central chi-squared distribution of two numbers.
RC_GTEST_PROP(LineOfSightError, IsOfRicesLawIfItIsKnownWithAnErrorAlikeInAllDirections, ()) {
  const double s = 1e-4, ratio = 0.01 * *rc::gen::inRange(0, 2000), p = 1e-4 * *rc::gen::inRange(1, 9999);
  const double bearing = *rc::gen::inRange(0, 6);
  const auto error =
      absolute_error(constant_error(turn(ratio * s * std::cos(bearing), ratio * s * std::sin(bearing), 0.0)) +
                         constant_error(deviations(s, s, 0.0)),
                     z_axis);
  const boost::math::non_central_chi_squared law(2.0, std::max(ratio * ratio, 1e-300));
  const double x = cone(error, p) / s;
  RC_ASSERT(std::abs(boost::math::cdf(law, x * x) - p) <= probability_tolerance);
}

// Two numbers of different deviations about a mean: by rays from the mean, of which a trapezoidal rule is
// exact for smooth periodic functions.
RC_GTEST_PROP(LineOfSightError, IsTheIntegralOverACircle, ()) {
  const auto number = [](int from, int until) { return 1e-3 * *rc::gen::inRange(from, until); };
  const double a = number(100, 1000), b = number(100, 1000), m = number(-700, 700), n = number(-700, 700);
  const double x = std::hypot(m, n) + number(100, 3000), scale = 1e-2;
  const auto error = absolute_error(
      constant_error(turn(scale * m, scale * n, 0.0)) + constant_error(deviations(scale * a, scale * b, 0.3)),
      z_axis);
  constexpr int rays = 4096;
  double sum = 0.0;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / rays;
    const double u = a * std::cos(angle), v = b * std::sin(angle), along = m * u + n * v, uu = u * u + v * v;
    const double t = (-along + std::sqrt(along * along + uu * (x * x - m * m - n * n))) / uu;
    sum -= std::expm1(-0.5 * t * t) / rays;
  }
  RC_ASSERT(std::abs(error.probability(scale * x * si::radian) - sum) <= probability_tolerance);
}

// From nearly one number to nearly exact ones the law goes over without a jump.
TEST(LineOfSightError, HoldsForDeviationsOfVeryDifferentSizes) {
  for (const double thin : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto error = absolute_error(
        constant_error(turn(2e-3, 0.0, 0.0)) + constant_error(deviations(1e-3, thin * 1e-3, 0.0)), z_axis);
    // Of the one number alone: erf((x - 2)/sqrt 2) + erf((x + 2)/sqrt 2), halved.
    EXPECT_NEAR(error.probability(3e-3 * si::radian), 0.8413444, thin + 1e-6) << thin;
    const auto known = absolute_error(
        constant_error(turn(2e-3, 0.0, 0.0)) + constant_error(deviations(thin * 1e-3, thin * 1e-3, 0.0)),
        z_axis);
    EXPECT_NEAR(cone(known, 0.5), 2e-3, 1e-3 * thin) << thin;
  }
}

// m(x) by the double integral of e^(-|t-s|/T) over the window.
TEST(WindowStatistics, AreTheClosedFormsOfAGaussMarkovProcess) {
  const double s = 1e-3;
  const auto error = random_error(deviations(s, s, s), seconds(2.0));
  const double whole = absolute_error(error, z_axis).rms().value();
  for (const double window : {1e-7, 1e-3, 0.2, 0.999, 1.001, 5.0, 60.0, 1e6}) {
    const double x = window / 2.0;
    const double mean = mean_error(error, z_axis, seconds(window)).rms().value() / whole,
                 rest = relative_error(error, z_axis, seconds(window)).rms().value() / whole;
    EXPECT_NEAR(mean * mean + rest * rest, 1.0, 1e-14) << window;
    if (x < 1e-2) {
      EXPECT_NEAR(rest * rest, x / 3.0 - x * x / 12.0, 1e-13 * x + x * x * x) << window;
    } else {
      EXPECT_NEAR(mean * mean, 2.0 * (x - 1.0 + std::exp(-x)) / (x * x), 1e-13) << window;
    }
  }
}

// What changes fast compared with the window is in it as at any time; the ends, of some correlation times,
// differ.
TEST(WindowStatistics, OfAFastProcessAreAlmostThoseOfOneTime) {
  const double T = 1e-5, window = 1.0;
  const auto error = random_error(deviations(1e-3, 3e-4, 1.0), seconds(T));
  const auto relative = relative_error(error, z_axis, seconds(window));
  const auto absolute = absolute_error(error, z_axis);
  for (const double p : {0.1, 0.5, 0.997})
    EXPECT_NEAR(absolute.probability(relative.half_cone(p)), p, 4.0 * T / window) << p;
}

TEST(WindowStatistics, OfAConstantErrorAreItsMeanAlone) {
  const auto error = constant_error(deviations(1e-3, 2e-3, 0.0)) + constant_error(turn(1e-3, 0.0, 0.0));
  EXPECT_NEAR(cone(mean_error(error, z_axis, seconds(60.0)), 0.9), cone(absolute_error(error, z_axis), 0.9),
              1e-15);
  EXPECT_EQ(cone(relative_error(error, z_axis, seconds(60.0)), 0.9), 0.0);
}

// A ramp: its mean is in the middle of the window, and at any time u alike it is d u from there.
TEST(WindowStatistics, OfADriftAreThoseOfARamp) {
  const auto radian_per_second = si::radian / si::second;
  const auto known = drift_error(
      vector(in<Body>, 3e-6 * radian_per_second, 4e-6 * radian_per_second, 9e-6 * radian_per_second),
      seconds(100.0));
  for (const double p : {0.1, 0.5, 0.99}) {
    EXPECT_NEAR(cone(absolute_error(known, z_axis), p), 500e-6, 1e-15);
    EXPECT_NEAR(cone(mean_error(known, z_axis, seconds(60.0)), p), 350e-6, 1e-15);
    EXPECT_NEAR(cone(relative_error(known, z_axis, seconds(60.0)), p), 150e-6 * p, 150e-6 * exact) << p;
  }
  // Of a rate that is not known, a mixture: P(|d u| <= x) is the mean of 1 - e^(-x^2/(2 s^2 u^2)).
  const double s = 1e-6, half = 30.0, x = 20e-6;
  const auto error =
      drift_error(covariance_from_standard_deviations(in<Body>, s * radian_per_second, s * radian_per_second,
                                                      0.0 * radian_per_second),
                  seconds(100.0));
  double sum = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double u = half * (i + 0.5) / steps;
    sum -= std::expm1(-0.5 * std::pow(x / (s * u), 2)) / steps;
  }
  const auto relative = relative_error(error, z_axis, seconds(2.0 * half));
  EXPECT_NEAR(relative.probability(x * si::radian), sum, 1e-8);  // of the midpoint rule
  EXPECT_NEAR(relative.rms().value(), s * half * std::sqrt(2.0 / 3.0), 1e-18);
}

// A process of two numbers, drawn from its definition step by step, in windows that are independent.
TEST(WindowStatistics, AreThoseOfManyWindows) {
  constexpr int windows = 10000, steps = 100;
  constexpr double T = 20.0, window = 30.0, step = window / steps, a = 1e-3, b = 0.4e-3, d = 5e-5;
  std::mt19937_64 random(20261129);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> any(0, steps);
  const double kept = std::exp(-step / T), added = std::sqrt(1.0 - kept * kept);
  const auto error = random_error(deviations(a, b, 1.0), seconds(T)) +
                     drift_error(vector(in<Body>, 0.0 * (si::radian / si::second),
                                        d * (si::radian / si::second), 0.0 * (si::radian / si::second)),
                                 seconds(100.0));
  const auto relative = relative_error(error, z_axis, seconds(window));
  const auto means = mean_error(random_error(deviations(a, b, 1.0), seconds(T)), z_axis, seconds(window));
  constexpr double confidence = 0.9;
  const double x = cone(relative, confidence), y = cone(means, confidence);
  double squares = 0.0, squares_of_means = 0.0, fourths = 0.0, fourths_of_means = 0.0;
  int within = 0, means_within = 0;
  for (int k = 0; k < windows; ++k) {
    Eigen::Vector2d e(a * normal(random), b * normal(random)), mean = Eigen::Vector2d::Zero();
    const int chosen = any(random);
    Eigen::Vector2d there = e;
    for (int i = 0; i <= steps; ++i) {
      if (i > 0) e = kept * e + added * Eigen::Vector2d(a * normal(random), b * normal(random));
      mean += e * ((i == 0 || i == steps ? 0.5 : 1.0) / steps);
      if (i == chosen) there = e + Eigen::Vector2d(0.0, d * (i * step - 0.5 * window));
    }
    const double rest = (there - mean).squaredNorm(), of_mean = mean.squaredNorm();
    squares += rest / windows;
    squares_of_means += of_mean / windows;
    fourths += rest * rest / windows;
    fourths_of_means += of_mean * of_mean / windows;
    within += std::sqrt(rest) <= x ? 1 : 0;
    means_within += std::sqrt(of_mean) <= y ? 1 : 0;
  }
  // Four standard deviations of the sample; the sums of 100 steps are off the integrals by a share of
  // (step/T)^2, and the end times are drawn as often as others: half a step of 100.
  constexpr double of_steps = 1.0 / steps;
  const auto bound = [](double fourth, double square) {
    return 4.0 * std::sqrt((fourth - square * square) / windows) + of_steps * square;
  };
  EXPECT_NEAR(squares, std::pow(relative.rms().value(), 2), bound(fourths, squares));
  EXPECT_NEAR(squares_of_means, std::pow(means.rms().value(), 2), bound(fourths_of_means, squares_of_means));
  const double of_counts = 4.0 * std::sqrt(confidence * (1.0 - confidence) / windows);
  EXPECT_NEAR(1.0 * within / windows, confidence, of_counts + of_steps * (1.0 - confidence));
  EXPECT_NEAR(1.0 * means_within / windows, confidence, of_counts + of_steps * (1.0 - confidence));
}

// The columns of L, P = L L^T, are turns, and vectors: their way along a chain of two turns that do not
// commute is that of the covariance.
TEST(PointingError, IsCarriedAlongTheChainAsVectorsAre) {
  const Dcm R_bench_from_camera =
      dcm(axis_angle(of<Camera>, relative_to<Bench>, unit_x(in<Bench>), 0.8 * si::radian));
  const Dcm R_body_from_bench =
      dcm(axis_angle(of<Bench>, relative_to<Body>, unit_y(in<Body>), -1.1 * si::radian));
  Matrix3d L;
  L << 1.0, 0.0, 0.0, 2.0, 0.5, 0.0, -1.0, 3.0, 0.1;
  L *= 1e-4;
  const auto b_camera = vector(in<Camera>, 1e-4 * si::radian, 2e-4 * si::radian, -5e-4 * si::radian);
  const auto error = constant_error(covariance<si::angle>(in<Camera>, Matrix3d(L * L.transpose()))) +
                     constant_error(b_camera);
  const auto axis = direction(vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 0.5 * si::metre));
  const auto square_across = [&](const Vector<Camera, si::angle>& theta_camera) {
    const Vector3d theta = (R_body_from_bench * (R_bench_from_camera * theta_camera)).coordinates();
    return axis.coordinates().cross(theta).squaredNorm();
  };
  double sum = square_across(b_camera);
  for (const Vector3d& column : {L.col(0).eval(), L.col(1).eval(), L.col(2).eval()})
    sum += square_across(
        vector(in<Camera>, column.x() * si::radian, column.y() * si::radian, column.z() * si::radian));
  const PointingError<Body> carried = R_body_from_bench * (R_bench_from_camera * error);
  EXPECT_NEAR(absolute_error(carried, axis).rms().value(), std::sqrt(sum), 1e-16);
  const PointingError<Body> at_once = R_body_from_bench * R_bench_from_camera * error;
  EXPECT_NEAR(absolute_error(at_once, axis).rms().value(), std::sqrt(sum), 1e-16);
}

TEST(PointingError, SaysWhatItIs) {
  std::ostringstream out;
  out << constant_error(turn(1e-3, 0.0, 0.0)) << ", "
      << constant_error(turn(1e-3, 0.0, 0.0)) + random_error(deviations(1.0, 1.0, 1.0), seconds(1.0));
  EXPECT_EQ(out.str(),
            "1 contribution in " + frame_name<Body>() + ", 2 contributions in " + frame_name<Body>());
}

template <class Function> std::string refusal(const Function& function) {
  try {
    (void)function();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "nothing is refused";
}

TEST(PointingError, RefusesWhatIsNoError) {
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] { return constant_error(1e308 * turn(0.0, 100.0, 0.0)); }),
            "constant_error(): a coordinate is inf");
  EXPECT_EQ(
      refusal([&] {
        return constant_error(trust_covariance<si::angle>(in<Body>, Matrix3d(Matrix3d::Constant(no_number))));
      }),
      "constant_error(): an entry of the covariance is nan");
  EXPECT_EQ(refusal([] { return random_error(deviations(1.0, 1.0, 1.0), seconds(0.0)); }),
            "random_error(): the correlation time is 0 s; it must be finite and above 0");
  EXPECT_EQ(refusal([] {
              const auto rate = 1.0 * (si::radian / si::second);
              return drift_error(vector(in<Body>, rate, rate, rate), seconds(-1.0));
            }),
            "drift_error(): the time since the update is -1 s; it must be finite and above 0");
}

TEST(LineOfSightError, RefusesWhatHasNoFigure) {
  const auto error = constant_error(deviations(1e-3, 1e-3, 1e-3));
  const auto found = absolute_error(error, z_axis);
  const std::string most =
      "; it must be above 0 and at most 1 - 1e-08, for a normal distribution has no bound";
  EXPECT_EQ(refusal([&] { return found.half_cone(1.0); }), "half_cone(): the confidence is 1" + most);
  EXPECT_EQ(refusal([&] { return found.half_cone(0.0); }), "half_cone(): the confidence is 0" + most);
  EXPECT_EQ(refusal([&] { return found.probability(std::nan("") * si::radian); }),
            "probability(): the angle is nan");
  EXPECT_EQ(refusal([&] { return mean_error(error, z_axis, seconds(0.0)); }),
            "mean_error(): the window is 0 s; it must be finite and above 0");
  EXPECT_EQ(refusal([&] {
              const auto rate = 1e-6 * (si::radian / si::second);
              return relative_error(error + drift_error(vector(in<Body>, rate, rate, rate), seconds(10.0)),
                                    z_axis, seconds(20.0));
            }),
            "relative_error(): the window is 20 s, longer than the 10 s of a drift since its last update");
  EXPECT_EQ(refusal([&] { return absolute_error(error, 2.0 * z_axis); }),
            "absolute_error(): |n| of the axis is 2; direction() has length 1");
  for (const double off : {-orthonormality_tolerance, orthonormality_tolerance}) {
    EXPECT_NO_THROW((void)absolute_error(error, (1.0 + 0.999 * off) * z_axis));
    EXPECT_THROW((void)absolute_error(error, (1.0 + 1.001 * off) * z_axis), BadInput);
  }
  EXPECT_EQ(refusal([&] {
              return absolute_error(constant_error(deviations(0.3, 0.3, 0.0)), z_axis).half_cone(0.9);
            }),
            "half_cone(): the half-angle is above 0.5 rad; the law is of small turns");
}

}  // namespace
}  // namespace vectrix::line_of_sight_error_test
