#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/named/transform.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

namespace vectrix {
namespace detail {

/// The motion of frame b relative to a: R_b^a, and depending on the level w_ab^b and alpha_ab^b.
struct EdgeMotion {
  Square<double> R;
  Column<double> w, alpha;
};

/// The same, and the motion of b's origin: r_ab^a, v_ab|a^a and a_ab|a^a.
struct PlacedMotion {
  EdgeMotion turning;
  Column<double> r, v, a;
};

/// The numbers of an edge of a NamedGraph. Immutable: threads read it at the same time.
class EdgeFunction {
 public:
  EdgeFunction(Level level, bool placed) : level_(level), placed_(placed) {}
  EdgeFunction(const EdgeFunction&) = delete;
  EdgeFunction& operator=(const EdgeFunction&) = delete;
  virtual ~EdgeFunction() = default;

  Level level() const { return level_; }
  /// Whether it has the position of the second frame's origin, and of its motion what the level says.
  bool placed() const { return placed_; }
  /// The value, if it is constant; else null.
  virtual const PlacedMotion* constant() const { return nullptr; }
  virtual Square<double> rotation(double t) const = 0;
  /// Whether the rotation is given as a quaternion. Products of several quaternions are cheaper.
  virtual bool in_quaternions() const { return false; }
  virtual Eigen::Quaterniond quaternion(double t) const { return Eigen::Quaterniond(rotation(t)); }
  virtual EdgeMotion motion(double t) const = 0;
  /// The motion with the place, if it has one.
  virtual PlacedMotion placed_motion(double t) const { return {motion(t), {}, {}, {}}; }

 private:
  Level level_;
  bool placed_;
};

}  // namespace detail

/// An edge before it is added to a NamedGraph: static_edge(R_a_from_b), rigid_edge(R_a_from_b), both also of
/// a NamedTransform, edge(To(a), From(b), f), sampled_edge(samples, longest_gap). It has a level, as in a
/// FrameGraph; a rate that is not known is not taken for zero.
class NamedEdge {
 public:
  NamedEdge(detail::Trusted, NamedFrame a, NamedFrame b, std::unique_ptr<const detail::EdgeFunction> function)
      : a_(a), b_(b), function_(std::move(function)) {}

  NamedFrame to() const { return a_; }
  NamedFrame from() const { return b_; }
  Level level() const { return function_->level(); }
  bool placed() const { return function_->placed(); }
  const detail::EdgeFunction& function() const { return *function_; }

 private:
  NamedFrame a_, b_;
  std::unique_ptr<const detail::EdgeFunction> function_;
};

namespace detail {

inline std::string described(const NamedEdge& edge) {
  return "the edge " + in_quotes(edge.to()) + " - " + in_quotes(edge.from());
}

class ConstantFunction final : public EdgeFunction {
 public:
  ConstantFunction(Level level, bool placed, const PlacedMotion& motion)
      : EdgeFunction(level, placed), motion_(motion) {}

  const PlacedMotion* constant() const override { return &motion_; }
  Square<double> rotation(double) const override { return motion_.turning.R; }
  EdgeMotion motion(double) const override { return motion_.turning; }
  PlacedMotion placed_motion(double) const override { return motion_; }

