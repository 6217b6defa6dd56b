#pragma once

#include <cstddef>
#include <vector>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// The relative pointing errors of an axis over windows of one duration.
struct RelativeErrors {
  std::vector<std::size_t> starts;  // the first sample of each window
  std::vector<double> errors;       // rad
  std::size_t left_out = 0;         // windows that reach over a gap or the end of the record
  // Of two samples with no more than a window and no gap between them.
  double largest_change = 0.0;  // rad
  std::size_t change_from = 0, change_until = 0;
};

/// The unit vectors to the target in the axes of the body, as the record is stated, from those in the axes of
/// the reference.
std::vector<Eigen::Vector3d> seen_in_body(const AttitudeRecord& record,
                                          const std::vector<Eigen::Vector3d>& directions);

/// The absolute pointing error at every sample, rad: the angle between the axis and the target.
std::vector<double> absolute_errors(const std::vector<Eigen::Vector3d>& in_body, const Eigen::Vector3d& axis);

/// The relative pointing error of each window of so many seconds that begins at a sample: how far the target,
/// as the body sees it, is at most from its mean direction over the samples of the window. The mean has no
/// weights. If it is said which samples count, those among which others stand are no windows. A window
/// without a second sample is refused, and so is a record without a window: BadInput.
RelativeErrors relative_errors(const AttitudeRecord& record, const std::vector<Eigen::Vector3d>& in_body,
                               double seconds, const std::vector<bool>& among = {});

/// The errors in windows of so many seconds one after the other, rad: of each window the angle between the
/// axis and the mean direction of the target, and of each sample of them that between the target and this
/// mean. Each sample is in one window, or in none: so all count alike. Windows, their means, and what is
/// refused, as of relative_errors().
struct WindowErrors {
  std::vector<double> of_means, from_means;
};
WindowErrors window_errors(const AttitudeRecord& record, const std::vector<Eigen::Vector3d>& in_body,
                           const Eigen::Vector3d& axis, double seconds, const std::vector<bool>& among = {});

}  // namespace vectrix::cli
