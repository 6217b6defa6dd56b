#pragma once

#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/frames/graph/level.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix {

/// An edge of a frame graph with a constant value.
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

/// The result of a function with a template call operator, for messages.
struct DependsOnInstant {};

namespace detail {

template <class Signature> struct SignatureOf;
template <class Result, class... Arguments> struct SignatureOf<std::function<Result(Arguments...)>> {
  using result = Evaluated<std::remove_cvref_t<Result>>;
  using arguments = std::tuple<std::remove_cvref_t<Arguments>...>;
};
struct NoSignature {
  using result = DependsOnInstant;
  using arguments = std::tuple<>;
};
template <class Function> constexpr auto signature_of() {
  if constexpr (requires { std::function{std::declval<Function>()}; }) {
    return SignatureOf<decltype(std::function{std::declval<Function>()})>{};
  } else {
    return NoSignature{};
  }
}
template <class Function> using Result = typename decltype(signature_of<Function>())::result;
template <class Function> using Arguments = typename decltype(signature_of<Function>())::arguments;

template <class Argument>
inline constexpr bool is_answer = !std::is_void_v<typename QuestionOf<Argument>::type>;

/// A quantity is accepted in its own type only: whole seconds are refused.
template <class Instant, class Argument>
inline constexpr bool is_instant = std::is_convertible_v<const Instant&, Argument>;
template <class U, class S, class Argument>
inline constexpr bool is_instant<Quantity<U, S>, Argument> = std::is_same_v<Quantity<U, S>, Argument>;

template <class Arguments> struct ArgumentsOf;
template <class... Arguments> struct ArgumentsOf<std::tuple<Arguments...>> {
  static constexpr std::size_t answers = (std::size_t{0} + ... + is_answer<Arguments>);
  static constexpr bool has_answers = answers > 0;
  /// One instant at most: two would be given the same one.
  static constexpr bool lawful = sizeof...(Arguments) > 0 && sizeof...(Arguments) - answers <= 1;
  /// The argument that is not an answer of the graph must be convertible from the instant.
  template <class Instant>
  static constexpr bool take = ((is_answer<Arguments> || is_instant<Instant, Arguments>)&&...);
};

template <class Function>
inline constexpr bool makes_edge = EdgeValue<Result<Function>>&& ArgumentsOf<Arguments<Function>>::lawful;

}  // namespace detail

/// An edge of a frame graph that is a function. Its arguments are the instant (a time, a state or any type at
/// which the graph is asked) and answers of the edges listed before it at that instant.
template <class Function> class FunctionEdge {
 public:
  using value_type = detail::Result<Function>;
  using arguments = detail::Arguments<Function>;

  template <class Instant>
  static constexpr bool takes = detail::ArgumentsOf<arguments>::template take<Instant>;

  explicit FunctionEdge(Function function) : function_(std::move(function)) {}

  template <class... Arguments> value_type operator()(const Arguments&... given) const {
    return function_(given...);
  }

 private:
  Function function_;
};

/// A fixed rotation of unknown rate: no rate can be asked across it. rigid_edge() in kinematics also claims
/// rest.
template <class A, class B, class S> ConstantEdge<Dcm<A, B, S>> static_edge(const Dcm<A, B, S>& R_a_from_b) {
  return ConstantEdge<Dcm<A, B, S>>{R_a_from_b};
}

/// A fixed position and rotation of unknown rate.
template <class A, class B, class S>
ConstantEdge<Transform<A, B, S>> static_edge(const Transform<A, B, S>& X_a_from_b) {
  return ConstantEdge<Transform<A, B, S>>{X_a_from_b};
}

/// The edge whose value is f(...). f has one call operator, not a template. It returns a Dcm, MovingDcm or
/// AcceleratingDcm, or with a position a Transform, MovingTransform or AcceleratingTransform; this type gives
/// the frames and the level. The argument types of f select its inputs:
///     edge([](Quantity<si::time> t) { return turned_z(to<Itrf>, from<Gcrf>, rate * t); })
///     edge([](const Displacement<Gcrf, Ship, In<Gcrf>>& r, const Dcm<Gcrf, Itrf>& R) { ... })
/// An argument that is a rotation, rate, position, velocity or acceleration is answered by the edges listed
/// before this one, at the same instant. Edges that several others ask are evaluated once. Any other argument
/// is the instant.
template <class Function>
std::enable_if_t<detail::makes_edge<Function>, FunctionEdge<Function>> edge(Function function) {
  return FunctionEdge<Function>{std::move(function)};
}
template <class Function, class Returned = detail::Result<Function>>
  requires(!detail::makes_edge<Function>)
auto edge(  // of one instant and of answers; returns a Dcm, MovingDcm, AcceleratingDcm, or one with a place
    Function) -> Refused = delete;

}  // namespace vectrix
