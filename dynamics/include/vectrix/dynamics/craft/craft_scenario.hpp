#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/changes.hpp>
#include <vectrix/dynamics/craft/given_function.hpp>
#include <vectrix/dynamics/craft/motion.hpp>

namespace vectrix {

// The mistakes in a scenario, for messages.
template <class X> struct NothingHolds {};
template <class X> struct IsHeldTwice {};
template <class Function> struct IsNoLoad {};
template <class Function> struct IsNoChange {};
template <class Function> struct IsNoFunctionOfTheState {};

namespace detail {

template <class Part> struct PartOf {
  static constexpr bool load = true, held = false, ticks = false, zero = false;
};
template <class X> struct PartOf<Held<X>> {
  static constexpr bool load = false, held = true, ticks = false, zero = false;
};
template <class Trigger, class F> struct PartOf<Change<Trigger, F>> {
  static constexpr bool load = false, held = false, ticks = true, zero = false;
};
template <class G, class F> struct PartOf<Change<Zero<G>, F>> {
  static constexpr bool load = false, held = false, ticks = false, zero = true;
};

/// An instant with the derivative of its state under all loads.
template <CraftType C> struct Accelerated {
  Now<C> now;
  const std::array<double, C::state_size>& rates;
};
/// Each impulse changes a held value to what fits the state after it.
template <class F> struct PartOf<Change<Impulse, F>> {
  static constexpr bool load = false, held = false, ticks = false, zero = false;
};
template <class F> Change<Impulse, F> after_impulse(F update) {
  return {{}, std::move(update)};
}

template <class Part> inline constexpr bool is_after_impulse = false;
template <class F> inline constexpr bool is_after_impulse<Change<Impulse, F>> = true;

/// What a zero or a settling value of a load sees: an instant, and its accelerations if the held X were `x`.
/// They are solved when they are asked for; those of the held X once for all functions that see the instant.
template <CraftType C, class X> struct Solved {
  Now<C> now;
  std::function<Accelerated<C>(const X& x)> with;  ///< it overwrites what it gave before
};
/// What a function of the state with these arguments sees: Solved if it takes one, else Now<C>.
template <class C, class Arguments> struct SeenBy : std::type_identity<Now<C>> {};
template <class C, class X, class... Rest>
struct SeenBy<C, std::tuple<Solved<C, X>, Rest...>> : std::type_identity<Solved<C, X>> {};
/// At the start of each smooth segment, after all changes, X may settle: `ends` says which X is no longer
/// what it was, as a joint that is at rest no longer slips, and becomes X{}; then an X{} may become another,
/// what `begins` gives: a joint breaks away when its load jumps.
template <class Ends, class Begins> struct Settling {
  Ends ends;
  Begins begins;
};
template <class Ends, class Begins> Settling<Ends, Begins> settling(const Ends& ends, const Begins& begins) {
  return {ends, begins};
}
template <class Part> inline constexpr bool is_settling = false;
template <class Ends, class Begins> inline constexpr bool is_settling<Settling<Ends, Begins>> = true;
template <class Ends, class Begins> struct PartOf<Settling<Ends, Begins>> {
  static constexpr bool load = false, held = false, ticks = false, zero = false;
};

/// While the held X is X{}, a number of the state is zero, as the speed of a joint that sticks: what it is
/// when X becomes X{}, as the time of the zero is rounded, it is no longer. It does not withstand an impulse,
/// in which X is as if it were `moving`.
template <class X> struct StandsStill {
  using held = X;
  std::size_t at;
  X moving;
};
template <class Part> inline constexpr bool stands_still = false;
template <class X> inline constexpr bool stands_still<StandsStill<X>> = true;
template <class X> struct PartOf<StandsStill<X>> {
  static constexpr bool load = false, held = false, ticks = false, zero = false;
};

/// The speeds of the joint or rotor b among the numbers of the state.
template <class C, class B> std::span<const double> speeds_of(const double* y) {
  using Shape = typename C::shape;
  if constexpr (Shape::template has_rotor<B>)
    return {y + Shape::template spin_at<B>, 1};
  else
    return {y + Shape::template speed_at<B>, Shape::template Part<B>::counts.speeds};
}
template <class C, class B> bool is_moving(const double* y) {
  const auto speeds = speeds_of<C, B>(y);
  return std::any_of(speeds.begin(), speeds.end(), [](double u) { return u != 0.0; });
}

/// While the held X is true, the joint or rotor b stands still: an impulse stops it if it moves.
template <class B, class X> struct Stands { using held = X; };
template <class Part> inline constexpr bool stands = false;
template <class B, class X> inline constexpr bool stands<Stands<B, X>> = true;
template <class B, class X> struct PartOf<Stands<B, X>> {
  static constexpr bool load = false, held = false, ticks = false, zero = false;
};

template <class... Tuples> struct JoinedOf { using type = std::tuple<>; };
template <class... X> struct JoinedOf<std::tuple<X...>> { using type = std::tuple<X...>; };
template <class... X, class... Y, class... Tuples>
struct JoinedOf<std::tuple<X...>, std::tuple<Y...>, Tuples...> : JoinedOf<std::tuple<X..., Y...>, Tuples...> {
};
template <class... Tuples> using Joined = typename JoinedOf<Tuples...>::type;
template <class Part> struct HeldType { using type = std::tuple<>; };
template <class X> struct HeldType<Held<X>> { using type = std::tuple<X>; };
template <class... Parts> struct HeldTypesOf { using type = std::tuple<>; };
template <class... Parts>
  requires(PartOf<Parts>::held || ...)
struct HeldTypesOf<Parts...> {
  using type = Joined<typename HeldType<Parts>::type...>;
};
/// The types of the values that the parts hold, in their order.
template <class... Parts> using HeldTypes = typename HeldTypesOf<Parts...>::type;

template <class X, class Tuple> inline constexpr std::size_t count_in = 0;
template <class X, class... Types>
inline constexpr std::size_t count_in<X, std::tuple<Types...>> = (std::size_t{0} + ... +
                                                                  std::is_same_v<X, Types>);

/// The arguments of a function after the first `count`, or none.
template <std::size_t count, class Arguments> struct RestOf { using type = std::tuple<>; };
template <class First, class... Rest> struct RestOf<1, std::tuple<First, Rest...>> {
  using type = std::tuple<Rest...>;
};
template <class First, class Second, class... Rest> struct RestOf<2, std::tuple<First, Second, Rest...>> {
  using type = std::tuple<Rest...>;
};
/// What a function of the state takes besides.
template <class Function> using Taken = typename RestOf<1, typename UpdateOf<Function>::arguments>::type;

/// What a load takes besides. Its call operator may be a template on the scalar; one that takes nothing more
/// may be any template.
template <class Member> struct ArgumentsOfMember;
template <class F, class R, class... Given> struct ArgumentsOfMember<R (F::*)(Given...) const> {
  using type = std::tuple<std::remove_cvref_t<Given>...>;
};
template <class C, class Load> constexpr auto taken_by_load() {
  if constexpr (is_load<C, Load>)
    return std::type_identity<std::tuple<>>{};
  else if constexpr (requires { &Load::template operator()<double>; })
    return RestOf<2, typename ArgumentsOfMember<decltype(&Load::template operator()<double>)>::type>{};
  else
    return RestOf<2, Arguments<Load>>{};
}
template <class C, class Load> using TakenByLoad = typename decltype(taken_by_load<C, Load>())::type;

/// The first value that is taken and not held; Nothing if there is none.
template <class HeldTuple, class Tuple> struct FirstNotHeld : std::type_identity<Nothing> {};
template <class HeldTuple, class X, class... Rest>
struct FirstNotHeld<HeldTuple, std::tuple<X, Rest...>>
    : std::conditional_t<count_in<X, HeldTuple> == 0, std::type_identity<NothingHolds<X>>,
                         FirstNotHeld<HeldTuple, std::tuple<Rest...>>> {};

template <class Function, class Before, class Tuple> struct CallableWith;
template <class Function, class... Before, class... X>
    struct CallableWith<Function, std::tuple<Before...>, std::tuple<X...>>
    : std::bool_constant < requires(const Function& f, Before... before, const X&... x) {
  f(before..., x...);
} > {};

/// Whether a function of the state and of held values gives a number or a quantity: a condition has no zero.
template <class Value>
inline constexpr bool is_size = std::is_convertible_v<Value, double> && !std::is_same_v<Value, bool>;
template <class U> inline constexpr bool is_size<Quantity<U>> = true;
template <class C, class G, class Tuple> struct GivesSize;
template <class C, class G, class... X> struct GivesSize<C, G, std::tuple<X...>> {
  static constexpr bool test() {
    using Seen = typename SeenBy<C, Arguments<G>>::type;
    return requires(const G& g, const Seen& seen, const X&... x) {
      requires is_size<std::remove_cvref_t<decltype(g(seen, x...))>>;
    };
  }
};

/// Of a function that is not called as it should be; Refused if the compiler has said what is wrong in it.
template <bool has_error, class Mistake>
using FaultOfCall = std::type_identity<std::conditional_t<has_error, Refused, Mistake>>;

/// The mistake of one part.
template <class C, class HeldTuple, class Part> struct FaultOfPart {
  static constexpr auto fault() {
    using Lack = typename FirstNotHeld<HeldTuple, TakenByLoad<C, Part>>::type;
    if constexpr (std::is_same_v<Part, Refused>) {
      return std::type_identity<Refused>{};
    } else if constexpr (!std::is_same_v<Lack, Nothing>) {
      return std::type_identity<Lack>{};
    } else if constexpr (!CallableWith<Part, std::tuple<const Now<C>&, Forces<C>&>,
                                       TakenByLoad<C, Part>>::value) {
      return FaultOfCall<has_error<Part, const Now<C>&, Forces<C>&>(), IsNoLoad<Part>>{};
    } else {
      return std::type_identity<Nothing>{};
    }
  }
  using type = typename decltype(fault())::type;
};
template <class C, class HeldTuple, class X> struct FaultOfPart<C, HeldTuple, Held<X>> {
  using type = std::conditional_t<count_in<X, HeldTuple> == 1, Nothing, IsHeldTwice<X>>;
};
template <class C, class HeldTuple, class F> struct FaultOfUpdate {
  static constexpr auto fault() {
    using X = typename UpdateOf<F>::result;
    using Lack = typename FirstNotHeld<HeldTuple, Joined<Taken<F>, std::tuple<X>>>::type;
    constexpr bool called = CallableWith<F, std::tuple<const Now<C>&>, Taken<F>>::value;
    if constexpr (!is_becomes<F> &&
                  (std::is_void_v<X> || !called || std::is_same_v<Arguments<F>, std::tuple<>>)) {
      return FaultOfCall<has_error<F, const Now<C>&>(), IsNoChange<F>>{};
    } else {
      return std::type_identity<Lack>{};
    }
  }
  using type = typename decltype(fault())::type;
};
template <class C, class HeldTuple, class F>
  requires is_effect<F>
struct FaultOfUpdate<C, HeldTuple, F> {
  using type = Nothing;
};
template <class C, class HeldTuple, class Ends, class Begins>
struct FaultOfPart<C, HeldTuple, Settling<Ends, Begins>> {
  using type = Nothing;
};
template <class C, class HeldTuple, class X> struct FaultOfPart<C, HeldTuple, StandsStill<X>> {
  using type = Nothing;
};
template <class C, class HeldTuple, class B, class X> struct FaultOfPart<C, HeldTuple, Stands<B, X>> {
  using type = Nothing;
};
template <class C, class HeldTuple, class Trigger, class F>
struct FaultOfPart<C, HeldTuple, Change<Trigger, F>> : FaultOfUpdate<C, HeldTuple, F> {};
template <class C, class HeldTuple, class G, class F> struct FaultOfPart<C, HeldTuple, Change<Zero<G>, F>> {
  static constexpr auto fault() {
    using Lack = typename FirstNotHeld<HeldTuple, Taken<G>>::type;
    if constexpr (!std::is_same_v<Lack, Nothing>) {
      return std::type_identity<Lack>{};
    } else if constexpr (!GivesSize<C, G, Taken<G>>::test()) {
      return FaultOfCall<has_error<G, const Now<C>&>(), IsNoFunctionOfTheState<G>>{};
    } else {
      return FaultOfUpdate<C, HeldTuple, F>{};
    }
  }
  using type = typename decltype(fault())::type;
};

template <std::size_t number, class Part> auto parts_of(const Part& part) {
  if constexpr (SeveralParts<Part>)
    return part.template parts<number>();
  else
    return std::tuple<Part>{part};
}
template <class... Parts> auto all_parts(const Parts&... parts) {
  if constexpr ((SeveralParts<Parts> || ...)) {
    return [&]<std::size_t... number>(std::index_sequence<number...>) {
      return std::tuple_cat(parts_of<number>(parts)...);
    }
    (std::index_sequence_for<Parts...>{});
  } else {
    return std::tuple<Parts...>{parts...};
  }
}
template <class... Parts> using AllParts = decltype(all_parts(std::declval<const Parts&>()...));

/// The first mistake of all parts; Nothing if there is none.
template <class C, class HeldTuple, class... Parts> constexpr auto first_fault() {
  constexpr std::size_t bad =
      first_of<!std::is_same_v<typename FaultOfPart<C, HeldTuple, Parts>::type, Nothing>...>();
  if constexpr (bad == nowhere)
    return std::type_identity<Nothing>{};
  else
    return FaultOfPart<C, HeldTuple, std::tuple_element_t<bad, std::tuple<Parts...>>>{};
}
template <class C, class Tuple> struct FaultOfParts;
template <class C, class... Parts> struct FaultOfParts<C, std::tuple<Parts...>> {
  using type = typename decltype(first_fault<C, HeldTypes<Parts...>, Parts...>())::type;
};
template <class C, class... Parts> using ScenarioFault = typename FaultOfParts<C, AllParts<Parts...>>::type;

/// Calls a function with what stands before, and the held values of its further arguments.
template <class... X, class Function, class HeldTuple, class... Before>
[[gnu::always_inline]] inline decltype(auto) with_held(std::type_identity<std::tuple<X...>>,
                                                       const Function& function, const HeldTuple& values,
                                                       Before&&... before) {
  return function(before..., std::get<X>(values)...);
}

/// A load with the held values that it takes, which outlive it.
template <class Load, class HeldTuple> struct HeldLoad {
  Load load;
  const HeldTuple* values;
  template <class C, class S>
  [[gnu::always_inline]] void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    with_held(std::type_identity<TakenByLoad<C, Load>>{}, load, *values, now, forces);
  }
};

}  // namespace detail

