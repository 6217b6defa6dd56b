#pragma once

#include <array>
#include <complex>
#include <variant>
#include <vectrix/dynamics/rigid/free_rotation.hpp>

#include "principal_axes.hpp"

namespace vectrix::detail {

/// The Jacobi functions at one instant, and exp(i Phi/2) times a positive number.
struct JacobiNumbers {
  double sn, cn, dn;
  std::complex<double> half_turn;
};

/// By theta functions of the nome q = exp(-pi K'/K), for k^2 <= 1/2, where q < 0.0433; in v = pi u / (2 K).
/// Phi/2 is a steady turn plus arg theta_4(v - i eta | q^2), whose terms are (-1)^n times
///     (P_n + M_n) cos 2nv + i (P_n - M_n) sin 2nv,   P_n = q^(2 n^2) (z/q)^n,  M_n = q^(2 n^2) (q/z)^n
/// with z = q e^(2 eta) in [q, 1]. The omitted terms are below 1e-16.
struct DirectSeries {
  double sn_factor, cn_factor, dn_factor;
  std::array<double, 3> even;    ///< 2 q^(n^2), n = 1 ...
  std::array<double, 2> odd;     ///< q^(n (n + 1)), n = 1 ...
  std::array<double, 2> cosine;  ///< P_n + M_n
  std::array<double, 2> sine;    ///< P_n - M_n
  long double start, rate;       ///< of v, in turns
  long double half_turn_rate;    ///< mean rate of Phi/2, in turns

  [[nodiscard]] JacobiNumbers at(long double seconds) const;
};

/// By theta functions of the complementary nome q' = exp(-pi K/K'), for k^2 > 1/2; in v' = pi u / (2 K') with
/// u reduced to [-K, K], and with theta_2(a + i v'/2 | q'^(1/2)) for Phi/2. Products such as q'^(n^2)
/// e^(2n|v'|) are written as powers of x = e^(-2|v'|) and y = q'/x, both at most 1: nothing overflows as k ->
/// 1. For q' = 0, the separatrix, they are the hyperbolic functions.
struct ComplementarySeries {
  double sn_factor, cn_factor, dn_factor;
  std::array<double, 4> odd;     ///< q'^(n (n + 1)), n = 0 ...
  std::array<double, 5> even;    ///< q'^(n^2), n = 0 ...
  std::array<double, 5> cosine;  ///< q'^(n^2 / 2) cos((2n + 1) a), n = 0 ...
  std::array<double, 5> sine;    ///< q'^(n^2 / 2) sin((2n + 1) a)
  double root_nome;              ///< q'^(1/2)
  long double start, rate;       ///< of u
  long double interval;          ///< 2 K
  double to_v;                   ///< pi / (2 K')
  double largest_v;              ///< pi K / (2 K')
  long double
      half_turn_rate;  ///< rate of Phi/2 where dn = 1, in turns per second: u is slow in a near sphere
  long double half_turn_per_u;     ///< what the poles add, in turns, without theta_2
  long double half_turn_interval;  ///< what they add over 2 K, in turns, with theta_2

  [[nodiscard]] JacobiNumbers at(long double seconds) const;
};

struct FreeRotationSeries {
  std::variant<DirectSeries, ComplementarySeries> functions;
  std::array<double, 3> rate_amplitude;  ///< w^p = (r1 cn, r2 sn, r3 dn)
  std::array<double, 3> unit_momentum;   ///< h^p / |h|, with cn, sn, dn as above
  std::array<double, 9> axes;            ///< R_p^b by columns
  std::array<double, 4> before, after;   ///< q_b^i = before q_z(Phi) s(h)* after
  Regime regime;
  double period;
  double smallest_moment;

  [[nodiscard]] JacobiNumbers at(long double seconds) const {
    return std::visit([&](const auto& series) { return series.at(seconds); }, functions);
  }
};

/// q_z(Phi) s(h)*, with s(h) the shortest rotation of the third axis onto h.
std::array<double, 4> turn_of_momentum(const FreeRotationSeries& body, const JacobiNumbers& now);

FreeRotationSeries free_rotation_series(const PrincipalBody& body, const std::array<double, 4>& q_i_from_b);

}  // namespace vectrix::detail
