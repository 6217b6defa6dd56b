#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "attitude_kernel_record.hpp"
#include "attitude_record.hpp"
#include "flown_orbit.hpp"
#include "interpolation.hpp"
#include "selection.hpp"

namespace vectrix::cli {

/// The file of an attitude, and what is stated of it.
struct AttitudeSource {
  std::filesystem::path file;
  std::optional<TableColumns> columns{};  // of a table; a message says them itself
  Selection selection{};
  std::optional<KernelWords> kernel{};  // of a kernel of SPICE
};
/// Throws BadInput as read_table, read_message or read_kernel does, and if fewer than two samples are within
/// the times.
AttitudeRecord read_attitude(const AttitudeSource& source);
/// Every file that is read.
std::vector<std::filesystem::path> files_of(const AttitudeSource& source);

/// The file of an orbit; all are empty if none is given.
struct OrbitSource {
  std::filesystem::path elements{}, message{}, kernel{}, mean_elements{};
  std::optional<OrbitFile> table{};
  StatedSatellite satellite{};                    // of elements, two lines or messages, of several
  StatedInterpolation interpolation{};            // of a table, or a message that does not say it
  std::optional<EarthOrientation> orientation{};  // of an orbit in ITRF
};
/// The file that is read, or none.
std::vector<std::filesystem::path> files_of(const OrbitSource& source);
/// Nothing if none is given. Throws BadInput for two, and as orbit_of_elements, orbit_of_message,
/// orbit_of_kernel or orbit_of_table does.
FlownOrbit read_orbit(const OrbitSource& source, const TimeSpan& span,
                      const std::optional<Epoch>& nearest_to = {});

}  // namespace vectrix::cli
