#include "replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>

#include "angle_figures.hpp"
#include "convert.hpp"
#include "cubesat.hpp"
#include "figures.hpp"
#include "pointing_error.hpp"
#include "says.hpp"
#include "scenario/replay_report.hpp"
#include "scenario_folder.hpp"

namespace vectrix::cli::replay_test {
namespace {

using Eigen::Vector3d;

constexpr double arcsecond = std::numbers::pi / 648000.0;
const std::filesystem::path examples = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples";

// The text of an example that may stand in any folder, and writes nothing.
std::string example(const std::string& name) {
  std::string text = content(examples / "scenarios" / name);
  for (auto at = text.find("../data"); at != std::string::npos; at = text.find("../data"))
    text.replace(at, 7, (examples / "data").string());
  return text.substr(0, text.find("[output]"));
}

struct Result {
  std::shared_ptr<const TemporaryFolder> folder;
  Scenario scenario;
  Flight flight;
  std::vector<Measured> measures;
  std::vector<Report::Verdict> judged;

  [[nodiscard]] bool fulfilled(std::size_t i) const { return judged.at(i).fulfilled; }
  [[nodiscard]] Report report() const { return replay_report(scenario, flight, measures, judged, "0"); }
};
Result result(const std::string& text) {
  const auto folder = std::make_shared<const TemporaryFolder>();
  const Scenario scenario = read_scenario(folder->written("s.toml", text));
  Progress silent(nullptr);
  Result made{folder, scenario, read_flight(scenario, silent), {}, {}};
  for (const Measure& each : scenario.measures)
    made.measures.push_back(measured(each, scenario, made.flight));
  made.judged = verdicts(scenario, made.flight, made.measures);
  return made;
}

// The flight's own results: the cosine of the angle between the boresight and the Sun.
TEST(Replay, FindsTheAnglesThatACubesatsGroundProcessingHasPublished) {
  const auto published = CsvTable::read(examples / "data/CTIM_20230420_pointing.csv", {});
  const auto found =
      result(with(with(example("ctim.toml"), "05:20:10Z", "05:00:10Z"), "06:10:00Z", "06:59:50Z"));
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
  const auto found = result(example("ctim.toml"));
  ASSERT_EQ(found.judged.size(), 2U);
  EXPECT_TRUE(found.fulfilled(0));
  EXPECT_TRUE(found.fulfilled(1));
  EXPECT_EQ(found.judged[0].required, "absolute error at most 0.36 deg in 99.7 % of the samples in sunlight");
  EXPECT_EQ(found.judged[0].reached.substr(0, 5), "0.357");
}

TEST(Replay, IsChangedByEachMistake) {
  const std::string right = example("ctim.toml");
  const auto fulfilled = [](const std::string& text) { return result(text).fulfilled(0); };
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
    const auto found = result(text);
    return better_readings(found.flight, found.measures[0]);
  };
  EXPECT_EQ(better(right), "");
  EXPECT_EQ(better(transposed), "transposed (median 0.350123 deg)");
  EXPECT_EQ(better(last), "other order of numbers (median 0.350123 deg)");
  EXPECT_EQ(better(with(transposed, "scalar = \"first\"", "scalar = \"last\"")),
            "other order and transposed (median 0.350123 deg)");
  EXPECT_EQ(better(with(right, "-z of radiometer", "x of radiometer")), "");  // none
  const auto table = result(transposed).report().tables.at(1);
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
  const auto of_table = result(table), of_message = result(text);
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
  const auto found = result(text);
  for (const double angle : found.measures[0].angles) {
    EXPECT_GE(degrees * angle, 0.0003);
    EXPECT_LE(degrees * angle, 0.0011);
  }
  EXPECT_TRUE(found.fulfilled(0));
  const AngleFigures off_nadir(found.measures[1].angles);
  EXPECT_NEAR(off_nadir.quantile(50.0), 29.9, 0.01);  // it looks 30 deg to the right
  // The yaw steering is the difference: some degrees.
  const auto inertial = result(with(text, "velocity relative to ITRF", "velocity relative to GCRF"));
  EXPECT_FALSE(inertial.fulfilled(0));
  EXPECT_GT(AngleFigures(inertial.measures[0].angles).quantile(50.0), 1.0);
  EXPECT_FALSE(result(with(text, "from = \"quaternion axes\", to = \"J2000\"",
                           "from = \"J2000\", to = \"quaternion axes\""))
                   .fulfilled(0));
  EXPECT_FALSE(result(with(text, "scalar = \"last\"", "scalar = \"first\"")).fulfilled(0));
  EXPECT_FALSE(
      result(with(text, "[[0, -1, 0], [-1, 0, 0], [0, 0, -1]]", "[[0, 1, 0], [1, 0, 0], [0, 0, -1]]"))
          .fulfilled(0));
}

TEST(Replay, SeesTheGyrosOfSentinel1AgreeWithItsTurns) {
  const auto report = result(example("sentinel1.toml")).report();
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
  const auto found = result(example("ctim.toml"));
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
  EXPECT_TRUE(result(example("ctim.toml")).report().tables.at(0).rows.at(0).size() ==
              report.tables[0].headings.size());
}

TEST(Replay, InterruptsCurvesInGaps) {
  const std::string whole = with(
      example("ctim.toml"), "start = 2023-04-20T05:20:10Z\nend = 2023-04-20T06:10:00Z\nstep = \"10 s\"", "");
  const auto gaps = [&](const std::string& text) {
    const auto plot = result(text).report().plots[0];
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
  const auto found = result(with(whole, "gap = \"30 s\"", "gap = \"15 s\""));
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

// The Earth hides the Sun if the line to it passes nearer than its radius.
TEST(Replay, CountsOnlySunlightOrShadow) {
  std::string text = with(with(example("ctim.toml"), "05:20:10Z", "05:00:10Z"), "06:10:00Z", "06:59:50Z");
  const auto found = result(text);
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
  const auto in_shadow = result(with(text, "when = \"sunlight\"", "when = \"shadow\""));
  EXPECT_EQ(counts(in_shadow.judged[0]), " of " + std::to_string(dark) + " are within)");
  const auto refused = complaint(
      [&] { (void)result(with(example("ctim.toml"), "when = \"sunlight\"", "when = \"shadow\"")); });
  EXPECT_TRUE(says(refused, "s.toml:38:1: no instant is in shadow"));
}

// A window counts if all its samples do.
TEST(Replay, LeavesOutWindowsOverWhatDoesNotCount) {
  const auto found = result(example("ctim.toml"));
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

class ReplayFiles : public ::testing::Test, protected ScenarioFolder {
 protected:
  [[nodiscard]] bool run(const std::string& text, bool force = false, bool check = false) {
    folder.written("s.toml", text);
    out.str("");
    Progress silent(nullptr);
    return replay({file(), check, force, "0"}, silent, out);
  }
  std::ostringstream out;
};

TEST_F(ReplayFiles, SaysWhatIsFulfilled) {
  // The body is along the reference, its z axis 68 deg from the Sun of that day.
  EXPECT_FALSE(run(plain));
  EXPECT_TRUE(
      says(out.str(),
           "not fulfilled  off-Sun: absolute error at most 0.5 deg in 95 % of the samples; it is 111."));
  EXPECT_TRUE(says(out.str(), "Not fulfilled: 1 of 1 requirement.\n"));
  EXPECT_TRUE(run(with(plain, "0.5 deg", "179 deg")));
  EXPECT_TRUE(says(out.str(), "Everything required is fulfilled.\n"));
  EXPECT_TRUE(run(std::string(plain).substr(0, std::string(plain).find("[[require]]"))));
  EXPECT_TRUE(says(out.str(), "Nothing is required.\n"));
}

TEST_F(ReplayFiles, OnlyReadsThemForACheck) {
  EXPECT_TRUE(
      run(plain + std::string("[output]\ncsv = \"") + folder.file("o.csv").string() + "\"\n", false, true));
  EXPECT_TRUE(says(out.str(), "s.toml: 1 measure and 1 requirement of body relative to GCRF, 3 samples, "));
  EXPECT_FALSE(std::filesystem::exists(folder.file("o.csv")));
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "z of body", "z of boy"), false, true); }, file()),
            "FILE:12:9: there is no frame 'boy' fixed in the body; the nearest is 'body'");
}

