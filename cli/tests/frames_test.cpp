#include "frames.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "resampled.hpp"
#include "says.hpp"
#include "scenario/flight.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::frames_test {
namespace {

using Eigen::Vector3d;

const std::filesystem::path scenarios = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/scenarios";

std::string text(const char* file, const std::string& from = "", const std::string& to = "",
                 const std::string& at = "") {
  std::ostringstream out;
  frames({scenarios / file, from, to, at}, out);
  return out.str();
}
// The numbers after the last of some words.
std::vector<double> numbers(const std::string& text, const std::string& words, std::size_t count) {
  std::istringstream in(text.substr(text.rfind(words) + words.size()));
  std::vector<double> all(count);
  char comma{};
  for (double& each : all) in >> each >> comma;
  return all;
}
Eigen::Quaterniond turn(const std::string& said) {
  const auto q = numbers(said, "scalar first: (", 4);
  return {q[0], q[1], q[2], q[3]};
}
Vector3d rate(const std::string& said) {
  return Vector3d(numbers(said, "deg/s: (", 3).data());
}

constexpr double rounding = 1e-14, printed = 2e-6;  // rad; deg/s: two numbers of six decimals

TEST(Frames, AreTheProductOfTheirFactors) {
  const auto scenario = read_scenario(scenarios / "ctim.toml");
  const auto flown = read_flown_attitude(scenario);
  const auto t = Epoch::from_utc("2023-04-20T05:30:00");
  const auto step = step_at(flown.record, t);
  const auto said = text("ctim.toml", "radiometer", "ICRF", "2023-04-20T05:30:00 UTC");
  const Eigen::Quaterniond body_from_radiometer = flown.frames.body_from("radiometer", {});
  EXPECT_LE(turn(said).angularDistance(step.at.to_reference * body_from_radiometer), rounding);
  const Vector3d w = body_from_radiometer.conjugate() * step.at.rate * (180.0 / std::numbers::pi);
  EXPECT_LE((rate(said) - w).norm(), printed);
  EXPECT_GT(w.norm(), 0.01);
  const auto back = text("ctim.toml", "ICRF", "radiometer", "2023-04-20T05:30:00 UTC");
  EXPECT_LE(turn(back).angularDistance(turn(said).conjugate()), rounding);
  EXPECT_TRUE(
      says(said, "R1: v_body = R1 v_radiometer; fixed, " + (scenarios / "ctim.toml").string() + ":24\n"));
  EXPECT_TRUE(says(said, "R = R2 R1: v_GCRF = R v_radiometer\n"));
}

// w_ig = -R w_gi, and the turn of the Earth once a sidereal day.
TEST(Frames, MeetInOneThatIsNoneOfTheirs) {
  const auto said = text("sentinel1.toml", "satellite", "ITRF"),
             attitude = text("sentinel1.toml", "satellite", "GCRF"),
             earth = text("sentinel1.toml", "ITRF", "GCRF");
  EXPECT_LE(turn(said).angularDistance(turn(earth).conjugate() * turn(attitude)), 1e-13);
  EXPECT_NEAR(rate(earth).norm(), 360.0 / 86164.1, printed);
  EXPECT_LE((rate(said) - (rate(attitude) - turn(said).conjugate() * rate(earth))).norm(), printed);
  // x of the body is nearly forward, z looks 30 deg to the side of down.
  const auto lvlh = text("sentinel1.toml", "satellite", "LVLH");
  EXPECT_NEAR((turn(lvlh) * Vector3d::UnitZ()).z(), std::cos(29.89 * std::numbers::pi / 180.0), 1e-4);
  EXPECT_TRUE(says(lvlh, "w is not known"));
  EXPECT_TRUE(says(said, "R3: v_GCRF = R3 v_EME2000; the bias of J2000\n"));
  EXPECT_TRUE(says(said, "R4: v_ITRF = R4 v_GCRF; the observed turn of the Earth, inverted\n"));
}

// Of two element sets the one near the time that is looked at, and not near the middle of the file.
TEST(Frames, HaveTheOrbitOfTheReplay) {
  const TemporaryFolder folder;
  std::string table = "t,w,x,y,z\n";
  for (const char* time : {"19T12", "20T00", "20T12", "21T00", "21T12", "22T00", "22T12"})
    table += "2023-04-" + std::string(time) + ":00:00,1,0,0,0\n";
  folder.written("a.csv", table);
  folder.written("two.tle",
                 "1 52950U 22074G   23109.57820907  .00068572  00000-0  17802-2 0  9997\n"
                 "2 52950  45.0036 325.6810 0013662 217.4787 142.5173 15.38064442 44569\n"
                 "1 52950U 22074G   23111.57820907  .00068572  00000-0  17802-2 0  9990\n"
                 "2 52950  45.0036 325.6810 0013662 217.4787 302.5173 15.38064442 44567\n");
  const auto file = folder.written("s.toml", R"(version = 1
title = "T"
[time]
start = 2023-04-19T14:00:00Z
end = 2023-04-19T16:00:00Z
step = "10 min"
[orbit]
tle = "two.tle"
[attitude]
file = "a.csv"
time = { column = "t", scale = "UTC" }
[attitude.quaternion]
columns = ["w", "x", "y", "z"]
scalar = "first"
maps = { from = "body", to = "GCRF" }
)");
  Progress silent(nullptr);
  const auto flight = read_flight(read_scenario(file), silent);
  struct Lvlh : moving_frame {};
  const auto said = turn(text(file.c_str(), "LVLH", "GCRF", "2023-04-19T15:00:00 UTC"));
  const auto [r, v] = flight.orbit(Epoch::from_utc("2023-04-19T15:00:00"));
  EXPECT_LE(said.angularDistance(Eigen::Quaterniond(lvlh(from<Lvlh>, r, v).matrix())), rounding);
}

TEST(Frames, AreListed) {
  const auto list = text("sentinel1.toml");
  EXPECT_TRUE(says(list, "  satellite, relative to quaternion axes: fixed, "));
  EXPECT_TRUE(says(list,
                   "  ITRF, relative to GCRF: the observed turn of the Earth\n  LVLH, relative to GCRF: of "
                   "the orbit, z along -r, y "
                   "along -(r x v)\n"));
}

TEST(Frames, RefuseWhatIsNotThere) {
  const auto refusal = [](const char* file, const std::string& from, const std::string& to,
                          const std::string& at = "") {
    return complaint([&] { (void)text(file, from, to, at); });
  };
  EXPECT_EQ(refusal("ctim.toml", "radiometre", "GCRF"),
            "--from: the scenario has no frame 'radiometre'; the nearest is 'radiometer'");
  EXPECT_EQ(refusal("ctim.toml", "body", "ITRF"),
            "--to: the scenario has no frame 'ITRF'; it needs orientation = \"FILE\" in [earth]");
  EXPECT_EQ(refusal("ctim.toml", "body", "body"), "--from and --to are one frame, body");
  EXPECT_EQ(refusal("ctim.toml", "body", ""), "--from and --to go together: v_to = R v_from");
  EXPECT_TRUE(says(refusal("ctim.toml", "body", "GCRF", "2023-04-20T04:00:00 UTC"),
                   "is in a gap or outside the samples"));
}

}  // namespace
}  // namespace vectrix::cli::frames_test
