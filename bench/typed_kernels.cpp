#include "typed_kernels.hpp"

#include <vectrix/dynamics/rigid/euler.hpp>

namespace typed {

Dcm<C, A> dcm_product(const Dcm<C, B>& R_c_from_b, const Dcm<B, A>& R_b_from_a) {
  return R_c_from_b * R_b_from_a;
}

Vector<B, si::length> dcm_on_vector(const Dcm<B, A>& R_b_from_a, const Vector<A, si::length>& r_a) {
  return R_b_from_a * r_a;
}

Vector<F, si::length> dcm_chain_on_vector(const Dcm<F, E>& R_f_from_e, const Dcm<E, D>& R_e_from_d,
                                          const Dcm<D, C>& R_d_from_c, const Dcm<C, B>& R_c_from_b,
                                          const Dcm<B, A>& R_b_from_a, const Vector<A, si::length>& r_a) {
  return R_f_from_e * R_e_from_d * R_d_from_c * R_c_from_b * R_b_from_a * r_a;
}

Dcm<D, A> dcm_product_of_three(const Dcm<D, C>& R_d_from_c, const Dcm<C, B>& R_c_from_b,
                               const Dcm<B, A>& R_b_from_a) {
  return R_d_from_c * R_c_from_b * R_b_from_a;
}

AngularVelocity<A, F, In<F>> rate_chain(const RateChain& chain) {
  const auto& [w_ab_b, w_bc_c, w_cd_d, w_de_e, w_ef_f, R_c_from_b, R_d_from_c, R_e_from_d, R_f_from_e] =
      chain;
  const auto w_ac_c = R_c_from_b * w_ab_b + w_bc_c;
  const auto w_ad_d = R_d_from_c * w_ac_c + w_cd_d;
  const auto w_ae_e = R_e_from_d * w_ad_d + w_de_e;
  return R_f_from_e * w_ae_e + w_ef_f;
}

DcmRate<A, B> dcm_rate(const Dcm<A, B>& R_a_from_b, const AngularVelocity<A, B, In<B>>& w_ab_b) {
  return rate(R_a_from_b, w_ab_b);
}

AngularAcceleration<A, B, In<B>> euler(const Inertia<B>& J_b, const AngularVelocity<A, B, In<B>>& w_ab_b,
                                       const Vector<B, si::torque>& torque_b) {
  return vectrix::euler(J_b, w_ab_b, torque_b);
}

Quaternion<C, A> quaternion_product(const Quaternion<C, B>& q_c_from_b, const Quaternion<B, A>& q_b_from_a) {
  return q_c_from_b * q_b_from_a;
}

Vector<B, si::length> quaternion_on_vector(const Quaternion<B, A>& q_b_from_a,
                                           const Vector<A, si::length>& r_a) {
  return q_b_from_a * r_a;
}

Dcm<B, A> turned_z(const Quantity<si::angle>& angle) {
  return vectrix::turned_z(to<B>, from<A>, angle);
}

Quaternion<A, B> exp_to_quaternion(const RotationVector<A, B>& theta_ab) {
  return exp_quaternion(theta_ab);
}

Dcm<A, F> constant_graph(const ConstantGraph& graph, const Quantity<si::time>& t) {
  return graph.at(t).rotation(to<A>, from<F>);
}

Dcm<A, F> function_graph(const FunctionGraph& graph, const Quantity<si::time>& t) {
  return graph.at(t).rotation(to<A>, from<F>);
}

AngularVelocity<A, F, In<F>> moving_graph(const MovingGraph& graph, const Quantity<si::time>& t) {
  return graph.at(t).angular_velocity(of<F>, relative_to<A>, in<F>);
}

AngularVelocity<A, F, In<A>> moving_graph_reexpressed(const MovingGraph& graph, const Quantity<si::time>& t) {
  return graph.at(t).angular_velocity(of<F>, relative_to<A>, in<A>);
}

}  // namespace typed
