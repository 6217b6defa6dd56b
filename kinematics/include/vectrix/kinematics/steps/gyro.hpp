#pragma once

#include <optional>
#include <vectrix/kinematics/steps/coning.hpp>

namespace vectrix {

/// The reading of X, an AngularVelocity or an AngleIncrement, by a gyro with errors. It is not an X;
/// GyroErrors converts between the two.
template <class X> class Measured {
 public:
  using scalar = typename X::scalar;
  template <class Derived>
  Measured(detail::Trusted, const Eigen::MatrixBase<Derived>& coordinates) : coordinates_(coordinates) {}

  const detail::Column<scalar>& coordinates() const& { return coordinates_; }
  detail::Column<scalar> coordinates() && { return coordinates_; }

 private:
  detail::Column<scalar> coordinates_;
};

template <class X> inline constexpr bool detail::is_framed<Measured<X>> = true;

namespace detail {

/// The quantities that a gyro fixed in b measures.
template <class X> struct GyroQuantity {};
template <class A, class B, class S> struct GyroQuantity<AngularVelocity<A, B, In<B>, S>> { using body = B; };
template <class A, class B, class S> struct GyroQuantity<AngleIncrement<A, B, S>> { using body = B; };

}  // namespace detail

template <class X> std::ostream& print_framed(std::ostream& out, const Measured<X>& reading) {
  return out << "measured " << X{detail::trusted, reading.coordinates()};
}

/// Claims that the numbers of x are gyro readings, which include its errors: measured(w_ab_b),
/// measured(alpha).
template <class X, class Body = typename detail::GyroQuantity<X>::body> Measured<X> measured(const X& x) {
  return {detail::trusted, x.coordinates()};
}

/// A gyro triad fixed in b that measures
///     w_measured = (I + diag(scale) + M) w_ab^b + bias
/// M has a zero diagonal; M_ij is the angle, rad, by which the i-th sensitive axis leans towards the j-th of
/// b. (Titterton, Weston, Strapdown Inertial Navigation Technology.)
template <Frame B, class S = double> class GyroErrors {
 public:
  GyroErrors(detail::Trusted, const detail::Column<S>& bias, const detail::Square<S>& sensitivity)
      : bias_(bias), sensitivity_(sensitivity), inverse_(sensitivity.inverse()) {}

  template <class A>
  Measured<AngularVelocity<A, B, In<B>, S>> applied(const AngularVelocity<A, B, In<B>, S>& w_ab_b) const {
    return {detail::trusted, sensitivity_ * w_ab_b.coordinates() + bias_};
  }
  template <class A>
  AngularVelocity<A, B, In<B>, S> corrected(const Measured<AngularVelocity<A, B, In<B>, S>>& reading) const {
    return AngularVelocity<A, B, In<B>, S>{detail::trusted, inverse_ * (reading.coordinates() - bias_)};
  }
  /// The same for integrals over an interval of length dt.
  template <class A>
  Measured<AngleIncrement<A, B, S>> applied(const AngleIncrement<A, B, S>& alpha,
                                            const Quantity<si::time, S>& dt) const {
    return {detail::trusted, sensitivity_ * alpha.coordinates() + dt.value() * bias_};
  }
  template <class A>
  AngleIncrement<A, B, S> corrected(const Measured<AngleIncrement<A, B, S>>& count,
                                    const Quantity<si::time, S>& dt) const {
    return AngleIncrement<A, B, S>{detail::trusted, inverse_ * (count.coordinates() - dt.value() * bias_)};
  }
  template <class Given, class... Duration>
  auto corrected(  // what a gyro in b measured: a rate, or an angle increment and its dt
      const Given&, const Duration&...) const -> Refused = delete;

 private:
  detail::Column<S> bias_;
  detail::Square<S> sensitivity_;
  detail::Square<S> inverse_;
};

/// Bias, scale factor errors and misalignments (M_xy, M_xz; M_yx, M_yz; M_zx, M_zy), all small numbers.
/// Throws BadInput when one is not finite, or when |det(I + diag(scale) + M)| < 1e-3: this is not the
/// sensitivity of a gyro triad.
template <Frame B, class S>
GyroErrors<B, S> gyro_errors(const Vector<B, si::angular_velocity, S>& bias_b,
                             const Vector<B, si::dimensionless, S>& scale_b,
                             const Eigen::Matrix<S, 3, 2>& misalignment) {
  detail::Square<S> sensitivity = detail::Square<S>::Identity();
  for (Eigen::Index row = 0; row < 3; ++row) {
    sensitivity(row, row) += scale_b.coordinates()(row);
    sensitivity(row, row == 0 ? 1 : 0) = misalignment(row, 0);
    sensitivity(row, row == 2 ? 1 : 2) = misalignment(row, 1);
  }
  const std::string place = "gyro_errors(in " + frame_name<B>() + "): ";
  if (!detail::all_finite(sensitivity) || !detail::all_finite(bias_b.coordinates())) {
    const detail::Column<S> bias = bias_b.coordinates();
    throw BadInput(place + (detail::all_finite(bias) ? "of the sensitivity " + detail::not_finite(sensitivity)
                                                     : "of the bias " + detail::not_finite(bias)));
  }
  using std::abs;
  const S determinant = sensitivity.determinant();
  if (!detail::all(abs(determinant) >= detail::number<S>(1e-3))) {
    throw BadInput(place + "the determinant of the sensitivity is " + detail::text(determinant));
  }
  return {detail::trusted, bias_b.coordinates(), sensitivity};
}

/// The attitude q_b^a propagated with the counts of a gyro triad in b. The errors are removed from each
/// count; then it is corrected for coning with the previous count. Order and coning drift as
/// coning_corrected_after(), order 3, for intervals of any length.
template <Frame A, Frame B, class S = double> class GyroAttitude {
 public:
  GyroAttitude(const Quaternion<A, B, S>& start_a_from_b, const GyroErrors<B, S>& errors)
      : q_a_from_b_(start_a_from_b), errors_(errors) {}

  /// Takes the count of the next interval. Throws BadInput when the count is not finite, dt is not
  /// positive, or its ratio to the dt before overflows; then the attitude stays as it was.
  void add(const Measured<AngleIncrement<A, B, S>>& count, const Quantity<si::time, S>& dt) {
    detail::require_positive_duration<A, B>(dt.value(), "GyroAttitude::add");
    const Interval now{errors_.corrected(count, dt), dt};
    const Interval before = last_.value_or(now);
    q_a_from_b_ = advance(q_a_from_b_, coning_corrected_after(before.alpha, before.dt, now.alpha, now.dt));
    last_ = now;
  }
  template <class Count>
  void add(  // measured(alpha): the measured angle increment of b relative to a, and its dt
      const Count&, const Quantity<si::time, S>&) = delete;

  /// The norm is 1 to a few rounding units after any number of counts.
  const Quaternion<A, B, S>& attitude() const { return q_a_from_b_; }

 private:
  struct Interval {
    AngleIncrement<A, B, S> alpha;
    Quantity<si::time, S> dt;
  };

  Quaternion<A, B, S> q_a_from_b_;
  GyroErrors<B, S> errors_;
  std::optional<Interval> last_;
};

}  // namespace vectrix
