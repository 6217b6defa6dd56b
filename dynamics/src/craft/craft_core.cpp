#include <vectrix/dynamics/craft/craft_core.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

constexpr double rounding_of_inertia = 16.0 * std::numeric_limits<double>::epsilon();

Eigen::Matrix3d full(const multibody::Symmetric<double>& m) {
  return Eigen::Matrix3d{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}};
}
/// The axis about which a symmetric matrix is zero but for the rounding of numbers of the size of `of`.
std::optional<Eigen::Vector3d> axis_without(const Eigen::Matrix3d& J, const Eigen::Matrix3d& of) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(J);
  if (principal.eigenvalues()[0] > rounding_of_inertia * of.trace()) return std::nullopt;
  return principal.eigenvectors().col(0);
}

Eigen::Matrix3d parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.dot(b) * Eigen::Matrix3d::Identity() - a * b.transpose();
}
/// Of the craft with all its joints locked, about the hub's origin.
struct Whole {
  double m = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
};
Whole whole(const multibody::Tree<double>& tree, const multibody::Work<double>& work) {
  Whole craft;
  for (int body = 0; body <= static_cast<int>(work.links.size()); ++body) {
    const auto& mass =
        body == 0 ? tree.numbers().hub : tree.numbers().links[static_cast<std::size_t>(body) - 1].mass;
    const Eigen::Matrix3d R = eigen(tree.rotation(body, work));
    const Eigen::Vector3d r = eigen(tree.position(body, work)), mc = R * eigen(mass.mc);
    craft.J += R * full(mass.J) * R.transpose() + parallel(r, mc) + parallel(mc, r) + mass.m * parallel(r, r);
    craft.m += mass.m;
    craft.first += mass.m * r + mc;
  }
  return craft;
}
/// Of what the hub feels of the craft with all its joints free: that of a body far off on a free joint is not
/// lost in rounding.
bool free_craft_turns(const multibody::Tree<double>& tree, const double* y, multibody::Work<double>& work) {
  std::vector<double> ydot(tree.layout().size());
  tree.solve(y, ydot.data(), work);
  const Eigen::Matrix3d A = full(work.hub.A), H = eigen(work.hub.H), M = full(work.hub.M);
  return !axis_without(A - H * M.inverse() * H.transpose(), A);
}
/// Point masses on a line have no rotation about it.
void require_inertia(const CraftCore& core, const char* action, const double* y) {
  auto work = core.tree.work();
  core.tree.place(y, work);
  const Whole craft = whole(core.tree, work);
  if (const double trace = craft.J.trace(); trace != 0.0 && !has_size(trace))
    throw BadInput(action + of_the_craft(core) +
                   ": as it stands, the sum of its moments of inertia about the hub's origin is " +
                   text(trace) + " kg m^2" + sizes_of_a_craft());
  const auto axis = axis_without(craft.J - parallel(craft.first, craft.first) / craft.m, craft.J);
  if (!axis || free_craft_turns(core.tree, y, work)) return;
  throw BadInput(action + of_the_craft(core) + ": as it stands, it has no inertia about the axis (" +
                 text(axis->x()) + ", " + text(axis->y()) + ", " + text(axis->z()) + ") of the hub");
}

}  // namespace

LoweredParts::LoweredParts(const PlainSpacecraft& hub) : plain_(hub) {}
LoweredParts::~LoweredParts() = default;
void LoweredParts::add(const PlainBody& body) {
  plain_.bodies.push_back(body);
}
void LoweredParts::add(const PlainRotor& rotor) {
  plain_.rotors.push_back(rotor);
}
void LoweredParts::add(const PlainMode& mode) {
  plain_.modes.push_back(mode);
}
void LoweredParts::add(const PlainMount& mount) {
  mounts_.push_back(mount);
}
std::shared_ptr<const CraftCore> LoweredParts::core() const {
  const NamedCraftCore named(plain_, "Spacecraft");
  auto core = std::make_shared<CraftCore>(named.core());
  core->mounts = mounts_;
  return core;
}

std::vector<double> quaternion_numbers(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = unit_quaternion_of(R);
  return {q.w(), q.x(), q.y(), q.z()};
}

double* put_numbers(double* to, const Eigen::Matrix3d& R) {
  const auto q = quaternion_numbers(R);
  return std::copy(q.begin(), q.end(), to);
}
double* put_numbers(double* to, const Eigen::Vector3d& v) {
  return std::copy(v.data(), v.data() + v.size(), to);
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
  require_inertia(core, action, y.data());
}
void require_finite_rates(const CraftCore& core, const char* action, double time,
                          std::span<const double> ydot, const std::function<std::string()>& why) {
  const std::size_t bad = not_finite(ydot);
  if (bad == ydot.size()) return;
  const std::string cause = why();
  throw BadInput(action + of_the_craft(core) + " at " + text(time) + " s: the derivative of " +
                 core.component_names[bad] + " is " + text(ydot[bad]) + (cause.empty() ? "" : ": " + cause));
}

}  // namespace vectrix::detail
