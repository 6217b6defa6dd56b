#include "words.hpp"

#include <gtest/gtest.h>

#include "newer_leap_seconds.hpp"
#include "space/tests/temporary_file.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::words_test {
namespace {

constexpr const char* aem = "CCSDS_AEM_VERS = 1.0\n";
constexpr const char* oem = "CCSDS_OEM_VERS = 2.0\n";
constexpr const char* table = "t,a,b,c,d\n";

// What a table of an orbit needs, too.
AttitudeWords shared_with_orbit(const std::filesystem::path& file) {
  AttitudeWords words;
  words.file = file;
  words.time = "t";
  words.scale = "gps";
  words.reference = "GCRF";
  return words;
}
AttitudeWords attitude(const std::filesystem::path& file) {
  AttitudeWords words = shared_with_orbit(file);
  words.scale = "tai";
  words.quaternion = "a,b,c,d";
  words.scalar = "first";
  words.maps = "body";
  return words;
}
const OrbitWords orbit{"x,y,z", "u,v,w", "km"};

TEST(Words, SayWhatTheColumnsMean) {
  TemporaryFile file(table);
  AttitudeWords words = attitude(file.path());
  words.rates = "p,q,r";
  words.rate_unit = "deg/s";
  words.rate_axes = "reference";
  words.from = "2026-11-29T00:00:00 TAI";
  const AttitudeSource source = attitude_source(words);
  ASSERT_TRUE(source.columns);
  EXPECT_EQ(std::string(source.columns->scale.name()), "TAI");
  EXPECT_EQ(source.columns->quaternion, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(source.columns->stated.scalar, Convention::Scalar::first);
  EXPECT_EQ(source.columns->stated.maps, Convention::Maps::to_body);
  EXPECT_EQ(source.columns->rates, (std::vector<std::string>{"p", "q", "r"}));
  EXPECT_TRUE(source.columns->rates_in_degrees);
  EXPECT_EQ(source.columns->rate_axes, RateAxes::reference);
  EXPECT_EQ(source.selection.from, Epoch::from("2026-11-29T00:00:00 TAI"));
  const OrbitFile found = orbit_file(shared_with_orbit(file.path()), orbit);
  ASSERT_TRUE(found.columns);
  EXPECT_EQ(std::string(found.columns->scale.name()), "GPS");
  EXPECT_EQ(found.columns->velocity, (std::vector<std::string>{"u", "v", "w"}));
  EXPECT_TRUE(found.columns->in_kilometres);
}

template <class Change> std::string refusal(const std::string& content, const Change& change) {
  TemporaryFile file(content);
  AttitudeWords words = attitude(file.path());
  change(words);
  return complaint([&] { (void)attitude_source(words); }, file.path());
}

TEST(Words, OfATableAreAllNeeded) {
  const std::string missing = "FILE: a table does not say what its columns mean; missing: ";
  const auto alone = [](auto& w) { w = AttitudeWords{w.file}; };
  EXPECT_EQ(refusal(table, alone),
            missing +
                "--time COLUMN, --scale utc|tai|tt|tdb|gps, --quaternion COLUMN,COLUMN,COLUMN,COLUMN, "
                "--scalar first|last, --maps body|reference, --reference EME2000|GCRF");
  EXPECT_EQ(refusal(table, [](auto& w) { w.scale = ""; }), missing + "--scale utc|tai|tt|tdb|gps");
  EXPECT_EQ(refusal(table, [](auto& w) { w.rates = "p,q,r"; }),
            missing + "--rate-unit rad/s|deg/s, --rate-axes body|reference");
  EXPECT_EQ(refusal(table, [](auto& w) { w.rates = "p,q,r", w.rate_unit = "rad/s"; }),
            missing + "--rate-axes body|reference");
  TemporaryFile file(table);
  EXPECT_EQ(complaint([&] { (void)orbit_file(AttitudeWords{file.path()}, {}); }, file.path()),
            missing +
                "--time COLUMN, --scale utc|tai|tt|tdb|gps, --position COLUMN,COLUMN,COLUMN, --velocity "
                "COLUMN,COLUMN,COLUMN, --unit m|km, --reference EME2000|GCRF");
}

TEST(Words, ThatDoNotApplyAreRefused) {
  const std::string message = "FILE: is a message and says itself what its data are; ";
  const auto only = [](std::string AttitudeWords::*word) {
    return [word](AttitudeWords& w) {
      w = AttitudeWords{w.file};
      w.*word = "utc";
    };
  };
  using W = AttitudeWords;
  const std::pair<std::string W::*, const char*> columns[] = {
      {&W::time, "--time"},           {&W::scale, "--scale"},
      {&W::reference, "--reference"}, {&W::quaternion, "--quaternion"},
      {&W::scalar, "--scalar"},       {&W::maps, "--maps"},
      {&W::rates, "--rates"},         {&W::rate_unit, "--rate-unit"},
      {&W::rate_axes, "--rate-axes"}};
  for (const auto& [word, option] : columns)
    EXPECT_EQ(refusal(aem, only(word)), message + option + " is of a table");
  EXPECT_EQ(refusal(table, [](auto& w) { w.segment = "1"; }), "FILE: is a table; --segment is of a message");
  EXPECT_EQ(refusal(table, [](auto& w) { w.rate_unit = "deg/s"; }),
            "FILE: --rate-unit is of rates; missing: --rates COLUMN,COLUMN,COLUMN");
  EXPECT_EQ(refusal(table, [](auto& w) { w.rate_axes = "body"; }),
            "FILE: --rate-axes is of rates; missing: --rates COLUMN,COLUMN,COLUMN");
  EXPECT_EQ(refusal(table, [](auto& w) { w.quaternion = "a,b,b,d"; }),
            "FILE: the column 'b' is named twice by the options");
  EXPECT_EQ(refusal(table, [](auto& w) { w.time = "d"; }),
            "FILE: the column 'd' is named twice by the options");
  for (const char* segment : {"-1", "0", "1.5", "x", "99999999999999999999999"})
    EXPECT_EQ(refusal(aem,
                      [&](auto& w) {
                        w = AttitudeWords{w.file, segment};
                      }),
              std::string("--segment ") + segment + " is no whole number from 1 on");
}

// The times that are asked for have them too.
TEST(Words, OfAKernelMayBringLeapSeconds) {
  const KeptLeapSeconds kept;
  const TemporaryFolder folder;
  AttitudeWords words;
  words.file = folder.written("a.bc", "DAF/CK  ");
  words.until = "2036-01-01T00:00:00 UTC";
  words.kernel.leap_seconds = folder.written("newer.tls", leap_second_kernel(with_an_invented_one));
  EXPECT_EQ(attitude_source(words).selection.until, Epoch::from(scale::tai, "2036-01-01T00:00:38"));
}

TEST(Words, OfAnOrbitAreNotThoseOfAnAttitude) {
  TemporaryFolder folder;
  const auto csv = folder.written("t.csv", table), message = folder.written("a.aem", aem),
             orbit_message = folder.written("o.oem", oem);
  const auto is_orbit = [](const AttitudeWords& words, const OrbitWords& of_orbit) {
    return content_of(words, of_orbit, "", "out.csv").kind == Content::Kind::orbit;
  };
  EXPECT_TRUE(is_orbit({csv}, orbit));
  EXPECT_FALSE(is_orbit({csv}, {}));
  EXPECT_FALSE(is_orbit({message}, {}));
  EXPECT_TRUE(is_orbit({orbit_message}, {}));
  EXPECT_EQ(complaint([&] { (void)content_of({csv}, orbit, "oem", "out.csv"); }, csv),
            "FILE: is no message; --kind is of a combined one");
  EXPECT_TRUE(is_orbit({folder.written("marked.oem", std::string("\xef\xbb\xbf") + oem)}, {}));
  // No message begins so, but it is none of a table either: its reader says what is wrong.
  EXPECT_FALSE(attitude_source({folder.written("c.aem", std::string("COMMENT first\n") + aem)}).columns);
  EXPECT_EQ(complaint(
                [&] {
                  (void)is_orbit({csv}, {"", "", "km"});
                },
                csv),
            "FILE: --unit is of an orbit; missing: --position and --velocity");
  EXPECT_EQ(complaint([&] { (void)is_orbit({message}, orbit); }, message),
            "FILE: is a message and says itself what its data are; --position is of a table");
  EXPECT_EQ(complaint(
                [&] {
                  (void)orbit_file({orbit_message, "", "", "", "t"}, {});
                },
                orbit_message),
            "FILE: is a message and says itself what its data are; --time is of a table");
  AttitudeWords words = shared_with_orbit(csv);
  words.maps = "body";
  EXPECT_EQ(
      complaint([&] { (void)orbit_file(words, orbit); }),
      "--maps is of an attitude, --position and --velocity are of an orbit; one is converted at a time");
  words = shared_with_orbit(csv);
  words.segment = "1";
  EXPECT_EQ(complaint([&] { (void)orbit_file(words, orbit); }, csv),
            "FILE: is a table; --segment is of a message");
  words = shared_with_orbit(csv);
  EXPECT_EQ(complaint(
                [&] {
                  (void)orbit_file(words, {"x,y,z", "x,v,w", "m"});
                },
                csv),
            "FILE: the column 'x' is named twice by the options");
}

TEST(Words, OfAMessageAreForOne) {
  const auto refused = [](const char* out, bool of_orbit, const MessageWords& words) {
    ConvertOptions options{out};
    return complaint([&] { set_message_words(options, words, of_orbit); });
  };
  MessageWords words;
  words.object_name = "S";
  EXPECT_EQ(refused("out.csv", true, words), "out.csv: is to be a table; --object-name is of a message");
  words = {};
  words.aem_version = "1.0";
  EXPECT_EQ(refused("out.csv", false, words), "out.csv: is to be a table; --aem-version is of a message");
  EXPECT_EQ(refused("out.oem", true, words), "--aem-version is of an attitude, and an orbit is converted");
  words = {};
  words.body = "B";
  EXPECT_EQ(refused("out.oem", true, words), "--body is of an attitude, and an orbit is converted");
  words = {};
  words.interpolation = {"hermite", "7"};
  EXPECT_EQ(refused("out.aem", false, words), "--interpolation is of an orbit, and an attitude is converted");
  EXPECT_EQ(refused("out.csv", true, words), "out.csv: is to be a table; --interpolation is of a message");
  ConvertOptions options{"out.oem"};
  set_message_words(options, words, true);
  ASSERT_TRUE(options.interpolation);
  EXPECT_EQ(options.interpolation->name(), "HERMITE interpolation of degree 7");
  EXPECT_EQ(options.aem_version, "2.0");
}

TEST(Words, OfAnInterpolationSayMethodAndDegree) {
  const auto refused = [](const char* method, const char* degree, const char* message) {
    OrbitSource source{{}, message};
    return complaint([&] { set_orbit_words(source, {method, degree}); });
  };
  const std::string together = "--interpolation and --degree go together: --interpolation hermite --degree 7";
  EXPECT_EQ(refused("hermite", "", "o.oem"), together);
  EXPECT_EQ(refused("", "7", "o.oem"), together);
  EXPECT_EQ(refused("hermite", "-3", "o.oem"), "--degree -3 is no whole number from 1 on");
  EXPECT_EQ(refused("hermite", "4", "o.oem"),
            "HERMITE interpolation of degree 4 does not exist; the degree is odd, 3 to 15");
  EXPECT_EQ(refused("lagrange", "16", "o.oem"),
            "LAGRANGE interpolation of degree 16 does not exist; the degree is 2 to 15");
  EXPECT_EQ(refused("lagrange", "1", "o.oem"),
            "LAGRANGE interpolation of degree 1 does not exist; the degree is 2 to 15");
  EXPECT_EQ(refused("lagrange", "8", ""), "--interpolation is of an orbit message; missing: --oem FILE");
  EXPECT_EQ(refused("lagrange", "8", "o.oem"), "nothing was thrown");
  EXPECT_EQ(refused("", "", ""), "nothing was thrown");
  OrbitSource source{{}, "o.oem"};
  source.satellite.value = "25544";
  EXPECT_EQ(complaint([&] { set_orbit_words(source, {}); }),
            "--satellite is of elements; missing: --tle FILE or --omm FILE");
}

}  // namespace
}  // namespace vectrix::cli::words_test
