#include "sample_faults.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "median.hpp"

namespace vectrix::cli {
namespace {

void add(SampleFaults::Extreme& found, double value, std::size_t sample) {
  if (found.count == 0 || value > found.largest) {
    found.largest = value;
    found.sample = sample;
  }
  ++found.count;
}

double norm(const std::array<double, 4>& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

}  // namespace

SampleFaults faults_of(const AttitudeRecord& record) {
  std::vector<double> durations, turns, norms;
  SampleFaults found{};
  for (std::size_t i = 0; i + 1 < record.size(); ++i) {
    const Eigen::Quaterniond turn =
        record.to_reference(i, record.stated).conjugate() * record.to_reference(i + 1, record.stated);
    durations.push_back((record.times[i + 1] - record.times[i]).value());
    turns.push_back(2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w())));
    if (turn.w() < 0.0) add(found.sign_flips, 0.0, i + 1);
  }
  for (const auto& q : record.numbers) norms.push_back(norm(q));
  found.median_step = median(durations);
  found.scale = median(norms);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < turns.size(); ++i) speeds.push_back(turns[i] / durations[i]);
  const double usual = median(speeds);
  constexpr double least_jump = 0.5 * std::numbers::pi / 180.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (durations[i] > 3.0 * found.median_step) add(found.gaps, durations[i], i + 1);
    if (turns[i] > 0.9 * std::numbers::pi) add(found.half_turns, turns[i], i + 1);
    if (speeds[i] > 10.0 * usual && turns[i] > least_jump) add(found.jumps, turns[i], i + 1);
  }
  constexpr double tolerance = 1e-6;
  for (std::size_t i = 0; i < norms.size(); ++i) {
    const double off = std::abs(norms[i] / found.scale - 1.0);
    if (off > tolerance) add(found.norm_errors, off, i);
  }
  return found;
}

}  // namespace vectrix::cli
