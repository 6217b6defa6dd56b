#include <vectrix/dynamics/craft/plain_parts.hpp>

#include <utility>

namespace vectrix::detail {

PlainSpacecraft plain_hub(std::string inertial, std::string name, HubMotion motion, const MassNumbers& mass) {
  return {std::move(inertial), std::move(name), motion, mass.mass, mass.r_bc_b, mass.J_c_b, {}, {}, {}};
}

PlainBody plain_body(std::string name, std::string parent, JointKind joint, const Eigen::Matrix3d& R_p_from_b,
                     const Eigen::Vector3d& r_pb_p, const std::vector<Eigen::Vector3d>& axes_b,
                     const MassNumbers& mass) {
  return {std::move(name), std::move(parent), joint,       axes_b,    R_p_from_b,
          r_pb_p,          mass.mass,         mass.r_bc_b, mass.J_c_b};
}

}  // namespace vectrix::detail
