// The rigid-body bugs of docs/explanation/bug_zoo.md: each mistake in plain Eigen, and the law that finds it.
#include <Eigen/Eigenvalues>
#include <vectrix/dynamics.hpp>

#include "rigid_bodies.hpp"

using namespace vectrix;
using namespace vectrix::test;

namespace bug_zoo_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Rounding: sums of a few products of numbers below 100.
constexpr double rounding = 1e-13;
/// Far above rounding.
constexpr double visible = 1e-2;

/// Four masses, kg, about their centre of mass, m: the axes all differ, and so do the products of inertia.
struct Cloud {
  std::array<double, 4> m = {1.0, 2.0, 1.5, 3.0};
  std::array<Vector3d, 4> r = {
      Vector3d(1.0, 0.2, -0.4), Vector3d(-0.3, 0.9, 0.5), Vector3d(0.4, -1.1, 0.8), {}};

  Cloud() { r[3] = -(m[0] * r[0] + m[1] * r[1] + m[2] * r[2]) / m[3]; }

  double sum(int i, int j) const {
    double total = 0.0;
    for (std::size_t k = 0; k < m.size(); ++k) total += m[k] * r[k](i) * r[k](j);
    return total;
  }
  double moment(int i, int j) const { return sum(i, i) + sum(j, j); }

  /// The law h = sum m r x (w x r).
  Vector3d momentum(const Vector3d& w) const {
    Vector3d h = Vector3d::Zero();
    for (std::size_t k = 0; k < m.size(); ++k) h += m[k] * r[k].cross(w.cross(r[k]));
    return h;
  }
};

const Vector3d w(0.3, -0.7, 0.5);

// sum m x y, given where the tensor's entry - sum m x y is required: positive, symmetric, a valid inertia,
// and wrong.
TEST(BugZoo, AProductOfInertiaIsMinusTheEntryOfTheTensor) {
  const Cloud cloud;
  const double xx = cloud.moment(1, 2), yy = cloud.moment(0, 2), zz = cloud.moment(0, 1);
  const double xy = cloud.sum(0, 1), xz = cloud.sum(0, 2), yz = cloud.sum(1, 2);
  const Inertia<Body> mistaken = tensor(xx, yy, zz, xy, xz, yz);  // the door cannot detect it
  EXPECT_GT(((mistaken * rate_body(w)).coordinates() - cloud.momentum(w)).norm(), visible);

  const auto unit = si::kilogram_square_metre;
  const auto J_b =
      inertia_from_moments_and_products(in<Body>, xx * unit, yy * unit, zz * unit, vectrix::xy(xy * unit),
                                        vectrix::xz(xz * unit), vectrix::yz(yz * unit));
  EXPECT_LE(((J_b * rate_body(w)).coordinates() - cloud.momentum(w)).norm(), rounding);
}

// J = R D R^T with R = R_p^b. R^T D R has the same principal moments: only its axes are wrong.
TEST(BugZoo, PrincipalAxesHaveADirection) {
  const Cloud cloud;
  const Matrix3d J = tensor(cloud.moment(1, 2), cloud.moment(0, 2), cloud.moment(0, 1), -cloud.sum(0, 1),
                            -cloud.sum(0, 2), -cloud.sum(1, 2))
                         .matrix();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(J);
  const Matrix3d R_b_from_p = solver.eigenvectors();
  const auto as_claimed = [](const Matrix3d& m) {
    return tensor(m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2));
  };
  const Matrix3d moments = solver.eigenvalues().asDiagonal();
  const Inertia<Body> mistaken = as_claimed(R_b_from_p.transpose() * moments * R_b_from_p);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> again(mistaken.matrix());
  EXPECT_LE((again.eigenvalues() - solver.eigenvalues()).norm(), rounding);
  EXPECT_GT(((mistaken * rate_body(w)).coordinates() - cloud.momentum(w)).norm(), visible);
  const Inertia<Body> J_b = as_claimed(R_b_from_p * moments * R_b_from_p.transpose());
  EXPECT_LE(((J_b * rate_body(w)).coordinates() - cloud.momentum(w)).norm(), rounding);
}

// The power of a force at r on a rotating body equals the power of its torque: F . (w x r) = tau . w.
TEST(BugZoo, ATorqueDoesTheWorkOfItsForce) {
  const Vector3d r(0.4, -1.2, 0.7);
  const Vector3d F(3.0, 0.5, -2.0);
  const double power = F.dot(w.cross(r));
  EXPECT_GT(std::abs(F.cross(r).dot(w) - power), visible);
  const Vector<Body, si::torque> torque_b =
      cross(vector<si::length>(in<Body>, r), vector<si::force>(in<Body>, F));
  EXPECT_NEAR(dot(torque_b, rate_body(w).vector()).value(), power, rounding);
}

// d/dt|_i h = tau; in the body's axes J alpha + w x J w = tau.
TEST(BugZoo, MomentumChangesByTheTorqueAlone) {
  const Inertia<Body> J_b = tensor(2.0, 3.5, 5.0, 0.3, -0.2, 0.4);
  const Vector3d tau(0.1, 0.4, -0.2);
  const auto residual = [&](const Vector3d& alpha) {
    return (J_b.matrix() * alpha + w.cross(J_b.matrix() * w) - tau).norm();
  };
  EXPECT_GT(residual(J_b.inverse_matrix() * tau), visible);
  EXPECT_LE(residual(euler(J_b, rate_body(w), torque_body(0.1, 0.4, -0.2)).coordinates()), rounding);
}

}  // namespace
}  // namespace bug_zoo_test
