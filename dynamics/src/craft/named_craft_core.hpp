#pragma once

#include <deque>
#include <optional>
#include <unordered_map>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/dynamics/mass/parallel_axes.hpp>

namespace vectrix::detail {

/// A NamedSpacecraft: what it is, its tree, and where each name is.
class NamedCraftCore {
 public:
  NamedCraftCore(PlainSpacecraft given, const char* form);
  NamedCraftCore(const NamedCraftCore&) = delete;

  const CraftCore& core() const { return core_; }
  const PlainSpacecraft& plain() const { return core_.plain; }
  const multibody::Tree<double>& tree() const { return core_.tree; }

  /// 0: the inertial frame; 1: the hub; then the bodies.
  NamedFrame frame(std::size_t number) const { return NamedFrame{frames_[number]}; }
  NamedFrame frame(std::string_view name) const;
  NamedFrame own(NamedFrame frame) const;
  /// The link of the tree that is this body; 0 for the hub. Throws BadInput for the inertial frame.
  int link(NamedFrame body, const char* action) const;

  struct Joint {
    const PlainBody* body;
    std::size_t link;  ///< from 0; of a gimbal its first
  };
  Joint joint(std::string_view body) const;
  std::size_t rotor(std::string_view name) const;
  std::optional<std::size_t> find_rotor(std::string_view name) const;
  std::size_t mode(std::string_view name) const;

  /// Where the position (from the start of the state) and the speed (from the first speed) of an axis are.
  std::size_t position_at(const Joint& joint, int axis) const;
  std::size_t speed_at(const Joint& joint, int axis) const;

 private:
  std::vector<int> links_;  // by body, the hub first
  CraftCore core_;
  std::deque<FrameRecord> frames_;
  std::unordered_map<std::string_view, std::size_t> numbers_;  // of the frames, by name
};

const char* name_of(JointKind kind);
/// Of a mass, kg, or an inertia, kg m^2. The equations hold products of three of them, also if one moment is
/// near moment_tolerance of the others: in this range none of them overflows or underflows.
constexpr double least_size = 1e-90, greatest_size = 1e90;
inline bool has_size(double size) {
  return size >= least_size && size <= greatest_size;
}
inline std::string sizes_of_a_craft() {
  return "; the equations take " + text(least_size) + " to " + text(greatest_size);
}
/// J about the origin, from J about the centre of mass.
inline Eigen::Matrix3d about_origin(double mass, const Eigen::Vector3d& centre, const Eigen::Matrix3d& J_c) {
  return J_c + inertia_of_point_mass<double>(mass, centre);
}
/// Checks the craft, and puts parents before the bodies that hang on them. `form` begins the messages.
PlainSpacecraft checked_craft(PlainSpacecraft craft, const char* form);

}  // namespace vectrix::detail
