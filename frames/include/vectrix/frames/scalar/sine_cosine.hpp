#pragma once

#include <cmath>
#include <type_traits>
#include <vectrix/frames/scalar/batch.hpp>

namespace vectrix::detail {

template <class S> struct SineCosine {
  S sine;
  S cosine;
};

/// Above it the quarter turns of a batch's angle cannot be taken off in three exact steps.
inline constexpr double batch_angle_limit = 1e6;

/// sin x and cos x of a batch of doubles, |x| <= batch_angle_limit: x less the nearest n quarter turns, with
/// pi/2 in three parts, the first two of 33 bits so that n times them is exact (Cody and Waite 1980, chapter
/// 8), then the series of both, whose first terms left out are below 1e-17.
template <Batch S> SineCosine<S> sine_cosine_by_series(const S& x) {
  using std::abs;
  const auto nearest = [](const S& y) { return (y + S(0x1.8p52)) - S(0x1.8p52); };
  const S n = nearest(x * S(0x1.45f306dc9c883p-1));
  const S r = ((x - n * S(0x1.921fb544p+0)) - n * S(0x1.0b4611a6p-34)) - n * S(0x1.3198a2e037073p-69);
  const S z = r * r;
  const auto series = [&z](auto... coefficients) {  // the highest first
    S sum(0.0);
    ((sum = sum * z + S(coefficients)), ...);
    return sum;
  };
  const S s = r + r * z *
                      series(1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
                             1 / 362880.0, -1 / 5040.0, 1 / 120.0, -1 / 6.0);
  const S c = S(1.0) + z * series(-1 / 6402373705728000.0, 1 / 20922789888000.0, -1 / 87178291200.0,
                                  1 / 479001600.0, -1 / 3628800.0, 1 / 40320.0, -1 / 720.0, 1 / 24.0, -0.5);
  const S quarter = n - S(4.0) * nearest(n * S(0.25));  // -2 and 2 are the same
  const auto odd = abs(quarter) == S(1.0);
  const S half = S(1.0) - abs(quarter);  // -1 of half a turn
  return {select(odd, S(c * quarter), S(s * half)), select(odd, S(-s * quarter), S(c * half))};
}

/// sin x and cos x; of an infinity, what is no number.
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
