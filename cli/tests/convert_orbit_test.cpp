#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "convert.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::convert_orbit_test {
namespace {

using earth::Eme2000, earth::Gcrf;

const ConvertOptions named{{}, {}, {"S", "2026-001A", "TEST", "2026-11-29T00:00:00"}};

std::string convert_to(const OrbitFile& source, const std::filesystem::path& out,
                       const std::string& frame = "") {
  ConvertOptions options = named;
  options.out = out;
  options.frame = frame;
  std::ostringstream said;
  convert(source, options, said);
  return said.str();
}

// The table that convert writes.
const OrbitColumns written{"time_tdb",
                           scale::tdb,
                           {"x_in_gcrf_m", "y_in_gcrf_m", "z_in_gcrf_m"},
                           {"vx_in_gcrf_m_per_s", "vy_in_gcrf_m_per_s", "vz_in_gcrf_m_per_s"},
                           false,
                           "GCRF"};

bool same(const OrbitRecord& a, const OrbitRecord& b) {
  bool equal = a.lines.lines.size() == b.lines.lines.size() && a.lines.ref_frame == b.lines.ref_frame &&
               std::string(a.time_scale.name()) == b.time_scale.name();
  for (std::size_t i = 0; equal && i < a.lines.lines.size(); ++i) {
    const auto &left = a.lines.lines[i], &right = b.lines.lines[i];
    equal = left.time == right.time && left.position == right.position && left.velocity == right.velocity;
  }
  return equal;
}

// Sixteen digits.
std::string any_decimal(const char* exponent) {
  return std::to_string(*rc::gen::inRange<std::int64_t>(-9'999'999'999'999'999, 9'999'999'999'999'999)) +
         exponent;
}

RC_GTEST_PROP(ConvertOrbit, LosesNoDigit, ()) {
  TemporaryFolder folder;
  const bool kilometres = *rc::gen::arbitrary<bool>();
  const OrbitColumns columns{"t", scale::tdb, {"x", "y", "z"}, {"u", "v", "w"}, kilometres, "ICRF"};
  std::string text = "t,x,y,z,u,v,w\n";
  const auto start = Epoch::from_utc("2026-11-29T00:00:00");
  for (int i = 0; i < 4; ++i) {
    const auto picoseconds = *rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000);
    text +=
        exact_text(start + (60.0 * i + 1e-12 * static_cast<double>(picoseconds)) * si::second, scale::tdb);
    for (int k = 0; k < 3; ++k) text += "," + any_decimal(kilometres ? "e-12" : "e-9");
    for (int k = 0; k < 3; ++k) text += "," + any_decimal(kilometres ? "e-15" : "e-12");
    text += "\n";
  }
  const OrbitFile first{folder.written("first.csv", text), columns}, second{folder.file("second.oem")},
      third{folder.file("third.csv"), written}, fourth{folder.file("fourth.oem")};
  const OrbitRecord expected = read_orbit_file(first);
  const std::string report = ": 4 samples of an orbit in GCRF\n";
  RC_ASSERT(convert_to(first, second.file) == second.file.string() + report);
  RC_ASSERT(same(read_orbit_file(second), expected));
  RC_ASSERT(convert_to(second, third.file) == third.file.string() + report);
  RC_ASSERT(same(read_orbit_file(third), expected));
  RC_ASSERT(convert_to(third, fourth.file) == fourth.file.string() + report);
  RC_ASSERT(content(second.file) == content(fourth.file));
}

std::string message(const std::string& frame, const std::string& rest = "") {
  return "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2020-01-01T00:00:00\nORIGINATOR = SOMEONE\nMETA_START\n"
         "OBJECT_NAME = SAT\nOBJECT_ID = 2020-007B\nCENTER_NAME = EARTH\nREF_FRAME = " +
         frame +
         "\nTIME_SYSTEM = UTC\nSTART_TIME = 2026-11-29T00:00:00\nSTOP_TIME = 2026-11-29T00:03:00\n"
         "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 7\nMETA_STOP\n"
         "2026-11-29T00:00:00 6778.0669 1000 2000 3 4 7.5 1e-3 2e-3 8e-3\n"
         "2026-11-29T00:01:00 6778.0669 1000 2000 3 4 7.5 1e-3 2e-3 8e-3\n"
         "2026-11-29T00:03:00 6778.0669 1000 2000 3 4 7.6 1e-3 2e-3 8e-3\n" +
         rest;
}
constexpr const char* covariances =
    "COVARIANCE_START\nEPOCH = 2026-11-29T00:00:00\n1\n0 1\n0 0 1\n0 0 0 1\n0 0 0 0 1\n0 0 0 0 0 1\n"
    "EPOCH = 2026-11-29T00:03:00\n2\n0 1\n0 0 1\n0 0 0 1\n0 0 0 0 1\n0 0 0 0 0 1\nCOVARIANCE_STOP\n";

