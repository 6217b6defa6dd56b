#pragma once

#include <vector>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "short_units.hpp"
#include "testing/attitudes.hpp"

/// A craft of five kinds of joints, with names, and a state of it.
namespace vectrix_test::named_five {

using namespace vectrix;
using namespace vectrix_test::short_units;
using Eigen::Matrix3d, Eigen::Vector3d;

/// A hub with a hinged boom, on it a wheel with an antenna on two axes, a mass on a slider and a gyro.
inline PlainSpacecraft five() {
  const Matrix3d unit = Matrix3d::Identity();
  const auto body = [&](const char* name, const char* parent, JointKind kind, std::vector<Vector3d> axes) {
    return PlainBody{name, parent, kind, axes, unit, {1.0, 0.2, 0.0}, 2.0, {0.1, 0.0, 0.3}, 0.5 * unit};
  };
  return {
      "gcrf",
      "hub",
      HubMotion::free,
      100.0,
      Vector3d::Zero(),
      50.0 * unit,
      {body("antenna", "boom", JointKind::gimbal, {Vector3d::UnitX(), Vector3d::UnitY()}),
       body("boom", "hub", JointKind::hinge, {Vector3d::UnitZ()}),
       body("mass", "hub", JointKind::slider, {Vector3d::UnitX()}), body("gyro", "boom", JointKind::ball, {}),
       body("box", "mass", JointKind::fixed, {}), body("probe", "box", JointKind::free, {})},
      {{"wheel", "boom", Vector3d::UnitY(), 0.1}},
      {{"first", "antenna", {0.1, 0.0, 0.0}, {0.0, 0.2, 0.0}, 3.0, 0.01}}};
}

inline NamedMovingTransform at_origin(NamedFrame a, NamedFrame b, const Matrix3d& R,
                                      const Vector3d& r = Vector3d::Zero()) {
  return {
      moving_dcm(dcm(To(a), From(b), R),
                 angular_velocity(Of(b), RelativeTo(a),
                                  vector<si::angular_velocity>(In(b), Vector3d(0.1, -0.2, 0.3)))),
      displacement(Of(b), RelativeTo(a), vector<si::length>(In(a), r)),
      velocity(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::velocity>(In(a), Vector3d(0.4, 0.5, -0.6)))};
}

inline std::vector<NamedStart> starts_of_five(const NamedSpacecraft& craft, const Matrix3d& R) {
  const NamedFrame boom = craft.frame("boom"), gyro = craft.frame("gyro"), box = craft.frame("box"),
                   probe = craft.frame("probe");
  return {starts("antenna", 0.1 * rad, 0.2 * rad_s, 0.3 * rad, 0.4 * rad_s),
          starts("boom", 0.5 * rad, 0.6 * rad_s),
          starts("mass", 0.7 * si::metre, 0.8 * m_s),
          starts(at_origin(boom, gyro, R).turning()),
          starts(at_origin(box, probe, R, {3.0, 2.0, 1.0})),
          spins("wheel", 9.0 * rad_s),
          deflects("first", 0.01, -0.02)};
}
inline NamedState state_of_five(const NamedSpacecraft& craft, const Matrix3d& R) {
  return craft.state(at_origin(craft.inertial(), craft.hub(), R, {7e6, 0.0, 0.0}), starts_of_five(craft, R));
}

}  // namespace vectrix_test::named_five
