#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include <vectrix/space.hpp>

#include "element_sets.hpp"
#include "interpolation.hpp"
#include "orbit_record.hpp"

namespace vectrix::cli {

struct Satellite : moving_frame {};

/// The motion of the satellite in GCRF.
using FlownOrbit = std::function<PointMotion<earth::Gcrf, Satellite, earth::Gcrf>(const Epoch&)>;

/// Halfway from its start to its end.
Epoch middle_of(const TimeSpan& span);

/// Of the one of these element sets of a file, of one satellite, whose epoch is nearest to an instant, by
/// default the middle of the span, and at most a week from all of the span. Throws BadInput as of_satellite
/// does, for older elements, and where SGP4 ends.
FlownOrbit orbit_of_elements(const std::vector<ElementSet>& sets, const std::filesystem::path& file,
                             const TimeSpan& span, const std::optional<Epoch>& nearest_to = {},
                             const StatedSatellite& satellite = {});

/// An interpolation that was stated, and how to state one.
struct StatedInterpolation {
  std::optional<Interpolation> value{};
  std::string word = "--interpolation hermite|lagrange --degree NUMBER";

  [[nodiscard]] std::string name() const { return word.substr(0, word.find(' ')); }
};

/// The motion of the one spacecraft of an ephemeris kernel. Throws BadInput as EphemerisKernel does, and if
/// there are several spacecraft or none.
FlownOrbit orbit_of_kernel(const std::filesystem::path& file, const TimeSpan& span);

/// Of an orbit ephemeris message in EME2000, GCRF or TEME, or in ITRF if the orientation of the Earth is
/// given, about the Earth: each epoch by the first segment that has it, interpolated as the segment says, or
/// else as `stated`. Throws BadInput as the message does, for another frame, an epoch in no segment, fewer
/// samples than the interpolation needs, an interpolation that nobody has stated, and one that is stated
/// while every segment says its own.
FlownOrbit orbit_of_message(const std::filesystem::path& file, const TimeSpan& span,
                            const StatedInterpolation& stated = {},
                            const std::optional<EarthOrientation>& orientation = std::nullopt);

/// Of a table, in ITRF only with the orientation of the Earth. Throws BadInput as the table does, and as
/// orbit_of_message.
FlownOrbit orbit_of_table(const OrbitFile& source, const TimeSpan& span, const Interpolation& interpolation,
                          const std::optional<EarthOrientation>& orientation);

}  // namespace vectrix::cli
