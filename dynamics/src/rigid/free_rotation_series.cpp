#include "free_rotation_series.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "elliptic.hpp"
#include "quaternion_numbers.hpp"

namespace vectrix::detail {
namespace {

using Real = long double;
using Vector = PrincipalBody::Vector;
constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real infinity = std::numeric_limits<Real>::infinity();

Real power(Real base, std::size_t exponent) {
  Real result = 1.0L;
  for (; exponent > 0; --exponent) result *= base;
  return result;
}
double narrow(Real x) {
  return static_cast<double>(x);
}
std::array<double, 3> narrow(const Vector& x) {
  return {narrow(x.x()), narrow(x.y()), narrow(x.z())};
}

/// The body in axes ordered so that h goes around the third one. The signs are such that h3 > 0 and h1 >= 0
/// at the epoch. The formulas use the distances |H^2 - 2 T J_i| and |J_i - J_j|, and so contain no
/// difference.
struct Polhode {
  explicit Polhode(const PrincipalBody& body) {
    const Eigen::Index last = body.nearer_first ? 0 : 2;
    const Eigen::Index first = 2 - last;
    sign = body.nearer_first ? -1.0L : 1.0L;
    const Vector flip(body.rate(first) < 0.0L ? -1.0L : 1.0L, 1.0L, body.rate(last) < 0.0L ? -1.0L : 1.0L);
    axes.col(0) = flip(0) * body.axes.col(first);
    axes.col(2) = flip(2) * body.axes.col(last);
    axes.col(1) = sign * flip(0) * flip(2) * body.axes.col(1);
    w << flip(0) * body.rate(first), sign * flip(0) * flip(2) * body.rate(1), flip(2) * body.rate(last);
    J << body.moments(first), body.moments(1), body.moments(last);
    J21 = body.nearer_first ? body.J32 : body.J21;
    J32 = body.nearer_first ? body.J21 : body.J32;
    J31 = body.J31;
    H = body.momentum;
    near1 = body.distance(first);
    near2 = body.distance(1);
    near3 = body.distance(last);
    rho = std::sqrt(J32 * near1 / (J(0) * J(1) * J(2)));
    square = J21 * near3 / (J32 * near1);
    complementary_square = J31 * near2 / (J32 * near1);
    rate = {std::sqrt(near3 / (J(0) * J31)), std::sqrt(near3 / (J(1) * J32)),
            std::sqrt(near1 / (J(2) * J31))};
  }

  /// u at the epoch, from cn(u) : sn(u).
  Real start() const {
    const Real cosine = w.x() * std::sqrt(J(0) * J31);
    const Real sine = w.y() * std::sqrt(J(1) * J32);
    const Real length = std::hypot(cosine, sine);
    return elliptic::incomplete(sine / length, cosine / length, complementary_square);
  }
  /// d(Phi/2)/dt where dn = 1:  Phi' = H/J3 + (2 T - H^2/J3) / (H (1 + h3)), with h scaled to length 1
  Real half_turn_rate() const {
    return (H / J(2) + sign * near3 / (H * J(2)) / (1.0L + J(2) * rate.z() / H)) / 2.0L;
  }
  /// y with sn^2(y | k') = J1 (J3 - J2) / (J2 (J3 - J1)): the poles of Phi' are at u = +- i (2 K' - y).
  Real pole() const {
    const Real sine = J(0) * J32 / (J(1) * J31);
    const Real cosine = J(2) * J21 / (J(1) * J31);
    return std::sqrt(sine) * elliptic::carlson_rf(cosine, cosine + square * sine, 1.0L);
  }
  /// K' - y, from sn(K' - y | k') = h3 / H where dn = 1.
  Real pole_from_quarter_period() const {
    const Real h3 = J(2) * rate.z() / H;
    return h3 * elliptic::carlson_rf(J(0) * near3 / (J31 * H * H), J(1) * near3 / (J32 * H * H), 1.0L);
  }

