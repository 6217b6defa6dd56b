#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>
#include <string>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>

namespace vectrix::validation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Draw {
 public:
  explicit Draw(unsigned long seed) : random_(seed) {}
  double normal() { return normal_(random_); }
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  Vector3d triple() { return {normal(), normal(), normal()}; }
  Matrix3d rotation() {
    return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().toRotationMatrix();
  }
  /// Of a box, about its centre, in other axes.
  Matrix3d inertia(double mass) {
    const Vector3d squares = Vector3d(between(0.1, 1.0), between(0.1, 1.0), between(0.1, 1.0)).cwiseAbs2();
    const Vector3d principal = mass / 3.0 * (Vector3d::Constant(squares.sum()) - squares);
    const Matrix3d axes = rotation(), J = axes * principal.asDiagonal() * axes.transpose();
    return 0.5 * (J + J.transpose());
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

/// `slanted`: the axes of a gimbal make 55 degrees, else a right angle.
inline PlainBody random_body(Draw& draw, int number, const std::string& parent, bool locks, bool slanted) {
  const auto joint = JointKind(draw.below(6));
  const Vector3d first = draw.triple().normalized(), across = first.cross(draw.triple()).normalized();
  const Vector3d second = slanted ? Vector3d((across + 0.7 * first).normalized()) : across;
  std::vector<Vector3d> axes;
  if (joint == JointKind::hinge || joint == JointKind::slider || joint == JointKind::gimbal)
    axes.push_back(first);
  if (joint == JointKind::gimbal) axes.push_back(second);
  const double mass = draw.between(0.3, 3.0);
  return {(locks && draw.below(3) == 0 ? "locked " : "body ") + std::to_string(number),
          parent,
          joint,
          axes,
          draw.rotation(),
          draw.triple(),
          mass,
          0.3 * draw.triple(),
          draw.inertia(mass)};
}

/// Makes the coordinates and rates of the modes at the end of a state small, as deflections are.
inline void make_small(const PlainSpacecraft& craft, std::vector<double>& state) {
  for (std::size_t i = state.size() - 2 * craft.modes.size(); i < state.size(); ++i) state[i] *= 0.1;
}

/// Two to `most` bodies with two rotors; with `locks` a third of the bodies has a name that begins with
/// "locked"; if it is `flexible` its gimbals are slanted, and it has three modes.
inline PlainSpacecraft random_craft(Draw& draw, bool locks, int most, bool flexible = false) {
  const double mass = draw.between(3.0, 30.0);
  PlainSpacecraft craft{"inertial", "hub", HubMotion::free, mass, 0.3 * draw.triple(), draw.inertia(mass), {},
                        {},         {}};
  auto& bodies = craft.bodies;
  const int count = 1 + draw.below(most - 1);
  for (int i = 1; i <= count; ++i) {
    const int parent = draw.below(i);
    bodies.push_back(random_body(
        draw, i, parent == 0 ? "hub" : bodies[static_cast<std::size_t>(parent) - 1].name, locks, flexible));
  }
  const auto inertia_at = [&](int at) -> const Matrix3d& {
    return at == 0 ? craft.J_c_h : bodies[static_cast<std::size_t>(at) - 1].J_c_b;
  };
  const auto name_at = [&](int at) {
    return at == 0 ? craft.hub : bodies[static_cast<std::size_t>(at) - 1].name;
  };
  for (int i = 0; i < 2; ++i) {
    const int at = draw.below(count + 1);
    craft.rotors.push_back({"rotor " + std::to_string(i), name_at(at), draw.triple().normalized(),
                            0.05 / inertia_at(at).inverse().trace()});
  }
  for (int i = 0; flexible && i < 3; ++i) {
    const int at = draw.below(count + 1);
    const PlainBody* body = at == 0 ? nullptr : &bodies[static_cast<std::size_t>(at) - 1];
    const Vector3d d_t = 0.2 * std::sqrt(body ? body->mass : craft.mass) * draw.triple().normalized();
    const Vector3d turning = std::sqrt(0.05 / inertia_at(at).inverse().trace()) * draw.triple().normalized();
    craft.modes.push_back({"mode " + std::to_string(i), name_at(at),
                           (body ? body->r_bc_b : craft.r_hc_h).cross(d_t) + turning, d_t,
                           draw.between(0.5, 3.0), draw.between(0.0, 0.1)});
  }
  return craft;
}

}  // namespace vectrix::validation
