#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// A factor of a chain: a frame of an attitude kernel, or one that is mounted on another, and what it is
/// relative to. The numbers are those of frames, in kernels of attitudes those of their class.
struct KernelLink {
  std::int32_t frame, base;
  bool is_mounted;
};

/// The frames of an attitude kernel from a given one to one that is known without it, in steps of the kernel
/// and of the frame kernel:
///     R_reference^frame = R_reference^base ... R_gimbal^frame
struct KernelChain {
  std::vector<KernelLink> links;  // the given frame first
  std::int32_t root;              // the frame of which the last link is relative: J2000, ECLIPJ2000 or ITRF93

  /// Throws BadInput, with the name, for a frame that is in neither kernel, one that is relative to itself,
  /// and one that the kernel has relative to several others within the span.
  static KernelChain of(std::int32_t frame, const AttitudeKernel& kernel, const FrameKernel& frames,
                        const TimeSpan& span, const std::string& file);
  /// Whether it is one frame of the attitude kernel relative to J2000.
  [[nodiscard]] bool is_direct() const;
  /// Of the names of reference_name().
  [[nodiscard]] std::string reference() const;
};

/// Of such a chain the product, in the times that all factors know: in each interval samples where the factor
/// with most of them has them; the motion between them; the recorded rates if all factors have them. The
/// record has its file already. Throws BadInput as AttitudeKernel does, of type 1 too, and if the factors
/// have no time in common.
void multiply(const KernelChain& chain, const AttitudeKernel& kernel, const FrameKernel& frames,
              const TimeSpan& span, AttitudeRecord& record);

/// What later segments of the time hide of a frame: "segment 1 'A' for 20 s, segment 2 'B' for 3 s".
std::string hidden_segments(const AttitudeKernel& kernel, const std::vector<HiddenAttitude>& hidden);

}  // namespace vectrix::cli