 private:
  PlacedMotion motion_;
};

template <class Value>
concept NamedPlaced = std::same_as<Value, NamedTransform> || std::same_as<Value, NamedMovingTransform> ||
    std::same_as<Value, NamedAcceleratingTransform>;
template <class Value>
concept NamedEdgeValue = std::same_as<Value, NamedDcm> || std::same_as<Value, NamedMovingDcm> ||
    std::same_as<Value, NamedAcceleratingDcm> || NamedPlaced<Value>;

// What is known of a value of any level, typed or named.
template <class Value> inline constexpr Level level_of = LevelOf<Value>::level;
template <> inline constexpr Level level_of<NamedDcm> = Level::rotation;
template <> inline constexpr Level level_of<NamedMovingDcm> = Level::rate;
template <> inline constexpr Level level_of<NamedAcceleratingDcm> = Level::acceleration;
template <> inline constexpr Level level_of<NamedTransform> = Level::rotation;
template <> inline constexpr Level level_of<NamedMovingTransform> = Level::rate;
template <> inline constexpr Level level_of<NamedAcceleratingTransform> = Level::acceleration;
template <class Value> inline constexpr bool is_placed = LevelOf<Value>::placed;
template <NamedEdgeValue Value> inline constexpr bool is_placed<Value> = NamedPlaced<Value>;

// The parts of a named value, by the words for the typed ones.
template <NamedEdgeValue Value> const auto& turning_of(const Value& value) {
  if constexpr (requires { value.turning(); }) {
    return value.turning();
  } else {
    return value;
  }
}
inline const NamedDcm& rotation_of(const NamedDcm& value) {
  return value;
}
template <NamedEdgeValue Value> const NamedDcm& rotation_of(const Value& value) {
  return turning_of(value).rotation();
}
template <NamedEdgeValue Value> const NamedAngularVelocity& angular_velocity_of(const Value& value) {
  return turning_of(value).angular_velocity();
}
template <NamedEdgeValue Value> const NamedAngularAcceleration& angular_acceleration_of(const Value& value) {
  return turning_of(value).angular_acceleration();
}

// The numbers of a value, typed or named.
template <class Value> EdgeMotion motion_of(const Value& value) {
  EdgeMotion motion;
  motion.R = rotation_of(value).matrix();
  if constexpr (level_of<Value> >= Level::rate) motion.w = angular_velocity_of(value).coordinates();
  if constexpr (level_of<Value> >= Level::acceleration)
    motion.alpha = angular_acceleration_of(value).coordinates();
  return motion;
}
template <class Value> PlacedMotion placed_motion_of(const Value& value) {
  PlacedMotion motion{motion_of(value), {}, {}, {}};
  if constexpr (NamedPlaced<Value>) {
    motion.r = value.translation().coordinates();
    if constexpr (level_of<Value> >= Level::rate) motion.v = value.velocity().coordinates();
    if constexpr (level_of<Value> >= Level::acceleration) motion.a = value.acceleration().coordinates();
  } else if constexpr (is_placed<Value>) {
    motion.r = value.translation.coordinates();
    if constexpr (level_of<Value> >= Level::rate) motion.v = value.velocity.coordinates();
    if constexpr (level_of<Value> >= Level::acceleration) motion.a = value.acceleration.coordinates();
  }
  return motion;
}

/// f(t), whose value is typed or named. Each call checks that a named value has the frames of the edge, and
/// that the rotation and the position are finite, because a trusted door checks nothing.
template <class Function, class Value> class FunctionOfTime final : public EdgeFunction {
 public:
  FunctionOfTime(NamedFrame a, NamedFrame b, Function function)
      : EdgeFunction(level_of<Value>, is_placed<Value>), a_(a), b_(b), function_(std::move(function)) {}

  Square<double> rotation(double t) const override { return rotation_of(checked(t)).matrix(); }
  EdgeMotion motion(double t) const override { return motion_of(checked(t)); }
  PlacedMotion placed_motion(double t) const override {
    const Value value = checked(t);
    const PlacedMotion motion = placed_motion_of(value);
    if constexpr (is_placed<Value>) {
      if (!motion.r.allFinite()) [[unlikely]]
        refuse("returned a position that is not finite", t);
    }
    return motion;
  }

 private:
  Value checked(double t) const {
    const Value value = function_(Quantity<si::time>::from_value(t));
    check(value, t);
    return value;
  }
  void check(const Value& value, double t) const {
    const auto& R_a_from_b = rotation_of(value);
    if constexpr (std::same_as<std::remove_cvref_t<decltype(R_a_from_b)>, NamedDcm>) {
      if (R_a_from_b.to() != a_ || R_a_from_b.from() != b_) [[unlikely]]
        refuse("returned " + described(R_a_from_b), t);
    }
    if (!R_a_from_b.matrix().allFinite()) [[unlikely]]
      refuse("returned a rotation that is not finite", t);
  }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse(const std::string& what, double t) const {
    throw BadInput("the edge " + in_quotes(a_) + " - " + in_quotes(b_) + " at " + text(t) +
                   " s: its function " + what);
  }

  NamedFrame a_, b_;
  Function function_;
};

inline NamedEdge constant_edge(Level level, const NamedDcm& R_a_from_b, bool placed,
                               const Column<double>& r_ab_a) {
  const auto none = Column<double>::Zero();
  const PlacedMotion at_rest{{R_a_from_b.matrix(), none, none}, r_ab_a, none, none};
  return {trusted, R_a_from_b.to(), R_a_from_b.from(),
          std::make_unique<ConstantFunction>(level, placed, at_rest)};
}
inline NamedEdge constant_edge(Level level, const NamedDcm& R_a_from_b) {
  return constant_edge(level, R_a_from_b, false, Column<double>::Zero());
}
inline NamedEdge constant_edge(Level level, const NamedTransform& X_a_from_b) {
  return constant_edge(level, X_a_from_b.rotation(), true, X_a_from_b.translation().coordinates());
}

}  // namespace detail

/// A fixed rotation, or rotation and position, of unknown rate: no rate can be asked across it.
inline NamedEdge static_edge(const NamedDcm& R_a_from_b) {
  return detail::constant_edge(Level::rotation, R_a_from_b);
}
inline NamedEdge static_edge(const NamedTransform& X_a_from_b) {
  return detail::constant_edge(Level::rotation, X_a_from_b);
}

/// Claims that b is rigidly mounted on a: w_ab and alpha_ab are zero, and b's origin does not move in a.
inline NamedEdge rigid_edge(const NamedDcm& R_a_from_b) {
  return detail::constant_edge(Level::acceleration, R_a_from_b);
}
inline NamedEdge rigid_edge(const NamedTransform& X_a_from_b) {
  return detail::constant_edge(Level::acceleration, X_a_from_b);
}

/// The edge whose value at an instant is f(t), of b relative to a: a NamedDcm, NamedMovingDcm or
/// NamedAcceleratingDcm, or with a position a NamedTransform, NamedMovingTransform or
/// NamedAcceleratingTransform. Threads may call f at the same time.
///     edge(To(body), From(wheel), [=](Quantity<si::time> t) { return turned_z(To(body), From(wheel), rate *
///     t); })
/// An exception of f passes to the caller of the query. The query throws BadInput when the value has other
/// frames or is not finite.
template <class Function>
  requires detail::NamedEdgeValue<
      std::remove_cvref_t<std::invoke_result_t<const Function&, Quantity<si::time>>>>
      NamedEdge edge(To<NamedFrame> a, From<NamedFrame> b, Function f) {
    using Value = std::remove_cvref_t<std::invoke_result_t<const Function&, Quantity<si::time>>>;
    return {detail::trusted, a.frame, b.frame,
            std::make_unique<detail::FunctionOfTime<Function, Value>>(a.frame, b.frame, std::move(f))};
  }

}  // namespace vectrix
