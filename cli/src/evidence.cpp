#include "evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "quantile.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double decisive = 3.0;     // a disagreement so many times smaller decides
constexpr double negligible = 1e-3;  // so small a part of the largest that fits decides nothing

double angle_of(const Quaterniond& q) {
  return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w()));
}
Quaterniond turned(const Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
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
  std::vector<double> durations;
  for (std::size_t i = 0; i + 1 < record.size(); ++i)
    durations.push_back((record.times[i + 1] - record.times[i]).value());
  const double longest = longest_step(median(durations));
  std::vector<Step> steps;
  for (std::size_t i = 0; i < durations.size(); ++i)
    if (durations[i] <= longest) steps.push_back({i, durations[i]});
  return steps;
}

// rad/s rms. The rates are of the body relative to the reference, in the axes of one of them.
double rate_difference(const std::vector<Quaterniond>& q, const std::vector<Step>& steps,
                       const std::vector<Vector3d>& rates, RateAxes axes) {
  double sum = 0.0;
  for (const auto& [i, duration] : steps) {
    const Quaterniond by_rate = turned(0.5 * duration * (rates[i] + rates[i + 1]));
    const Quaterniond turn =
        axes == RateAxes::body ? q[i].conjugate() * q[i + 1] : q[i + 1] * q[i].conjugate();
    const double difference = angle_of(turn.conjugate() * by_rate) / duration;
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(steps.size()));
}

RateAxes other(RateAxes axes) {
  return axes == RateAxes::body ? RateAxes::reference : RateAxes::body;
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
  const std::vector<Vector3d> none(record.size(), Vector3d::Zero());
  RateEvidence evidence{{},
                        {},
                        rms_of(rates),
                        rate_difference(to_reference(record, all_readings[0]), steps, none, RateAxes::body)};
  for (const Reading& reading : readings_of(record)) {
    const auto q = to_reference(record, reading);
    evidence.stated_axes.push_back(rate_difference(q, steps, rates, record.rate_axes));
    evidence.other_axes.push_back(rate_difference(q, steps, rates, other(record.rate_axes)));
  }
  return evidence;
}

std::vector<RatesInOtherAxes> rates_in_other_axes(const AttitudeRecord& record) {
  const auto steps = steps_of(record);
  const auto given = record.rates_in_radians();
  std::vector<RatesInOtherAxes> tried;
  for (const Reading& reading : all_readings) {
    if (reading.other_order) continue;
    const auto q = to_reference(record, reading);
    for (const SignedAxes& axes : all_axes()) {
      std::vector<Vector3d> rates;
      for (const Vector3d& w : given) rates.push_back(in_body(axes, w));
      tried.push_back({reading, axes, rate_difference(q, steps, rates, RateAxes::body)});
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
    const auto q = to_reference(record, reading);
    double sum = 0.0;
    for (const auto& [i, duration] : steps) {
      const Quaterniond before = lvlh_from_reference[i] * q[i], after = lvlh_from_reference[i + 1] * q[i + 1];
      const double rate = angle_of(before.conjugate() * after) / duration;
      sum += rate * rate;
    }
    found.push_back(std::sqrt(sum / static_cast<double>(steps.size())));
  }
  return found;
}

std::vector<double> off_target(const AttitudeRecord& record, const Vector3d& axis, Target target,
                               const FlownOrbit& orbit) {
  const auto to_target = directions(record, target, geometric, orbit);
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