TEST(ConvertOrbit, TurnsPositionsVelocitiesAndAccelerationsToTheOtherFrame) {
  TemporaryFolder folder;
  const auto in = folder.written("in.oem", message("J2000", covariances)), out = folder.file("out.oem");
  EXPECT_EQ(convert_to({in}, out, "ICRF"), out.string() +
                                               ": 3 samples of an orbit in GCRF\n  not to the last digit: "
                                               "the orbit is turned from EME2000 to GCRF\n");
  const auto before = OrbitEphemerisMessage::read(in).segments()[0],
             after = OrbitEphemerisMessage::read(out).segments()[0];
  const auto R_gcrf_from_eme = inverse(eme2000_from_gcrf());
  const auto old = before.samples<Eme2000, Satellite>();
  const auto found = after.samples<Gcrf, Satellite>();
  const auto old_a = before.accelerations<Eme2000, Satellite>();
  const auto found_a = after.accelerations<Gcrf, Satellite>();
  constexpr double rounding = 1e-8;  // m, of 7000 km; more than enough for the others
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE((found[i].motion.position.coordinates() -
               R_gcrf_from_eme.matrix() * old[i].motion.position.coordinates())
                  .norm(),
              rounding);
    EXPECT_LE((found[i].motion.velocity.coordinates() -
               R_gcrf_from_eme.matrix() * old[i].motion.velocity.coordinates())
                  .norm(),
              rounding);
    EXPECT_LE((found_a[i].coordinates() - R_gcrf_from_eme.matrix() * old_a[i].coordinates()).norm(),
              rounding);
    EXPECT_GT((found[i].motion.position.coordinates() - old[i].motion.position.coordinates()).norm(), 0.1);
  }
  EXPECT_EQ(after.metadata().object_name, "S");
  EXPECT_EQ(after.metadata().interpolation, "HERMITE");
  ASSERT_EQ(after.covariances().size(), 2U);
  EXPECT_EQ(after.covariances()[0].ref_frame, "J2000");
}

TEST(ConvertOrbit, KeepsAnyFrameAndSaysWhatATableLeavesOut) {
  TemporaryFolder folder;
  OrbitFile in{folder.written("in.oem", message("TEME", covariances))};
  const auto out = folder.file("out.csv"), part = folder.file("part.oem");
  EXPECT_EQ(convert_to(in, out),
            out.string() + ": 3 samples of an orbit in TEME\n  left out: 2 covariances\n");
  const auto table =
      CsvTable::read(out, {"time_utc", "x_in_teme_m", "vz_in_teme_m_per_s", "az_in_teme_m_per_s2"});
  EXPECT_EQ(table.number(0, "x_in_teme_m"), 6778066.9);
  EXPECT_EQ(table.number(2, "vz_in_teme_m_per_s"), 7600.0);
  EXPECT_EQ(table.number(2, "az_in_teme_m_per_s2"), 8.0);
  in.selection.from = Epoch::from("2026-11-29T00:00:30 UTC");
  convert_to(in, part);
  const auto after = OrbitEphemerisMessage::read(part).segments()[0];
  EXPECT_EQ(after.size(), 2U);
  EXPECT_EQ(after.covariances().size(), 1U);
  EXPECT_EQ(after.metadata().start_time, Epoch::from_utc("2026-11-29T00:01:00"));
  in.selection = {{}, {}, Epoch::from("2026-11-29T00:02:00 UTC")};
  const auto early = folder.file("early.oem");
  convert_to(in, early);
  const auto before = OrbitEphemerisMessage::read(early).segments()[0];
  ASSERT_EQ(before.covariances().size(), 1U);
  EXPECT_EQ(before.covariances()[0].epoch, Epoch::from_utc("2026-11-29T00:00:00"));
}

TEST(ConvertOrbit, StatesTheInterpolationThatIsGiven) {
  TemporaryFolder folder;
  ConvertOptions options = named;
  options.out = folder.file("out.oem");
  options.interpolation = Interpolation{"LAGRANGE", 2};
  std::ostringstream said;
  convert(OrbitFile{folder.written("in.oem", message("GCRF"))}, options, said);
  const auto after = OrbitEphemerisMessage::read(options.out).segments()[0];
  EXPECT_EQ(after.metadata().interpolation, "LAGRANGE");
  EXPECT_EQ(after.metadata().interpolation_degree, 2);
}

