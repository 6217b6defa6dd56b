#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vectrix/dynamics/mass/inertia.hpp>
#include <vectrix/dynamics/rigid/state.hpp>
#include <vectrix/frames/scalar/larger.hpp>

/// Frames, short forms of the doors and exact motions, shared by the tests of rigid bodies.
namespace vectrix::test {

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};

using BodyState = State<Gcrf, Body>;
using BodyRate = AngularVelocity<Gcrf, Body, In<Body>>;

inline Quantity<si::time> seconds(double t) {
  return t * si::second;
}

inline Inertia<Body> tensor(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0,
                            double yz = 0.0) {
  const auto unit = si::kilogram_square_metre;
  return inertia_from_tensor(in<Body>, xx * unit, yy * unit, zz * unit, vectrix::xy(xy * unit),
                             vectrix::xz(xz * unit), vectrix::yz(yz * unit));
}

inline Vector<Body, si::torque> torque_body(double x, double y, double z) {
  return vector<si::torque>(in<Body>, Eigen::Vector3d(x, y, z));
}

inline BodyRate rate_body(const Eigen::Vector3d& w) {
  return angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w));
}

inline Quaternion<Gcrf, Body> attitude(const Eigen::Quaterniond& q) {
  return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
}

inline BodyState state_at(double t, const Eigen::Quaterniond& q, const Eigen::Vector3d& w) {
  return {seconds(t), attitude(q), rate_body(w)};
}

/// Angle of the rotation between two attitudes, rad.
inline double angle_between(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond turn = p.conjugate() * q;
  return 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

/// The larger of the errors of attitude (rad) and rate (rad/s).
inline double error(const BodyState& found, const BodyState& exact) {
  return detail::larger(angle_between(found.q_i_from_b.eigen(), exact.q_i_from_b.eigen()),
                        (found.w_ib_b.coordinates() - exact.w_ib_b.coordinates()).norm());
}

/// A torque-free body with J = diag(a, a, c): h is fixed in space, and the body turns about it at |h| / a and
/// about its own axis at n (1 - c/a), so that q_b^i(t) = exp(t h^i / a) q_b^i(0) exp(t n (1 - c/a) e3).
struct AxisymmetricBody {
  double a = 2.0;
  double c = 3.0;
  Eigen::Quaterniond q0 = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3).normalized();
  Eigen::Vector3d w0 = {0.3, -0.2, 0.5};

  BodyState exact(double t) const {
    using Eigen::AngleAxisd;
    const Eigen::Vector3d h_i = q0 * Eigen::Vector3d(a * w0.x(), a * w0.y(), c * w0.z());
    const AngleAxisd precession(t * h_i.norm() / a, h_i.normalized());
    const AngleAxisd spin(t * w0.z() * (1.0 - c / a), Eigen::Vector3d::UnitZ());
    const AngleAxisd nutation(t * w0.z() * (c - a) / a, Eigen::Vector3d::UnitZ());
    return state_at(t, (precession * q0 * spin).normalized(), nutation * w0);
  }
};

/// Expects that the text of an exception contains `text`.
inline void expect_said(const std::exception& error, const std::string& text) {
  EXPECT_TRUE(std::string{error.what()}.find(text) != std::string::npos)
      << "the text is \"" << error.what() << "\", expected in it \"" << text << '"';
}

template <class Action> void expect_bad_input(const Action& action, const std::string& text) {
  try {
    action();
    ADD_FAILURE() << "no BadInput; expected \"" << text << '"';
  } catch (const BadInput& error) {
    expect_said(error, text);
  }
}

}  // namespace vectrix::test
