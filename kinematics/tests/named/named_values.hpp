#pragma once

#include <string>
#include <vectrix/kinematics/named/dcm_doors.hpp>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

/// Values with named frames, of random numbers.
namespace values_test {

using namespace vectrix;
using namespace vectrix_test;

/// Four frames, and values that relate them.
struct Values {
  NamedGraph graph;
  NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  NamedFrame c = graph.add_frame("c", FrameMotion::moving);
  NamedFrame d = graph.add_frame("d", FrameMotion::moving);
  Eigen::Matrix3d R1 = *rotation_matrix(), R2 = *rotation_matrix();
  Eigen::Vector3d v1 = *triple(), v2 = *triple();

  NamedAngularVelocity w(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                         const Eigen::Vector3d& v) const {
    return angular_velocity(Of(of), RelativeTo(relative_to), vector<si::angular_velocity>(In(in), v));
  }
  NamedAngularAcceleration alpha(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                                 const Eigen::Vector3d& v) const {
    return angular_acceleration(Of(of), RelativeTo(relative_to), vector<si::angular_acceleration>(In(in), v));
  }
  NamedDisplacement r(NamedFrame of, NamedFrame relative_to, NamedFrame in, const Eigen::Vector3d& r) const {
    return displacement(Of(of), RelativeTo(relative_to), vector<si::length>(In(in), r));
  }
  NamedVelocity v(NamedFrame of, NamedFrame relative_to, NamedFrame observer, NamedFrame in,
                  const Eigen::Vector3d& v) const {
    return velocity(Of(of), RelativeTo(relative_to), ObservedFrom(observer), vector<si::velocity>(In(in), v));
  }
  NamedAcceleration a_of(NamedFrame of, NamedFrame relative_to, NamedFrame observer, NamedFrame in,
                         const Eigen::Vector3d& v) const {
    return acceleration(Of(of), RelativeTo(relative_to), ObservedFrom(observer),
                        vector<si::acceleration>(In(in), v));
  }
};

template <class Action> std::string refusal(const Action& action) {
  return message<BadInput>(action);
}
}  // namespace values_test
