#pragma once

#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// The attitude at other times, turning at a constant rate from one sample to the next, the shortest way:
/// without those outside the samples and those in a gap. Without rates. Throws BadInput if fewer than two are
/// left, and for a time within a step that turns by nearly half a turn: which way is not known.
AttitudeRecord resampled(const AttitudeRecord& record, const std::vector<Epoch>& times);

}  // namespace vectrix::cli
