#include <vectrix/dynamics/craft/plain_parts.hpp>

#include <utility>

namespace vectrix::detail {

PlainSpacecraft plain_hub(std::string inertial, std::string name, HubMotion motion, const MassNumbers& mass) {
  return {std::move(inertial), std::move(name), motion, mass.mass, mass.r_bc_b, mass.J_c_b, {}, {}, {}};
}

PlainSpacecraft plain_hub(NameFunction inertial, NameFunction name, HubMotion motion,
                          const MassNumbers& mass) {
  return plain_hub(inertial(), name(), motion, mass);
}
PlainBody plain_body(std::string name, std::string parent, JointKind joint, const Eigen::Matrix3d& R_p_from_b,
                     const Eigen::Vector3d& r_pb_p, const std::vector<Eigen::Vector3d>& axes_b,
                     const MassNumbers& mass) {
  return {std::move(name), std::move(parent), joint,       axes_b,    R_p_from_b,
          r_pb_p,          mass.mass,         mass.r_bc_b, mass.J_c_b};
}
PlainBody plain_body(NameFunction name, NameFunction parent, JointKind joint,
                     const Eigen::Matrix3d& R_p_from_b, const Eigen::Vector3d& r_pb_p,
                     const std::vector<Eigen::Vector3d>& axes_b, const MassNumbers& mass) {
  return plain_body(name(), parent(), joint, R_p_from_b, r_pb_p, axes_b, mass);
}

}  // namespace vectrix::detail
