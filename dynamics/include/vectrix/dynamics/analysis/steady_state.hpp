#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include <vectrix/dynamics/analysis/duals.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// The accelerations that may be left in an equilibrium: of the hub and of joints that turn, of the hub and
/// of joints that slide, and of modes, kg^1/2 m/s^2. There is no default.
struct EquilibriumTolerances {
  Quantity<si::angular_acceleration> turning;
  Quantity<si::acceleration> sliding;
  double mode;
};

/// No equilibrium was found: `component()` is left with the second derivative `residual()`.
class VECTRIX_EXPORT NoEquilibrium : public std::runtime_error {
 public:
  NoEquilibrium(const std::string& text, std::string component, double residual, long iterations)
      : std::runtime_error(text),
        component_(std::move(component)),
        residual_(residual),
        iterations_(iterations) {}

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] double residual() const { return residual_; }
  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  std::string component_;
  double residual_;
  long iterations_;
};

namespace detail {

struct SteadyProblem {
  const CraftCore& core;
  std::span<const double> guess;
  std::function<void(const Dual* y, Dual* ydot)> rates;
  const multibody::Work<Dual>& work;  ///< after rates(): which joints are locked
  EquilibriumTolerances tolerances;
};
/// The state of steady turning; throws NoEquilibrium.
VECTRIX_EXPORT std::vector<double> steady_state(const SteadyProblem& problem);

}  // namespace detail

}  // namespace vectrix
