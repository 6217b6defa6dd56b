#include "sample_faults.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "figures.hpp"
#include "quantile.hpp"
#include "reference_frame.hpp"

namespace vectrix::cli {
namespace {

void add(SampleFaults::Extreme& found, double value, std::size_t sample) {
  if (found.count == 0 || value > found.largest) {
    found.largest = value;
    found.sample = sample;
  }
  ++found.count;
}

// The body cannot know of a late time tag: it turned in the step before as in the step behind.
void add_wrong_times(const std::vector<double>& durations, const std::vector<double>& turns,
                     SampleFaults& found) {
  if (turns.size() < 2) return;
  std::vector<double> changes;
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) changes.push_back(std::abs(turns[i + 1] - turns[i]));
  constexpr double least_part = 0.01, decisive = 4.0;
  const double usual = found.median_step, unsteadiness = median(changes);
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    const double late = std::abs(durations[i] - usual);
    const bool is_made_up_for = std::abs(durations[i] + durations[i + 1] - 2.0 * usual) < late / decisive;
    // What the speed before and behind would differ by, as a turn in a usual step.
    const double made_up = late * (turns[i] + turns[i + 1]) / usual;
    if (late > least_part * usual && is_made_up_for &&
        decisive * std::max(changes[i], unsteadiness) < made_up)
      add(found.wrong_times, late, i + 1);
  }
}

void write_head(const AttitudeRecord& record, const SampleFaults& faults, std::ostream& out) {
  out << record.file << "\n"
      << record.size() << " samples of " << record.body << " relative to " << record.reference_of_file()
      << ", " << record.times.front() << " to " << record.times.back() << ", usually "
      << shown(faults.median_step) << " s apart.\n";
  if (record.has_quaternions) {
    const bool to_body = record.stated.maps == Convention::Maps::to_body;
    out << "As stated, R(q) takes coordinates to " << (to_body ? record.body : record.reference_of_file())
        << "; the scalar is " << (record.stated.scalar == Convention::Scalar::first ? "first" : "last")
        << ".\n";
  }
  if (!record.chain.empty()) out << "Multiplied from what the kernel has: " << record.chain << ".\n";
  if (const std::string axes = axes_of_reference(record.reference_of_file()); !axes.empty())
    out << record.reference_of_file() << " is taken as CCSDS has it, of the orbit relative to GCRF: " << axes
        << ".\n";
  out << '\n';
}

void write_faults(const AttitudeRecord& record, const SampleFaults& faults, std::ostream& out) {
  out << "Samples\n";
  const auto at = [&](std::size_t sample) {
    return "sample " + detail::text(sample + 1) + ", " + record.times[sample].utc(3) + " UTC";
  };
  const auto line = [&](const SampleFaults::Extreme& found, const std::string& one, const std::string& many,
                        const std::string& largest) {
    if (found.count > 0)
      out << "  " << found.count << ' ' << (found.count == 1 ? one : many)
          << (largest.empty() ? ", first" : "; most " + largest) << " at " << at(found.sample) << '\n';
  };
  const std::string longer =
      record.longest_step ? shown(*record.longest_step) + " s" : "three times the usual one";
  line(faults.gaps, "gap, a step longer than " + longer, "gaps, steps longer than " + longer,
       shown(faults.gaps.largest) + " s, which ends");
  line(faults.breaks, "step from one interval of the kernel to another, over which nothing is interpolated",
       "steps from one interval of the kernel to another, over which nothing is interpolated", "");
  line(faults.wrong_times,
       "time that seems wrong: with the usual steps the body turns evenly, with these it does not",
       "times that seem wrong: with the usual steps the body turns evenly, with these it does not",
       shown(faults.wrong_times.largest) + " s");
  line(faults.sign_flips, "change from q to -q: the attitude is one, its numbers are not",
       "changes from q to -q: the attitude is one, its numbers are not", "");
  line(faults.half_turns, "step near half a turn: rates must say which way it turned",
       "steps near half a turn: rates must say which way it turned",
       shown(degrees * faults.half_turns.largest) + " deg");
  line(faults.jumps, "jump, ten times faster than usual", "jumps, ten times faster than usual",
       shown(degrees * faults.jumps.largest) + " deg");
  line(faults.norm_errors, "quaternion whose norm is off the median norm by more than 1e-6",
       "quaternions whose norm is off the median norm by more than 1e-6",
       shown(faults.norm_errors.largest) + " of it");
  if (std::abs(faults.scale - 1.0) > 1e-6)
    out << "  the norm of the quaternions is " << shown(faults.scale) << ", not 1\n";
  if (faults.gaps.count + faults.breaks.count + faults.sign_flips.count + faults.half_turns.count +
          faults.jumps.count + faults.norm_errors.count + faults.wrong_times.count ==
      0)
    out << "  no gaps, changes of sign, half turns, jumps or differing norms\n";
  if (!record.hidden_segments.empty())
    out << "  hidden by later segments of the kernel: " << record.hidden_segments << '\n';
  out << '\n';
}

}  // namespace

std::vector<double> durations_of(const AttitudeRecord& record) {
  std::vector<double> durations;
  for (std::size_t i = 0; i + 1 < record.size(); ++i)
    durations.push_back((record.times[i + 1] - record.times[i]).value());
  return durations;
}

SampleFaults faults_of(const AttitudeRecord& record) {
  const auto durations = durations_of(record);
  std::vector<double> turns, norms;
  SampleFaults found{};
  for (std::size_t i = 0; i + 1 < record.size(); ++i) {
    const Eigen::Quaterniond turn =
        record.to_reference(i, record.stated).conjugate() * record.to_reference(i + 1, record.stated);
    turns.push_back(angle_of(turn));
    if (turn.w() < 0.0) add(found.sign_flips, 0.0, i + 1);
  }
  for (const auto& q : record.numbers) norms.push_back(norm_of(q));
  found.median_step = median(durations);
  found.scale = median(norms);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < turns.size(); ++i) speeds.push_back(turns[i] / durations[i]);
  const double usual = median(speeds);
  constexpr double least_jump = 0.5 / degrees;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (durations[i] > longest_step(record, found.median_step)) {
      add(found.gaps, durations[i], i + 1);
    } else if (is_break(record, i)) {
      add(found.breaks, 0.0, i + 1);
    }
    if (turns[i] > nearly_half_a_turn) add(found.half_turns, turns[i], i + 1);
    if (speeds[i] > 10.0 * usual && turns[i] > least_jump) add(found.jumps, turns[i], i + 1);
  }
  add_wrong_times(durations, turns, found);
  constexpr double tolerance = 1e-6;
  for (std::size_t i = 0; i < norms.size(); ++i) {
    const double off = std::abs(norms[i] / found.scale - 1.0);
    if (off > tolerance) add(found.norm_errors, off, i);
  }
  return found;
}

void write_samples(const AttitudeRecord& record, std::ostream& out) {
  const SampleFaults faults = faults_of(record);
  write_head(record, faults, out);
  write_faults(record, faults, out);
}

}  // namespace vectrix::cli
