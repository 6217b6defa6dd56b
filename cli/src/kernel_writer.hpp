#pragma once

#include <filesystem>
#include <string>

#include "attitude_kernel_record.hpp"
#include "plain_attitude.hpp"

namespace vectrix::cli {

/// Writes an attitude relative to GCRF, which kernels call J2000, as an attitude kernel of type 3. A step
/// above `longest_step`, in seconds, is a gap, which its readers do not interpolate. Throws BadInput for
/// another reference, and without a clock and a frame.
void write_kernel(const PlainAttitude& attitude, const KernelWords& words, double longest_step,
                  const std::filesystem::path& out, bool force);

/// As a kernel can have it: rates in rad/s, in the axes of the reference.
PlainAttitude as_in_a_kernel(PlainAttitude attitude);

}  // namespace vectrix::cli
