#pragma once

#include <filesystem>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/text_kernel.hpp>
#include <vectrix/space/time/leap_seconds.hpp>

namespace vectrix {

/// The leap seconds of a kernel of SPICE (LSK):
///     use_leap_seconds(read_leap_second_kernel("naif0012.tls"))
/// Throws BadInput with line and column for what are no pairs of whole seconds and first days of a month, and
/// if the kernel has other constants than all have had: with them its ephemeris time would be another one.
/// use_leap_seconds() checks the order, and that the table has all that is known.
VECTRIX_EXPORT std::vector<LeapSecond> read_leap_second_kernel(const std::filesystem::path& file);
VECTRIX_EXPORT std::vector<LeapSecond> leap_seconds_of(const TextKernel& kernel);

}  // namespace vectrix
