// The bugs of docs/explanation/bug_zoo.md for moving frames: each mistake in plain Eigen, and the law that
// finds it. The reference is a central difference of rotations and coordinates alone.
#include <gtest/gtest.h>

#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace bug_zoo_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Craft : named_point {};

constexpr double now = 0.4;
constexpr double h = 1e-5;
/// The error of a central difference: h^2/6 of a third derivative, which is below 10, plus epsilon/h.
constexpr double difference_tolerance = 1e-8;

template <class Function> auto slope(const Function& f, double t = now) {
  return ((f(t + h) - f(t - h)) / (2 * h)).eval();
}

/// R_b^a of a frame that turns about three axes; none of them is fixed.
Eigen::Quaterniond turned(double t) {
  return AngleAxisd(0.5 + 0.9 * t, Vector3d::UnitZ()) * AngleAxisd(0.3 - 0.7 * t * t, Vector3d::UnitX()) *
         AngleAxisd(std::sin(t), Vector3d::UnitY());
}
Matrix3d turning(double t) {
  return turned(t).toRotationMatrix();
}

Dcm<Gcrf, Body> attitude(double t = now) {
  return dcm(to<Gcrf>, from<Body>, turning(t));
}
DcmRate<Gcrf, Body> attitude_rate() {
  return dcm_rate(attitude(), slope(turning));
}
AngularVelocity<Gcrf, Body, In<Body>> body_rate() {
  return angular_velocity_from(attitude(), attitude_rate(), in<Body>);
}

TEST(BugZoo, TheTwoAnglesOfViewOfOneRateAreTwoVectors) {
  const Matrix3d R = turning(now);
  const Matrix3d Rdot = slope(turning);
  const auto residual = [&](const Vector3d& w_b) { return distance(R * hat(w_b), Rdot); };
  EXPECT_GT(residual(-vee(R.transpose() * Rdot)), visible);  // w_ba
  EXPECT_GT(residual(vee(Rdot * R.transpose())), visible);   // w_ab, but in a
  EXPECT_LE(residual(body_rate().coordinates()), difference_tolerance);
  const auto w_ab_a = angular_velocity_from(attitude(), attitude_rate(), in<Gcrf>);
  EXPECT_LE(distance(rate(attitude(), w_ab_a).matrix(), Rdot), difference_tolerance);
}

// The attitude after dt: the increment multiplies on the side of the frame in which the rate is expressed.
TEST(BugZoo, TheIncrementGoesOnTheSideOfItsFrame) {
  const Eigen::Quaterniond q = turned(now);
  const auto w_ab_a = angular_velocity_from(attitude(), attitude_rate(), in<Gcrf>);
  const Vector3d half = w_ab_a.coordinates() / 2;
  const Eigen::Quaterniond increment(0, half.x(), half.y(), half.z());
  const Eigen::Vector4d qdot = slope([](double t) -> Eigen::Vector4d { return turned(t).coeffs(); });
  EXPECT_GT(distance((q * increment).coeffs(), qdot), visible);
  const auto q_a_from_b = quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
  EXPECT_LE(distance(rate(q_a_from_b, w_ab_a).eigen().coeffs(), qdot), difference_tolerance);
}

// A frame with its first axis along r and its third axis along r x v. A force bends the orbit out of its
// plane.
TEST(BugZoo, TheRateOfAFrameIsNotTheRateOfItsFirstAxis) {
  const auto r = [](double t) { return Vector3d(std::cos(t), std::sin(t), 0.4 * std::sin(2 * t)); };
  const auto v = [](double t) { return Vector3d(-std::sin(t), std::cos(t), 0.8 * std::cos(2 * t)); };
  const auto axes = [&](double t) {
    Matrix3d R;
    R.col(0) = r(t).normalized();
    R.col(2) = r(t).cross(v(t)).normalized();
    R.col(1) = R.col(2).cross(R.col(0));
    return R;
  };
  const Matrix3d Rdot = slope(axes);
  const auto residual = [&](const Vector3d& w_ab_a) { return distance(hat(w_ab_a) * axes(now), Rdot); };
  const Vector3d orbital = r(now).cross(v(now)) / r(now).squaredNorm();
  EXPECT_GT(residual(orbital), visible);
  EXPECT_LE((hat(orbital) * axes(now) - Rdot).col(0).norm(), difference_tolerance);  // this hides the mistake
  const Dcm<Gcrf, Body> R_a_from_b = dcm(to<Gcrf>, from<Body>, axes(now));
  const auto w_ab_a = angular_velocity_from(R_a_from_b, dcm_rate(R_a_from_b, Rdot), in<Gcrf>);
  EXPECT_LE(residual(w_ab_a.coordinates()), difference_tolerance);
}

