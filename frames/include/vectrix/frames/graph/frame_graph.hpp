#pragma once

#include <cstddef>
#include <tuple>
#include <utility>
#include <vectrix/frames/graph/snapshot.hpp>

namespace vectrix {

// The mistakes in a list of edges, for messages.
template <class Link> struct TwoPathsOver {};
template <class F> struct OneFrameTwice {};
template <class Scalar, class Other> struct ScalarsDiffer {};
template <class Given> struct NotAnEdge {};
template <class Link, class Lack> struct EdgeAsksFor {};

namespace detail {

/// The first edge whose function does not take the instant; void when all do.
template <class Instant, class... Edges> struct Refusing : std::type_identity<void> {};
template <class Instant, class Edge, class... Edges>
struct Refusing<Instant, Edge, Edges...>
    : std::conditional_t<Edge::template takes<Instant>, Refusing<Instant, Edges...>,
                         std::type_identity<LinkOf<Edge>>> {};
template <class Instant, class... Edges> using FirstRefusing = typename Refusing<Instant, Edges...>::type;
template <class Instant, class... Edges>
using RefusingEdge =
    std::enable_if_t<!std::is_void_v<FirstRefusing<Instant, Edges...>>, FirstRefusing<Instant, Edges...>>;

}  // namespace detail

/// A tree of frames known at compile time. Its edges are fixed values or functions of the instant, joined by
/// `frame_graph(...)`. `graph.at(t)` is the graph at one instant:
///     graph.at(t).rotation(to<Camera>, from<Itrf>)
///     graph.at(t).angular_velocity(of<Camera>, relative_to<Itrf>, in<Camera>)
///     graph.at(t).angular_acceleration(of<Camera>, relative_to<Itrf>, in<Camera>)
/// The path is found at compile time. An unknown frame, a missing path, a second path or a level that an edge
/// lacks does not compile. An edge may ask the graph what the edges listed before it know.
template <class... Edges> class FrameGraph {
  template <class Instant>
  using Snapshot = std::enable_if_t<std::is_void_v<detail::FirstRefusing<Instant, Edges...>>,
                                    GraphSnapshot<Instant, Edges...>>;

 public:
  explicit FrameGraph(Edges... edges) : edges_(std::move(edges)...) {}

  template <class Instant> Snapshot<Instant> at(const Instant& instant) const& { return {edges_, instant}; }
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

/// The first edge that asks for something that the edges before it do not know, and what they lack; else
/// Nothing.
template <std::size_t edge, class... Edges> struct FirstAsking {
  static constexpr auto fault() {
    if constexpr (edge == sizeof...(Edges)) {
      return std::type_identity<Nothing>{};
    } else {
      using Edge = std::tuple_element_t<edge, std::tuple<Edges...>>;
      using Lack = LackOfEdge<EdgesBefore<edge, Edges...>, Edge>;
      if constexpr (std::is_same_v<Lack, Nothing>) {
        return FirstAsking<edge + 1, Edges...>{};
      } else {
        return std::type_identity<EdgeAsksFor<LinkOf<Edge>, Lack>>{};
      }
    }
  }
  using type = typename decltype(fault())::type;
};

/// The first mistake in the edges. Nothing if they form a forest of one scalar and each gets what it asks
/// for.
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
      return FirstAsking<0, Edges...>{};
    }
  }
}
template <class... Edges> using FaultOf = typename decltype(fault<Edges...>())::type;

template <class... Edges>
using GraphOf = typename MadeUnless<FaultOf<Edges...>, FrameGraph>::template type<Edges...>;

}  // namespace detail

template <class First, class... Edges>
detail::GraphOf<First, Edges...> frame_graph(First first, Edges... edges) {
  return detail::GraphOf<First, Edges...>{std::move(first), std::move(edges)...};
}
template <class First, class... Edges, class Fault = detail::FaultOf<First, Edges...>>
  requires(!std::is_same_v<Fault, Nothing> && !std::is_same_v<Fault, Refused>)
auto frame_graph(  // a tree of frames, in one scalar; an edge asks those before it: see Fault
    First, Edges...) -> Refused = delete;

}  // namespace vectrix
