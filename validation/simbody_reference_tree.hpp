#pragma once

#include <memory>
#include <vector>

#include "simbody_reference.hpp"

/// A tree of bodies in Simbody, behind plain types, at one state. Matrices are row-major; SI units.
namespace vectrix::validation {

enum class SimbodyJoint { hinge, slider, gimbal, ball, free, fixed };

/// A body b on its parent p (-1: the hub). Where a joint has two axes, they are orthogonal.
struct SimbodyTreeBody {
  SimbodyJoint joint;
  int parent;
  Matrix3 R_p_from_b;
  Vector3 r_pb_p, axis_1_b, axis_2_b;
  double mass_kg;
  Vector3 centre_b;
  Matrix3 inertia_c_b;  ///< about the centre
  bool locked;          ///< all its accelerations are zero
  double effort;        ///< of a hinge, N m, or a slider, N
};
/// A balanced rotor, whose mass is in its body's; torque of the body on it.
struct SimbodyTreeRotor {
  int body;
  Vector3 axis_b;
  double inertia;
  double torque_nm;
};
struct SimbodyTreeCraft {
  double mass_kg;
  Vector3 centre_b;
  Matrix3 inertia_c_b;
  std::vector<SimbodyTreeBody> bodies;
  std::vector<SimbodyTreeRotor> rotors;
  Vector3 field_i;                         ///< a uniform acceleration, m/s^2
  std::vector<Vector3> force_i, torque_i;  ///< on each body about its origin, the hub first
};

/// Simbody 3.7 refuses an inertia without mass, so a rotor is a wheel on a pin at the centre of its body,
/// with a twentieth of its mass and the inertia of a disc, both taken out of the body.
class SimbodyTree {
 public:
  explicit SimbodyTree(const SimbodyTreeCraft& craft);
  ~SimbodyTree();
  SimbodyTree(const SimbodyTree&) = delete;

  /// The state in the order of multibody::Tree, without modes:
  ///     [ q_i_from_h 4 | w_ih_h 3 | r_i 3 | v_i 3 | joint positions | joint speeds | rotor speeds ]
  /// Attitudes are scalar first. Computes the accelerations.
  void evaluate(const double* y);

  /// After evaluate(): alpha_ih in the hub's axes, a_i, then the rates of the speeds of joints and rotors.
  std::vector<double> rates() const;
  /// What the joint of each body transmits to it, about its origin, in inertial axes.
  struct Transmitted {
    Vector3 force_i, torque_i;
  };
  std::vector<Transmitted> reactions() const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace vectrix::validation
