#include "target_words.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "pointing.hpp"
#include "scenario/replayed.hpp"

namespace vectrix::cli::target_words_test {
namespace {

TargetWords star() {
  TargetWords words;
  words.target = "star";
  words.right_ascension = "279.2347";
  words.declination = "-38.7837";
  return words;
}
TargetWords station() {
  TargetWords words;
  words.target = "station";
  words.latitude = "40.015";
  words.longitude = "-105.2705";
  words.height = "1655";
  return words;
}

TEST(TargetWords, OfAnAxisAreThreeNumbers) {
  EXPECT_EQ(axis_of("1,-2.5,1e3"), Eigen::Vector3d(1.0, -2.5, 1000.0));
  const auto refused = [](const char* text) { return complaint([&] { (void)axis_of(text); }); };
  EXPECT_EQ(refused("0,0"), "--axis 0,0 has 2 fields between commas, not 3");
  EXPECT_EQ(refused("0,0,"), "--axis 0,0,: '' is no number");
  EXPECT_EQ(refused("0,1e999,0"), "--axis 0,1e999,0: '1e999' is no number");
  EXPECT_EQ(refused("0,1x,0"), "--axis 0,1x,0: '1x' is no number");
}

TEST(TargetWords, NameATarget) {
  EXPECT_EQ(target_names(), (std::vector<std::string>{"earth", "moon", "sun", "velocity", "velocity_in_itrf",
                                                      "star", "station"}));
  TargetWords words;
  for (const std::string& name : plain_target_names()) {
    words.target = name;
    EXPECT_TRUE(std::holds_alternative<Target>(target_of(words))) << name;
  }
  EXPECT_EQ(std::get<Target>(target_of(words)), Target::velocity_in_itrf);
}

TEST(TargetWords, SayWhereAStarOrAStationIs) {
  constexpr double degree = std::numbers::pi / 180.0, rounding = 1e-15;
  const auto vega = std::get<StarTarget>(target_of(star()));
  EXPECT_NEAR(vega.at.right_ascension.value(), 279.2347 * degree, rounding);
  EXPECT_NEAR(vega.at.declination.value(), -38.7837 * degree, rounding);
  EXPECT_EQ(
      vega.name,
      "the star at right ascension 279.2347 deg, declination -38.7837 deg, standing still: no proper motion "
      "is given");
  EXPECT_FALSE(vega.motion.has_value());
  const auto boulder = std::get<StationTarget>(target_of(station()));
  EXPECT_NEAR(boulder.at.latitude.angle.value(), 40.015 * degree, rounding);
  EXPECT_NEAR(boulder.at.longitude.value(), -105.2705 * degree, rounding);
  EXPECT_EQ(boulder.at.height.value(), 1655.0);
  EXPECT_EQ(boulder.name, "the station at latitude 40.015 deg, longitude -105.2705 deg, height 1655 m");
}

TargetWords moving_star() {
  TargetWords words = star();
  words.proper_motion = "-798.58,10328.12";
  words.cos_declination = "included";
  words.epoch = "2000-01-01T12:00:00 TT";
  return words;
}

TEST(TargetWords, SayHowAStarMoves) {
  constexpr double mas_per_year = std::numbers::pi / 648000e3 / (365.25 * 86400.0);
  TargetWords words = moving_star();
  const auto barnard = std::get<StarTarget>(target_of(words));
  ASSERT_TRUE(barnard.motion.has_value());
  EXPECT_DOUBLE_EQ(barnard.motion->proper.right_ascension().value(), -798.58 * mas_per_year);
  EXPECT_DOUBLE_EQ(barnard.motion->proper.declination().value(), 10328.12 * mas_per_year);
  EXPECT_TRUE(barnard.motion->proper.has_cos_declination());
  EXPECT_EQ(barnard.motion->epoch, Epoch::from_tt("2000-01-01T12:00:00"));
  EXPECT_EQ(barnard.motion->parallax.value(), 0.0);
  EXPECT_EQ(
      barnard.name,
      "the star at right ascension 279.2347 deg, declination -38.7837 deg at 2000-01-01T12:00:00 TT, with "
      "its proper motion");
  words.cos_declination = "not_included";
  words.parallax = "547.45";
  const auto other = std::get<StarTarget>(target_of(words));
  EXPECT_FALSE(other.motion->proper.has_cos_declination());
  EXPECT_DOUBLE_EQ(other.motion->parallax.value(), 547.45 * std::numbers::pi / 648000e3);
}

TEST(TargetWords, OfTheMotionOfAStarAreAllAndNumbers) {
  const auto refusal = [](std::string TargetWords::*word, const std::string& text) {
    TargetWords words = moving_star();
    words.*word = text;
    return complaint([&] { (void)target_of(words); });
  };
  EXPECT_EQ(refusal(&TargetWords::epoch, ""), "the motion of the star is not all; missing: --epoch TIME");
  EXPECT_EQ(refusal(&TargetWords::proper_motion, ""),
            "the motion of the star is not all; missing: --proper-motion MAS,MAS");
  EXPECT_EQ(refusal(&TargetWords::cos_declination, ""),
            "the motion of the star is not all; missing: --cos-declination included|not_included");
  EXPECT_EQ(refusal(&TargetWords::proper_motion, "1"),
            "--proper-motion 1 has 1 fields between commas, not 2");
  EXPECT_EQ(refusal(&TargetWords::proper_motion, "1,nan"),
            "--proper-motion: 'nan' is no finite number of milliarcseconds");
  for (const char* const fast : {"-798.58,10400.1", "10328.12,1300", "1e9,0", "0,-1e9"})
    EXPECT_EQ(refusal(&TargetWords::proper_motion, fast),
              std::string("--proper-motion ") + fast +
                  " is more than 10400 milliarcseconds in a year, that of Barnard's star, the fastest");
  EXPECT_EQ(refusal(&TargetWords::parallax, "1001"), "--parallax 1001 is not from 0 to 1000 milliarcseconds");
  EXPECT_EQ(refusal(&TargetWords::parallax, "-1"), "--parallax -1 is not from 0 to 1000 milliarcseconds");
  TargetWords only = star();
  only.parallax = "10";
  EXPECT_EQ(complaint([&] { (void)target_of(only); }),
            "the motion of the star is not all; missing: --proper-motion MAS,MAS, --cos-declination "
            "included|not_included, --epoch TIME");
  TargetWords of_sun;
  of_sun.target = "sun";
  of_sun.epoch = "2000-01-01T12:00:00 TT";
  EXPECT_EQ(complaint([&] { (void)target_of(of_sun); }), "--epoch is of a star, and the target is sun");
}

TEST(TargetWords, AreAllAndNoOthers) {
  const auto refusal = [](TargetWords words, const auto& change) {
    change(words);
    return complaint([&] { (void)target_of(words); });
  };
  EXPECT_EQ(refusal(star(), [](auto& w) { w.declination.clear(); }),
            "--target star is not all; missing: --declination DEGREES");
  EXPECT_EQ(refusal(station(), [](auto& w) { w.latitude.clear(), w.height.clear(); }),
            "--target station is not all; missing: --latitude DEGREES, --height METRES");
  EXPECT_EQ(refusal(star(), [](auto& w) { w.target = "sun"; }),
            "--right-ascension is of a star, and the target is sun");
  EXPECT_EQ(refusal(star(), [](auto& w) { w.height = "0"; }),
            "--height is of a station, and the target is star");
  EXPECT_EQ(refusal(station(), [](auto& w) { w.declination = "0"; }),
            "--declination is of a star, and the target is station");
}

TEST(TargetWords, AreAnglesAndAHeight) {
  const auto refusal = [](TargetWords words, std::string TargetWords::*word, const std::string& text) {
    words.*word = text;
    return complaint([&] { (void)target_of(words); });
  };
  EXPECT_EQ(refusal(star(), &TargetWords::declination, "90.1"),
            "--declination 90.1 is no number of degrees from -90 to 90");
  EXPECT_EQ(refusal(star(), &TargetWords::declination, "-90"), "nothing was thrown");
  EXPECT_EQ(refusal(star(), &TargetWords::right_ascension, "361"),
            "--right-ascension 361 is no number of degrees from -360 to 360");
  EXPECT_EQ(refusal(star(), &TargetWords::right_ascension, "18h36m"),
            "--right-ascension 18h36m is no number of degrees from -360 to 360");
  EXPECT_EQ(refusal(station(), &TargetWords::latitude, "nan"),
            "--latitude nan is no number of degrees from -90 to 90");
  EXPECT_EQ(refusal(station(), &TargetWords::longitude, "-360.5"),
            "--longitude -360.5 is no number of degrees from -360 to 360");
  EXPECT_EQ(refusal(station(), &TargetWords::height, "inf"), "--height inf is no finite number of metres");
  EXPECT_EQ(refusal(station(), &TargetWords::height, "1 km"), "--height 1 km is no finite number of metres");
}

// The scenario of the cubesat, and the same with the options of the command.
class PointingAsReplay : public ::testing::Test {
 protected:
  static std::string scenario(const std::string& target, const std::string& tables) {
    std::string text = example("ctim.toml");
    text = with(text, "step = \"10 s\"", "");
    text = with(with(text, "-z of radiometer", "-z of body"), "target = \"sun\"\ncorrection = \"geometric\"",
                target);
    return text.substr(0, text.find("[[require]]")) + tables;
  }
  static PointingOptions options(const Scenario& scenario, const TargetWords& words) {
    PointingOptions options;
    options.attitude = scenario.attitude;
    options.orbit.elements = scenario.orbit->elements;
    options.axis = {0.0, 0.0, -1.0};
    options.target = target_of(words);
    return options;
  }
  static void expect_same(const Replayed& replay, PointingOptions options) {
    const auto csv = replay.folder->file("angles.csv");
    options.csv = csv;
    std::ostringstream out;
    EXPECT_TRUE(pointing(options, out));
    const auto table = CsvTable::read(csv, {"angle_deg"});
    const auto& angles = replay.measures[0].angles;
    ASSERT_EQ(table.rows(), angles.size());
    constexpr double rounding = 1e-12;  // deg: the angles come from texts in degrees, here and there
    for (std::size_t i = 0; i < angles.size(); ++i)
      EXPECT_NEAR(table.number(i, "angle_deg"), angles[i] * (180.0 / std::numbers::pi), rounding);
  }
};

TEST_F(PointingAsReplay, LooksAtAStar) {
  const auto replay = replayed(scenario("target = \"Vega\"\ncorrection = \"apparent\"",
                                        "[[star]]\nname = \"Vega\"\nright_ascension = \"279.2347 deg\"\n"
                                        "declination = \"-38.7837 deg\"\n"));
  PointingOptions given = options(replay.scenario, star());
  given.correction = apparent;
  expect_same(replay, given);
}

TEST_F(PointingAsReplay, LooksAtAStarThatMoves) {
  const auto replay = replayed(scenario(
      "target = \"Barnard\"\ncorrection = \"light_time\"",
      "[[star]]\nname = \"Barnard\"\nright_ascension = \"279.2347 deg\"\ndeclination = \"-38.7837 deg\"\n"
      "[star.proper_motion]\nepoch = \"2000-01-01T12:00:00 TT\"\nright_ascension = \"-798.58 mas/yr\"\n"
      "declination = \"10328.12 mas/yr\"\ncos_declination = \"included\"\nparallax = \"0.54745 arcsec\"\n"));
  TargetWords words = moving_star();
  words.parallax = "547.45";
  PointingOptions given = options(replay.scenario, words);
  given.correction = light_time;
  expect_same(replay, given);
}

TEST_F(PointingAsReplay, LooksAtAStation) {
  const auto finals = examples / "data/finals2000A_april_2023.txt";
  const auto replay = replayed(
      scenario("target = \"Boulder\"", "[earth]\norientation = \"" + finals.string() +
                                           "\"\n[[station]]\nname = \"Boulder\"\nlatitude = \"40.015 deg\"\n"
                                           "longitude = \"-105.2705 deg\"\nheight = \"1655 m\"\n"));
  PointingOptions given = options(replay.scenario, station());
  given.orientation = finals;
  expect_same(replay, given);
  given.csv = given.orientation = replay.folder->written("finals.txt", content(finals));
  given.force = true;
  std::ostringstream out;
  EXPECT_EQ(complaint([&] { (void)pointing(given, out); }, given.csv),
            "FILE: is the same file as " + given.csv.string() + ", which is read");
}

}  // namespace
}  // namespace vectrix::cli::target_words_test
