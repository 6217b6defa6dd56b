#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/craft/each_part.hpp>

namespace vectrix {

/// One part of a craft, of a scenario or of a state for each of several. Made by each().
template <class... Parts> struct EachPart {
  std::tuple<Parts...> each;

  template <class C, class S>
    requires(std::invocable<const Parts&, const Now<C, S>&, Forces<C, S>&>&&...)
  void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    std::apply([&](const auto&... load) { (load(now, forces), ...); }, each);
  }
  /// The numbers of a list, and of a list in a list, are above those of all parts beside it.
  template <std::size_t number> auto parts() const {
    constexpr std::size_t most = 4096;
    static_assert(sizeof...(Parts) < most);
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return std::tuple_cat(detail::parts_of<(number + 1) * most + i>(std::get<i>(each))...);
    }
    (std::index_sequence_for<Parts...>{});
  }
};

namespace detail {

template <class F, class... B> constexpr bool gives_parts() {
  if constexpr (sizeof...(B) > 0 && (std::is_invocable_v<const F&, Of<B>> && ...))
    return !(std::is_void_v<std::invoke_result_t<const F&, Of<B>>> || ...);
  return false;
}

}  // namespace detail

/// The same load, change, body or start for each of several: f(of<B>) gives that of one.
///     each(of_numbered<Panel, 1, 4>, [&](auto b) { return spring(craft, b, k, q_0); })
///     each(of_numbered<Panel, 1, 4>, [&]<int i>(Of<Panel<i>>) { return body(mass<i>(), joint<i>()); })
/// spacecraft(), state(), scenario() and motion() take it as they take its parts one after the other.
template <class... B, class F>
  requires(detail::gives_parts<F, B...>())
auto each(OfEach<B...>, const F& f) {
  return EachPart<std::invoke_result_t<const F&, Of<B>>...>{{f(of<B>)...}};
}
template <class Several, class F>
auto each(  // each(of_each<A, B>, f): f(of<A>) gives a part or a start: [](auto b) { ... }
    const Several&, const F&) -> Refused = delete;

namespace detail {

/// What each of `count` is given: a value for all, or its own of an array.
template <std::size_t count, class Given> struct GivenToOne { using type = Given; };
template <std::size_t count, class Given> struct GivenToOne<count, std::array<Given, count>> {
  using type = Given;
};
template <class Given> const Given& given_to(const Given& given, std::size_t) {
  return given;
}
template <class Given, std::size_t count>
const Given& given_to(const std::array<Given, count>& given, std::size_t i) {
  return given[i];
}
template <class First, class... B, class Q, class U> struct Started<OfEach<First, B...>, Q, U> {
  static constexpr std::size_t count = 1 + sizeof...(B);
  template <class F>
  using One = Started<Of<F>, typename GivenToOne<count, Q>::type, typename GivenToOne<count, U>::type>;
  static constexpr bool fits = One<First>::fits;
  static auto make(OfEach<First, B...> several, const Q& coordinates, const U& rates) {
    std::size_t i = 0;
    return each(several, [&]<class F>(Of<F> one) {
      const std::size_t at = i++;
      return One<F>::make(one, given_to(coordinates, at), given_to(rates, at));
    });
  }
};

}  // namespace detail

}  // namespace vectrix
