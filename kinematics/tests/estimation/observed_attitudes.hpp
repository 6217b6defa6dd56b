#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

/// Shared by the tests of rotations from data: random directions, measured with errors.
namespace vectrix_test {

inline vectrix::Vector<Gcrf, vectrix::si::dimensionless> reference(const Eigen::Vector3d& r) {
  return direction(vectrix::vector<vectrix::si::dimensionless>(vectrix::in<Gcrf>, r));
}
inline vectrix::Vector<Body, vectrix::si::dimensionless> measured(const Eigen::Vector3d& r) {
  return direction(vectrix::vector<vectrix::si::dimensionless>(vectrix::in<Body>, r));
}
inline vectrix::Quantity<vectrix::si::angle> rad(double angle) {
  return vectrix::Quantity<vectrix::si::angle>::from_value(angle);
}
inline vectrix::Dcm<Body, Gcrf> body_from_gcrf(const Eigen::Quaterniond& q) {
  return vectrix::trust_dcm(vectrix::to<Body>, vectrix::from<Gcrf>, q.toRotationMatrix());
}

/// Normally distributed numbers.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}
  double operator()(double sigma) { return sigma * normal_(random_); }
  Eigen::Vector3d column(double sigma) { return {(*this)(sigma), (*this)(sigma), (*this)(sigma)}; }
  /// r turned by sigma about each of two axes perpendicular to it.
  Eigen::Vector3d across(const Eigen::Vector3d& r, double sigma) {
    const Eigen::Vector3d u = r.unitOrthogonal();
    return r.normalized() + (*this)(sigma)*u + (*this)(sigma)*r.normalized().cross(u);
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

/// The mean of squares that must have the chi-square distribution.
class ChiSquare {
 public:
  explicit ChiSquare(double freedom) : freedom_(freedom) {}
  void add(double square) {
    sum_ += square;
    ++count_;
  }
  double mean() const { return sum_ / count_; }
  /// Five standard deviations of the mean, whose variance is 2 k / n: one seed in two million is outside.
  bool agrees() const { return std::abs(mean() - freedom_) < 5 * std::sqrt(2 * freedom_ / count_); }

 private:
  double freedom_, sum_ = 0.0, count_ = 0.0;
};

/// Directions at least this far from parallel: a rounding changes the attitude by less than rounding / sine
/// of this angle.
inline constexpr double least_sine = 0.1;
inline constexpr double solved = 64 * epsilon / (least_sine * least_sine);

/// Two directions that are not nearly parallel.
inline std::pair<Eigen::Vector3d, Eigen::Vector3d> two_directions() {
  const Eigen::Matrix3d axes = *rotation_matrix();
  const double least = std::asin(least_sine), most = std::numbers::pi - least;
  const double angle = least + (most - least) * (1 + *coordinate()) / 2;
  return {axes.col(0), 2 * (std::cos(angle) * axes.col(0) + std::sin(angle) * axes.col(1))};
}

inline vectrix::Observation<Body, Gcrf> seen(const vectrix::Dcm<Body, Gcrf>& R, const Eigen::Vector3d& r,
                                             double sigma = 0.01) {
  return observation(R * reference(r), reference(r), rad(sigma));
}

}  // namespace vectrix_test
