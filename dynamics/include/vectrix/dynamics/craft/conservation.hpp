#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <type_traits>
#include <vectrix/dynamics/craft/flight.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix {
namespace detail {

/// The coordinates of a vector, the value of a quantity; numbers as they are.
inline double plain_value(double value) {
  return value;
}
inline const Eigen::Vector3d& plain_value(const Eigen::Vector3d& value) {
  return value;
}
template <class U> double plain_value(const Quantity<U>& value) {
  return value.value();
}
template <class F, class U> Eigen::Vector3d plain_value(const Vector<F, U>& value) {
  return value.coordinates();
}
inline double size_of(double value) {
  return std::abs(value);
}
template <class S> S size_of(const Eigen::Matrix<S, 3, 1>& value) {
  return value.norm();
}

template <class F, class C> inline constexpr bool measures = requires(const F& quantity, const Now<C>& now) {
  plain_value(quantity(now));
};

}  // namespace detail

/// The largest change of a quantity since the start of a run, over all its nodes, relative to what it was; if
/// that is zero, the change itself. The quantity is a function of const Now<C>&, a number, a Quantity, a
/// Vector or its coordinates:
///     largest_change(craft, flight, [](const Now<C>& now) { return now.angular_momentum(); })
/// Throws BadInput if the trajectory has no node.
template <CraftType C, class... X, class F>
  requires detail::measures<F, C>
double largest_change(const C& craft, const CraftTrajectory<C, X...>& trajectory, const F& quantity) {
  const detail::CraftCore& core = *craft.core();
  auto work = core.tree.work();
  const auto at = [&](std::size_t index) {
    const CraftState<C> state = trajectory.node(index);
    core.tree.place(state.data(), work);
    const Now<C> now{detail::trusted, core, state.time().value(), state.data(), work};
    auto value = detail::plain_value(quantity(now));
    return value;
  };
  const auto start = at(0);
  double largest = 0.0;
  for (std::size_t i = 1; i < trajectory.node_count(); ++i)
    largest = detail::larger(largest, detail::size_of(decltype(start)(at(i) - start)));
  const double scale = detail::size_of(start);
  return scale > 0.0 ? largest / scale : largest;
}
template <CraftType C, CraftType GivenC, class... X, class F>
  requires(!(std::is_same_v<C, GivenC> && detail::measures<F, C>))
auto largest_change(  // of a craft C, its trajectory, and f: a number, quantity or vector of const Now<C>&
    const C&, const CraftTrajectory<GivenC, X...>&, const F&) -> Refused = delete;

/// What a run should have kept, and how far each changed: see largest_change(). All but the first are empty
/// if a load acts: what it keeps is a question for largest_change().
struct CraftConservation {
  double orthonormality;                   ///< of the raw attitude: CraftTrajectory::orthonormality_drift()
  std::optional<double> energy;            ///< Now::energy(); empty if a mode is damped
  std::optional<double> momentum;          ///< Now::momentum(); empty if the hub is only turning
  std::optional<double> angular_momentum;  ///< Now::angular_momentum()
};
/// What is known, one line each.
VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const CraftConservation& kept);

/// The conservation report of a trajectory of this scenario. Throws BadInput if it has no node.
template <CraftType C, class... Parts, class... X>
CraftConservation conservation(const CraftScenario<C, Parts...>& scenario,
                               const CraftTrajectory<C, X...>& trajectory) {
  const C& craft = scenario.craft();
  CraftConservation report{trajectory.orthonormality_drift(), {}, {}, {}};
  if constexpr (!(detail::PartOf<Parts>::load || ...)) {
    const auto& modes = craft.core()->plain.modes;
    const auto change = [&](const auto& quantity) { return largest_change(craft, trajectory, quantity); };
    if (std::none_of(modes.begin(), modes.end(),
                     [](const PlainMode& mode) { return mode.damping_ratio > 0.0; }))
      report.energy = change([](const Now<C>& now) { return now.energy(); });
    if constexpr (C::shape::free) report.momentum = change([](const Now<C>& now) { return now.momentum(); });
    report.angular_momentum = change([](const Now<C>& now) { return now.angular_momentum(); });
  }
  return report;
}
template <CraftType C, class... Parts, CraftType GivenC, class... X>
  requires(!std::is_same_v<C, GivenC>)
auto conservation(  // conservation(scenario, trajectory): both of one craft
    const CraftScenario<C, Parts...>&, const CraftTrajectory<GivenC, X...>&) -> Refused = delete;

}  // namespace vectrix
