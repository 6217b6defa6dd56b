#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

#include <vectrix/frames/covariance.hpp>
#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/vector.hpp>

namespace vectrix {
namespace detail {

enum class ErrorKind { constant, random, drift };

/// One contribution, in rad, s and the axes of some frame. Of a drift, mean and covariance are those of its
/// rate.
struct ErrorSource {
  ErrorKind kind;
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
  double seconds;  // correlation time; time since the last update
};
/// Throws BadInput when a number is not finite or a time is not positive.
VECTRIX_EXPORT ErrorSource checked_source(const char* door, const ErrorSource& source);

}  // namespace detail

/// The error of an attitude, of type PointingError<F>: the small turn theta^f by which it is wrong, in the
/// axes of f, as the sum of independent contributions. With b, d of a normal distribution:
///     constant    theta(t) = b                             constant_error(b_f), constant_error(P_f)
///     random      cov(theta(t), theta(s)) = P e^(-|t-s|/T)   random_error(P_f, T)
///     drift       theta(t) = d t, t since the last update  drift_error(d_f, t), drift_error(Q_f, t)
/// A contribution is made in the frame in which it arises and carried along the chain:
///     1.  theta^b = R_a^b theta^a, P^b = R_a^b P^a (R_a^b)^T      R_b_from_a * e_a
///     2.  the sum claims that they are independent                e_a + f_a
/// First order in theta. absolute_error(), mean_error() and relative_error() say what it does to an axis.
template <Frame F> class PointingError {
 public:
  using frame = F;

  PointingError() = delete;  // constant_error(), random_error() or drift_error()
  PointingError(detail::Trusted, std::vector<detail::ErrorSource> sources) : sources_(std::move(sources)) {}

  template <class Operand = PointingError>
  auto operator-() const -> Refused = delete;  // an error with a sign is a Vector

  /// The contributions as bare numbers. The frame is no longer checked.
  const std::vector<detail::ErrorSource>& sources() const { return sources_; }

 private:
  std::vector<detail::ErrorSource> sources_;
};

template <class F> inline constexpr bool detail::is_framed<PointingError<F>> = true;

/// The same at all times: known, or of a covariance over all flights, as of a mounting. Throws BadInput when
/// a number is not finite.
template <Frame F> PointingError<F> constant_error(const Vector<F, si::angle>& b_f) {
  return {detail::trusted,
          {detail::checked_source("constant_error", {detail::ErrorKind::constant, b_f.coordinates(),
                                                     Eigen::Matrix3d::Zero(), 1.0})}};
}
template <Frame F> PointingError<F> constant_error(const Covariance<F, si::angle>& P_f) {
  return {detail::trusted,
          {detail::checked_source(
              "constant_error", {detail::ErrorKind::constant, Eigen::Vector3d::Zero(), P_f.matrix(), 1.0})}};
}

/// A stationary Gauss-Markov process of first order, as the noise of a sensor behind a filter. Throws
/// BadInput when a number is not finite, or the correlation time is not positive.
template <Frame F>
PointingError<F> random_error(const Covariance<F, si::angle>& P_f,
                              const Quantity<si::time>& correlation_time) {
  return {detail::trusted,
          {detail::checked_source("random_error", {detail::ErrorKind::random, Eigen::Vector3d::Zero(),
                                                   P_f.matrix(), correlation_time.value()})}};
}

/// A rate, known or of a covariance, times the time since the attitude was last updated. The figures hold at
/// the end of this time, when the error is largest; windows end there. Throws BadInput when a number is not
/// finite, or the time is not positive.
template <Frame F>
PointingError<F> drift_error(const Vector<F, si::angular_velocity>& d_f,
                             const Quantity<si::time>& since_update) {
  return {detail::trusted,
          {detail::checked_source("drift_error", {detail::ErrorKind::drift, d_f.coordinates(),
                                                  Eigen::Matrix3d::Zero(), since_update.value()})}};
}
template <Frame F>
PointingError<F> drift_error(const Covariance<F, si::angular_velocity>& Q_f,
                             const Quantity<si::time>& since_update) {
  return {detail::trusted,
          {detail::checked_source("drift_error", {detail::ErrorKind::drift, Eigen::Vector3d::Zero(),
                                                  Q_f.matrix(), since_update.value()})}};
}

// theta^b = R_a^b theta^a
template <class B, class A>
PointingError<B> product(const Dcm<B, A, double>& R_b_from_a, const PointingError<A>& e_a) {
  const Eigen::Matrix3d& R = R_b_from_a.matrix();
  std::vector<detail::ErrorSource> sources = e_a.sources();
  for (detail::ErrorSource& source : sources) {
    source.mean = R * source.mean;
    source.covariance = R * source.covariance * R.transpose();
  }
  return {detail::trusted, std::move(sources)};
}

// Independent ones.
template <class F> PointingError<F> sum(const PointingError<F>& e_f, const PointingError<F>& f_f) {
  std::vector<detail::ErrorSource> sources = e_f.sources();
  sources.insert(sources.end(), f_f.sources().begin(), f_f.sources().end());
  return {detail::trusted, std::move(sources)};
}

/// 3 contributions in Body
template <class F> std::ostream& print_framed(std::ostream& out, const PointingError<F>& e_f) {
  const std::size_t count = e_f.sources().size();
  return out << count << (count == 1 ? " contribution in " : " contributions in ") << frame_name<F>();
}

}  // namespace vectrix
