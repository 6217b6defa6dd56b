#include <vectrix/dynamics/rigid/free_rotation.hpp>

#include <cmath>
#include <numbers>

#include "free_rotation_series.hpp"
#include "quaternion_numbers.hpp"

namespace vectrix::detail {
namespace {

/// exp(i angle) of an angle in turns; whole turns are removed in long double.
std::complex<double> unit_complex(long double turns) {
  const double angle = 2.0 * std::numbers::pi * static_cast<double>(turns - std::rint(turns));
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

JacobiNumbers DirectSeries::at(long double seconds) const {
  const std::complex<double> unit = unit_complex(start + rate * seconds);
  const double c1 = unit.real(), s1 = unit.imag();
  const double c2 = 1.0 - 2.0 * s1 * s1, s2 = 2.0 * s1 * c1;
  const double c3 = c1 * c2 - s1 * s2, s3 = s1 * c2 + c1 * s2;
  const double c4 = 1.0 - 2.0 * s2 * s2, s4 = 2.0 * s2 * c2;
  const double c5 = c3 * c2 - s3 * s2, s5 = s3 * c2 + c3 * s2;
  const double c6 = c4 * c2 - s4 * s2;
  const double theta_odd = even[0] * c2 + even[2] * c6;
  const double theta_even = 1.0 + even[1] * c4;
  const double theta4 = theta_even - theta_odd;
  return {sn_factor * (s1 - odd[0] * s3 + odd[1] * s5) / theta4,
          cn_factor * (c1 + odd[0] * c3 + odd[1] * c5) / theta4,
          dn_factor * (theta_even + theta_odd) / theta4,
          unit_complex(half_turn_rate * seconds) *
              std::complex<double>(1.0 - cosine[0] * c2 + cosine[1] * c4, sine[1] * s4 - sine[0] * s2)};
}

JacobiNumbers ComplementarySeries::at(long double seconds) const {
  const long double u = start + rate * seconds;
  const long double count = std::rint(u / interval);
  const long double reduced = count == 0.0L ? u : u - count * interval;
  const double v = to_v * static_cast<double>(std::abs(reduced));
  const double root_x = std::exp(-v), x = root_x * root_x;
  const double root_y = std::exp(v - largest_v), y = root_y * root_y;

  // theta_1 and theta_2 divided by q'^(1/4) e^v; theta_3 and theta_4; all at i v'
  double theta1 = 0.0, theta2 = 0.0, theta3 = 1.0, theta4 = 1.0, sign = 1.0;
  double x_power = x, y_power = 1.0;
  for (std::size_t n = 0; n < odd.size(); ++n) {
    theta1 += sign * (even[n] * y_power - odd[n] * x_power);
    theta2 += even[n] * y_power + odd[n] * x_power;
    y_power *= y;
    sign = -sign;
    const double term = odd[n] * y_power + even[n + 1] * x_power;
    theta3 += term;
    theta4 += sign * term;
    x_power *= x;
  }
  // theta_2(a + i v/2 | q'^(1/2)) divided by q'^(1/8) e^(v/2). Its terms: root_nome^(n^2) root_y^n and
  // root_nome^(n (n + 1)) root_x^(n + 1)
  double real = 0.0, imaginary = 0.0, up = 1.0, down = root_x;
  for (std::size_t n = 0; n < cosine.size(); ++n) {
    real += cosine[n] * (up + down);
    imaginary -= sine[n] * (up - down);
    up *= root_y;
    down *= root_x * root_nome;
  }
  const double direction = reduced < 0.0L ? -1.0 : 1.0;
  const double parity = std::remainder(count, 2.0L) == 0.0L ? 1.0 : -1.0;
  const std::complex<double> turned =
      unit_complex(half_turn_rate * seconds + half_turn_per_u * reduced + count * half_turn_interval);
  return {parity * direction * sn_factor * theta1 / theta2, parity * cn_factor * root_x * theta4 / theta2,
          dn_factor * root_x * theta3 / theta2, turned * std::complex<double>(real, direction * imaginary)};
}

std::array<double, 4> turn_of_momentum(const FreeRotationSeries& body, const JacobiNumbers& now) {
  const double x = body.unit_momentum[0] * now.cn;
  const double y = body.unit_momentum[1] * now.sn;
  const double z = 1.0 + body.unit_momentum[2] * now.dn;
  const double re = now.half_turn.real(), im = now.half_turn.imag();
  const double scale = 1.0 / std::sqrt((re * re + im * im) * (x * x + y * y + z * z));
  return {scale * re * z, scale * (re * y + im * x), scale * (im * y - re * x), scale * im * z};
}

FreeRotation::FreeRotation(const Eigen::Matrix3d& J_b, const std::array<double, 4>& q_i_from_b,
                           const Eigen::Vector3d& w_ib_b)
    : series_(std::make_shared<FreeRotationSeries>(
          free_rotation_series(principal_body(J_b, w_ib_b), q_i_from_b))) {}

RotationNumbers FreeRotation::at(long double seconds_since_epoch) const {
  const FreeRotationSeries& body = *series_;
  const JacobiNumbers now = body.at(seconds_since_epoch);
  const std::array<double, 3> of{now.cn, now.sn, now.dn};
  RotationNumbers numbers{};
  for (std::size_t column = 0; column < 3; ++column) {
    const double along = body.rate_amplitude[column] * of[column];
    for (std::size_t row = 0; row < 3; ++row) numbers.w[row] += body.axes[3 * column + row] * along;
  }
  numbers.q = product(product(body.before, turn_of_momentum(body, now)), body.after);
  return numbers;
}

Regime FreeRotation::regime() const {
  return series_->regime;
}
double FreeRotation::period() const {
  return series_->period;
}
double FreeRotation::smallest_moment() const {
  return series_->smallest_moment;
}

}  // namespace vectrix::detail
