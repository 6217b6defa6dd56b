#pragma once

#include <vectrix/kinematics/named/vector.hpp>

namespace vectrix {
namespace detail {

/// A vector of b relative to a, between frames known at run time.
template <class U> class OfRelativeTo {
 public:
  using unit = U;

  OfRelativeTo(Trusted, NamedFrame of, NamedFrame relative_to, const NamedVector<U>& vector)
      : of_(of), relative_to_(relative_to), vector_(vector) {}

  NamedFrame of() const { return of_; }
  NamedFrame relative_to() const { return relative_to_; }
  NamedFrame in() const { return vector_.in(); }
  const NamedVector<U>& vector() const& { return vector_; }
  NamedVector<U> vector() && { return vector_; }
  const Column<double>& coordinates() const& { return vector_.coordinates(); }
  Column<double> coordinates() && { return vector_.coordinates(); }

  Quantity<U> x() const { return vector_.x(); }
  Quantity<U> y() const { return vector_.y(); }
  Quantity<U> z() const { return vector_.z(); }

 private:
  NamedFrame of_, relative_to_;
  NamedVector<U> vector_;
};

}  // namespace detail

/// w_ab^c, rad/s, alpha_ab^c, rad/s^2, or r_ab^c, m, between frames known at run time; the unit U
/// distinguishes them. Their laws are those of AngularVelocity, AngularAcceleration and Displacement, checked
/// at run time. An operation on frames that do not chain throws BadInput that names both.
template <VectorUnit U> class NamedRelativeVector : public detail::OfRelativeTo<U> {
 public:
  using detail::OfRelativeTo<U>::OfRelativeTo;

  /// x_ba^c = -x_ab^c
  NamedRelativeVector operator-() const {
    return {detail::trusted, this->relative_to(), this->of(), -this->vector()};
  }
};

/// v_ab|o^c, m/s, or a_ab|o^c, m/s^2, of b's origin relative to a's, observed from o: Velocity and
/// Acceleration for frames known at run time. Their sums chain, and their differences cancel, for one
/// observer.
template <VectorUnit U> class NamedObservedVector : public detail::OfRelativeTo<U> {
 public:
  NamedObservedVector(detail::Trusted key, NamedFrame of, NamedFrame relative_to, NamedFrame observed_from,
                      const NamedVector<U>& vector)
      : detail::OfRelativeTo<U>(key, of, relative_to, vector), observed_from_(observed_from) {}

  NamedFrame observed_from() const { return observed_from_; }

  /// x_ba|o^c = -x_ab|o^c
  NamedObservedVector operator-() const {
    return {detail::trusted, this->relative_to(), this->of(), observed_from_, -this->vector()};
  }

 private:
  NamedFrame observed_from_;
};

template <class U> inline constexpr bool detail::is_framed<NamedRelativeVector<U>> = true;
template <class U> inline constexpr bool detail::is_framed<NamedObservedVector<U>> = true;

namespace detail {

template <class X>
concept NamedPair = requires(const X& ab) {
  ab.of();
  ab.relative_to();
};

template <NamedPair X> std::string of_relative_to_in(const X& ab) {
  std::string words = " of " + in_quotes(ab.of()) + " relative to " + in_quotes(ab.relative_to());
  if constexpr (requires { ab.observed_from(); }) words += " observed from " + in_quotes(ab.observed_from());
  return words + " in " + in_quotes(ab.in());
}

template <class U> inline constexpr const char* symbol_of = nullptr;
template <> inline constexpr const char* symbol_of<si::angular_velocity> = "w";
template <> inline constexpr const char* symbol_of<si::angular_acceleration> = "alpha";
template <> inline constexpr const char* symbol_of<si::length> = "r";
template <> inline constexpr const char* symbol_of<si::velocity> = "v";
template <> inline constexpr const char* symbol_of<si::acceleration> = "a";

template <NamedPair X> std::string described(const X& ab) {
  return symbol_of<typename X::unit> + of_relative_to_in(ab);
}

/// The operands of a sum in the order in which they chain, ab and bd.
template <class X> struct ChainedPair {
  const X& ab;
  const X& bd;

  static ChainedPair of(const X& one, const X& other) {
    const bool turned = one.relative_to() == other.of() && one.of() != other.relative_to();
    return turned ? ChainedPair{other, one} : ChainedPair{one, other};
  }
};

/// Throws BadInput unless one of the two ends where the other begins and both are expressed in one frame.
template <class X> ChainedPair<X> require_chain(const X& one, const X& other) {
  const auto pair = ChainedPair<X>::of(one, other);
  const auto action = [&] { return "sum of " + described(one) + " and " + described(other); };
  if (one.of() == other.of() && one.relative_to() == other.relative_to())
    throw BadInput(action() + ": one pair twice; a sum has ab and bd");
  require_same(pair.ab.of(), pair.bd.relative_to(), action);
  require_same(pair.ab.in(), pair.bd.in(), action);
  if constexpr (requires { one.observed_from(); })
    require_same(one.observed_from(), other.observed_from(), action);
  return pair;
}

struct Ends {
  NamedFrame of, relative_to;
};

/// The ends of a difference, from which the common one has gone. Throws BadInput unless there is exactly one,
/// and both operands are expressed in one frame and have one observer.
template <class X> Ends ends_of_difference(const X& left, const X& right) {
  const auto action = [&] { return "difference of " + described(left) + " and " + described(right); };
  require_same(left.in(), right.in(), action);
  if constexpr (requires { left.observed_from(); })
    require_same(left.observed_from(), right.observed_from(), action);
  const bool one_reference = left.relative_to() == right.relative_to();
  if (one_reference != (left.of() == right.of()))
    return one_reference ? Ends{left.of(), right.of()} : Ends{right.relative_to(), left.relative_to()};
  throw BadInput(action() + (one_reference ? ": one pair twice; for two estimates, error_between(x, y)"
                                           : ": no frame cancels, " + are_two(left.of(), right.of()) + ", " +
                                                 are_two(left.relative_to(), right.relative_to())));
}

template <class X> void require_in(const NamedDcm& R_d_from_c, const X& ab_c) {
  require_same(R_d_from_c.from(), ab_c.in(),
               [&] { return "product of " + described(R_d_from_c) + " and " + described(ab_c); });
}

}  // namespace detail

// Sums and differences have other frames than their operands: x_ad = x_ab + x_bd.
template <class U>
auto operator+=(NamedRelativeVector<U>&, const NamedRelativeVector<U>&) -> Refused = delete;
template <class U>
auto operator+=(NamedObservedVector<U>&, const NamedObservedVector<U>&) -> Refused = delete;
template <class U>
auto operator-=(NamedRelativeVector<U>&, const NamedRelativeVector<U>&) -> Refused = delete;
template <class U>
auto operator-=(NamedObservedVector<U>&, const NamedObservedVector<U>&) -> Refused = delete;

// x_ab^d = R_c^d x_ab^c
template <class U>
NamedRelativeVector<U> product(const NamedDcm& R_d_from_c, const NamedRelativeVector<U>& ab_c) {
  detail::require_in(R_d_from_c, ab_c);
  return {detail::trusted, ab_c.of(), ab_c.relative_to(), R_d_from_c * ab_c.vector()};
}
template <class U>
NamedObservedVector<U> product(const NamedDcm& R_d_from_c, const NamedObservedVector<U>& ab_c) {
  detail::require_in(R_d_from_c, ab_c);
  return {detail::trusted, ab_c.of(), ab_c.relative_to(), ab_c.observed_from(), R_d_from_c * ab_c.vector()};
}

// x_ad^c = x_ab^c + x_bd^c, in either order. Angular accelerations do not add: chain().
template <class U>
  requires(!std::same_as<U, si::angular_acceleration>)
NamedRelativeVector<U> sum(const NamedRelativeVector<U>& one, const NamedRelativeVector<U>& other) {
  const auto [ab, bd] = detail::require_chain(one, other);
  return {detail::trusted, bd.of(), ab.relative_to(), ab.vector() + bd.vector()};
}
template <class U>
NamedObservedVector<U> sum(const NamedObservedVector<U>& one, const NamedObservedVector<U>& other) {
  const auto [ab, bd] = detail::require_chain(one, other);
  return {detail::trusted, bd.of(), ab.relative_to(), ab.observed_from(), ab.vector() + bd.vector()};
}

// x_bd^c = x_ad^c - x_ab^c, and x_ab^c = x_ad^c - x_bd^c.
template <class U>
  requires(!std::same_as<U, si::angular_acceleration>)
NamedRelativeVector<U> difference(const NamedRelativeVector<U>& left, const NamedRelativeVector<U>& right) {
  const auto [of, relative_to] = detail::ends_of_difference(left, right);
  return {detail::trusted, of, relative_to, left.vector() - right.vector()};
}
template <class U>
NamedObservedVector<U> difference(const NamedObservedVector<U>& left, const NamedObservedVector<U>& right) {
  const auto [of, relative_to] = detail::ends_of_difference(left, right);
  return {detail::trusted, of, relative_to, left.observed_from(), left.vector() - right.vector()};
}

/// The error of an estimate of x_ab^c, as a plain vector: its coordinates less those of the reference. Throws
/// BadInput unless both are of one pair, expressed in one frame, and have one observer.
template <detail::NamedPair X>
NamedVector<typename X::unit> error_between(const X& estimate, const X& reference) {
  using namespace detail;
  const auto action = [&] {
    return "error_between(" + described(estimate) + ", " + described(reference) + ")";
  };
  require_same(estimate.of(), reference.of(), action);
  require_same(estimate.relative_to(), reference.relative_to(), action);
  if constexpr (requires { estimate.observed_from(); })
    require_same(estimate.observed_from(), reference.observed_from(), action);
  require_same(estimate.in(), reference.in(), action);
  return estimate.vector() - reference.vector();
}

template <detail::NamedPair X> std::ostream& print_framed(std::ostream& out, const X& ab) {
  return detail::print_column(out, ab.coordinates(), detail::unit_symbol<typename X::unit>)
         << detail::of_relative_to_in(ab);
}

}  // namespace vectrix
