#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "scenario/scenario.hpp"
#include "target.hpp"

namespace vectrix::cli {

/// What a replay found, as numbers and texts: enough for its report, without the files of the flight.
struct Result {
  /// Of the body relative to the reference.
  struct Attitude {
    std::vector<Epoch> times;
    std::vector<Eigen::Quaterniond> reference_from_body;  // of norm 1, the sign without jumps
    std::vector<Eigen::Vector3d> rates;                   // rad/s in the body; empty if there are none
    double longest_step;                                  // s: a longer one is a gap
  };
  /// At every time of the attitude.
  struct Orbit {
    std::vector<SatelliteMotion> motions;
    std::vector<double> visible_sun;            // 1: all of it, 0: none
    std::vector<Eigen::Vector2d> ground_track;  // geodetic latitude, longitude, deg
  };
  /// At every time of the attitude.
  struct Angles {
    std::string name, what;    // "off-Sun", "angle between -z of radiometer and the Sun, geometric, ..."
    std::string axis, target;  // "-z of radiometer", "the Sun"
    Eigen::Vector3d axis_in_body;
    std::vector<double> degrees;
    std::vector<Eigen::Vector3d> directions;  // of the target, along the axes of the reference
    std::vector<bool> hidden{};               // by the Earth; empty if it cannot be
  };
  struct Verdict {
    std::size_t measure;
    double required, percent, window;  // deg, %, s; 0: no window, of the absolute error
    When when;
    double reached, margin;      // deg
    std::size_t within, judged;  // how many of how many are at most `required`
    bool fulfilled;
  };
  struct ScenarioText {
    std::string path, text;
  };

  Report texts;  // without plots and scene
  std::string body, reference;
  Attitude attitude;  // at the instants that are looked at
  Attitude samples;   // of the file, from the one before these to the one after
  std::optional<Orbit> orbit{};
  std::vector<Report::BodyFrame> frames{};
  std::vector<Angles> measures{};
  std::vector<Verdict> verdicts{};       // as those of the texts
  std::vector<ScenarioText> scenario{};  // the file itself first, then those that it includes
};

/// The steps of an attitude that are gaps, by the samples at which they begin.
std::vector<std::size_t> gaps_of(const Result::Attitude& attitude);

/// What is shown of it: the texts, with plots and scene.
Report report_of(const Result& result);

}  // namespace vectrix::cli
