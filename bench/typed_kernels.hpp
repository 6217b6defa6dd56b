#pragma once

#include <span>
#include <vectrix/dynamics/craft/attitude_state.hpp>
#include <vectrix/dynamics/mass/inertia.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics.hpp>

#include "spin.hpp"

/// Frames and operands of the typed kernels.
namespace bench {

using namespace vectrix;

struct A : inertial_frame {};
struct B : moving_frame {};
struct C : moving_frame {};
struct D : moving_frame {};
struct E : moving_frame {};
struct F : moving_frame {};

/// F turned about its z axis at a constant rate gives G: an edge that is a function of time.
template <Frame G, Frame F> struct Spin {
  double rate;
  Dcm<G, F> operator()(const Quantity<si::time>& t) const {
    return trust_dcm(to<G>, from<F>, [&] { return spin(rate * t.value()); });
  }
};
/// The same with its angular velocity.
template <Frame G, Frame F> struct MovingSpin {
  double rate;
  AngularVelocity<G, F, In<F>> w_gf_f;
  MovingDcm<G, F> operator()(const Quantity<si::time>& t) const {
    return MovingDcm{trust_dcm(to<G>, from<F>, [&] { return spin(rate * t.value()); }), w_gf_f};
  }
};

// Five edges, A to F; the second and the fourth are against the direction of the queries.
using ConstantGraph = FrameGraph<ConstantEdge<Dcm<A, B>>, ConstantEdge<Dcm<C, B>>, ConstantEdge<Dcm<C, D>>,
                                 ConstantEdge<Dcm<E, D>>, ConstantEdge<Dcm<E, F>>>;
template <class Edge> using Function = FunctionEdge<Edge>;
using FunctionGraph = FrameGraph<Function<Spin<A, B>>, Function<Spin<C, B>>, Function<Spin<C, D>>,
                                 Function<Spin<E, D>>, Function<Spin<E, F>>>;
using MovingGraph =
    FrameGraph<Function<MovingSpin<A, B>>, Function<MovingSpin<C, B>>, Function<MovingSpin<C, D>>,
               Function<MovingSpin<E, D>>, Function<MovingSpin<E, F>>>;

struct RateChain {
  AngularVelocity<A, B, In<B>> w_ab_b;
  AngularVelocity<B, C, In<C>> w_bc_c;
  AngularVelocity<C, D, In<D>> w_cd_d;
  AngularVelocity<D, E, In<E>> w_de_e;
  AngularVelocity<E, F, In<F>> w_ef_f;
  Dcm<C, B> R_c_from_b;
  Dcm<D, C> R_d_from_c;
  Dcm<E, D> R_e_from_d;
  Dcm<F, E> R_f_from_e;
};

}  // namespace bench

/// The kernels in the library's types. raw_kernels.hpp has a function of the same name for each.
namespace typed {

using namespace bench;

Dcm<C, A> dcm_product(const Dcm<C, B>& R_c_from_b, const Dcm<B, A>& R_b_from_a);
Vector<B, si::length> dcm_on_vector(const Dcm<B, A>& R_b_from_a, const Vector<A, si::length>& r_a);
Vector<F, si::length> dcm_chain_on_vector(const Dcm<F, E>& R_f_from_e, const Dcm<E, D>& R_e_from_d,
                                          const Dcm<D, C>& R_d_from_c, const Dcm<C, B>& R_c_from_b,
                                          const Dcm<B, A>& R_b_from_a, const Vector<A, si::length>& r_a);
Dcm<D, A> dcm_product_of_three(const Dcm<D, C>& R_d_from_c, const Dcm<C, B>& R_c_from_b,
                               const Dcm<B, A>& R_b_from_a);
AngularVelocity<A, F, In<F>> rate_chain(const RateChain& chain);
DcmRate<A, B> dcm_rate(const Dcm<A, B>& R_a_from_b, const AngularVelocity<A, B, In<B>>& w_ab_b);
AngularAcceleration<A, B, In<B>> euler(const Inertia<B>& J_b, const AngularVelocity<A, B, In<B>>& w_ab_b,
                                       const Vector<B, si::torque>& torque_b);
Quaternion<C, A> quaternion_product(const Quaternion<C, B>& q_c_from_b, const Quaternion<B, A>& q_b_from_a);
Vector<B, si::length> quaternion_on_vector(const Quaternion<B, A>& q_b_from_a,
                                           const Vector<A, si::length>& r_a);
Dcm<B, A> turned_z(const Quantity<si::angle>& angle);
Quaternion<A, B> exp_to_quaternion(const RotationVector<A, B>& theta_ab);
Dcm<A, F> constant_graph(const ConstantGraph& graph, const Quantity<si::time>& t);
Dcm<A, F> function_graph(const FunctionGraph& graph, const Quantity<si::time>& t);
AngularVelocity<A, F, In<F>> moving_graph(const MovingGraph& graph, const Quantity<si::time>& t);
AngularVelocity<A, F, In<A>> moving_graph_reexpressed(const MovingGraph& graph, const Quantity<si::time>& t);
void body_rate(const AttitudeState& attitude, const Inertia<B>& J_b, std::span<const double> y,
               std::span<double> ydot);

}  // namespace typed
