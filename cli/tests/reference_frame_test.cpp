#include "reference_frame.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "check.hpp"
#include "convert.hpp"
#include "cubesat.hpp"
#include "frames.hpp"
#include "pointing.hpp"
#include "pointing_error.hpp"
#include "replay.hpp"
#include "says.hpp"
#include "scenario/replayed.hpp"
#include "table_text.hpp"

namespace vectrix::cli::reference_frame_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;
using earth::Gcrf, earth::Itrf, earth::Teme;
using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

const std::filesystem::path finals =
    std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/finals2000A_april_2023.txt";
// deg. The axes come from texts and other products; ITRF from the polynomials of EarthMotion, 1 microarcsec;
// TEME without dX, dY, 1e-9 rad.
constexpr double rounding = 1e-12, of_polynomials = 3e-10, of_pole = 2e-7;

TEST(ReferenceName, IsOneForManyNames) {
  const auto is = [](const char* name, const char* known) { EXPECT_EQ(reference_name(name), known) << name; };
  is("J2000", "EME2000");
  is("icrf", "GCRF");
  is("TEMEOFDATE", "TEME");
  is("TOD_EARTH", "TOD");
  is("cirf", "CIRF");
  is("ITRF-97", "ITRF");
  is("LVLH_ROTATING", "LVLH");
  is("RSW", "RTN");
  is("tnw_rotating", "TNW");
  for (const char* name : {"SC_BODY_1", "LVLH_INERTIAL", "MCI", "ITRFOLD", "LVLH2", "_ROTATING", ""})
    EXPECT_EQ(reference_name(name), std::nullopt) << name;
}

// Ten minutes of the cubesat, relative to any of the frames.
class RelativeTo : public ::testing::Test {
 protected:
  RelativeTo() {
    AttitudeSource source = cubesat_attitude();
    source.selection.from = Epoch::from_utc("2023-04-20T05:20:00");
    source.selection.until = Epoch::from_utc("2023-04-20T05:30:00");
    truth = read_attitude(source);
    for (std::size_t i = 0; i < truth.size(); ++i)
      gcrf_from_body.push_back(truth.to_reference(i, truth.stated));
    orbit = read_orbit(cubesat_orbit(), from_until(truth.times.front(), truth.times.back()));
  }

  // Its axes are the rows.
  static Matrix3d axes(const Vector3d& x, const Vector3d& y, const Vector3d& z) {
    Matrix3d R;
    R << x.normalized().transpose(), y.normalized().transpose(), z.normalized().transpose();
    return R;
  }
  Matrix3d frame_from_gcrf(const std::string& frame, const Epoch& t) const {
    if (frame == "ITRF" || frame == "TEME") {
      const auto orientation = EarthOrientation::read(finals);
      const Matrix3d R_itrf_from_gcrf = orientation.at(t).rotation.matrix().transpose();
      if (frame == "ITRF") return R_itrf_from_gcrf;
      return teme_from_itrf(t, orientation.parameters(t)).rotation.matrix() * R_itrf_from_gcrf;
    }
    const auto motion = orbit(t);
    const Vector3d r = motion.position.coordinates(), v = motion.velocity.coordinates(), h = r.cross(v);
    if (frame == "LVLH") return axes(h.cross(r), -h, -r);
    if (frame == "RTN") return axes(r, h.cross(r), h);
    if (frame == "TNW") return axes(v, h.cross(v), h);
    if (frame == "NTW") return axes(v.cross(h), v, h);
    return axes(v, h, v.cross(h));  // VNC
  }
  // By which R(q) takes coordinates to the body.
  std::string table(const std::string& frame) const {
    std::string text = "t,w,x,y,z\n";
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Quaterniond q =
          (Quaterniond(frame_from_gcrf(frame, truth.times[i])) * gcrf_from_body[i]).conjugate();
      text += exact_text(truth.times[i], scale::utc);
      add_fields(text, std::array{q.w(), q.x(), q.y(), q.z()});
      text += "\n";
    }
    return text;
  }
  AttitudeSource source(const std::string& frame) const {
    TableColumns columns{"t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_body}, frame, {}};
    return {folder.written("attitude.csv", table(frame)), columns};
  }
  std::vector<double> off_sun() const {
    auto angles = absolute_errors(seen_in_body(truth, directions(truth, Target::sun, geometric, orbit)),
                                  {0.0, 0.0, -1.0});
    for (double& angle : angles) angle *= 180.0 / std::numbers::pi;
    return angles;
  }
  static double near(const std::string& frame) {
    return frame == "TEME" ? of_pole : frame == "ITRF" ? of_polynomials : rounding;
  }

  static constexpr std::array all_frames{"ITRF", "TEME", "LVLH", "RTN", "TNW", "NTW", "VNC"};
  TemporaryFolder folder;
  AttitudeRecord truth;
  std::vector<Quaterniond> gcrf_from_body;
  FlownOrbit orbit;
};

