#include "resampled.hpp"

#include <algorithm>

#include "figures.hpp"
#include "quantile.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

// The first sample of the step in which an instant is, if it is in one that is no gap; the last sample is the
// end of a step.
std::optional<std::size_t> step_with(const AttitudeRecord& record, double longest, const Epoch& t) {
  const auto& times = record.times;
  if (t < times.front() || times.back() < t) return std::nullopt;
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  auto i = static_cast<std::size_t>(after - times.begin()) - 1;
  const auto is_step = [&](std::size_t k) { return !is_gap(record, k, longest); };
  if (is_step(i)) return i;
  if (times[i] == t && i > 0 && is_step(i - 1)) return i - 1;
  return std::nullopt;
}

BodyMotion in_step(const AttitudeRecord& record, std::size_t i, const Epoch& t) {
  if (record.motion) return record.motion(t);
  struct Reference : inertial_frame {};
  struct Body : moving_frame {};
  const auto quaternion = [&](std::size_t k) {
    const auto q = record.to_reference(k, record.stated);
    return nearest_quaternion_scalar_first(to<Reference>, from<Body>, q.w(), q.x(), q.y(), q.z()).quaternion;
  };
  const auto q0 = quaternion(i), q1 = quaternion(i + 1);
  const double turn = angle_of(q0.eigen().conjugate() * q1.eigen());
  if (turn > nearly_half_a_turn)
    throw BadInput(record.file + ": from " + record.times[i].utc(3) + " UTC to " +
                   record.times[i + 1].utc(3) + " UTC the attitude turns by " + shown(degrees * turn) +
                   " deg, nearly half a turn: which way is not known, and no attitude between them");
  const auto motion = Slerp(record.times[i], q0, record.times[i + 1], q1)(t);
  return {Eigen::Quaterniond(motion.rotation.matrix()), motion.angular_velocity.coordinates()};
}

// As a file of this convention has them.
std::array<double, 4> numbers_of(const Eigen::Quaterniond& to_reference, const Convention& convention) {
  const Eigen::Quaterniond q =
      convention.maps == Convention::Maps::to_reference ? to_reference : to_reference.conjugate();
  if (convention.scalar == Convention::Scalar::first) return {q.w(), q.x(), q.y(), q.z()};
  return {q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

AttitudeStep step_at(const AttitudeRecord& record, const Epoch& t) {
  const double longest = longest_step(record, median(durations_of(record)));
  const auto step = step_with(record, longest, t);
  if (!step)
    throw BadInput(record.file + ": " + t.utc() + " UTC is in a gap or outside the samples, " +
                   record.times.front().utc() + " UTC to " + record.times.back().utc() + " UTC");
  return {*step, in_step(record, *step, t)};
}

AttitudeRecord resampled(const AttitudeRecord& record, const std::vector<Epoch>& times) {
  const double longest = longest_step(record, median(durations_of(record)));
  AttitudeRecord at = record;
  at.times.clear();
  at.numbers.clear();
  at.rates.clear();
  at.derived_rates.clear();
  at.interval_starts.clear();
  for (const Epoch& t : times) {
    const auto step = step_with(record, longest, t);
    if (!step) continue;
    const auto q = in_step(record, *step, t).to_reference;
    at.times.push_back(t);
    at.numbers.push_back(numbers_of(q, record.stated));
  }
  if (at.size() < 2)
    throw BadInput(record.file + ": " + counted(at.size(), "instant") + " of " +
                   counted(times.size(), "instant") +
                   " are within the samples and in no gap; at least two are needed");
  constexpr double none_left_out = 1.5;  // steps between two instants, if they follow each other
  at.longest_step = std::max(longest, none_left_out * median(durations_of(at)));
  return at;
}

}  // namespace vectrix::cli
