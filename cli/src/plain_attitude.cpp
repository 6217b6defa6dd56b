#include "plain_attitude.hpp"

#include <algorithm>
#include <cmath>

#include "earth_frame.hpp"
#include "figures.hpp"

namespace vectrix::cli {
namespace {

bool is_far_from_unit(const std::array<double, 4>& q) {
  constexpr double most = 0.01;  // a message with more is not read
  return !(std::abs(norm_of(q) - 1.0) <= most);
}

// Of a record that is turned to GCRF.
PlainAttitude plain_turned(const AttitudeRecord& record) {
  PlainAttitude attitude{record.body, record.reference, record.time_scale, record.times};
  for (std::size_t i = 0; i < record.size(); ++i) {
    const Eigen::Quaterniond q = record.to_reference(i, record.stated);
    attitude.quaternions.push_back({q.w(), q.x(), q.y(), q.z()});
  }
  attitude.computed.push_back("the attitude is turned from " + record.stated_reference + " to " +
                              record.reference);
  if (!record.rates.empty() || !record.derived_rates.empty() || !record.no_rates.empty())
    attitude.computed.push_back("the rates, relative to " + record.stated_reference + ", are left out");
  return attitude;
}

}  // namespace

PlainAttitude plain(const AttitudeRecord& record) {
  if (!record.stated_reference.empty()) return plain_turned(record);
  const bool are_derived = !record.derived_rates.empty();
  if (!record.no_rates.empty() && !are_derived)
    throw BadInput(record.file + ": " + record.no_rates + " They would be lost");
  PlainAttitude attitude{record.body,
                         record.reference,
                         record.time_scale,
                         record.times,
                         {},
                         are_derived ? record.derived_rates : record.rates};
  attitude.rates_in_degrees = !are_derived && record.rates_in_degrees;
  attitude.rate_axes = are_derived ? RateAxes::body : record.rate_axes;
  if (are_derived) attitude.computed.push_back("the rates are computed from " + record.derived_from);
  for (Eigen::Vector3d& w : attitude.rates) w.array() += 0.0;
  if (!record.has_quaternions)
    attitude.computed.emplace_back("the quaternions are computed from Euler angles");
  if (record.are_normalised)
    attitude.computed.emplace_back(
        "the quaternions are divided by their norms, and the times computed from ticks");
  const bool first = record.stated.scalar == Convention::Scalar::first;
  const double sign = record.stated.maps == Convention::Maps::to_reference ? 1.0 : -1.0;
  for (const auto& n : record.numbers) {
    const std::array<double, 4> q = first ? n : std::array{n[3], n[0], n[1], n[2]};
    // + 0.0: no -0
    attitude.quaternions.push_back({q[0], sign * q[1] + 0.0, sign * q[2] + 0.0, sign * q[3] + 0.0});
  }
  return attitude;
}

PlainAttitude relative_to_frame(PlainAttitude attitude, const std::string& reference) {
  if (reference == attitude.reference) return attitude;
  if (!inertial(attitude.reference))
    throw BadInput("the attitude is relative to " + attitude.reference + ", and has to be relative to " +
                   reference + "; --frame " + reference + " turns it");
  return turned(std::move(attitude), reference, std::nullopt, "");
}

PlainAttitude turned(PlainAttitude attitude, const std::string& reference,
                     const std::optional<EarthOrientation>& orientation, const std::string& file) {
  if (reference == attitude.reference) return attitude;
  const auto turn =
      turn_of_axes(attitude.reference, reference, from_until(attitude.times.front(), attitude.times.back()),
                   orientation, file);
  const double unit = attitude.rates_in_degrees ? degrees : 1.0;
  const bool in_body = attitude.rate_axes == RateAxes::body;
  Eigen::Quaterniond q_new_from_old = Eigen::Quaterniond::Identity();  // from one to the next of one sign
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    const auto new_from_old = turn(attitude.times[i]);
    auto& n = attitude.quaternions[i];
    const Eigen::Quaterniond q_old_from_body(n[0], n[1], n[2], n[3]);
    Eigen::Quaterniond next(new_from_old.rotation.matrix());
    if (next.dot(q_new_from_old) < 0.0) next.coeffs() *= -1.0;
    q_new_from_old = next;
    const Eigen::Quaterniond q = q_new_from_old * q_old_from_body;
    n = {q.w(), q.x(), q.y(), q.z()};
    if (attitude.rates.empty()) continue;
    // Of the old axes relative to the new ones, and of the body relative to the old ones.
    const Eigen::Vector3d &w_axes = new_from_old.angular_velocity.coordinates(), &w = attitude.rates[i];
    attitude.rates[i] = in_body
                            ? Eigen::Vector3d(w + q_old_from_body.normalized().conjugate() * (unit * w_axes))
                            : Eigen::Vector3d(new_from_old.rotation.matrix() * (w + unit * w_axes));
  }
  attitude.computed.push_back("the attitude is turned from " + attitude.reference + " to " + reference);
  attitude.reference = reference;
  return attitude;
}

PlainAttitude as_in_a_message(PlainAttitude attitude) {
  if (std::any_of(attitude.quaternions.begin(), attitude.quaternions.end(), is_far_from_unit)) {
    attitude.computed.push_back("the quaternions, the first of norm " +
                                shown(norm_of(attitude.quaternions.front())) +
                                ", are divided by their norms");
    for (auto& q : attitude.quaternions) {
      const double length = norm_of(q);
      for (double& number : q) number /= length;
    }
  }
  if (!attitude.rates.empty() && !attitude.rates_in_degrees) {
    attitude.computed.emplace_back("the rates are converted from rad/s to deg/s");
    for (Eigen::Vector3d& w : attitude.rates) w *= degrees;
    attitude.rates_in_degrees = true;
  }
  return attitude;
}

}  // namespace vectrix::cli
