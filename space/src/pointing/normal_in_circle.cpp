#include "normal_in_circle.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "quadrature.hpp"

namespace vectrix::detail {
namespace {

// That |y| <= h for y of a normal distribution.
double in_interval(double mean, double deviation, double h) {
  if (deviation == 0.0) return std::abs(mean) <= h ? 1.0 : 0.0;
  const double scale = 1.0 / (deviation * std::numbers::sqrt2);
  return 0.5 * (std::erf((h - mean) * scale) + std::erf((h + mean) * scale));
}

}  // namespace

// Along the principal axes, y of the larger deviation s and z of the smaller one:
//     integral over |y| <= x of p(y) P(|z| <= sqrt(x^2 - y^2)) dy,    y = x sin(a)
double normal_in_circle(const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance, double radius) {
  constexpr double most = 9.0;   // standard deviations: 2e-19 of the probability is beyond
  constexpr double piece = 3.0;  // the same, long
  if (!(radius >= 0.0)) return 0.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(covariance);
  const Eigen::Vector2d deviations = principal.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d middle = principal.eigenvectors().transpose() * mean;
  const double small = deviations[0], large = deviations[1];
  if (large == 0.0) return middle.norm() <= radius ? 1.0 : 0.0;
  if (radius == 0.0) return 0.0;
  if (small == 0.0) {
    const double left = radius * radius - middle[0] * middle[0];
    return left >= 0.0 ? in_interval(middle[1], large, std::sqrt(left)) : 0.0;
  }
  const auto angle = [&](double y) { return std::asin(std::clamp(y / radius, -1.0, 1.0)); };
  std::vector<double> places;
  for (double times = -most; times <= most; times += piece) {
    places.push_back(angle(middle[1] + times * large));
    const double z = std::abs(middle[0]) + times * small;
    if (z > 0.0 && z < radius) {
      places.push_back(std::acos(z / radius));
      places.push_back(-places.back());
    }
  }
  const auto density = [&](double a) {
    const double y = radius * std::sin(a), h = radius * std::cos(a), d = (y - middle[1]) / large;
    return std::exp(-0.5 * d * d) * in_interval(middle[0], small, h) * h;
  };
  return integral(density, angle(middle[1] - most * large), angle(middle[1] + most * large),
                  std::move(places)) /
         (large * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace vectrix::detail
