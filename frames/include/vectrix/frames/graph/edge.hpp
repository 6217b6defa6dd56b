#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <vectrix/frames/graph/level.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix {

namespace detail {

/// An instant that is a quantity, under the short name of its unit: the compiler's messages stay readable.
template <Unit U, class S> struct QuantityInstant {
  Quantity<U, S> value;
  operator const Quantity<U, S>&() const { return value; }
};

}  // namespace detail

/// An edge of a frame graph whose value never changes.
template <EdgeValue V> class ConstantEdge {
 public:
  using value_type = V;

  template <class Instant> static constexpr bool takes = true;

  explicit ConstantEdge(const V& value) : value_(value) {}
  const V& value() const& { return value_; }
  V value() && { return value_; }

 private:
  V value_;
};

/// An edge of a frame graph that is a function of the instant: of time, of a state, of whatever the graph is
/// asked at.
template <class Function, EdgeValue V> class FunctionEdge {
 public:
  using value_type = V;

  template <class Instant> static constexpr bool takes = std::is_invocable_v<const Function&, const Instant&>;

  explicit FunctionEdge(Function function) : function_(std::move(function)) {}

  template <class Instant> V operator()(const Instant& instant) const { return function_(instant); }

 private:
  Function function_;
};

/// An edge of a frame graph that is a function of the graph's snapshot: of what the edges listed before it
/// are at the same instant.
template <class Function, EdgeValue V> class SnapshotEdge {
 public:
  using value_type = V;

  template <class Instant> static constexpr bool takes = true;

  explicit SnapshotEdge(Function function) : function_(std::move(function)) {}

  template <class Snapshot> V operator()(const Snapshot& now) const { return function_(now); }

 private:
  Function function_;
};

/// A fixed rotation and nothing more: no rate can be asked across it. rigid_edge() in kinematics claims rest
/// as well.
template <class A, class B, class S> ConstantEdge<Dcm<A, B, S>> static_edge(const Dcm<A, B, S>& R_a_from_b) {
  return ConstantEdge<Dcm<A, B, S>>{R_a_from_b};
}

/// A fixed place and rotation, and nothing more.
template <class A, class B, class S>
ConstantEdge<Transform<A, B, S>> static_edge(const Transform<A, B, S>& X_a_from_b) {
  return ConstantEdge<Transform<A, B, S>>{X_a_from_b};
}

/// What a function of any instant returns, for messages.
struct DependsOnInstant {};

namespace detail {

template <class Signature> struct ResultOf;
template <class Result, class... Arguments> struct ResultOf<std::function<Result(Arguments...)>> {
  using type = Evaluated<std::remove_cvref_t<Result>>;
};
template <class Function> constexpr auto result_of() {
  if constexpr (requires { std::function{std::declval<Function>()}; }) {
    return ResultOf<decltype(std::function{std::declval<Function>()})>{};
  } else {
    return std::type_identity<DependsOnInstant>{};
  }
}
template <class Function> using Result = typename decltype(result_of<Function>())::type;

template <class Function, class V> struct FunctionEdgeIf {};
template <class Function, EdgeValue V>
struct FunctionEdgeIf<Function, V> : std::type_identity<FunctionEdge<Function, V>> {};
template <class Function> using FunctionEdgeOf = typename FunctionEdgeIf<Function, Result<Function>>::type;

}  // namespace detail

/// The edge whose value at an instant is f(instant). f has one call operator, not a template, and returns a
/// Dcm, a MovingDcm or an AcceleratingDcm, or one of these with a place: a Transform, a MovingTransform or an
/// AcceleratingTransform. Frames and level are read off that type.
///     edge([](Quantity<si::time> t) { return turned_z(to<Itrf>, from<Gcrf>, rate * t); })
template <class Function> detail::FunctionEdgeOf<Function> edge(Function function) {
  return detail::FunctionEdgeOf<Function>{std::move(function)};
}
template <class Function, class Returned = detail::Result<Function>>
  requires(!EdgeValue<Returned>)
auto edge(  // of one type of instant; returns a Dcm, MovingDcm, AcceleratingDcm, or one with a place
    Function) -> Refused = delete;

/// The edge whose value, a V, follows from other edges of its graph at the same instant: f(now) asks `now` as
/// a snapshot is asked. It sees the edges listed before it in frame_graph(), and what they share is evaluated
/// once. `now.instant()` is the instant.
///     edge<Dcm<Gcrf, Lvlh>>([](const auto& now) { ... now.position(of<Ship>, relative_to<Gcrf>, in<Gcrf>)
///     ... })
template <EdgeValue V, class Function> SnapshotEdge<Function, V> edge(Function function) {
  return SnapshotEdge<Function, V>{std::move(function)};
}

}  // namespace vectrix
