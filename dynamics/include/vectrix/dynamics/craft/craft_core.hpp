#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

/// A mount c on a body b: X_c^b in plain numbers.
template <class S> struct MountNumbers {
  multibody::Square<S> R_b_from_c;
  multibody::Column<S> r_bc_b;
};
using PlainMount = MountNumbers<double>;

/// What a spacecraft is when its names are lost: the same of a Spacecraft and of a NamedSpacecraft of the
/// same parts, but for the mounts, which only the first has. In the scalar in which its motion is asked.
template <class S> struct CraftCoreIn {
  PlainSpacecraft plain;
  multibody::Tree<S> tree;
  std::vector<std::string> component_names;
  std::vector<MountNumbers<S>> mounts;
};
using CraftCore = CraftCoreIn<double>;

/// The parts of a Spacecraft, when their names are lost.
class VECTRIX_EXPORT LoweredParts {
 public:
  explicit LoweredParts(const PlainSpacecraft& hub);
  ~LoweredParts();
  LoweredParts(const LoweredParts&) = delete;
  LoweredParts& operator=(const LoweredParts&) = delete;

  void add(const PlainBody& body);
  void add(const PlainRotor& rotor);
  void add(const PlainMode& mode);
  void add(const PlainMount& mount);
  /// Throws BadInput as NamedSpacecraft does, with "Spacecraft" before the message.
  [[nodiscard]] std::shared_ptr<const CraftCore> core() const;

 private:
  PlainSpacecraft plain_;
  std::vector<PlainMount> mounts_;
};

/// q of a rotation matrix, scalar first.
VECTRIX_EXPORT std::vector<double> quaternion_numbers(const Eigen::Matrix3d& R);
/// Writes these, or the coordinates of a vector, and returns where the next number is.
VECTRIX_EXPORT double* put_numbers(double* to, const Eigen::Matrix3d& R);
VECTRIX_EXPORT double* put_numbers(double* to, const Eigen::Vector3d& v);

/// The positions of a ball or free joint, from q of R_b^p, scalar first, and r_pb^p to what the engine counts
/// from the mount.
VECTRIX_EXPORT std::vector<double> from_mount(const PlainBody& body, std::vector<double> positions);

/// The sum of the moments of inertia of all bodies, kg m^2, each with its mass as far off as its own lever
/// arms are: the order of magnitude of those of the craft.
VECTRIX_EXPORT double size_of_inertia(const PlainSpacecraft& craft);

VECTRIX_EXPORT void require_finite_time(const CraftCore& core, const char* action, double time);
/// Throws BadInput with the name of a number that is not finite, or with that of a quaternion whose square is
/// zero, infinite or without all its digits: no rotation follows from it. Any other norm is accepted. Also if
/// the craft has no inertia about an axis as it stands: point masses on a line.
VECTRIX_EXPORT void require_state(const CraftCore& core, const char* action, std::span<const double> y);
/// Throws BadInput: a joint is driven, and also locked or driven again.
[[noreturn]] VECTRIX_EXPORT void refuse_to_hold_twice(const std::string& what);
/// Places a tree in which no body needs a force: the (n, f) of its bodies are then those of the loads alone,
/// with the opposite sign.
template <class S>
void place_for_loads(const multibody::Tree<S>& tree, const S* y, multibody::Work<S>& work) {
  tree.place(y, work);
  work.hub.n = work.hub.f = multibody::zero_column<S>();
  for (auto& link : work.links) link.I.n = link.I.f = multibody::zero_column<S>();
}
/// The first of so many loads that gives what is not finite, and what, as "load 2 of 3: the motor torque on
/// Wheel is nan N m"; empty if there is none. of_load(i) places for the loads and lets load i act, counted
/// from 1; of_load(0) lets all act.
VECTRIX_EXPORT std::string first_not_finite_load(
    const PlainSpacecraft& craft, std::size_t count,
    const std::function<const multibody::Work<double>&(std::size_t)>& of_load);
/// What loads have given that is not finite, without the number of the load.
VECTRIX_EXPORT std::string not_finite_load(const PlainSpacecraft& craft, const multibody::Work<double>& work);
/// Throws BadInput with the name of a number whose derivative is not finite, and with what `why` says then.
VECTRIX_EXPORT void require_finite_rates(const CraftCore& core, const char* action, double time,
                                         std::span<const double> ydot,
                                         const std::function<std::string()>& why);

}  // namespace vectrix::detail
