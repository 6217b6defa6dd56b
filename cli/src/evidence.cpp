#include "evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "earth_frame.hpp"
#include "quantile.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double decisive = 3.0;     // a disagreement so many times smaller decides
constexpr double negligible = 1e-3;  // so small a part of the largest that fits decides nothing

struct Before : moving_frame {};
struct After : moving_frame {};
Quaterniond turned(const Vector3d& rotation_vector) {
  return exp_quaternion(vectrix::rotation_vector(of<After>, relative_to<Before>,
                                                 vector<si::angle>(in<Before>, rotation_vector)))
      .eigen();
}

// Relative to the reference of the file, as its rates are.
std::vector<Quaterniond> to_stated_reference(const AttitudeRecord& record, const Reading& reading) {
  std::vector<Quaterniond> all;
  for (std::size_t i = 0; i < record.size(); ++i)
    all.push_back(record.to_stated_reference(i, reading.of(record.stated)));
  return all;
}
std::vector<Quaterniond> to_reference(const AttitudeRecord& record, const Reading& reading) {
  std::vector<Quaterniond> all;
  for (std::size_t i = 0; i < record.size(); ++i)
    all.push_back(record.to_reference(i, reading.of(record.stated)));
  return all;
}

// The steps between samples that are no gaps: the first sample of each, and its duration in s.
struct Step {
  std::size_t first;
  double duration;
};
std::vector<Step> steps_of(const AttitudeRecord& record) {
  const auto durations = durations_of(record);
  const double longest = longest_step(record, median(durations));
  std::vector<Step> steps;
  for (std::size_t i = 0; i < durations.size(); ++i)
    if (!is_gap(record, i, longest)) steps.push_back({i, durations[i]});
  return steps;
}

// The turn of each step, by the attitude at its ends, in the axes of one of the frames.
std::vector<Quaterniond> turns_of(const std::vector<Quaterniond>& q, const std::vector<Step>& steps,
                                  RateAxes axes) {
  std::vector<Quaterniond> turns;
  for (const auto& [i, duration] : steps)
    turns.push_back(axes == RateAxes::body ? q[i].conjugate() * q[i + 1] : q[i + 1] * q[i].conjugate());
  return turns;
}
// By the mean of the rates at its ends.
std::vector<Quaterniond> turns_by(const std::vector<Vector3d>& rates, const std::vector<Step>& steps) {
  std::vector<Quaterniond> turns;
  for (const auto& [i, duration] : steps) turns.push_back(turned(0.5 * duration * (rates[i] + rates[i + 1])));
  return turns;
}

// rad/s rms, of the turn of every step.
template <class Turn> double rms_rate(const std::vector<Step>& steps, const Turn& turn) {
  double sum = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double rate = angle_of(turn(k)) / steps[k].duration;
    sum += rate * rate;
  }
  return std::sqrt(sum / static_cast<double>(steps.size()));
}
double rms_difference(const std::vector<Step>& steps, const std::vector<Quaterniond>& some,
                      const std::vector<Quaterniond>& others) {
  return rms_rate(steps, [&](std::size_t k) { return some[k].conjugate() * others[k]; });
}

double rms_beyond_change(const std::vector<Step>& steps, const std::vector<Quaterniond>& turns,
                         const std::vector<Quaterniond>& by_rates, const std::vector<Vector3d>& rates) {
  double sum = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto [i, duration] = steps[k];
    const double change = (rates[i + 1] - rates[i]).norm(),
                 beyond = angle_of(turns[k].conjugate() * by_rates[k]) / duration - 0.5 * change;
    if (beyond > 0.0) sum += beyond * beyond;
  }
  return std::sqrt(sum / static_cast<double>(steps.size()));
}

// An error of one attitude is in two steps that follow each other, with both signs, and in no others. What
// differences further apart have in common is none: of errors alone the mean of so many products of two of
// three numbers each is within 0.7 of the mean square over their root, one in three times.
double rms_lasting(const std::vector<Step>& steps, const std::vector<Quaterniond>& turns,
                   const std::vector<Quaterniond>& by_rates) {
  constexpr std::size_t first_lag = 2, last_lag = 8, least_count = 30;
  constexpr double of_chance = 0.7, sure = 5.0;
  std::vector<Vector3d> left;
  double square = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Eigen::AngleAxisd turn(turns[k].conjugate() * by_rates[k]);
    const double angle = std::remainder(turn.angle(), 2.0 * std::numbers::pi);
    left.emplace_back(angle / steps[k].duration * turn.axis());
    square += left.back().squaredNorm() / static_cast<double>(steps.size());
  }
  double lasting = 0.0;
  for (std::size_t lag = first_lag; lag <= last_lag; ++lag) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t k = 0; k + lag < steps.size(); ++k) {
      if (steps[k + lag].first != steps[k].first + lag) continue;  // a gap is between them
      sum += left[k].dot(left[k + lag]);
      ++count;
    }
    if (count < least_count) return std::sqrt(square);
    // One that turns with the body points as before over one of the lags.
    const double common = sum / static_cast<double>(count);
    if (common > sure * of_chance * square / std::sqrt(static_cast<double>(count)))
      lasting = std::max(lasting, common);
  }
  return std::sqrt(lasting);
}

double rms_of(const std::vector<Vector3d>& rates) {
  double sum = 0.0;
  for (const Vector3d& w : rates) sum += w.squaredNorm();
  return std::sqrt(sum / static_cast<double>(rates.size()));
}

