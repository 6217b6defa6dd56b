#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"
#include "reading.hpp"
#include "target.hpp"

namespace vectrix::cli {

/// How far the rates of a file are from the turns between its samples, rad/s rms, by reading: with the axes
/// that are stated for the rates, and with the other ones. Of each step shorter than three times the median
/// one it is the angle between the turn that the quaternions have, and that of the mean rate of both ends.
struct RateEvidence {
  std::vector<double> stated_axes, other_axes;  // by reading
  double rms_rate;                              // of the file
};
RateEvidence compare_rates(const AttitudeRecord& record);

/// A signed permutation of axes: entry i says along which axis of the body, 1 to 3, and to which side, axis i
/// of the rates is.
using SignedAxes = std::array<int, 3>;
/// A reading, and where the axes of the rates are in the body.
struct RatesInOtherAxes {
  Reading reading;
  SignedAxes axes;
  double difference;  // rad/s rms
};
/// That of the first two readings and all 24 right-handed permutations that makes the rates agree; nothing
/// unless it alone brings the difference below a third of that of any other, and of the rates themselves. The
/// other order of numbers would add nothing: it permutes the body's axes, and those of the reference, in one
/// of the first two readings, and no rate can tell.
std::optional<RatesInOtherAxes> axes_of_rates(const AttitudeRecord& record);

/// The rms rate of the body relative to LVLH, rad/s, by reading.
std::vector<double> steadiness(const AttitudeRecord& record, const FlownOrbit& orbit);

/// The median angle between an axis of the body and the target, rad, by reading. The target is geometric.
std::vector<double> off_target(const AttitudeRecord& record, const Eigen::Vector3d& axis, Target target,
                               const FlownOrbit& orbit);

/// What a list of disagreements, one a reading, says: that which is stated comes first.
enum class Verdict { as_stated, another, undecided };
/// Another reading must be more than three times better than the stated one; the stated one is confirmed if
/// it is more than three times better than all others. Nothing is decided if the best disagreement exceeds
/// `useless`.
Verdict verdict(const std::vector<double>& disagreements, double useless);

}  // namespace vectrix::cli
