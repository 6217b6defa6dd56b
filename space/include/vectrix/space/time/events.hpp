#pragma once

#include <functional>
#include <type_traits>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/time/time_span.hpp>

namespace vectrix {

enum class Crossing { rising, falling };

/// An instant at which a function of time changes its sign.
struct ZeroCrossing {
  Epoch epoch;
  Crossing direction;
};

/// How near to a zero its epoch has to be. The clock has 1e-11 s.
struct EventOptions {
  Quantity<si::time> tolerance = 1e-9 * si::second;
};

namespace detail {

using NumberOfEpoch = std::function<double(const Epoch&)>;
VECTRIX_EXPORT std::vector<ZeroCrossing> zero_crossings(const TimeSpan& span, const Quantity<si::time>& step,
                                                        const NumberOfEpoch& f, const EventOptions& options);
VECTRIX_EXPORT std::vector<TimeSpan> positive_intervals(const TimeSpan& span, const Quantity<si::time>& step,
                                                        const NumberOfEpoch& f, const EventOptions& options);

template <class X> inline constexpr bool has_sign = false;  // a bool or a whole number has no zero to find
template <> inline constexpr bool has_sign<double> = true;
template <class U> inline constexpr bool has_sign<Quantity<U, double>> = true;

template <class F, class Result>
using IfFunctionOfEpoch =
    std::enable_if_t<has_sign<std::remove_cvref_t<std::invoke_result_t<const F&, const Epoch&>>>, Result>;

template <class F> NumberOfEpoch number_of_epoch(const F& f) {
  return [&f](const Epoch& epoch) {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(f(epoch))>>) {
      return f(epoch);
    } else {
      return f(epoch).value();
    }
  };
}

}  // namespace detail

/// The instants in a span at which f(epoch), a double or a quantity, changes its sign, in order of time:
///     events(span, 30.0 * si::second, [&](const Epoch& t) { return elevation(t) - least; })
/// f is evaluated at the start, each step later and at the end, and each change of sign from one of these
/// instants to the next is narrowed down by Boost.Math's toms748 (Alefeld, Potra, Shi 1995). Between two of
/// them an even number of zeros hides, and of an odd number one is found. So two zeros are found whatever the
/// start if they are more than a step apart; nearer, perhaps neither. Where f crosses zero by no more than d
/// at an extremum with the second derivative f'', its two zeros are sqrt(8 d/|f''|) apart: the step has to be
/// shorter than that. Where f touches zero, in a tangent or a cusp, or is zero at an end of the span, it does
/// not change its sign, and there is no event; a jump past zero is one. Throws BadInput, with the epoch, if f
/// is not finite, f throws BadInput, or f is zero at two neighbouring instants, as it is if it is zero for a
/// time. Any other exception of f is nested in a std::runtime_error with the epoch. Throws BadInput if the
/// step or the tolerance is not positive and finite, or the tolerance is less than 1e-10 s.
template <class F>
detail::IfFunctionOfEpoch<F, std::vector<ZeroCrossing>> events(const TimeSpan& span,
                                                               const Quantity<si::time>& step, const F& f,
                                                               const EventOptions& options = {}) {
  return detail::zero_crossings(span, step, detail::number_of_epoch(f), options);
}
template <class Step, class F, class... Options>
auto events(  // span, step in s, f: of an Epoch, gives a double or a quantity, not a bool
    const TimeSpan&, const Step&, const F&, const Options&...) -> Refused = delete;

/// The intervals of a span in which f > 0, such as the passes of a satellite: each from a rising zero, or the
/// start of the span, to a falling zero, or the end. Finds zeros and throws as events() does.
template <class F>
detail::IfFunctionOfEpoch<F, std::vector<TimeSpan>> intervals(const TimeSpan& span,
                                                              const Quantity<si::time>& step, const F& f,
                                                              const EventOptions& options = {}) {
  return detail::positive_intervals(span, step, detail::number_of_epoch(f), options);
}
template <class Step, class F, class... Options>
auto intervals(  // span, step in s, f: of an Epoch, gives a double or a quantity, not a bool
    const TimeSpan&, const Step&, const F&, const Options&...) -> Refused = delete;

}  // namespace vectrix
