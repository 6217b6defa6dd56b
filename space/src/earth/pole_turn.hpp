#pragma once

#include <Eigen/Core>
#include <cmath>

#include "../varying.hpp"

namespace vectrix::detail {

/// The turn of a frame c relative to g whose z axis is at p = (X, Y, Z) in g, by the shortest arc:
///     R_g^c = R3(-E) R2(d) R3(E) = [1 - aX^2, -aXY, -X; -aXY, 1 - aY^2, -Y; X, Y, Z],    a = 1 / (1 + Z)
/// With u = R_g^c dp/dt the angular velocity in c is (-u2, u1, -a (X dY/dt - Y dX/dt)).
struct PoleTurn {
  Eigen::Matrix3d R_c_from_g;
  Eigen::Vector3d w_gc_c, alpha_gc_c;
};

// 1 / (1 + (1 - s)^1/2). Within 100 years of 2000 s is below 1e-4: there by its series, which waits for no
// root and no quotient. The first term left out, 7/256 s^4, is below 3e-18.
inline double per_one_and_root(double s) {
  if (s > 1e-4) return 1.0 / (1.0 + std::sqrt(1.0 - s));
  return (0.5 + s * (1.0 / 8.0)) + (s * s) * (1.0 / 16.0 + s * (5.0 / 128.0));
}

struct Pole {
  double X, Y, a, Z;
};
inline Pole pole_at(double X, double Y) {
  const double square = X * X + Y * Y, a = per_one_and_root(square);
  return {X, Y, a, 1.0 - a * square};
}
inline Eigen::Matrix3d pole_matrix(const Pole& pole) {
  const auto [X, Y, a, Z] = pole;
  Eigen::Matrix3d R_c_from_g;
  R_c_from_g << 1.0 - a * X * X, -a * X * Y, -X, -a * X * Y, 1.0 - a * Y * Y, -Y, X, Y, Z;
  return R_c_from_g;
}

[[gnu::always_inline]] inline PoleTurn pole_turn(const Varying& x, const Varying& y) {
  const auto [X, Xd, Xdd] = x;
  const auto [Y, Yd, Ydd] = y;
  const Pole pole = pole_at(X, Y);
  const double a = pole.a, per_z = 1.0 / pole.Z;
  PoleTurn turn;
  turn.R_c_from_g = pole_matrix(pole);
  const double b = X * Xd + Y * Yd;
  const double bd = Xd * Xd + Yd * Yd + X * Xdd + Y * Ydd;
  const double Zd = -b * per_z;
  const double ad = -a * a * Zd;
  // u1 = dX/dt + k X, u2 = dY/dt + k Y
  const double k = a * b * per_z;
  const double kd = (ad * b + a * bd) * per_z - k * per_z * Zd;
  const double area = X * Yd - Y * Xd;
  turn.w_gc_c = {-(Yd + k * Y), Xd + k * X, -a * area};
  turn.alpha_gc_c = {-(Ydd + kd * Y + k * Yd), Xdd + kd * X + k * Xd, -ad * area - a * (X * Ydd - Y * Xdd)};
  return turn;
}

}  // namespace vectrix::detail
