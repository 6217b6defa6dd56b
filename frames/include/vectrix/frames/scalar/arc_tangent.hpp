#pragma once

#include <cmath>
#include <type_traits>
#include <vectrix/frames/scalar/batch.hpp>

namespace vectrix::detail {

/// (atan(t) - t) / t^3 from z = t^2 for |t| <= tan(pi/8), by the minimax polynomial for the relative error of
/// atan, 1.3e-18. Evaluated in pairs, which are independent.
template <class S> S arc_tangent_series(const S& z) {
  const auto pair = [&z](double constant, double linear) {
    return number<S>(constant) + number<S>(linear) * z;
  };
  const S z2 = z * z, z4 = z2 * z2;
  const S first = pair(-0.3333333333333319616, 0.199999999999532457) +
                  z2 * pair(-0.142857142801664609, 0.1111111078215209181);
  const S second = pair(-0.09090897725210102321, 0.07692059717247089626) +
                   z2 * pair(-0.06663099206619533667, 0.05847859322885287912);
  const S third =
      pair(-0.05039190756065256303, 0.03806215055121201839) - z2 * number<S>(0.01790505326773519454);
  return first + z4 * (second + z4 * third);
}

/// atan2(y, x). For doubles and batches the standard function takes twice the time, and handles lanes one
/// after the other. Here atan of the smaller magnitude over the larger; above tan(pi/8) it is reduced by
/// pi/4.
template <class S> S arc_tangent(const S& y, const S& x) {
  if constexpr (Batch<S> || std::is_same_v<S, double>) {
    using std::abs;
    using std::copysign;
    using std::signbit;
    const S opposite = abs(y), adjacent = abs(x);
    const auto steep = opposite > adjacent;
    const S small = select(steep, adjacent, opposite);
    const S large = select(steep, opposite, adjacent);
    const auto near_diagonal = small > number<S>(0.41421356237309503) * large;
    const S a = select(near_diagonal, S(small - large), small);
    const S b = select(near_diagonal, S(small + large), large);
    const S t = a / select(b == S(0), S(1), b);
    const S z = t * t;
    const S from_small =
        select(near_diagonal, number<S>(0.78539816339744831), S(0)) + (t + t * z * arc_tangent_series(z));
    const S acute = select(steep, S(number<S>(1.5707963267948966) - from_small), from_small);
    return copysign(select(signbit(x), S(number<S>(3.1415926535897932) - acute), acute), y);
  } else {
    using std::atan2;
    return atan2(y, x);
  }
}

}  // namespace vectrix::detail
