#pragma once

#include <array>
#include <string>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// An attitude in one convention: the scalar first, R(q) takes coordinates from the body to the reference.
struct PlainAttitude {
  std::string body, reference;
  TimeScale time_scale = scale::utc;
  std::vector<Epoch> times{};
  std::vector<std::array<double, 4>> quaternions{};  // of any norm
  std::vector<Eigen::Vector3d> rates{};  // of the body relative to the reference; empty if there are none
  bool rates_in_degrees = false;
  RateAxes rate_axes = RateAxes::body;
  std::vector<std::string> computed{};  // which numbers are not those of the file, and why
};

/// The numbers of the record, only in another order and with other signs.
PlainAttitude plain(const AttitudeRecord& record);
/// Relative to EME2000 or GCRF instead. Throws BadInput unless it is relative to one of them.
PlainAttitude relative_to_frame(PlainAttitude attitude, const std::string& reference);
/// Relative to another frame of earth_frame_name() instead, also its rates. Throws BadInput, which begins
/// with the file, as earth_frame().
PlainAttitude turned(PlainAttitude attitude, const std::string& reference,
                     const std::optional<EarthOrientation>& orientation, const std::string& file);
/// As a message can have it: quaternions of norm 1 within a hundredth, and rates in degrees. If one
/// quaternion is not so, all are divided by their norms.
PlainAttitude as_in_a_message(PlainAttitude attitude);

}  // namespace vectrix::cli
