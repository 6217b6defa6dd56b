#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/frames/graph/lacks.hpp>
#include <vectrix/frames/graph/places.hpp>

namespace vectrix {

// Each question defines lacking(), what a graph lacks to answer it (else Nothing), and answer(), which
// computes it by a walk.

/// R_a^b between any two joined frames.
template <class B, class A> struct AskRotation {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks<Topology, Level::rotation, B, A, A>();
  }
  template <class Walk> static auto answer(const Walk& walk) { return walk.template rotation<B, A>(); }
};

/// w_ab^c, of b relative to a, expressed in c: needs the rate on every edge from a to b.
template <class B, class A, class C> struct AskAngularVelocity {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks<Topology, Level::rate, B, A, C>();
  }
  template <class Walk> static auto answer(const Walk& walk) {
    return walk.template angular_velocity<B, A, C>();
  }
};

/// alpha_ab^c, of b relative to a, expressed in c: needs the acceleration on every edge from a to b.
template <class B, class A, class C> struct AskAngularAcceleration {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks<Topology, Level::acceleration, B, A, C>();
  }
  template <class Walk> static auto answer(const Walk& walk) {
    return walk.template angular_acceleration<B, A, C>();
  }
};

/// X_a^b: needs the position on every edge from a to b.
template <class B, class A> struct AskTransform {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks_transform<Topology, B, A>();
  }
  template <class Walk> static auto answer(const Walk& walk) { return walk.template transform<B, A>(); }
};

/// r_pq^c, of q's origin relative to p's, expressed in c: needs the position on every edge from p to q.
template <class Q, class P, class C> struct AskPosition {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks_place<Topology, Level::rotation, Q, P, P, C>();
  }
  template <class Walk> static auto answer(const Walk& walk) { return walk.template position<Q, P, C>(); }
};

/// v_pq|a^c, of q's origin relative to p's, observed from a, expressed in c: needs position and rate on every
/// edge from p to q, and the rate on every edge from that path to a.
template <class Q, class P, class A, class C> struct AskVelocity {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks_place<Topology, Level::rate, Q, P, A, C>();
  }
  template <class Walk> static auto answer(const Walk& walk) { return walk.template velocity<Q, P, A, C>(); }
};

/// a_pq|a^c: as AskVelocity, with accelerations instead of rates.
template <class Q, class P, class A, class C> struct AskAcceleration {
  template <class Topology> static constexpr auto lacking() {
    return detail::lacks_place<Topology, Level::acceleration, Q, P, A, C>();
  }
  template <class Walk> static auto answer(const Walk& walk) {
    return walk.template acceleration<Q, P, A, C>();
  }
};

namespace detail {

template <class Question, class Topology>
using LackOf = typename decltype(Question::template lacking<Topology>())::type;

/// An argument of the function of edge number `edge`: an answer of the edges before it, or the instant.
template <class Values, std::size_t edge, class Argument> decltype(auto) argument_of(const Values& values) {
  if constexpr (is_answer<Argument>) {
    using Before = typename Values::template Before<edge>;
    return QuestionOf<Argument>::type::answer(PlaceWalk<Before, Values>{values});
  } else {
    return (values.evaluation.instant);
  }
}

/// What the edges before an edge lack for its first question that they cannot answer; Nothing if they answer
/// all.
template <class Before, class... Arguments> struct FirstLack : std::type_identity<Nothing> {};
template <class Before, class Argument, class... Arguments> struct FirstLack<Before, Argument, Arguments...> {
  static constexpr auto lack() {
    if constexpr (!is_answer<Argument>) {
      return FirstLack<Before, Arguments...>{};
    } else {
      using Lack = LackOf<typename QuestionOf<Argument>::type, Before>;
      return std::conditional_t<std::is_same_v<Lack, Nothing>, FirstLack<Before, Arguments...>,
                                std::type_identity<Lack>>{};
    }
  }
  using type = typename decltype(lack())::type;
};

template <class Before, class Edge> struct LackOfEdgeType : std::type_identity<Nothing> {};
template <class Before, class Function>
struct LackOfEdgeType<Before, FunctionEdge<Function>> : LackOfEdgeType<Before, Arguments<Function>> {};
template <class Before, class... Arguments>
struct LackOfEdgeType<Before, std::tuple<Arguments...>> : FirstLack<Before, Arguments...> {};
template <class Before, class Edge> using LackOfEdge = typename LackOfEdgeType<Before, Edge>::type;

}  // namespace detail
}  // namespace vectrix
