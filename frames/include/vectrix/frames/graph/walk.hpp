#pragma once

#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vectrix/frames/graph/path.hpp>

namespace vectrix::detail {

template <class Edge> inline constexpr bool is_constant = false;
template <class V> inline constexpr bool is_constant<ConstantEdge<V>> = true;

/// Whether the function of an edge takes answers of other edges.
template <class Edge> inline constexpr bool asks = false;
template <class Function>
inline constexpr bool asks<FunctionEdge<Function>> = ArgumentsOf<Arguments<Function>>::has_answers;

/// The values of the edges at an instant, evaluated at each request.
template <class Instant, class... Edges> struct FreshValues {
  const std::tuple<Edges...>& edges;
  const Instant& instant;

  template <std::size_t I> decltype(auto) value() const {
    if constexpr (is_constant<std::tuple_element_t<I, std::tuple<Edges...>>>) {
      return std::get<I>(edges).value();
    } else {
      return std::get<I>(edges)(instant);
    }
  }
};

struct NotKept {};
template <class Edge>
using Kept = std::conditional_t<is_constant<Edge>, NotKept, std::optional<typename Edge::value_type>>;

/// The edges of a graph, an instant, and the values of the edges evaluated so far.
template <class Instant, class... Edges> struct Evaluation {
  const std::tuple<Edges...>& edges;
  Instant instant;
  mutable std::tuple<Kept<Edges>...> kept;
};

template <class Values, std::size_t edge, class Argument> decltype(auto) argument_of(const Values& values);

/// The same, but the values are kept between queries and shared with the edges that ask others.
template <class Instant, class... Edges> struct KeptValues {
  template <std::size_t edge> using Before = EdgesBefore<edge, Edges...>;

  const Evaluation<Instant, Edges...>& evaluation;

  template <std::size_t I> const auto& value() const {
    using Edge = std::tuple_element_t<I, std::tuple<Edges...>>;
    const Edge& edge = std::get<I>(evaluation.edges);
    if constexpr (is_constant<Edge>) {
      return edge.value();
    } else {
      auto& value = std::get<I>(evaluation.kept);
      if (!value) {
        if constexpr (asks<Edge>) {
          value.emplace(evaluated<I>(edge, std::type_identity<typename Edge::arguments>{}));
        } else {
          value.emplace(edge(evaluation.instant));
        }
      }
      return *value;
    }
  }

 private:
  template <std::size_t I, class Edge, class... Arguments>
  auto evaluated(const Edge& edge, std::type_identity<std::tuple<Arguments...>>) const {
    return edge(argument_of<KeptValues, I, Arguments>(*this)...);
  }
};

template <bool reversed, class Value> decltype(auto) oriented(const Value& value) {
  if constexpr (reversed) {
    return inverse(value);
  } else {
    return (value);
  }
}

/// The value of an edge, or its inverse; with `before`, the product of `before` and that.
template <bool reversed, class Value> decltype(auto) times(const Value& value) {
  return oriented<reversed>(value);
}
template <bool reversed, class Value, class Before> auto times(const Value& value, const Before& before) {
  return before * oriented<reversed>(value);
}
template <bool reversed, class X, class A, class B, class S>
  requires(!reversed)
Dcm<X, B, S> times(const Dcm<A, B, S>& R_a_from_b, const Dcm<X, A, S>& R_x_from_a) {
  return composed(R_x_from_a, R_a_from_b);
}
/// No transposed copy: it is stored one by one and loaded in pairs, which causes a store-forwarding stall.
template <bool reversed, class X, class A, class B, class S>
  requires reversed Dcm<X, A, S> times(const Dcm<A, B, S>& R_a_from_b, const Dcm<X, B, S>& R_x_from_b) {
    return {trusted, R_x_from_b.matrix() * R_a_from_b.matrix().transpose()};
  }

/// The answers of a frame graph at one instant. `values.template value<I>()` is the value of edge I; each
/// answer asks for it once per edge on the path.
template <class Topology, class Values> class GraphWalk {
 public:
  explicit GraphWalk(const Values& values) : values_(values) {}

  // R_a^b
  template <class B, class A> auto rotation() const {
    if constexpr (std::is_same_v<A, B>) {
      using S = typename Topology::scalar;
      return Dcm<B, A, S>{trusted, Square<S>::Identity()};
    } else {
      return product<B, A, Topology::template path_between<B, A>.length>(
          [](const auto& value) -> decltype(auto) { return rotation_of(value); });
    }
  }

  // The paths from a to b and from a to c part at m: w_ab^m = w_am^m + w_mb^m, then re-expressed from m in c.
  template <class B, class A, class C> [[gnu::always_inline]] auto angular_velocity() const {
    static constexpr auto& to_b = Topology::template path_between<A, B>;
    static constexpr std::size_t parting = Topology::template shared_steps<A, B, C>();
    return carried<A, C, parting>([&]() __attribute__((always_inline)) {
      if constexpr (parting == 0) {
        return rate_back<A, B, 0>();
      } else if constexpr (parting == to_b.length) {
        return rate<A, B, parting>();
      } else {
        return rate<A, B, parting>() + rate_back<A, B, parting>();
      }
    });
  }

  // alpha_ab^m = alpha_am^m - alpha_bm^m + w_am^m x (-w_bm^m), then re-expressed from m in c.
  template <class B, class A, class C> auto angular_acceleration() const {
    static constexpr auto& to_b = Topology::template path_between<A, B>;
    static constexpr std::size_t parting = Topology::template shared_steps<A, B, C>();
    const auto whole = [](const auto& value) -> decltype(auto) { return accelerating_part(value); };
    return carried<A, C, parting>([&] {
      if constexpr (parting == 0) {
        return -angular_acceleration_of(product<B, A, to_b.length>(whole));
      } else if constexpr (parting == to_b.length) {
        return angular_acceleration_of(product<A, B, parting>(whole));
      } else {
        const auto am = product<A, B, parting>(whole);
        const auto bm = product<B, A, to_b.length - parting>(whole);
        return chain(angular_acceleration_of(am), -angular_acceleration_of(bm), angular_velocity_of(am),
                     -angular_velocity_of(bm));
      }
    });
  }

 protected:
  // The product of part(value) over the first `end` edges from A to B, each inverted if it is passed
  // backwards. `before` is the product over the first `step` edges.
  template <class A, class B, std::size_t end, std::size_t step = 0, class Part, class... Product>
  auto product(Part part, const Product&... before) const {
    static constexpr auto& path = Topology::template path_between<A, B>;
    const auto& here = value<path.edge[step]>();
    if constexpr (step + 1 == end) {
      return times<path.reversed[step]>(part(here), before...);
    } else {
      return product<A, B, end, step + 1>(part, times<path.reversed[step]>(part(here), before...));
    }
  }

  // w_am^m, where m is `end` steps from A on the path to B; `before` is the rate after `step` steps. All
  // functions of a rate query are always_inline: clang would otherwise call them and prepare unused values.
  template <class A, class B, std::size_t end, std::size_t step = 0, class... Rate>
  [[gnu::always_inline]] auto rate(const Rate&... before) const {
    static constexpr auto& path = Topology::template path_between<A, B>;
    const auto& here = value<path.edge[step]>();
    const auto next = [&] {
      if constexpr (path.reversed[step]) {
        return rate_against(rotation_of(here), angular_velocity_of(here), before...);
      } else {
        return rate_along(rotation_of(here), angular_velocity_of(here), before...);
      }
    };
    if constexpr (step + 1 == end) {
      return next();
    } else {
      return rate<A, B, end, step + 1>(next());
    }
  }

  // w_mb^m, where m is `step` steps from A on the path to B.
  template <class A, class B, std::size_t step> [[gnu::always_inline]] auto rate_back() const {
    static constexpr auto& path = Topology::template path_between<A, B>;
    if constexpr (step + 1 == path.length) {
      return rate_back_over<path.edge[step], path.reversed[step]>();
    } else {
      return rate_back_over<path.edge[step], path.reversed[step]>(rate_back<A, B, step + 1>());
    }
  }
  template <std::size_t edge, bool reversed, class... Rate>
  [[gnu::always_inline]] auto rate_back_over(const Rate&... beyond) const {
    const auto& here = value<edge>();
    if constexpr (reversed) {
      return rate_back_against(rotation_of(here), angular_velocity_of(here), beyond...);
    } else {
      return rate_back_along(rotation_of(here), angular_velocity_of(here), beyond...);
    }
  }

  template <std::size_t edge> decltype(auto) value() const { return values_.template value<edge>(); }

  // The result of `rate()` in the frame `step` steps from A on the path to C, re-expressed in C, without
  // copies.
  template <class A, class C, std::size_t step, class Rate>
  [[gnu::always_inline]] auto carried(Rate rate) const {
    static constexpr auto& path = Topology::template path_between<A, C>;
    if constexpr (step == path.length) {
      return rate();
    } else {
      const auto& here = value<path.edge[step]>();
      return carried<A, C, step + 1>([&]() __attribute__((always_inline)) {
        return oriented<!path.reversed[step]>(rotation_of(here)) * rate();
      });
    }
  }

 private:
  Values values_;
};

}  // namespace vectrix::detail
