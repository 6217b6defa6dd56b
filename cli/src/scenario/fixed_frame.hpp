#pragma once

#include <string>
#include <vector>

#include "scenario/scenario.hpp"
#include "scenario/table.hpp"

namespace vectrix::cli {

/// Of a [[frame]]. Throws BadInput with file, line and column for no rotation, and maps that do not name the
/// frame.
FixedFrame fixed_frame(const ScenarioTable& from);
/// How it is stated: "v_body = R(q) v_radiometer, the scalar is first".
std::string stated_frame(const ScenarioTable& from);
/// Of "-z of body" or "[0, 0.1, 1] of body".
FixedAxis fixed_axis(const ScenarioValue& from);

/// The frames that are fixed in a body, the body first: coordinates from them to the body.
class BodyFrames {
 public:
  /// Throws BadInput for two frames of one name, and for a frame that hangs on none that is fixed in the
  /// body.
  BodyFrames(const std::string& body, const std::vector<FixedFrame>& frames);

  [[nodiscard]] const std::vector<Report::BodyFrame>& all() const { return frames_; }
  /// Throws BadInput at the place, with the nearest name.
  [[nodiscard]] const Eigen::Quaterniond& body_from(const std::string& frame, const Place& place) const;
  /// The unit vector in the axes of the body.
  [[nodiscard]] Eigen::Vector3d in_body(const FixedAxis& axis) const;

 private:
  [[nodiscard]] const Report::BodyFrame* find(const std::string& name) const;
  std::vector<Report::BodyFrame> frames_;
};

}  // namespace vectrix::cli
