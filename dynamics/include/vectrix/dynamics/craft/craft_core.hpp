#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

/// A mount c on a body b: X_c^b in plain numbers.
struct PlainMount {
  multibody::Square<double> R_b_from_c;
  multibody::Column<double> r_bc_b;
};

/// What a typed spacecraft is when its names are lost: the same tree as that of a NamedSpacecraft of the
/// same parts.
struct CraftCore {
  PlainSpacecraft plain;
  multibody::Tree<double> tree;
  std::vector<std::string> component_names;
  std::vector<PlainMount> mounts;
};

/// Throws BadInput as NamedSpacecraft does, with "Spacecraft" before the message.
VECTRIX_EXPORT std::shared_ptr<const CraftCore> make_craft_core(PlainSpacecraft plain,
                                                                std::vector<PlainMount> mounts);

/// q of a rotation matrix, scalar first.
VECTRIX_EXPORT std::vector<double> quaternion_numbers(const Eigen::Matrix3d& R);

/// The positions of a ball or free joint, from q of R_b^p, scalar first, and r_pb^p to what the engine counts
/// from the mount.
VECTRIX_EXPORT std::vector<double> from_mount(const PlainBody& body, std::vector<double> positions);

/// Throws BadInput with the name of a number that is not finite.
VECTRIX_EXPORT void require_finite_state(const char* action, const CraftCore& core, double time,
                                         std::span<const double> y);

}  // namespace vectrix::detail
