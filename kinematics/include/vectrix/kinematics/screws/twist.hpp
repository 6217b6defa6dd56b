#pragma once

#include <vectrix/frames/shift.hpp>
#include <vectrix/frames/transform.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

namespace vectrix {

/// The point at which a twist is taken: at<P>.
template <class P> struct At {};
template <Point P> inline constexpr At<P> at{};

/// V_ab(p)^c, of type Twist<A, B, At<P>, In<C>>: the motion of the rigid frame b relative to a: the rate
/// w_ab^c, and the velocity v, observed from a, of the particle of b that is now at the point p. Its laws:
///     1.  V_ab(p)^c + V_bd(p)^c = V_ad(p)^c          twists chain at one point
///     2.  V_ba(p)^c = -V_ab(p)^c
///     3.  V_ab(p)^d = R_c^d V_ab(p)^c
///     4.  v(q) = v(p) + w_ab x r_pq                  shift(V_c, r_pq_c) to another point
///     5.  V_ab(c)^c = Ad(X_b^c) V_ab(b)^b            X_c_from_b * V: laws 3 and 4 together
template <Frame A, Frame B, class Place, class ExpressedIn, class S = double> class Twist;

template <Frame A, Frame B, Point P, Frame C, class S> class Twist<A, B, At<P>, In<C>, S> {
 public:
  Twist(detail::Trusted key, const detail::Column<S>& rate, const detail::Column<S>& velocity)
      : rate_(key, rate), velocity_(key, velocity) {}

  AngularVelocity<A, B, In<C>, S> angular_velocity() const {
    return AngularVelocity<A, B, In<C>, S>{detail::trusted, rate_};
  }
  /// The velocity of the particle of b at p, observed from a.
  const Vector<C, si::velocity, S>& velocity() const& { return velocity_; }
  Vector<C, si::velocity, S> velocity() && { return velocity_; }
  /// The six bare numbers, the rate first.
  Eigen::Matrix<S, 6, 1> coordinates() const {
    Eigen::Matrix<S, 6, 1> numbers;
    numbers << rate_.coordinates(), velocity_.coordinates();
    return numbers;
  }
  /// V_ba(p)^c = -V_ab(p)^c
  Twist<B, A, At<P>, In<C>, S> operator-() const {
    return {detail::trusted, -rate_.coordinates(), -velocity_.coordinates()};
  }

 private:
  Vector<C, si::angular_velocity, S> rate_;
  Vector<C, si::velocity, S> velocity_;
};

template <class A, class B, class P, class C, class S>
inline constexpr bool detail::is_framed<Twist<A, B, P, C, S>> = true;

/// Claims that v_c is the velocity, observed from a, of the particle of b at p.
template <class P, class A, class B, class C, class S>
Twist<A, B, At<P>, In<C>, S> twist(At<P>, const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                   const Vector<C, si::velocity, S>& v_c) {
  return {detail::trusted, w_ab_c.coordinates(), v_c.coordinates()};
}
template <class Place, class Rate, class VelocityOf>
  requires detail::any_framed<Rate, VelocityOf>
auto twist(  // twist(at<P>, w_ab_c, v_c): expressed in one frame
    Place, const Rate&, const VelocityOf&) -> Refused = delete;

// V_ad(p)^c = V_ab(p)^c + V_bd(p)^c
template <class A, class B, class D, class P, class C, class S>
Twist<A, D, At<P>, In<C>, S> sum(const Twist<A, B, At<P>, In<C>, S>& ab,
                                 const Twist<B, D, At<P>, In<C>, S>& bd) {
  return {detail::trusted, ab.angular_velocity().coordinates() + bd.angular_velocity().coordinates(),
          ab.velocity().coordinates() + bd.velocity().coordinates()};
}
// V_bd(p)^c = V_ad(p)^c - V_ab(p)^c: the common reference goes.
template <class A, class B, class D, class P, class C, class S>
  requires(!std::same_as<B, D>)
Twist<B, D, At<P>, In<C>, S> difference(const Twist<A, D, At<P>, In<C>, S>& ad,
                                        const Twist<A, B, At<P>, In<C>, S>& ab) {
  return {detail::trusted, ad.angular_velocity().coordinates() - ab.angular_velocity().coordinates(),
          ad.velocity().coordinates() - ab.velocity().coordinates()};
}
// V_ab(p)^c = V_ad(p)^c - V_bd(p)^c
template <class A, class B, class D, class P, class C, class S>
  requires(!std::same_as<A, B>)
Twist<A, B, At<P>, In<C>, S> difference(const Twist<A, D, At<P>, In<C>, S>& ad,
                                        const Twist<B, D, At<P>, In<C>, S>& bd) {
  return {detail::trusted, ad.angular_velocity().coordinates() - bd.angular_velocity().coordinates(),
          ad.velocity().coordinates() - bd.velocity().coordinates()};
}
// V_ab(p)^d = R_c^d V_ab(p)^c
template <class D, class C, class A, class B, class P, class S>
Twist<A, B, At<P>, In<D>, S> product(const Dcm<D, C, S>& R_d_from_c, const Twist<A, B, At<P>, In<C>, S>& ab) {
  return {detail::trusted, R_d_from_c.matrix() * ab.angular_velocity().coordinates(),
          R_d_from_c.matrix() * ab.velocity().coordinates()};
}
// V(c)^c = Ad(X_d^c) V(d)^d:  w^c = R_d^c w^d,  v(c)^c = R_d^c v(d)^d + r_cd^c x w^c
template <class C, class D, class A, class B, class S>
Twist<A, B, At<C>, In<C>, S> product(const Transform<C, D, S>& X_c_from_d,
                                     const Twist<A, B, At<D>, In<D>, S>& ab) {
  const detail::Column<S> w_c = X_c_from_d.rotation.matrix() * ab.angular_velocity().coordinates();
  return {detail::trusted, w_c,
          X_c_from_d.rotation.matrix() * ab.velocity().coordinates() +
              X_c_from_d.translation.coordinates().cross(w_c)};
}

// v(q) = v(p) + w_ab x r_pq
template <class A, class B, class P, class Q, class C, class S>
Twist<A, B, At<Q>, In<C>, S> shifted(const Twist<A, B, At<P>, In<C>, S>& ab,
                                     const Displacement<P, Q, In<C>, S>& r_pq_c) {
  const detail::Column<S> w = ab.angular_velocity().coordinates();
  return {detail::trusted, w, ab.velocity().coordinates() + w.cross(r_pq_c.coordinates())};
}

namespace detail {

template <class S> Eigen::Matrix<S, 6, 6> ad(const Column<S>& w, const Column<S>& v) {
  Eigen::Matrix<S, 6, 6> matrix = Eigen::Matrix<S, 6, 6>::Zero();
  matrix.template topLeftCorner<3, 3>() = hat(w);
  matrix.template bottomRightCorner<3, 3>() = hat(w);
  matrix.template bottomLeftCorner<3, 3>() = hat(v);
  return matrix;
}

}  // namespace detail

/// ad(V), a bare 6x6 matrix, rates first, [[w]x 0; [v]x [w]x]. Its laws:
///     1.  d/dt Ad(X_b^a) = Ad(X_b^a) ad(V_ab(b)^b) = ad(V_ab(a)^a) Ad(X_b^a)
///     2.  ad(Ad(X) V) = Ad(X) ad(V) Ad(X)^-1
///     3.  ad(V) W = -ad(W) V, so that ad(V) V = 0
template <class A, class B, class P, class C, class S>
Eigen::Matrix<S, 6, 6> ad(const Twist<A, B, P, C, S>& V_ab) {
  return detail::ad<S>(V_ab.angular_velocity().coordinates(), V_ab.velocity().coordinates());
}

/// Ad(X_a^b), a bare 6x6 matrix, rates first: [R_a^b 0; [r_ba^b]x R_a^b R_a^b]. Its inverse is
/// adjoint(inverse(X_b_from_a)).
template <class B, class A, class S> Eigen::Matrix<S, 6, 6> adjoint(const Transform<B, A, S>& X_b_from_a) {
  const detail::Square<S>& R = X_b_from_a.rotation.matrix();
  Eigen::Matrix<S, 6, 6> matrix = Eigen::Matrix<S, 6, 6>::Zero();
  matrix.template topLeftCorner<3, 3>() = R;
  matrix.template bottomRightCorner<3, 3>() = R;
  matrix.template bottomLeftCorner<3, 3>() = hat(X_b_from_a.translation.coordinates()) * R;
  return matrix;
}

template <class A, class B, class P, class C, class S>
std::ostream& print_framed(std::ostream& out, const Twist<A, B, At<P>, In<C>, S>& ab) {
  return out << ab.angular_velocity() << "; " << ab.velocity() << " at " << frame_name<P>();
}

}  // namespace vectrix
