#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "scenario/place.hpp"
#include "sources.hpp"
#include "target.hpp"
#include "when.hpp"

namespace vectrix::cli {

/// A frame that is fixed in another one: coordinates between `name` and `parent`.
struct FixedFrame {
  Place place;
  std::string name, parent;
  Eigen::Quaterniond parent_from_frame;
};

/// A direction fixed in a frame.
struct FixedAxis {
  Place place;
  std::string text, frame;
  Eigen::Vector3d vector;
};

struct Measure {
  Place place;
  std::string name;
  FixedAxis axis;
  Place target_place;
  MeasureTarget target;
  std::optional<SkyCorrection> correction{};  // of the Sun, the Moon and stars
  When when = When::always;                   // of the figures, and of requirements that say nothing else
};

struct Requirement {
  Place place;
  std::size_t measure;
  double degrees;  // at most; not of one that the budget limits
  double percent;
  std::optional<double> window{};  // s: of the relative error, else it is of the absolute one
  When when = When::always;
  std::string text{};  // "absolute error at most 0.5 deg in 95 % of the samples"
  bool by_budget = false;
};

/// The frame in which a contribution arises, fixed in the body; its name is known at run time.
struct ErrorFrame : moving_frame {};

/// A part of the pointing error budget of some measures.
struct Contribution {
  Place place;
  std::string name;
  std::vector<std::size_t> measures;
  Place in_place;
  std::string in, kind;
  PointingError<ErrorFrame> error;
};

/// A column of a table, and where it is named.
struct NamedColumn {
  std::filesystem::path file;
  std::string name;
  Place place;
};

/// The rates of a table as they are stated, before it is known which frames are fixed in the body.
struct StatedRates {
  Place of_place, relative_to_place, in_place;
  std::string of, relative_to, in;
};

/// A scenario file of version 1 with its words understood: a flight, what is measured of it, and what is
/// required of that.
struct Scenario {
  std::string file, title;
  std::optional<Epoch> start{}, end{};
  Place time_place{};
  std::optional<double> step{};  // s
  std::optional<EarthOrientation> orientation{};
  Place orientation_place{};
  AttitudeSource attitude{};
  std::string body{};           // as the table names it; of a message empty
  std::optional<double> gap{};  // s
  std::optional<StatedRates> rates{};
  std::optional<OrbitSource> orbit{};
  std::vector<FixedFrame> frames{};
  std::vector<Measure> measures{};
  std::vector<Requirement> requirements{};
  std::vector<Contribution> contributions{};
  std::filesystem::path report{}, csv{};        // empty if not wanted
  std::vector<std::filesystem::path> texts{};   // this file, then those that it includes
  std::vector<std::filesystem::path> inputs{};  // every file that is read, the texts first
  std::vector<NamedColumn> columns{};
  std::vector<Report::Choice> choices{};  // what it states
};

/// Throws BadInput with file, line and column: as read_scenario_table, and for words that do not go together,
/// a name that nothing has or two have, no rotation, and an axis without direction.
Scenario read_scenario(const std::filesystem::path& file);

/// Throws BadInput for the first column that its table does not have, with the nearest one.
void require_columns(const Scenario& scenario);

}  // namespace vectrix::cli
