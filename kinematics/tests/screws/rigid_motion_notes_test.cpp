// Three wrong formulas of lecture notes on rigid motion, each compared with the correct result from power
// series of the matrices alone:
//   - points written with the homogeneous coordinate 0;
//   - exp(V^ t) = [R, (I - R) p; 0 1] with p = w x v/|w|^2, derived with an inverse of [w]x;
//   - Rx(w1 t) Ry(w2 t) Rz(w3 t) = exp([w]x t).
#include <gtest/gtest.h>

#include "points/moving_points.hpp"
#include "rigid_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rigid_motion_notes_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Six = Eigen::Matrix<double, 6, 1>;

const Vector3d w(0.3, -0.8, 0.5);  // rad/s
constexpr double t = 0.7;          // s

Six numbers(const Vector3d& rate, const Vector3d& v) {
  Six V;
  V << rate, v;
  return V;
}
Matrix4d series(const Six& V) {
  return power_series<4>(four_by_four(extended(Six(V * t))), 0).cast<double>();
}
Matrix4d library(const Six& V) {
  return homogeneous_matrix(exp(held(twist_with<Gcrf, Body, Gcrf, Gcrf>(V), t * si::second)));
}
/// The notes' translation, (I - R) (w x v)/|w|^2.
Vector3d doubtful(const Six& V) {
  const Matrix3d R = series(V).topLeftCorner<3, 3>();
  const Vector3d rate = V.head<3>();
  return (Matrix3d::Identity() - R) * rate.cross(V.tail<3>()) / rate.squaredNorm();
}

TEST(Notes, ThePointsOfARigidMotionNeedTheCoordinateOne) {
  const Six V = numbers(w, {1.0, 2.0, -0.5});
  const Matrix4d G = series(V);
  const Vector3d q(0.2, -0.4, 1.0);
  const Vector4d as_vector = G * q.homogeneous().cwiseProduct(Vector4d(1, 1, 1, 0));
  EXPECT_LE(distance(as_vector.head<3>(), G.topLeftCorner<3, 3>() * q), rounding);  // rotated, not translated
  const Vector4d as_point = G * q.homogeneous();
  const auto X = exp(held(twist_with<Gcrf, Body, Gcrf, Gcrf>(V), t * si::second));
  const auto q_b = displacement(of<Camera>, relative_to<Body>, vector<si::length>(in<Body>, q));
  EXPECT_LE(distance((X * q_b).coordinates(), as_point.head<3>()), rounding);
  EXPECT_GT(distance(as_point, as_vector), visible);
  // Its velocity is w x q + v; with 0 in place of 1, v is lost.
  const Matrix4d V_hat = four_by_four(extended(V)).cast<double>();
  const auto at_q = shift(twist_with<Gcrf, Body, Gcrf, Gcrf>(V),
                          displacement(of<Camera>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, q)));
  EXPECT_LE(distance(at_q.velocity().coordinates(), (V_hat * q.homogeneous()).head<3>()), rounding);
  EXPECT_GT(distance(at_q.velocity().coordinates(), w.cross(q)), visible);
}

TEST(Notes, TheDoubtfulExponentialHoldsWhereNothingMovesAlongTheAxis) {
  const Vector3d across = w.cross(Vector3d(1.0, 2.0, -0.5));
  const Six V = numbers(w, across);
  EXPECT_NEAR(w.dot(across), 0.0, rounding);
  EXPECT_LE(distance(doubtful(V), series(V).topRightCorner<3, 1>()), rounding);
  EXPECT_LE(distance(library(V), series(V)), rounding);
}

TEST(Notes, TheDoubtfulExponentialLosesTheMotionAlongTheAxis) {
  const Six V = numbers(w, {1.0, 2.0, -0.5});
  const Vector3d v = V.tail<3>();
  const Vector3d true_one = series(V).topRightCorner<3, 1>();
  EXPECT_GT(distance(doubtful(V), true_one), visible);
  // The lost term is w (w . v) t/|w|^2, to the last digit.
  const Vector3d along = w * w.dot(v) * t / w.squaredNorm();
  EXPECT_LE(distance(doubtful(V) + along, true_one), rounding);
  EXPECT_LE(distance(library(V), series(V)), rounding);
  EXPECT_NEAR(screw_axis(held(twist_with<Gcrf, Body, Gcrf, Gcrf>(V), t * si::second)).advance.value(),
              along.norm() * (w.dot(v) < 0 ? -1 : 1), rounding);
  // [w]x, which the notes invert, is singular; and for w = 0 the notes divide by zero.
  EXPECT_NEAR(hat(w).determinant(), 0.0, rounding);
  const Six still = numbers(Vector3d::Zero(), v);
  EXPECT_FALSE(doubtful(still).allFinite());
  EXPECT_LE(distance(library(still).topRightCorner<3, 1>(), v * t), rounding);
}

// The translation (I - R) p assumes that p = w x v/|w|^2 is at rest. p is a point of the axis: it is at rest
// only if the advance is zero.
TEST(Notes, ThePointOfTheAxisIsCarriedAlong) {
  const Six V = numbers(w, {1.0, 2.0, -0.5});
  const Vector3d v = V.tail<3>();
  const Vector3d p = w.cross(v) / w.squaredNorm();
  const Vector4d moved_p = series(V) * p.homogeneous();
  EXPECT_LE(distance(moved_p.head<3>(), p + w * w.dot(v) * t / w.squaredNorm()), rounding);
  const auto axis = screw_axis(held(twist_with<Gcrf, Body, Gcrf, Gcrf>(V), t * si::second));
  EXPECT_LE(distance(axis.place.coordinates(), p), rounding);
}

TEST(Notes, ThreeTurnsAboutTheAxesAreNotOneAboutTheVector) {
  const auto angle = [](double rate, double time) { return rate * time * si::radian; };
  const auto three = [&](double time) {
    return inverse(turned_z(to<Body>, from<Camera>, angle(w.z(), time)) *
                   turned_y(to<Camera>, from<Ground>, angle(w.y(), time)) *
                   turned_x(to<Ground>, from<Gcrf>, angle(w.x(), time)))
        .matrix()
        .eval();
  };
  const auto one = [&](double time) { return exp(turn_of(w * time)).matrix(); };
  const double apart = (three(t) - one(t)).norm();
  EXPECT_GT(apart, 0.1);  // Frobenius norm, of 0.7 rad
  // The one rotation is additive in time, the product of three is not.
  EXPECT_LE(distance(one(t) * one(0.4), one(t + 0.4)), rounding);
  EXPECT_GT(distance(three(t) * three(0.4), three(t + 0.4)), visible);
  // The correct statement: the derivative of the product at t = 0 is [w]x, so that the two differ by the
  // square of t.
  EXPECT_NEAR((three(t / 100) - one(t / 100)).norm() / apart, 1e-4, 2e-5);
}

}  // namespace
}  // namespace rigid_motion_notes_test
