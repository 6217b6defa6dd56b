#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/pointing/following_triad.hpp>

namespace vectrix {
namespace detail {

/// How many of a vector and its derivatives a level has.
constexpr std::size_t known_at(Level level) {
  return static_cast<std::size_t>(level) + 1;
}
template <Level level, class S, std::size_t N> Jet<S, known_at(level)> leading(const Jet<S, N>& jet) {
  Jet<S, known_at(level)> part;
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = jet[i];
  return part;
}

}  // namespace detail

/// A direction in which something points, as a vector u of any length, and its derivatives for an observer in
/// a, all expressed in a:
///     Level::rotation        u
///     Level::rate            u, d/dt|_a u
///     Level::acceleration    u, d/dt|_a u, d2/dt2|_a u
/// Made by moving_direction() or fixed_direction(); what is given decides the level. An observer in another
/// frame: (R_b^a, w_ab^b) * u, at the lower level of the two,
///     d/dt|_a u = d/dt|_b u + w_ab x u
template <Frame A, Level known, class S = double> class MovingDirection {
 public:
  static constexpr Level level = known;
  using Numbers = detail::Jet<S, detail::known_at(known)>;

  MovingDirection(detail::Trusted, const Numbers& numbers) : numbers_(numbers) {}

  /// The bare numbers: u and its derivatives.
  const Numbers& numbers() const { return numbers_; }

  MovingDirection operator-() const {
    Numbers opposite;
    for (std::size_t i = 0; i < opposite.size(); ++i) opposite[i] = -numbers_[i];
    return {detail::trusted, opposite};
  }

 private:
  Numbers numbers_;
};

template <class A, Level level, class S>
inline constexpr bool detail::is_framed<MovingDirection<A, level, S>> = true;

namespace detail {

template <class A, class S, class... Vectors>
auto direction_of(const Vectors&... vectors)
    -> MovingDirection<A, static_cast<Level>(sizeof...(Vectors) - 1), S> {
  return {trusted, Jet<S, sizeof...(Vectors)>{vectors.coordinates()...}};
}

// From p to q.
template <class P, class Q, class A, class S> auto pointed(const Displacement<P, Q, In<A>, S>& r_pq_a) {
  return direction_of<A, S>(r_pq_a);
}
template <class P, class Q, class A, class S>
auto pointed(const Displacement<P, Q, In<A>, S>& r_pq_a,
             const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a) {
  return direction_of<A, S>(r_pq_a, v_pq_a_a);
}
template <class P, class Q, class A, class S>
auto pointed(const Displacement<P, Q, In<A>, S>& r_pq_a,
             const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a,
             const Acceleration<P, Q, ObservedFrom<A>, In<A>, S>& a_pq_a_a) {
  return direction_of<A, S>(r_pq_a, v_pq_a_a, a_pq_a_a);
}
template <class P, class Q, class A, class S, class... Accelerations>
auto pointed(const PointMotion<P, Q, A, S>& motion, const Accelerations&... a_pq_a_a)
    -> decltype(pointed(motion.position, motion.velocity, a_pq_a_a...)) {
  return pointed(motion.position, motion.velocity, a_pq_a_a...);
}
// Along the velocity.
template <class P, class Q, class A, class S>
auto pointed(const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a) {
  return direction_of<A, S>(v_pq_a_a);
}
template <class P, class Q, class A, class S>
auto pointed(const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a,
             const Acceleration<P, Q, ObservedFrom<A>, In<A>, S>& a_pq_a_a) {
  return direction_of<A, S>(v_pq_a_a, a_pq_a_a);
}
template <class P, class Q, class A, class S>
auto pointed(const Velocity<P, Q, ObservedFrom<A>, In<A>, S>& v_pq_a_a,
             const Acceleration<P, Q, ObservedFrom<A>, In<A>, S>& a_pq_a_a,
             const Derivative<A, A, si::acceleration, S>& jerk_a_a) {
  return direction_of<A, S>(v_pq_a_a, a_pq_a_a, jerk_a_a.vector());
}
// Along any vector.
template <class A, class U, class S> auto pointed(const Vector<A, U, S>& u_a) {
  return direction_of<A, S>(u_a);
}
template <class A, class U, class S>
auto pointed(const Vector<A, U, S>& u_a, const Derivative<A, A, U, S>& rate_a_a) {
  return direction_of<A, S>(u_a, rate_a_a.vector());
}
template <class A, class U, class S>
auto pointed(const Vector<A, U, S>& u_a, const Derivative<A, A, U, S>& rate_a_a,
             const Derivative<A, A, unit_of_vector_quotient<U, si::time>, S>& change_a_a) {
  return direction_of<A, S>(u_a, rate_a_a.vector(), change_a_a.vector());
}

template <class... Given> using PointedOf = decltype(pointed(std::declval<const Given&>()...));
template <class... Given>
concept HasDirection = requires {
  typename PointedOf<Given...>;
};

}  // namespace detail

/// The direction from p to q, of the velocity, or of any vector, with the derivatives that are given. They
/// are observed from the frame in which they are expressed:
///     moving_direction(r_pq_a)       (r_pq_a, v_pq_a_a)       (r_pq_a, v_pq_a_a, a_pq_a_a)
///     moving_direction(v_pq_a_a)     (v_pq_a_a, a_pq_a_a)     (v_pq_a_a, a_pq_a_a, jerk_a_a)
///     moving_direction(u_a)          (u_a, udot_a_a)          (u_a, udot_a_a, uddot_a_a)
/// A PointMotion may stand for r and v; jerk, udot and uddot are a Derivative.
template <class... Given> detail::PointedOf<Given...> moving_direction(const Given&... given) {
  return detail::pointed(given...);
}
template <class... Given>
  requires(!detail::HasDirection<Given...>)
auto moving_direction(  // a vector, then its derivatives, observed from the frame in which all are expressed
    const Given&...) -> Refused = delete;

/// Claims that the direction does not change for an observer in a: its derivatives are zero.
template <class A, class U, class S>
MovingDirection<A, Level::acceleration, S> fixed_direction(const Vector<A, U, S>& u_a) {
  const detail::Column<S> zero = detail::Column<S>::Zero();
  return {detail::trusted, {u_a.coordinates(), zero, zero}};
}
template <class Given>
auto fixed_direction(  // a vector
    const Given&) -> Refused = delete;

// d/dt|_a u = d/dt|_b u + w x u
// d2/dt2|_a u = d2/dt2|_b u + alpha x u + 2 w x d/dt|_b u + w x (w x u)
template <class A, class B, Level level, class S>
MovingDirection<A, Level::rotation, S> product(const Dcm<A, B, S>& ab,
                                               const MovingDirection<B, level, S>& u_b) {
  return {detail::trusted, {ab.matrix() * u_b.numbers()[0]}};
}
template <class A, class B, Level level, class S>
auto product(const MovingDcm<A, B, S>& ab, const MovingDirection<B, level, S>& u_b)
    -> MovingDirection<A, std::min(level, Level::rate), S> {
  const auto& u = u_b.numbers();
  const detail::Square<S> R = ab.rotation.matrix();
  if constexpr (level == Level::rotation) {
    return {detail::trusted, {R * u[0]}};
  } else {
    return {detail::trusted, {R * u[0], R * (u[1] + ab.angular_velocity.coordinates().cross(u[0]))}};
  }
}
template <class A, class B, Level level, class S>
MovingDirection<A, level, S> product(const AcceleratingDcm<A, B, S>& ab,
                                     const MovingDirection<B, level, S>& u_b) {
  if constexpr (level == Level::acceleration) {
    const auto& u = u_b.numbers();
    const detail::Square<S> R = ab.rotation.matrix();
    const detail::Column<S> w = ab.angular_velocity.coordinates(), turning = w.cross(u[0]);
    return {
        detail::trusted,
        {R * u[0], R * (u[1] + turning),
         R * (u[2] + ab.angular_acceleration.coordinates().cross(u[0]) + w.cross(S(2) * u[1] + turning))}};
  } else {
    return product(without_acceleration(ab), u_b);
  }
}

/// |u x v| / (|u| |v|), the sine of the angle between two directions. At zero they do not fix an attitude.
template <class A, Level first, Level second, class S>
Quantity<si::dimensionless, S> distance_from_singularity(const MovingDirection<A, first, S>& u_a,
                                                         const MovingDirection<A, second, S>& v_a) {
  return Quantity<si::dimensionless, S>::from_value(
      detail::sine_between<S>(u_a.numbers()[0], v_a.numbers()[0]));
}

}  // namespace vectrix
