#pragma once

#include <vectrix/dynamics/force/about.hpp>
#include <vectrix/frames/shift.hpp>

namespace vectrix {

/// M_p^c, `M_p_c`, of type Torque<P, In<C>>: the moment of forces about the point p, expressed in c, N m.
///     1.  M_p^c + N_p^c                      about one point, expressed in one frame
///     2.  M_p^d = R_c^d M_p^c                R_d_from_c * M_p_c
///     3.  M_q^c = M_p^c + F^c x r_pq^c       shift(M_p_c, r_pq_c, F_c), F is the sum of the forces
/// Made by torque_about<P>(M_c) or moment(r_pq_c, F_c). There is no default constructor.
template <Point P, class ExpressedIn, class S = double> class Torque;

template <Point P, Frame C, class S>
class Torque<P, In<C>, S> : public detail::RelativeVector<C, si::torque, S> {
 public:
  using about = P;
  using moment_of = si::force;
  template <class Q> using AboutPoint = Torque<Q, In<C>, S>;
  template <class D> using Expressed = Torque<P, In<D>, S>;

  using detail::RelativeVector<C, si::torque, S>::RelativeVector;

  Torque operator-() const { return Torque{detail::trusted, -this->coordinates()}; }
};

/// H_p^c, `H_p_c`, of type AngularMomentum<P, In<C>>: the moment of linear momenta about the point p,
/// expressed in c, N m s. It has the laws of a torque, with the linear momentum instead of the force:
///     1.  H_p^c + K_p^c                      2.  H_p^d = R_c^d H_p^c
///     3.  H_q^c = H_p^c + p^c x r_pq^c       shift(H_p_c, r_pq_c, p_c)
/// The type does not contain the masses, nor the observer of their velocities: the caller claims them.
/// Made by angular_momentum_about<P>(H_c) or moment(r_pq_c, p_c). There is no default constructor.
template <Point P, class ExpressedIn, class S = double> class AngularMomentum;

template <Point P, Frame C, class S>
class AngularMomentum<P, In<C>, S> : public detail::RelativeVector<C, si::angular_momentum, S> {
 public:
  using about = P;
  using moment_of = si::momentum;
  template <class Q> using AboutPoint = AngularMomentum<Q, In<C>, S>;
  template <class D> using Expressed = AngularMomentum<P, In<D>, S>;

  using detail::RelativeVector<C, si::angular_momentum, S>::RelativeVector;

  AngularMomentum operator-() const { return AngularMomentum{detail::trusted, -this->coordinates()}; }
};

template <class P, class C, class S> inline constexpr bool detail::is_framed<Torque<P, C, S>> = true;
template <class P, class C, class S> inline constexpr bool detail::is_framed<AngularMomentum<P, C, S>> = true;

/// Claims that the vector is a torque about p.
template <Point P, class C, class S> Torque<P, In<C>, S> torque_about(const Vector<C, si::torque, S>& M_c) {
  return Torque<P, In<C>, S>{detail::trusted, M_c};
}
template <class P, class Given>
auto torque_about(const Given&) -> Refused = delete;  // needs N m; of a force: moment(r_pq_c, F_c)

/// Claims that the vector is an angular momentum about p.
template <Point P, class C, class S>
AngularMomentum<P, In<C>, S> angular_momentum_about(const Vector<C, si::angular_momentum, S>& H_c) {
  return AngularMomentum<P, In<C>, S>{detail::trusted, H_c};
}
template <class P, class Given>
auto angular_momentum_about(  // needs N m s; of a momentum: moment(r_pq_c, p_c)
    const Given&) -> Refused = delete;

namespace detail {

template <class X>
concept Moment = requires {
  typename X::moment_of;
  typename X::template AboutPoint<typename X::about>;
};

template <class P, class C, class U, class S> struct MomentOf {};
template <class P, class C, class S>
struct MomentOf<P, C, si::force, S> : std::type_identity<Torque<P, In<C>, S>> {};
template <class P, class C, class S>
struct MomentOf<P, C, si::momentum, S> : std::type_identity<AngularMomentum<P, In<C>, S>> {};

}  // namespace detail

/// r_pq^c x F^c: the torque about p of a force that acts at q; or the angular momentum about p of a mass at q
/// with the given linear momentum.
template <class P, class Q, class C, class U, class S>
typename detail::MomentOf<P, C, U, S>::type moment(const Displacement<P, Q, In<C>, S>& r_pq_c,
                                                   const Vector<C, U, S>& F_c) {
  return typename detail::MomentOf<P, C, U, S>::type{detail::trusted,
                                                     r_pq_c.coordinates().cross(F_c.coordinates())};
}
template <class Arm, class Given>
  requires detail::any_framed<Arm, Given>
auto moment(  // moment(r_pq_c, F_c): of a force or a momentum, expressed in one frame
    const Arm&, const Given&) -> Refused = delete;

template <detail::Moment X> X sum(const X& M_p_c, const X& N_p_c) {
  return X{detail::trusted, M_p_c.coordinates() + N_p_c.coordinates()};
}
template <detail::Moment X> X difference(const X& M_p_c, const X& N_p_c) {
  return X{detail::trusted, M_p_c.coordinates() - N_p_c.coordinates()};
}
template <detail::Moment X> X product(const std::type_identity_t<typename X::scalar>& k, const X& M_p_c) {
  return X{detail::trusted, k * M_p_c.coordinates()};
}
template <detail::Moment X> X product(const X& M_p_c, const std::type_identity_t<typename X::scalar>& k) {
  return X{detail::trusted, M_p_c.coordinates() * k};
}

// M_q^c = M_p^c + F^c x r_pq^c
template <detail::Moment X, class Q>
auto shifted(const X& M_p_c,
             const Displacement<typename X::about, Q, In<typename X::expressed>, typename X::scalar>& r_pq_c,
             const Vector<typename X::expressed, typename X::moment_of, typename X::scalar>& F_c) {
  return typename X::template AboutPoint<Q>{
      detail::trusted, M_p_c.coordinates() + F_c.coordinates().cross(r_pq_c.coordinates())};
}

/// |M_p|, N m; |H_p|, N m s.
template <detail::Moment X> auto norm(const X& M_p_c) {
  return norm(M_p_c.vector());
}

template <detail::Moment X> std::ostream& print_framed(std::ostream& out, const X& M_p_c) {
  return detail::print_column(out, M_p_c.coordinates(), detail::unit_symbol<typename X::unit>)
         << " about " << frame_name<typename X::about>() << " in " << frame_name<typename X::expressed>();
}

}  // namespace vectrix