// e turns at a constant rate in i, b turns in i: the acceleration of b relative to e.
TEST(BugZoo, TheAccelerationOfAChainHasATermWithASign) {
  const Vector3d w_ie_i(0, 0, 0.6);
  const auto R_i_from_e = [&](double t) {
    return AngleAxisd(w_ie_i.z() * t, Vector3d::UnitZ()).toRotationMatrix();
  };
  const auto w_ib_b = [](double t) -> Vector3d { return vee(turning(t).transpose() * slope(turning, t)); };
  const auto w_eb_b = [&](double t) -> Vector3d { return w_ib_b(t) - turning(t).transpose() * w_ie_i; };
  // Second differences: epsilon/h^2 is 1e-6 where h is 1e-5.
  constexpr double second_difference_tolerance = 1e-4;
  const Vector3d alpha_ib_b = slope(w_ib_b);  // w x w vanishes: the same from i and from b
  const Vector3d alpha_eb_b = slope(w_eb_b);
  const Vector3d w_ie_b = turning(now).transpose() * w_ie_i;
  EXPECT_GT(distance(Vector3d(alpha_ib_b - w_ib_b(now).cross(w_ie_b)), alpha_eb_b), visible);
  EXPECT_GT(distance(alpha_ib_b, alpha_eb_b), visible);  // the omitted term

  const auto ib =
      accelerating_dcm(attitude(), body_rate(),
                       angular_acceleration(of<Body>, relative_to<Gcrf>,
                                            vector<si::angular_acceleration>(in<Body>, alpha_ib_b)));
  const auto w_ie_e =
      angular_velocity(of<Itrf>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Itrf>, w_ie_i));
  const auto ie = accelerating_dcm(dcm(to<Gcrf>, from<Itrf>, R_i_from_e(now)), w_ie_e,
                                   unaccelerated(of<Itrf>, relative_to<Gcrf>, in<Itrf>));
  EXPECT_LE(distance((inverse(ie) * ib).angular_acceleration.coordinates(), alpha_eb_b),
            second_difference_tolerance);
}

TEST(BugZoo, AMotionAfterItsInverseIsRest) {
  const auto ab = moving_dcm(attitude(), body_rate());
  const Vector3d w_ab_b = body_rate().coordinates();
  // w_aa^a of (R_b^a, w_ab^b) * (R_a^b, w_ba^a)
  const auto rate_of_product = [&](const Vector3d& w_ba_a) -> Vector3d {
    return turning(now) * w_ab_b + w_ba_a;
  };
  EXPECT_GT(rate_of_product(turning(now) * w_ab_b).norm(), visible);  // not negated
  EXPECT_GT(rate_of_product(-w_ab_b).norm(), visible);                // not re-expressed
  EXPECT_LE((ab * inverse(ab)).angular_velocity.coordinates().norm(), rounding);
  EXPECT_LE((inverse(ab) * ab).angular_velocity.coordinates().norm(), rounding);
}

// An orbit of 7000 km about the Earth. The velocity seen from the ground is not the orbit's velocity in the
// ground's axes.
TEST(BugZoo, AVelocityIsTransportedNotOnlyRotated) {
  constexpr double spin = 7.292115e-5;  // rad/s
  constexpr double period_rate = 1.078e-3;
  const auto r_i = [](double t) {
    return Vector3d(7e6 * std::cos(period_rate * t), 4e6 * std::sin(period_rate * t),
                    5.7e6 * std::sin(period_rate * t));
  };
  const auto R_i_from_e = [](double t) {
    return AngleAxisd(1.2 + spin * t, Vector3d::UnitZ()).toRotationMatrix();
  };
  // Coordinates of 7e6 m, differences over 1 s: rounding 1e-9 m, h^2/6 of a third derivative of 1e-2 m/s^3.
  constexpr double t = 900.0;
  constexpr double step = 0.5;
  constexpr double orbit_tolerance = 5e-3;
  const auto slope_of = [&](const auto& f) -> Vector3d { return (f(t + step) - f(t - step)) / (2 * step); };
  const Vector3d v_i = slope_of(r_i);
  const Vector3d v_e = slope_of([&](double at) -> Vector3d { return R_i_from_e(at).transpose() * r_i(at); });
  EXPECT_GT((R_i_from_e(t).transpose() * v_i - v_e).norm(), 300.0);  // m/s

  const Dcm<Itrf, Gcrf> R_e_from_i = inverse(dcm(to<Gcrf>, from<Itrf>, R_i_from_e(t)));
  const auto r_i_i = displacement(of<Craft>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r_i(t)));
  const auto v_i_i =
      velocity(of<Craft>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::velocity>(in<Gcrf>, v_i));
  const auto w_ei_e = -angular_velocity(of<Itrf>, relative_to<Gcrf>,
                                        vector<si::angular_velocity>(in<Itrf>, Vector3d(0, 0, spin)));
  const auto found = transport(observed_from<Itrf>, R_e_from_i * v_i_i, R_e_from_i * r_i_i, w_ei_e);
  EXPECT_LE((found.coordinates() - v_e).norm(), orbit_tolerance);
}

