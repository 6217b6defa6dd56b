#pragma once

#include <filesystem>

#include "harmonics.hpp"

namespace vectrix::detail {

/// Fully normalized coefficients, with mu (m^3/s^2) and the radius (m) that go with them.
struct GravityModel {
  double mu;
  double radius;
  Harmonics coefficients;
};

/// The embedded coefficients.
inline constexpr int egm2008_degree = 20;
GravityModel egm2008_model(int degree);

/// Throws BadInput with file, line and reason.
GravityModel read_icgem(const std::filesystem::path& file, int degree);

}  // namespace vectrix::detail
