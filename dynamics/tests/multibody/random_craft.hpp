#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <random>
#include <vector>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/multibody/hinge.hpp>
#include <vectrix/dynamics/multibody/slider.hpp>
#include <vectrix/dynamics/multibody/tree.hpp>

/// Random crafts with every kind of joint, off-axis, with rotors and modes, for the tests of the engine.
namespace vectrix_test {

namespace mb = vectrix::multibody;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using vectrix::JointKind;
using vectrix::detail::eigen;

/// A body as a user describes it; J about the centre c, in the axes of the body.
struct Described {
  JointKind joint;
  int parent;  // 0: the hub
  Matrix3d R_p_from_b;
  Vector3d axis_1, axis_2, r_pb_p;
  double m;
  Vector3d c;
  Matrix3d J;
};
struct DescribedCraft {
  Described hub;
  std::vector<Described> bodies;
  std::vector<mb::Rotor<double>> rotors;  // numbered by described body
  std::vector<mb::Mode<double>> modes;
};

class RandomCraft {
 public:
  explicit RandomCraft(unsigned long seed) : random_(seed) {}

  double normal() { return normal_(random_); }
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  Vector3d triple() { return {normal(), normal(), normal()}; }
  Matrix3d rotation() {
    return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().toRotationMatrix();
  }

  Described body(int parent, JointKind joint, double scale) {
    const double m = scale * between(0.3, 3.0);
    const Vector3d half(between(0.1, 1.0), between(0.1, 1.0), between(0.1, 1.0));
    const Vector3d squares = half.cwiseAbs2();
    const Vector3d moments = m / 3.0 * (Vector3d::Constant(squares.sum()) - squares);  // of a box
    const Matrix3d axes = rotation();
    const Vector3d axis = triple().normalized();
    return {joint,
            parent,
            rotation(),
            axis,
            (axis + 0.8 * triple().normalized()).normalized(),
            triple(),
            m,
            0.3 * triple(),
            axes * moments.asDiagonal() * axes.transpose()};
  }

  DescribedCraft craft(int bodies) {
    DescribedCraft craft{body(0, JointKind::free, 10.0), {}, {}, {}};
    for (int i = 0; i < bodies; ++i) craft.bodies.push_back(body(below(i + 1), JointKind(below(6)), 1.0));
    for (int i = 0; i < 3; ++i) {
      const int at = below(bodies + 1);
      const Described& b = at == 0 ? craft.hub : craft.bodies[std::size_t(at) - 1];
      const Matrix3d inverse = b.J.inverse();
      // About the centre, d of mass 1 takes the share d^T M^-1 d: three rotors and three modes at most 9/10.
      const Vector3d n = triple().normalized();
      craft.rotors.push_back({at, {n.x(), n.y(), n.z()}, 0.2 / inverse.trace()});
      Vector3d r = 0.02 * triple(), t = 0.1 * triple();
      const double scale = std::sqrt(0.1 / (r.dot(inverse * r) + t.squaredNorm() / b.m));
      t *= scale;
      r = scale * r + b.c.cross(t);
      craft.modes.push_back(
          {at, {r.x(), r.y(), r.z()}, {t.x(), t.y(), t.z()}, between(0.5, 3.0), between(0.0, 0.1)});
    }
    return craft;
  }

  std::vector<double> state(const mb::Tree<double>& tree) {
    std::vector<double> y(tree.layout().size());
    for (double& number : y) number = normal();
    // The inertia of a body does not depend on its modes, its first moment does: small deflections leave its
    // inertia about the centre positive.
    for (std::size_t i = tree.layout().modes_begin(); i < y.size(); ++i) y[i] *= 0.01;
    return y;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

template <class S> mb::Column<S> plain_column(const Vector3d& v) {
  return {S(v.x()), S(v.y()), S(v.z())};
}
template <class S> mb::Square<S> plain_square(const Matrix3d& m) {
  return {plain_column<S>(Vector3d(m.col(0))), plain_column<S>(Vector3d(m.col(1))),
          plain_column<S>(Vector3d(m.col(2)))};
}
template <class S> mb::Mass<S> plain_mass(const Described& b) {
  const Matrix3d J = b.J + b.m * (b.c.squaredNorm() * Matrix3d::Identity() - b.c * b.c.transpose());
  return {S(b.m),
          plain_column<S>(b.m * b.c),
          {S(J(0, 0)), S(J(1, 1)), S(J(2, 2)), S(J(0, 1)), S(J(0, 2)), S(J(1, 2))}};
}

/// The numbers of the tree, and the number in it of each described body: a gimbal has a ring before it.
template <class S> struct Lowered {
  mb::TreeNumbers<S> numbers;
  std::vector<int> number;
};

template <class S> Lowered<S> lowered(const DescribedCraft& craft, mb::HubMotion motion) {
  Lowered<S> made{{motion, plain_mass<S>(craft.hub), {}, {}, {}}, {0}};
  for (const Described& b : craft.bodies) {
    const int parent = made.number[std::size_t(b.parent)];
    const mb::Mass<S> mass = plain_mass<S>(b);
    const mb::Square<S> R = plain_square<S>(b.R_p_from_b);
    const mb::Column<S> r = plain_column<S>(b.r_pb_p), n = plain_column<S>(b.axis_1);
    auto& links = made.numbers.links;
    switch (b.joint) {
      case JointKind::hinge:
        links.push_back({parent, mb::hinge(R, n, r), mass});
        break;
      case JointKind::slider:
        links.push_back({parent, mb::slider(R, n, r), mass});
        break;
      case JointKind::gimbal:
        mb::add_gimbal(made.numbers, parent, R, n, plain_column<S>(b.axis_2), r, mass);
        break;
      case JointKind::ball:
        links.push_back({parent, mb::joint(mb::Kind::ball, R, r), mass});
        break;
      case JointKind::free:
        links.push_back({parent, mb::joint(mb::Kind::free, R, r), mass});
        break;
      case JointKind::fixed:
        links.push_back({parent, mb::joint(mb::Kind::fixed, R, r), mass});
        break;
    }
    made.number.push_back(static_cast<int>(links.size()));
  }
  const auto column = [](const mb::Column<double>& v) { return plain_column<S>(eigen(v)); };
  for (const auto& rotor : craft.rotors)
    made.numbers.rotors.push_back(
        {made.number[std::size_t(rotor.body)], column(rotor.axis), S(rotor.inertia)});
  for (const auto& mode : craft.modes)
    made.numbers.modes.push_back({made.number[std::size_t(mode.body)], column(mode.rotation),
                                  column(mode.translation), S(mode.frequency), S(mode.damping_ratio)});
  return made;
}

}  // namespace vectrix_test
