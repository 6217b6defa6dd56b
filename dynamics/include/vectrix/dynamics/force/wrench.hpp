#pragma once

#include <vectrix/dynamics/force/moment.hpp>

namespace vectrix {

/// (F^c, M_p^c), `W_p_c`, of type Wrench<P, In<C>>: the sum F of forces, N, and their torque about the point
/// p, N m, both expressed in c. Its laws:
///     1.  W_p^c + V_p^c                          about one point, expressed in one frame
///     2.  W_p^d = (R_c^d F^c, R_c^d M_p^c)       R_d_from_c * W_p_c
///     3.  W_q^c = (F^c, M_p^c + F^c x r_pq^c)    shift(W_p_c, r_pq_c)
/// Made by wrench(F_c, M_p_c) or force_through<P>(F_c). There is no default constructor.
template <Point P, class ExpressedIn, class S = double> class Wrench;

template <Point P, Frame C, class S> class Wrench<P, In<C>, S> {
 public:
  explicit Wrench(detail::Trusted, const Vector<C, si::force, S>& F_c, const Torque<P, In<C>, S>& M_p_c)
      : force_(F_c), torque_(M_p_c) {}

  const Vector<C, si::force, S>& force() const& { return force_; }
  Vector<C, si::force, S> force() && { return force_; }
  const Torque<P, In<C>, S>& torque() const& { return torque_; }
  Torque<P, In<C>, S> torque() && { return torque_; }

  Wrench operator-() const { return Wrench{detail::trusted, -force_, -torque_}; }

 private:
  Vector<C, si::force, S> force_;
  Torque<P, In<C>, S> torque_;
};

template <class P, class C, class S> inline constexpr bool detail::is_framed<Wrench<P, C, S>> = true;

/// The wrench of forces with the sum F and the torque M_p about p.
template <class P, class C, class S>
Wrench<P, In<C>, S> wrench(const Vector<C, si::force, S>& F_c, const Torque<P, In<C>, S>& M_p_c) {
  return Wrench<P, In<C>, S>{detail::trusted, F_c, M_p_c};
}
template <class ForceGiven, class TorqueGiven>
  requires detail::any_framed<ForceGiven, TorqueGiven>
auto wrench(  // wrench(F_c, M_p_c): a force and a torque about a point, expressed in one frame
    const ForceGiven&, const TorqueGiven&) -> Refused = delete;

/// Claims that the line of action of the force passes through p: the torque about p is zero.
template <Point P, class C, class S> Wrench<P, In<C>, S> force_through(const Vector<C, si::force, S>& F_c) {
  return wrench(F_c, torque_about<P>(zero<si::torque, C, S>(in<C>)));
}
template <class P, class Given> auto force_through(const Given&) -> Refused = delete;  // needs newtons

template <class P, class C, class S>
Wrench<P, C, S> sum(const Wrench<P, C, S>& W_p_c, const Wrench<P, C, S>& V_p_c) {
  return Wrench<P, C, S>{detail::trusted, W_p_c.force() + V_p_c.force(), W_p_c.torque() + V_p_c.torque()};
}
template <class P, class C, class S>
Wrench<P, C, S> difference(const Wrench<P, C, S>& W_p_c, const Wrench<P, C, S>& V_p_c) {
  return Wrench<P, C, S>{detail::trusted, W_p_c.force() - V_p_c.force(), W_p_c.torque() - V_p_c.torque()};
}
template <class P, class C, class S>
Wrench<P, C, S> product(const std::type_identity_t<S>& k, const Wrench<P, C, S>& W_p_c) {
  return Wrench<P, C, S>{detail::trusted, k * W_p_c.force(), k * W_p_c.torque()};
}
template <class P, class C, class S>
Wrench<P, C, S> product(const Wrench<P, C, S>& W_p_c, const std::type_identity_t<S>& k) {
  return Wrench<P, C, S>{detail::trusted, W_p_c.force() * k, W_p_c.torque() * k};
}

// W_p^d = (R_c^d F^c, R_c^d M_p^c)
template <class D, class C, class P, class S>
Wrench<P, In<D>, S> product(const Dcm<D, C, S>& R_d_from_c, const Wrench<P, In<C>, S>& W_p_c) {
  return Wrench<P, In<D>, S>{detail::trusted, R_d_from_c * W_p_c.force(), R_d_from_c * W_p_c.torque()};
}

// W_q^c = (F^c, M_p^c + F^c x r_pq^c)
template <class P, class Q, class C, class S>
Wrench<Q, In<C>, S> shifted(const Wrench<P, In<C>, S>& W_p_c, const Displacement<P, Q, In<C>, S>& r_pq_c) {
  return Wrench<Q, In<C>, S>{detail::trusted, W_p_c.force(), shift(W_p_c.torque(), r_pq_c, W_p_c.force())};
}

template <class P, class C, class S>
std::ostream& print_framed(std::ostream& out, const Wrench<P, In<C>, S>& W_p_c) {
  return out << W_p_c.force() << "; " << W_p_c.torque();
}

}  // namespace vectrix
