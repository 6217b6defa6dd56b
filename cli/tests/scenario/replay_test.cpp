#include "scenario/flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "angle_figures.hpp"
#include "convert.hpp"
#include "cubesat.hpp"
#include "figures.hpp"
#include "pointing_error.hpp"
#include "replayed.hpp"
#include "says.hpp"

namespace vectrix::cli::replay_test {
namespace {

using Eigen::Vector3d;

constexpr double arcsecond = std::numbers::pi / 648000.0;

// The flight's own results: the cosine of the angle between the boresight and the Sun.
TEST(Replay, FindsTheAnglesThatACubesatsGroundProcessingHasPublished) {
  const auto published = CsvTable::read(examples / "data/CTIM_20230420_pointing.csv", {});
  const auto found =
      replayed(with(with(example("ctim.toml"), "05:20:10Z", "05:00:10Z"), "06:10:00Z", "06:59:50Z"));
  const auto& times = found.flight.attitude.times;
  ASSERT_EQ(times.size(), published.rows());
  double sum = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto microseconds = static_cast<std::int64_t>(published.number(i, "microsecondssincegpsepoch"));
    ASSERT_NEAR((times[i] - Epoch::from_gps_seconds(microseconds / 1'000'000)).value(), 0.0, 1e-9);
    sum +=
        std::pow((found.measures[0].angles[i] - std::acos(published.number(i, "timdotsun"))) / arcsecond, 2);
  }
  constexpr double of_printed_cosines =
      0.03;  // arcsec: cosines near 1, with 16 digits, of a position good to metres
  EXPECT_LE(std::sqrt(sum / static_cast<double>(times.size())), of_printed_cosines);
}

// The published angles of these samples are 0.339 to 0.358 deg.
TEST(Replay, JudgesTheCubesat) {
  const auto found = replayed(example("ctim.toml"));
  ASSERT_EQ(found.judged.size(), 2U);
  EXPECT_TRUE(found.fulfilled(0));
  EXPECT_TRUE(found.fulfilled(1));
  EXPECT_EQ(found.judged[0].required, "absolute error at most 0.36 deg in 99.7 % of the samples in sunlight");
  EXPECT_EQ(found.judged[0].reached.substr(0, 5), "0.357");
}

TEST(Replay, IsChangedByEachMistake) {
  const std::string right = example("ctim.toml");
  const auto fulfilled = [](const std::string& text) { return replayed(text).fulfilled(0); };
  ASSERT_TRUE(fulfilled(right));
  EXPECT_FALSE(fulfilled(with(right, "from = \"ICRF\", to = \"body\"", "from = \"body\", to = \"ICRF\"")))
      << "transposed";
  EXPECT_FALSE(fulfilled(with(right, "scalar = \"first\"", "scalar = \"last\""))) << "scalar misplaced";
  EXPECT_FALSE(
      fulfilled(with(right, "from = \"radiometer\", to = \"body\"", "from = \"body\", to = \"radiometer\"")))
      << "frame transposed";
  EXPECT_FALSE(fulfilled(with(right, "-z of radiometer", "-z of body"))) << "frame forgotten";
  EXPECT_FALSE(fulfilled(with(right, "-z of radiometer", "z of radiometer"))) << "sign";
}

// The mistake is named; none is undone.
TEST(Replay, SaysWhichReadingWouldBeOnTheTarget) {
  const std::string right = example("ctim.toml"),
                    transposed =
                        with(right, "from = \"ICRF\", to = \"body\"", "from = \"body\", to = \"ICRF\""),
                    last = with(right, "scalar = \"first\"", "scalar = \"last\"");
  const auto better = [](const std::string& text) {
    const auto found = replayed(text);
    return better_readings(found.flight, found.measures[0]);
  };
  EXPECT_EQ(better(right), "");
  EXPECT_EQ(better(transposed), "transposed (median 0.350123 deg)");
  EXPECT_EQ(better(last), "other order of numbers (median 0.350123 deg)");
  EXPECT_EQ(better(with(transposed, "scalar = \"first\"", "scalar = \"last\"")),
            "other order and transposed (median 0.350123 deg)");
  EXPECT_EQ(better(with(right, "-z of radiometer", "x of radiometer")), "");  // none
  const auto table = replayed(transposed).report().tables.at(1);
  EXPECT_EQ(table.headings,
            (std::vector<std::string>{"measure", "as stated", "transposed", "other order of numbers",
                                      "other order and transposed"}));
  EXPECT_EQ(table.rows.at(0).at(2), "0.350123");
}

// A message says itself what it means: the same flight.
TEST(Replay, ReadsAMessage) {
  const auto aem = temporary_path("_ctim.aem");
  ConvertOptions to_aem{aem};
  to_aem.text = {"CTIM", "2022-074G", "LASP", "2026-11-29T00:00:00"};
  to_aem.body = "SC_BODY_1";
  std::ostringstream silent;
  convert(cubesat_attitude(), to_aem, silent);
  const std::string table = example("ctim.toml");
  const auto begin = table.find("time = {"), end = table.find("[[frame]]");
  std::string text = table;
  text.replace(begin, end - begin, "gap = \"30 s\"\n");
  text = with(with(text, (examples / "data/CTIM_20230420_attitude.csv").string(), aem.string()),
              "to = \"body\" }\n\n[[measure]]", "to = \"SC_BODY_1\" }\n\n[[measure]]");
  const auto of_table = replayed(table), of_message = replayed(text);
  const Report report = of_message.report();
  std::filesystem::remove(aem);
  constexpr double rounding = 1e-13;  // rad: of quaternions that were divided by their norm
  for (std::size_t i = 0; i < of_table.measures[0].angles.size(); ++i)
    EXPECT_NEAR(of_message.measures[0].angles[i], of_table.measures[0].angles[i], rounding);
  EXPECT_EQ(of_message.flight.attitude.body, "SC_BODY_1");
  bool is_said = false;
  for (const auto& choice : report.choices)
    is_said = is_said || (choice.by == aem.string() &&
                          choice.value.ends_with("coordinates to GCRF, the scalar is last"));
  EXPECT_TRUE(is_said);
}

// Zero-Doppler steering: 0.0003 to 0.0011 deg, with the observed orientation of the Earth.
TEST(Replay, FindsTheZeroDopplerSteeringOfSentinel1) {
  const std::string text = example("sentinel1.toml");
  const auto found = replayed(text);
  for (const double angle : found.measures[0].angles) {
    EXPECT_GE(degrees * angle, 0.0003);
    EXPECT_LE(degrees * angle, 0.0011);
  }
  EXPECT_TRUE(found.fulfilled(0));
  const AngleFigures off_nadir(found.measures[1].angles);
  EXPECT_NEAR(off_nadir.quantile(50.0), 29.9, 0.01);  // it looks 30 deg to the right
  // The yaw steering is the difference: some degrees.
  const auto inertial = replayed(with(text, "velocity relative to ITRF", "velocity relative to GCRF"));
  EXPECT_FALSE(inertial.fulfilled(0));
  EXPECT_GT(AngleFigures(inertial.measures[0].angles).quantile(50.0), 1.0);
  EXPECT_FALSE(replayed(with(text, "from = \"quaternion axes\", to = \"J2000\"",
                             "from = \"J2000\", to = \"quaternion axes\""))
                   .fulfilled(0));
  EXPECT_FALSE(replayed(with(text, "scalar = \"last\"", "scalar = \"first\"")).fulfilled(0));
  EXPECT_FALSE(
      replayed(with(text, "[[0, -1, 0], [-1, 0, 0], [0, 0, -1]]", "[[0, 1, 0], [1, 0, 0], [0, 0, -1]]"))
          .fulfilled(0));
}

// The Earth hides the Sun if the line to it passes nearer than its radius.
TEST(Replay, CountsOnlySunlightOrShadow) {
  std::string text = with(with(example("ctim.toml"), "05:20:10Z", "05:00:10Z"), "06:10:00Z", "06:59:50Z");
  const auto found = replayed(text);
  constexpr double penumbra = 40e3;  // m: of the Sun's disc, and of the ellipsoid, on the line
  std::size_t dark = 0;
  for (std::size_t i = 0; i < found.flight.motions.size(); ++i) {
    const Vector3d r = found.flight.motions[i].position.coordinates(), s = found.measures[0].directions[i];
    const double passes = (r - r.dot(s) * s).norm() - wgs84::semi_major_axis.value();
    const double seen = found.flight.visible_sun[i];
    const bool is_behind = r.dot(s) < 0.0;
    if (!is_behind || passes > penumbra) {
      EXPECT_EQ(seen, 1.0);
    }
    if (is_behind && passes < -penumbra) {
      EXPECT_EQ(seen, 0.0);
    }
    dark += seen == 0.0 ? 1U : 0U;
  }
  EXPECT_GT(dark, 100U);
  const auto counts = [](const Report::Verdict& verdict) {
    return verdict.reached.substr(verdict.reached.find(" of "));
  };
  const auto in_shadow = replayed(with(text, "when = \"sunlight\"", "when = \"shadow\""));
  EXPECT_EQ(counts(in_shadow.judged[0]), " of " + std::to_string(dark) + " are within)");
  const auto refused = complaint(
      [&] { (void)replayed(with(example("ctim.toml"), "when = \"sunlight\"", "when = \"shadow\"")); });
  EXPECT_TRUE(says(refused, "s.toml:38:1: no instant is in shadow"));
}

// A window counts if all its samples do.
TEST(Replay, LeavesOutWindowsOverWhatDoesNotCount) {
  const auto found = replayed(example("ctim.toml"));
  const auto& record = found.flight.attitude;
  const auto& in_body = found.measures[0].in_body;
  std::vector<bool> among(record.size(), true);
  among[100] = among[101] = among[200] = false;
  const auto all = relative_errors(record, in_body, 60.0),
             some = relative_errors(record, in_body, 60.0, among);
  std::vector<std::size_t> expected;
  for (const std::size_t start : all.starts)
    if (std::find(among.begin() + static_cast<std::ptrdiff_t>(start),
                  among.begin() + static_cast<std::ptrdiff_t>(start + 7),
                  false) == among.begin() + static_cast<std::ptrdiff_t>(start + 7))
      expected.push_back(start);
  EXPECT_EQ(some.starts, expected);
  EXPECT_LT(expected.size(), all.starts.size());
  for (std::size_t k = 0, j = 0; k < some.starts.size(); ++k) {
    while (all.starts[j] != some.starts[k]) ++j;
    EXPECT_EQ(some.errors[k], all.errors[j]);
  }
}

TEST(Replay, NamesTheOrientationOfAnotherTime) {
  const auto refused = complaint([&] {
    (void)replayed(with(example("sentinel1.toml"), "finals2000A_april_2022", "finals2000A_april_2023"));
  });
  EXPECT_TRUE(
      says(refused, "s.toml:7:15: EarthOrientation: the epoch 2022-04-14T10:22:11.874999 UTC is outside"))
      << refused;
}

// What was asked for and is not known is not passed over in silence.
TEST(Replay, SaysWhatHasNoAttitude) {
  const std::string stepped = example("ctim.toml");
  const std::string times = "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z\nstep = \"10 s\"";
  const auto said = [&](const std::string& text) {
    const auto found = replayed(text);
    const std::string missing = without_attitude(found.scenario, found.flight);
    const auto facts = found.report().facts;
    EXPECT_EQ(
        std::any_of(facts.begin(), facts.end(), [&](const auto& fact) { return fact.value == missing; }),
        !missing.empty());
    return missing;
  };
  EXPECT_EQ(said(stepped), "");
  EXPECT_EQ(said(with(stepped, "06:10:00", "07:10:00")),
            "61 of 660 instants, in gaps or outside the samples");  // the last sample is at 06:59:59
  EXPECT_EQ(said(with(stepped, times, "")), "");
  EXPECT_EQ(said(with(stepped, times, "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z")), "");
  EXPECT_EQ(said(with(stepped, times, "end = 2023-04-20T07:00:59.001Z")),
            "60 s, in gaps or outside the samples");
  EXPECT_EQ(said(with(stepped, times, "start = 2023-04-20T04:59:09.001Z")),
            "60 s, in gaps or outside the samples");
}

}  // namespace
}  // namespace vectrix::cli::replay_test
