#pragma once

#include <cstddef>
#include <type_traits>
#include <vectrix/frames/graph/path.hpp>

namespace vectrix {

// What a graph may lack to answer a question, for messages.
struct Nothing {};
template <class F> struct UnknownFrame {};
template <class To, class From> struct NoPath {};
template <class F> struct OtherFrameThan {};
template <class Link> struct RateOn {};
template <class Link> struct AccelerationOn {};
template <class Link> struct PlaceOn {};

namespace detail {

/// The type that is made of parts without a fault; Refused if a part was; none for another fault.
template <class Fault, template <class...> class Made> struct MadeUnless {};
template <template <class...> class Made> struct MadeUnless<Nothing, Made> {
  template <class... Parts> using type = Made<Parts...>;
};
template <template <class...> class Made> struct MadeUnless<Refused, Made> {
  template <class...> using type = Refused;
};

template <class Topology, class... Fs> struct FirstUnknown : std::type_identity<void> {};
template <class Topology, class F, class... Fs>
struct FirstUnknown<Topology, F, Fs...>
    : std::conditional_t<Topology::template knows<F>, FirstUnknown<Topology, Fs...>, std::type_identity<F>> {
};

/// What the graph lacks to answer at `level` for B relative to A, expressed in C; Nothing if it can answer.
template <class Topology, Level level, class B, class A, class C> constexpr auto lacks() {
  if constexpr (!(Topology::template knows<B> && Topology::template knows<A> &&
                  Topology::template knows<C>)) {
    return std::type_identity<UnknownFrame<typename FirstUnknown<Topology, B, A, C>::type>>{};
  } else if constexpr (!Topology::template joined<B, A>()) {
    return std::type_identity<NoPath<B, A>>{};
  } else if constexpr (!Topology::template joined<B, C>()) {
    return std::type_identity<NoPath<B, C>>{};
  } else if constexpr (level == Level::rotation) {
    return std::type_identity<Nothing>{};
  } else if constexpr (std::is_same_v<A, B>) {
    return std::type_identity<OtherFrameThan<A>>{};
  } else if constexpr (constexpr std::size_t edge = Topology::template edge_below<A, B>(level);
                       edge == nowhere) {
    return std::type_identity<Nothing>{};
  } else if constexpr (level == Level::rate) {
    return std::type_identity<RateOn<typename Topology::template LinkAt<edge>>>{};
  } else {
    return std::type_identity<AccelerationOn<typename Topology::template LinkAt<edge>>>{};
  }
}

/// What the graph lacks to answer at `level` for the origin of Q relative to that of P, observed from A,
/// expressed in C; Nothing if it can answer.
template <class Topology, Level level, class Q, class P, class A, class C> constexpr auto lacks_place() {
  using Basic = typename decltype(lacks<Topology, Level::rotation, Q, P, A>())::type;
  if constexpr (!std::is_same_v<Basic, Nothing>) {
    return std::type_identity<Basic>{};
  } else if constexpr (constexpr auto in_c = lacks<Topology, level, Q, P, C>();
                       !std::is_same_v<typename decltype(in_c)::type, Nothing>) {
    return in_c;
  } else if constexpr (std::is_same_v<P, Q>) {
    return std::type_identity<OtherFrameThan<P>>{};
  } else if constexpr (constexpr std::size_t edge = Topology::template edge_without_place<P, Q>();
                       edge != nowhere) {
    return std::type_identity<PlaceOn<typename Topology::template LinkAt<edge>>>{};
  } else {
    using M = typename Topology::template PartingFrame<P, Q, A>;
    if constexpr (level == Level::rotation || std::is_same_v<A, M>) {
      return std::type_identity<Nothing>{};
    } else {
      return lacks<Topology, level, M, A, A>();
    }
  }
}

/// What the graph lacks to answer for the Transform from A to B.
template <class Topology, class B, class A> constexpr auto lacks_transform() {
  if constexpr (std::is_same_v<A, B>) {
    return lacks<Topology, Level::rotation, B, A, A>();
  } else {
    return lacks_place<Topology, Level::rotation, A, B, B, B>();
  }
}

}  // namespace detail
}  // namespace vectrix
