#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include <vectrix/dynamics/craft/named_body.hpp>
#include <vectrix/dynamics/craft/named_motion.hpp>
#include <vectrix/dynamics/craft/tolerances.hpp>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/kinematics/named/quaternion.hpp>
#include <vectrix/kinematics/named/transform_doors.hpp>

namespace vectrix {

/// A spacecraft whose bodies, joints, rotors and modes have their names at run time, for example from a file:
/// a tree of any number of bodies. Its equations of motion are those of multibody::Tree; the state is
///     [ q_h^i 4 | w_ih^h 3 | r_ih^i 3 | v_ih|i^i 3 | joints' positions | joints' speeds | rotors | eta |
///     eta' ]
/// q scalar first, of any norm; rad/s, m, m/s; r and v of the hub's origin, without both if the hub is only
/// turning; the joints in the order of plain().bodies, parents first, each as JointKind says; the speeds of
/// the rotors relative to their bodies, rad/s; the modes, kg^1/2 m and kg^1/2 m/s. Where the typed form would
/// not compile, it throws BadInput with the names. Immutable and cheap to copy; threads may share it.
class VECTRIX_EXPORT NamedSpacecraft {
 public:
  /// Throws BadInput with the name of the part: a mass or an inertia that no body has, or that is below 1e-90
  /// or above 1e90 kg, kg m^2; an axis that is not a unit vector; a number that is not finite; a name that is
  /// empty, twice used or unknown; bodies that hang on each other in a loop; a rotor with more inertia than
  /// its body; modes in which more mass takes part than their body has; a joint about which its body, without
  /// what hangs on it, has no inertia.
  explicit NamedSpacecraft(const PlainSpacecraft& plain);
  NamedSpacecraft(const NamedHub& hub, const std::vector<NamedBody>& bodies,
                  const std::vector<NamedRotor>& rotors = {}, const std::vector<NamedMode>& modes = {});

  /// As it was given, the bodies in the order of the state.
  [[nodiscard]] const PlainSpacecraft& plain() const&;
  [[nodiscard]] PlainSpacecraft plain() &&;

  /// The frame of a body, or the inertial one. It belongs to this craft and its copies. Throws BadInput with
  /// the nearest name if there is none.
  [[nodiscard]] NamedFrame frame(std::string_view name) const;
  [[nodiscard]] NamedFrame hub() const;
  [[nodiscard]] NamedFrame inertial() const;

  /// The state from the motion of the hub, and the starts of all joints, rotors and modes: none is zero by
  /// default. Throws BadInput if one is missing, twice given, of another kind, or not finite.
  [[nodiscard]] NamedState state(const NamedMovingTransform& X_i_from_hub,
                                 const std::vector<NamedStart>& starts) const;
  [[nodiscard]] NamedState state(const NamedMovingDcm& R_i_from_hub,
                                 const std::vector<NamedStart>& starts) const;
  /// How many numbers a state has.
  [[nodiscard]] std::size_t state_size() const;
  /// Claims that the numbers are a state. Throws BadInput if their count is wrong, one is not finite, or a
  /// quaternion is zero; any other norm is accepted.
  [[nodiscard]] NamedState state(std::span<const double> numbers) const;

  /// The state at a time with its accelerations and what its joints transmit. Throws BadInput if a result is
  /// not finite.
  [[nodiscard]] NamedMotion motion(const NamedState& state, const Quantity<si::time>& time,
                                   const NamedLoads& loads = {},
                                   const std::vector<NamedHeld>& held = {}) const;

  /// The state after an impulse that stops these joints and rotors, as a latch or a brake does: no place
  /// changes, all speeds may. Momentum and angular momentum are kept, energy is lost; what is held keeps its
  /// speed in the impulse. Then a run goes on from this state, with the joint locked(). Throws BadInput for a
  /// name that the craft has not.
  [[nodiscard]] NamedState stopped(const NamedState& state, const std::vector<std::string>& names,
                                   const std::vector<NamedHeld>& held = {}) const;

  /// The problem from a state at the time `start` to `end`: right-hand side, initial state, tolerances and
  /// names of components. The method and the rest are the caller's; the default is that of ode::Problem. A
  /// result is a state again:
  ///     craft.state(ode::solve(problem).at(t))
  /// The problem keeps what it works with: two threads must not solve the same one, but copies of it.
  [[nodiscard]] ode::Problem problem(const NamedState& state, const Quantity<si::time>& start,
                                     const Quantity<si::time>& end, double relative_tolerance,
                                     const CraftTolerances& absolute, const NamedLoads& loads = {},
                                     const std::vector<NamedHeld>& held = {}) const;

 private:
  std::shared_ptr<const detail::NamedCraftCore> core_;
};

}  // namespace vectrix