  Real sign;
  Eigen::Matrix<Real, 3, 3> axes;
  Vector w, J, rate;
  Real J21, J32, J31, H, near1, near2, near3;
  Real rho, square, complementary_square;
};

struct Periods {
  Real K, K_complement;
};

DirectSeries direct_series(const Polhode& body, const Periods& of) {
  const Real q = std::exp(-pi * of.K_complement / of.K);
  const Real z = std::exp(-pi * body.pole_from_quarter_period() / of.K);
  const Real q_over_z = std::exp(-pi * body.pole() / of.K);
  DirectSeries series;
  Real odd = 1.0L, all = 1.0L, alternating = 1.0L;
  for (std::size_t n = 1; n <= 3; ++n) {
    series.even[n - 1] = narrow(2.0L * power(q, n * n));
    odd += power(q, n * (n + 1));
    all += 2.0L * power(q, n * n);
    alternating += (n % 2 == 0 ? 2.0L : -2.0L) * power(q, n * n);
  }
  series.sn_factor = narrow(all / odd);
  series.cn_factor = narrow(alternating / odd);
  series.dn_factor = narrow(alternating / all);

  Real theta = 1.0L, derivative = 0.0L, sign = 1.0L;
  for (std::size_t n = 1; n <= 3; ++n) {
    sign = -sign;
    const Real P = power(q, 2 * n * n - n) * power(z, n);
    const Real M = power(q, 2 * n * n) * power(q_over_z, n);
    theta += sign * (P + M);
    derivative += sign * 2.0L * static_cast<Real>(n) * (P - M);
    if (n > 2) continue;
    series.odd[n - 1] = narrow(power(q, n * (n + 1)));
    series.cosine[n - 1] = narrow(P + M);
    series.sine[n - 1] = narrow(P - M);
  }
  const Real v_rate = body.sign * pi * body.rho / (2.0L * of.K);
  series.start = body.start() / (4.0L * of.K);
  series.rate = v_rate / (2.0L * pi);
  series.half_turn_rate = (body.half_turn_rate() - v_rate * derivative / theta) / (2.0L * pi);
  return series;
}

ComplementarySeries complementary_series(const Polhode& body, const Periods& of) {
  const Real ratio = pi * of.K / of.K_complement;
  const Real q = std::exp(-ratio);
  const Real root = std::exp(-ratio / 2.0L);
  const Real a = pi * body.pole() / (4.0L * of.K_complement);
  ComplementarySeries series;
  Real odd = 0.0L, all = 1.0L, alternating = 1.0L, theta = 0.0L, derivative = 0.0L, re = 0.0L, im = 0.0L;
  for (std::size_t n = 0; n < 5; ++n) {
    const Real multiple = static_cast<Real>(2 * n + 1);
    const Real cosine = power(root, n * n) * std::cos(multiple * a);
    const Real sine = power(root, n * n) * std::sin(multiple * a);
    series.even[n] = narrow(power(q, n * n));
    series.cosine[n] = narrow(cosine);
    series.sine[n] = narrow(sine);
    theta += power(root, n) * cosine;
    derivative += power(root, n) * multiple * sine;
    // At v' = pi K / (2 K'), where x = q' and y = 1.
    re += cosine * (1.0L + power(root, 2 * n + 1));
    im -= sine * (1.0L - power(root, 2 * n + 1));
    if (n < 4) {
      series.odd[n] = narrow(power(q, n * (n + 1)));
      odd += power(q, n * (n + 1));
    }
    if (n > 0) {
      all += 2.0L * power(q, n * n);
      alternating += (n % 2 == 0 ? 2.0L : -2.0L) * power(q, n * n);
    }
  }
  series.sn_factor = narrow(all / alternating);
  series.cn_factor = narrow(2.0L * odd / alternating);
  series.dn_factor = narrow(2.0L * odd / all);
  series.root_nome = narrow(root);
  series.start = body.start();
  series.rate = body.sign * body.rho;
  series.interval = 2.0L * of.K;
  series.to_v = narrow(pi / (2.0L * of.K_complement));
  series.largest_v = narrow(ratio / 2.0L);
  const Real per_u = pi / (4.0L * of.K_complement) * derivative / theta;
  series.half_turn_rate = body.half_turn_rate() / (2.0L * pi);
  series.half_turn_per_u = per_u / (2.0L * pi);
  series.half_turn_interval = of.K < infinity ? (per_u * of.K + std::atan2(im, re)) / pi : 0.0L;
  return series;
}

/// A spin about a fixed axis, or rest: the third axis is along w.
DirectSeries even_turn(Real speed) {
  DirectSeries series{};
  series.sn_factor = series.cn_factor = series.dn_factor = 1.0;
  series.half_turn_rate = speed / (4.0L * pi);
  return series;
}

}  // namespace

FreeRotationSeries free_rotation_series(const PrincipalBody& body, const std::array<double, 4>& q_i_from_b) {
  FreeRotationSeries series{};
  series.smallest_moment = narrow(body.moments(0));
  if (!(series.smallest_moment > 0.0)) return series;  // not a body; the caller throws
  Eigen::Matrix<Real, 3, 3> axes;
  if (body.steady) {
    const Vector w_b = body.axes * body.rate;
    const Real speed = w_b.stableNorm();
    const Vector direction = speed > 0.0L ? w_b : Vector::UnitZ();
    axes = Eigen::Quaternion<Real>::FromTwoVectors(Vector::UnitZ(), direction).toRotationMatrix();
    series.functions = even_turn(speed);
    series.rate_amplitude = {0.0, 0.0, narrow(speed)};
    series.unit_momentum = {0.0, 0.0, 1.0};
    series.regime = speed == 0.0L ? Regime::at_rest : Regime::steady;
    series.period = narrow(infinity);
  } else {
    const Polhode polhode(body);
    const Periods of{elliptic::complete(std::sqrt(polhode.complementary_square)),
                     elliptic::complete(std::sqrt(polhode.square))};
    axes = polhode.axes;
    if (polhode.square <= 0.5L) {
      series.functions = direct_series(polhode, of);
    } else {
      series.functions = complementary_series(polhode, of);
    }
    series.rate_amplitude = narrow(polhode.rate);
    series.unit_momentum = narrow(Vector(polhode.J.cwiseProduct(polhode.rate) / polhode.H));
    series.regime = polhode.near2 == 0.0L ? Regime::separatrix
                    : body.nearer_first   ? Regime::long_axis
                                          : Regime::short_axis;
    series.period = narrow(4.0L * of.K / polhode.rho);
  }
  for (Eigen::Index i = 0; i < 9; ++i) series.axes[static_cast<std::size_t>(i)] = narrow(axes(i % 3, i / 3));

  // q_b^i = q_b^i(0) q_p^b (q_z(Phi) s(h)*)(0)^-1 (q_z(Phi) s(h)*)(t) q_b^p
  const Eigen::Quaternion<Real> p(axes);
  const std::array<double, 4> q_b_from_p{narrow(p.w()), narrow(p.x()), narrow(p.y()), narrow(p.z())};
  const std::array<double, 4> turned = turn_of_momentum(series, series.at(0.0L));
  const auto conjugate = [](const std::array<double, 4>& q) {
    return std::array<double, 4>{q[0], -q[1], -q[2], -q[3]};
  };
  series.before = product(product(q_i_from_b, q_b_from_p), conjugate(turned));
  series.after = conjugate(q_b_from_p);
  return series;
}

}  // namespace vectrix::detail
