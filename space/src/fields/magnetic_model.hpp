#pragma once

#include <string>
#include <vector>

#include "harmonics.hpp"

namespace vectrix::detail {

/// Coefficients of Schmidt, nT, at the start of some years, linear in time between these.
struct MagneticModel {
  struct AtYear {
    int year;
    Harmonics potential;
  };

  std::string name;
  std::vector<AtYear> epochs;
};

/// The embedded coefficients.
MagneticModel igrf14_model();
MagneticModel wmm2025_model();

}  // namespace vectrix::detail
