#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "timing.hpp"

/// The same tasks on the same numbers in five libraries. Plain C++17, because one of the libraries needs it.
namespace bench {

using Numbers = std::vector<double>;
using Three = std::array<double, 3>;
using Four = std::array<double, 4>;
using Nine = std::array<double, 9>;

/// Matrices row by row, quaternions scalar first.
struct Given {
  std::array<Nine, 5> R;   // R_b_from_a, R_c_from_b, to R_f_from_e
  std::array<Three, 5> w;  // w_ab_b, w_bc_c, to w_ef_f, rad/s
  std::array<Four, 2> q;   // q_b_from_a, q_c_from_b
  std::array<Three, 2> r;  // positions for R[0] and R[1] in a transform, m
  Three r_a;
  Three theta, small_theta;  // rotation vectors, rad
  Nine R_below, R_above;     // below 120 degrees, where the scalar of the quaternion is largest, and above
  Nine R_small;              // by 1e-7 rad
  Four q_large, q_small;     // by 1.3 and by 1.3e-6 rad
  Three yaw_pitch_roll;      // rad, about z, then the turned y, then the turned x
};

enum class Task {
  dcm_product,
  dcm_on_vector,
  chain_on_vector,
  rate_chain,
  quaternion_product,
  transform_product,
  dcm_to_quaternion_below,
  dcm_to_quaternion_above,
  exp_to_quaternion,
  exp_to_quaternion_small,
  exp_to_dcm,
  log_of_dcm,
  log_of_dcm_small,
  log_of_quaternion,
  log_of_quaternion_small,
  quaternion_to_dcm,
  euler_to_dcm,
  dcm_to_euler
};

/// One task in one library. `result`: matrices row by row, quaternions scalar first, the rotation of a
/// transform before its translation.
struct Way {
  std::function<void(long)> repeat;
  std::function<Numbers()> result;
};
/// The tasks for which the library has a function.
using Peer = std::map<Task, Way>;

Peer vectrix_peer(const Given& given);
Peer eigen_peer(const Given& given);
Peer simbody_peer(const Given& given);
Peer kdl_peer(const Given& given);
Peer tf2_peer(const Given& given);

/// `kernel` of operands that must outlive the returned object; `list` gives the numbers of the result.
template <auto kernel, class List, class... Operands> Way way(const List& list, const Operands&... operands) {
  return {[&operands...](long calls) {
            for (long i = 0; i < calls; ++i) {
              alignas(64) const auto result = kernel(operands...);
              keep(result);
            }
          },
          [list, &operands...] { return list(kernel(operands...)); }};
}

/// The tasks for which all untyped libraries use the same code. No call is inlined, so all have the cost of a
/// call.
template <class Rotation, class Vector, class Transform> struct Untyped {
  [[gnu::noinline]] static Rotation dcm_product(const Rotation& R_c_from_b, const Rotation& R_b_from_a) {
    return R_c_from_b * R_b_from_a;
  }
  [[gnu::noinline]] static Vector dcm_on_vector(const Rotation& R_b_from_a, const Vector& r_a) {
    return R_b_from_a * r_a;
  }
  [[gnu::noinline]] static Vector chain_on_vector(const Untyped& g) {
    return g.R_f_from_e * g.R_e_from_d * g.R_d_from_c * g.R_c_from_b * g.R_b_from_a * g.r_a;
  }
  [[gnu::noinline]] static Vector rate_chain(const Untyped& g) {
    const Vector w_ac_c = g.R_c_from_b * g.w_ab_b + g.w_bc_c;
    const Vector w_ad_d = g.R_d_from_c * w_ac_c + g.w_cd_d;
    const Vector w_ae_e = g.R_e_from_d * w_ad_d + g.w_de_e;
    return g.R_f_from_e * w_ae_e + g.w_ef_f;
  }
  [[gnu::noinline]] static Transform transform_product(const Transform& X_c_from_b,
                                                       const Transform& X_b_from_a) {
    return X_c_from_b * X_b_from_a;
  }

  template <class MakeRotation, class MakeVector, class MakeTransform>
  Untyped(const Given& given, const MakeRotation& R, const MakeVector& v, const MakeTransform& X)
      : R_b_from_a(R(given.R[0])),
        R_c_from_b(R(given.R[1])),
        R_d_from_c(R(given.R[2])),
        R_e_from_d(R(given.R[3])),
        R_f_from_e(R(given.R[4])),
        R_below(R(given.R_below)),
        R_above(R(given.R_above)),
        R_small(R(given.R_small)),
        w_ab_b(v(given.w[0])),
        w_bc_c(v(given.w[1])),
        w_cd_d(v(given.w[2])),
        w_de_e(v(given.w[3])),
        w_ef_f(v(given.w[4])),
        r_a(v(given.r_a)),
        theta(v(given.theta)),
        small_theta(v(given.small_theta)),
        yaw_pitch_roll(v(given.yaw_pitch_roll)),
        X_b_from_a(X(R_b_from_a, v(given.r[0]))),
        X_c_from_b(X(R_c_from_b, v(given.r[1]))) {}

  /// The implementations of those tasks.
  template <class List> Peer ways(const List& list) const {
    return {{Task::dcm_product, way<&dcm_product>(list, R_c_from_b, R_b_from_a)},
            {Task::dcm_on_vector, way<&dcm_on_vector>(list, R_b_from_a, r_a)},
            {Task::chain_on_vector, way<&chain_on_vector>(list, *this)},
            {Task::rate_chain, way<&rate_chain>(list, *this)},
            {Task::transform_product, way<&transform_product>(list, X_c_from_b, X_b_from_a)}};
  }

  alignas(64) Rotation R_b_from_a;
  alignas(64) Rotation R_c_from_b;
  alignas(64) Rotation R_d_from_c;
  alignas(64) Rotation R_e_from_d;
  alignas(64) Rotation R_f_from_e;
  alignas(64) Rotation R_below;
  alignas(64) Rotation R_above;
  alignas(64) Rotation R_small;
  alignas(64) Vector w_ab_b;
  alignas(64) Vector w_bc_c;
  alignas(64) Vector w_cd_d;
  alignas(64) Vector w_de_e;
  alignas(64) Vector w_ef_f;
  alignas(64) Vector r_a;
  alignas(64) Vector theta;
  alignas(64) Vector small_theta;
  alignas(64) Vector yaw_pitch_roll;
  alignas(64) Transform X_b_from_a;
  alignas(64) Transform X_c_from_b;
};

}  // namespace bench
