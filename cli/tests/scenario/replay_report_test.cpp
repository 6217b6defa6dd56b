#include "scenario/replay_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "figures.hpp"
#include "replayed.hpp"
#include "says.hpp"

namespace vectrix::cli::replay_report_test {
namespace {

using Eigen::Vector3d;

TEST(Replay, SeesTheGyrosOfSentinel1AgreeWithItsTurns) {
  const auto report = replayed(example("sentinel1.toml")).report();
  ASSERT_EQ(report.plots.size(), 4U);
  const Report::Plot& differences = report.plots[3];
  EXPECT_EQ(differences.unit, "deg/s");
  EXPECT_EQ(differences.axes, "quaternion axes");
  double sum = 0.0;
  for (const auto& curve : differences.curves) {
    ASSERT_EQ(curve.values.size(), differences.seconds.size());
    EXPECT_TRUE(std::isnan(curve.values.back()));  // no turn follows it
    for (std::size_t i = 0; i + 1 < curve.values.size(); ++i) sum += std::pow(curve.values[i] / degrees, 2);
  }
  constexpr double published = 2e-6;  // rad/s rms
  EXPECT_LE(std::sqrt(sum / static_cast<double>(differences.seconds.size() - 1)), published);
}

TEST(Replay, FillsAReport) {
  const auto found = replayed(example("ctim.toml"));
  const Report report = found.report();
  EXPECT_EQ(report.title, "CTIM, 20 April 2023: is the radiometer on the Sun?");
  EXPECT_EQ(report.start, Epoch::from_utc("2023-04-20T05:20:10"));
  EXPECT_EQ(report.verdicts.size(), 2U);
  ASSERT_EQ(report.plots.size(), 3U);
  EXPECT_EQ(report.plots[0].limits.at(0).value, 0.36);
  EXPECT_EQ(report.plots[0].limits.at(0).name, "off-Sun at most 0.36 deg");
  // The samples around the instants, each 10 s at 9.001 s of it.
  EXPECT_NEAR(report.plots[2].seconds.front(), -0.999, 1e-9);
  EXPECT_NEAR(report.plots[2].seconds.back(), 2999.001, 1e-9);
  for (const auto& plot : report.plots) {
    for (const auto& curve : plot.curves) EXPECT_EQ(curve.values.size(), plot.seconds.size());
    for (std::size_t i = 1; i < plot.seconds.size(); ++i) EXPECT_GT(plot.seconds[i], plot.seconds[i - 1]);
  }
  // The angle between the axis and the direction of the scene is that of the measure.
  const auto& scene = report.scene.value();
  ASSERT_EQ(scene.seconds.size(), found.flight.attitude.size());
  constexpr double rounding = 1e-14;
  for (std::size_t i = 0; i < scene.seconds.size(); i += 50) {
    const Vector3d axis = scene.reference_from_body[i] * scene.axes.at(0).axis;
    EXPECT_NEAR(angle_between(axis, scene.directions.at(0).vectors[i]), found.measures[0].angles[i],
                rounding);
    // LVLH has the Earth along z, and a low orbit its velocity nearly along x.
    const Vector3d down = scene.views.at(0).from_reference[i] * -scene.positions[i].normalized();
    EXPECT_LE((down - Vector3d::UnitZ()).norm(), rounding);
    EXPECT_LE(std::abs(scene.ground_track[i].x()), 53.3);  // its inclination is 53 deg
  }
  EXPECT_EQ(scene.frames.at(0).name, "radiometer");
  EXPECT_EQ(report.inputs.size(), 3U);
  for (const auto& input : report.inputs)
    EXPECT_EQ(input.bytes, input.path.find("s.toml") != std::string::npos
                               ? example("ctim.toml").size()
                               : std::filesystem::file_size(input.path));
  bool is_said = false;
  for (const auto& choice : report.choices)
    is_said = is_said || (choice.value == "v_body = R(q) v_ICRF, the scalar is first" &&
                          choice.by.find("s.toml:") != std::string::npos);
  EXPECT_TRUE(is_said);
  EXPECT_TRUE(replayed(example("ctim.toml")).report().tables.at(0).rows.at(0).size() ==
              report.tables[0].headings.size());
}

TEST(Replay, InterruptsCurvesInGaps) {
  const std::string whole = with(
      example("ctim.toml"), "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z\nstep = \"10 s\"", "");
  const auto gaps = [&](const std::string& text) {
    const auto plot = replayed(text).report().plots[0];
    std::size_t count = 0;
    for (const double value : plot.curves[0].values) count += std::isnan(value) ? 1U : 0U;
    return count;
  };
  EXPECT_EQ(gaps(whole), 0U);
  EXPECT_EQ(gaps(with(whole, "gap = \"30 s\"", "gap = \"15 s\"")), 27U);  // steps of 20 and 30 s
}

// Between the two samples of a gap nothing of the scene is there.
TEST(Replay, InterruptsTheSceneInGaps) {
  const std::string whole = with(
      example("ctim.toml"), "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z\nstep = \"10 s\"", "");
  const auto found = replayed(with(whole, "gap = \"30 s\"", "gap = \"15 s\""));
  const Report report = found.report();
  const auto& scene = report.scene.value();
  ASSERT_EQ(scene.seconds.size(), found.flight.attitude.size() + 27U);
  const auto& times = found.flight.attitude.times;
  std::size_t sample = 0;
  for (std::size_t i = 0; i < scene.seconds.size(); ++i) {
    const bool is_gap = std::isnan(scene.reference_from_body[i].x());
    if (is_gap) {
      EXPECT_GT((times.at(sample) - times.at(sample - 1)).value(), 15.0);
      EXPECT_GT(scene.seconds[i], (times[sample - 1] - report.start).value());
      EXPECT_LT(scene.seconds[i], (times[sample] - report.start).value());
    } else {
      EXPECT_EQ(scene.seconds[i], (times.at(sample++) - report.start).value());
    }
    EXPECT_EQ(std::isnan(scene.directions.at(0).vectors.at(i).x()), is_gap);
    EXPECT_EQ(std::isnan(scene.views.at(0).from_reference.at(i).x()), is_gap);
    EXPECT_EQ(std::isnan(scene.positions.at(i).x()), is_gap);
    EXPECT_EQ(std::isnan(scene.ground_track.at(i).x()), is_gap);
  }
  EXPECT_EQ(sample, times.size());
  EXPECT_TRUE(says(html(report), "692 of 692 samples; "));
}

}  // namespace
}  // namespace vectrix::cli::replay_report_test
