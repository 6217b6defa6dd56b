#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/frames/graph/lacks.hpp>
#include <vectrix/frames/graph/places.hpp>

namespace vectrix {

template <class Instant, class... Edges> class GraphSnapshot;

namespace detail {

template <class Edges, class Count> struct FirstEdges;
template <class... Edges, std::size_t... I>
struct FirstEdges<std::tuple<Edges...>, std::index_sequence<I...>>
    : std::type_identity<Topology<std::tuple_element_t<I, std::tuple<Edges...>>...>> {};

/// The edges that a snapshot can be asked about.
template <class Snapshot> struct TopologyOf;
template <class Instant, class... Edges>
struct TopologyOf<GraphSnapshot<Instant, Edges...>> : std::type_identity<Topology<Edges...>> {};
template <std::size_t count, class Instant, class... Edges>
struct TopologyOf<EarlierEdges<count, Instant, Edges...>>
    : FirstEdges<std::tuple<Edges...>, std::make_index_sequence<count>> {};

/// The questions that a frame graph answers at one instant. `kept_walk()` of the Snapshot keeps the value of
/// each edge it passes, `fresh_walk()` does not. A question that cannot be answered is refused, and `Lacking`
/// says why.
template <class Snapshot> class GraphQueries {
  using Topology = typename TopologyOf<Snapshot>::type;

  template <Level level, class B, class A, class C>
  using Lack = typename decltype(lacks<Topology, level, B, A, C>())::type;
  template <Level level, class Q, class P, class A, class C>
  using LackOfPlace = typename decltype(lacks_place<Topology, level, Q, P, A, C>())::type;
  template <class B, class A>
  using LackOfTransform = typename decltype(lacks_transform<Topology, B, A>())::type;

  template <class Lacking> using Answered = std::enable_if_t<std::is_same_v<Lacking, Nothing>, int>;
  template <class Lacking> using Unanswered = std::enable_if_t<!std::is_same_v<Lacking, Nothing>, Lacking>;

 public:
  /// R_a^b between any two joined frames.
  template <class B, class A, Answered<Lack<Level::rotation, B, A, A>> = 0>
  auto rotation(To<B>, From<A>) const& {
    return self().kept_walk().template rotation<B, A>();
  }
  template <class B, class A, Answered<Lack<Level::rotation, B, A, A>> = 0> auto rotation(To<B>, From<A>) && {
    return self().fresh_walk().template rotation<B, A>();
  }
  template <class B, class A, class Lacking = Unanswered<Lack<Level::rotation, B, A, A>>>
  auto rotation(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;

  /// w_ab^c, of b relative to a, expressed in c: needs the rate on every edge from a to b.
  template <class B, class A, class C, Answered<Lack<Level::rate, B, A, C>> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) const& {
    return self().kept_walk().template angular_velocity<B, A, C>();
  }
  template <class B, class A, class C, Answered<Lack<Level::rate, B, A, C>> = 0>
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) && {
    return self().fresh_walk().template angular_velocity<B, A, C>();
  }
  template <class B, class A, class C, class Lacking = Unanswered<Lack<Level::rate, B, A, C>>>
  auto angular_velocity(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;

  /// alpha_ab^c, of b relative to a, expressed in c: needs the acceleration on every edge from a to b.
  template <class B, class A, class C, Answered<Lack<Level::acceleration, B, A, C>> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const& {
    return self().kept_walk().template angular_acceleration<B, A, C>();
  }
  template <class B, class A, class C, Answered<Lack<Level::acceleration, B, A, C>> = 0>
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) && {
    return self().fresh_walk().template angular_acceleration<B, A, C>();
  }
  template <class B, class A, class C, class Lacking = Unanswered<Lack<Level::acceleration, B, A, C>>>
  auto angular_acceleration(  // the graph lacks something to answer: see Lacking
      Of<B>, RelativeTo<A>, In<C>) const -> Refused = delete;

