#pragma once

#include <string>
#include <vector>

#include "target.hpp"

namespace vectrix::cli {

/// What the options say of a target, and of what should look at it. Empty: not given.
struct TargetWords {
  std::string axis{}, target{};
  std::string right_ascension{}, declination{};  // of a star, degrees
  // How it moves: "-798.58,10328.12", milliarcsec in a Julian year, "included" or "not_included",
  // milliarcsec.
  std::string proper_motion{}, cos_declination{}, epoch{}, parallax{};
  std::string latitude{}, longitude{}, height{};  // of a station, degrees and metres
};

/// "sun", and other targets that need no more words.
std::vector<std::string> plain_target_names();
/// Those, "star" and "station".
std::vector<std::string> target_names();

/// The components of --axis. Throws BadInput unless they are three numbers.
Eigen::Vector3d axis_of(const std::string& text);
/// Of --target. Throws BadInput for options of a star or a station that are missing or of no use, and for
/// what is no such angle or height.
MeasureTarget target_of(const TargetWords& words);

}  // namespace vectrix::cli
