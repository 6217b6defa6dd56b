#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/mass/mass_properties.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

/// The mass properties of a body b, from its origin and in its axes.
struct MassNumbers {
  double mass;
  Eigen::Vector3d r_bc_b;
  Eigen::Matrix3d J_c_b;
};
template <class Whole, class B> MassNumbers mass_numbers(const MassProperties<Whole, B, In<B>>& mass) {
  return {mass.mass().value(), mass.centre().coordinates(), mass.inertia().matrix()};
}

/// A craft of its hub alone.
VECTRIX_EXPORT PlainSpacecraft plain_hub(std::string inertial, std::string name, HubMotion motion,
                                         const MassNumbers& mass);
VECTRIX_EXPORT PlainSpacecraft plain_hub(NameFunction inertial, NameFunction name, HubMotion motion,
                                         const MassNumbers& mass);
VECTRIX_EXPORT PlainBody plain_body(std::string name, std::string parent, JointKind joint,
                                    const Eigen::Matrix3d& R_p_from_b, const Eigen::Vector3d& r_pb_p,
                                    const std::vector<Eigen::Vector3d>& axes_b, const MassNumbers& mass);
VECTRIX_EXPORT PlainBody plain_body(NameFunction name, NameFunction parent, JointKind joint,
                                    const Eigen::Matrix3d& R_p_from_b, const Eigen::Vector3d& r_pb_p,
                                    const std::vector<Eigen::Vector3d>& axes_b, const MassNumbers& mass);

}  // namespace vectrix::detail
