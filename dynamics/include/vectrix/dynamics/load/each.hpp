#pragma once

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/craft_scenario.hpp>

namespace vectrix {

/// Several bodies, mounts or rotors: of_each<Left, Right>; of_numbered<Panel, 1, 4> is Panel<1> to Panel<4>.
template <class... B> struct OfEach {};
template <class... B> inline constexpr OfEach<B...> of_each{};

namespace detail {

template <template <int> class B, int first, class> struct Numbered;
template <template <int> class B, int first, int... i>
struct Numbered<B, first, std::integer_sequence<int, i...>> {
  using type = OfEach<B<first + i>...>;
};

}  // namespace detail

template <template <int> class B, int first, int last>
  requires(first <= last)
inline constexpr typename detail::Numbered<B, first, std::make_integer_sequence<int, last - first + 1>>::type
    of_numbered{};

/// One part of a scenario for each of several. Made by each().
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

/// The same load, or change, for each of several: f(of<B>) gives that of one.
///     each(of_numbered<Panel, 1, 4>, [&](auto b) { return spring(craft, b, k, q_0); })
template <class... B, class F>
  requires(sizeof...(B) > 0 && (std::is_invocable_v<const F&, Of<B>> && ...))
auto each(OfEach<B...>, const F& f) {
  return EachPart<std::invoke_result_t<const F&, Of<B>>...>{{f(of<B>)...}};
}
template <class Several, class F>
auto each(  // each(of_each<A, B>, f): f(of<A>) gives a part of a scenario: [](auto b) { ... }
    const Several&, const F&) -> Refused = delete;

}  // namespace vectrix
