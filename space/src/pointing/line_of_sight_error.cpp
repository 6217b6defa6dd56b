#include <vectrix/space/pointing/line_of_sight_error.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include <vectrix/frames/errors.hpp>

#include "normal_in_circle.hpp"
#include "quadrature.hpp"

namespace vectrix {
namespace detail {
namespace {

using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

// (e^-x - 1 + x)/x^2
double phi2(double x) {
  if (x > 0.5) return (x + std::expm1(-x)) / (x * x);
  double term = 0.5, sum = term;
  for (int k = 3; k < 18; ++k) sum += term *= -x / k;
  return sum;
}
// (1/2 - phi2(x))/x
double phi3(double x) {
  if (x > 0.5) return (0.5 - phi2(x)) / x;
  double term = 1.0 / 6.0, sum = term;
  for (int k = 4; k < 19; ++k) sum += term *= -x / k;
  return sum;
}

}  // namespace

/// m(x): the share of the variance that the mean over a window keeps.
double share_of_mean(double x) {
  return 2.0 * phi2(x);
}
/// 1 - m(x), without cancellation for small x.
double share_of_rest(double x) {
  return 2.0 * x * phi3(x);
}
/// r(u) in the form without cancellation for small x: with e^-a = 1 - a + a^2 phi2(a).
double share_at(double x, double a) {
  const double b = x - a;
  return 2.0 * (a * a * phi2(a) + b * b * phi2(b)) / x - share_of_rest(x);
}

ErrorSource checked_source(const char* door, const ErrorSource& source) {
  const std::string place = std::string(door) + "(): ";
  for (const double number : source.mean)
    if (!std::isfinite(number)) throw BadInput(place + "a coordinate is " + text(number));
  for (const double number : source.covariance.reshaped())
    if (!std::isfinite(number)) throw BadInput(place + "an entry of the covariance is " + text(number));
  if (!(source.seconds > 0.0 && std::isfinite(source.seconds)))
    throw BadInput(place +
                   (source.kind == ErrorKind::drift ? "the time since the update" : "the correlation time") +
                   " is " + text(source.seconds) + " s; it must be finite and above 0");
  return source;
}

namespace {

// The two numbers of a turn that move the axis, in some orthogonal pair of directions.
class Across {
 public:
  Across(const char* name, const Vector3d& axis) {
    const double length = axis.norm();
    if (!(std::abs(length - 1.0) <= orthonormality_tolerance))
      throw BadInput(std::string(name) + "(): |n| of the axis is " + text(length) +
                     "; direction() has length 1");
    rows_.row(0) = axis.unitOrthogonal();
    rows_.row(1) = axis.cross(rows_.row(0).transpose());
  }
  [[nodiscard]] Vector2d of(const Vector3d& v) const { return rows_ * v; }
  [[nodiscard]] Matrix2d of(const Matrix3d& P) const { return rows_ * P * rows_.transpose(); }

