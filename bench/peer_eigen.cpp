#include <Eigen/Geometry>

#include "peers.hpp"

namespace bench::raw_eigen {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Operands = Untyped<Matrix3d, Vector3d, Isometry3d>;

struct List {
  Numbers operator()(const Vector3d& v) const { return {v.x(), v.y(), v.z()}; }
  Numbers operator()(const Quaterniond& q) const { return {q.w(), q.x(), q.y(), q.z()}; }
  Numbers operator()(const Matrix3d& R) const {
    const Matrix3d transposed = R.transpose();
    return Numbers(transposed.data(), transposed.data() + transposed.size());
  }
  Numbers operator()(const Isometry3d& X) const {
    Numbers list = (*this)(Matrix3d(X.linear()));
    for (const double r : (*this)(Vector3d(X.translation()))) list.push_back(r);
    return list;
  }
};

[[gnu::noinline]] Quaterniond quaternion_product(const Quaterniond& q_c_from_b,
                                                 const Quaterniond& q_b_from_a) {
  return q_c_from_b * q_b_from_a;
}

[[gnu::noinline]] Quaterniond dcm_to_quaternion(const Matrix3d& R_b_from_a) {
  return Quaterniond(R_b_from_a);
}

[[gnu::noinline]] Quaterniond exp_to_quaternion(const Vector3d& theta_ab) {
  const double angle = theta_ab.norm();
  if (angle == 0.0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, theta_ab / angle));
}

[[gnu::noinline]] Matrix3d exp_to_dcm(const Vector3d& theta_ab) {
  const double angle = theta_ab.norm();
  if (angle == 0.0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, theta_ab / angle).toRotationMatrix();
}

[[gnu::noinline]] Vector3d log_of_dcm(const Matrix3d& R_a_from_b) {
  const Eigen::AngleAxisd turn(R_a_from_b);
  return turn.angle() * turn.axis();
}

[[gnu::noinline]] Vector3d log_of_quaternion(const Quaterniond& q_a_from_b) {
  const Eigen::AngleAxisd turn(q_a_from_b);
  return turn.angle() * turn.axis();
}

[[gnu::noinline]] Matrix3d quaternion_to_dcm(const Quaterniond& q_b_from_a) {
  return q_b_from_a.toRotationMatrix();
}

[[gnu::noinline]] Matrix3d euler_to_dcm(const Vector3d& yaw_pitch_roll) {
  return (Eigen::AngleAxisd(yaw_pitch_roll(0), Vector3d::UnitZ()) *
          Eigen::AngleAxisd(yaw_pitch_roll(1), Vector3d::UnitY()) *
          Eigen::AngleAxisd(yaw_pitch_roll(2), Vector3d::UnitX()))
      .toRotationMatrix();
}

[[gnu::noinline]] Vector3d dcm_to_euler(const Matrix3d& R_a_from_b) {
  return R_a_from_b.eulerAngles(2, 1, 0);
}

}  // namespace bench::raw_eigen

namespace bench {

Peer eigen_peer(const Given& given) {
  using namespace raw_eigen;
  const auto matrix = [](const Nine& m) { return Matrix3d(Matrix3d::ConstMapType(m.data()).transpose()); };
  const auto vector = [](const Three& v) { return Vector3d(v[0], v[1], v[2]); };
  const auto transform = [](const Matrix3d& R, const Vector3d& r) {
    Isometry3d X = Isometry3d::Identity();
    X.linear() = R;
    X.translation() = r;
    return X;
  };
  const auto quaternion = [](const Four& q) { return Quaterniond(q[0], q[1], q[2], q[3]); };
  static const Operands g(given, matrix, vector, transform);
  alignas(64) static const Quaterniond q_b_from_a = quaternion(given.q[0]);
  alignas(64) static const Quaterniond q_c_from_b = quaternion(given.q[1]);
  alignas(64) static const Quaterniond q_large = quaternion(given.q_large);
  alignas(64) static const Quaterniond q_small = quaternion(given.q_small);
  Peer peer = g.ways(List{});
  peer[Task::quaternion_product] = way<&quaternion_product>(List{}, q_c_from_b, q_b_from_a);
  peer[Task::dcm_to_quaternion_below] = way<&dcm_to_quaternion>(List{}, g.R_below);
  peer[Task::dcm_to_quaternion_above] = way<&dcm_to_quaternion>(List{}, g.R_above);
  peer[Task::exp_to_quaternion] = way<&exp_to_quaternion>(List{}, g.theta);
  peer[Task::exp_to_quaternion_small] = way<&exp_to_quaternion>(List{}, g.small_theta);
  peer[Task::exp_to_dcm] = way<&exp_to_dcm>(List{}, g.theta);
  peer[Task::log_of_dcm] = way<&log_of_dcm>(List{}, g.R_below);
  peer[Task::log_of_dcm_small] = way<&log_of_dcm>(List{}, g.R_small);
  peer[Task::log_of_quaternion] = way<&log_of_quaternion>(List{}, q_large);
  peer[Task::log_of_quaternion_small] = way<&log_of_quaternion>(List{}, q_small);
  peer[Task::quaternion_to_dcm] = way<&quaternion_to_dcm>(List{}, q_b_from_a);
  peer[Task::euler_to_dcm] = way<&euler_to_dcm>(List{}, g.yaw_pitch_roll);
  peer[Task::dcm_to_euler] = way<&dcm_to_euler>(List{}, g.R_below);
  return peer;
}

}  // namespace bench
