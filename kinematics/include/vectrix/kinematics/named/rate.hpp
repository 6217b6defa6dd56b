#pragma once

#include <vectrix/kinematics/named/vector.hpp>

namespace vectrix {

/// w_ab^c, rad/s, or alpha_ab^c, rad/s^2, between frames known at run time; the unit U distinguishes them.
/// Its laws are those of AngularVelocity and AngularAcceleration, checked at run time. An operation on frames
/// that do not chain throws BadInput that names both.
template <VectorUnit U> class NamedRate {
 public:
  NamedRate(detail::Trusted, NamedFrame of, NamedFrame relative_to, const NamedVector<U>& vector)
      : of_(of), relative_to_(relative_to), vector_(vector) {}

  NamedFrame of() const { return of_; }
  NamedFrame relative_to() const { return relative_to_; }
  NamedFrame in() const { return vector_.in(); }
  const NamedVector<U>& vector() const& { return vector_; }
  NamedVector<U> vector() && { return vector_; }
  const detail::Column<double>& coordinates() const& { return vector_.coordinates(); }
  detail::Column<double> coordinates() && { return vector_.coordinates(); }

  /// w_ba^c = -w_ab^c, and the same for alpha
  NamedRate operator-() const { return {detail::trusted, relative_to_, of_, -vector_}; }

 private:
  NamedFrame of_, relative_to_;
  NamedVector<U> vector_;
};

using NamedAngularVelocity = NamedRate<si::angular_velocity>;
using NamedAngularAcceleration = NamedRate<si::angular_acceleration>;

template <class U> inline constexpr bool detail::is_framed<NamedRate<U>> = true;

namespace detail {

template <class U> std::string of_relative_to_in(const NamedRate<U>& rate) {
  return " of " + in_quotes(rate.of()) + " relative to " + in_quotes(rate.relative_to()) + " in " +
         in_quotes(rate.in());
}
template <class U> std::string described(const NamedRate<U>& rate) {
  return (std::same_as<U, si::angular_velocity> ? "w" : "alpha") + of_relative_to_in(rate);
}

inline void require_other(NamedFrame b, NamedFrame a) {
  if (b == a) {
    throw BadInput("of " + in_quotes(b) + " relative to " + in_quotes(a) +
                   ": a frame does not move relative to itself");
  }
}

}  // namespace detail

// The sum has other frames than its operands: w_ad = w_ab + w_bd.
template <class U> auto operator+=(NamedRate<U>&, const NamedRate<U>&) -> Refused = delete;

/// Claims that the vector is the angular velocity (acceleration) of b relative to a.
inline NamedAngularVelocity angular_velocity(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                             const NamedVector<si::angular_velocity>& w_ab_c) {
  detail::require_other(b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, w_ab_c};
}
inline NamedAngularAcceleration angular_acceleration(
    Of<NamedFrame> b, RelativeTo<NamedFrame> a, const NamedVector<si::angular_acceleration>& alpha_ab_c) {
  detail::require_other(b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, alpha_ab_c};
}

// w_ab^d = R_c^d w_ab^c, and the same for alpha
template <class U> NamedRate<U> product(const NamedDcm& R_d_from_c, const NamedRate<U>& ab_c) {
  detail::require_same(R_d_from_c.from(), ab_c.in(), [&] {
    return "product of " + detail::described(R_d_from_c) + " and " + detail::described(ab_c);
  });
  return {detail::trusted, ab_c.of(), ab_c.relative_to(), R_d_from_c * ab_c.vector()};
}

// w_ad^c = w_ab^c + w_bd^c, in either order
inline NamedAngularVelocity sum(const NamedAngularVelocity& one, const NamedAngularVelocity& other) {
  const bool turned = one.relative_to() == other.of() && one.of() != other.relative_to();
  const NamedAngularVelocity& ab = turned ? other : one;
  const NamedAngularVelocity& bd = turned ? one : other;
  const auto action = [&] { return "sum of " + detail::described(one) + " and " + detail::described(other); };
  detail::require_same(ab.of(), bd.relative_to(), action);
  detail::require_same(ab.in(), bd.in(), action);
  return {detail::trusted, bd.of(), ab.relative_to(), ab.vector() + bd.vector()};
}

/// alpha_ad^c = alpha_ab^c + alpha_bd^c + w_ab^c x w_bd^c, all four expressed in c.
inline NamedAngularAcceleration chain(const NamedAngularAcceleration& alpha_ab,
                                      const NamedAngularAcceleration& alpha_bd,
                                      const NamedAngularVelocity& w_ab, const NamedAngularVelocity& w_bd) {
  const auto action = [&] {
    return "chain of " + detail::described(alpha_ab) + ", " + detail::described(alpha_bd) + ", " +
           detail::described(w_ab) + ", " + detail::described(w_bd);
  };
  detail::require_same(alpha_ab.of(), alpha_bd.relative_to(), action);
  detail::require_same(w_ab.of(), alpha_ab.of(), action);
  detail::require_same(w_ab.relative_to(), alpha_ab.relative_to(), action);
  detail::require_same(w_bd.of(), alpha_bd.of(), action);
  detail::require_same(w_bd.relative_to(), alpha_bd.relative_to(), action);
  for (const NamedFrame in : {alpha_bd.in(), w_ab.in(), w_bd.in()})
    detail::require_same(alpha_ab.in(), in, action);
  const NamedVector<si::angular_acceleration> cross{detail::trusted, w_ab.in(),
                                                    w_ab.coordinates().cross(w_bd.coordinates())};
  return {detail::trusted, alpha_bd.of(), alpha_ab.relative_to(),
          alpha_ab.vector() + alpha_bd.vector() + cross};
}

template <class U> std::ostream& print_framed(std::ostream& out, const NamedRate<U>& rate) {
  return detail::print_column(out, rate.coordinates(), detail::unit_symbol<U>)
         << detail::of_relative_to_in(rate);
}

}  // namespace vectrix