/// What happens to a spacecraft: loads, held values, and what changes them. Made by scenario().
template <class C, class... Parts> class CraftScenario {
 public:
  CraftScenario() = delete;  // scenario(craft, parts...)
  CraftScenario(detail::Trusted, const C& craft, std::tuple<Parts...> parts)
      : craft_(craft), parts_(std::move(parts)) {}

  const C& craft() const& { return craft_; }
  C craft() && { return craft_; }
  const std::tuple<Parts...>& parts() const& { return parts_; }

 private:
  C craft_;
  std::tuple<Parts...> parts_;
};

namespace detail {

template <class C, class Tuple> struct ScenarioWith;
template <class C, class... Parts>
struct ScenarioWith<C, std::tuple<Parts...>> : std::type_identity<CraftScenario<C, Parts...>> {};
template <class... CraftAndParts> using MadeScenario = typename ScenarioWith<CraftAndParts...>::type;
template <class C, class... Parts> constexpr auto fault_of_scenario() {
  if constexpr (CraftType<C>)
    return std::type_identity<ScenarioFault<C, Parts...>>{};
  else
    return std::type_identity<IsNoCraft<C>>{};
}
template <class C, class... Parts>
using FaultOfScenario = typename decltype(fault_of_scenario<C, Parts...>())::type;
template <class C, class... Parts>
using ScenarioOf =
    typename MadeUnless<FaultOfScenario<C, Parts...>, MadeScenario>::template type<C, AllParts<Parts...>>;

}  // namespace detail

/// A craft and what happens to it, in any order:
///   - loads: (const Now<C>&, Forces<C>&, const X&...), with any held values; those of the folder load/
///   - held(x): a value that only changes change, at the ends of smooth segments
///   - changes of held values: every(), at_times(), at_start(), when()
/// Changes at one instant all see the values from before it; if two change one value, the later in the list
/// counts. Throws BadInput for a load that is an empty std::function.
template <class C, class... Parts>
detail::ScenarioOf<C, Parts...> scenario(const C& craft, const Parts&... parts) {
  if constexpr (std::is_same_v<detail::FaultOfScenario<C, Parts...>, Refused>) {
    return Refused{};
  } else {
    (detail::require_function([] { return "scenario, a load"; }, parts), ...);
    return {detail::trusted, craft, detail::all_parts(parts...)};
  }
}
template <class C, class... Parts, class Fault = detail::FaultOfScenario<C, Parts...>>
  requires(!std::is_same_v<Fault, Nothing> && !std::is_same_v<Fault, Refused>)
auto scenario(  // the craft, then loads, held values, and changes of what is held: see Fault
    const C&, const Parts&...) -> Refused = delete;

}  // namespace vectrix
