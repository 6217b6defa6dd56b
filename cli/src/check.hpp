#pragma once

#include <iosfwd>
#include <optional>

#include "sources.hpp"
#include "target.hpp"

namespace vectrix::cli {

struct CheckOptions {
  AttitudeSource attitude;
  OrbitSource orbit{};
  std::optional<Eigen::Vector3d> axis{};  // in the axes of the body, any length
  std::optional<Target> target{};
  std::filesystem::path orientation{};  // of the Earth, for ITRF
};

/// Writes which readings of an attitude make its rates, its steadiness and its target agree. It chooses none.
/// True if a comparison confirms the file as stated, and none prefers another reading. Throws BadInput.
bool check(const CheckOptions& options, std::ostream& out);

}  // namespace vectrix::cli
