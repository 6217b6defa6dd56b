#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "pointing.hpp"
#include "replay.hpp"
#include "replayed.hpp"
#include "result_file/result_file.hpp"
#include "says.hpp"
#include "stored_attitude.hpp"

namespace vectrix::cli::hidden_target_test {
namespace {

// The cubesat's radiometer on the Sun for two hours, through the shadow of the Earth, and a star.
std::string through_shadow() {
  std::string text = with(with(example("ctim.toml"), "05:20:10Z", "05:00:10Z"), "06:10:00Z", "06:59:50Z");
  return text.substr(0, text.find("[[require]]"));
}
const std::string visible =
    "[[require]]\nmeasure = \"off-Sun\"\nabsolute = \"0.36 deg\"\npercent = \"99.7 %\"\nwhen = \"visible\"\n";

TEST(HiddenTarget, IsNotJudgedIfOnlyVisibleOnesAre) {
  const auto found = replayed(through_shadow() + visible);
  const auto& hidden = found.measures[0].hidden;
  ASSERT_EQ(hidden.size(), found.flight.attitude.size());
  const auto count = static_cast<std::size_t>(std::count(hidden.begin(), hidden.end(), true));
  EXPECT_GT(count, 100U);
  EXPECT_EQ(found.judged[0].count, hidden.size() - count);
  EXPECT_EQ(found.judged[0].required,
            "absolute error at most 0.36 deg in 99.7 % of the samples while it is visible");
  const Result result = found.result();
  EXPECT_EQ(result.measures[0].hidden, hidden);
  const std::string words =
      "the Earth hides it at " + std::to_string(count) + " of " + std::to_string(hidden.size()) + " instants";
  const auto& facts = result.texts.facts;
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [&](const auto& fact) {
    return fact.name == "target of off-Sun" && fact.value == words;
  }));
  // Hidden ones count if nothing is said.
  EXPECT_EQ(replayed(through_shadow() + with(visible, "when = \"visible\"\n", "")).judged[0].count,
            hidden.size());
}

// `when` of the measure: the figures too are of visible ones only.
TEST(HiddenTarget, IsLeftOutOfTheFiguresOfAMeasure) {
  const std::string of_measure =
      with(through_shadow(), "target = \"sun\"\n", "target = \"sun\"\nwhen = \"visible\"\n");
  const std::string required = with(visible, "when = \"visible\"\n", "");
  const auto found = replayed(of_measure + required), all = replayed(through_shadow() + visible);
  EXPECT_EQ(found.judged[0].required, all.judged[0].required);
  EXPECT_EQ(found.judged[0].figures.found, all.judged[0].figures.found);
  const auto& hidden = found.measures[0].hidden;
  double largest = 0.0;
  for (std::size_t i = 0; i < hidden.size(); ++i)
    if (!hidden[i]) largest = std::max(largest, found.measures[0].angles[i]);
  const auto row = [](const Replayed& replay) { return replay.report().tables[0].rows[0]; };
  EXPECT_EQ(row(found)[4], decimals(degrees * largest));
  EXPECT_NE(row(all)[4], row(found)[4]);
  const auto count = std::count(hidden.begin(), hidden.end(), true);
  const auto facts = found.result().texts.facts;
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [&](const auto& fact) {
    return fact.name == "figures of off-Sun" &&
           fact.value == std::to_string(count) + " of " + std::to_string(hidden.size()) +
                             " instants are left out, where the Earth hides the target";
  }));
  EXPECT_NE(complaint([&] {
              (void)replayed(of_measure + with(visible, "\"visible\"", "\"sunlight\""));
            }).find("'require.when' is \"sunlight\", and 'off-Sun' is measured only while it is visible"),
            std::string::npos);
}

// The same word as an option of pointing, the same figures.
TEST(HiddenTarget, IsLeftOutByPointing) {
  std::string text = with(through_shadow(), "step = \"10 s\"", "");
  text = with(text, "-z of radiometer", "-z of body");
  const auto found = replayed(with(text, "target = \"sun\"\n", "target = \"sun\"\nwhen = \"visible\"\n"));
  PointingOptions options;
  options.attitude = found.scenario.attitude;
  options.orbit.elements = found.scenario.orbit->elements;
  options.axis = {0.0, 0.0, -1.0};
  options.correction = geometric;
  const auto said = [&] {
    std::ostringstream out;
    (void)pointing(options, out);
    return out.str();
  };
  const std::string all = said();
  EXPECT_TRUE(says(all, "These are of all samples, but the Earth hides it at "));
  options.when = When::visible;
  const std::string visible_ones = said();
  const AngleFigures figures(counted_of(found.measures[0].angles, found.measures[0].counts));
  const std::string largest = decimals(figures.value(figures.place_of_largest()));
  EXPECT_TRUE(says(visible_ones, "largest " + std::string(12 - largest.size() + 2, ' ') + largest))
      << visible_ones;
  EXPECT_TRUE(says(visible_ones, " samples are left out, where the Earth hides the target.\n"));
  EXPECT_FALSE(says(visible_ones, "These are of all samples"));
  EXPECT_NE(all, visible_ones);
  // A window among which a sample is hidden is none.
  options.window = 60.0;
  EXPECT_TRUE(says(said(), "reach over a gap, a sample that is left out, or the end\n"));
  options.when = When::shadow;
  EXPECT_TRUE(says(said(), " samples are left out, which are not in shadow.\n"));
  options.when = When::visible;
  options.target = Target::earth;
  options.correction.reset();
  EXPECT_EQ(complaint([&] { (void)said(); }),
            "the Earth hides the Sun, the Moon, stars and stations, and not the centre of the Earth");
  options.target = Target::sun;
  options.correction = geometric;
  options.orbit = {};
  EXPECT_EQ(complaint([&] { (void)said(); }),
            "whether it is visible needs an orbit; missing: --tle, --omm, --oem or --spk");
}

