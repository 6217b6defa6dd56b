#include <vectrix/dynamics/craft/named_motion.hpp>

#include <Eigen/Geometry>

#include "named_craft_core.hpp"

namespace vectrix {
namespace {

using detail::eigen;
using detail::in_quotes;
using detail::NamedCraftCore;
using detail::numbers;
using multibody::Work;

/// R_f^h.
Eigen::Matrix3d to_hub(const NamedCraftCore& core, const Work<double>& work, NamedFrame f) {
  if (core.own(f).motion() == FrameMotion::inertial) return eigen(work.R_i_from_h).transpose();
  return eigen(core.tree().rotation(core.link(f, "rotation"), work));
}
Eigen::Vector3d in_hub_axes(const NamedCraftCore& core, const Work<double>& work, NamedFrame c,
                            const Eigen::Vector3d& v_c) {
  return to_hub(core, work, c) * v_c;
}
Eigen::Vector3d in_axes_of(const NamedCraftCore& core, const Work<double>& work, NamedFrame c,
                           const Eigen::Vector3d& v_h) {
  return to_hub(core, work, c).transpose() * v_h;
}

/// w_if, in the hub's axes.
Eigen::Vector3d turning(const NamedCraftCore& core, const Work<double>& work, NamedFrame f) {
  if (f.motion() == FrameMotion::inertial) return Eigen::Vector3d::Zero();
  return eigen(core.tree().angular_velocity(core.link(f, "angular_velocity"), work));
}
void require_free(const NamedCraftCore& core, const char* what, NamedFrame f) {
  if (f.motion() == FrameMotion::inertial && core.plain().motion == HubMotion::turning) {
    throw BadInput(std::string{what} + " relative to " + in_quotes(f) + ": the hub " +
                   in_quotes(core.plain().hub) + " is only turning, and where it is is not known");
  }
}
/// From the hub's origin to that of f, in the hub's axes: between two bodies no digits go to where the craft
/// is.
Eigen::Vector3d place(const NamedCraftCore& core, const Work<double>& work, const double* y, NamedFrame f) {
  if (f.motion() != FrameMotion::inertial) return eigen(core.tree().position(core.link(f, "position"), work));
  require_free(core, "position", f);
  return eigen(work.R_i_from_h).transpose() * -Eigen::Vector3d(y[7], y[8], y[9]);
}
/// The velocity of the origin of f relative to that of the hub, observed from the inertial frame, in the
/// hub's axes: between two bodies no digits go to the speed of the craft.
Eigen::Vector3d moving(const NamedCraftCore& core, const Work<double>& work, const double* y, NamedFrame f) {
  if (f.motion() != FrameMotion::inertial)
    return eigen(core.tree().velocity_beyond_hub(core.link(f, "velocity"), y, work));
  require_free(core, "velocity", f);
  return eigen(work.R_i_from_h).transpose() * -Eigen::Vector3d(y[10], y[11], y[12]);
}

/// The joint, if it is of one of the kinds.
NamedCraftCore::Joint joint_of_kind(const NamedCraftCore& core, const char* action, std::string_view body,
                                    const char* effort, std::initializer_list<JointKind> kinds) {
  const auto joint = core.joint(body);
  for (const JointKind kind : kinds)
    if (joint.body->joint == kind) return joint;
  throw BadInput(std::string{action} + ": " + effort + " on " + in_quotes(body) + ", whose joint is a " +
                 detail::name_of(joint.body->joint));
}
NamedCraftCore::Joint joint_that_turns(const NamedCraftCore& core, const char* action, std::string_view body,
                                       int axis) {
  const auto joint =
      joint_of_kind(core, action, body, "a torque about an axis", {JointKind::hinge, JointKind::gimbal});
  if (axis < 1 || static_cast<std::size_t>(axis) > detail::counts_of(joint.body->joint).axes)
    throw BadInput(std::string{action} + " on " + in_quotes(body) + ": its joint has no axis " +
                   detail::text(axis));
  return joint;
}

}  // namespace

NamedFrame NamedNow::frame(std::string_view name) const {
  return core_->frame(name);
}
NamedFrame NamedNow::frame(NamedFrame frame) const {
  return core_->own(frame);
}
NamedDcm NamedNow::rotation_between(NamedFrame b, NamedFrame a) const {
  return {detail::trusted, b, a,
          Eigen::Matrix3d(to_hub(*core_, *work_, b).transpose() * to_hub(*core_, *work_, a))};
}
NamedAngularVelocity NamedNow::rate(NamedFrame b, NamedFrame a, NamedFrame c) const {
  const Eigen::Vector3d w = turning(*core_, *work_, b) - turning(*core_, *work_, a);
  return {detail::trusted, b, a, {detail::trusted, c, in_axes_of(*core_, *work_, c, w)}};
}
NamedDisplacement NamedNow::place(NamedFrame b, NamedFrame a, NamedFrame c) const {
  const Eigen::Vector3d r = vectrix::place(*core_, *work_, y_, b) - vectrix::place(*core_, *work_, y_, a);
  return {detail::trusted, b, a, {detail::trusted, c, in_axes_of(*core_, *work_, c, r)}};
}
// v_ab|o = v_b - v_a - w_io x r_ab
NamedVelocity NamedNow::speed(NamedFrame b, NamedFrame a, NamedFrame o, NamedFrame c) const {
  const Eigen::Vector3d r = vectrix::place(*core_, *work_, y_, b) - vectrix::place(*core_, *work_, y_, a);
  const Eigen::Vector3d v =
      moving(*core_, *work_, y_, b) - moving(*core_, *work_, y_, a) - turning(*core_, *work_, o).cross(r);
  return {detail::trusted, b, a, o, {detail::trusted, c, in_axes_of(*core_, *work_, c, v)}};
}

multibody::Conserved<double> NamedNow::conserved() const {
  return core_->tree().conserved(y_, multibody::zero_column<double>(), *work_);
}
Quantity<si::energy> NamedNow::energy() const {
  return Quantity<si::energy>::from_value(conserved().energy);
}
NamedVector<si::momentum> NamedNow::momentum() const {
  return {detail::trusted, core_->frame(std::size_t{0}), eigen(conserved().momentum)};
}
NamedVector<si::angular_momentum> NamedNow::angular_momentum() const {
  return {detail::trusted, core_->frame(std::size_t{0}), eigen(conserved().angular_momentum)};
}

void NamedForces::force(NamedFrame body, const NamedVector<si::force>& F_c) {
  const auto F = in_hub_axes(*core_, *work_, F_c.in(), F_c.coordinates());
  core_->tree().add_wrench(core_->link(body, "force"), numbers(F), multibody::zero_column<double>(), *work_);
}
void NamedForces::force(NamedFrame body, const NamedVector<si::length>& r_bq_d,
                        const NamedVector<si::force>& F_c) {
  const auto r = in_hub_axes(*core_, *work_, r_bq_d.in(), r_bq_d.coordinates());
  const auto F = in_hub_axes(*core_, *work_, F_c.in(), F_c.coordinates());
  core_->tree().add_wrench(core_->link(body, "force"), numbers(F), numbers(Eigen::Vector3d(r.cross(F))),
                           *work_);
}
void NamedForces::torque(NamedFrame body, const NamedVector<si::torque>& M_c) {
  const auto M = in_hub_axes(*core_, *work_, M_c.in(), M_c.coordinates());
  core_->tree().add_wrench(core_->link(body, "torque"), multibody::zero_column<double>(), numbers(M), *work_);
}
void NamedForces::effort(std::string_view body, const Quantity<si::torque>& about, int axis) {
  const auto joint = joint_that_turns(*core_, "effort", body, axis);
  work_->efforts[core_->speed_at(joint, axis)] += about.value();
}
void NamedForces::effort(std::string_view body, const Quantity<si::force>& along) {
  const auto joint = joint_of_kind(*core_, "effort", body, "a force along an axis", {JointKind::slider});
  work_->efforts[core_->speed_at(joint, 1)] += along.value();
}
void NamedForces::effort(std::string_view body, const NamedVector<si::torque>& M_c) {
  const auto joint =
      joint_of_kind(*core_, "effort", body, "a torque vector", {JointKind::ball, JointKind::free});
  const Eigen::Vector3d M_b = in_axes_of(*core_, *work_, core_->frame(body),
                                         in_hub_axes(*core_, *work_, M_c.in(), M_c.coordinates()));
  for (std::size_t i = 0; i < 3; ++i)
    work_->efforts[core_->speed_at(joint, 1) + i] += M_b[static_cast<Eigen::Index>(i)];
}
void NamedForces::motor(std::string_view rotor, const Quantity<si::torque>& torque) {
  work_->motors[core_->rotor(rotor)] += torque.value();
}
void NamedForces::modal(std::string_view mode, double force) {
  work_->modal[core_->mode(mode)] += force;
}
void NamedForces::field(const NamedVector<si::acceleration>& g_c) {
  const auto g_h = in_hub_axes(*core_, *work_, g_c.in(), g_c.coordinates());
  work_->field += work_->R_i_from_h * numbers(g_h);
}

NamedAngularAcceleration NamedMotion::angular_acceleration(Of<std::string_view> body,
                                                           In<std::string_view> c) const {
  const NamedFrame b = core_->frame(body.frame), in = core_->frame(c.frame);
  const auto moved = core_->tree().accelerations(core_->link(b, "angular_acceleration"), work_);
  return {detail::trusted,
          b,
          core_->frame(std::size_t{0}),
          {detail::trusted, in, in_axes_of(*core_, work_, in, eigen(moved.alpha))}};
}
NamedAcceleration NamedMotion::acceleration(Of<std::string_view> body, In<std::string_view> c) const {
  const NamedFrame b = core_->frame(body.frame), in = core_->frame(c.frame), i = core_->frame(std::size_t{0});
  const auto moved = core_->tree().accelerations(core_->link(b, "acceleration"), work_);
  return {detail::trusted, b, i, i, {detail::trusted, in, in_axes_of(*core_, work_, in, eigen(moved.a))}};
}
NamedVector<si::force> NamedMotion::joint_force(Of<std::string_view> body, In<std::string_view> c) const {
  const NamedFrame in = core_->frame(c.frame);
  core_->joint(body.frame);
  const auto passed = core_->tree().reaction(core_->link(core_->frame(body.frame), "joint_force"), work_);
  return {detail::trusted, in, in_axes_of(*core_, work_, in, eigen(passed.force))};
}
NamedVector<si::torque> NamedMotion::joint_torque(Of<std::string_view> body, In<std::string_view> c) const {
  const NamedFrame in = core_->frame(c.frame);
  core_->joint(body.frame);
  const auto passed = core_->tree().reaction(core_->link(core_->frame(body.frame), "joint_torque"), work_);
  return {detail::trusted, in, in_axes_of(*core_, work_, in, eigen(passed.torque))};
}

Quantity<si::torque> NamedMotion::holding_torque(Of<std::string_view> body, int axis) const {
  if (const auto rotor = core_->find_rotor(body.frame); rotor && axis == 1)
    return Quantity<si::torque>::from_value(core_->tree().holding_torque(*rotor, work_));
  const auto joint = joint_that_turns(*core_, "holding_torque", body.frame, axis);
  return Quantity<si::torque>::from_value(
      core_->tree().holding_effort(static_cast<int>(joint.link) + axis, work_));
}
Quantity<si::force> NamedMotion::holding_force(Of<std::string_view> body) const {
  const auto joint =
      joint_of_kind(*core_, "holding_force", body.frame, "a force along an axis", {JointKind::slider});
  return Quantity<si::force>::from_value(
      core_->tree().holding_effort(static_cast<int>(joint.link) + 1, work_));
}

}  // namespace vectrix
