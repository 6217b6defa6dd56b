#pragma once

#include <algorithm>
#include <iosfwd>
#include <numbers>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// The steps from each sample to the next, s.
std::vector<double> durations_of(const AttitudeRecord& record);
/// A longer step is a gap, s.
inline double longest_step(const AttitudeRecord& record, double median_step) {
  return record.longest_step.value_or(3.0 * median_step);
}

/// Whether a new interval of a kernel begins behind the step from a sample: its attitude is not interpolated.
inline bool is_break(const AttitudeRecord& record, std::size_t sample) {
  const auto& starts = record.interval_starts;
  return std::binary_search(starts.begin(), starts.end(), record.times[sample + 1]);
}
/// Whether the step from a sample is a break, or longer than `longest`, s.
inline bool is_gap(const AttitudeRecord& record, std::size_t sample, double longest) {
  return (record.times[sample + 1] - record.times[sample]).value() > longest || is_break(record, sample);
}

/// rad. Which way a step turns that turns by more is not known.
inline constexpr double nearly_half_a_turn = 0.9 * std::numbers::pi;

/// What the samples of an attitude show without anything to compare with.
struct SampleFaults {
  struct Extreme {
    std::size_t count = 0;
    double largest = 0.0;
    std::size_t sample = 0;  // where it is largest
  };

  double median_step;   // s
  Extreme gaps;         // steps longer than longest_step, s
  Extreme breaks;       // shorter ones from one interval of a kernel to another
  Extreme sign_flips;   // q and -q are one attitude, but not to who interpolates the numbers
  Extreme half_turns;   // steps that turn by more than 0.9 of half a turn, rad: which way is not known
  Extreme jumps;        // steps more than ten times as fast as the median and 0.5 deg, rad
  Extreme norm_errors;  // | |q| - 1 | above 1e-6, unless the numbers are of another scale
  double scale;         // the median norm
  // Times that are off by more than a hundredth of the usual step, s: with that step before and behind them,
  // and not with theirs, the body turns evenly.
  Extreme wrong_times;
};
SampleFaults faults_of(const AttitudeRecord& record);

/// Writes what the record has, in the convention that is stated, and what its samples show.
void write_samples(const AttitudeRecord& record, std::ostream& out);

}  // namespace vectrix::cli
