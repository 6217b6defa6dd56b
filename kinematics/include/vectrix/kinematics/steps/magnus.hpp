#pragma once

#include <type_traits>
#include <vectrix/kinematics/steps/increment.hpp>

namespace vectrix {
namespace detail {

template <class RateOfTime, class S>
using RateAt = std::invoke_result_t<const RateOfTime&, const Quantity<si::time, S>&>;
template <class RateOfTime, class S>
using IncrementOfRate = typename BodyRate<RateAt<RateOfTime, S>>::increment;
template <class RateOfTime, class S>
concept GivesBodyRate = requires {
  typename IncrementOfRate<RateOfTime, S>;
};

// The series is for Y' = A Y, here with Y = (R_b^a)^T and A = -[w]x. Commutators are cross products of -w.
template <class S> Column<S> magnus_4(const Column<S>& w1, const Column<S>& w2, const S& h) {
  using std::sqrt;
  return h / S(2) * (w1 + w2) + h * h * sqrt(S(3)) / S(12) * w1.cross(w2);
}
template <class S>
Column<S> magnus_6(const Column<S>& w1, const Column<S>& w2, const Column<S>& w3, const S& h) {
  using std::sqrt;
  const Column<S> a1 = -h * w2;
  const Column<S> a2 = -h * sqrt(S(15)) / S(3) * (w3 - w1);
  const Column<S> a3 = -h * S(10) / S(3) * (w3 - S(2) * w2 + w1);
  const Column<S> c1 = a1.cross(a2);
  const Column<S> c2 = a1.cross(Column<S>(S(2) * a3 + c1)) / S(-60);
  return -(a1 + a3 / S(12) + Column<S>(S(-20) * a1 - a3 + c1).cross(Column<S>(a2 + c2)) / S(240));
}

}  // namespace detail

/// The increment of a rate w_ab^b(t) that is a function of time alone, over [t, t + dt], by the Magnus series
/// at Gauss points, of order 2, 4 or 6:
///     theta = int w + 1/2 int int_{s < t} w(s) x w(t) + ...
/// It takes one, two or three values of the rate (Iserles, Norsett 1999; Blanes, Casas, Ros 2000). The series
/// is valid for steps that turn by less than pi. The integral of w alone is the increment only if w keeps its
/// direction.
template <int Order, class RateOfTime, class S>
  requires(detail::GivesBodyRate<RateOfTime, S> && (Order == 2 || Order == 4 || Order == 6))
detail::IncrementOfRate<RateOfTime, S> magnus_increment(const RateOfTime& rate,
                                                        const Quantity<si::time, S>& t,
                                                        const Quantity<si::time, S>& dt) {
  using std::sqrt;
  const S h = dt.value();
  // The rate at c steps from the middle of the interval.
  const auto w = [&](const S& c) -> detail::Column<S> {
    return rate(Quantity<si::time, S>::from_value(t.value() + (S(1) / S(2) + c) * h)).coordinates();
  };
  if constexpr (Order == 2) {
    return {detail::trusted, h * w(S(0))};
  } else if constexpr (Order == 4) {
    const S c = sqrt(S(3)) / S(6);
    return {detail::trusted, detail::magnus_4<S>(w(-c), w(c), h)};
  } else {
    const S c = sqrt(S(15)) / S(10);
    return {detail::trusted, detail::magnus_6<S>(w(-c), w(S(0)), w(c), h)};
  }
}
template <int Order, class RateOfTime, class Start, class Duration>
auto magnus_increment(  // magnus_increment<2, 4 or 6>(rate, t, dt): rate(t) is w_ab_b, in b's own axes
    const RateOfTime&, const Start&, const Duration&) -> Refused = delete;

}  // namespace vectrix
