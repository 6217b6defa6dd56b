#pragma once

#include <cstddef>
#include <vector>
#include <vectrix/dynamics/multibody/internals.hpp>
#include <vectrix/dynamics/multibody/joint.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::multibody {

/// The motion of the hub. `free`: attitude and position are states. `turning`: the attitude alone; the craft
/// is as free, but the state does not say where it is. Nothing in the mechanics depends on that.
enum class HubMotion { free, turning };

/// A body with the joint on which it hangs: on the hub, 0, or on link 1, 2, ... before it.
template <class S> struct Link {
  int parent;
  Joint<S> joint;
  Mass<S> mass;
};

template <class S> struct TreeNumbers {
  HubMotion hub_motion;
  Mass<S> hub;
  std::vector<Link<S>> links;
  std::vector<Rotor<S>> rotors;
  std::vector<Mode<S>> modes;
};

/// Adds two hinges with a massless ring between them, about axis_1, fixed in the parent, and axis_2, fixed in
/// the body; at zero both are in the body's axes. Returns the number of the ring; the body has the next.
template <class S>
int add_gimbal(TreeNumbers<S>& tree, int parent, const Square<S>& R_p_from_b, const Column<S>& axis_1,
               const Column<S>& axis_2, const Column<S>& r_pb_p, const Mass<S>& mass);

/// Where each number of the state is:
///     [ q_i_from_h 4 | w_ih_h 3 | r_i 3 | v_i 3 | joint positions | joint speeds | rotor speeds | eta | eta'
///     ]
/// q scalar first, of any norm; w, rad/s; r_i, m, and v_i, m/s, of the hub's origin in inertial axes, absent
/// if the hub is only turning. Each link has the numbers that the header of its kind gives, rad and m, rad/s
/// and m/s, in the order of the links; rotors, rad/s, relative to their bodies; eta, kg^1/2 m.
struct TreeLayout {
  std::size_t hub, positions, speeds, rotors, modes;
  std::vector<std::size_t> position_at, speed_at;  ///< by link, from the start of the state

  [[nodiscard]] std::size_t speeds_begin() const { return hub + positions; }
  [[nodiscard]] std::size_t rotors_begin() const { return hub + positions + speeds; }
  [[nodiscard]] std::size_t modes_begin() const { return rotors_begin() + rotors; }
  [[nodiscard]] std::size_t size() const { return modes_begin() + 2 * modes; }
};

/// Whether the acceleration of a joint or rotor is given: that of a locked one, and of one that sticks by
/// friction, is zero, that of a driven one is not.
enum class Hold : char { none, sticks, locked, driven };

/// A tree at one instant, and what acts on it. One for each thread; made by Tree::work().
template <class S> struct Work {
  // Set between place() and solve(); place() sets them to zero.
  std::vector<S> efforts;         ///< by speed: N m, N
  std::vector<S> motors;          ///< torques on the rotors, N m
  std::vector<S> modal;           ///< forces on the modes, Q
  std::vector<Hold> held;         ///< by link: those that have the given u', whatever their efforts
  std::vector<S> given;           ///< by speed: u'
  std::vector<Hold> held_rotors;  ///< those that have the given O', whatever their motors do
  std::vector<S> given_spins;     ///< by rotor: O'
  Column<S> field;                ///< a uniform acceleration, in inertial axes, m/s^2

  Square<S> R_i_from_h;
  Square<S> unit;  ///< R of the hub in its own axes
  Column<S> w;     ///< w_ih
  Articulated<S> hub;
  Accelerations<S> hub_acceleration;  ///< less the field
  std::vector<Moving<S>> links;
  std::vector<Column<S>> axes;  ///< of the rotors
  std::vector<MovingMode<S>> modes;
};

/// Momentum, kg m/s, and angular momentum about a point, N m s, in inertial axes; kinetic energy and that of
/// the modes' springs, J. Springs of joints are efforts: their energy is the user's.
template <class S> struct Conserved {
  Column<S> momentum, angular_momentum;
  S energy;
};

