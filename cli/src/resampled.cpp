#include "resampled.hpp"

#include <algorithm>

#include "figures.hpp"
#include "quantile.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

struct Reference : inertial_frame {};
struct Body : moving_frame {};

}  // namespace

AttitudeRecord resampled(const AttitudeRecord& record, const std::vector<Epoch>& times) {
  std::vector<AttitudeSample<Reference, Body, Epoch>> samples;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const auto q = record.to_reference(i, record.stated);
    samples.push_back(
        {record.times[i],
         nearest_quaternion_scalar_first(to<Reference>, from<Body>, q.w(), q.x(), q.y(), q.z()).quaternion});
  }
  const double longest = longest_step(record, median(durations_of(record)));
  const SampledAttitude motion(samples, longest * si::second);
  AttitudeRecord at = record;
  at.has_quaternions = true;
  at.stated = {Convention::Scalar::first, Convention::Maps::to_reference};
  at.times.clear();
  at.numbers.clear();
  at.rates.clear();
  const auto add = [&](const Epoch& t, const Eigen::Quaterniond& q) {
    at.times.push_back(t);
    at.numbers.push_back({q.w(), q.x(), q.y(), q.z()});
  };
  for (const Epoch& t : times) {
    if (t < record.times.front() || record.times.back() < t) continue;
    const auto after = std::lower_bound(record.times.begin(), record.times.end(), t);
    const auto i = static_cast<std::size_t>(after - record.times.begin());
    if (record.times[i] == t) {
      add(t, record.to_reference(i, record.stated));
      continue;
    }
    if ((record.times[i] - record.times[i - 1]).value() > longest) continue;
    const double turn = angle_of(record.to_reference(i - 1, record.stated).conjugate() *
                                 record.to_reference(i, record.stated));
    if (turn > nearly_half_a_turn)
      throw BadInput(record.file + ": from " + record.times[i - 1].utc(3) + " UTC to " +
                     record.times[i].utc(3) + " UTC the attitude turns by " + shown(degrees * turn) +
                     " deg, nearly half a turn: which way is not known, and no attitude between them");
    add(t, Eigen::Quaterniond(motion(t).rotation.matrix()));
  }
  if (at.size() < 2)
    throw BadInput(record.file + ": " + counted(at.size(), "instant") + " of " +
                   counted(times.size(), "instant") +
                   " are within the samples and in no gap; at least two are needed");
  return at;
}

}  // namespace vectrix::cli
