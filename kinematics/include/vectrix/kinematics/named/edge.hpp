#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/named/moving_dcm.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>

namespace vectrix {
namespace detail {

/// The motion of frame b relative to a: R_b^a, and depending on the level w_ab^b and alpha_ab^b.
struct EdgeMotion {
  Square<double> R;
  Column<double> w, alpha;
};

/// The numbers of an edge of a NamedGraph. Immutable: threads read it at the same time.
class EdgeFunction {
 public:
  explicit EdgeFunction(Level level) : level_(level) {}
  EdgeFunction(const EdgeFunction&) = delete;
  EdgeFunction& operator=(const EdgeFunction&) = delete;
  virtual ~EdgeFunction() = default;

  Level level() const { return level_; }
  /// The rotation, if it is constant; else null.
  virtual const Square<double>* constant() const { return nullptr; }
  virtual Square<double> rotation(double t) const = 0;
  /// Whether the rotation is given as a quaternion. Products of several quaternions are cheaper.
  virtual bool in_quaternions() const { return false; }
  virtual Eigen::Quaterniond quaternion(double t) const { return Eigen::Quaterniond(rotation(t)); }
  virtual EdgeMotion motion(double t) const = 0;

 private:
  Level level_;
};

}  // namespace detail

/// An edge before it is added to a NamedGraph: static_edge(R_a_from_b), rigid_edge(R_a_from_b), edge(To(a),
/// From(b), f), sampled_edge(samples, longest_gap). It has a level, as in a FrameGraph; no edge is raised to
/// a higher level with zeros by default.
class NamedEdge {
 public:
  NamedEdge(detail::Trusted, NamedFrame a, NamedFrame b, std::unique_ptr<const detail::EdgeFunction> function)
      : a_(a), b_(b), function_(std::move(function)) {}

  NamedFrame to() const { return a_; }
  NamedFrame from() const { return b_; }
  Level level() const { return function_->level(); }
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
  ConstantFunction(Level level, const EdgeMotion& motion) : EdgeFunction(level), motion_(motion) {}

  const Square<double>* constant() const override { return &motion_.R; }
  Square<double> rotation(double) const override { return motion_.R; }
  EdgeMotion motion(double) const override { return motion_; }

 private:
  EdgeMotion motion_;
};

// The numbers of a value of any level, typed or named.
template <class Value> inline constexpr Level level_of = LevelOf<Value>::level;
template <> inline constexpr Level level_of<NamedDcm> = Level::rotation;
template <> inline constexpr Level level_of<NamedMovingDcm> = Level::rate;
template <> inline constexpr Level level_of<NamedAcceleratingDcm> = Level::acceleration;

inline const NamedDcm& rotation_of(const NamedDcm& value) {
  return value;
}
inline const NamedDcm& rotation_of(const NamedMovingDcm& value) {
  return value.rotation();
}
inline const NamedDcm& rotation_of(const NamedAcceleratingDcm& value) {
  return value.rotation();
}
inline const NamedAngularVelocity& angular_velocity_of(const NamedMovingDcm& value) {
  return value.angular_velocity();
}
inline const NamedAngularVelocity& angular_velocity_of(const NamedAcceleratingDcm& value) {
  return value.angular_velocity();
}
inline const NamedAngularAcceleration& angular_acceleration_of(const NamedAcceleratingDcm& value) {
  return value.angular_acceleration();
}

template <class Value> EdgeMotion motion_of(const Value& value) {
  EdgeMotion motion;
  motion.R = rotation_of(value).matrix();
  if constexpr (level_of<Value> >= Level::rate) motion.w = angular_velocity_of(value).coordinates();
  if constexpr (level_of<Value> >= Level::acceleration)
    motion.alpha = angular_acceleration_of(value).coordinates();
  return motion;
}

/// f(t), whose value is typed or named. Each call checks that a named value has the frames of the edge, and
/// that the rotation is finite, because a trusted door checks nothing.
template <class Function, class Value> class FunctionOfTime final : public EdgeFunction {
 public:
  FunctionOfTime(NamedFrame a, NamedFrame b, Function function)
      : EdgeFunction(level_of<Value>), a_(a), b_(b), function_(std::move(function)) {}

  Square<double> rotation(double t) const override {
    const Value value = function_(Quantity<si::time>::from_value(t));
    check(value, t);
    return rotation_of(value).matrix();
  }
  EdgeMotion motion(double t) const override {
    const Value value = function_(Quantity<si::time>::from_value(t));
    check(value, t);
    return motion_of(value);
  }

 private:
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

template <class Value>
concept NamedEdgeValue = std::same_as<Value, NamedDcm> || std::same_as<Value, NamedMovingDcm> ||
    std::same_as<Value, NamedAcceleratingDcm>;

inline NamedEdge constant_edge(Level level, const NamedDcm& R_a_from_b) {
  const EdgeMotion at_rest{R_a_from_b.matrix(), Column<double>::Zero(), Column<double>::Zero()};
  return {trusted, R_a_from_b.to(), R_a_from_b.from(), std::make_unique<ConstantFunction>(level, at_rest)};
}

}  // namespace detail

/// A fixed rotation of unknown rate: no rate can be asked across it.
inline NamedEdge static_edge(const NamedDcm& R_a_from_b) {
  return detail::constant_edge(Level::rotation, R_a_from_b);
}

/// Claims that b is rigidly mounted on a: w_ab and alpha_ab are zero.
inline NamedEdge rigid_edge(const NamedDcm& R_a_from_b) {
  return detail::constant_edge(Level::acceleration, R_a_from_b);
}

/// The edge whose value at an instant is f(t), a NamedDcm, NamedMovingDcm or NamedAcceleratingDcm of b
/// relative to a. Threads may call f at the same time.
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
