#pragma once

#include <vectrix/frames/covariance.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/estimation/observation.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/kinematics/samples/log_motion.hpp>
#include <vectrix/kinematics/samples/sample_steps.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

namespace vectrix {

/// The largest turn, rad, from the middle of a window to its ends that estimate_motion() accepts. Beyond half
/// a turn the shortest rotation vector belongs to another turn.
inline constexpr double widest_window_turn = 2.0;

/// Smallest share of the sum of squares of a polynomial term that the other terms must leave unexplained.
/// Below it rounding decides the derivatives.
inline constexpr double nearly_undetermined = 1e-10;

/// R_b^a, w_ab^b and alpha_ab^b at one instant, estimated from noisy samples, with the covariances of the
/// errors: the small turn from the true to the estimated attitude, and the errors of the two vectors.
template <Frame A, Frame B, class S = double> struct MotionEstimate {
  AcceleratingDcm<A, B, S> motion;
  Covariance<B, si::angle, S> attitude_covariance;
  Covariance<B, si::angular_velocity, S> rate_covariance;
  Covariance<B, si::angular_acceleration, S> acceleration_covariance;
  /// Half the sum of the squared residuals, in units of sigma. Twice the loss has the chi-square distribution
  /// of `freedom` degrees of freedom. A much larger value means that the motion is not a polynomial over the
  /// window, or that sigma is too small.
  S loss;
  std::size_t freedom;
};

namespace detail {

/// A polynomial of rotation vectors, theta = sum_k p_k u^k, by least squares.
template <int degree, class S> struct LogPolynomial {
  static constexpr Eigen::Index size = 3 * (degree + 1);
  using Normal = Eigen::Matrix<S, size, size>;
  using Coefficients = Eigen::Matrix<S, size, 1>;

  Coefficients p;
  Normal covariance;  // for errors of variance 1
  S squares;          // of the residuals
  S least_share;      // smallest pivot: what the others leave unexplained

  Column<S> coefficient(Eigen::Index k) const { return p.template segment<3>(3 * k); }
  Square<S> block(Eigen::Index k, Eigen::Index l) const {
    return covariance.template block<3, 3>(3 * k, 3 * l);
  }

  /// An error e of the sample's attitude, in b, changes theta by J^-1 e, so the residual is J (theta -
  /// polynomial).
  LogPolynomial(const std::vector<S>& u, const std::vector<Column<S>>& theta) {
    Normal normal = Normal::Zero();
    Coefficients right = Coefficients::Zero();
    for (std::size_t i = 0; i < u.size(); ++i) {
      const auto design = row(u[i], theta[i]);
      normal += design.transpose() * design;
      right += design.transpose() * theta[i];  // J theta = theta
    }
    const Coefficients scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::LLT<Normal> factor(Normal(scale.asDiagonal() * normal * scale.asDiagonal()));
    least_share =
        factor.info() == Eigen::Success ? S(factor.matrixLLT().diagonal().cwiseAbs2().minCoeff()) : S(0);
    covariance = scale.asDiagonal() * factor.solve(Normal::Identity()) * scale.asDiagonal();
    p = covariance * right;
    squares = S(0);
    for (std::size_t i = 0; i < u.size(); ++i) {
      squares += (theta[i] - row(u[i], theta[i]) * p).squaredNorm();
    }
  }

 private:
  static Eigen::Matrix<S, 3, size> row(const S& u, const Column<S>& theta) {
    Eigen::Matrix<S, 3, size> design;
    Square<S> term = log_jacobian(theta);
    for (Eigen::Index k = 0; k <= degree; ++k) {
      design.template middleCols<3>(3 * k) = term;
      term *= u;
    }
    return design;
  }
};

template <class S> Square<S> symmetric(const Square<S>& P) {
  return (P + P.transpose()) / S(2);
}

}  // namespace detail

/// The motion at t by least squares: a polynomial of rotation vectors through the samples within `half_width`
/// of t. The error of a sample is a small turn of standard deviation sigma about each axis, independent of
/// the others. In the middle of a window of n samples a step h apart the standard deviation of w is about
/// sigma/h sqrt(12/n^3) for degree 2 (and sqrt(75/n^3) for 3 and 4). The covariances are of first order in
/// sigma and do not include the error of the polynomial model. Throws BadInput when t is outside the samples,
/// the window has fewer samples than the polynomial has coefficients, it turns by more than
/// widest_window_turn to either side, or sigma is not positive.
template <int degree = 3, class A, class B, class I, class S = InstantScalar<I>>
  requires(degree >= 2 && degree <= 6 && detail::SingleNumber<S>)
MotionEstimate<A, B, S> estimate_motion(const std::vector<AttitudeSample<A, B, I>>& samples,
                                        const std::type_identity_t<I>& t,
                                        const Quantity<si::time, std::type_identity_t<S>>& half_width,
                                        const Quantity<si::angle, std::type_identity_t<S>>& sigma) {
  using detail::instant_text, detail::text;
  using Sample = AttitudeSample<A, B, I>;
  const std::string place = detail::samples_place<A, B>("estimate_motion");
  const auto refuse = [&](const std::string& why) { throw BadInput(place + ": " + why); };
  detail::SampleSteps<I>::require_instants(place, detail::instants_of(samples), degree + 1);
  const S width = half_width.value(), variance = sigma.value() * sigma.value();
  if (!(sigma.value() > S(0) && variance > S(0) && variance - variance == S(0)))
    refuse("the standard deviation is " + text(sigma.value()) + " rad");
  if (!(width > S(0) && width - width == S(0))) refuse("the half width is " + text(width) + " s");
  const I &earliest = samples.front().time, &latest = samples.back().time;
  const auto since_now = [&](const Sample& sample) -> S { return (sample.time - t).value(); };
  if (!(since_now(samples.front()) <= S(0) && since_now(samples.back()) >= S(0)))
    refuse("the time " + instant_text(t) + " is outside the samples, [" + instant_text(earliest) + ", " +
           instant_text(latest) + "]");

  const auto before = [&](const Sample& sample, const S& time) { return since_now(sample) < time; };
  const auto until = [&](const S& time, const Sample& sample) { return time < since_now(sample); };
  const auto first = std::lower_bound(samples.begin(), samples.end(), -width, before);
  const auto end = std::upper_bound(samples.begin(), samples.end(), width, until);
  const std::size_t count = first < end ? static_cast<std::size_t>(end - first) : 0;
  if (count < degree + 1)
    refuse("the number of samples within " + text(width) + " s of " + instant_text(t) + " is " + text(count) +
           "; a polynomial of degree " + text(degree) + " needs " + text(degree + 1));
  const auto middle = std::min(std::lower_bound(first, end, S(0), before), end - 1);
  const auto turned = [](auto from, auto last) {
    S angle = S(0);
    for (; from != last; ++from)
      angle += detail::turn_between(from->q_a_from_b, std::next(from)->q_a_from_b).norm();
    return angle;
  };
  const S turn = std::max(turned(first, middle), turned(middle, end - 1));
  if (!(turn <= S(widest_window_turn)))
    refuse("from the middle of the window to its end b turns by " + text(turn) + " rad, at most " +
           text(widest_window_turn) + " rad are allowed");

  using Polynomial = detail::LogPolynomial<degree, S>;
  std::vector<S> u;
  for (auto sample = first; sample != end; ++sample) u.push_back(since_now(*sample) / width);
  const auto fit_about = [&](const Quaternion<A, B, S>& q0) {
    std::vector<detail::Column<S>> theta;
    for (auto sample = first; sample != end; ++sample)
      theta.push_back(detail::turn_between(q0, sample->q_a_from_b));
    return Polynomial(u, theta);
  };
  const auto moved = [](const Quaternion<A, B, S>& q0, const detail::Column<S>& theta) {
    const auto increment = exp_quaternion(RotationVector<A, B, S>{detail::trusted, theta});
    return Quaternion<A, B, S>{detail::trusted, q0.eigen() * increment.eigen()};
  };
  // First about the middle sample, then about the attitude found, where theta is nearly zero.
  const Polynomial coarse = fit_about(middle->q_a_from_b);
  if (!(coarse.least_share > S(detail::door_tolerance<S>(nearly_undetermined))))
    refuse("the times of the " + text(count) + " samples in the window do not fix a polynomial of degree " +
           text(degree) + ": the share " + text(coarse.least_share) + " is left to one coefficient");
  const Quaternion<A, B, S> q0 = moved(middle->q_a_from_b, coarse.coefficient(0));
  const Polynomial fine = fit_about(q0);
  const detail::Column<S> rate = fine.coefficient(1) / width;
  const detail::Column<S> acceleration = S(2) * fine.coefficient(2) / (width * width);
  const detail::LogMotion<S> motion{fine.coefficient(0), rate, acceleration};

  // At theta = 0:  dw = dtheta' + theta' x dtheta / 2
  //                dalpha = dtheta'' + theta'' x dtheta / 2 - theta' x (theta' x dtheta) / 6
  using Square = detail::Square<S>;
  const Square half_rate = hat(rate) / S(2);
  const Square bent = hat(acceleration) / S(2) - hat(rate) * hat(rate) / S(6);
  const Square P00 = fine.block(0, 0);
  const Square P10 = fine.block(1, 0) / width, P11 = fine.block(1, 1) / (width * width);
  const Square P20 = S(2) * fine.block(2, 0) / (width * width);
  const Square P22 = S(4) * fine.block(2, 2) / (width * width * width * width);
  const Square Pw = P11 + half_rate * P10.transpose() + P10 * half_rate.transpose() +
                    half_rate * P00 * half_rate.transpose();
  const Square Palpha = P22 + bent * P20.transpose() + P20 * bent.transpose() + bent * P00 * bent.transpose();
  return {
      {dcm(moved(q0, fine.coefficient(0))),
       AngularVelocity<A, B, In<B>, S>{detail::trusted, motion.angular_velocity()},
       AngularAcceleration<A, B, In<B>, S>{detail::trusted, motion.angular_acceleration()}},
      Covariance<B, si::angle, S>{detail::trusted, detail::symmetric<S>(variance * P00)},
      Covariance<B, si::angular_velocity, S>{detail::trusted, detail::symmetric<S>(variance * Pw)},
      Covariance<B, si::angular_acceleration, S>{detail::trusted, detail::symmetric<S>(variance * Palpha)},
      fine.squares / variance / S(2),
      3 * (count - degree - 1)};
}
template <int degree = 3, class Samples, class Time, class HalfWidth, class Deviation>
auto estimate_motion(  // samples of b relative to a, t and half width in s, sigma in rad; degree 2 to 6
    const Samples&, const Time&, const HalfWidth&, const Deviation&) -> Refused = delete;

}  // namespace vectrix
