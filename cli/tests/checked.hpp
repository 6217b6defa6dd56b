#pragma once

#include <sstream>
#include <string>

#include "check.hpp"
#include "cubesat.hpp"

namespace vectrix::cli {

/// What check() says, and writes.
struct Checked {
  bool fits;
  std::string text;
};
inline Checked checked(const CheckOptions& options) {
  std::ostringstream out;
  const bool fits = check(options, out);
  return {fits, out.str()};
}

/// The cubesat with its orbit, its axis and its target.
inline CheckOptions cubesat() {
  CheckOptions options{cubesat_attitude(), cubesat_orbit(), Eigen::Vector3d(0.0, 0.0, -1.0), Target::sun};
  options.attitude.columns->reference = "J2000";
  return options;
}

}  // namespace vectrix::cli