// A lander at rest on the Moon. A stored copy of the length of w was never set: 4.2 m/s are lost.
TEST(BugZoo, ARateHasNoSecondCopy) {
  const Vector3d w_im_m(1e-7, -2e-7, 2.66e-6);  // rad/s
  const Vector3d r_m(1.1e6, 1.1e6, 0.8e6);      // m
  const double stale_length = 0.0;
  const Vector3d v_m = stale_length != 0.0 ? Vector3d(w_im_m.cross(r_m)) : Vector3d::Zero();
  EXPECT_GT((v_m - w_im_m.cross(r_m)).norm(), 4.0);  // m/s

  const auto w =
      angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w_im_m));
  const auto r = displacement(of<Craft>, relative_to<Body>, vector<si::length>(in<Body>, r_m));
  const auto v = transport(observed_from<Gcrf>,
                           at_rest(of<Craft>, relative_to<Body>, observed_from<Body>, in<Body>), r, w);
  EXPECT_EQ(v.coordinates(), w_im_m.cross(r_m));
}

// A coasting body that rotates: the derivative of its velocity's coordinates is not an acceleration.
TEST(BugZoo, TheDerivativeOfCoordinatesBelongsToTheirFrame) {
  const Vector3d v_a(3, -1, 2);  // constant in a
  const auto v_b = [&](double t) -> Vector3d { return turning(t).transpose() * v_a; };
  const Vector3d vdot_b = slope(v_b);
  EXPECT_GT(vdot_b.norm(), visible);
  const auto seen_from_b =
      derivative<si::velocity>(observed_from<Body>, vector<si::acceleration>(in<Body>, vdot_b));
  const auto seen_from_a =
      transport(observed_from<Gcrf>, seen_from_b, vector<si::velocity>(in<Body>, v_b(now)), body_rate());
  EXPECT_LE(seen_from_a.vector().coordinates().norm(), difference_tolerance);
}

// The mean rate over the last dt is the rate at dt/2 ago, about an axis that has moved since.
TEST(BugZoo, ADifferenceOfAttitudesIsAnAverageOfThePast) {
  const Matrix3d Rdot = slope(turning);
  const auto residual = [&](const Vector3d& w_b) { return distance(turning(now) * hat(w_b), Rdot); };
  const auto averaged = [](double dt) -> Vector3d {
    const AngleAxisd turn(Matrix3d(turning(now - dt).transpose() * turning(now)));
    return turn.axis() * turn.angle() / dt;
  };
  EXPECT_GT(residual(averaged(0.1)), visible);
  EXPECT_NEAR(residual(averaged(0.1)) / residual(averaged(0.05)), 2.0, 0.2);  // first order in dt
  EXPECT_LE(residual(body_rate().coordinates()), difference_tolerance);
}

// q1 and -q1 are one attitude. With three of four signs changed it is another attitude.
TEST(BugZoo, TheSignOfAQuaternionIsNoAttitude) {
  const Eigen::Quaterniond q0(AngleAxisd(0.4, Vector3d(1, 2, 2) / 3));
  const Eigen::Quaterniond q1(AngleAxisd(1.5, Vector3d(-2, 1, 2) / 3));
  const auto between = [&](Eigen::Quaterniond end, bool all_four) {
    double cosine = q0.dot(end);
    if (cosine < 0) {
      end.w() = -end.w();
      end.x() = -end.x();
      end.y() = -end.y();
      end.z() = all_four ? -end.z() : end.z();
      cosine = -cosine;
    }
    const double angle = std::acos(cosine);
    Eigen::Quaterniond q;
    q.coeffs() =
        (std::sin(0.7 * angle) * q0.coeffs() + std::sin(0.3 * angle) * end.coeffs()) / std::sin(angle);
    return q.normalized().toRotationMatrix();
  };
  const Eigen::Quaterniond minus_q1(-q1.coeffs());
  EXPECT_GT(distance(between(minus_q1, false), between(q1, false)), visible);

  const auto typed = [](const Eigen::Quaterniond& q) {
    return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
  };
  const auto found = [&](const Eigen::Quaterniond& end) {
    return Slerp(0.0 * si::second, typed(q0), 1.0 * si::second, typed(end))(0.3 * si::second)
        .rotation.matrix();
  };
  EXPECT_LE(distance(found(minus_q1), found(q1)), rounding);
  EXPECT_LE(distance(found(q1), between(q1, true)), rounding);
}

}  // namespace
}  // namespace bug_zoo_test
