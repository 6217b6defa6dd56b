#include <vectrix/kinematics.hpp>

#include "peers.hpp"

namespace bench::typed {

using namespace vectrix;

struct A : inertial_frame {};
struct B : moving_frame {};
struct C : moving_frame {};
struct D : moving_frame {};
struct E : moving_frame {};
struct F : moving_frame {};

struct List {
  template <class ToFrame, class FromFrame> Numbers operator()(const Dcm<ToFrame, FromFrame>& R) const {
    const Eigen::Matrix3d transposed = R.matrix().transpose();
    return Numbers(transposed.data(), transposed.data() + transposed.size());
  }
  template <class ToFrame, class FromFrame>
  Numbers operator()(const Quaternion<ToFrame, FromFrame>& q) const {
    const auto list = q.scalar_first();
    return Numbers(list.begin(), list.end());
  }
  template <class ToFrame, class FromFrame> Numbers operator()(const Transform<ToFrame, FromFrame>& X) const {
    Numbers list = (*this)(X.rotation);
    for (const double r : (*this)(X.translation)) list.push_back(r);
    return list;
  }
  template <class Typed>
    requires requires(const Typed& v) {
      v.coordinates();
    }
  Numbers operator()(const Typed& v) const {
    return {v.coordinates().x(), v.coordinates().y(), v.coordinates().z()};
  }
};

struct Operands {
  alignas(64) Dcm<B, A> R_b_from_a;
  alignas(64) Dcm<C, B> R_c_from_b;
  alignas(64) Dcm<D, C> R_d_from_c;
  alignas(64) Dcm<E, D> R_e_from_d;
  alignas(64) Dcm<F, E> R_f_from_e;
  alignas(64) Dcm<A, B> R_below;
  alignas(64) Dcm<A, B> R_above;
  alignas(64) Dcm<A, B> R_small;
  alignas(64) Quaternion<A, B> q_large;
  alignas(64) Quaternion<A, B> q_small;
  alignas(64) AngularVelocity<A, B, In<B>> w_ab_b;
  alignas(64) AngularVelocity<B, C, In<C>> w_bc_c;
  alignas(64) AngularVelocity<C, D, In<D>> w_cd_d;
  alignas(64) AngularVelocity<D, E, In<E>> w_de_e;
  alignas(64) AngularVelocity<E, F, In<F>> w_ef_f;
  alignas(64) Vector<A, si::length> r_a;
  alignas(64) RotationVector<A, B> theta;
  alignas(64) RotationVector<A, B> small_theta;
  alignas(64) EulerAngles<Intrinsic<3, 2, 1>, A, B> yaw_pitch_roll;
  alignas(64) Quaternion<B, A> q_b_from_a;
  alignas(64) Quaternion<C, B> q_c_from_b;
  alignas(64) Transform<B, A> X_b_from_a;
  alignas(64) Transform<C, B> X_c_from_b;
};

[[gnu::noinline]] Dcm<C, A> dcm_product(const Dcm<C, B>& R_c_from_b, const Dcm<B, A>& R_b_from_a) {
  return R_c_from_b * R_b_from_a;
}

[[gnu::noinline]] Vector<B, si::length> dcm_on_vector(const Dcm<B, A>& R_b_from_a,
                                                      const Vector<A, si::length>& r_a) {
  return R_b_from_a * r_a;
}

[[gnu::noinline]] Vector<F, si::length> chain_on_vector(const Operands& g) {
  return g.R_f_from_e * g.R_e_from_d * g.R_d_from_c * g.R_c_from_b * g.R_b_from_a * g.r_a;
}

[[gnu::noinline]] AngularVelocity<A, F, In<F>> rate_chain(const Operands& g) {
  const auto w_ac_c = g.R_c_from_b * g.w_ab_b + g.w_bc_c;
  const auto w_ad_d = g.R_d_from_c * w_ac_c + g.w_cd_d;
  const auto w_ae_e = g.R_e_from_d * w_ad_d + g.w_de_e;
  return g.R_f_from_e * w_ae_e + g.w_ef_f;
}

[[gnu::noinline]] Quaternion<C, A> quaternion_product(const Quaternion<C, B>& q_c_from_b,
                                                      const Quaternion<B, A>& q_b_from_a) {
  return q_c_from_b * q_b_from_a;
}

[[gnu::noinline]] Transform<C, A> transform_product(const Transform<C, B>& X_c_from_b,
                                                    const Transform<B, A>& X_b_from_a) {
  return X_c_from_b * X_b_from_a;
}

[[gnu::noinline]] Quaternion<A, B> dcm_to_quaternion(const Dcm<A, B>& R_a_from_b) {
  return quaternion(R_a_from_b);
}

[[gnu::noinline]] Quaternion<A, B> exp_to_quaternion(const RotationVector<A, B>& theta_ab) {
  return exp_quaternion(theta_ab);
}

[[gnu::noinline]] Dcm<A, B> exp_to_dcm(const RotationVector<A, B>& theta_ab) {
  return exp(theta_ab);
}

[[gnu::noinline]] RotationVector<A, B> log_of_dcm(const Dcm<A, B>& R_a_from_b) {
  return log(R_a_from_b);
}

[[gnu::noinline]] RotationVector<A, B> log_of_quaternion(const Quaternion<A, B>& q_a_from_b) {
  return log(q_a_from_b);
}

[[gnu::noinline]] Dcm<B, A> quaternion_to_dcm(const Quaternion<B, A>& q_b_from_a) {
  return dcm(q_b_from_a);
}

using YawPitchRoll = EulerAngles<Intrinsic<3, 2, 1>, A, B>;

[[gnu::noinline]] Dcm<A, B> euler_to_dcm(const YawPitchRoll& x_ab) {
  return dcm(x_ab);
}

[[gnu::noinline]] YawPitchRoll dcm_to_euler(const Dcm<A, B>& R_a_from_b) {
  return euler_angles(intrinsic<3, 2, 1>, R_a_from_b);
}

template <class G, class F> Dcm<G, F> rotation(To<G>, From<F>, const Nine& m) {
  return trust_dcm(to<G>, from<F>, Eigen::Matrix3d::ConstMapType(m.data()).transpose());
}

template <class G, class F> Transform<G, F> place(const Dcm<G, F>& R_g_from_f, const Three& r) {
  return Transform{R_g_from_f, displacement(of<F>, relative_to<G>,
                                            vector<si::length>(in<G>, Eigen::Vector3d(r[0], r[1], r[2])))};
}

Operands operands(const Given& given) {
  const auto turn = [](const Three& v) {
    return rotation_vector(of<B>, relative_to<A>,
                           vector<si::angle>(in<B>, Eigen::Vector3d(v[0], v[1], v[2])));
  };
  const auto angles = [](const Three& v) {
    return euler_angles(intrinsic<3, 2, 1>, of<B>, relative_to<A>, v[0] * si::radian, v[1] * si::radian,
                        v[2] * si::radian);
  };
  const auto rate = [&]<class G, class F>(Of<G>, RelativeTo<F>, const Three& v) {
    return angular_velocity(of<G>, relative_to<F>,
                            vector<si::angular_velocity>(in<G>, Eigen::Vector3d(v[0], v[1], v[2])));
  };
  const auto quaternion = [](auto to_frame, auto from_frame, const Four& q) {
    return quaternion_scalar_first(to_frame, from_frame, q[0], q[1], q[2], q[3]);
  };
  const auto& R = given.R;
  const auto& w = given.w;
  return {rotation(to<B>, from<A>, R[0]),
          rotation(to<C>, from<B>, R[1]),
          rotation(to<D>, from<C>, R[2]),
          rotation(to<E>, from<D>, R[3]),
          rotation(to<F>, from<E>, R[4]),
          rotation(to<A>, from<B>, given.R_below),
          rotation(to<A>, from<B>, given.R_above),
          rotation(to<A>, from<B>, given.R_small),
          quaternion(to<A>, from<B>, given.q_large),
          quaternion(to<A>, from<B>, given.q_small),
          rate(of<B>, relative_to<A>, w[0]),
          rate(of<C>, relative_to<B>, w[1]),
          rate(of<D>, relative_to<C>, w[2]),
          rate(of<E>, relative_to<D>, w[3]),
          rate(of<F>, relative_to<E>, w[4]),
          vector<si::length>(in<A>, Eigen::Vector3d(given.r_a[0], given.r_a[1], given.r_a[2])),
          turn(given.theta),
          turn(given.small_theta),
          angles(given.yaw_pitch_roll),
          quaternion(to<B>, from<A>, given.q[0]),
          quaternion(to<C>, from<B>, given.q[1]),
          place(rotation(to<B>, from<A>, R[0]), given.r[0]),
          place(rotation(to<C>, from<B>, R[1]), given.r[1])};
}

}  // namespace bench::typed

