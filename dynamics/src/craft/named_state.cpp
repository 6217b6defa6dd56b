#include <vectrix/dynamics/craft/named_state.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/kinematics/named/quaternion.hpp>

#include "named_craft_core.hpp"

namespace vectrix {
namespace detail {
namespace {

/// Puts the starts in the places of a state; each part once.
void place_starts(const NamedCraftCore& core, const std::vector<NamedStart>& starts, std::vector<double>& y) {
  const auto& plain = core.plain();
  const auto& layout = core.tree().layout();
  std::vector<std::string_view> missing;
  for (const auto& body : plain.bodies)
    if (body.joint != JointKind::fixed) missing.push_back(body.name);
  for (const auto& rotor : plain.rotors) missing.push_back(rotor.name);
  for (const auto& mode : plain.modes) missing.push_back(mode.name);
  for (const NamedStart& start : starts) {
    const std::string place = "state: the start of " + in_quotes(start.name());
    if (std::holds_alternative<NamedStart::Rotor>(start.of())) {
      y[layout.rotors_begin() + core.rotor(start.name())] = start.speeds()[0];
    } else if (std::holds_alternative<NamedStart::Mode>(start.of())) {
      const std::size_t at = layout.modes_begin() + core.mode(start.name());
      y[at] = start.positions()[0];
      y[at + layout.modes] = start.speeds()[0];
    } else {
      const auto joint = core.joint(start.name());
      if (const JointKind kind = std::get<JointKind>(start.of()); kind != joint.body->joint) {
        throw BadInput(place + " is that of a " + name_of(kind) + ", its joint is a " +
                       name_of(joint.body->joint));
      }
      if (!start.relative_to().empty() && start.relative_to() != joint.body->parent) {
        throw BadInput(place + " is relative to " + in_quotes(start.relative_to()) + ", and it hangs on " +
                       in_quotes(joint.body->parent));
      }
      const bool turns = joint.body->joint == JointKind::ball || joint.body->joint == JointKind::free;
      const auto positions = turns ? from_mount(*joint.body, start.positions()) : start.positions();
      std::copy(positions.begin(), positions.end(),
                y.begin() + static_cast<std::ptrdiff_t>(core.position_at(joint, 1)));
      std::copy(start.speeds().begin(), start.speeds().end(),
                y.begin() + static_cast<std::ptrdiff_t>(layout.speeds_begin() + core.speed_at(joint, 1)));
    }
    const auto found = std::find(missing.begin(), missing.end(), start.name());
    if (found == missing.end()) throw BadInput(place + " is given twice");
    missing.erase(found);
  }
  if (!missing.empty()) {
    throw BadInput("state: " + in_quotes(missing.front()) + " has no start" +
                   (missing.size() == 1 ? "" : ", nor have " + text(missing.size() - 1) + " others"));
  }
}

void require_frames(const NamedCraftCore& core, const NamedDcm& R) {
  const auto action = [&] {
    return "state of the craft of " + in_quotes(core.plain().hub) + " from " + described(R);
  };
  require_same(R.to(), core.frame(std::size_t{0}), action);
  require_same(R.from(), core.frame(std::size_t{1}), action);
}

}  // namespace

double named_number(const NamedView& view, NamedNumber number, std::string_view name, int axis) {
  const NamedCraftCore& core = *view.core;
  const auto& layout = core.tree().layout();
  switch (number) {
    case NamedNumber::spin:
      return view.y[layout.rotors_begin() + core.rotor(name)];
    case NamedNumber::deflection:
      return view.y[layout.modes_begin() + core.mode(name)];
    case NamedNumber::deflection_rate:
      return view.y[layout.modes_begin() + layout.modes + core.mode(name)];
    default:
      break;
  }
  const auto joint = core.joint(name);
  const JointKind kind = joint.body->joint;
  const bool turns = number == NamedNumber::angle || number == NamedNumber::angle_rate;
  const bool fits = turns == (kind != JointKind::slider);
  if (!fits || axis < 1 || static_cast<std::size_t>(axis) > counts_of(kind).axes) {
    throw BadInput(std::string{turns ? "angle " : "length "} + text(axis) + " of " + in_quotes(name) +
                   ": its joint is a " + name_of(kind));
  }
  const bool position = number == NamedNumber::angle || number == NamedNumber::length;
  return view
      .y[position ? core.position_at(joint, axis) : layout.speeds_begin() + core.speed_at(joint, axis)];
}

}  // namespace detail

NamedStart detail::start_of(const NamedMovingDcm& R_p_from_b) {
  std::vector<double> w;
  detail::append(w, R_p_from_b.angular_velocity().coordinates());
  return {detail::trusted,
          R_p_from_b.rotation().from().name(),
          JointKind::ball,
          detail::quaternion_numbers(R_p_from_b.rotation().matrix()),
          w,
          R_p_from_b.rotation().to().name()};
}
NamedStart detail::start_of(const NamedMovingTransform& X_p_from_b) {
  std::vector<double> positions = detail::quaternion_numbers(X_p_from_b.turning().rotation().matrix()),
                      speeds;
  detail::append(positions, X_p_from_b.translation().coordinates());
  detail::append(speeds, X_p_from_b.turning().angular_velocity().coordinates());
  detail::append(speeds, X_p_from_b.velocity().coordinates());
  return {detail::trusted, X_p_from_b.turning().rotation().from().name(), JointKind::free, positions,
          speeds,          X_p_from_b.turning().rotation().to().name()};
}

NamedState NamedSpacecraft::state(const NamedMovingTransform& X_i_from_hub,
                                  const std::vector<NamedStart>& starts) const {
  detail::require_frames(*core_, X_i_from_hub.turning().rotation());
  if (plain().motion != HubMotion::free)
    throw BadInput("state: the hub " + detail::in_quotes(plain().hub) +
                   " is only turning; its position is not a state");
  std::vector<double> y = detail::quaternion_numbers(X_i_from_hub.turning().rotation().matrix());
  detail::append(y, X_i_from_hub.turning().angular_velocity().coordinates());
  detail::append(y, X_i_from_hub.translation().coordinates());
  detail::append(y, X_i_from_hub.velocity().coordinates());
  y.resize(core_->tree().layout().size());
  detail::place_starts(*core_, starts, y);
  return state(y);
}
NamedState NamedSpacecraft::state(const NamedMovingDcm& R_i_from_hub,
                                  const std::vector<NamedStart>& starts) const {
  detail::require_frames(*core_, R_i_from_hub.rotation());
  if (plain().motion != HubMotion::turning)
    throw BadInput("state: the hub " + detail::in_quotes(plain().hub) +
                   " is free; its position and velocity are missing");
  std::vector<double> y = detail::quaternion_numbers(R_i_from_hub.rotation().matrix());
  detail::append(y, R_i_from_hub.angular_velocity().coordinates());
  y.resize(core_->tree().layout().size());
  detail::place_starts(*core_, starts, y);
  return state(y);
}
NamedState NamedSpacecraft::state(std::span<const double> numbers) const {
  const std::size_t size = core_->tree().layout().size();
  if (numbers.size() != size) {
    throw BadInput("state: " + detail::text(numbers.size()) + " numbers; the craft of " +
                   detail::in_quotes(plain().hub) + " has " + detail::text(size));
  }
  detail::require_state(core_->core(), "state", numbers);
  return {detail::trusted, core_, {numbers.begin(), numbers.end()}};
}

NamedMovingDcm NamedState::turning() const {
  const NamedFrame i = core_->frame(std::size_t{0}), h = core_->frame(std::size_t{1});
  const double* y = numbers_.data();
  const auto q = nearest_quaternion_scalar_first(To(i), From(h), y[0], y[1], y[2], y[3]).quaternion;
  return moving_dcm(dcm(q),
                    angular_velocity(Of(h), RelativeTo(i),
                                     vector<si::angular_velocity>(In(h), Eigen::Vector3d(y[4], y[5], y[6]))));
}
NamedMovingTransform NamedState::hub_motion() const {
  if (core_->plain().motion != HubMotion::free)
    throw BadInput("hub_motion: the hub " + detail::in_quotes(core_->plain().hub) + " is only turning");
  const NamedFrame i = core_->frame(std::size_t{0}), h = core_->frame(std::size_t{1});
  const double* y = numbers_.data();
  return {turning(),
          displacement(Of(h), RelativeTo(i), vector<si::length>(In(i), Eigen::Vector3d(y[7], y[8], y[9]))),
          velocity(Of(h), RelativeTo(i), ObservedFrom(i),
                   vector<si::velocity>(In(i), Eigen::Vector3d(y[10], y[11], y[12])))};
}

}  // namespace vectrix
