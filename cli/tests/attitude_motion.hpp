#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// A body that turns at a constant rate about one axis, and with it about another: q(t) = exp(a t) exp(b t)
/// takes coordinates to the reference, with the rate b + R(exp(b t))^T a in the body.
struct AttitudeMotion {
  Eigen::Vector3d a, b;  // rad/s

  static Eigen::Quaterniond turned(const Eigen::Vector3d& by) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(by.norm(), by.normalized()));
  }
  [[nodiscard]] Eigen::Quaterniond to_reference(double t) const { return turned(t * a) * turned(t * b); }
  [[nodiscard]] Eigen::Vector3d rate_in_body(double t) const { return b + turned(t * b).conjugate() * a; }

  /// Samples each second, written by one convention and stated to be of another.
  [[nodiscard]] AttitudeRecord record(std::size_t count, const Convention& written, const Convention& stated,
                                      RateAxes written_axes, RateAxes stated_axes) const {
    AttitudeRecord record;
    record.file = "motion";
    record.body = "the body";
    record.reference = "GCRF";
    record.stated = stated;
    record.rate_axes = stated_axes;
    for (std::size_t i = 0; i < count; ++i) {
      const auto t = static_cast<double>(i);
      const Eigen::Quaterniond to = to_reference(t);
      const Eigen::Quaterniond q = written.maps == Convention::Maps::to_reference ? to : to.conjugate();
      record.times.push_back(Epoch::from_utc("2026-11-29T00:00:00") + t * si::second);
      if (written.scalar == Convention::Scalar::first) {
        record.numbers.push_back({q.w(), q.x(), q.y(), q.z()});
      } else {
        record.numbers.push_back({q.x(), q.y(), q.z(), q.w()});
      }
      const Eigen::Vector3d w = rate_in_body(t);
      record.rates.emplace_back(written_axes == RateAxes::body ? w : to * w);
    }
    return record;
  }
};

}  // namespace vectrix::cli
