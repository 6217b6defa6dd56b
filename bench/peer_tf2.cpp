#include <tf2/LinearMath/Transform.h>

#include "peers.hpp"

namespace bench::ros {

using tf2::Matrix3x3;
using tf2::Quaternion;
using tf2::Transform;
using tf2::Vector3;
using Operands = Untyped<Matrix3x3, Vector3, Transform>;

struct List {
  Numbers operator()(const Vector3& v) const { return {v.x(), v.y(), v.z()}; }
  Numbers operator()(const Quaternion& q) const { return {q.w(), q.x(), q.y(), q.z()}; }
  Numbers operator()(const Matrix3x3& R) const {
    Numbers list;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) list.push_back(R[i][j]);
    return list;
  }
  Numbers operator()(const Transform& X) const {
    Numbers list = (*this)(X.getBasis());
    for (const double r : (*this)(X.getOrigin())) list.push_back(r);
    return list;
  }
};

[[gnu::noinline]] Quaternion quaternion_product(const Quaternion& q_c_from_b, const Quaternion& q_b_from_a) {
  return q_c_from_b * q_b_from_a;
}

[[gnu::noinline]] Quaternion dcm_to_quaternion(const Matrix3x3& R_b_from_a) {
  Quaternion q;
  R_b_from_a.getRotation(q);
  return q;
}

[[gnu::noinline]] Quaternion exp_to_quaternion(const Vector3& theta_ab) {
  return Quaternion(theta_ab, theta_ab.length());
}

[[gnu::noinline]] Matrix3x3 exp_to_dcm(const Vector3& theta_ab) {
  return Matrix3x3(Quaternion(theta_ab, theta_ab.length()));
}

[[gnu::noinline]] Vector3 log_of_dcm(const Matrix3x3& R_a_from_b) {
  Quaternion q;
  R_a_from_b.getRotation(q);
  return q.getAxis() * q.getAngle();
}

[[gnu::noinline]] Vector3 log_of_quaternion(const Quaternion& q_a_from_b) {
  return q_a_from_b.getAxis() * q_a_from_b.getAngle();
}

[[gnu::noinline]] Matrix3x3 quaternion_to_dcm(const Quaternion& q_b_from_a) {
  return Matrix3x3(q_b_from_a);
}

[[gnu::noinline]] Matrix3x3 euler_to_dcm(const Vector3& yaw_pitch_roll) {
  Matrix3x3 R_a_from_b;
  R_a_from_b.setEulerYPR(yaw_pitch_roll.x(), yaw_pitch_roll.y(), yaw_pitch_roll.z());
  return R_a_from_b;
}

[[gnu::noinline]] Vector3 dcm_to_euler(const Matrix3x3& R_a_from_b) {
  double yaw, pitch, roll;
  R_a_from_b.getEulerYPR(yaw, pitch, roll);
  return Vector3(yaw, pitch, roll);
}

}  // namespace bench::ros

namespace bench {

Peer tf2_peer(const Given& given) {
  using namespace ros;
  const auto matrix = [](const Nine& m) {
    return Matrix3x3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
  };
  const auto vector = [](const Three& v) { return Vector3(v[0], v[1], v[2]); };
  const auto transform = [](const Matrix3x3& R, const Vector3& r) { return Transform(R, r); };
  const auto quaternion = [](const Four& q) { return Quaternion(q[1], q[2], q[3], q[0]); };
  static const Operands g(given, matrix, vector, transform);
  alignas(64) static const Quaternion q_b_from_a = quaternion(given.q[0]);
  alignas(64) static const Quaternion q_c_from_b = quaternion(given.q[1]);
  alignas(64) static const Quaternion q_large = quaternion(given.q_large);
  alignas(64) static const Quaternion q_small = quaternion(given.q_small);
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
