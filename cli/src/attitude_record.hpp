#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "message_text.hpp"
#include "selection.hpp"

namespace vectrix::cli {

/// How the four numbers of a quaternion are to be taken: which of them is the scalar, and to which frame the
/// matrix R(q) of Hamilton's product takes coordinates.
struct Convention {
  enum class Scalar { first, last };
  enum class Maps { to_body, to_reference };

  Scalar scalar;
  Maps maps;
};

/// The frames in whose axes a rate of the body relative to the reference may be given.
enum class RateAxes { body, reference };
inline RateAxes other(RateAxes axes) {
  return axes == RateAxes::body ? RateAxes::reference : RateAxes::body;
}

/// q_reference^body, and the rate of the body relative to the reference in its own axes, rad/s.
struct BodyMotion {
  Eigen::Quaterniond to_reference;
  Eigen::Vector3d rate;
};

/// The attitude of a body as a file has it, with the convention that the file, or who reads it, states. The
/// frames of these numbers are what is in question, so they have none here.
struct AttitudeRecord {
  std::string file, body;
  bool names_body = false;  // the file, or its frame kernel; else `body` only tells it from the reference
  std::string reference;    // one of reference_name()
  Convention stated{};
  bool has_quaternions = true;  // else Euler angles, whose numbers have no other order
  bool are_normalised = false;  // of a kernel, where the norm does not matter
  std::vector<Epoch> times;
  std::vector<std::array<double, 4>> numbers;  // in the order of the file
  std::vector<Eigen::Vector3d> rates{};  // of the body relative to the reference; empty if there are none
  bool rates_in_degrees = false;         // per second; else rad/s
  RateAxes rate_axes = RateAxes::body;   // stated
  std::string no_rates{};                // why rates of the file are not used
  // From derivatives of the same numbers, which no reading contradicts: rad/s, in the body. And from what.
  std::vector<Eigen::Vector3d> derived_rates{};
  std::string derived_from{};
  TimeScale time_scale = scale::utc;     // in which the file has the times
  std::optional<MessageText> message{};  // of a message
  std::vector<Epoch> interval_starts{};  // of a kernel: to these samples nothing leads from the one before
  // Of a kernel, what later segments of the same time hide: "segment 1 'A' for 20 s, segment 2 'B' for 3 s".
  std::string hidden_segments{};
  // Of a kernel that has it by way of other frames: what was multiplied, and the motion between samples,
  // which is not steady; else empty.
  std::string chain{};
  std::function<BodyMotion(const Epoch&)> motion{};
  std::optional<double> longest_step{};  // s: a longer one is a gap; by default three times the median
  // By turn_to_gcrf(): the reference of the file, and at every sample its attitude; empty without it.
  std::string stated_reference{};
  std::vector<Eigen::Quaterniond> gcrf_from_stated{};

  [[nodiscard]] std::size_t size() const { return times.size(); }
  /// The quaternion that takes coordinates from the body to the reference, of norm 1.
  [[nodiscard]] Eigen::Quaterniond to_reference(std::size_t sample, const Convention& convention) const;
  /// The same to the reference of the file, relative to which its rates are.
  [[nodiscard]] Eigen::Quaterniond to_stated_reference(std::size_t sample,
                                                       const Convention& convention) const;
  [[nodiscard]] const std::string& reference_of_file() const {
    return stated_reference.empty() ? reference : stated_reference;
  }
  /// The rates in rad/s.
  [[nodiscard]] std::vector<Eigen::Vector3d> rates_in_radians() const;
};

/// The angle of the shortest turn, rad, from a quaternion of norm 1.
inline double angle_of(const Eigen::Quaterniond& turn) {
  return 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}
/// The norm of a quaternion.
inline double norm_of(const std::array<double, 4>& q) {
  return std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
}

/// The names of the columns of a table, and what its numbers mean.
struct TableColumns {
  std::string time;
  TimeScale scale = scale::utc;
  std::vector<std::string> quaternion;  // four
  Convention stated{};
  std::string reference;
  std::vector<std::string> rates;  // three, or none
  bool rates_in_degrees = false;
  RateAxes rate_axes = RateAxes::body;
};

/// Throws BadInput with file, line and column for what is no number, no time, a quaternion of zeros, fewer
/// than two samples, and times that do not increase.
AttitudeRecord read_table(const std::filesystem::path& file, const TableColumns& columns);

/// The selected segment of an attitude ephemeris message, with all its samples.
/// Throws BadInput as the message does, for a segment that the file does not have, and unless one frame is of
/// reference_name() and the other is not.
AttitudeRecord read_message(const std::filesystem::path& file, const Selection& selection);

}  // namespace vectrix::cli