  /// X_a^b: needs the place on every edge from a to b.
  template <class B, class A, Answered<LackOfTransform<B, A>> = 0> auto transform(To<B>, From<A>) const {
    return self().kept_walk().template transform<B, A>();
  }
  template <class B, class A, class Lacking = Unanswered<LackOfTransform<B, A>>>
  auto transform(  // the graph lacks something to answer: see Lacking
      To<B>, From<A>) const -> Refused = delete;

  /// r_pq^c, of q's origin relative to p's, expressed in c: needs the place on every edge from p to q.
  template <class Q, class P, class C, Answered<LackOfPlace<Level::rotation, Q, P, P, C>> = 0>
  auto position(Of<Q>, RelativeTo<P>, In<C>) const {
    return self().kept_walk().template position<Q, P, C>();
  }
  template <class Q, class P, class C, class Lacking = Unanswered<LackOfPlace<Level::rotation, Q, P, P, C>>>
  auto position(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, In<C>) const -> Refused = delete;

  /// v_pq|a^c, of q's origin relative to p's, observed from a, expressed in c: needs place and rate on every
  /// edge from p to q, and the rate on every edge from there to a.
  template <class Q, class P, class A, class C, Answered<LackOfPlace<Level::rate, Q, P, A, C>> = 0>
  auto velocity(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return self().kept_walk().template velocity<Q, P, A, C>();
  }
  template <class Q, class P, class A, class C,
            class Lacking = Unanswered<LackOfPlace<Level::rate, Q, P, A, C>>>
  auto velocity(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;

  /// a_pq|a^c, likewise: needs the accelerations.
  template <class Q, class P, class A, class C, Answered<LackOfPlace<Level::acceleration, Q, P, A, C>> = 0>
  auto acceleration(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const {
    return self().kept_walk().template acceleration<Q, P, A, C>();
  }
  template <class Q, class P, class A, class C,
            class Lacking = Unanswered<LackOfPlace<Level::acceleration, Q, P, A, C>>>
  auto acceleration(  // the graph lacks something to answer: see Lacking
      Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) const -> Refused = delete;

 private:
  const Snapshot& self() const { return static_cast<const Snapshot&>(*this); }
};

/// The snapshot as the edge number `count` sees it: the edges listed before it, at the same instant. So no
/// edge can ask for itself.
template <std::size_t count, class Instant, class... Edges>
class EarlierEdges : public GraphQueries<EarlierEdges<count, Instant, Edges...>> {
 public:
  explicit EarlierEdges(const Evaluation<Instant, Edges...>& evaluation) : evaluation_(evaluation) {}

  const Instant& instant() const { return evaluation_.instant; }

 private:
  friend GraphQueries<EarlierEdges>;
  auto kept_walk() const {
    using Values = KeptValues<Instant, Edges...>;
    return PlaceWalk<typename TopologyOf<EarlierEdges>::type, Values>{Values{evaluation_}};
  }
  auto fresh_walk() const { return kept_walk(); }

  const Evaluation<Instant, Edges...>& evaluation_;
};

}  // namespace detail

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
template <class Instant, class... Edges>
class GraphSnapshot : public detail::GraphQueries<GraphSnapshot<Instant, Edges...>> {
 public:
  GraphSnapshot(const std::tuple<Edges...>& edges, const Instant& instant)
      : evaluation_{edges, instant, {}} {}

  const Instant& instant() const { return evaluation_.instant; }

 private:
  friend detail::GraphQueries<GraphSnapshot>;
  auto kept_walk() const {
    using Values = detail::KeptValues<Instant, Edges...>;
    return detail::PlaceWalk<detail::Topology<Edges...>, Values>{Values{evaluation_}};
  }
  auto fresh_walk() const {
    if constexpr ((detail::takes_snapshot<Edges> || ...)) {
      return kept_walk();  // what an edge asks for, the path may pass too
    } else {
      using Values = detail::FreshValues<Instant, Edges...>;
      return detail::GraphWalk<detail::Topology<Edges...>, Values>{
          Values{evaluation_.edges, evaluation_.instant}};
    }
  }

  detail::Evaluation<Instant, Edges...> evaluation_;
};

}  // namespace vectrix
