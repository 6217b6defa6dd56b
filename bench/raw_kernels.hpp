#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>

/// The kernels written by hand in plain Eigen: the same mathematics on the same numbers; frames appear in
/// comments only.
namespace raw {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct RateChain {
  Vector3d w_ab_b, w_bc_c, w_cd_d, w_de_e, w_ef_f;
  Matrix3d R_c_from_b, R_d_from_c, R_e_from_d, R_f_from_e;
};

struct Inertia {
  Matrix3d tensor, inverse;
};

/// The matrices of a path: A from B, C from B, C from D, E from D, E from F.
struct ConstantPath {
  std::array<Matrix3d, 5> R;
};
/// The rates about z of the same edges, rad/s.
struct SpinPath {
  std::array<double, 5> rate;
  std::array<Vector3d, 5> w;
};

enum class Attitude { quaternion, dcm };

Matrix3d dcm_product(const Matrix3d& R_c_from_b, const Matrix3d& R_b_from_a);
Vector3d dcm_on_vector(const Matrix3d& R_b_from_a, const Vector3d& r_a);
Vector3d dcm_chain_on_vector(const Matrix3d& R_f_from_e, const Matrix3d& R_e_from_d,
                             const Matrix3d& R_d_from_c, const Matrix3d& R_c_from_b,
                             const Matrix3d& R_b_from_a, const Vector3d& r_a);
Vector3d vector_first(const Matrix3d& R_f_from_e, const Matrix3d& R_e_from_d, const Matrix3d& R_d_from_c,
                      const Matrix3d& R_c_from_b, const Matrix3d& R_b_from_a, const Vector3d& r_a);
Matrix3d dcm_product_of_three(const Matrix3d& R_d_from_c, const Matrix3d& R_c_from_b,
                              const Matrix3d& R_b_from_a);
Vector3d rate_chain(const RateChain& chain);
Matrix3d dcm_rate(const Matrix3d& R_a_from_b, const Vector3d& w_ab_b);
Vector3d euler(const Inertia& J_b, const Vector3d& w_ab_b, const Vector3d& torque_b);
Quaterniond quaternion_product(const Quaterniond& q_c_from_b, const Quaterniond& q_b_from_a);
Vector3d quaternion_on_vector(const Quaterniond& q_b_from_a, const Vector3d& r_a);
Matrix3d turned_z(const double& angle);
Quaterniond exp_to_quaternion(const Vector3d& theta_ab);
Matrix3d constant_graph(const ConstantPath& path, const double& t);
Matrix3d function_graph(const SpinPath& path, const double& t);
Vector3d moving_graph(const SpinPath& path, const double& t);
Vector3d moving_graph_reexpressed(const SpinPath& path, const double& t);
void body_rate(const Attitude& attitude, const Inertia& J_b, std::span<const double> y,
               std::span<double> ydot);

}  // namespace raw
