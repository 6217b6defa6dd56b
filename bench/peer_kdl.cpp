#include <kdl/frames.hpp>

#include "peers.hpp"

namespace bench::kdl {

using KDL::Frame;
using KDL::Rotation;
using KDL::Vector;
using Operands = Untyped<Rotation, Vector, Frame>;

// KDL returns a quaternion as four numbers and has no type for it.
struct Quaternion {
  double x, y, z, w;
};

struct List {
  Numbers operator()(const Vector& v) const { return {v.x(), v.y(), v.z()}; }
  Numbers operator()(const Quaternion& q) const { return {q.w, q.x, q.y, q.z}; }
  Numbers operator()(const Rotation& R) const { return Numbers(R.data, R.data + 9); }
  Numbers operator()(const Frame& X) const {
    Numbers list = (*this)(X.M);
    for (const double r : (*this)(X.p)) list.push_back(r);
    return list;
  }
};

[[gnu::noinline]] Quaternion dcm_to_quaternion(const Rotation& R_b_from_a) {
  Quaternion q;
  R_b_from_a.GetQuaternion(q.x, q.y, q.z, q.w);
  return q;
}

[[gnu::noinline]] Rotation exp_to_dcm(const Vector& theta_ab) {
  return Rotation::Rot(theta_ab, theta_ab.Norm());
}

[[gnu::noinline]] Vector log_of_dcm(const Rotation& R_a_from_b) {
  return R_a_from_b.GetRot();
}

[[gnu::noinline]] Rotation quaternion_to_dcm(const Quaternion& q) {
  return Rotation::Quaternion(q.x, q.y, q.z, q.w);
}

[[gnu::noinline]] Rotation euler_to_dcm(const Vector& yaw_pitch_roll) {
  return Rotation::EulerZYX(yaw_pitch_roll.x(), yaw_pitch_roll.y(), yaw_pitch_roll.z());
}

[[gnu::noinline]] Vector dcm_to_euler(const Rotation& R_a_from_b) {
  double yaw, pitch, roll;
  R_a_from_b.GetEulerZYX(yaw, pitch, roll);
  return Vector(yaw, pitch, roll);
}

}  // namespace bench::kdl

namespace bench {

Peer kdl_peer(const Given& given) {
  using namespace kdl;
  const auto rotation = [](const Nine& m) {
    return Rotation(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
  };
  const auto vector = [](const Three& v) { return Vector(v[0], v[1], v[2]); };
  const auto transform = [](const Rotation& R, const Vector& r) { return Frame(R, r); };
  static const Operands g(given, rotation, vector, transform);
  const auto& q = given.q[0];
  alignas(64) static const Quaternion q_b_from_a{q[1], q[2], q[3], q[0]};

  Peer peer = g.ways(List{});
  peer[Task::dcm_to_quaternion_below] = way<&dcm_to_quaternion>(List{}, g.R_below);
  peer[Task::dcm_to_quaternion_above] = way<&dcm_to_quaternion>(List{}, g.R_above);
  peer[Task::exp_to_dcm] = way<&exp_to_dcm>(List{}, g.theta);
  peer[Task::log_of_dcm] = way<&log_of_dcm>(List{}, g.R_below);
  peer[Task::log_of_dcm_small] = way<&log_of_dcm>(List{}, g.R_small);
  peer[Task::quaternion_to_dcm] = way<&quaternion_to_dcm>(List{}, q_b_from_a);
  peer[Task::euler_to_dcm] = way<&euler_to_dcm>(List{}, g.yaw_pitch_roll);
  peer[Task::dcm_to_euler] = way<&dcm_to_euler>(List{}, g.R_below);
  return peer;
}

}  // namespace bench
