#pragma once

#include <cmath>
#include <vectrix/frames/batch.hpp>

namespace vectrix::detail {

/// atan2(y, x). Of a batch, whose standard function goes lane by lane: of the smaller and the larger
/// magnitude, from pi/4 above tan(pi/8), by the polynomial in t = a/b, |t| <= tan(pi/8), of least relative
/// error, 1.3e-18.
template <class S> S arc_tangent(const S& y, const S& x) {
  using std::abs;
  if constexpr (Batch<S>) {
    const S opposite = abs(y), adjacent = abs(x);
    const auto steep = opposite > adjacent;
    const S small = select(steep, adjacent, opposite);
    const S large = select(steep, opposite, adjacent);
    const auto near_diagonal = small > number<S>(0.41421356237309503) * large;
    const S a = select(near_diagonal, S(small - large), small);
    const S b = select(near_diagonal, S(small + large), large);
    const S t = a / select(b == S(0), S(1), b);
    const S z = t * t;
    S sum(0);
    for (const double coefficient :
         {-0.01790505326773519454, 0.03806215055121201839, -0.05039190756065256303, 0.05847859322885287912,
          -0.06663099206619533667, 0.07692059717247089626, -0.09090897725210102321, 0.1111111078215209181,
          -0.142857142801664609, 0.199999999999532457, -0.3333333333333319616}) {
      sum = sum * z + number<S>(coefficient);
    }
    const S from_small = select(near_diagonal, number<S>(0.78539816339744831), S(0)) + (t + t * z * sum);
    const S acute = select(steep, S(number<S>(1.5707963267948966) - from_small), from_small);
    return copysign(select(signbit(x), S(number<S>(3.1415926535897932) - acute), acute), y);
  } else {
    using std::atan2;
    return atan2(y, x);
  }
}

}  // namespace vectrix::detail
