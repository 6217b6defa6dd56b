#pragma once

#include <functional>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// What an attitude shows if the times of its file are of another scale than stated.
struct ScaleReading {
  const char* scale;  // "UTC"
  double angle;       // rad
};

/// The angle, by `measured`, with the times of the file read in each of the other scales: the same digits. TT
/// and TDB, 2 ms apart, are one. Of a thousand samples at most, and of those that stay within the times of
/// the file, where its orbit is known; a scale that leaves fewer than two is not tried, and none before 1981.
std::vector<ScaleReading> in_other_scales(const AttitudeRecord& as_read,
                                          const std::function<double(AttitudeRecord)>& measured);

}  // namespace vectrix::cli
