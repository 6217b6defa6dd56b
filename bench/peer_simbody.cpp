#include <SimTKcommon/Orientation.h>

#include "peers.hpp"

// Unlike the states of Simbody's systems, rotations and transforms are the same with and without NDEBUG.
namespace bench::simbody {

using SimTK::Mat33;
using SimTK::Quaternion;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;
using SimTK::Vec4;
using Operands = Untyped<Rotation, Vec3, Transform>;

struct List {
  Numbers operator()(const Vec3& v) const { return {v[0], v[1], v[2]}; }
  Numbers operator()(const Quaternion& q) const { return {q[0], q[1], q[2], q[3]}; }
  Numbers operator()(const Rotation& R) const {
    Numbers list;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) list.push_back(R[i][j]);
    return list;
  }
  Numbers operator()(const Transform& X) const {
    Numbers list = (*this)(X.R());
    for (const double r : (*this)(X.p())) list.push_back(r);
    return list;
  }
};

[[gnu::noinline]] Quaternion dcm_to_quaternion(const Rotation& R_b_from_a) {
  return R_b_from_a.convertRotationToQuaternion();
}

[[gnu::noinline]] Quaternion exp_to_quaternion(const Vec3& theta_ab) {
  Quaternion q;
  q.setQuaternionFromAngleAxis(theta_ab.norm(), UnitVec3(theta_ab));
  return q;
}

[[gnu::noinline]] Rotation exp_to_dcm(const Vec3& theta_ab) {
  return Rotation(theta_ab.norm(), theta_ab);
}

[[gnu::noinline]] Vec3 log_of_dcm(const Rotation& R_a_from_b) {
  const Vec4 turn = R_a_from_b.convertRotationToAngleAxis();
  return turn[0] * turn.getSubVec<3>(1);
}

[[gnu::noinline]] Vec3 log_of_quaternion(const Quaternion& q_a_from_b) {
  const Vec4 turn = q_a_from_b.convertQuaternionToAngleAxis();
  return turn[0] * turn.getSubVec<3>(1);
}

[[gnu::noinline]] Rotation quaternion_to_dcm(const Quaternion& q_b_from_a) {
  return Rotation(q_b_from_a);
}

[[gnu::noinline]] Rotation euler_to_dcm(const Vec3& yaw_pitch_roll) {
  return Rotation(SimTK::BodyRotationSequence, yaw_pitch_roll[0], SimTK::ZAxis, yaw_pitch_roll[1],
                  SimTK::YAxis, yaw_pitch_roll[2], SimTK::XAxis);
}

[[gnu::noinline]] Vec3 dcm_to_euler(const Rotation& R_a_from_b) {
  return R_a_from_b.convertThreeAxesRotationToThreeAngles(SimTK::BodyRotationSequence, SimTK::ZAxis,
                                                          SimTK::YAxis, SimTK::XAxis);
}

}  // namespace bench::simbody

namespace bench {

Peer simbody_peer(const Given& given) {
  using namespace simbody;
  const auto rotation = [](const Nine& m) {
    return Rotation(Mat33(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]), true);
  };
  const auto vector = [](const Three& v) { return Vec3(v[0], v[1], v[2]); };
  const auto transform = [](const Rotation& R, const Vec3& r) { return Transform(R, r); };
  static const Operands g(given, rotation, vector, transform);
  const auto quaternion = [](const Four& q) { return Quaternion(Vec4(q[0], q[1], q[2], q[3])); };
  alignas(64) static const Quaternion q_b_from_a = quaternion(given.q[0]);
  alignas(64) static const Quaternion q_large = quaternion(given.q_large);
  alignas(64) static const Quaternion q_small = quaternion(given.q_small);

  Peer peer = g.ways(List{});
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
