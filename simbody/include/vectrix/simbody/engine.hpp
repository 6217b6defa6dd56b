#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include <vectrix/frames/export.hpp>

/// A tree of bodies in Simbody, behind plain types, in SI units; matrices by rows. This header is C++17, as
/// Simbody's are.
namespace vectrix::detail {

enum class SimbodyJoint { hinge, slider, ball, free, fixed };

/// A link of the tree: a body b on its parent p (0: the hub, else the link before it in the list with this
/// number, from 1 on). A gimbal is two hinges with a ring between them, whose mass is 0. The name is for
/// messages.
struct SimbodyLink {
  std::string name;
  SimbodyJoint joint;
  int parent;
  std::array<double, 9> R_p_from_b;
  std::array<double, 3> r_pb_p, axis_b;
  double mass;
  std::array<double, 3> centre_b;
  std::array<double, 9> inertia_c_b;  ///< about the centre
};
/// A balanced rotor, whose mass is in its body's.
struct SimbodyRotor {
  int body;
  std::array<double, 3> axis_b;
  double inertia;
};
/// A mode of an appendage of a body, as multibody::Mode.
struct SimbodyMode {
  int body;
  std::array<double, 3> rotation_b, translation_b;
  double frequency, damping_ratio;
};
struct SimbodyCraft {
  std::string name_of_hub;
  bool hub_has_place;
  double mass;
  std::array<double, 3> centre_b;
  std::array<double, 9> inertia_c_b;
  std::vector<SimbodyLink> links;
  std::vector<SimbodyRotor> rotors;
  std::vector<SimbodyMode> modes;
};

/// What acts on a craft. Forces are in the hub's axes, on each link through its origin, the hub first;
/// torques are about that origin; all others as in multibody::Work.
struct SimbodyLoads {
  std::vector<std::array<double, 3>> forces, torques;
  std::vector<double> efforts, motors, modal;
  std::array<double, 3> field_i;  ///< a uniform acceleration
  std::vector<char> locked_links, driven_links, locked_rotors, driven_rotors;
  std::vector<double> given, given_spins;  ///< accelerations, by speed, of what is driven
};

/// Simbody's explicit Runge-Kutta pairs. Merson, of order 4, is more accurate for the same accuracy;
/// Feldberg, of order 5, is cheaper.
enum class SimbodyPair { merson, feldberg };

/// The tree, its right-hand side and its integrator. The numbers of a state are those of multibody::Tree.
/// Simbody 3.7 refuses an inertia without mass, so a rotor is a wheel on a pin at the centre of mass of its
/// body, with a twentieth of its mass and the inertia of a disc, both taken out of the body. What is locked
/// at the start of a segment is so by Simbody's own lock. A driven joint, and one that is locked later, has
/// the effort that gives it its acceleration, found with Simbody's mass matrix. Simbody has no modes: the
/// coordinate of one is that of a mass of 1 kg on a slider of its own, and the appendage acts on its body
/// with the wrench that it needs, found together with those efforts. One for each thread. What the loads
/// throw passes through, and so do Simbody's exceptions.
class VECTRIX_EXPORT SimbodyEngine {
 public:
  using Loads = std::function<void(double t, const double* y, SimbodyLoads& loads)>;
  /// Simbody integrates in units of `time_scale`, s.
  SimbodyEngine(const SimbodyCraft& craft, SimbodyPair pair, double accuracy, double time_scale, Loads loads);
  ~SimbodyEngine();
  SimbodyEngine(const SimbodyEngine&) = delete;
  SimbodyEngine& operator=(const SimbodyEngine&) = delete;

  /// The derivative of the state.
  void rates(double t, const double* y, double* ydot);
  /// What the joint of each link transmits to it, about its origin, in inertial axes, at the last rates().
  struct Transmitted {
    std::array<double, 3> force_i, torque_i;
  };
  std::vector<Transmitted> reactions() const;

  /// Begins at (t, y). Steps end at `stop`.
  void start(double t, const double* y, double stop, double longest);
  /// One step of Simbody's own. Returns the time reached, `stop` if it is the end.
  double step();
  void state(double* y) const;
  void rate(double* ydot) const;

  std::size_t evaluations() const;
  std::size_t error_test_failures() const;

 private:
  struct System;
  class Acting;
  std::unique_ptr<System> system_;
};

}  // namespace vectrix::detail
