#pragma once

#include <filesystem>
#include <string>

#include "element_sets.hpp"
#include "orbit_record.hpp"

namespace vectrix::cli {

/// An orbit without samples of its own, two lines, messages of elements or an ephemeris kernel of SPICE, and
/// the instants at which it is wanted, as options state them: times with their scale, and s. Empty: not
/// given.
struct SampledOrbit {
  std::filesystem::path file;
  std::string from{}, until{}, step{};
  StatedSatellite satellite{};  // of elements of several
};

/// Elements by SGP4 in TEME, a kernel in GCRF: from the first instant on, a step apart, until the last,
/// rounded to a nanosecond.
/// Throws BadInput that names the options which are missing, as orbit_of_elements() and orbit_of_kernel() do,
/// for fewer than two instants, and for instants that the file does not have.
OrbitRecord sampled(const SampledOrbit& source);

/// Whether the file is an ephemeris kernel of SPICE (SPK). Throws BadInput if it cannot be read.
bool is_orbit_kernel(const std::filesystem::path& file);

}  // namespace vectrix::cli
