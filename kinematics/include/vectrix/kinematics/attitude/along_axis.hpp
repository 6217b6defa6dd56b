#pragma once

#include <cmath>
#include <vectrix/kinematics/attitude/parameters.hpp>

namespace vectrix {
namespace detail {

/// The base of ModifiedRodrigues and GibbsVector: a vector along the axis of the turn from a to b. Its
/// coordinates are the same in a and in b.
template <class X, class A, class B, class S> class AlongAxis : public AttitudeParameters<X, A, B, S, 3> {
 public:
  using AttitudeParameters<X, A, B, S, 3>::AttitudeParameters;

  /// The vector expressed in a or in b.
  Vector<A, si::dimensionless, S> in_reference() const { return {trusted, this->coordinates()}; }
  Vector<B, si::dimensionless, S> in_turned() const { return {trusted, this->coordinates()}; }

  static const char* unit_symbol(int derivative) {
    return derivative == 0 ? "" : derivative == 1 ? "1/s" : "1/s^2";
  }
};

template <class S> Eigen::Quaternion<S> shorter_way(const Eigen::Quaternion<S>& q) {
  const auto flipped = is_longer_way(q);
  return Eigen::Quaternion<S>(select<S>(flipped, S(-q.w()), q.w()), select<S>(flipped, S(-q.x()), q.x()),
                              select<S>(flipped, S(-q.y()), q.y()), select<S>(flipped, S(-q.z()), q.z()));
}

/// Throws BadInput when x is not finite, or the distance from the singularity, angle / |x|, is below
/// singular_angle().
template <class X> void require_away(const X& x, double angle, const char* door) {
  using S = typename X::scalar;
  require_finite<X>(x.coordinates(), door);
  const S longest = S(angle) / singular_angle<S>();
  if (!all(x.coordinates().squaredNorm() < longest * longest)) {
    const auto plain = x.coordinates().unaryExpr([](const S& n) { return without_derivatives(n); }).eval();
    using Plain = typename decltype(plain)::Scalar;
    refuse_singular<X>(Plain(Plain(angle) / scaled_norm(plain)), door);
  }
}

/// x x w for a rate expressed in b, w x x for a rate expressed in a.
template <bool expressed_in_turned, class S> Column<S> turn_of(const Column<S>& x, const Column<S>& w) {
  return expressed_in_turned ? x.cross(w) : w.cross(x);
}

}  // namespace detail
}  // namespace vectrix
