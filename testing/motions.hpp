#pragma once

#include <Eigen/Core>

#include <unsupported/Eigen/AutoDiff>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

/// Motions whose derivatives come only from automatic differentiation of the matrices: the reference for
/// rates.
/// What needs no frame is compiled once, in motions.cpp.
namespace vectrix_test {

/// A number with its first time derivative; and with its second.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using Dual2 = Eigen::AutoDiffScalar<Eigen::Matrix<Dual, 1, 1>>;

inline Dual2 instant(double t) {
  return {Dual(t, 1, 0), 1, 0};
}
inline Dual2 constant(double x) {
  const Eigen::Matrix<double, 1, 1> none(0.0);
  return {Dual(x, none), Eigen::Matrix<Dual, 1, 1>(Dual(0.0, none))};
}
inline double value(const Dual2& x) {
  return x.value().value();
}
inline double first(const Dual2& x) {
  return x.derivatives()(0).value();
}
inline double second(const Dual2& x) {
  return x.derivatives()(0).derivatives()(0);
}

/// R_b^a and its first two derivatives, 1/s and 1/s^2.
struct MotionNumbers {
  Eigen::Matrix3d R, Rdot, Rddot;

  explicit MotionNumbers(const Eigen::Matrix<Dual2, 3, 3>& R_a_from_b);
  /// w_ab^a = vee(Rdot R^T)
  Eigen::Vector3d w_a() const;
  /// alpha_ab^a = d/dt w_ab^a = vee(Rddot R^T + Rdot Rdot^T)
  Eigen::Vector3d alpha_a() const;
};

/// These numbers with their frames.
template <class A, class B> struct Motion : MotionNumbers {
  explicit Motion(const vectrix::Dcm<A, B, Dual2>& R_a_from_b) : MotionNumbers(R_a_from_b.matrix()) {}

  vectrix::Dcm<A, B> rotation() const { return vectrix::dcm(vectrix::to<A>, vectrix::from<B>, R); }

  vectrix::AngularVelocity<A, B, vectrix::In<B>> w_ab_b() const {
    using namespace vectrix;
    return angular_velocity(of<B>, relative_to<A>,
                            vector<si::angular_velocity>(in<B>, R.transpose() * w_a()));
  }
  vectrix::AngularAcceleration<A, B, vectrix::In<B>> alpha_ab_b() const {
    using namespace vectrix;
    return angular_acceleration(of<B>, relative_to<A>,
                                vector<si::angular_acceleration>(in<B>, R.transpose() * alpha_a()));
  }
  vectrix::MovingDcm<A, B> moving() const { return moving_dcm(rotation(), w_ab_b()); }
  vectrix::AcceleratingDcm<A, B> accelerating() const {
    return accelerating_dcm(rotation(), w_ab_b(), alpha_ab_b());
  }
};

/// The derivatives of these motions reach 10 1/s and 100 1/s^2; a chain of three adds about ten roundings.
inline constexpr double motion_tolerance = 1e-12;

/// The matrix of three turns about different axes, with accelerations. `seed` selects the motion.
Eigen::Matrix<Dual2, 3, 3> turning_matrix(double seed, const Dual2& t);

/// A motion of b seen from a: those turns.
template <class A, class B> vectrix::Dcm<A, B, Dual2> turning(double seed, const Dual2& t) {
  using namespace vectrix;
  return trust_dcm(to<A>, from<B>, turning_matrix(seed, t));
}

}  // namespace vectrix_test
