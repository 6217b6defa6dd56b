#pragma once

#include <Eigen/Core>
#include <concepts>
#include <utility>
#include <vector>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/pointing/pointing_error.hpp>

namespace vectrix {

/// The error of an axis n of a body: the angle between where it looks and where it should. Of a small turn
/// theta only the part across the axis, two numbers, moves it: the angle is |theta - (n . theta) n|. Made by
/// absolute_error(), mean_error() and relative_error().
class VECTRIX_EXPORT LineOfSightError {
 public:
  /// Across the axis, rad. In the middle of a window of so many seconds the error is of the distribution
  /// (mean, covariance); at the time u from there, of
  ///     (mean + drift u, covariance + drift_covariance u^2 + sum_k P_k r_k(u)).
  struct Numbers {
    struct Random {
      Eigen::Matrix2d covariance;
      double correlation_time;
    };
    Eigen::Vector2d mean = Eigen::Vector2d::Zero(), drift = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(), drift_covariance = Eigen::Matrix2d::Zero();
    std::vector<Random> random{};
    double window = 0.0;
  };
  explicit LineOfSightError(Numbers numbers) : numbers_(std::move(numbers)) {}

  /// The root of the mean square of the angle.
  [[nodiscard]] Quantity<si::angle> rms() const;

  /// The probability that the angle is at most x, by quadrature, to probability_tolerance: the integral of
  /// the normal distribution of the two numbers over a circle; of a relative error also over its window.
  [[nodiscard]] double probability(const Quantity<si::angle>& x) const;

  /// The half-angle of the cone in which the axis is with this probability, its confidence: the x with
  /// probability(x) = confidence. Rayleigh's law if mean = 0 and all directions across the axis are alike;
  /// then three standard deviations are 98.9 %, not the 99.7 % of a single number. Throws BadInput when the
  /// confidence is not above 0 and at most 1 - least_risk, and when the half-angle is above
  /// largest_small_turn.
  [[nodiscard]] Quantity<si::angle> half_cone(double confidence) const;

 private:
  Numbers numbers_;
};

/// Of a probability: the rules of quadrature are exact to this for pieces of three standard deviations.
inline constexpr double probability_tolerance = 1e-9;
/// 1 - confidence is to be known to a tenth.
inline constexpr double least_risk = 10.0 * probability_tolerance;
/// rad. What is neglected, products of two turns, is half of the square of a turn.
inline constexpr double largest_small_turn = 0.5;

namespace detail {
VECTRIX_EXPORT LineOfSightError absolute_error(const std::vector<ErrorSource>& sources,
                                               const Eigen::Vector3d& axis);
VECTRIX_EXPORT LineOfSightError mean_error(const std::vector<ErrorSource>& sources,
                                           const Eigen::Vector3d& axis, double window);
VECTRIX_EXPORT LineOfSightError relative_error(const std::vector<ErrorSource>& sources,
                                               const Eigen::Vector3d& axis, double window);
}  // namespace detail

/// The absolute performance error (APE) of an axis: the error at a time. In the words of ECSS-E-ST-60-10C
/// the figures are of the mixed interpretation, any time of any flight; of drifts at the end of their time.
/// Throws BadInput when the axis has not the length 1.
template <Frame F>
LineOfSightError absolute_error(const PointingError<F>& e_f, const Vector<F, si::dimensionless>& n_f) {
  return detail::absolute_error(e_f.sources(), n_f.coordinates());
}

/// The mean performance error (MPE): the mean of the error over a window of the length D.
///     constant  b      random  P m, m = 2 (x - 1 + e^-x)/x^2, x = D/T      drift  d (t - D/2)
/// Throws BadInput as absolute_error(), when the window is not positive, and when a drift is updated in it.
template <Frame F>
LineOfSightError mean_error(const PointingError<F>& e_f, const Vector<F, si::dimensionless>& n_f,
                            const Quantity<si::time>& window) {
  return detail::mean_error(e_f.sources(), n_f.coordinates(), window.value());
}

/// The relative performance error (RPE): the error at a time less its mean over a window of the length D, at
/// any time of it alike. With u from the middle of the window, a = x/2 + u/T and b = x/2 - u/T
///     constant  0      drift  d u, in the mean square d^2 D^2/12
///     random    P r(u), r(u) = 1 + m - 2 (2 - e^-a - e^-b)/x, in the mean P (1 - m)
/// In frequencies m is the weight 2 (1 - cos wD)/(wD)^2 of Lucke, Sirlin and San Martin (1992).
/// Throws BadInput as mean_error().
template <Frame F>
LineOfSightError relative_error(const PointingError<F>& e_f, const Vector<F, si::dimensionless>& n_f,
                                const Quantity<si::time>& window) {
  return detail::relative_error(e_f.sources(), n_f.coordinates(), window.value());
}

template <class ErrorIn, class AxisIn>
  requires(!std::same_as<ErrorIn, AxisIn>)
auto absolute_error(  // (e_f, n_f): one frame; R_f_from_a * e_a carries an error to it
    const PointingError<ErrorIn>&, const Vector<AxisIn, si::dimensionless>&) -> Refused = delete;
template <class ErrorIn, class AxisIn>
  requires(!std::same_as<ErrorIn, AxisIn>)
auto mean_error(  // (e_f, n_f, window): one frame; R_f_from_a * e_a carries an error to it
    const PointingError<ErrorIn>&, const Vector<AxisIn, si::dimensionless>&, const Quantity<si::time>&)
    -> Refused = delete;
template <class ErrorIn, class AxisIn>
  requires(!std::same_as<ErrorIn, AxisIn>)
auto relative_error(  // (e_f, n_f, window): one frame; R_f_from_a * e_a carries an error to it
    const PointingError<ErrorIn>&, const Vector<AxisIn, si::dimensionless>&, const Quantity<si::time>&)
    -> Refused = delete;

}  // namespace vectrix