Vector3d in_body(const SignedAxes& axes, const Vector3d& w) {
  Vector3d turned = Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    turned[std::abs(axes[i]) - 1] = std::copysign(1.0, axes[i]) * w[static_cast<Eigen::Index>(i)];
  return turned;
}

std::vector<SignedAxes> all_axes() {
  std::vector<SignedAxes> all;
  std::array<int, 3> order{1, 2, 3};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      SignedAxes axes = order;
      for (std::size_t i = 0; i < 3; ++i)
        if ((signs >> i & 1) != 0) axes[i] = -axes[i];
      all.push_back(axes);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

}  // namespace

RateEvidence compare_rates(const AttitudeRecord& record) {
  const auto steps = steps_of(record);
  const auto rates = record.rates_in_radians();
  RateEvidence evidence{{}, {}, rms_of(rates), 0.0};
  if (!std::isfinite(evidence.rms_rate))
    throw BadInput(record.file + ": the rates are too large, " + detail::text(evidence.rms_rate) +
                   " rad/s rms");
  evidence.least_beyond_change = evidence.least_lasting = std::numeric_limits<double>::infinity();
  const auto by_rates = turns_by(rates, steps);
  const auto difference = [&](const std::vector<Quaterniond>& q, RateAxes axes) {
    const auto turns = turns_of(q, steps, axes);
    evidence.least_beyond_change =
        std::min(evidence.least_beyond_change, rms_beyond_change(steps, turns, by_rates, rates));
    evidence.least_lasting = std::min(evidence.least_lasting, rms_lasting(steps, turns, by_rates));
    return rms_difference(steps, turns, by_rates);
  };
  for (const Reading& reading : readings_of(record)) {
    const auto q = to_stated_reference(record, reading);
    if (evidence.stated_axes.empty()) {
      const auto turns = turns_of(q, steps, record.rate_axes);
      evidence.rms_turn = rms_rate(steps, [&](std::size_t k) { return turns[k]; });
    }
    evidence.stated_axes.push_back(difference(q, record.rate_axes));
    evidence.other_axes.push_back(difference(q, other(record.rate_axes)));
    if (record.gcrf_from_stated.empty() || is_slow(record.stated_reference)) continue;
    const auto of_gcrf = to_reference(record, reading);
    evidence.of_gcrf_in_body.push_back(difference(of_gcrf, RateAxes::body));
    evidence.of_gcrf_in_gcrf.push_back(difference(of_gcrf, RateAxes::reference));
  }
  return evidence;
}

std::vector<RatesInOtherAxes> rates_in_other_axes(const AttitudeRecord& record) {
  const auto steps = steps_of(record);
  const auto by_rates = turns_by(record.rates_in_radians(), steps);
  std::vector<RatesInOtherAxes> tried;
  for (const Reading& reading : all_readings) {
    if (reading.other_order) continue;
    const auto turns = turns_of(to_stated_reference(record, reading), steps, RateAxes::body);
    for (const SignedAxes& axes : all_axes()) {
      const double difference = rms_rate(steps, [&](std::size_t k) {
        const Vector3d v = in_body(axes, by_rates[k].vec());
        return turns[k].conjugate() * Quaterniond(by_rates[k].w(), v.x(), v.y(), v.z());
      });
      tried.push_back({reading, axes, difference});
    }
  }
  std::sort(tried.begin(), tried.end(),
            [](const auto& a, const auto& b) { return a.difference < b.difference; });
  return tried;
}

std::vector<double> steadiness(const AttitudeRecord& record, const FlownOrbit& orbit) {
  struct Lvlh : moving_frame {};
  const Eigen::Matrix3d R_gcrf_from_reference = gcrf_from(record.reference);
  std::vector<Quaterniond> lvlh_from_reference;
  for (const Epoch& t : record.times) {
    const auto [r, v] = orbit(t);
    lvlh_from_reference.emplace_back(
        Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix().transpose() * R_gcrf_from_reference));
  }
  const auto steps = steps_of(record);
  std::vector<double> found;
  for (const Reading& reading : readings_of(record)) {
    auto q = to_reference(record, reading);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = lvlh_from_reference[i] * q[i];
    const auto turns = turns_of(q, steps, RateAxes::body);
    found.push_back(rms_rate(steps, [&](std::size_t k) { return turns[k]; }));
  }
  return found;
}

std::vector<double> off_target(const AttitudeRecord& record, const Vector3d& axis, Target target,
                               const FlownOrbit& orbit) {
  return off_directions(record, axis, directions(record, target, geometric, orbit));
}

std::vector<double> off_directions(const AttitudeRecord& record, const Vector3d& axis,
                                   const std::vector<Vector3d>& to_target) {
  std::vector<double> found;
  for (const Reading& reading : readings_of(record)) {
    const auto q = to_reference(record, reading);
    std::vector<double> angles;
    for (std::size_t i = 0; i < record.size(); ++i)
      angles.push_back(angle_between(q[i] * axis, to_target[i]));
    found.push_back(median(angles));
  }
  return found;
}

std::vector<std::size_t> fitting(const std::vector<double>& disagreements, double largest) {
  const double best = *std::min_element(disagreements.begin(), disagreements.end());
  const double limit = std::max(decisive * best, negligible * largest);
  std::vector<std::size_t> fit;
  for (std::size_t i = 0; i < disagreements.size(); ++i)
    if (best <= largest && disagreements[i] <= limit) fit.push_back(i);
  return fit;
}

}  // namespace vectrix::cli
