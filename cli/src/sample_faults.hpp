#pragma once

#include <iosfwd>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// The steps from each sample to the next, s.
std::vector<double> durations_of(const AttitudeRecord& record);
/// A longer step is a gap.
inline double longest_step(double median_step) {
  return 3.0 * median_step;
}

/// What the samples of an attitude show without anything to compare with.
struct SampleFaults {
  struct Extreme {
    std::size_t count = 0;
    double largest = 0.0;
    std::size_t sample = 0;  // where it is largest
  };

  double median_step;   // s
  Extreme gaps;         // steps longer than three times the median, s
  Extreme sign_flips;   // q and -q are one attitude, but not to who interpolates the numbers
  Extreme half_turns;   // steps that turn by more than 0.9 of half a turn, rad: which way is not known
  Extreme jumps;        // steps more than ten times as fast as the median and 0.5 deg, rad
  Extreme norm_errors;  // | |q| - 1 | above 1e-6, unless the numbers are of another scale
  double scale;         // the median norm
};
SampleFaults faults_of(const AttitudeRecord& record);

/// Writes what the record has, in the convention that is stated, and what its samples show.
void write_samples(const AttitudeRecord& record, std::ostream& out);

}  // namespace vectrix::cli
