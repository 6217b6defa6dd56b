#pragma once

#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vectrix/frames/graph_path.hpp>

namespace vectrix {
namespace detail {

struct NotCached {};

template <class Edge> struct CacheOf { using type = std::optional<typename Edge::value_type>; };
template <class V> struct CacheOf<ConstantEdge<V>> { using type = NotCached; };

/// An instant that is a quantity, under the short name of its unit: the compiler's messages stay readable.
template <Unit U, class S> struct QuantityInstant {
  Quantity<U, S> value;
  operator const Quantity<U, S>&() const { return value; }
};

template <class Topology, class... Fs> struct FirstUnknown : std::type_identity<void> {};
template <class Topology, class F, class... Fs>
struct FirstUnknown<Topology, F, Fs...>
    : std::conditional_t<Topology::template knows<F>, FirstUnknown<Topology, Fs...>, std::type_identity<F>> {
};

template <bool reversed, class Value> decltype(auto) oriented(const Value& value) {
  if constexpr (reversed) {
    return inverse(value);
  } else {
    return (value);
  }
}

/// The value of an edge, or its inverse, and the product of what is before it with that.
template <bool reversed, class Value> auto times(const Value& value) {
  return oriented<reversed>(value);
}
template <bool reversed, class Value, class Before> auto times(const Value& value, const Before& before) {
  return before * oriented<reversed>(value);
}

}  // namespace detail

template <class... Edges> class FrameGraph;

/// A frame graph at one instant. Answers what the path between two frames knows; each edge on it is evaluated
/// once. Holds a reference to the graph. Not for use by two threads at once: take one snapshot per thread.
template <class Instant, class... Edges> class GraphSnapshot {
  using Topology = detail::Topology<Edges...>;

  // Nested so that the constraints below can be named in one word each.
  template <class... Fs> static constexpr bool all_known = (Topology::template knows<Fs> && ...);
  template <class... Fs> using FirstUnknown = typename detail::FirstUnknown<Topology, Fs...>::type;
  template <class A, class B> static constexpr bool joined = Topology::template joined<A, B>();
  template <class A, class B, Level level> static constexpr bool knows_level() {
    if constexpr (joined<A, B>) {
      return Topology::template edge_below<A, B>(level) == detail::nowhere;
    } else {
      return false;
    }
  }
  template <class A, class B, Level level>
  using EdgeBelow = typename Topology::template LinkAt<Topology::template edge_below<A, B>(level)>;

 public:
  GraphSnapshot(const std::tuple<Edges...>& edges, const Instant& instant)
      : edges_(edges), instant_(instant) {}

  /// R_a^b between any two joined frames.
  template <class B, class A>
    requires joined<B, A>
  auto rotation(To<B>, From<A>) const {
    if constexpr (std::is_same_v<A, B>) {
      return Dcm<B, A>{detail::trusted, detail::Square<double>::Identity()};
    } else {
      return walk<B, A>([](const auto& value) -> decltype(auto) { return rotation_of(value); });
    }
  }

  /// w_ab^c, of b relative to a, expressed in c: needs the rate on every edge from a to b.
  template <class B, class A, class C>
    requires(!std::is_same_v<A, B> && knows_level<A, B, Level::rate>() && joined<C, B>)
  auto angular_velocity(Of<B>, RelativeTo<A>, In<C>) const {
    // The paths from a to b and to c part at m: w_ab^m = w_am^m - w_bm^m, then from m to c. Each edge once.
    static constexpr auto& to_b = Topology::template path_between<A, B>;
    static constexpr std::size_t parting = Topology::template shared_steps<A, B, C>();
    if constexpr (parting == 0) {
      return carried<A, C, 0>(-rate<B, A, to_b.length>());
    } else if constexpr (parting == to_b.length) {
      return carried<A, C, parting>(rate<A, B, parting>());
    } else {
      return carried<A, C, parting>(rate<A, B, parting>() + -rate<B, A, to_b.length - parting>());
    }
  }

  /// alpha_ab^c, of b relative to a, expressed in c: needs the acceleration on every edge from a to b.
  template <class B, class A, class C>
    requires(!std::is_same_v<A, B> && knows_level<A, B, Level::acceleration>() && joined<C, B>)
  auto angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const {
    const auto R_a_from_b = walk<A, B>([](const auto& value) -> decltype(auto) { return (value); });
    return reexpressed<C, B>(angular_acceleration_of(R_a_from_b));
  }

  template <class B, class A, class UnknownFrame = FirstUnknown<B, A>>
    requires(!all_known<B, A>)
  void rotation(To<B>, From<A>) const = delete;  // the graph has no such frame
  template <class ToFrame, class FromFrame>
    requires(all_known<ToFrame, FromFrame> && !joined<ToFrame, FromFrame>)
  void rotation(To<ToFrame>, From<FromFrame>) const = delete;  // no path between the two frames

  template <class B, class A, class C, class UnknownFrame = FirstUnknown<B, A, C>>
    requires(!all_known<B, A, C>)
  void angular_velocity(Of<B>, RelativeTo<A>, In<C>) const = delete;  // the graph has no such frame
  template <class OfFrame, class RelativeFrame, class InFrame>
    requires(all_known<OfFrame, RelativeFrame, InFrame> &&
             !(joined<OfFrame, RelativeFrame> && joined<OfFrame, InFrame>))
  void angular_velocity(Of<OfFrame>,  // no path between the frames
                        RelativeTo<RelativeFrame>, In<InFrame>) const = delete;
  template <class B, class A, class C, class EdgeWithoutRate = EdgeBelow<A, B, Level::rate>>
    requires(joined<A, B>&& joined<C, B> && !knows_level<A, B, Level::rate>())
  void angular_velocity(Of<B>, RelativeTo<A>, In<C>) const = delete;  // an edge on the path has no rate

  template <class SameFrame, class C>
  void angular_velocity(Of<SameFrame>,  // a frame does not turn relative to itself
                        RelativeTo<SameFrame>, In<C>) const = delete;

  template <class B, class A, class C, class UnknownFrame = FirstUnknown<B, A, C>>
    requires(!all_known<B, A, C>)
  void angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const = delete;  // the graph has no such frame
  template <class OfFrame, class RelativeFrame, class InFrame>
    requires(all_known<OfFrame, RelativeFrame, InFrame> &&
             !(joined<OfFrame, RelativeFrame> && joined<OfFrame, InFrame>))
  void angular_acceleration(Of<OfFrame>,  // no path between the frames
                            RelativeTo<RelativeFrame>, In<InFrame>) const = delete;
  template <class B, class A, class C, class EdgeWithoutAcceleration = EdgeBelow<A, B, Level::acceleration>>
    requires(joined<A, B>&& joined<C, B> && !knows_level<A, B, Level::acceleration>())
  void angular_acceleration(Of<B>, RelativeTo<A>, In<C>) const = delete;  // an edge has no acceleration

  template <class SameFrame, class C>
  void angular_acceleration(Of<SameFrame>,  // a frame does not turn relative to itself
                            RelativeTo<SameFrame>, In<C>) const = delete;

 private:
  template <std::size_t I> const auto& value() const {
    const auto& edge = std::get<I>(edges_);
    auto& cache = std::get<I>(cache_);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(cache)>, detail::NotCached>) {
      return edge.value();
    } else {
      if (!cache) cache.emplace(edge(instant_));
      return *cache;
    }
  }

