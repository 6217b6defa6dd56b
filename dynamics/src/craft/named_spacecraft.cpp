#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include <algorithm>
#include <vectrix/dynamics/craft/plain_parts.hpp>
#include <vectrix/dynamics/multibody/impulse.hpp>

#include "named_craft_core.hpp"

namespace vectrix {
namespace {

using detail::in_quotes;
using detail::NamedCraftCore;

PlainSpacecraft plain_of(const NamedHub& hub, const std::vector<NamedBody>& bodies,
                         const std::vector<NamedRotor>& rotors, const std::vector<NamedMode>& modes) {
  PlainSpacecraft craft =
      detail::plain_hub(hub.inertial, hub.name, hub.motion, detail::mass_numbers(hub.mass));
  for (const auto& [name, parent, mass, joint] : bodies)
    craft.bodies.push_back(detail::plain_body(name, parent, joint.kind, joint.X_p_from_b.rotation.matrix(),
                                              joint.X_p_from_b.translation.coordinates(), joint.axes_b,
                                              detail::mass_numbers(mass)));
  for (const NamedRotor& rotor : rotors)
    craft.rotors.push_back({rotor.name, rotor.body, rotor.axis_b.coordinates(), rotor.inertia.value()});
  for (const NamedMode& mode : modes)
    craft.modes.push_back({mode.name, mode.body, mode.rotation_b, mode.translation_b, mode.frequency.value(),
                           mode.damping_ratio});
  return craft;
}

/// A joint or rotor that is held, resolved to links, or a rotor, and their places among the speeds.
struct HeldPart {
  NamedHeld how;
  std::size_t first_link, links, first_speed, speeds;  ///< of a rotor no link, and its number
};

HeldPart resolved(const NamedCraftCore& core, const NamedHeld& how) {
  const auto refuse = [&](const std::string& what) {
    throw BadInput("prescribed(" + in_quotes(how.name()) + "): " + what +
                   ", and the acceleration that of a " + detail::name_of(*how.joint()));
  };
  if (const auto rotor = core.find_rotor(how.name())) {
    if (how.joint().value_or(JointKind::hinge) != JointKind::hinge) refuse("it is a rotor");
    return {how, 0, 0, *rotor, 1};
  }
  const auto joint = core.joint(how.name());
  const JointKind kind = joint.body->joint;
  if (how.joint() && how.joint() != kind) refuse(std::string{"its joint is a "} + detail::name_of(kind));
  const detail::JointCounts counts = detail::counts_of(kind);
  if (!how.accelerations()) return {how, joint.link, counts.links, 0, 0};
  if (how.axis() == 0) return {how, joint.link, counts.links, core.speed_at(joint, 1), counts.axes};
  if (how.axis() < 0 || how.axis() > 2)
    throw BadInput("prescribed(" + in_quotes(how.name()) + "): a gimbal has the axes 1 and 2, not " +
                   detail::text(how.axis()));
  return {how, joint.link + static_cast<std::size_t>(how.axis() - 1), 1, core.speed_at(joint, how.axis()), 1};
}
std::vector<HeldPart> resolved(const NamedCraftCore& core, const std::vector<NamedHeld>& held) {
  std::vector<HeldPart> list;
  for (const NamedHeld& how : held) {
    const HeldPart part = resolved(core, how);
    for (const HeldPart& other : list) {
      const bool same_axis = how.axis() == 0 || other.how.axis() == 0 || how.axis() == other.how.axis();
      if (other.how.name() == how.name() && same_axis)
        throw BadInput((part.links > 0 ? "the joint of " : "the rotor ") + in_quotes(how.name()) +
                       " is held twice");
    }
    list.push_back(part);
  }
  return list;
}

/// ydot = f(t, y), with the loads and what is held.
struct Evaluation {
  std::shared_ptr<const NamedCraftCore> core;
  NamedLoads loads;
  std::vector<HeldPart> held;
  multibody::Work<double> work;

  Evaluation(std::shared_ptr<const NamedCraftCore> of, NamedLoads given, const std::vector<NamedHeld>& joints)
      : core(std::move(of)),
        loads(std::move(given)),
        held(resolved(*core, joints)),
        work(core->tree().work()) {}

  void operator()(double segment_start, double t, const double* y, double* ydot) {
    core->tree().place(y, work);
    hold(t);
    add_loads(segment_start, t, y);
    core->tree().solve(y, ydot, work);
  }
  /// What is held or loads that is not finite; empty if there is none.
  std::string not_finite(double segment_start, double t, const double* y) {
    detail::place_for_loads(core->tree(), y, work);
    hold(t);
    add_loads(segment_start, t, y);
    return detail::not_finite_load(core->plain(), work);
  }

