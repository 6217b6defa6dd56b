#pragma once

/// Elliptic integrals in long double, for constants of closed forms that are used over many periods.
namespace vectrix::elliptic {

/// Carlson's R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)) by duplication (Carlson 1995,
/// "Numerical computation of real or complex elliptic integrals"); x, y, z >= 0. Infinite when two are zero.
long double carlson_rf(long double x, long double y, long double z);

/// K = pi / (2 agm(1, k')), the complete integral of the first kind, from the complementary modulus k', so
/// that it is accurate as k -> 1. Infinite for k' = 0.
long double complete(long double complementary_modulus);

/// F = int_0^phi dt / sqrt(1 - k^2 sin^2 t) for |phi| <= pi/2, from sin(phi), cos(phi) and k'^2.
long double incomplete(long double sine, long double cosine, long double complementary_square);

}  // namespace vectrix::elliptic
