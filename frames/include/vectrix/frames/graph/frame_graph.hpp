#pragma once

#include <cstddef>
#include <tuple>
#include <utility>
#include <vectrix/frames/graph/places.hpp>

namespace vectrix {

// What a graph may lack to answer a query, for messages.
struct Nothing {};
template <class F> struct UnknownFrame {};
template <class To, class From> struct NoPath {};
template <class F> struct OtherFrameThan {};
template <class Link> struct RateOn {};
template <class Link> struct AccelerationOn {};
template <class Link> struct PlaceOn {};

// What is wrong with the edges of a graph, for messages.
template <class Link> struct TwoPathsOver {};
template <class F> struct OneFrameTwice {};
template <class Scalar, class Other> struct ScalarsDiffer {};
template <class Given> struct NotAnEdge {};

namespace detail {

template <class Instant> struct InstantType : std::type_identity<Instant> {};
template <class BoostUnit, class S>
struct InstantType<AnyQuantity<BoostUnit, S>> : std::type_identity<QuantityInstant<unit_tag<BoostUnit>, S>> {
};
template <class Instant> using InstantOf = typename InstantType<Instant>::type;

/// The first edge whose function does not take the instant; void when all do.
template <class Instant, class... Edges> struct Refusing : std::type_identity<void> {};
template <class Instant, class Edge, class... Edges>
struct Refusing<Instant, Edge, Edges...>
    : std::conditional_t<Edge::template takes<Instant>, Refusing<Instant, Edges...>,
                         std::type_identity<LinkOf<Edge>>> {};
template <class Instant, class... Edges>
using FirstRefusing = typename Refusing<InstantOf<Instant>, Edges...>::type;
template <class Instant, class... Edges>
using RefusingEdge =
    std::enable_if_t<!std::is_void_v<FirstRefusing<Instant, Edges...>>, FirstRefusing<Instant, Edges...>>;

template <class Topology, class... Fs> struct FirstUnknown : std::type_identity<void> {};
template <class Topology, class F, class... Fs>
struct FirstUnknown<Topology, F, Fs...>
    : std::conditional_t<Topology::template knows<F>, FirstUnknown<Topology, Fs...>, std::type_identity<F>> {
};

/// What the graph lacks to answer at `level` for B relative to A, expressed in C; Nothing when it can.
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

/// What the graph lacks to answer at `level` for the origin of Q relative to that of P, seen from A,
/// expressed in C; Nothing when it can.
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

/// What it lacks to answer for the place of a relative to b.
template <class Topology, class B, class A> constexpr auto lacks_transform() {
  if constexpr (std::is_same_v<A, B>) {
    return lacks<Topology, Level::rotation, B, A, A>();
  } else {
    return lacks_place<Topology, Level::rotation, A, B, B, B>();
  }
}

}  // namespace detail

template <class... Edges> class FrameGraph;

/// What a refused at() would return; see Refused.
struct RefusedSnapshot {
  template <class... Asked> Refused rotation(const Asked&...) const;
  template <class... Asked> Refused angular_velocity(const Asked&...) const;
  template <class... Asked> Refused angular_acceleration(const Asked&...) const;
  template <class... Asked> Refused transform(const Asked&...) const;
  template <class... Asked> Refused position(const Asked&...) const;
  template <class... Asked> Refused velocity(const Asked&...) const;
  template <class... Asked> Refused acceleration(const Asked&...) const;
};

/// A frame graph at one instant. Answers what the path between two frames knows. An edge is evaluated at most
/// once: a snapshot with a name keeps the values, one without, `graph.at(t).rotation(...)`, needs each once
/// only. Holds a reference to the graph. Not for use by two threads at once: take one snapshot per thread.
template <class Instant, class... Edges> class GraphSnapshot {
  using Topology = detail::Topology<Edges...>;

  template <Level level, class B, class A, class C>
  using LackingFor = typename decltype(detail::lacks<Topology, level, B, A, C>())::type;
  template <Level level, class B, class A, class C>
  static constexpr bool answers = std::is_same_v<LackingFor<level, B, A, C>, Nothing>;
  template <Level level, class B, class A, class C>
  using Answered = std::enable_if_t<answers<level, B, A, C>, int>;

  template <Level level, class Q, class P, class A, class C>
  using LackingForPlace = typename decltype(detail::lacks_place<Topology, level, Q, P, A, C>())::type;
  template <Level level, class Q, class P, class A, class C>
  using Placed = std::enable_if_t<std::is_same_v<LackingForPlace<level, Q, P, A, C>, Nothing>, int>;
  template <Level level, class Q, class P, class A, class C>
  using NotPlaced = std::enable_if_t<!std::is_same_v<LackingForPlace<level, Q, P, A, C>, Nothing>,
                                     LackingForPlace<level, Q, P, A, C>>;
  template <class B, class A>
  using LackingForTransform = typename decltype(detail::lacks_transform<Topology, B, A>())::type;

 public:
  GraphSnapshot(const std::tuple<Edges...>& edges, const Instant& instant)
      : edges_(edges), instant_(instant) {}

  /// R_a^b between any two joined frames.
  template <class B, class A, Answered<Level::rotation, B, A, A> = 0> auto rotation(To<B>, From<A>) const& {
    return kept().template rotation<B, A>();
  }
  template <class B, class A, Answered<Level::rotation, B, A, A> = 0> auto rotation(To<B>, From<A>) && {
    return fresh().template rotation<B, A>();
  }

  /// w_ab^c, of b relative to a, expressed in c: needs the rate on every edge from a to b.
  template <class B, class A, class C, Answered<Level::rate, B, A, C> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) const& {
    return kept().template angular_velocity<B, A, C>();
  }
  template <class B, class A, class C, Answered<Level::rate, B, A, C> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) && {
    return fresh().template angular_velocity<B, A, C>();
  }

  /// alpha_ab^c, of b relative to a, expressed in c: needs the acceleration on every edge from a to b.
  template <class B, class A, class C, Answered<Level::acceleration, B, A, C> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const& {
    return kept().template angular_acceleration<B, A, C>();
  }
  template <class B, class A, class C, Answered<Level::acceleration, B, A, C> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) && {
    return fresh().template angular_acceleration<B, A, C>();
  }

  /// X_a^b: needs the place on every edge from a to b.
  template <class B, class A, std::enable_if_t<std::is_same_v<LackingForTransform<B, A>, Nothing>, int> = 0>
  auto transform(To<B>, From<A>) const {
    return kept().template transform<B, A>();
  }

  /// r_pq^c, of q's origin relative to p's, expressed in c: needs the place on every edge from p to q.
  template <class Q, class P, class C, Placed<Level::rotation, Q, P, P, C> = 0>
  auto position(Of<Q>, RelativeTo<P>, In<C>) const {
    return kept().template position<Q, P, C>();
  }

  /// v_pq|a^c, of q's origin relative to p's, observed from a, expressed in c: needs place and rate on every
  /// edge from p to q, and the rate on every edge from there to a.
  template <class Q, class P, class A, class C, Placed<Level::rate, Q, P, A, C> = 0>
  auto velocity(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return kept().template velocity<Q, P, A, C>();
  }

  /// a_pq|a^c, likewise: needs the accelerations.
  template <class Q, class P, class A, class C, Placed<Level::acceleration, Q, P, A, C> = 0>
  auto acceleration(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return kept().template acceleration<Q, P, A, C>();
  }

  template <class B, class A, class Lacking = LackingForTransform<B, A>>
    requires(!std::is_same_v<Lacking, Nothing>)
  auto transform(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;
  template <class Q, class P, class C, class Lacking = NotPlaced<Level::rotation, Q, P, P, C>>
  auto position(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, In<C>) const -> Refused = delete;
  template <class Q, class P, class A, class C, class Lacking = NotPlaced<Level::rate, Q, P, A, C>>
  auto velocity(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;
  template <class Q, class P, class A, class C, class Lacking = NotPlaced<Level::acceleration, Q, P, A, C>>
  auto acceleration(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;

  template <class B, class A, class Lacking = LackingFor<Level::rotation, B, A, A>>
    requires(!answers<Level::rotation, B, A, A>)
  auto rotation(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;
  template <class B, class A, class C, class Lacking = LackingFor<Level::rate, B, A, C>>
    requires(!answers<Level::rate, B, A, C>)
  auto angular_velocity(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;
  template <class B, class A, class C, class Lacking = LackingFor<Level::acceleration, B, A, C>>
    requires(!answers<Level::acceleration, B, A, C>)
  auto angular_acceleration(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;

 private:
  auto fresh() const {
    using Values = detail::FreshValues<Instant, Edges...>;
    return detail::GraphWalk<Topology, Values>{Values{edges_, instant_}};
  }
  auto kept() const {
    using Values = detail::KeptValues<Instant, Edges...>;
    return detail::PlaceWalk<Topology, Values>{Values{{edges_, instant_}, kept_}};
  }

  const std::tuple<Edges...>& edges_;
  Instant instant_;
  mutable std::tuple<detail::Kept<Edges>...> kept_;
};

/// A tree of frames known at compile time. Its edges are fixed values or functions of the instant, joined by
/// `frame_graph(...)`. `graph.at(t)` is the graph at one instant:
///     graph.at(t).rotation(to<Camera>, from<Itrf>)
///     graph.at(t).angular_velocity(of<Camera>, relative_to<Itrf>, in<Camera>)
///     graph.at(t).angular_acceleration(of<Camera>, relative_to<Itrf>, in<Camera>)
/// The path is found at compile time. An unknown frame, no path, two paths, or asking an edge for more than
/// it knows does not compile.
template <class... Edges> class FrameGraph {
  template <class Instant>
  using Snapshot = std::enable_if_t<std::is_void_v<detail::FirstRefusing<Instant, Edges...>>,
                                    GraphSnapshot<detail::InstantOf<Instant>, Edges...>>;

 public:
  explicit FrameGraph(Edges... edges) : edges_(std::move(edges)...) {}

  template <class Instant> Snapshot<Instant> at(const Instant& instant) const& {
    return {edges_, detail::InstantOf<Instant>{instant}};
  }
  template <class Instant, class RefusingEdge = detail::RefusingEdge<Instant, Edges...>>
  auto at(  // the function on this edge does not take this instant
      const Instant&) const& -> RefusedSnapshot = delete;
  template <class Instant>
  auto at(  // the snapshot refers to the graph: give the graph a name first
      const Instant&) const&& -> RefusedSnapshot = delete;

 private:
  std::tuple<Edges...> edges_;
};

namespace detail {

template <class E>
concept GraphEdge = requires {
  typename E::value_type;
};

/// What is wrong with the edges; Nothing when they are a forest in one scalar.
template <class... Edges> constexpr auto fault() {
  if constexpr (constexpr std::size_t bad = first_of<!GraphEdge<Edges>...>(); bad != nowhere) {
    using Given = std::tuple_element_t<bad, std::tuple<Edges...>>;
    return std::conditional<std::is_same_v<Given, Refused>, Refused, NotAnEdge<Given>>{};
  } else {
    using All = Topology<Edges...>;
    using S = typename All::scalar;
    constexpr std::size_t other = first_of<!std::is_same_v<S, ScalarOf<Edges>>...>();
    constexpr std::size_t loop = first_of<std::is_same_v<FirstOf<Edges>, SecondOf<Edges>>...>();
    if constexpr (other != nowhere) {
      return std::type_identity<
          ScalarsDiffer<S, ScalarOf<std::tuple_element_t<other, std::tuple<Edges...>>>>>{};
    } else if constexpr (loop != nowhere) {
      return std::type_identity<OneFrameTwice<FirstOf<std::tuple_element_t<loop, std::tuple<Edges...>>>>>{};
    } else if constexpr (All::closing_edge() != nowhere) {
      return std::type_identity<TwoPathsOver<typename All::template LinkAt<All::closing_edge()>>>{};
    } else {
      return std::type_identity<Nothing>{};
    }
  }
}
template <class... Edges> using FaultOf = typename decltype(fault<Edges...>())::type;

template <class Fault, class... Edges> struct GraphUnless {};
template <class... Edges> struct GraphUnless<Nothing, Edges...> : std::type_identity<FrameGraph<Edges...>> {};
template <class... Edges> struct GraphUnless<Refused, Edges...> : std::type_identity<Refused> {};
template <class... Edges> using GraphOf = typename GraphUnless<FaultOf<Edges...>, Edges...>::type;

}  // namespace detail

template <class First, class... Edges>
detail::GraphOf<First, Edges...> frame_graph(First first, Edges... edges) {
  return detail::GraphOf<First, Edges...>{std::move(first), std::move(edges)...};
}
template <class First, class... Edges, class Fault = detail::FaultOf<First, Edges...>>
  requires(!std::is_same_v<Fault, Nothing> && !std::is_same_v<Fault, Refused>)
auto frame_graph(First, Edges...) -> Refused = delete;  // a tree of frames, in one scalar: see Fault

}  // namespace vectrix
