#pragma once

#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vectrix/frames/errors.hpp>

/// What <vectrix/frames/instants.hpp> brings where instants are checked.
namespace vectrix {

/// Quantities of two instants were combined: a mistake in the program, not in its data. The text says what
/// was done, both types and both instants.
class __attribute__((visibility("default"))) TwoInstants : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {

inline constexpr bool instants_checked = true;

/// The instant that a frame graph was asked at.
class Instant {
 public:
  virtual ~Instant() = default;
  /// Instants of two types are not compared, and count as one.
  virtual bool is(const Instant& other) const = 0;
  virtual std::string name() const = 0;
};
using Stamp = std::shared_ptr<const Instant>;

/// The type's name as the compiler writes it.
template <class T> std::string type_name() {
  const std::string_view signature = __PRETTY_FUNCTION__;
  const auto begin = signature.find("T = ") + 4;
  return std::string{signature.substr(begin, signature.find_first_of(";]", begin) - begin)};
}

/// What instants are compared by and what their unit is called; of quantities, see edge.hpp.
template <class T> const T& number_in(const T& instant) {
  return instant;
}
template <class T> const char* unit_in(const T&) {
  return "";
}

template <class T> class InstantValue final : public Instant {
 public:
  explicit InstantValue(const T& instant) : instant_(instant) {}

  bool is(const Instant& other) const override {
    const auto* same_type = dynamic_cast<const InstantValue*>(&other);
    return same_type == nullptr || all(number_in(instant_) == number_in(same_type->instant_));
  }
  std::string name() const override {
    using Number = std::remove_cvref_t<decltype(number_in(instant_))>;
    if constexpr (Batch<Number> || requires(std::ostream & out, const Number& number) { out << number; }) {
      return text(number_in(instant_)) + unit_in(instant_);
    } else {
      return "a " + type_name<T>();
    }
  }

 private:
  T instant_;
};

/// Instants that cannot be compared leave no stamp.
template <class T> Stamp stamp_of_instant(const T& instant) {
  if constexpr (requires { all(number_in(instant) == number_in(instant)); }) {
    return std::make_shared<const InstantValue<T>>(instant);
  } else {
    return {};
  }
}

/// Pass-key of the library's own algebra: what it builds from checked operands is not checked again, and is
/// of their instant.
struct Trusted {
  explicit Trusted() = default;
  explicit Trusted(Stamp instant) : stamp(std::move(instant)) {}
  Stamp stamp;
};
inline constinit const Trusted trusted{};

/// The base of what holds the numbers of a quantity.
class Stamped {
 public:
  explicit Stamped(const Trusted& key) : stamp_(key.stamp) {}
  const Stamp& stamp() const { return stamp_; }

 private:
  Stamp stamp_;
};

/// f(parts...) of a quantity that is an aggregate of others.
template <class X, class F> decltype(auto) with_parts(const X& x, const F& f) {
  if constexpr (requires { x.turning, x.acceleration; }) {
    return f(x.turning, x.translation, x.velocity, x.acceleration);
  } else if constexpr (requires { x.turning, x.velocity; }) {
    return f(x.turning, x.translation, x.velocity);
  } else if constexpr (requires { x.moving, x.angular_acceleration; }) {
    return f(x.moving, x.angular_acceleration);
  } else if constexpr (requires { x.rotation, x.angular_velocity; }) {
    return f(x.rotation, x.angular_velocity);
  } else if constexpr (requires { x.rotation, x.translation; }) {
    return f(x.rotation, x.translation);
  }
}
template <class X>
concept HasParts = std::is_aggregate_v<X> && requires(const X& x) {
  requires !std::is_void_v<decltype(with_parts(x, [](const auto&...) { return 0; }))>;
};

/// f(stamp, name of the type that has it) for everything in x that has a place for a stamp.
template <class X, class F> void each_stamp(const X& x, const F& f) {
  if constexpr (std::is_base_of_v<Stamped, X>) {
    f(x.stamp(), type_name<X>);
  } else if constexpr (HasParts<X>) {
    with_parts(x, [&](const auto&... parts) { (each_stamp(parts, f), ...); });
  } else if constexpr (requires { x.vector().stamp(); }) {
    f(x.vector().stamp(), type_name<X>);
  } else if constexpr (requires { x.velocity().stamp(); }) {
    f(x.velocity().stamp(), type_name<X>);
  }
}

/// The same quantity with another stamp.
template <class X> X stamped(const X& x, const Trusted& key) {
  if constexpr (HasParts<X>) {
    return with_parts(x, [&](const auto&... parts) { return X{stamped(parts, key)...}; });
  } else if constexpr (requires { X{key, x.vector()}; }) {
    return X{key, stamped(x.vector(), key)};
  } else if constexpr (requires { X{key, x.of(), x.relative_to(), x.vector()}; }) {
    return X{key, x.of(), x.relative_to(), stamped(x.vector(), key)};
  } else if constexpr (requires { X{key, x.angular_velocity().coordinates(), x.velocity().coordinates()}; }) {
    return X{key, x.angular_velocity().coordinates(), x.velocity().coordinates()};
  } else if constexpr (!std::is_base_of_v<Stamped, X>) {
    return x;
  } else if constexpr (requires { X{key, x.coordinates()}; }) {
    return X{key, x.coordinates()};
  } else if constexpr (requires { X{key, x.matrix()}; }) {
    return X{key, x.matrix()};
  } else if constexpr (requires { X{key, x.in(), x.coordinates()}; }) {
    return X{key, x.in(), x.coordinates()};
  } else if constexpr (requires { X{key, x.to(), x.from(), x.matrix()}; }) {
    return X{key, x.to(), x.from(), x.matrix()};
  } else if constexpr (requires { X{key, x.to(), x.from(), x.eigen()}; }) {
    return X{key, x.to(), x.from(), x.eigen()};
  } else {
    return X{key, [&] { return x.eigen(); }};
  }
}

/// The one instant of the operands, or none. Throws TwoInstants.
template <class... Operands> Stamp common_stamp(const char* action, const Operands&... operands) {
  Stamp common;
  std::string (*owner)() = nullptr;
  const auto require_same = [&](const Stamp& stamp, std::string (*name)()) {
    if (stamp && common && !common->is(*stamp)) {
      throw TwoInstants(std::string{action} + ": " + owner() + " at " + common->name() + " and " + name() +
                        " at " + stamp->name() + " are of two instants");
    }
    if (stamp && !common) {
      common = stamp;
      owner = name;
    }
  };
  (each_stamp(operands, require_same), ...);
  return common;
}

template <class Make, class... Operands>
auto of_one_instant(const char* action, const Make& make, const Operands&... operands) {
  using Result = decltype(make());
  const Stamp stamp = common_stamp(action, operands...);
  if constexpr (std::is_move_constructible_v<Result>) {
    return stamp ? stamped(make(), Trusted{stamp}) : make();
  } else {
    return make();  // a chain of rotations, which cannot be built again: it asks its factors
  }
}

/// The pass-key for what is built from operands, at their instant.
template <class... Operands> Trusted trusted_like(const Operands&... operands) {
  return Trusted{common_stamp("combining", operands...)};
}

}  // namespace detail

/// The same for any instant: what is to be compared with, or added to, its like at another.
template <class X> X without_instant(const X& x) {
  return detail::stamped(x, detail::trusted);
}

}  // namespace vectrix