 private:
  Eigen::Matrix<double, 2, 3> rows_;
};

void require_window(const char* name, const std::vector<ErrorSource>& sources, double window) {
  const std::string place = std::string(name) + "(): the window is " + text(window) + " s";
  if (!(window > 0.0 && std::isfinite(window))) throw BadInput(place + "; it must be finite and above 0");
  for (const ErrorSource& source : sources)
    if (source.kind == ErrorKind::drift && window > source.seconds)
      throw BadInput(place + ", longer than the " + text(source.seconds) +
                     " s of a drift since its last update");
}

// With the drifts at a time before the end, and what of a random error is left in a mean over the window.
LineOfSightError in_one_moment(const Across& across, const std::vector<ErrorSource>& sources, double window) {
  LineOfSightError::Numbers all;
  for (const ErrorSource& source : sources) {
    const double time = source.kind == ErrorKind::drift ? source.seconds - 0.5 * window : 1.0;
    const double share =
        source.kind == ErrorKind::random ? share_of_mean(window / source.seconds) : time * time;
    all.mean += time * across.of(source.mean);
    all.covariance += share * across.of(source.covariance);
  }
  return LineOfSightError(std::move(all));
}

}  // namespace

LineOfSightError absolute_error(const std::vector<ErrorSource>& sources, const Vector3d& axis) {
  return in_one_moment(Across("absolute_error", axis), sources, 0.0);
}

LineOfSightError mean_error(const std::vector<ErrorSource>& sources, const Vector3d& axis, double window) {
  require_window("mean_error", sources, window);
  return in_one_moment(Across("mean_error", axis), sources, window);
}

LineOfSightError relative_error(const std::vector<ErrorSource>& sources, const Vector3d& axis,
                                double window) {
  require_window("relative_error", sources, window);
  const Across across("relative_error", axis);
  LineOfSightError::Numbers all;
  all.window = window;
  for (const ErrorSource& source : sources) {
    if (source.kind == ErrorKind::random)
      all.random.push_back({across.of(source.covariance), source.seconds});
    if (source.kind == ErrorKind::drift) {
      all.drift += across.of(source.mean);
      all.drift_covariance += across.of(source.covariance);
    }
  }
  return LineOfSightError(std::move(all));
}

}  // namespace detail

using Eigen::Matrix2d, Eigen::Vector2d;

Quantity<si::angle> LineOfSightError::rms() const {
  const double square = numbers_.window * numbers_.window / 12.0;  // of u, in the mean
  double sum = numbers_.mean.squaredNorm() + numbers_.covariance.trace() +
               square * (numbers_.drift.squaredNorm() + numbers_.drift_covariance.trace());
  for (const auto& [covariance, correlation_time] : numbers_.random)
    sum += detail::share_of_rest(numbers_.window / correlation_time) * covariance.trace();
  return std::sqrt(sum) * si::radian;
}

double LineOfSightError::probability(const Quantity<si::angle>& x) const {
  const double radius = x.value();
  if (!std::isfinite(radius)) throw BadInput("probability(): the angle is " + detail::text(radius));
  const double half = 0.5 * numbers_.window;
  const auto covariance_at = [&](double u) {
    Matrix2d covariance = numbers_.covariance + u * u * numbers_.drift_covariance;
    for (const auto& [P, T] : numbers_.random)
      covariance += detail::share_at(numbers_.window / T, (half + u) / T) * P;
    return covariance;
  };
  const auto at = [&](double u) {
    return detail::normal_in_circle(numbers_.mean + u * numbers_.drift, covariance_at(u), radius);
  };
  if (numbers_.window == 0.0) return at(0.0);
  // Alike for u and -u. It changes fast within some correlation times of the ends, and where a known drift
  // leaves the circle.
  std::vector<double> places;
  for (const auto& [P, T] : numbers_.random)
    for (const double times : {0.1, 0.3, 1.0, 3.0, 8.0, 16.0, 40.0}) places.push_back(half - times * T);
  if (const double drift = numbers_.drift.norm(); drift * half > radius) {
    const double u = radius / drift;
    const Vector2d along = numbers_.drift / drift;
    const double deviation = std::sqrt(std::max(along.dot(covariance_at(u) * along), 0.0));
    for (const double times : {-9.0, -3.0, -1.0, 0.0, 1.0, 3.0, 9.0})
      places.push_back(u + times * deviation / drift);
  }
  return detail::adaptive_integral(at, 0.0, half, std::move(places)) / half;
}

Quantity<si::angle> LineOfSightError::half_cone(double confidence) const {
  if (!(confidence > 0.0 && confidence <= 1.0 - least_risk))
    throw BadInput("half_cone(): the confidence is " + detail::text(confidence) +
                   "; it must be above 0 and at most 1 - " + detail::text(least_risk) +
                   ", for a normal distribution has no bound");
  const double largest = largest_small_turn;
  const auto missing = [&](double x) { return probability(x * si::radian) - confidence; };
  if (!(missing(largest) >= 0.0))
    throw BadInput("half_cone(): the half-angle is above " + detail::text(largest) +
                   " rad; the law is of small turns");
  return detail::zero_of(missing, largest, rms().value()) * si::radian;
}

}  // namespace vectrix
