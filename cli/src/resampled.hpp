#pragma once

#include <optional>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// The attitude at an instant between two samples: `motion` of the record, or else turning at a constant rate
/// the shortest way.
struct AttitudeStep {
  std::size_t before;  // the sample before the instant, or at it
  BodyMotion at;
};
/// Throws BadInput outside the samples, in a gap, and within a step that turns by nearly half a turn: which
/// way is not known.
AttitudeStep step_at(const AttitudeRecord& record, const Epoch& t);

/// The attitude at other times, in the convention of the record: without those outside the samples and those
/// in a gap, and without rates. The times are equal steps: where one is left out is a gap.
/// Throws BadInput if fewer than two are left, and as step_at.
AttitudeRecord resampled(const AttitudeRecord& record, const std::vector<Epoch>& times);

}  // namespace vectrix::cli
