#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// What a report shows, as data. Seconds count from `start`; a value that is not there, as in a gap, is NaN.
struct Report {
  struct Fact {
    std::string name, value;
  };
  /// One requirement.
  struct Verdict {
    std::string what;      // "angle between -z of radiometer and the Sun"
    std::string required;  // "at most 0.5 deg in 95 % of the samples"
    std::string reached;   // "0.353994 deg"
    std::string margin;    // "0.146006 deg"
    bool fulfilled;
  };
  struct Curve {
    std::string name;  // "off-Sun"
    std::vector<double> values;
  };
  struct Limit {
    double value;
    std::string name;
  };
  /// Curves of one unit over one time.
  struct Plot {
    std::string title, unit, axes;  // axes: the frame in which components are; empty for scalars
    std::vector<double> seconds;
    std::vector<Curve> curves;
    std::vector<Limit> limits{};
  };
  /// A table of figures: a heading of each column, and rows of as many texts.
  struct Table {
    std::string title;
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
  };
  /// A frame fixed in the body: coordinates from it to the body.
  struct BodyFrame {
    std::string name;
    Eigen::Quaterniond body_from_frame;
  };
  /// An axis of the body that is to look somewhere, by its unit vector in the axes of the body.
  struct BodyAxis {
    std::string name;
    Eigen::Vector3d axis;
  };
  /// A unit vector along the axes of the reference at each time of the scene.
  struct Direction {
    std::string name;  // "Sun"
    std::vector<Eigen::Vector3d> vectors;
  };
  /// Another frame to look from: coordinates from the reference to it, at each time of the scene.
  struct View {
    std::string name;  // "LVLH"
    std::vector<Eigen::Quaterniond> from_reference;
  };
  struct Scene {
    std::string body, reference;
    std::vector<double> seconds;
    std::vector<Eigen::Quaterniond> reference_from_body;
    std::vector<BodyFrame> frames{};
    std::vector<BodyAxis> axes{};
    std::vector<Direction> directions{};
    std::vector<View> views{};
    std::vector<Eigen::Vector3d> positions{};  // m, along the axes of the reference; empty without an orbit
    std::vector<Eigen::Vector2d> ground_track{};  // geodetic latitude, longitude, deg; empty without an orbit
  };
  struct Input {
    std::string path;
    std::uintmax_t bytes;
    std::string sha256;
  };
  /// A convention, and who stated it: the file, or the line of the scenario.
  struct Choice {
    std::string what, value, by;
  };

  std::string title;
  Epoch start;
  std::vector<Fact> facts{};  // what was asked
  std::vector<Verdict> verdicts{};
  std::vector<Plot> plots{};
  std::vector<Table> tables{};
  std::optional<Scene> scene{};
  std::vector<Input> inputs{};
  std::vector<Choice> choices{};
  std::string version;  // of the program
};

/// One HTML page that needs no network: its script, style and data are in it. Curves in it have single
/// precision, and of long ones it keeps the extremes of equal parts, so that a page stays below 5 MB. Throws
/// BadInput for tables whose rows differ in length, values that are not as many as their times, times that do
/// not increase, an infinity, curves beyond 1e37, quaternions and directions whose norm is not 1 to 1e-6, and
/// places that are not on the Earth.
std::string html(const Report& report);

}  // namespace vectrix::cli