  // The product, from A to B, of `part` of each edge's value, turned into the direction of the walk; `before`
  // is that of the first `step` edges.
  template <class A, class B, std::size_t step = 0, class Part, class... Product>
  auto walk(Part part, const Product&... before) const {
    static constexpr auto& path = Topology::template path_between<A, B>;
    if constexpr (step == path.length) {
      return (before, ...);
    } else {
      const auto& here = part(value<path.edge[step]>());
      return walk<A, B, step + 1>(part, detail::times<path.reversed[step]>(here, before...));
    }
  }

  // w_am^m, of the frame m that is `end` steps from A on the way to B; `before` is that of the first `step`
  // edges.
  template <class A, class B, std::size_t end, std::size_t step = 0, class... Rate>
  auto rate(const Rate&... before) const {
    static constexpr auto& path = Topology::template path_between<A, B>;
    if constexpr (step == end) {
      return (before, ...);
    } else {
      const auto& here = moving_part(value<path.edge[step]>());
      if constexpr (path.reversed[step]) {
        return rate<A, B, end, step + 1>(rate_against(here, before...));
      } else {
        return rate<A, B, end, step + 1>(rate_along(here, before...));
      }
    }
  }

  // A vector given in the frame `step` steps from A on the way to C, expressed in C.
  template <class A, class C, std::size_t step, class Rate> auto carried(const Rate& rate) const {
    static constexpr auto& path = Topology::template path_between<A, C>;
    if constexpr (step == path.length) {
      return rate;
    } else {
      const auto& here = rotation_of(value<path.edge[step]>());
      return carried<A, C, step + 1>(detail::oriented<!path.reversed[step]>(here) * rate);
    }
  }

