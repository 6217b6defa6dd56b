#pragma once

#include <vectrix/dynamics/scenario/trajectory.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix {

/// The conserved quantities of a trajectory, and how far each changed: the largest relative change since the
/// start, over all steps. Empty if the scenario does not conserve the quantity (a torque acts) or has no
/// orbit.
struct Conservation {
  double orthonormality;                    ///< of the raw attitude: Trajectory::orthonormality_drift()
  std::optional<double> rotational_energy;  ///< 1/2 w . J w
  std::optional<double> angular_momentum;   ///< the vector R_b^i J w, in i
  std::optional<double> orbital_energy;     ///< v^2/2 - mu/r
  std::optional<double> orbital_angular_momentum;  ///< the vector r x v, in i
};

namespace detail {

inline double relative_change(double change, double scale) {
  return scale > 0.0 ? change / scale : change;
}

}  // namespace detail

/// The conservation report of a trajectory of this scenario. Throws BadInput if the trajectory has an orbit
/// and the scenario no mu, or if the trajectory has no node.
template <class I, class B>
Conservation conservation(const Scenario<I, B>& scenario, const Trajectory<I, B>& trajectory) {
  Conservation report{trajectory.orthonormality_drift(), {}, {}, {}, {}};
  const State<I, B> first = trajectory.node(0);
  if (first.orbit && !scenario.mu) {
    throw BadInput("conservation(scenario of " + frame_name<B>() +
                   "): the trajectory has an orbit, but mu is not given");
  }
  const auto energy = [&](const State<I, B>& state) {
    return kinetic_energy(scenario.inertia, state.w_ib_b).value();
  };
  const auto momentum = [&](const State<I, B>& state) {
    return angular_momentum(scenario, state).coordinates();
  };
  const auto orbital_energy = [&](const State<I, B>& state) {
    return state.orbit->velocity.coordinates().squaredNorm() / 2.0 -
           scenario.mu->value() / norm(state.orbit->position).value();
  };
  const auto orbital_momentum = [&](const State<I, B>& state) {
    return cross(state.orbit->position.vector(), state.orbit->velocity.vector()).coordinates();
  };

  // The largest change of `quantity`, a number or a column, relative to its first value.
  const auto largest_change = [&](const auto& quantity) {
    const auto start = quantity(first);
    const auto size = [](const auto& value) {
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
        return std::abs(value);
      } else {
        return value.norm();
      }
    };
    double largest = 0.0;
    for (std::size_t i = 1; i < trajectory.node_count(); ++i) {
      largest = detail::larger(
          largest, size(std::remove_cvref_t<decltype(start)>(quantity(trajectory.node(i)) - start)));
    }
    return detail::relative_change(largest, size(start));
  };

  if (scenario.torque_free()) {
    report.rotational_energy = largest_change(energy);
    report.angular_momentum = largest_change(momentum);
  }
  if (first.orbit) {
    report.orbital_energy = largest_change(orbital_energy);
    report.orbital_angular_momentum = largest_change(orbital_momentum);
  }
  return report;
}

}  // namespace vectrix
