#pragma once

#include <boost/units/units_fwd.hpp>
#include <cmath>
#include <type_traits>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/scalar/batch.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/frames/unit.hpp>

namespace vectrix {

template <Unit U, class S = double> class Quantity;
template <Unit U> struct UnitConstant;

namespace detail {

template <class X> inline constexpr bool is_quantity = false;
template <class U, class S> inline constexpr bool is_quantity<Quantity<U, S>> = true;
template <class U> inline constexpr bool is_quantity<UnitConstant<U>> = true;

/// What a quantity may be multiplied with: no type of the library, which says itself what it is multiplied
/// with.
template <class X>
concept Number = !is_framed<X> && !is_quantity<X>;

/// Whether a T goes into an S and loses nothing but digits: no double into a float or into a whole number.
template <class T, class S>
concept FitsInto = std::convertible_to<const T&, S> &&
    !(std::is_arithmetic_v<T> && std::is_arithmetic_v<S> &&
      (sizeof(T) > sizeof(S) || (std::is_integral_v<S> && !std::is_integral_v<T>)));

template <class U, class V, class S>
inline constexpr bool converts =
    !std::is_integral_v<S> &&
    std::same_as<typename boost_unit<U>::dimension_type, typename boost_unit<V>::dimension_type>;

/// How many U one V is.
template <class U, class V>
inline constexpr double conversion_factor = bu::conversion_factor(boost_unit<V>{}, boost_unit<U>{});

/// 1/U, for an operand T: looked up for a division alone, which few units have.
template <class U, class T> struct Inverse { using type = unit_quotient<si::dimensionless, U>; };

/// The one of two scalars that the other fits into.
template <class S, class T>
  requires FitsInto<T, S> || FitsInto<S, T>
using Wider = std::conditional_t<FitsInto<T, S>, S, T>;

/// The scalar of a number that gets a unit.
template <class S> using Measure = std::conditional_t<std::is_integral_v<S>, double, S>;

/// A factor of a number of S. Only what the machine multiplies at once has one type: a derivative times a
/// double stays that.
template <class S, class T> constexpr decltype(auto) factor(const T& k) {
  if constexpr (std::is_arithmetic_v<S> && std::is_arithmetic_v<T>) {
    return static_cast<Wider<S, T>>(k);
  } else {
    return (k);
  }
}

}  // namespace detail

/// A number of S in the unit U: `Quantity<si::torque> t = 2.0 * si::newton_metre`. A number to the machine:
/// as large, and as fast. Sums and comparisons need one unit; a product has the unit that Boost.Units gives
/// it. Boost's quantity of exactly this unit converts to this one and back. One without a dimension converts
/// to its number.
template <Unit U, class S> class Quantity {
  static constexpr bool is_ratio = std::same_as<U, si::dimensionless>;

 public:
  using unit = U;
  using scalar = S;

  constexpr Quantity() = default;
  constexpr Quantity(detail::Trusted, const S& value) : value_(value) {}
  /// Claims that the bare number is in the unit U.
  static constexpr Quantity from_value(const S& value) { return {detail::trusted, value}; }

  constexpr explicit Quantity(const S& ratio) requires is_ratio : value_(ratio) {}
  template <class T>
    requires(!is_ratio && (std::is_arithmetic_v<T> || std::same_as<T, S>))
  Quantity(  // a number needs its unit: 2.0 * si::metre
      const T&)
  = delete;

  template <class T>
    requires std::convertible_to<const T&, S>
  constexpr explicit(!detail::FitsInto<T, S>) Quantity(const Quantity<U, T>& x)
      : value_(static_cast<S>(x.value())) {}
  template <class V, class T>
    requires(!std::same_as<U, V>)
  Quantity(  // another unit: convert<si::length>(x) takes kilometres in
      const Quantity<V, T>&)
  = delete;

  template <class BoostUnit, class T>
    requires(std::same_as<unit_tag<BoostUnit>, U>&& detail::FitsInto<T, S>)
  constexpr Quantity(const boost::units::quantity<BoostUnit, T>& x) : value_(x.value()) {}
  template <class BoostUnit>
    requires std::same_as<unit_tag<BoostUnit>, U>
  constexpr operator boost::units::quantity<BoostUnit, S>() const {
    return boost::units::quantity<BoostUnit, S>::from_value(value_);
  }

  /// The bare number, in the unit U.
  constexpr const S& value() const& { return value_; }
  constexpr S value() && { return value_; }
  constexpr operator S() const requires is_ratio { return value_; }
  /// The bare number in another unit of the dimension: angle.in(si::degree).
  template <class V>
    requires detail::converts<V, U, S>
  constexpr S in(UnitConstant<V>) const {
    if constexpr (std::is_floating_point_v<S>) {
      return static_cast<S>(value_ * detail::conversion_factor<V, U>);
    } else {
      return S(value_ * detail::number<S>(detail::conversion_factor<V, U>));
    }
  }
  template <class Given>
  auto in(  // a unit of the same dimension: angle.in(si::degree)
      const Given&) const -> Refused = delete;

  constexpr Quantity operator-() const { return from_value(-value_); }
  constexpr Quantity& operator+=(const Quantity& x) {
    value_ += x.value_;
    return *this;
  }
  constexpr Quantity& operator-=(const Quantity& x) {
    value_ -= x.value_;
    return *this;
  }
  constexpr Quantity& operator*=(const S& k) {
    value_ *= k;
    return *this;
  }
  constexpr Quantity& operator/=(const S& k) {
    value_ /= k;
    return *this;
  }

  // Members: the left operand alone says the unit, so that the compiler finds one candidate for two units,
  // and clang's message is one note. Comparisons of a batch give a mask.
  constexpr Quantity operator+(const Quantity& y) const { return from_value(S(value_ + y.value_)); }
  constexpr Quantity operator-(const Quantity& y) const { return from_value(S(value_ - y.value_)); }
  constexpr auto operator==(const Quantity& y) const { return value_ == y.value_; }
  constexpr auto operator!=(const Quantity& y) const { return value_ != y.value_; }
  constexpr auto operator<(const Quantity& y) const { return value_ < y.value_; }
  constexpr auto operator<=(const Quantity& y) const { return value_ <= y.value_; }
  constexpr auto operator>(const Quantity& y) const { return value_ > y.value_; }
  constexpr auto operator>=(const Quantity& y) const { return value_ >= y.value_; }

  template <class V, class T>
  friend constexpr Quantity<unit_product<U, V>, detail::Wider<S, T>> operator*(const Quantity& x,
                                                                               const Quantity<V, T>& y) {
    return {detail::trusted, x.value_ * y.value()};
  }
  template <class V, class T>
  friend constexpr Quantity<unit_quotient<U, V>, detail::Wider<S, T>> operator/(const Quantity& x,
                                                                                const Quantity<V, T>& y) {
    return {detail::trusted, x.value_ / y.value()};
  }
  template <detail::Number T>
  friend constexpr Quantity<U, detail::Wider<S, T>> operator*(const Quantity& x, const T& k) {
    return {detail::trusted, x.value_ * detail::factor<S>(k)};
  }
  template <detail::Number T>
  friend constexpr Quantity<U, detail::Wider<S, T>> operator*(const T& k, const Quantity& x) {
    return {detail::trusted, detail::factor<S>(k) * x.value_};
  }
  template <detail::Number T>
  friend constexpr Quantity<U, detail::Wider<S, T>> operator/(const Quantity& x, const T& k) {
    return {detail::trusted, x.value_ / detail::factor<S>(k)};
  }
  template <detail::Number T>
  friend constexpr Quantity<typename detail::Inverse<U, T>::type, detail::Wider<S, T>> operator/(
      const T& k, const Quantity& x) {
    return {detail::trusted, detail::factor<S>(k) / x.value_};
  }

  // An == may be read from the right: both units are wanted at once.
  template <class V, class T>
    requires(!std::same_as<U, V>)
  auto operator==(  // a comparison needs one unit: convert<U>()
      const Quantity<V, T>&) const -> bool = delete;

 private:
  S value_{};
};

/// Boost's quantity as one of ours, for a function that takes any unit or any scalar: vector(in<F>,
/// quantity(x), quantity(y), quantity(z)). Nothing else needs it.
template <class BoostUnit, class S>
constexpr Quantity<unit_tag<BoostUnit>, S> quantity(const boost::units::quantity<BoostUnit, S>& x) {
  return {detail::trusted, x.value()};
}

/// |x|.
template <class U, class S> constexpr Quantity<U, S> abs(const Quantity<U, S>& x) {
  using std::abs;
  return {detail::trusted, S(abs(x.value()))};
}

namespace detail {

/// The operators of all units, found with a UnitConstant alone. Not members of it: every file declares two
/// dozen units, and each would have copies of its own.
struct UnitOperators {
  template <Number S, class U>
  friend constexpr Quantity<U, Measure<S>> operator*(const S& number, UnitConstant<U>) {
    return {trusted, static_cast<Measure<S>>(number)};
  }
  template <Number S, class U>
  friend constexpr Quantity<typename Inverse<U, S>::type, Measure<S>> operator/(const S& number,
                                                                                UnitConstant<U>) {
    return {trusted, static_cast<Measure<S>>(number)};
  }
  template <class V, class S, class U>
  friend constexpr Quantity<unit_product<V, U>, S> operator*(const Quantity<V, S>& x, UnitConstant<U>) {
    return {trusted, x.value()};
  }
  template <class V, class S, class U>
  friend constexpr Quantity<unit_quotient<V, U>, S> operator/(const Quantity<V, S>& x, UnitConstant<U>) {
    return {trusted, x.value()};
  }
  template <class U, class V>
  friend constexpr UnitConstant<unit_product<U, V>> operator*(UnitConstant<U>, UnitConstant<V>) {
    return {};
  }
  template <class U, class V>
  friend constexpr UnitConstant<unit_quotient<U, V>> operator/(UnitConstant<U>, UnitConstant<V>) {
    return {};
  }
};

}  // namespace detail

/// A unit to stand behind a number: 2.0 * si::metre, 0.1 * (si::radian / si::second). A whole number becomes
/// a double, because 1 * si::metre / (2 * si::second) is half a metre per second.
template <Unit U> struct UnitConstant : detail::UnitOperators {};

}  // namespace vectrix
