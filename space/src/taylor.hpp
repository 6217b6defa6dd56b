#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vectrix/frames/scalar/sine_cosine.hpp>

namespace vectrix::detail {

/// A function of time near an instant by its Taylor coefficients, x(t + h) = c_0 + c_1 h + c_2 h^2 + ...: the
/// rules follow from the coefficients of products (Griewank and Walther, Evaluating Derivatives, 2nd ed.,
/// table 13.2).
template <std::size_t order> struct Taylor {
  std::array<double, order + 1> c{};

  Taylor() = default;
  Taylor(double value) { c[0] = value; }

  Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
  Taylor& operator-=(const Taylor& b) { return *this = *this - b; }

  friend Taylor operator+(Taylor a, const Taylor& b) {
    for (std::size_t k = 0; k <= order; ++k) a.c[k] += b.c[k];
    return a;
  }
  friend Taylor operator-(Taylor a, const Taylor& b) {
    for (std::size_t k = 0; k <= order; ++k) a.c[k] -= b.c[k];
    return a;
  }
  friend Taylor operator-(const Taylor& a) { return -1.0 * a; }
  friend Taylor operator*(double a, Taylor b) {
    for (double& coefficient : b.c) coefficient *= a;
    return b;
  }
  friend Taylor operator*(const Taylor& a, double b) { return b * a; }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (std::size_t k = 0; k <= order; ++k)
      for (std::size_t i = 0; i <= k; ++i) product.c[k] += a.c[i] * b.c[k - i];
    return product;
  }
  friend Taylor operator/(const Taylor& a, const Taylor& b) {
    Taylor quotient = a;
    for (std::size_t k = 0; k <= order; ++k) {
      for (std::size_t i = 0; i < k; ++i) quotient.c[k] -= quotient.c[i] * b.c[k - i];
      quotient.c[k] /= b.c[0];
    }
    return quotient;
  }
  friend bool operator<(const Taylor& a, double b) { return a.c[0] < b; }
  friend bool operator>(const Taylor& a, double b) { return a.c[0] > b; }
  friend bool operator<=(const Taylor& a, double b) { return a.c[0] <= b; }
  friend bool operator>=(const Taylor& a, double b) { return a.c[0] >= b; }

  /// a^exponent, of which `value` is that of a_0.
  friend Taylor power(const Taylor& a, double exponent, double value) {
    Taylor result(value);
    for (std::size_t k = 1; k <= order; ++k) {
      for (std::size_t i = 0; i < k; ++i)
        result.c[k] +=
            (exponent * static_cast<double>(k - i) - static_cast<double>(i)) * a.c[k - i] * result.c[i];
      result.c[k] /= static_cast<double>(k) * a.c[0];
    }
    return result;
  }
  friend Taylor sqrt(const Taylor& a) { return power(a, 0.5, std::sqrt(a.c[0])); }
  friend Taylor sin(const Taylor& a) { return sine_cosine(a).sine; }
  friend Taylor cos(const Taylor& a) { return sine_cosine(a).cosine; }
  friend SineCosine<Taylor> sine_cosine(const Taylor& a) {
    SineCosine<Taylor> result{std::sin(a.c[0]), std::cos(a.c[0])};
    for (std::size_t k = 1; k <= order; ++k) add_coefficient(result, a, k, k);
    return result;
  }
  /// The sine and cosine of the angle u of Kepler's equation u + x cos u - y sin u = mean, of which `value`
  /// is u_0: each coefficient of u follows from those before it.
  friend SineCosine<Taylor> sine_cosine_of_kepler(const Taylor& mean, const Taylor& x, const Taylor& y,
                                                  double value) {
    Taylor u(value);
    SineCosine<Taylor> result{std::sin(value), std::cos(value)};
    const double slope = 1.0 - x.c[0] * result.sine.c[0] - y.c[0] * result.cosine.c[0];
    for (std::size_t k = 1; k <= order; ++k) {
      add_coefficient(result, u, k, k - 1);
      double left = mean.c[k];
      for (std::size_t i = 0; i <= k; ++i)
        left += y.c[i] * result.sine.c[k - i] - x.c[i] * result.cosine.c[k - i];
      u.c[k] = left / slope;
      result.sine.c[k] += u.c[k] * result.cosine.c[0];
      result.cosine.c[k] -= u.c[k] * result.sine.c[0];
    }
    return result;
  }
  friend Taylor atan2(const Taylor& y, const Taylor& x) {
    Taylor xdot, ydot;
    for (std::size_t k = 0; k < order; ++k) {
      xdot.c[k] = static_cast<double>(k + 1) * x.c[k + 1];
      ydot.c[k] = static_cast<double>(k + 1) * y.c[k + 1];
    }
    const Taylor rate = (x * ydot - y * xdot) / (x * x + y * y);
    Taylor angle(std::atan2(y.c[0], x.c[0]));
    for (std::size_t k = 1; k <= order; ++k) angle.c[k] = rate.c[k - 1] / static_cast<double>(k);
    return angle;
  }

 private:
  /// What a_1 to a_last give to coefficient k of the sine and the cosine of a.
  static void add_coefficient(SineCosine<Taylor>& to, const Taylor& a, std::size_t k, std::size_t last) {
    for (std::size_t i = 1; i <= last; ++i) {
      const double weight = static_cast<double>(i) * a.c[i] / static_cast<double>(k);
      to.sine.c[k] += weight * to.cosine.c[k - i];
      to.cosine.c[k] -= weight * to.sine.c[k - i];
    }
  }
};

}  // namespace vectrix::detail
