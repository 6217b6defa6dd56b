#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

namespace vectrix {

/// Several bodies, mounts or rotors: of_each<Left, Right>; of_numbered<Panel, 1, 4> is Panel<1> to Panel<4>.
template <class... B> struct OfEach {};
template <class... B> inline constexpr OfEach<B...> of_each{};

/// One part for each of several. Made by each().
template <class... Parts> struct EachPart;

namespace detail {

template <template <int> class B, int first, class> struct Numbered;
template <template <int> class B, int first, int... i>
struct Numbered<B, first, std::integer_sequence<int, i...>> {
  using type = OfEach<B<first + i>...>;
};

/// The types of a list, with those of the lists in it in their places.
template <class... Parts> struct FlatList;
template <class Part> struct FlatPart { using type = std::tuple<Part>; };
template <class... Parts> struct FlatPart<EachPart<Parts...>> : FlatList<Parts...> {};
template <class... Parts> struct FlatList {
  using type = decltype(std::tuple_cat(std::declval<typename FlatPart<Parts>::type>()...));
};
/// Calls f with each part, and with each of the lists.
template <class Part, class F> void for_each_part(const Part& part, const F& f) {
  f(part);
}
template <class... Parts, class F> void for_each_part(const EachPart<Parts...>& list, const F& f) {
  std::apply([&](const auto&... part) { (for_each_part(part, f), ...); }, list.each);
}

}  // namespace detail

template <template <int> class B, int first, int last>
  requires(first <= last)
inline constexpr typename detail::Numbered<B, first, std::make_integer_sequence<int, last - first + 1>>::type
    of_numbered{};

}  // namespace vectrix