 private:
  void hold(double t) {
    for (const HeldPart& part : held) {
      const auto& accelerations = part.how.accelerations();
      const auto how = accelerations ? multibody::Hold::driven : multibody::Hold::locked;
      if (part.links == 0)
        work.held_rotors[part.first_speed] = how;
      else
        std::fill_n(work.held.begin() + static_cast<std::ptrdiff_t>(part.first_link), part.links, how);
      if (!accelerations) continue;
      const auto given = accelerations(t);
      std::copy_n(given.begin(), part.speeds,
                  &(part.links == 0 ? work.given_spins : work.given)[part.first_speed]);
    }
  }
  void add_loads(double segment_start, double t, const double* y) {
    if (!loads) return;
    NamedForces forces{detail::trusted, *core, work};
    loads(NamedNow{detail::trusted, *core, segment_start, t, y, work}, forces);
  }
};

}  // namespace

NamedSpacecraft::NamedSpacecraft(const PlainSpacecraft& plain)
    : core_(std::make_shared<NamedCraftCore>(plain, "NamedSpacecraft")) {}
NamedSpacecraft::NamedSpacecraft(const NamedHub& hub, const std::vector<NamedBody>& bodies,
                                 const std::vector<NamedRotor>& rotors, const std::vector<NamedMode>& modes)
    : NamedSpacecraft(plain_of(hub, bodies, rotors, modes)) {}

const PlainSpacecraft& NamedSpacecraft::plain() const& {
  return core_->plain();
}
PlainSpacecraft NamedSpacecraft::plain() && {
  return core_->plain();
}
std::size_t NamedSpacecraft::state_size() const {
  return core_->tree().layout().size();
}
NamedFrame NamedSpacecraft::frame(std::string_view name) const {
  return core_->frame(name);
}
NamedFrame NamedSpacecraft::hub() const {
  return core_->frame(std::size_t{1});
}
NamedFrame NamedSpacecraft::inertial() const {
  return core_->frame(std::size_t{0});
}

NamedMotion NamedSpacecraft::motion(const NamedState& state, const Quantity<si::time>& time,
                                    const NamedLoads& loads, const std::vector<NamedHeld>& held) const {
  if (state.view().core != core_.get()) throw BadInput("motion: the state is of another craft");
  detail::require_finite_time(core_->core(), "motion", time.value());
  Evaluation evaluate(core_, loads, held);
  std::vector<double> ydot(state.numbers().size());
  evaluate(time.value(), time.value(), state.numbers().data(), ydot.data());
  detail::require_finite_rates(core_->core(), "motion", time.value(), ydot, [&] {
    return evaluate.not_finite(time.value(), time.value(), state.numbers().data());
  });
  return {detail::trusted, core_, time.value(), state.numbers(), std::move(ydot), std::move(evaluate.work)};
}

NamedState NamedSpacecraft::stopped(const NamedState& state, const std::vector<std::string>& names,
                                    const std::vector<NamedHeld>& held) const {
  using multibody::InImpulse;
  if (state.view().core != core_.get()) throw BadInput("stopped: the state is of another craft");
  const auto& layout = core_->tree().layout();
  std::vector<InImpulse> links(layout.speed_at.size(), InImpulse::is_free),
      rotors(layout.rotors, InImpulse::is_free);
  std::vector<NamedHeld> all = held;
  for (const std::string& name : names) all.push_back(locked(name));
  const std::vector<HeldPart> parts = resolved(*core_, all);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const HeldPart& part = parts[i];
    const InImpulse how = i < held.size() ? InImpulse::keeps_speed : InImpulse::stops;
    if (part.links == 0)
      rotors[part.first_speed] = how;
    else
      std::fill_n(links.begin() + static_cast<std::ptrdiff_t>(part.first_link), part.links, how);
  }
  std::vector<double> numbers = state.numbers();
  multibody::stop(core_->tree(), links, rotors, numbers.data());
  return this->state(numbers);
}

ode::Problem NamedSpacecraft::problem(const NamedState& state, const Quantity<si::time>& start,
                                      const Quantity<si::time>& end, double relative_tolerance,
                                      const CraftTolerances& tolerances, const NamedLoads& loads,
                                      const std::vector<NamedHeld>& held) const {
  if (state.view().core != core_.get()) throw BadInput("problem: the state is of another craft");
  ode::Problem problem;
  problem.rhs = [evaluate = Evaluation(core_, loads, held)](
                    double segment_start, double t, std::span<const double> y,
                    std::span<double> ydot) mutable { evaluate(segment_start, t, y.data(), ydot.data()); };
  problem.why_not_finite = [evaluate = Evaluation(core_, loads, held)](double segment_start, double t,
                                                                       std::span<const double> y) mutable {
    return evaluate.not_finite(segment_start, t, y.data());
  };
  problem.initial_state = state.numbers();
  problem.start = start.value();
  problem.end = end.value();
  problem.relative_tolerance = relative_tolerance;
  problem.absolute_tolerances = absolute_tolerances(core_->plain(), tolerances);
  problem.caller = "NamedSpacecraft " + in_quotes(core_->plain().hub);
  problem.component_names = core_->core().component_names;
  return problem;
}

}  // namespace vectrix