TEST_F(RelativeTo, PointingFindsTheAnglesOfTheAttitudeRelativeToGcrf) {
  for (const std::string frame : all_frames) {
    PointingOptions options;
    options.attitude = source(frame);
    options.orbit = cubesat_orbit();
    options.axis = {0.0, 0.0, -1.0};
    options.correction = geometric;
    options.csv = folder.file("angles.csv");
    options.force = true;
    if (frame == "ITRF") options.orientation = finals;
    std::ostringstream out;
    EXPECT_TRUE(pointing(options, out));
    EXPECT_TRUE(says(out.str(), "relative to " + frame + ", 2023-04-20"));
    const auto found = CsvTable::read(options.csv, {"angle_deg"});
    const auto expected = off_sun();
    ASSERT_EQ(found.rows(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found.number(i, "angle_deg"), expected[i], near(frame)) << frame;
  }
}

TEST_F(RelativeTo, ConvertTurnsItToGcrf) {
  for (const std::string frame : all_frames) {
    ConvertOptions options;
    options.out = folder.file("out.csv");
    options.frame = "GCRF";
    options.force = true;
    options.orbit = cubesat_orbit();
    if (frame == "ITRF") options.orientation = finals;
    std::ostringstream out;
    convert(source(frame), options, out);
    EXPECT_TRUE(says(out.str(), "the attitude is turned from " + frame + " to GCRF"));
    const auto found = CsvTable::read(options.out, {});
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto n = [&](const char* name) {
        return found.number(i, std::string("q_gcrf_from_body_") + name);
      };
      const Quaterniond q(n("w"), n("x"), n("y"), n("z"));
      EXPECT_LE(angle_of(q.conjugate() * gcrf_from_body[i]), near(frame)) << frame;
    }
    // Without --frame it is what it was, in a table that is read again.
    options.frame = "";
    options.orbit = {};
    options.orientation.clear();
    options.out = folder.file("same.csv");
    convert(source(frame), options, out);
    EXPECT_TRUE(says(content(options.out), "--maps reference --reference " + frame + "\n"));
  }
}

// As a message of CCSDS, in check, replay and frames.
TEST_F(RelativeTo, LvlhIsOneFrameEverywhere) {
  std::string message =
      "CCSDS_AEM_VERS = 2.0\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR = ME\nMETA_START\n"
      "OBJECT_NAME = CTIM\nOBJECT_ID = 2022-074G\nREF_FRAME_A = LVLH_ROTATING\nREF_FRAME_B = SC_BODY_1\n"
      "TIME_SYSTEM = UTC\nSTART_TIME = 2023-04-20T05:20:00\nSTOP_TIME = 2023-04-20T05:30:00\n"
      "ATTITUDE_TYPE = QUATERNION\nMETA_STOP\nDATA_START\n";
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Quaterniond q = Quaterniond(frame_from_gcrf("LVLH", truth.times[i])) * gcrf_from_body[i];
    message += exact_text(truth.times[i], scale::utc);
    for (const double number : {q.x(), q.y(), q.z(), q.w()}) message += " " + detail::text(number);
    message += "\n";
  }
  const auto file = folder.written("attitude.aem", message + "DATA_STOP\n");
  CheckOptions options{{file}, cubesat_orbit(), Vector3d(0.0, 0.0, -1.0), Target::sun};
  std::ostringstream out;
  EXPECT_TRUE(check(options, out));
  EXPECT_TRUE(says(out.str(), "SC_BODY_1 relative to LVLH, 2023"));
  EXPECT_TRUE(
      says(out.str(), "LVLH is taken as CCSDS has it, of the orbit relative to GCRF: z along -r, y along"));
  EXPECT_TRUE(says(out.str(), "The file as stated fits, three times better than any other reading."));
  options.orbit = {};
  EXPECT_EQ(
      complaint([&] { (void)check(options, out); }, file),
      "FILE: the attitude is relative to LVLH, a frame of the orbit; missing: --tle, --omm, --oem or --spk");
  options.orientation = finals;
  EXPECT_EQ(
      complaint([&] { (void)check(options, out); }, file),
      "--orientation is of ITRF, TIRF and CIRF; the attitude is relative to LVLH, and there is no --oem");

  const std::string text = "version = 1\ntitle = \"T\"\n[attitude]\nfile = \"" + file.string() +
                           "\"\n[orbit]\ntle = \"" + cubesat_orbit().elements.string() +
                           "\"\n[[measure]]\nname = \"m\"\naxis = \"-z of SC_BODY_1\"\ntarget = \"sun\"\n"
                           "correction = \"geometric\"\n";
  const auto found = replayed_file(folder.written("s.toml", text));
  const auto expected = off_sun();
  ASSERT_EQ(found.measures[0].angles.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found.measures[0].angles[i] * 180.0 / std::numbers::pi, expected[i], rounding);
  const Result result = found.result();
  EXPECT_EQ(result.reference, "GCRF");
  EXPECT_LE(angle_of(result.samples.reference_from_body[3].conjugate() * gcrf_from_body[3]), rounding);
  const std::string without_orbit =
      with(text, "[orbit]\ntle = \"" + cubesat_orbit().elements.string() + "\"\n", "");
  EXPECT_EQ(complaint([&] { (void)replayed_file(folder.written("without.toml", without_orbit)); }, file),
            "FILE: the attitude is relative to LVLH, a frame of the orbit; missing: [orbit]");

  const auto scenario = folder.written("s.toml", text);
  Progress silent(nullptr);
  out.str("");
  EXPECT_TRUE(replay({.file = scenario}, silent, out));
  EXPECT_TRUE(says(out.str(), "of SC_BODY_1 relative to LVLH, 2023"));
  out.str("");
  frames({scenario, "SC_BODY_1", "GCRF", ""}, out);
  EXPECT_TRUE(says(out.str(), "R1: v_LVLH = R1 v_SC_BODY_1; attitude, between the samples of "));
  EXPECT_TRUE(says(out.str(), "R2: v_GCRF = R2 v_LVLH; of the orbit, z along -r, y along -(r x v)"));
  EXPECT_TRUE(says(out.str(), "w is not known: a frame of the orbit"));
}

}  // namespace
}  // namespace vectrix::cli::reference_frame_test
