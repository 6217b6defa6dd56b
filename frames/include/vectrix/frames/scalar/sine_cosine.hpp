#pragma once

#include <cmath>
#include <type_traits>
#include <utility>
#include <vectrix/frames/scalar/batch.hpp>

namespace vectrix::detail {

template <class S> struct SineCosine {
  S sine;
  S cosine;
};

/// Largest angle, rad, from which quarter turns can be subtracted in three exact steps.
inline constexpr double batch_angle_limit = 1e6;

/// sin x and cos x of a batch of doubles, |x| <= batch_angle_limit. Subtracts the nearest n quarter turns
/// from x, with pi/2 in three parts. The first two have 33 bits, so that n times them is exact (Cody and
/// Waite 1980, chapter 8). Then the series of sine and cosine; the first omitted terms are below 1e-17.
template <Batch S> SineCosine<S> sine_cosine_by_series(const S& x) {
  using std::abs;
  const auto nearest = [](const S& y) { return (y + S(0x1.8p52)) - S(0x1.8p52); };
  const S n = nearest(x * S(0x1.45f306dc9c883p-1));
  const S r = ((x - n * S(0x1.921fb544p+0)) - n * S(0x1.0b4611a6p-34)) - n * S(0x1.3198a2e037073p-69);
  const S z = r * r, z2 = z * z;
  // Highest power first. Even and odd powers are independent sums, which takes half as long.
  const auto series = [&z, &z2](double highest, double next, auto... coefficients) {
    S sum(next), other(highest);
    ((other = std::exchange(sum, S(other * z2 + S(coefficients)))), ...);
    return S(sum + other * z);
  };
  const S s = r + r * z *
                      series(1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
                             1 / 362880.0, -1 / 5040.0, 1 / 120.0, -1 / 6.0);
  const S c = S(1.0) + z * series(-1 / 6402373705728000.0, 1 / 20922789888000.0, -1 / 87178291200.0,
                                  1 / 479001600.0, -1 / 3628800.0, 1 / 40320.0, -1 / 720.0, 1 / 24.0, -0.5);
  const S quarter = n - S(4.0) * nearest(n * S(0.25));  // -2 and 2 are equivalent
  const auto odd = abs(quarter) == S(1.0);
  const S half = S(1.0) - abs(quarter);  // -1 for half a turn
  return {select(odd, S(c * quarter), S(s * half)), select(odd, S(-s * quarter), S(c * half))};
}

/// sin x and cos x; NaN for infinities.
template <class S> SineCosine<S> sine_cosine(const S& x) {
  using std::abs;
  using std::cos;
  using std::sin;
  if constexpr (Batch<S>) {
    if (!all(abs(x) <= number<S>(batch_angle_limit))) {
      return {each_lane(x, [](auto angle) { return sin(angle); }),
              each_lane(x, [](auto angle) { return cos(angle); })};
    }
    if constexpr (std::is_same_v<typename S::value_type, double>) return sine_cosine_by_series(x);
  }
  return {S(sin(x)), S(cos(x))};
}

}  // namespace vectrix::detail
