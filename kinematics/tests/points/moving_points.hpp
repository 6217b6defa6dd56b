#pragma once

#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

#include "testing/motions.hpp"

/// Frames that rotate and move, differentiated automatically: the reference for velocities and accelerations.
namespace vectrix_test {

/// r_pq^a and its first two derivatives, as seen by an observer in a.
template <class P, class Q, class A> struct Track {
  Eigen::Vector3d r, v, a;

  explicit Track(const vectrix::Displacement<P, Q, vectrix::In<A>, Dual2>& r_pq_a)
      : r(r_pq_a.coordinates().unaryExpr([](const Dual2& x) { return value(x); })),
        v(r_pq_a.coordinates().unaryExpr([](const Dual2& x) { return first(x); })),
        a(r_pq_a.coordinates().unaryExpr([](const Dual2& x) { return second(x); })) {}

  auto displacement() const {
    using namespace vectrix;
    return vectrix::displacement(of<Q>, relative_to<P>, vector<si::length>(in<A>, r));
  }
  auto velocity() const {
    using namespace vectrix;
    return vectrix::velocity(of<Q>, relative_to<P>, observed_from<A>, vector<si::velocity>(in<A>, v));
  }
  auto acceleration() const {
    using namespace vectrix;
    return vectrix::acceleration(of<Q>, relative_to<P>, observed_from<A>, vector<si::acceleration>(in<A>, a));
  }
};

/// A position that moves with acceleration along a curve. `seed` selects the curve.
template <class P, class Q, class A>
vectrix::Displacement<P, Q, vectrix::In<A>, Dual2> moving(double seed, const Dual2& t) {
  using namespace vectrix;
  const Dual2 k = constant(seed);
  const Eigen::Matrix<Dual2, 3, 1> r(t * k + t * t, k - t * t * k, sin(Dual2(t + k)));
  return displacement(of<Q>, relative_to<P>, vector<si::length>(in<A>, r));
}

/// X_b^a(t), rotating and moving.
template <class A, class B> vectrix::Transform<A, B, Dual2> travelling(double seed, const Dual2& t) {
  return {turning<A, B>(seed, t), moving<A, B, A>(1.0 - seed, t)};
}

/// The motion of b as seen from a, from X_b^a(t).
template <class A, class B>
vectrix::AcceleratingTransform<A, B> motion(const vectrix::Transform<A, B, Dual2>& X) {
  const Track<A, B, A> track(X.translation);
  return {Motion<A, B>(X.rotation).accelerating(), track.displacement(), track.velocity(),
          track.acceleration()};
}

/// Not a number if one of them is none.
inline double largest_of(std::initializer_list<double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) largest = vectrix::detail::larger(largest, number);
  return largest;
}

/// The largest difference of two motions in any of their numbers.
template <class A, class B>
double distance(const vectrix::AcceleratingTransform<A, B>& left,
                const vectrix::AcceleratingTransform<A, B>& right) {
  const auto& l = left.turning;
  const auto& r = right.turning;
  return largest_of({distance(l.rotation.matrix(), r.rotation.matrix()),
                     distance(l.angular_velocity.coordinates(), r.angular_velocity.coordinates()),
                     distance(l.angular_acceleration.coordinates(), r.angular_acceleration.coordinates()),
                     distance(left.translation.coordinates(), right.translation.coordinates()),
                     distance(left.velocity.coordinates(), right.velocity.coordinates()),
                     distance(left.acceleration.coordinates(), right.acceleration.coordinates())});
}
template <class A, class B>
double distance(const vectrix::MovingTransform<A, B>& left, const vectrix::MovingTransform<A, B>& right) {
  return largest_of(
      {distance(left.turning.rotation.matrix(), right.turning.rotation.matrix()),
       distance(left.turning.angular_velocity.coordinates(), right.turning.angular_velocity.coordinates()),
       distance(left.translation.coordinates(), right.translation.coordinates()),
       distance(left.velocity.coordinates(), right.velocity.coordinates())});
}

}  // namespace vectrix_test
