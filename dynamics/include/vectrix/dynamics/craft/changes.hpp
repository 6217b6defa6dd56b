#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/given_function.hpp>
#include <vectrix/dynamics/craft/now.hpp>
#include <vectrix/dynamics/ode/solution.hpp>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/graph/edge.hpp>

namespace vectrix {

/// A value that loads and changes may take: constant in each smooth segment of a run.
template <class X> struct Held { X initial; };
/// The command of a controller, the mode of operation, whether a thruster is on: a value with a type of its
/// own, which names it, and what it is until its first change.
template <class X> Held<X> held(X initial) {
  return {std::move(initial)};
}

/// The result of a change that does not depend on the state.
template <class X> struct Becomes { X value; };
template <class X> Becomes<X> becomes(X value) {
  return {std::move(value)};
}

/// What a zero does: it is recorded, or it also ends the run.
struct Recorded {};
struct Stop {};
inline constexpr Stop stop{};

namespace detail {

/// The type of the value that a change returns, and those of its arguments; none if its call operator is a
/// template.
template <class F> struct UpdateOf {
  using result = Result<F>;
  using arguments = Arguments<F>;
};
template <class X> struct UpdateOf<Becomes<X>> {
  using result = X;
  using arguments = std::tuple<>;
};
template <class F> inline constexpr bool is_becomes = false;
template <class X> inline constexpr bool is_becomes<Becomes<X>> = true;
template <class F> inline constexpr bool is_effect = std::is_same_v<F, Recorded> || std::is_same_v<F, Stop>;

/// Ticks at start + k period, k = 0, 1, ...; what one finds takes effect `latency` later.
struct Clock {
  double period, latency;
};
struct TimeList {
  std::vector<double> times;
};
struct RunStart {};
/// After each impulse of the run.
struct Impulse {};
/// The zeros of a function of the state.
template <class G> struct Zero {
  std::string name;
  G function;
  ode::Direction direction;
};
template <class Trigger, class F> struct Change {
  Trigger trigger;
  F update;
};

/// A name, a direction, and what a zero does, if anything.
template <class Name, class... Given> inline constexpr bool is_zero = false;
template <class Name, class D>
inline constexpr bool is_zero<Name, D> =
    std::is_convertible_v<const Name&, std::string>&& std::is_same_v<D, ode::Direction>;
template <class Name, class D, class F> inline constexpr bool is_zero<Name, D, F> = is_zero<Name, D>;

template <class G> Zero<G> zero_of(std::string name, G function, ode::Direction direction) {
  G given = given_function([&] { return "when(\"" + name + "\")"; }, std::move(function));
  return {std::move(name), std::move(given), direction};
}

VECTRIX_EXPORT double checked_period(double period);
VECTRIX_EXPORT double checked_latency(double latency);
VECTRIX_EXPORT std::vector<double> checked_times(const std::vector<Quantity<si::time>>& times);

}  // namespace detail

/// A sampled controller: at start + k period, k = 0, 1, ..., the function (const Now<C>&, const X&...) -> X,
/// of the state and of held values, changes the held X. The run does not tick at its end. With a latency the
/// function sees the state at the tick, and its result takes effect so much later. Throws BadInput for a
/// period that is not positive, a latency that is negative, or one that is not finite.
template <class F>
detail::Change<detail::Clock, F> every(const Quantity<si::time>& period, F update,
                                       const Quantity<si::time>& latency = 0.0 * si::second) {
  return {{detail::checked_period(period.value()), detail::checked_latency(latency.value())},
          detail::given_function([] { return "every"; }, std::move(update))};
}

template <class Period, class F, class... Latency>
  requires(!std::is_convertible_v<const Period&, Quantity<si::time>> &&
           !requires(const F& span) { span.start(); })  // a TimeSpan has every() of its own
auto every(const Period&, const F&, const Latency&...) -> Refused = delete;  // every(period, f, latency)

/// A change of a held value at the given times: becomes(x), or a function as every() takes it. Times before
/// the start of a run, or not before its end, have no effect. Times too close for the rounding of time are
/// one instant; each of them still sees what the one before gave. Throws BadInput unless they are finite and
/// increase.
template <class F>
detail::Change<detail::TimeList, F> at_times(const std::vector<Quantity<si::time>>& times, F update) {
  return {{detail::checked_times(times)},
          detail::given_function([] { return "at_times"; }, std::move(update))};
}

template <class Times, class F>
auto at_times(  // at_times({t, ...}, f): times; f is becomes(x), or a function of const Now<C>&, const X&...
    const Times&, const F&) -> Refused = delete;

/// A change of a held value at the start of a run, before anything moves: a function as every() takes it. The
/// value that fits the state from which the run starts.
template <class F> detail::Change<detail::RunStart, F> at_start(F update) {
  return {{}, detail::given_function([] { return "at_start"; }, std::move(update))};
}

/// The zeros of a function (const Now<C>&, const X&...) of the state and of held values, a number or a
/// quantity, are events of the run, found as ode::Root says. They change a held value, as at_times() does; or
/// they stop the run; or they are recorded only. As every(), throws BadInput for an empty std::function.
template <class G>
detail::Change<detail::Zero<G>, Recorded> when(std::string name, G function, ode::Direction direction) {
  return {detail::zero_of(std::move(name), std::move(function), direction), {}};
}
template <class G, class F>
detail::Change<detail::Zero<G>, F> when(std::string name, G function, ode::Direction direction, F update) {
  auto changes = detail::given_function([&] { return "when(\"" + name + "\")"; }, std::move(update));
  return {detail::zero_of(std::move(name), std::move(function), direction), std::move(changes)};
}

template <class Name, class G, class... Given>
  requires(!detail::is_zero<Name, Given...>)
auto when(  // when("name", g, ode::Direction::falling): then nothing, stop, becomes(x), or a function
    const Name&, const G&, const Given&...) -> Refused = delete;

}  // namespace vectrix
