#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <ostream>
#include <type_traits>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// A number and its derivative along one direction, x + x' e with e^2 = 0: what a function of duals gives is
/// its value and its exact derivative. Each operation has its result at once, so that `auto` is safe, which
/// it is not with the expressions of Eigen::AutoDiffScalar. Comparisons are those of the values.
class VECTRIX_EXPORT Dual {
 public:
  constexpr Dual() = default;
  template <class T>
    requires std::is_arithmetic_v<T>
  constexpr Dual(const T& value) : value_(static_cast<double>(value)) {}
  constexpr Dual(double value, double derivative) : value_(value), derivative_(derivative) {}

  constexpr double value() const { return value_; }
  constexpr double derivatives() const { return derivative_; }  ///< the one that there is

  constexpr Dual operator-() const { return {-value_, -derivative_}; }
  constexpr Dual operator+() const { return *this; }
  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    return {a.value_ + b.value_, a.derivative_ + b.derivative_};
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    return {a.value_ - b.value_, a.derivative_ - b.derivative_};
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return {a.value_ * b.value_, a.derivative_ * b.value_ + a.value_ * b.derivative_};
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value_ / b.value_;
    return {quotient, (a.derivative_ - quotient * b.derivative_) / b.value_};
  }
  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }
  friend constexpr auto operator<=>(const Dual& a, const Dual& b) { return a.value_ <=> b.value_; }

  friend Dual abs(const Dual& x) { return std::signbit(x.value_) ? -x : x; }
  friend Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value_);
    return {root, 0.5 * x.per(root)};
  }
  friend Dual cbrt(const Dual& x) {
    const double root = std::cbrt(x.value_);
    return {root, x.per(3.0 * root * root)};
  }
  friend Dual sin(const Dual& x) { return {std::sin(x.value_), std::cos(x.value_) * x.derivative_}; }
  friend Dual cos(const Dual& x) { return {std::cos(x.value_), -std::sin(x.value_) * x.derivative_}; }
  friend Dual tan(const Dual& x) {
    const double tangent = std::tan(x.value_);
    return {tangent, (1.0 + tangent * tangent) * x.derivative_};
  }
  friend Dual asin(const Dual& x) {
    return {std::asin(x.value_), x.per(std::sqrt((1.0 - x.value_) * (1.0 + x.value_)))};
  }
  friend Dual acos(const Dual& x) {
    return {std::acos(x.value_), -x.per(std::sqrt((1.0 - x.value_) * (1.0 + x.value_)))};
  }
  friend Dual atan(const Dual& x) {
    return {std::atan(x.value_), x.derivative_ / (1.0 + x.value_ * x.value_)};
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double square = x.value_ * x.value_ + y.value_ * y.value_;
    const bool moves = x.derivative_ != 0.0 || y.derivative_ != 0.0;
    return {std::atan2(y.value_, x.value_),
            moves ? (x.value_ * y.derivative_ - y.value_ * x.derivative_) / square : 0.0};
  }
  friend Dual exp(const Dual& x) {
    const double e = std::exp(x.value_);
    return {e, e * x.derivative_};
  }
  friend Dual expm1(const Dual& x) { return {std::expm1(x.value_), std::exp(x.value_) * x.derivative_}; }
  friend Dual log(const Dual& x) { return {std::log(x.value_), x.derivative_ / x.value_}; }
  friend Dual sinh(const Dual& x) { return {std::sinh(x.value_), std::cosh(x.value_) * x.derivative_}; }
  friend Dual cosh(const Dual& x) { return {std::cosh(x.value_), std::sinh(x.value_) * x.derivative_}; }
  friend Dual tanh(const Dual& x) {
    const double t = std::tanh(x.value_);
    return {t, (1.0 - t) * (1.0 + t) * x.derivative_};
  }
  friend Dual pow(const Dual& x, double power) {
    return {std::pow(x.value_, power), x.derivative_ == 0.0 || power == 0.0
                                           ? 0.0
                                           : power * std::pow(x.value_, power - 1.0) * x.derivative_};
  }
  friend bool isfinite(const Dual& x) { return std::isfinite(x.value_) && std::isfinite(x.derivative_); }

  friend std::ostream& operator<<(std::ostream& out, const Dual& x) { return out << x.value_; }

 private:
  /// The derivative over d; zero where there is no slope, d = 0, and it does not move.
  constexpr double per(double d) const { return d == 0.0 && derivative_ == 0.0 ? 0.0 : derivative_ / d; }

  double value_ = 0.0, derivative_ = 0.0;
};

}  // namespace vectrix

namespace Eigen {

template <> struct NumTraits<vectrix::Dual> : NumTraits<double> {
  using Real = vectrix::Dual;
  using NonInteger = vectrix::Dual;
  using Nested = vectrix::Dual;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 6
  };
};
template <class Operation> struct ScalarBinaryOpTraits<vectrix::Dual, double, Operation> {
  using ReturnType = vectrix::Dual;
};
template <class Operation> struct ScalarBinaryOpTraits<double, vectrix::Dual, Operation> {
  using ReturnType = vectrix::Dual;
};

}  // namespace Eigen
