#pragma once

#include <cmath>
#include <vectrix/kinematics.hpp>

namespace vectrix_test {

/// The classical coning motion: b is turned from a by the constant angle `cone` about an axis that rotates in
/// the y-z plane of a at the rate `speed`. In closed form, with c = cone, s = speed:
///     q_b^a = (cos c/2, 0, sin c/2 cos st, sin c/2 sin st)
///     w_ab^b = s (-2 sin^2 c/2, -sin c sin st, sin c cos st)
/// b returns to the same attitude after each turn of the axis, but the integral of w does not return.
template <vectrix::Frame A, vectrix::Frame B> struct ConingMotion {
  double cone;
  double speed;

  vectrix::Quaternion<A, B> attitude(double t) const {
    const double s = std::sin(cone / 2), c = std::cos(cone / 2);
    return vectrix::quaternion_scalar_first(vectrix::to<A>, vectrix::from<B>, c, 0.0, s * std::cos(speed * t),
                                            s * std::sin(speed * t));
  }
  vectrix::AngularVelocity<A, B, vectrix::In<B>> rate(double t) const {
    using namespace vectrix;
    const double s = std::sin(cone / 2);
    return angular_velocity(
        of<B>, relative_to<A>,
        vector<si::angular_velocity>(
            in<B>, speed * Eigen::Vector3d(-2 * s * s, -std::sin(cone) * std::sin(speed * t),
                                           std::sin(cone) * std::cos(speed * t))));
  }
  /// The integral of the rate from t to t + h.
  vectrix::AngleIncrement<A, B> count(double t, double h) const {
    using namespace vectrix;
    const double s = std::sin(cone / 2);
    // Differences of cosines and of sines, written as products.
    const double chord = 2 * std::sin(cone) * std::sin(speed * h / 2);
    const double middle = speed * (t + h / 2);
    return angle_increment(
        of<B>, relative_to<A>,
        vector<si::angle>(in<B>, Eigen::Vector3d(-2 * s * s * speed * h, -chord * std::sin(middle),
                                                 chord * std::cos(middle))));
  }
  /// The rotation vector of the turn from t to t + h.
  Eigen::Vector3d increment(double t, double h) const {
    using namespace vectrix;
    return log(inverse(before(attitude(t))) * attitude(t + h)).coordinates();
  }
};

}  // namespace vectrix_test
