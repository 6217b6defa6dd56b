#include <vectrix/dynamics/craft/craft_core.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vectrix/kinematics/attitude/quaternion.hpp>

#include "named_craft_core.hpp"

namespace vectrix::detail {

std::shared_ptr<const CraftCore> make_craft_core(PlainSpacecraft plain, std::vector<PlainMount> mounts) {
  const NamedCraftCore named(std::move(plain), "Spacecraft");
  return std::make_shared<const CraftCore>(
      CraftCore{named.plain(), named.tree(), named.component_names(), std::move(mounts)});
}

std::vector<double> quaternion_numbers(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = unit_quaternion_of(R);
  return {q.w(), q.x(), q.y(), q.z()};
}

std::vector<double> from_mount(const PlainBody& body, std::vector<double> positions) {
  const Eigen::Quaterniond mount(body.R_p_from_b);
  const Eigen::Quaterniond q =
      mount.conjugate() * Eigen::Quaterniond(positions[0], positions[1], positions[2], positions[3]);
  positions[0] = q.w(), positions[1] = q.x(), positions[2] = q.y(), positions[3] = q.z();
  for (std::size_t i = 4; i < positions.size(); ++i)
    positions[i] -= body.r_pb_p[static_cast<Eigen::Index>(i - 4)];
  return positions;
}

void require_finite_state(const char* action, const CraftCore& core, double time, std::span<const double> y) {
  const auto refuse = [&](const std::string& what, double number) {
    throw BadInput(std::string{action} + " of the craft of " + in_quotes(core.plain.hub) + ": " + what +
                   " is " + text(number));
  };
  if (!std::isfinite(time)) refuse("the time, s,", time);
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!std::isfinite(y[i])) refuse(core.component_names[i], y[i]);
}

}  // namespace vectrix::detail
