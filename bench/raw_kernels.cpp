#include "raw_kernels.hpp"

#include "spin.hpp"

namespace raw {

using bench::Motion;
using bench::spin;

Matrix3d dcm_product(const Matrix3d& R_c_from_b, const Matrix3d& R_b_from_a) {
  return R_c_from_b * R_b_from_a;
}

Vector3d dcm_on_vector(const Matrix3d& R_b_from_a, const Vector3d& r_a) {
  return R_b_from_a * r_a;
}

Vector3d dcm_chain_on_vector(const Matrix3d& R_f_from_e, const Matrix3d& R_e_from_d,
                             const Matrix3d& R_d_from_c, const Matrix3d& R_c_from_b,
                             const Matrix3d& R_b_from_a, const Vector3d& r_a) {
  return R_f_from_e * R_e_from_d * R_d_from_c * R_c_from_b * R_b_from_a * r_a;
}

Vector3d vector_first(const Matrix3d& R_f_from_e, const Matrix3d& R_e_from_d, const Matrix3d& R_d_from_c,
                      const Matrix3d& R_c_from_b, const Matrix3d& R_b_from_a, const Vector3d& r_a) {
  return R_f_from_e * (R_e_from_d * (R_d_from_c * (R_c_from_b * (R_b_from_a * r_a))));
}

Matrix3d dcm_product_of_three(const Matrix3d& R_d_from_c, const Matrix3d& R_c_from_b,
                              const Matrix3d& R_b_from_a) {
  return R_d_from_c * R_c_from_b * R_b_from_a;
}

Vector3d rate_chain(const RateChain& chain) {
  const Vector3d w_ac_c = chain.R_c_from_b * chain.w_ab_b + chain.w_bc_c;
  const Vector3d w_ad_d = chain.R_d_from_c * w_ac_c + chain.w_cd_d;
  const Vector3d w_ae_e = chain.R_e_from_d * w_ad_d + chain.w_de_e;
  return chain.R_f_from_e * w_ae_e + chain.w_ef_f;
}

// R [w]x without the products by zero: two products per entry instead of three.
Matrix3d dcm_rate(const Matrix3d& R_a_from_b, const Vector3d& w_ab_b) {
  Matrix3d rate;
  rate.col(0) = R_a_from_b.col(1) * w_ab_b.z() - R_a_from_b.col(2) * w_ab_b.y();
  rate.col(1) = R_a_from_b.col(2) * w_ab_b.x() - R_a_from_b.col(0) * w_ab_b.z();
  rate.col(2) = R_a_from_b.col(0) * w_ab_b.y() - R_a_from_b.col(1) * w_ab_b.x();
  return rate;
}

Vector3d euler(const Inertia& J_b, const Vector3d& w_ab_b, const Vector3d& torque_b) {
  const Vector3d momentum = J_b.tensor * w_ab_b;
  return J_b.inverse * (torque_b - w_ab_b.cross(momentum));
}

Quaterniond quaternion_product(const Quaterniond& q_c_from_b, const Quaterniond& q_b_from_a) {
  return q_c_from_b * q_b_from_a;
}

Vector3d quaternion_on_vector(const Quaterniond& q_b_from_a, const Vector3d& r_a) {
  return q_b_from_a * r_a;
}

Matrix3d turned_z(const double& angle) {
  return spin(angle);
}

Quaterniond exp_to_quaternion(const Vector3d& theta_ab) {
  const double angle = theta_ab.norm();
  if (angle == 0.0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, theta_ab / angle));
}

Matrix3d constant_graph(const ConstantPath& path, const double&) {
  return path.R[0] * path.R[1].transpose() * path.R[2] * path.R[3].transpose() * path.R[4];
}

Matrix3d function_graph(const SpinPath& path, const double& t) {
  return spin(path.rate[0] * t) * spin(path.rate[1] * t).transpose() * spin(path.rate[2] * t) *
         spin(path.rate[3] * t).transpose() * spin(path.rate[4] * t);
}

// Vectors only, no matrix product. For an edge against the direction of the path: w_ac^c = R_b^c (w_ab^b -
// w_cb^b).
Vector3d moving_graph(const SpinPath& path, const double& t) {
  const auto edge = [&](std::size_t i) { return bench::moving_spin(path.rate[i] * t, path.w[i]); };
  const Motion ab = edge(0), cb = edge(1), cd = edge(2), ed = edge(3), ef = edge(4);
  const Vector3d w_ac_c = cb.R * (ab.w - cb.w);
  const Vector3d w_ad_d = cd.R.transpose() * w_ac_c + cd.w;
  const Vector3d w_ae_e = ed.R * (w_ad_d - ed.w);
  return ef.R.transpose() * w_ae_e + ef.w;
}

// Starts at the far end, so that the result is in A; again without a matrix product.
Vector3d moving_graph_reexpressed(const SpinPath& path, const double& t) {
  const auto edge = [&](std::size_t i) { return bench::moving_spin(path.rate[i] * t, path.w[i]); };
  const Motion ab = edge(0), cb = edge(1), cd = edge(2), ed = edge(3), ef = edge(4);
  const Vector3d w_df_e = ef.R * ef.w - ed.w;
  const Vector3d w_df_d = ed.R.transpose() * w_df_e;
  const Vector3d w_bf_c = cd.R * (w_df_d + cd.w) - cb.w;
  const Vector3d w_bf_b = cb.R.transpose() * w_bf_c;
  return ab.R * (w_bf_b + ab.w);
}

void body_rate(const Attitude& attitude, const Inertia& J_b, std::span<const double> y,
               std::span<double> ydot) {
  const std::size_t attitude_size = attitude == Attitude::quaternion ? 4 : 9;
  const Vector3d w = Eigen::Map<const Vector3d>(y.data() + attitude_size);
  if (attitude == Attitude::quaternion) {
    const Vector3d half = w / 2.0;
    const Quaterniond rate =
        Quaterniond(y[0], y[1], y[2], y[3]) * Quaterniond(0.0, half.x(), half.y(), half.z());
    ydot[0] = rate.w();
    ydot[1] = rate.x();
    ydot[2] = rate.y();
    ydot[3] = rate.z();
  } else {
    const Matrix3d R = Eigen::Map<const Matrix3d>(y.data());
    Eigen::Map<Matrix3d>(ydot.data()) = dcm_rate(R, w);
  }
  const Vector3d momentum = J_b.tensor * w;
  Eigen::Map<Vector3d>(ydot.data() + attitude_size) = J_b.inverse * -w.cross(momentum);
}

}  // namespace raw
