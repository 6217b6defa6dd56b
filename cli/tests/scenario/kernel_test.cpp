#include <gtest/gtest.h>

#include <algorithm>

#include "circular_orbit.hpp"
#include "newer_leap_seconds.hpp"
#include "replayed.hpp"
#include "says.hpp"
#include "space/tests/files/daf_text.hpp"

namespace vectrix::cli::kernel_test {
namespace {

const std::filesystem::path data = examples / "data";
const std::string attitude_kernel = (data / "CTIM_20230420_attitude.bc").string(),
                  clock_kernel = (data / "CTIM_clock.tsc").string(),
                  frame_kernel = (data / "CTIM_frames.tf").string(),
                  orbit_kernel = (data / "CTIM_20230420_orbit.bsp").string();

std::string key(const char* name, const std::string& value) {
  return std::string(name) + " = \"" + value + "\"\n";
}

// The example with these lines as its attitude, of a body with the name of the frame kernel.
std::string of_kernel(const std::string& lines) {
  std::string text = example("ctim.toml");
  const auto begin = text.find("file = "), end = text.find("[[frame]]");
  text.replace(begin, end - begin, lines);
  return with(text, "to = \"body\"", "to = \"CTIM_COORD\"");
}
const std::string attitude = key("file", attitude_kernel) + key("clock", clock_kernel),
                  named = attitude + key("frames", frame_kernel) + "gap = \"30 s\"\n";

// The same flight as the table, whose times are printed to the millisecond, as the clock has them.
TEST(ScenarioKernel, HasTheAttitudeOfTheTable) {
  const auto of_table = replayed(example("ctim.toml")), found = replayed(of_kernel(named));
  EXPECT_EQ(found.flight.attitude.body, "CTIM_COORD");
  const auto &angles = found.measures[0].angles, &expected = of_table.measures[0].angles;
  ASSERT_EQ(angles.size(), expected.size());
  constexpr double turned = 1e-9;  // rad: in 1e-7 s, to which kernels have times, at most 0.01 rad/s
  for (std::size_t i = 0; i < angles.size(); ++i) EXPECT_NEAR(angles[i], expected[i], turned);
  ASSERT_EQ(found.judged.size(), of_table.judged.size());
  for (std::size_t i = 0; i < found.judged.size(); ++i) {
    EXPECT_EQ(found.judged[i].reached, of_table.judged[i].reached);  // to 1e-6 deg
    EXPECT_EQ(found.judged[i].fulfilled, of_table.judged[i].fulfilled);
  }
}

// Two orbits of one flight: kilometres apart, at the distance of the Sun.
TEST(ScenarioKernel, HasTheOrbitOfTheElements) {
  const std::string of_elements = of_kernel(named);
  const auto by_elements = replayed(of_elements),
             found = replayed(with(of_elements, "tle = \"" + (data / "CTIM_20230419.tle").string(),
                                   "spk = \"" + orbit_kernel));
  double apart = 0.0;
  for (std::size_t i = 0; i < found.flight.motions.size(); ++i)
    apart = std::max(apart, (found.flight.motions[i].position.coordinates() -
                             by_elements.flight.motions[i].position.coordinates())
                                .norm());
  EXPECT_GT(apart, 0.0);
  constexpr double of_a_day = 20e3;  // m, of elements that are a day old
  EXPECT_LT(apart, of_a_day);
  const auto report = found.report();
  const auto has = [](const auto& all, const auto& is) { return std::any_of(all.begin(), all.end(), is); };
  for (const auto& file : {attitude_kernel, clock_kernel, frame_kernel, orbit_kernel})
    EXPECT_TRUE(has(report.inputs, [&](const auto& input) { return input.path == file; })) << file;
  EXPECT_TRUE(has(report.facts, [](const auto& fact) { return fact.value == orbit_kernel; }));
  EXPECT_TRUE(has(report.choices, [](const auto& choice) {
    return choice.by == attitude_kernel &&
           choice.value == "R(q) takes coordinates to CTIM_COORD, the scalar is first";
  }));
}

// One circle, as a kernel of type 13 and as a message, both with Hermite polynomials of degree 7.
class ScenarioOrbitKernel : public ::testing::Test, protected ScenarioFolder {
 protected:
  ScenarioOrbitKernel() {
    std::vector<double> states, times;
    std::vector<PositionSample<earth::Gcrf, Satellite, Epoch>> samples;
    for (double seconds = -600.0; seconds <= 600.0; seconds += 60.0) {
      const auto motion = circular_orbit<earth::Gcrf>(seconds);
      const Epoch t = Epoch::from_utc("2026-11-29T00:00:00") + seconds * si::second;
      samples.push_back({t, motion});
      for (const Eigen::Vector3d& numbers :
           {Eigen::Vector3d(motion.position.coordinates()), Eigen::Vector3d(motion.velocity.coordinates())})
        for (const double number : numbers) states.push_back(1e-3 * number);
      const auto date = t.julian_date(scale::tdb);
      times.push_back(86400.0 * (date.day - 2451545.0 + date.fraction));
    }
    std::vector<double> numbers = states;
    numbers.insert(numbers.end(), times.begin(), times.end());
    numbers.insert(numbers.end(), {3.0, static_cast<double>(times.size())});  // of 4 states
    folder.written("o.bsp",
                   daf_bytes("SPK", {{"S", {times.front(), times.back()}, {-77, 399, 1, 13}, numbers}}));
    EphemerisMetadata metadata{"SATELLITE", "2026-001A"};
    metadata.interpolation = "HERMITE";
    metadata.interpolation_degree = 7;
    folder.written("o.oem", OrbitEphemerisMessage({"2.0", "2026-11-29T00:00:00", "TEST"},
                                                  {OrbitEphemerisSegment(metadata, samples)})
                                .text());
  }
  [[nodiscard]] std::vector<SatelliteMotion> motions(const std::string& orbit) const {
    Progress silent(nullptr);
    return read_flight(read(plain + ("[orbit]\n" + orbit)), silent).motions;
  }
};

TEST_F(ScenarioOrbitKernel, IsTheOrbitOfTheMessage) {
  const auto of_kernel = motions("spk = \"o.bsp\"\n"), of_message = motions("oem = \"o.oem\"\n");
  ASSERT_EQ(of_kernel.size(), 3U);
  // 7.6 km/s in 2e-5 s, by which TDB and the time of SPICE differ. In EME2000 it would be 0.8 m off.
  constexpr double of_time = 0.2;  // m
  for (std::size_t i = 0; i < of_kernel.size(); ++i) {
    EXPECT_LE((of_kernel[i].position.coordinates() - of_message[i].position.coordinates()).norm(), of_time);
    EXPECT_LE((of_kernel[i].velocity.coordinates() - of_message[i].velocity.coordinates()).norm(),
              1e-3 * of_time);
  }
}

class ScenarioKernelWords : public ::testing::Test, protected ScenarioFolder {
 protected:
  [[nodiscard]] std::string said(const std::string& lines) const {
    return complaint([&] { (void)read_flown_attitude(read(of_kernel(lines))); }, file());
  }
};

TEST_F(ScenarioKernelWords, RefuseWhatDoesNotGoTogether) {
  const std::string is = attitude_kernel + " is a kernel of SPICE and says it itself";
  EXPECT_EQ(said(named), "nothing was thrown");
  EXPECT_EQ(said(key("file", attitude_kernel)),
            "FILE:14:1: 'attitude.clock' is missing: a kernel of SPICE needs it");
  EXPECT_EQ(said(attitude + "segment = 1\n"), "FILE:17:11: 'attitude.segment' is of a message; " + is);
  EXPECT_EQ(said(attitude + "time = { column = \"t\", scale = \"UTC\" }\n"),
            "FILE:17:8: 'attitude.time' is of a table; " + is);
  EXPECT_EQ(said(attitude + "kernel_frame = \"-7\"\n"),
            "FILE:17:16: DAF file " + attitude_kernel + ": it has the frames -152950000; kernel_frame is -7");
  EXPECT_EQ(said(attitude + "kernel_frame = \"NOPE\"\n"),
            "FILE:17:16: kernel_frame NOPE: this is no number, and no frame kernel is given");
  EXPECT_EQ(
      said(named + "kernel_frame = \"NOPE\"\n"),
      "FILE:19:16: kernel_frame NOPE: this is no number, and " + frame_kernel + " has no frame of this name");
  EXPECT_EQ(said(named + "kernel_frame = \"CTIM_COORD\"\n"), "nothing was thrown");
  EXPECT_EQ(said(key("file", attitude_kernel) + key("clock", "nowhere.tsc")),
            "FILE:16:9: there is no file " + folder.file("nowhere.tsc").string() +
                "; names are relative to the folder of this file");
}

TEST_F(ScenarioKernelWords, SayWhichFramesThereAre) {
  const auto record = [](std::int32_t frame) {
    return DafTestArray{"S", {0.0, 1.0}, {frame, 1, 3, 0}, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0}};
  };
  const auto two = folder.written("two.bc", daf_bytes("CK", {record(-1000), record(-2000)})).string();
  EXPECT_EQ(
      said(key("file", two) + key("clock", clock_kernel)),
      "DAF file " + two + ": it has the frames -2000, -1000; missing: kernel_frame = \"NAME\" in [attitude]");
}

TEST_F(ScenarioKernelWords, RefuseAKernelsKeysOfATable) {
  folder.written("c.tsc", "");
  EXPECT_EQ(
      refusal("[attitude.quaternion]", "clock = \"c.tsc\"\n[attitude.quaternion]"),
      "FILE:6:9: 'attitude.clock' is of a kernel of SPICE; " + folder.file("a.csv").string() + " is none");
  EXPECT_EQ(refusal_with("[orbit]\nspk = \"c.tsc\"\ninterpolation = { method = \"hermite\", degree = 3 }\n"),
            "FILE:21:17: 'orbit.interpolation' is of a table or an OEM, 'orbit.spk' is given");
}

// What a scenario uses is used by the process.
class ScenarioLeapSeconds : public ScenarioKernelWords {
 protected:
  // Of a scenario from 2023 until 2036.
  [[nodiscard]] std::string with_kernel(const std::filesystem::path& kernel) const {
    return with(of_kernel(named + key("leap_seconds", kernel.string())), "2023-04-20T06:10:00Z",
                "2036-01-01T00:00:00Z");
  }

 private:
  KeptLeapSeconds kept_;
};

TEST_F(ScenarioLeapSeconds, AreForTheTimesOfTheScenario) {
  const auto newer = folder.written("newer.tls", leap_second_kernel(with_an_invented_one));
  const auto scenario = read(with_kernel(newer));
  EXPECT_EQ(scenario.end.value(), Epoch::from(scale::tai, "2036-01-01T00:00:38"));
  EXPECT_NE(std::find(scenario.inputs.begin(), scenario.inputs.end(), newer), scenario.inputs.end());
}

TEST_F(ScenarioLeapSeconds, AreAllThatAreKnown) {
  const auto older = folder.written("older.tls", leap_second_kernel(""));
  EXPECT_EQ(refusal(with_kernel(older)), "FILE:19:16: " + older.string() +
                                             ": use_leap_seconds: the table ends where ERFA has 2017-01, "
                                             "37 s");
  EXPECT_EQ(refusal(with_kernel(clock_kernel)).substr(0, 12), "FILE:19:16: ");
}

}  // namespace
}  // namespace vectrix::cli::kernel_test
