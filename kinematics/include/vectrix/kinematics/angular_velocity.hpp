#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {

/// w_ab^c, `w_ab_c`, of type AngularVelocity<A, B, In<C>>: the angular velocity of b relative to a, expressed
/// in c, rad/s. Its laws:
///     1.  w_ab^c + w_bd^c = w_ad^c          sums chain, all expressed in one frame
///     2.  w_ba^c = -w_ab^c                  reversal
///     3.  w_ab^d = R_c^d w_ab^c             re-expression: R_d_from_c * w_ab_c
/// Made by angular_velocity(of<B>, relative_to<A>, ...); no default.
template <Frame A, Frame B, class Expressed, class S = double> class AngularVelocity;

template <Frame A, Frame B, Frame C, class S> class AngularVelocity<A, B, In<C>, S> {
 public:
  explicit AngularVelocity(detail::Trusted, const Vector<C, si::angular_velocity, S>& vector)
      : vector_(vector) {}

  const Vector<C, si::angular_velocity, S>& vector() const& { return vector_; }
  Vector<C, si::angular_velocity, S> vector() && { return vector_; }
  const detail::Column<S>& coordinates() const& { return vector_.coordinates(); }
  detail::Column<S> coordinates() && { return vector_.coordinates(); }

 private:
  Vector<C, si::angular_velocity, S> vector_;
};

template <class A, class B, class C, class S>
inline constexpr bool detail::is_framed<AngularVelocity<A, B, C, S>> = true;

/// Claims that the vector is the angular velocity of b relative to a.
template <Frame B, Frame A, class C, class S>
AngularVelocity<A, B, In<C>, S> angular_velocity(Of<B>, RelativeTo<A>,
                                                 const Vector<C, si::angular_velocity, S>& w_ab_c) {
  return AngularVelocity<A, B, In<C>, S>{detail::trusted, w_ab_c};
}
template <class B, class A, class C, class UnitGiven, class S>
  requires(!std::same_as<UnitGiven, si::angular_velocity>)
void angular_velocity(Of<B>, RelativeTo<A>, const Vector<C, UnitGiven, S>&) = delete;  // needs rad/s

/// Claims that b is at rest relative to a.
template <Frame B, Frame A, Frame C, class S = double>
AngularVelocity<A, B, In<C>, S> at_rest(Of<B>, RelativeTo<A>, In<C>) {
  return AngularVelocity<A, B, In<C>, S>{detail::trusted, zero<si::angular_velocity, C, S>(in<C>)};
}

// w_ad^c = w_ab^c + w_bd^c
template <class A, class B, class D, class C, class S>
AngularVelocity<A, D, In<C>, S> sum(const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                    const AngularVelocity<B, D, In<C>, S>& w_bd_c) {
  return AngularVelocity<A, D, In<C>, S>{detail::trusted, w_ab_c.vector() + w_bd_c.vector()};
}
// The sum commutes: w_bd^c + w_ab^c chains as well.
template <class A, class B, class D, class C, class S>
  requires(!std::same_as<A, D>)
AngularVelocity<A, D, In<C>, S> sum(const AngularVelocity<B, D, In<C>, S>& w_bd_c,
                                    const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return AngularVelocity<A, D, In<C>, S>{detail::trusted, w_bd_c.vector() + w_ab_c.vector()};
}

/// w_ab^c x r^c: with a position a velocity, with an angular momentum a torque.
template <class A, class B, class C, class U, class S>
Vector<C, unit_of_vector_product<si::angular_velocity, U>, S> cross(
    const AngularVelocity<A, B, In<C>, S>& w_ab_c, const Vector<C, U, S>& r_c) {
  return cross(w_ab_c.vector(), r_c);
}
template <class A, class B, class RateIn, class VectorIn, class U, class S>
  requires(!std::same_as<RateIn, VectorIn>)
void cross(const AngularVelocity<A, B, In<RateIn>, S>&,  // w_ab_c x r_c: expressed in one frame
           const Vector<VectorIn, U, S>&) = delete;

// w_ba^c = -w_ab^c
template <class A, class B, class C, class S>
AngularVelocity<B, A, In<C>, S> negative(const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return AngularVelocity<B, A, In<C>, S>{detail::trusted, -w_ab_c.vector()};
}

// w_ab^d = R_c^d w_ab^c
template <class D, class C, class A, class B, class S>
AngularVelocity<A, B, In<D>, S> product(const Dcm<D, C, S>& R_d_from_c,
                                        const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return AngularVelocity<A, B, In<D>, S>{detail::trusted, R_d_from_c * w_ab_c.vector()};
}

}  // namespace vectrix
