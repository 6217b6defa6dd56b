#pragma once

#include "sources.hpp"

namespace vectrix::cli {

/// Two hours of a cubesat that looks at the Sun with -z, and its two-line elements.
inline AttitudeSource cubesat_attitude() {
  const TableColumns columns{"UTC",
                             scale::utc,
                             {"quaternion_c", "quaternion_x", "quaternion_y", "quaternion_z"},
                             {Convention::Scalar::first, Convention::Maps::to_body},
                             "GCRF",
                             {}};
  return {std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/CTIM_20230420_attitude.csv", columns};
}
inline OrbitSource cubesat_orbit() {
  return {std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/CTIM_20230419.tle"};
}

}  // namespace vectrix::cli
