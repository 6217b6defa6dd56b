#include "kernel.hpp"
#include "raw_kernels.hpp"
#include "typed_kernels.hpp"

namespace bench {

std::vector<Kernel> kernels() {
  alignas(64) static const Eigen::Matrix3d R1 = Eigen::Quaterniond(0.4, -0.2, 0.5, 0.7).normalized().matrix();
  alignas(64) static const Eigen::Matrix3d R2 = Eigen::Quaterniond(-0.1, 0.9, 0.3, 0.2).normalized().matrix();
  alignas(64) static const Eigen::Matrix3d R3 = Eigen::Quaterniond(0.5, 0.1, -0.8, 0.3).normalized().matrix();
  alignas(64) static const Eigen::Vector3d v1(0.3, -1.1, 0.7);
  alignas(64) static const Eigen::Vector3d v2(-0.2, 0.4, 0.9);
  alignas(64) static const Eigen::Vector3d small = 1e-6 * v1;
  alignas(64) static const raw::Inertia raw_J = [] {
    Eigen::Matrix3d J;
    J << 2.0, 0.1, 0.2, 0.1, 3.0, -0.3, 0.2, -0.3, 4.0;
    return raw::Inertia{J, J.inverse()};
  }();
  alignas(64) static const double raw_t = 0.7;

  alignas(64) static const auto R_cb = trust_dcm(to<C>, from<B>, R1);
  alignas(64) static const auto R_ba = trust_dcm(to<B>, from<A>, R2);
  alignas(64) static const auto R_ab = trust_dcm(to<A>, from<B>, R1);
  alignas(64) static const auto q_cb = quaternion(R_cb);
  alignas(64) static const auto q_ba = quaternion(R_ba);
  alignas(64) static const auto r_a = vector<si::length>(in<A>, v1);
  alignas(64) static const auto torque_b = vector<si::torque>(in<B>, v2);
  alignas(64) static const auto J_b = trust_inertia(in<B>, raw_J.tensor);
  alignas(64) static const Quantity<si::angle> angle = raw_t * si::radian;
  alignas(64) static const Quantity<si::time> t = raw_t * si::second;
  const auto rate_of = []<class F, class G>(Of<G>, RelativeTo<F>, const Eigen::Vector3d& w) {
    return angular_velocity(of<G>, relative_to<F>, vector<si::angular_velocity>(in<G>, w));
  };
  alignas(64) static const auto w_ab_b = rate_of(of<B>, relative_to<A>, v1);
  const auto turn = [](const Eigen::Vector3d& theta) {
    return rotation_vector(of<B>, relative_to<A>, vector<si::angle>(in<B>, theta));
  };
  alignas(64) static const auto theta = turn(v1);
  alignas(64) static const auto small_theta = turn(small);
  alignas(64) static const auto& q1 = q_cb.eigen();
  alignas(64) static const auto& q2 = q_ba.eigen();

  alignas(64) static const RateChain chain{w_ab_b,
                                           rate_of(of<C>, relative_to<B>, v2),
                                           rate_of(of<D>, relative_to<C>, v1),
                                           rate_of(of<E>, relative_to<D>, v2),
                                           rate_of(of<F>, relative_to<E>, v1),
                                           trust_dcm(to<C>, from<B>, R1),
                                           trust_dcm(to<D>, from<C>, R2),
                                           trust_dcm(to<E>, from<D>, R3),
                                           trust_dcm(to<F>, from<E>, R1)};
  alignas(64) static const raw::RateChain raw_chain{v1, v2, v1, v2, v1, R1, R2, R3, R1};

  alignas(64) static const auto constant =
      frame_graph(static_edge(trust_dcm(to<A>, from<B>, R1)), static_edge(trust_dcm(to<C>, from<B>, R2)),
                  static_edge(trust_dcm(to<C>, from<D>, R3)), static_edge(trust_dcm(to<E>, from<D>, R1)),
                  static_edge(trust_dcm(to<E>, from<F>, R2)));
  alignas(64) static const raw::ConstantPath raw_constant{{R1, R2, R3, R1, R2}};
  alignas(64) static const raw::SpinPath path = [] {
    raw::SpinPath made{{0.11, -0.23, 0.31, 0.43, -0.57}, {}};
    for (std::size_t i = 0; i < 5; ++i) made.w[i] = {0.0, 0.0, -made.rate[i]};
    return made;
  }();
  const auto& rate = path.rate;
  alignas(64) static const auto spins =
      frame_graph(edge(Spin<A, B>{rate[0]}), edge(Spin<C, B>{rate[1]}), edge(Spin<C, D>{rate[2]}),
                  edge(Spin<E, D>{rate[3]}), edge(Spin<E, F>{rate[4]}));
  const auto moving_spin = [&]<class G, class F>(To<G>, From<F>, std::size_t i) {
    return edge(MovingSpin<G, F>{rate[i], rate_of(of<F>, relative_to<G>, path.w[i])});
  };
  alignas(64) static const auto moving = frame_graph(
      moving_spin(to<A>, from<B>, 0), moving_spin(to<C>, from<B>, 1), moving_spin(to<C>, from<D>, 2),
      moving_spin(to<E>, from<D>, 3), moving_spin(to<E>, from<F>, 4));

  alignas(64) static const AttitudeState typed_quaternion = AttitudeState::quaternion;
  alignas(64) static const AttitudeState typed_dcm = AttitudeState::dcm;
  const auto q_ab = quaternion(R_ab).scalar_first();
  alignas(64) static const Numbers y{q_ab[0], q_ab[1], q_ab[2], q_ab[3], v1.x(), v1.y(), v1.z()};
  alignas(64) static const Numbers dcm_y = [] {
    Numbers made(R1.data(), R1.data() + R1.size());
    made.insert(made.end(), v1.data(), v1.data() + v1.size());
    return made;
  }();
  alignas(64) static const raw::Attitude as_quaternion = raw::Attitude::quaternion;
  alignas(64) static const raw::Attitude as_dcm = raw::Attitude::dcm;
  using Rate = std::array<double, 7>;
  using DcmRates = std::array<double, 12>;

  return {
      {"control", form([] { return raw::dcm_product(R1, R2); }),
       form([] { return raw::dcm_product(R1, R2); })},
      {"DCM product", form([] { return typed::dcm_product(R_cb, R_ba); }),
       form([] { return raw::dcm_product(R1, R2); })},
      {"DCM on a vector", form([] { return typed::dcm_on_vector(R_ba, r_a); }),
       form([] { return raw::dcm_on_vector(R2, v1); })},
      {"five DCMs on a vector, raw as written", form([] {
         return typed::dcm_chain_on_vector(chain.R_f_from_e, chain.R_e_from_d, chain.R_d_from_c, R_cb, R_ba,
                                           r_a);
       }),
       form([] { return raw::dcm_chain_on_vector(R1, R3, R2, R1, R2, v1); })},
      {"five DCMs on a vector, raw vector first", form([] {
         return typed::dcm_chain_on_vector(chain.R_f_from_e, chain.R_e_from_d, chain.R_d_from_c, R_cb, R_ba,
                                           r_a);
       }),
       form([] { return raw::vector_first(R1, R3, R2, R1, R2, v1); })},
      {"product of three DCMs",
       form([] { return typed::dcm_product_of_three(chain.R_d_from_c, R_cb, R_ba); }),
       form([] { return raw::dcm_product_of_three(R2, R1, R2); })},
      {"rate chain of five", form([] { return typed::rate_chain(chain); }),
       form([] { return raw::rate_chain(raw_chain); })},
      {"Rdot = R [w]x", form([] { return typed::dcm_rate(R_ab, w_ab_b); }),
       form([] { return raw::dcm_rate(R1, v1); })},
      {"Euler's equation", form([] { return typed::euler(J_b, w_ab_b, torque_b); }),
       form([] { return raw::euler(raw_J, v1, v2); })},
      {"quaternion product", form([] { return typed::quaternion_product(q_cb, q_ba); }),
       form([] { return raw::quaternion_product(q1, q2); })},
      {"quaternion on a vector", form([] { return typed::quaternion_on_vector(q_ba, r_a); }),
       form([] { return raw::quaternion_on_vector(q2, v1); })},
      {"turned_z", form([] { return typed::turned_z(angle); }), form([] { return raw::turned_z(raw_t); })},
      {"exp to quaternion, 1.3 rad", form([] { return typed::exp_to_quaternion(theta); }),
       form([] { return raw::exp_to_quaternion(v1); })},
      {"exp to quaternion, 1.3e-6 rad", form([] { return typed::exp_to_quaternion(small_theta); }),
       form([] { return raw::exp_to_quaternion(small); })},
      {"graph, R over 5 constant edges", form([] { return typed::constant_graph(constant, t); }),
       form([] { return raw::constant_graph(raw_constant, raw_t); })},
      {"graph, R over 5 function edges", form([] { return typed::function_graph(spins, t); }),
       form([] { return raw::function_graph(path, raw_t); })},
      {"graph, w over 5 function edges, in the last frame",
       form([] { return typed::moving_graph(moving, t); }),
       form([] { return raw::moving_graph(path, raw_t); })},
      {"graph, w over 5 function edges, in the first frame",
       form([] { return typed::moving_graph_reexpressed(moving, t); }),
       form([] { return raw::moving_graph_reexpressed(path, raw_t); })},
      {"free body's ydot, quaternion", form([] {
         Rate ydot;
         typed::body_rate(typed_quaternion, J_b, y, ydot);
         return ydot;
       }),
       form([] {
         Rate ydot;
         raw::body_rate(as_quaternion, raw_J, y, ydot);
         return ydot;
       })},
      {"free body's ydot, DCM", form([] {
         DcmRates ydot;
         typed::body_rate(typed_dcm, J_b, dcm_y, ydot);
         return ydot;
       }),
       form([] {
         DcmRates ydot;
         raw::body_rate(as_dcm, raw_J, dcm_y, ydot);
         return ydot;
       })},
  };
}

}  // namespace bench
