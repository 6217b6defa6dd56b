#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/frames/graph/edge.hpp>

namespace vectrix {

/// The two frames that an edge joins, for messages.
template <class First, class Second> struct Link {};

namespace detail {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

template <class Edge> using FirstOf = typename LevelOf<typename Edge::value_type>::first;
template <class Edge> using SecondOf = typename LevelOf<typename Edge::value_type>::second;
template <class Edge> using ScalarOf = typename LevelOf<typename Edge::value_type>::scalar;
template <class Edge> using LinkOf = Link<FirstOf<Edge>, SecondOf<Edge>>;

/// The edges from one node to another. `reversed[i]` if the i-th is passed from its second frame to its
/// first.
template <std::size_t N> struct Path {
  std::size_t length = 0;
  std::array<std::size_t, N> edge{};
  std::array<bool, N> reversed{};
};

/// The index of the first that is true; `nowhere` if none is.
template <bool... are> constexpr std::size_t first_of() {
  constexpr std::array<bool, sizeof...(are)> all{are...};
  const auto found = std::find(all.begin(), all.end(), true);
  return found == all.end() ? nowhere : static_cast<std::size_t>(found - all.begin());
}

/// The graph in numbers, at compile time. Nodes are numbered by their first occurrence in the list of edges.
template <class... Edges> struct Topology;
template <> struct Topology<> { template <class F> static constexpr bool knows = false; };
template <class... Edges> struct Topology {
  static constexpr std::size_t size = sizeof...(Edges);
  using scalar = ScalarOf<std::tuple_element_t<0, std::tuple<Edges...>>>;

  template <class F> static constexpr std::size_t node() {
    constexpr std::array<bool, 2 * size> same = [] {
      std::array<bool, 2 * size> hits{};
      std::size_t i = 0;
      ((hits[i] = std::is_same_v<F, FirstOf<Edges>>, hits[i + 1] = std::is_same_v<F, SecondOf<Edges>>,
        i += 2),
       ...);
      return hits;
    }();
    const auto found = std::find(same.begin(), same.end(), true);
    return found == same.end() ? nowhere : static_cast<std::size_t>(found - same.begin());
  }

  static constexpr std::array<std::size_t, size> first{node<FirstOf<Edges>>()...};
  static constexpr std::array<std::size_t, size> second{node<SecondOf<Edges>>()...};

  /// The first edge between two frames that are already joined; `nowhere` in a forest.
  static constexpr std::size_t closing_edge() {
    std::array<std::size_t, 2 * size> component{};
    for (std::size_t n = 0; n < 2 * size; ++n) component[n] = n;
    for (std::size_t e = 0; e < size; ++e) {
      const std::size_t kept = component[first[e]];
      const std::size_t merged = component[second[e]];
      if (kept == merged) return e;
      for (std::size_t& c : component) c = c == merged ? kept : c;
    }
    return nowhere;
  }

  /// The only path from `start` to `goal`; its length is `nowhere` if there is none.
  static constexpr Path<size> path(std::size_t start, std::size_t goal) {
    // Finds the distance of each node from the goal, then follows decreasing distance from the start.
    std::array<std::size_t, 2 * size> distance{};
    distance.fill(nowhere);
    distance[goal] = 0;
    for (std::size_t round = 0; round < size; ++round) {
      for (std::size_t e = 0; e < size; ++e) {
        std::size_t& a = distance[first[e]];
        std::size_t& b = distance[second[e]];
        if (a != nowhere && b == nowhere) b = a + 1;
        if (b != nowhere && a == nowhere) a = b + 1;
      }
    }
    Path<size> result;
    if (distance[start] == nowhere) {
      result.length = nowhere;
      return result;
    }
    for (std::size_t node = start; node != goal;) {
      for (std::size_t e = 0; e < size; ++e) {
        const bool forward = first[e] == node && distance[second[e]] + 1 == distance[node];
        const bool backward = second[e] == node && distance[first[e]] + 1 == distance[node];
        if (!forward && !backward) continue;
        result.edge[result.length] = e;
        result.reversed[result.length++] = backward;
        node = forward ? second[e] : first[e];
        break;
      }
    }
    return result;
  }

  template <class Start, class Goal>
  static constexpr Path<size> path_between = path(node<Start>(), node<Goal>());

  template <class F> static constexpr bool knows = node<F>() != nowhere;

  template <class Start, class Goal> static constexpr bool joined() {
    if constexpr (knows<Start> && knows<Goal>) {
      return path_between<Start, Goal>.length != nowhere;
    } else {
      return false;
    }
  }

  /// The number of common steps of the paths from Start to Goal and from Start to Other.
  template <class Start, class Goal, class Other> static constexpr std::size_t shared_steps() {
    const auto& walk = path_between<Start, Goal>;
    const auto& other = path_between<Start, Other>;
    std::size_t step = 0;
    while (step < walk.length && step < other.length && walk.edge[step] == other.edge[step]) ++step;
    return step;
  }

  /// The frame where the paths from Start to Goal and from Start to Other part.
  template <class Start, class Goal, class Other> static constexpr auto parting_frame() {
    constexpr std::size_t steps = shared_steps<Start, Goal, Other>();
    if constexpr (steps == 0) {
      return std::type_identity<Start>{};
    } else {
      constexpr auto& walk = path_between<Start, Goal>;
      using Last = std::tuple_element_t<walk.edge[steps - 1], std::tuple<Edges...>>;
      return std::conditional_t<walk.reversed[steps - 1], std::type_identity<FirstOf<Last>>,
                                std::type_identity<SecondOf<Last>>>{};
    }
  }
  template <class Start, class Goal, class Other>
  using PartingFrame = typename decltype(parting_frame<Start, Goal, Other>())::type;

  /// The first edge from Start to Goal without a position; `nowhere` if all have one.
  template <class Start, class Goal> static constexpr std::size_t edge_without_place() {
    constexpr std::array<bool, size> placed{LevelOf<typename Edges::value_type>::placed...};
    const auto& walk = path_between<Start, Goal>;
    for (std::size_t i = 0; i < walk.length; ++i) {
      if (!placed[walk.edge[i]]) return walk.edge[i];
    }
    return nowhere;
  }

  /// The first edge from Start to Goal below `level`; `nowhere` if there is none.
  template <class Start, class Goal> static constexpr std::size_t edge_below(Level level) {
    constexpr std::array<Level, size> levels{LevelOf<typename Edges::value_type>::level...};
    const auto& walk = path_between<Start, Goal>;
    for (std::size_t i = 0; i < walk.length; ++i) {
      if (levels[walk.edge[i]] < level) return walk.edge[i];
    }
    return nowhere;
  }

  /// The frames of the edge with that number; void if it is `nowhere`.
  template <std::size_t edge> static constexpr auto link_at() {
    if constexpr (edge == nowhere) {
      return std::type_identity<void>{};
    } else {
      return std::type_identity<LinkOf<std::tuple_element_t<edge, std::tuple<Edges...>>>>{};
    }
  }
  template <std::size_t edge> using LinkAt = typename decltype(link_at<edge>())::type;
};

template <class Edges, class Count> struct FirstEdges;
template <class... Edges, std::size_t... I>
struct FirstEdges<std::tuple<Edges...>, std::index_sequence<I...>>
    : std::type_identity<Topology<std::tuple_element_t<I, std::tuple<Edges...>>...>> {};
/// The edges listed before edge number `edge`. The edge may ask only these, so no edge can depend on itself.
template <std::size_t edge, class... Edges>
using EdgesBefore = typename FirstEdges<std::tuple<Edges...>, std::make_index_sequence<edge>>::type;

}  // namespace detail
}  // namespace vectrix
