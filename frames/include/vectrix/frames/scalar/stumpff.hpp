#pragma once

#include <cmath>
#include <vectrix/frames/scalar/sine_cosine.hpp>

namespace vectrix::detail {

/// Stumpff's functions of x = |theta|^2, c_k = 1/k! - x/(k+2)! + x^2/(k+4)! - ..., so that c_0 = cos |theta|
/// and c_1 = sin |theta| / |theta|. Every power series of a skew matrix reduces to them:
///     1.  c_k = 1/k! - x c_(k+2)      2.  d_k = 2 dc_k/dx = k c_(k+2) - c_(k+1) = (c_(k-1) - k c_k) / x
/// Accurate to rounding for every angle. For large x the last form of d_k is used, because in the first
/// c_(k+2) and c_(k+1) nearly cancel.
template <class S> struct Stumpff { S c2, c3, d2, d3; };

/// 1 - x/((k+1)(k+2)) + x^2/((k+1)...(k+4)) - ...; for x < 9 the first omitted term is below 1e-22.
template <int k, class S> S stumpff_series(const S& x) {
  S sum = S(1);
  for (int n = k + 28; n > k; n -= 2) sum = S(1) - x * (S(1) / S(n * (n - 1)) * sum);
  return sum;
}
template <class S> Stumpff<S> stumpff_by_series(const S& x) {
  const S c4 = stumpff_series<4>(x) / S(24);
  const S c5 = stumpff_series<5>(x) / S(120);
  const S c3 = S(1) / S(6) - x * c5;
  return {S(1) / S(2) - x * c4, c3, S(2) * c4 - c3, S(3) * c5 - c4};
}
template <class S> Stumpff<S> stumpff_by_sine(const S& x) {
  using std::sqrt;
  const S angle = sqrt(x);
  const auto [s, c] = sine_cosine<S>(angle / S(2));
  const S c2 = S(2) * (s / angle) * (s / angle);  // not 1 - cos, whose digits cancel near a full turn
  const S c1 = S(2) * s * c / angle;
  const S c3 = (S(1) - c1) / x;
  return {c2, c3, (c1 - S(2) * c2) / x, (c2 - S(3) * c3) / x};
}
template <class S> Stumpff<S> stumpff(const S& x) {
  Stumpff<S> c = stumpff_by_series(x);
  if (const auto small = x < S(9); !all(small)) {
    const Stumpff<S> other = stumpff_by_sine(x);
    c = {select(small, c.c2, other.c2), select(small, c.c3, other.c3), select(small, c.d2, other.d2),
         select(small, c.d3, other.d3)};
  }
  return c;
}

}  // namespace vectrix::detail
