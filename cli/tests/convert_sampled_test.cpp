#include <gtest/gtest.h>

#include <sstream>

#include "convert.hpp"
#include "flown_orbit.hpp"
#include "says.hpp"
#include "temporary_folder.hpp"
#include "words.hpp"

namespace vectrix::cli::convert_sampled_test {
namespace {

using earth::Gcrf;

const auto data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
const auto lines = data / "CTIM_20230419.tle", kernel = data / "CTIM_20230420_orbit.bsp";
constexpr const char *from = "2023-04-20T05:30:00 UTC", *until = "2023-04-20T05:33:20 UTC";

ConvertOptions options_to(const std::filesystem::path& out) {
  ConvertOptions options;
  options.out = out;
  options.text = {"CTIM", "2022-074G", "TEST", "2026-11-29T00:00:00"};
  options.force = true;
  return options;
}
std::string convert_to(const SampledOrbit& source, const std::filesystem::path& out,
                       const std::string& frame = "") {
  ConvertOptions options = options_to(out);
  options.frame = frame;
  std::ostringstream said;
  convert(source, options, said);
  return said.str();
}
constexpr double rounding = 1e-7;  // m, of 7e6 turned there and back, at 8 km/s in 1e-11 s; m/s

class ConvertSampled : public ::testing::Test {
 protected:
  TemporaryFolder folder;
};

TEST_F(ConvertSampled, WritesTheOrbitOfElementsInTheirFrame) {
  const auto out = folder.file("out.oem"), message = folder.file("set.omm");
  EXPECT_EQ(
      convert_to({lines, from, until, "60"}, out),
      out.string() +
          ": 4 samples of an orbit in TEME\n  not to the last digit: the states are computed by SGP4\n");
  const Sgp4<Satellite> sgp4(TwoLineElements::read(lines).front().mean_elements(), at_most(72.0 * si::hour));
  const auto record = read_orbit_file({out});
  EXPECT_EQ(record.lines.ref_frame, "TEME");
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& line = record.lines.lines[i];
    EXPECT_EQ(line.time, Epoch::from_utc("2023-04-20T05:3" + std::to_string(i) + ":00"));
    const auto expected = sgp4.at(line.time);
    EXPECT_LE((line.position - expected.position.coordinates()).norm(), rounding);
    // SGP4 takes TEME for inertial, and so do the edges of the library: 5e-5 m/s.
    EXPECT_LE((line.velocity - expected.velocity.coordinates()).norm(), rounding);
  }
  std::ostringstream said;
  convert(ElementFile{lines}, options_to(message), said);
  const auto of_message = folder.file("of_message.oem");
  convert_to({message, from, until, "60"}, of_message);
  EXPECT_EQ(content(of_message), content(out));
}

TEST_F(ConvertSampled, WritesTheOrbitOfAKernel) {
  const auto out = folder.file("out.oem"), turned = folder.file("turned.csv");
  EXPECT_TRUE(says(convert_to({kernel, from, until, "50"}, out), ": 5 samples of an orbit in GCRF\n"));
  const auto orbit = orbit_of_kernel(kernel, from_until(Epoch::from(from), Epoch::from(until)));
  for (const auto& line : read_orbit_file({out}).lines.lines) {
    const auto expected = orbit(line.time);
    EXPECT_LE((line.position - expected.position.coordinates()).norm(), rounding);
    EXPECT_LE((line.velocity - expected.velocity.coordinates()).norm(), rounding);
  }
  EXPECT_TRUE(says(convert_to({kernel, from, until, "50"}, turned, "EME2000"), "in EME2000\n"));
}

TEST_F(ConvertSampled, NeedsInstantsThatTheFileHas) {
  const auto out = folder.file("out.oem");
  const auto refused = [&](const SampledOrbit& source) {
    return complaint([&] { (void)convert_to(source, out); }, source.file);
  };
  EXPECT_EQ(refused({lines}), "FILE: has no samples; missing: --from TIME, --until TIME, --step SECONDS");
  EXPECT_EQ(refused({lines, from, until}), "FILE: has no samples; missing: --step SECONDS");
  EXPECT_EQ(refused({lines, until, from, "1"}),
            std::string("--until ") + from + " is not after --from " + until);
  for (const std::string step : {"0", "-1", "nan", "1 s"})
    EXPECT_EQ(refused({lines, from, until, step}), "--step " + step + " is no positive number of seconds");
  EXPECT_EQ(refused({lines, from, until, "201"}), "--step 201 makes 1 instants; it must be 2 to 10000000");
  EXPECT_TRUE(says(refused({lines, from, "2023-05-20T00:00:00 UTC", "3600"}),
                   "31 days from the times that are looked at; at most 7 are allowed"));
  EXPECT_TRUE(says(refused({kernel, from, "2023-05-20T00:00:00 UTC", "3600"}),
                   "at 2023-04-22T10:30:00.000000 UTC its segments lead from -152950 to -152950, of which "
                   "they have nothing then"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(ConvertSampled, IsMeantByTheStepOrTheNameOfTheFile) {
  const auto kind = [&](const std::filesystem::path& file, const char* out, const std::string& step) {
    return content_of({file}, {}, "", out, step).kind;
  };
  using Kind = Content::Kind;
  EXPECT_EQ(kind(lines, "a.xml", ""), Kind::elements);
  EXPECT_EQ(kind(lines, "a.xml", "60"), Kind::sampled);
  EXPECT_EQ(kind(lines, "a.oem", ""), Kind::sampled);
  EXPECT_EQ(kind(lines, "a.csv", ""), Kind::sampled);
  EXPECT_EQ(kind(lines, "a.omm", ""), Kind::elements);
  EXPECT_EQ(kind(kernel, "a.oem", ""), Kind::sampled);
  const auto table = folder.written("t.csv", "t,q\n1,2\n");
  EXPECT_EQ(complaint([&] { (void)kind(table, "a.aem", "60"); }, table),
            "FILE: has samples; --step is of elements of SGP4, or of a kernel of an orbit (SPK)");
  const auto refused = [&](AttitudeWords words, ConvertOptions options) {
    return complaint([&] { (void)sampled_orbit_of(words, {}, options, "60"); }, words.file);
  };
  AttitudeWords words{kernel};
  words.scale = "utc";
  EXPECT_EQ(refused(words, {}), "FILE: has no samples; --scale is not of it");
  words.scale.clear();
  ConvertOptions options;
  options.orbit.satellite.value = "52950";
  EXPECT_EQ(refused(words, options), "FILE: has no samples; --satellite is of elements");
}

}  // namespace
}  // namespace vectrix::cli::convert_sampled_test
