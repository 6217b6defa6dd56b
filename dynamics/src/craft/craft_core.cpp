#include <vectrix/dynamics/craft/craft_core.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vectrix/kinematics/attitude/quaternion.hpp>

#include "named_craft_core.hpp"

namespace vectrix::detail {
namespace {

std::string of_the_craft(const CraftCore& core) {
  return " of the craft of " + in_quotes(core.plain.hub);
}
/// The place of the first number that is not finite; their count if there is none.
std::size_t not_finite(std::span<const double> numbers) {
  const auto found =
      std::find_if(numbers.begin(), numbers.end(), [](double number) { return !std::isfinite(number); });
  return static_cast<std::size_t>(found - numbers.begin());
}

}  // namespace

std::shared_ptr<const CraftCore> make_craft_core(PlainSpacecraft plain, std::vector<PlainMount> mounts) {
  const NamedCraftCore named(std::move(plain), "Spacecraft");
  auto core = std::make_shared<CraftCore>(named.core());
  core->mounts = std::move(mounts);
  return core;
}

std::vector<double> quaternion_numbers(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = unit_quaternion_of(R);
  return {q.w(), q.x(), q.y(), q.z()};
}

std::vector<double> from_mount(const PlainBody& body, std::vector<double> positions) {
  const Eigen::Quaterniond mount = unit_quaternion_of(body.R_p_from_b);
  const Eigen::Quaterniond q =
      mount.conjugate() * Eigen::Quaterniond(positions[0], positions[1], positions[2], positions[3]);
  positions[0] = q.w(), positions[1] = q.x(), positions[2] = q.y(), positions[3] = q.z();
  for (std::size_t i = 4; i < positions.size(); ++i)
    positions[i] -= body.r_pb_p[static_cast<Eigen::Index>(i - 4)];
  return positions;
}

double size_of_inertia(const PlainSpacecraft& craft) {
  double size = craft.J_c_h.trace() + craft.mass * craft.r_hc_h.squaredNorm();
  for (const PlainBody& body : craft.bodies)
    size += body.J_c_b.trace() + body.mass * (body.r_pb_p.squaredNorm() + body.r_bc_b.squaredNorm());
  return size;
}

void refuse_to_hold_twice(const std::string& what) {
  throw BadInput(what + " is driven, and locked or driven again");
}
void require_finite_time(const CraftCore& core, const char* action, double time) {
  if (!std::isfinite(time))
    throw BadInput(action + of_the_craft(core) + ": the time is " + text(time) + " s");
}
void require_state(const CraftCore& core, const char* action, std::span<const double> y) {
  if (const std::size_t bad = not_finite(y); bad < y.size())
    throw BadInput(action + of_the_craft(core) + ": " + core.component_names[bad] + " is " + text(y[bad]));
  const auto require_rotation = [&](std::size_t at) {
    const Eigen::Map<const Eigen::Vector4d> q(&y[at]);
    if (std::isnormal(q.squaredNorm())) return;
    throw BadInput(action + of_the_craft(core) + ": the quaternion from " + core.component_names[at] +
                   " on has the norm " + text(q.stableNorm()));
  };
  require_rotation(0);
  const auto& links = core.tree.numbers().links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const multibody::Kind kind = links[i].joint.kind;
    if (kind == multibody::Kind::ball || kind == multibody::Kind::free)
      require_rotation(core.tree.layout().position_at[i]);
  }
}
void require_finite_rates(const CraftCore& core, double time, std::span<const double> ydot) {
  const std::size_t bad = not_finite(ydot);
  if (bad == ydot.size()) return;
  throw BadInput("motion" + of_the_craft(core) + " at " + text(time) + " s: the derivative of " +
                 core.component_names[bad] + " is " + text(ydot[bad]));
}

}  // namespace vectrix::detail