TEST(ConvertOrbit, SaysHowToReadATableAboutTheEarthOnly) {
  TemporaryFolder folder;
  const auto out = folder.file("out.csv"), of_mars = folder.file("mars.csv");
  convert_to({folder.written("in.oem", message("GCRF"))}, out);
  EXPECT_TRUE(says(content(out), "# Options to read it: --time time_utc "));
  auto mars = message("GCRF");
  mars.replace(mars.find("EARTH"), 5, "MARS");
  convert_to({folder.written("mars.oem", mars)}, of_mars);
  EXPECT_TRUE(says(content(of_mars), "# Of SAT relative to the centre of MARS.\ntime_utc,"));
}

TEST(ConvertOrbit, KeepsWithinTheUseableTimes) {
  TemporaryFolder folder;
  auto useable = message("GCRF");
  useable.insert(useable.find("STOP_TIME"), "USEABLE_STOP_TIME = 2026-11-29T00:02:00\n");
  OrbitFile in{folder.written("in.oem", useable)};
  in.selection.from = Epoch::from("2026-11-29T00:00:30 UTC");
  const auto out = folder.file("out.oem");
  convert_to(in, out);
  EXPECT_EQ(OrbitEphemerisMessage::read(out).segments()[0].metadata().useable_stop_time,
            Epoch::from_utc("2026-11-29T00:02:00"));
  useable.replace(useable.find("00:02:00"), 8, "00:00:20");
  in.file = folder.written("late.oem", useable);
  EXPECT_EQ(complaint([&] { convert_to(in, folder.file("none.oem")); }, in.file),
            "FILE: none of the times is within USEABLE_START_TIME and USEABLE_STOP_TIME");
}

TEST(ConvertOrbit, CountsOneCovariance) {
  TemporaryFolder folder;
  OrbitFile in{folder.written("in.oem", message("TEME", covariances))};
  in.selection.from = Epoch::from("2026-11-29T00:00:30 UTC");
  const auto out = folder.file("out.csv");
  EXPECT_EQ(convert_to(in, out),
            out.string() + ": 2 samples of an orbit in TEME\n  left out: 1 covariance\n");
}

TEST(ConvertOrbit, RefusesWhatItCannotSay) {
  TemporaryFolder folder;
  const auto refusal = [&](const OrbitFile& source, const std::string& out, const std::string& frame = "") {
    return complaint([&] { (void)convert_to(source, folder.file(out), frame); }, source.file);
  };
  const auto in = folder.written("in.oem", message("ITRF2000"));
  EXPECT_EQ(refusal({in}, "out.oem", "GCRF"),
            "FILE: from ITRF to GCRF needs the orientation of the Earth; missing: --orientation FILE");
  EXPECT_EQ(
      refusal({folder.written("mci.oem", message("MCI"))}, "out.oem", "GCRF"),
      "FILE: the orbit is in 'MCI'; --frame turns EME2000, J2000, GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD "
      "and MOD into each other");
  EXPECT_TRUE(says(refusal({in}, "out.aem"),
                   "the name ends in none of .oem, .xml, .csv, .czml and .a, which say what to write"));
  EXPECT_EQ(refusal({in}, "in.oem"), "FILE: is the same file as " + in.string() + ", which is read");
  EXPECT_EQ(content(in), message("ITRF2000"));
  auto stopped = message("TOD");
  stopped.insert(stopped.find("TIME_SYSTEM"), "REF_FRAME_EPOCH = 2026-01-01T00:00:00\n");
  EXPECT_EQ(refusal({folder.written("tod.oem", stopped)}, "out.csv"),
            "FILE: a table does not say that REF_FRAME_EPOCH stops TOD");
  auto mixed = message("GCRF");
  mixed.erase(mixed.rfind(" 1e-3 2e-3 8e-3"), 15);
  EXPECT_EQ(refusal({folder.written("mixed.oem", mixed)}, "out.csv"),
            "FILE: some lines have an acceleration, others have none; a table has them for all");
  const auto table = [&](const std::string& rows) {
    const auto file = folder.written("t.csv", "t,x,y,z,u,v,w\n" + rows);
    return refusal({file, OrbitColumns{"t", scale::utc, {"x", "y", "z"}, {"u", "v", "w"}, true, "GCRF"}},
                   "out.oem");
  };
  EXPECT_EQ(table(""), "FILE: there are no samples");
  EXPECT_EQ(table("2026-11-29T00:00:00,1,2,3,4,5,6\n2026-11-29T00:00:00,1,2,3,4,5,6\n"),
            "table FILE, line 3, column 1 ('t'): 2026-11-29T00:00:00 is not after the row before");
  EXPECT_EQ(table("2026-11-29T00:00:00,1,2,nan,4,5,6\n"),
            "table FILE, line 2, column 4 ('z'): 'nan' times 10^3 is not a finite number");
  for (const char* out : {"out.oem", "out.csv"}) EXPECT_FALSE(std::filesystem::exists(folder.file(out)));
}

}  // namespace
}  // namespace vectrix::cli::convert_orbit_test
