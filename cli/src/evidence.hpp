#pragma once

#include <array>
#include <numbers>
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
  double rms_turn;                              // of the shortest turns, rad/s
  // Of rates relative to GCRF, if the reference of the file turns: in the axes of the body, and of GCRF.
  std::vector<double> of_gcrf_in_body{}, of_gcrf_in_gcrf{};
  // What the nearest of these leaves if the mean rate of a step may be off by half of its change in the step.
  double least_beyond_change{};
  // What of it lasts from one sample to those behind, as that of a wrong reading does: errors of single
  // samples do not. 0 if it may be chance; all of it if there are too few samples to tell.
  double least_lasting{};
};
RateEvidence compare_rates(const AttitudeRecord& record);

/// A signed permutation of axes: entry i says along which axis of the body, 1 to 3, and to which side, axis i
/// of the rates is. It may be left-handed: a single sign is a common mistake.
using SignedAxes = std::array<int, 3>;
/// A reading, and where the axes of the rates are in the body.
struct RatesInOtherAxes {
  Reading reading;
  SignedAxes axes;
  double difference;  // rad/s rms
};
/// All signed permutations, with the quaternions as stated and transposed; the best first. The other order of
/// numbers would add nothing: it permutes the body's axes, and those of the reference, in one of the first
/// two readings, and no rate can tell.
std::vector<RatesInOtherAxes> rates_in_other_axes(const AttitudeRecord& record);

/// The rms rate of the body relative to LVLH, rad/s, by reading.
std::vector<double> steadiness(const AttitudeRecord& record, const FlownOrbit& orbit);

/// The median angle between an axis of the body and the target, rad, by reading. The target is geometric.
std::vector<double> off_target(const AttitudeRecord& record, const Eigen::Vector3d& axis, Target target,
                               const FlownOrbit& orbit);

/// The same of a target whose directions along the axes of the reference are known.
std::vector<double> off_directions(const AttitudeRecord& record, const Eigen::Vector3d& axis,
                                   const std::vector<Eigen::Vector3d>& to_target);
/// rad. What is farther off does not look at its target.
inline constexpr double largest_off_target = 5.0 * std::numbers::pi / 180.0;

/// Which readings fit, of a list of disagreements, the stated one first: those that are at most three times
/// the smallest, or a thousandth of `largest`; none if all exceed that.
std::vector<std::size_t> fitting(const std::vector<double>& disagreements, double largest);

}  // namespace vectrix::cli