/// A craft of bodies that hang on each other as a tree, by the algorithm of articulated bodies: the cost is
/// proportional to the number of bodies. All vectors are in the axes of the hub as it stands, each body about
/// its own joint, and only the hub's rate occurs, not its velocity.
///     place   base to tip    where each body is, and the wrench that it needs at zero joint accelerations
///     (loads)                 add_wrench(), efforts, motors, modal, field
///     solve   tip to base    takes each joint's freedoms out of what hangs on it; the hub's accelerations;
///             base to tip    the joints' accelerations
/// Immutable; threads may share it. It allocates nothing after work().
template <class S> class VECTRIX_EXPORT Tree {
 public:
  /// Throws BadInput if a parent does not come before its body, or a rotor or a mode has no body.
  explicit Tree(TreeNumbers<S> numbers);

  [[nodiscard]] const TreeNumbers<S>& numbers() const { return numbers_; }
  [[nodiscard]] const TreeLayout& layout() const { return layout_; }
  [[nodiscard]] Work<S> work() const;

  /// Places are from the hub's origin, and its velocity does not occur: orbits cost no digits.
  void place(const S* y, Work<S>& k) const;
  /// A force, and a torque about the origin of the body, in the hub's axes.
  void add_wrench(int body, const Column<S>& force, const Column<S>& torque, Work<S>& k) const;
  void solve(const S* y, S* ydot, Work<S>& k) const;

  // After place():
  /// R_b^h, and the position of b's origin from the hub's, in the hub's axes.
  [[nodiscard]] const Square<S>& rotation(int body, const Work<S>& k) const;
  [[nodiscard]] Column<S> position(int body, const Work<S>& k) const;
  [[nodiscard]] const Column<S>& angular_velocity(int body, const Work<S>& k) const;
  /// The velocity of b's origin relative to the hub's, observed from the inertial frame, in the hub's axes:
  /// no digits go to the speed of the hub.
  [[nodiscard]] Column<S> velocity_beyond_hub(int body, const S* y, const Work<S>& k) const;
  /// The velocity of b's origin in the hub's axes. Of a turning hub: relative to the centre of mass.
  [[nodiscard]] Column<S> velocity(int body, const S* y, const Work<S>& k) const;
  /// About the point with the inertial coordinates `about`; of a turning hub, all relative to the centre of
  /// mass, and the point does not matter.
  [[nodiscard]] Conserved<S> conserved(const S* y, const Column<S>& about, const Work<S>& k) const;

  // After solve():
  /// alpha_ib and the inertial acceleration of b's origin, in the hub's axes.
  [[nodiscard]] Accelerations<S> accelerations(int body, const Work<S>& k) const;
  /// What the joint transmits to the body that hangs on it, in the hub's axes. The effort is part of it.
  [[nodiscard]] Transmitted<S> reaction(int body, const Work<S>& k) const;
  /// What a lock or a drive adds to the efforts of a hinge, N m, or slider, N, so that it has the given
  /// acceleration: zero but for rounding if the joint is not held.
  [[nodiscard]] S holding_effort(int body, const Work<S>& k) const;
  /// What a lock or a drive adds to the motor of a rotor, N m: zero if it is not held.
  [[nodiscard]] S holding_torque(std::size_t rotor, const Work<S>& k) const;

 private:
  [[gnu::always_inline]] inline void place_hub(const S* y, Work<S>& k) const;
  void give_hub_inertia(Work<S>& k) const;
  void place_link(std::size_t i, const S* y, Work<S>& k) const;
  void inward(std::size_t i, Work<S>& k) const;
  void outward(std::size_t i, S* ydot, Work<S>& k) const;
  [[gnu::always_inline]] inline void add_internals(const S* y, Work<S>& k) const;
  [[nodiscard, gnu::always_inline]] inline Accelerations<S> solve_hub(bool rigid, const Work<S>& k) const;
  [[nodiscard]] Articulated<S>& inertia(int body, Work<S>& k) const;
  [[nodiscard]] Accelerations<S> less_field(int body, const Work<S>& k) const;
  [[nodiscard]] Column<S> hub_velocity(const S* y, const Work<S>& k) const;
  [[nodiscard]] Conserved<S> sum_over_bodies(const S* y, const Column<S>& hub_velocity,
                                             const Work<S>& k) const;

  TreeNumbers<S> numbers_;
  TreeLayout layout_;
  std::vector<Mass<S>> less_rotors_;  // by body: J less J_s n n^T of its rotors
  bool rigid_;                        // no joints, no modes: the inverse is constant
  Column<S> centre_;
  Symmetric<S> inverse_inertia_;  // about the centre
};

extern template class Tree<double>;
extern template int add_gimbal(TreeNumbers<double>&, int, const Square<double>&, const Column<double>&,
                               const Column<double>&, const Column<double>&, const Mass<double>&);

}  // namespace vectrix::multibody