namespace bench {

Peer vectrix_peer(const Given& given) {
  using namespace typed;
  static const Operands g = operands(given);
  return {{Task::dcm_product, way<&dcm_product>(List{}, g.R_c_from_b, g.R_b_from_a)},
          {Task::dcm_on_vector, way<&dcm_on_vector>(List{}, g.R_b_from_a, g.r_a)},
          {Task::chain_on_vector, way<&chain_on_vector>(List{}, g)},
          {Task::rate_chain, way<&rate_chain>(List{}, g)},
          {Task::quaternion_product, way<&quaternion_product>(List{}, g.q_c_from_b, g.q_b_from_a)},
          {Task::transform_product, way<&transform_product>(List{}, g.X_c_from_b, g.X_b_from_a)},
          {Task::dcm_to_quaternion_below, way<&dcm_to_quaternion>(List{}, g.R_below)},
          {Task::dcm_to_quaternion_above, way<&dcm_to_quaternion>(List{}, g.R_above)},
          {Task::exp_to_quaternion, way<&exp_to_quaternion>(List{}, g.theta)},
          {Task::exp_to_quaternion_small, way<&exp_to_quaternion>(List{}, g.small_theta)},
          {Task::exp_to_dcm, way<&exp_to_dcm>(List{}, g.theta)},
          {Task::log_of_dcm, way<&log_of_dcm>(List{}, g.R_below)},
          {Task::log_of_dcm_small, way<&log_of_dcm>(List{}, g.R_small)},
          {Task::log_of_quaternion, way<&log_of_quaternion>(List{}, g.q_large)},
          {Task::log_of_quaternion_small, way<&log_of_quaternion>(List{}, g.q_small)},
          {Task::quaternion_to_dcm, way<&quaternion_to_dcm>(List{}, g.q_b_from_a)},
          {Task::euler_to_dcm, way<&euler_to_dcm>(List{}, g.yaw_pitch_roll)},
          {Task::dcm_to_euler, way<&dcm_to_euler>(List{}, g.R_below)}};
}

}  // namespace bench