TEST(HiddenTarget, IsWrittenAndStored) {
  const auto folder = std::make_shared<const TemporaryFolder>();
  const auto csv = folder->file("o.csv");
  const auto scenario =
      folder->written("s.toml", through_shadow() + "[output]\ncsv = \"" + csv.string() + "\"\n");
  ReplayOptions options;
  options.file = scenario;
  options.hdf5 = folder->file("o.h5");
  options.version = "0";
  Progress silent(nullptr);
  std::ostringstream out;
  (void)replay(options, silent, out);
  EXPECT_TRUE(says(out.str(), "the Earth hides it at "));
  const auto found = replayed_file(scenario);
  const auto table = CsvTable::read(csv, {"off-Sun_deg", "off-Sun_hidden"});
  ASSERT_EQ(table.rows(), found.measures[0].hidden.size());
  for (std::size_t i = 0; i < table.rows(); ++i)
    EXPECT_EQ(table.text(i, "off-Sun_hidden"), found.measures[0].hidden[i] ? "1" : "0");
  EXPECT_EQ(read_result(options.hdf5).measures[0].hidden, found.measures[0].hidden);

  // The stored result is an attitude again: the same angles, at the same instants.
  std::string again = through_shadow();
  const auto begin = again.find("[attitude]"), end = again.find("[[frame]]");
  again.replace(begin, end - begin,
                "[attitude]\nfile = \"" + options.hdf5.string() + "\"\ngap = \"30 s\"\n\n");
  const auto second = replayed_file(folder->written("again.toml", again), folder);
  ASSERT_EQ(second.measures[0].angles.size(), found.measures[0].angles.size());
  constexpr double rounding = 1e-14;  // rad: quaternions of norm 1 instead of 2e9
  for (std::size_t i = 0; i < second.measures[0].angles.size(); ++i)
    EXPECT_NEAR(second.measures[0].angles[i], found.measures[0].angles[i], rounding);
  EXPECT_EQ(second.flight.attitude.body, "body");
  const auto file = folder->written("again.toml", with(again, "gap =", "segment = 1\ngap ="));
  EXPECT_NE(complaint([&] { (void)replayed_file(file); }).find("is of a message; "), std::string::npos);
}

TEST(HiddenTarget, IsRefusedWhereNothingHides) {
  const std::string text = through_shadow() + visible;
  const std::string of_earth =
      with(with(text, "target = \"sun\"\n", "target = \"earth\"\n"),
           "correction = \"geometric\"      # where the Sun is, as the flight's own results have it\n", "");
  EXPECT_NE(complaint([&] {
              (void)replayed(of_earth);
            }).find("the Earth hides the Sun, the Moon, stars and stations, and not the centre of the Earth"),
            std::string::npos);
}

// Barnard's star: 10.39 arcsec in a Julian year.
TEST(StarTarget, MovesByItsProperMotion) {
  const auto text = [](const std::string& more) {
    return through_shadow().substr(0, through_shadow().find("[[measure]]")) +
           "[[star]]\nname = \"Barnard\"\nright_ascension = \"269.452 deg\"\ndeclination = \"4.6933 deg\"\n" +
           more +
           "[[measure]]\nname = \"m\"\naxis = \"z of body\"\ntarget = \"Barnard\"\ncorrection = "
           "\"light_time\"\n";
  };
  const std::string motion =
      "[star.proper_motion]\nepoch = \"2000-01-01T12:00:00 TT\"\nright_ascension = \"-798.58 mas/yr\"\n"
      "declination = \"10328.12 mas/yr\"\ncos_declination = \"included\"\n";
  const auto still = replayed(text("")), moved = replayed(text(motion));
  const Eigen::Vector3d n = still.measures[0].directions[0], m = moved.measures[0].directions[0];
  constexpr double arcsecond = 4.84813681109536e-6, years = 23.299;  // to 20 April 2023
  constexpr double of_the_day = 0.01;                                // arcsec
  EXPECT_NEAR(angle_between(n, m) / arcsecond, std::hypot(0.79858, 10.32812) * years, of_the_day);
  const Eigen::Vector3d east = Eigen::Vector3d::UnitZ().cross(n).normalized();
  EXPECT_NEAR((m - n).dot(east) / arcsecond, -0.79858 * years, of_the_day);
  const auto without = replayed(text(with(motion, "included", "not included")));
  EXPECT_NEAR((without.measures[0].directions[0] - n).dot(east) / arcsecond,
              -0.79858 * std::cos(4.6933 * arcsecond * 3600.0) * years, of_the_day);
  const auto chosen = [](const Replayed& found, const std::string& value) {
    const auto& all = found.scenario.choices;
    return std::any_of(all.begin(), all.end(), [&](const auto& choice) {
      return choice.what == "motion of Barnard" && choice.value == value;
    });
  };
  EXPECT_TRUE(chosen(moved, "its proper motion"));
  EXPECT_TRUE(chosen(still, "none: no proper motion is given"));
  // The parallax: at most 0.55 arcsec from where it is seen from the Sun.
  const auto near_star = replayed(text(motion + "parallax = \"0.54745 arcsec\"\n"));
  const double shift = angle_between(near_star.measures[0].directions[0], m) / arcsecond;
  EXPECT_GT(shift, 0.05);
  EXPECT_LT(shift, 0.56);
  EXPECT_NE(complaint([&] {
              (void)replayed(text(motion + "parallax = \"2 arcsec\"\n"));
            }).find("from 0 to 1 arcsec"),
            std::string::npos);
}

}  // namespace
}  // namespace vectrix::cli::hidden_target_test
