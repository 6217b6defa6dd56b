#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "sources.hpp"
#include "target.hpp"
#include "when.hpp"

namespace vectrix::cli {

struct PointingOptions {
  AttitudeSource attitude;
  OrbitSource orbit{};
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // in the axes of the body, any length
  MeasureTarget target = Target::sun;
  std::filesystem::path orientation{};        // of the Earth, for a station and ITRF
  std::optional<SkyCorrection> correction{};  // of the Sun, the Moon and stars, which need one
  When when = When::always;
  std::optional<double> window{};                       // s
  std::optional<double> required, required_relative{};  // deg, of the absolute and the relative error
  std::optional<double> percent{};  // of the samples, or the windows, that have to fulfil it
  std::filesystem::path csv{};      // empty if not wanted
  bool force = false;
};

/// Writes how far an axis of the body is from a target, and whether it fulfils what is required. True if it
/// does, or nothing is required. Throws BadInput.
bool pointing(const PointingOptions& options, std::ostream& out);

}  // namespace vectrix::cli
