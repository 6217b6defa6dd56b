#pragma once

#include <filesystem>
#include <functional>

#include <vectrix/space.hpp>

namespace vectrix::cli {

struct Satellite : moving_frame {};

/// The motion of the satellite in GCRF.
using FlownOrbit = std::function<PointMotion<earth::Gcrf, Satellite, earth::Gcrf>(const Epoch&)>;

/// Of the element set of a file of two-line elements whose epoch is nearest to the middle of the span, at
/// most a week old. Throws BadInput as TwoLineElements and Sgp4 do.
FlownOrbit orbit_of_elements(const std::filesystem::path& file, const TimeSpan& span);

/// Of an orbit ephemeris message in EME2000, GCRF or TEME: each epoch by the first segment that has it.
/// Throws BadInput as the message does, for another frame, and for an epoch in no segment.
FlownOrbit orbit_of_message(const std::filesystem::path& file, const TimeSpan& span);

}  // namespace vectrix::cli
