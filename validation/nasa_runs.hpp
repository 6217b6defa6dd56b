#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vectrix/dynamics.hpp>

#include "difference.hpp"

namespace vectrix::validation {

/// Duration of NASA's orbital attitude runs.
inline constexpr double nasa_duration_s = 28800.0;

struct TorquePulse {
  Quantity<si::time> start, end;
  Vector<Body, si::torque> torque_b;
};

struct NasaRun {
  Satellite craft;
  CraftState<Satellite> start;
  Quantity<si::gravitational_parameter> mu;
  bool gravity_gradient;
  std::optional<TorquePulse> pulse;
};

/// NASA's run "2", "8A", "8B", "9A" or "10A", from the published initial conditions.
NasaRun nasa_run(const std::string& name);

/// Its motion until a time, by the tolerances of tight().
std::function<CraftState<Satellite>(const Quantity<si::time>&)> fly(const NasaRun& run, double end_s);

}  // namespace vectrix::validation