  template <class C, class B, class Rate> auto reexpressed(const Rate& rate_b) const {
    if constexpr (std::is_same_v<C, B>) {
      return rate_b;
    } else {
      return rotation(to<C>, from<B>) * rate_b;
    }
  }

  const std::tuple<Edges...>& edges_;
  Instant instant_;
  mutable std::tuple<typename detail::CacheOf<Edges>::type...> cache_;
};

/// A tree of frames known at compile time. Its edges are fixed values or functions of the instant, joined by
/// `frame_graph(...)`. `graph.at(t)` is the graph at one instant:
///     graph.at(t).rotation(to<Camera>, from<Itrf>)
///     graph.at(t).angular_velocity(of<Camera>, relative_to<Itrf>, in<Camera>)
///     graph.at(t).angular_acceleration(of<Camera>, relative_to<Itrf>, in<Camera>)
/// The path is found at compile time. An unknown frame, no path, two paths, or asking an edge for more than
/// it knows does not compile.
template <class... Edges> class FrameGraph {
 public:
  explicit FrameGraph(Edges... edges) : edges_(std::move(edges)...) {}

  template <class Instant> GraphSnapshot<Instant, Edges...> at(const Instant& instant) const& {
    return {edges_, instant};
  }
  template <class BoostUnit, class S>
  GraphSnapshot<detail::QuantityInstant<unit_tag<BoostUnit>, S>, Edges...> at(
      const AnyQuantity<BoostUnit, S>& instant) const& {
    return {edges_, {instant}};
  }
  template <class Instant>
  void at(const Instant&) const&& = delete;  // the snapshot refers to the graph: give the graph a name first

 private:
  std::tuple<Edges...> edges_;
};

namespace detail {

template <class... Edges> inline constexpr bool is_tree = Topology<Edges...>::closing_edge() == nowhere;

}  // namespace detail

template <class... Edges>
  requires(sizeof...(Edges) > 0 && detail::is_tree<Edges...>)
FrameGraph<Edges...> frame_graph(Edges... edges) {
  return FrameGraph<Edges...>{std::move(edges)...};
}
template <class... Edges, class ClosingEdge = typename detail::Topology<Edges...>::template LinkAt<
                              detail::Topology<Edges...>::closing_edge()>>
  requires(sizeof...(Edges) > 0 && !detail::is_tree<Edges...>)
void frame_graph(Edges... edges) = delete;  // two paths between the frames of the closing edge

}  // namespace vectrix