TEST_F(ReplayFiles, AreWrittenOnce) {
  const auto csv = folder.file("o.csv");
  const std::string text = plain + std::string("[output]\ncsv = \"") + csv.string() + "\"\n";
  (void)run(text);
  EXPECT_TRUE(says(out.str(), "Written: " + csv.string()));
  const auto table = CsvTable::read(csv, {"time_utc", "off-Sun_deg"});
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(complaint([&] { (void)run(text); }, csv), "FILE: exists; --force overwrites it");
  (void)run(text, true);
  const std::string input =
      plain + std::string("[output]\ncsv = \"") + folder.file("a.csv").string() + "\"\n";
  EXPECT_EQ(complaint([&] { (void)run(input, true); }, folder.file("a.csv")),
            "FILE: is the same file as " + folder.file("a.csv").string() + ", which is read");
}

TEST_F(ReplayFiles, LimitTheInstants) {
  EXPECT_EQ(complaint([&] { (void)run(plain + std::string("[time]\nstep = \"0.001 ms\"\n")); }, file()),
            "FILE:19:1: 'time.step' makes 20000001 instants; at most 10000000 are looked at");
}

TEST_F(ReplayFiles, HaveTheColumnsThatAreNamed) {
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "\"t\"", "\"time\"")); }, file()),
            "FILE:5:19: " + folder.file("a.csv").string() +
                " has no column 'time'; there are: t, a, b, c, d, wx, wy, wz");
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "\"d\"]", "\"wxx\"]")); }, file()),
            "FILE:7:11: " + folder.file("a.csv").string() + " has no column 'wxx'; the nearest is 'wx'");
}

TEST(Replay, NamesTheOrientationOfAnotherTime) {
  const auto refused = complaint([&] {
    (void)result(with(example("sentinel1.toml"), "finals2000A_april_2022", "finals2000A_april_2023"));
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
    const auto found = result(text);
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

TEST_F(ReplayFiles, SayWhatHasNoAttitude) {
  (void)run(plain + std::string("[time]\nstep = \"10 s\"\nend = 2026-11-29T00:01:00Z\n"));
  EXPECT_TRUE(
      says(out.str(), "\nWithout attitude, not judged: 4 of 7 instants, in gaps or outside the samples\n"));
}

TEST_F(ReplayFiles, HaveSamplesAtTheTimes) {
  EXPECT_EQ(
      complaint(
          [&] { (void)run(plain + std::string("[time]\nstep = \"1 s\"\nstart = 2026-11-30T00:00:00Z\n")); },
          file()),
      "FILE:19:1: the samples of " + folder.file("a.csv").string() +
          " are from 2026-11-29T00:00:00.000000 UTC to 2026-11-29T00:00:20.000000 UTC, none from "
          "'time.start' to "
          "'time.end'");
}

}  // namespace
}  // namespace vectrix::cli::replay_test
