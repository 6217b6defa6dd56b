#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

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

/// The attitude of a body as a file has it, with the convention that the file, or who reads it, states. The
/// frames of these numbers are what is in question, so they have none here.
struct AttitudeRecord {
  std::string file, body;
  std::string reference;  // EME2000 or GCRF
  Convention stated{};
  bool has_quaternions = true;  // else Euler angles, whose numbers have no other order
  std::vector<Epoch> times;
  std::vector<std::array<double, 4>> numbers;  // in the order of the file
  std::vector<Eigen::Vector3d> rates;          // rad/s; empty if there are none
  RateAxes rate_axes = RateAxes::body;         // stated
  std::string no_rates{};                      // why rates of the file are not used

  [[nodiscard]] std::size_t size() const { return times.size(); }
  /// The quaternion that takes coordinates from the body to the reference, of norm 1.
  [[nodiscard]] Eigen::Quaterniond to_reference(std::size_t sample, const Convention& convention) const;
};

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

/// The segment of an attitude ephemeris message, counted from 1. Throws BadInput as the message does, for a
/// segment that the file does not have, and if neither frame is EME2000 or GCRF.
AttitudeRecord read_message(const std::filesystem::path& file, std::size_t segment);

}  // namespace vectrix::cli
