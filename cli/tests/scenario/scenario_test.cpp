#include "scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "says.hpp"
#include "scenario/fixed_frame.hpp"
#include "scenario/flight.hpp"
#include "scenario_folder.hpp"

namespace vectrix::cli::scenario_test {
namespace {

using Eigen::Vector3d;

class ScenarioWords : public ::testing::Test, protected ScenarioFolder {
 protected:
  // What is said when also the attitude is read.
  [[nodiscard]] std::string flown_refusal(const std::string& text) const {
    return complaint([&] { (void)read_flown_attitude(read(text)); }, file());
  }
  [[nodiscard]] BodyFrames frames(const std::string& lines) const {
    return read_flown_attitude(read(plain + lines)).frames;
  }
};

TEST_F(ScenarioWords, SayBetweenWhichFramesTheQuaternionMaps) {
  EXPECT_EQ(refusal("to = \"GCRF\"", "to = \"sensor\""),
            "FILE:9:8: 'body' and 'sensor' are both bodies; one of them must be a reference: EME2000, J2000, "
            "GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD, MOD, LVLH, RTN, RSW, TNW, NTW and VNC");
  EXPECT_EQ(refusal("from = \"body\"", "from = \"J2000\""),
            "FILE:9:8: 'J2000' and 'GCRF' are both references; one of them must be the body");
  const auto to_reference = read(plain).attitude.columns->stated;
  EXPECT_EQ(to_reference.maps, Convention::Maps::to_reference);
  EXPECT_EQ(to_reference.scalar, Convention::Scalar::last);
  const auto other =
      read(with(plain, "{ from = \"body\", to = \"GCRF\" }", "{ from = \"icrf\", to = \"body\" }"));
  EXPECT_EQ(other.attitude.columns->stated.maps, Convention::Maps::to_body);
  EXPECT_EQ(other.attitude.columns->reference, "GCRF");
}

TEST_F(ScenarioWords, AreOfATableOrOfAMessage) {
  EXPECT_EQ(refusal("time = { column = \"t\", scale = \"UTC\" }\n", ""),
            "FILE:3:1: 'attitude.time' is missing: a table needs it");
  EXPECT_EQ(
      refusal("file = \"a.csv\"", "file = \"a.csv\"\nsegment = 1"),
      "FILE:5:11: 'attitude.segment' is of a message; " + folder.file("a.csv").string() + " is a table");
  folder.written("a.csv", "CCSDS_AEM_VERS = 2.0\n");
  EXPECT_EQ(refusal("[[", "[["), "FILE:5:8: 'attitude.time' is of a table; " + folder.file("a.csv").string() +
                                     " is a message and says it itself");
  folder.written("a.csv", "t\n");
  EXPECT_EQ(refusal("[\"a\", \"b\"", "[\"a\", \"a\""), "FILE:3:1: the column 'a' is named twice");
}

TEST_F(ScenarioWords, SayWhatTheRatesAreOf) {
  const std::string
      rates =
          "[attitude.rates]\ncolumns = [\"wx\", \"wy\", \"wz\"]\nunit = \"deg/s\"\nof = \"body\"\n"
          "relative_to = \"GCRF\"\nin = \"gyros\"\n",
      gyros =
          "[[frame]]\nname = \"gyros\"\n[frame.dcm]\nrows = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]\n"
          "maps = { from = \"gyros\", to = \"body\" }\n";
  // z of the gyros is x of the body.
  const auto record = read_flown_attitude(read(plain + rates + gyros)).record;
  constexpr double rounding = 1e-17;  // of 0.02
  EXPECT_LE((record.rates.at(1) - Vector3d(0.02, 0.0, 0.0)).norm(), rounding);
  EXPECT_TRUE(record.rates_in_degrees);
  EXPECT_EQ(record.rate_axes, RateAxes::body);
  EXPECT_EQ(flown_refusal(plain + rates),
            "FILE:24:6: there is no frame 'gyros' fixed in the body; there are: body");
  EXPECT_EQ(flown_refusal(plain + with(rates, "of = \"body\"", "of = \"bdy\"") + gyros),
            "FILE:22:6: there is no frame 'bdy' fixed in the body; the nearest is 'body'");
  EXPECT_EQ(refusal(plain + with(rates, "\"GCRF\"", "\"J2000\"")),
            "FILE:23:15: the rates are relative to 'J2000', the quaternions to GCRF; both must be relative "
            "to one frame");
  EXPECT_EQ(refusal(plain + with(rates, "\"gyros\"", "\"J2000\"")),
            "FILE:24:6: the rates are in the axes of J2000; it must be GCRF or a frame fixed in the body");
  EXPECT_EQ(read_flown_attitude(read(plain + with(rates, "\"gyros\"", "\"ICRF\""))).record.rate_axes,
            RateAxes::reference);
}

TEST_F(ScenarioWords, FixFramesInTheBody) {
  constexpr double rounding = 1e-15;
  const auto z = [&](const std::string& lines) {
    return frames("[[frame]]\nname = \"s\"\n" + lines).in_body({{}, "", "s", Vector3d(0.0, 0.0, 1.0)});
  };
  // x of the body is z of the sensor.
  const std::string to_body = "maps = { from = \"s\", to = \"body\" }\n",
                    from_body = "maps = { from = \"body\", to = \"s\" }\n";
  const std::string rows = "[frame.dcm]\nrows = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]\n";
  EXPECT_LE((z(rows + to_body) - Vector3d::UnitX()).norm(), rounding);
  EXPECT_LE((z(rows + from_body) - Vector3d::UnitY()).norm(), rounding);
  // A quarter turn about x takes z to -y: v_to = q v q*.
  const std::string first = "[frame.quaternion]\nnumbers = [2, 2, 0, 0]\nscalar = \"first\"\n",
                    last = "[frame.quaternion]\nnumbers = [2, 0, 0, 2]\nscalar = \"last\"\n";
  EXPECT_LE((z(first + to_body) + Vector3d::UnitY()).norm(), rounding);
  EXPECT_LE((z(last + to_body) + Vector3d::UnitY()).norm(), rounding);
  EXPECT_LE((z(first + from_body) - Vector3d::UnitY()).norm(), rounding);
}

// Yaw, pitch and roll: the law of the library's EulerAngles.
TEST_F(ScenarioWords, TurnAFrameByEulerAngles) {
  struct Body : moving_frame {};
  struct Sensor : moving_frame {};
  constexpr double rounding = 1e-15;
  const auto angle = [](double number) { return convert<si::angle>(number * si::degree); };
  const auto R_body_from_sensor = dcm(
      euler_angles(intrinsic<3, 2, 1>, of<Sensor>, relative_to<Body>, angle(10.0), angle(20.0), angle(30.0)));
  const std::string lines =
      "[[frame]]\nname = \"s\"\n[frame.euler]\naxes = [3, 2, 1]\nangles = \"[10, 20, 30] deg\"\n";
  const Place here;
  const auto turned = frames(lines + "of = \"s\"\nrelative_to = \"body\"\n").body_from("s", here);
  EXPECT_LE((turned.toRotationMatrix() - R_body_from_sensor.matrix()).norm(), rounding);
  const auto other = frames(lines + "of = \"body\"\nrelative_to = \"s\"\n").body_from("s", here);
  EXPECT_LE((other.toRotationMatrix() - R_body_from_sensor.matrix().transpose()).norm(), rounding);
}

TEST_F(ScenarioWords, HangFramesOnEachOther) {
  // A quarter turn about z each, the second stated before the first.
  const std::string quarter = "[frame.quaternion]\nnumbers = [1, 0, 0, 1]\nscalar = \"first\"\n";
  const auto both = frames("[[frame]]\nname = \"b\"\n" + quarter +
                           "maps = { from = \"b\", to = \"a\" }\n[[frame]]\nname = \"a\"\n" + quarter +
                           "maps = { from = \"a\", to = \"body\" }\n");
  constexpr double rounding = 1e-15;
  EXPECT_LE((both.in_body({{}, "", "b", Vector3d::UnitX()}) + Vector3d::UnitX()).norm(), rounding);
  EXPECT_EQ(both.all().size(), 3U);
  const std::string mapped =
      "[[frame]]\nname = \"b\"\n" + quarter + "maps = { from = \"b\", to = \"bdy\" }\n";
  EXPECT_EQ(flown_refusal(plain + mapped),
            "FILE:19:1: the frame 'b' hangs on 'bdy', which is not fixed in 'body'; the nearest is 'body'");
  EXPECT_EQ(flown_refusal(plain + with(mapped, "bdy", "body") + with(mapped, "bdy", "body")),
            "FILE:25:1: there are two frames 'b'; the other is at " + file().string() + ":19:1");
}

TEST_F(ScenarioWords, RefuseWhatIsNoFrame) {
  const auto said = [&](const std::string& lines) {
    return flown_refusal(std::string(plain) + "[[frame]]\nname = \"s\"\n" + lines);
  };
  const std::string maps = "maps = { from = \"s\", to = \"body\" }\n";
  EXPECT_EQ(said(""), "FILE:19:1: 'frame' needs one of: quaternion, dcm, euler");
  EXPECT_TRUE(says(said("[frame.dcm]\nrows = [[1, 0, 0], [0, 1, 0], [0, 0, 0.9]]\n" + maps),
                   "FILE:22:8: the rows are no rotation: "));
  EXPECT_TRUE(says(said("[frame.dcm]\nrows = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]\n" + maps),
                   "FILE:22:8: the rows are no rotation: "));
  EXPECT_EQ(said("[frame.quaternion]\nnumbers = [0, 0, 0, 0]\nscalar = \"first\"\n" + maps),
            "FILE:22:11: the squared norm of the quaternion is 0; it has no direction");
  EXPECT_EQ(said("[frame.quaternion]\nnumbers = [1, 0, 0, 0]\nscalar = \"first\"\nmaps = { from = \"a\", to "
                 "= \"body\" }\n"),
            "FILE:24:8: it is stated between 'a' and 'body'; exactly one of them must be 's'");
  EXPECT_EQ(said("[frame.quaternion]\nnumbers = [1, 0, 0, 0]\nscalar = \"first\"\n" + maps +
                 "[frame.dcm]\nrows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n" + maps),
            "FILE:25:1: 'frame.quaternion' and 'frame.dcm' are both given; one is needed");
  const std::string euler =
      "[frame.euler]\naxes = [3, 2, 1]\nangles = \"[10, 20, 30] deg\"\nof = \"s\"\nrelative_to = \"body\"\n";
  EXPECT_EQ(said(with(euler, "[3, 2, 1]", "[3, 2, 0]")),
            "FILE:22:8: 'frame.euler.axes' holds 0; the axes are 1, 2 and 3");
  EXPECT_EQ(said(with(euler, "[3, 2, 1]", "[3, 3, 1]")),
            "FILE:22:8: 'frame.euler.axes' turns twice in turn about one axis");
  EXPECT_EQ(flown_refusal(std::string(plain) + "[[frame]]\nname = \"J2000\"\n" + euler),
            "FILE:20:8: 'J2000' is the name of a reference");
  EXPECT_EQ(flown_refusal(std::string(plain) + "[[frame]]\nname = \"body\"\n" +
                          with(with(euler, "\"body\"", "\"s\""), "of = \"s\"", "of = \"body\"")),
            "FILE:19:1: 'body' is the name of the body of the attitude");
}

// Names that mean another frame are no names of a body: an attitude relative to ITRF would be read as one.
TEST_F(ScenarioWords, RefuseTheNamesOfOtherFramesForABody) {
  const std::string maps = "{ from = \"body\", to = \"GCRF\" }";
  EXPECT_EQ(refusal(maps, "{ from = \"ITRF\", to = \"GCRF\" }"),
            "FILE:9:8: 'ITRF' and 'GCRF' are both references; one of them must be the body");
  EXPECT_EQ(refusal(maps, "{ from = \"body\", to = \"teme\" }"), "nothing was thrown");
  EXPECT_EQ(
      refusal(maps, "{ from = \"body\", to = \"mci\" }"),
      "FILE:9:8: 'body' and 'mci' are both bodies; one of them must be a reference: EME2000, J2000, GCRF, "
      "ICRF, ITRF, TIRF, CIRF, TEME, TOD, MOD, LVLH, RTN, RSW, TNW, NTW and VNC");
  const std::string mounted =
      "[[frame]]\nname = \"LVLH\"\n[frame.quaternion]\nnumbers = [1, 0, 0, 0]\nscalar = \"first\"\n"
      "maps = { from = \"LVLH\", to = \"body\" }\n";
  EXPECT_EQ(refusal_with(mounted), "FILE:20:8: 'LVLH' is the name of a frame that is not fixed in a body");
}

TEST_F(ScenarioWords, NameAnAxisAndItsFrame) {
  const auto axis = [&](const std::string& text) { return refusal("\"z of body\"", "\"" + text + "\""); };
  EXPECT_EQ(axis("z"),
            "FILE:12:10: 'measure.axis' is 'z': it does not say of which frame, as \"-z of body\"");
  EXPECT_EQ(axis("-z of "),
            "FILE:12:11: 'measure.axis' is '-z of ': it does not say of which frame, as \"-z of body\"");
  EXPECT_EQ(
      axis("w of body"),
      "FILE:12:9: 'measure.axis' is 'w of body': needed: x, y or z, with or without a sign, or [x, y, z]");
  EXPECT_EQ(axis("-"),
            "FILE:12:10: 'measure.axis' is '-': needed: x, y or z, with or without a sign, or [x, y, z]");
  EXPECT_EQ(axis("[0, 0, 0] of body"),
            "FILE:12:9: 'measure.axis' is '[0, 0, 0] of body': it has no direction");
  EXPECT_EQ(axis("[0, 1] of body"),
            "FILE:12:9: 'measure.axis' is '[0, 1] of body': 3 numbers in brackets are needed, as [1, 2, 3]");
  EXPECT_EQ(flown_refusal(with(plain, "z of body", "z of boddy")),
            "FILE:12:9: there is no frame 'boddy' fixed in the body; the nearest is 'body'");
  EXPECT_EQ(read(with(plain, "z of body", "-y of body")).measures[0].axis.vector, Vector3d(0.0, -1.0, 0.0));
  EXPECT_EQ(read(with(plain, "z of body", "[0, 3, -4] of body")).measures[0].axis.vector,
            Vector3d(0.0, 0.6, -0.8));
}

TEST_F(ScenarioWords, NameATarget) {
  EXPECT_EQ(refusal("\"sun\"", "\"sunn\""), "FILE:13:10: there is no target 'sunn'; the nearest is 'sun'");
  EXPECT_EQ(refusal("correction = \"geometric\"\n", ""),
            "FILE:10:1: 'measure.correction' is missing: sun is not where it is seen; one of: \"geometric\", "
            "\"light_time\", "
            "\"apparent\"");
  const std::string orbit = "[orbit]\ntle = \"t.tle\"\n";
  EXPECT_EQ(refusal(with(plain, "\"sun\"", "\"earth\"") + orbit),
            "FILE:14:14: 'measure.correction' is of the Sun, the Moon and stars");
  EXPECT_EQ(refusal("\"sun\"", "\"moon\""),
            "FILE:13:10: the direction of moon needs an orbit; missing: [orbit]");
  const std::string star =
      "[[star]]\nname = \"Sirius\"\nright_ascension = \"101.287 deg\"\ndeclination = \"-16.716 deg\"\n";
  EXPECT_EQ(
      refusal(with(plain, "\"sun\"", "\"sirius\"") + orbit + star),
      "FILE:14:14: a catalogue says where a star is seen, not where it is; needed one of: \"light_time\", "
      "\"apparent\"");
  EXPECT_EQ(
      refusal(with(with(plain, "\"sun\"", "\"sirius\""), "correction = \"geometric\"\n", "") + orbit + star),
      "FILE:10:1: 'measure.correction' is missing: sirius is not where it is seen; one of: \"light_time\", "
      "\"apparent\"");
  EXPECT_EQ(refusal_with(with(star, "-16.716", "-116.716")),
            "FILE:22:15: 'star.declination' is -116.716 deg; it is at most 90 deg");
  EXPECT_EQ(refusal_with(with(star, "101.287 deg", "365527.0 arcmin")),
            "FILE:21:19: 'star.right_ascension' is 365527.0 arcmin, more than a turn");
  EXPECT_EQ(refusal_with(star + star), "FILE:24:8: there are two targets 'Sirius'");
  EXPECT_EQ(refusal_with(with(star, "Sirius", "Sun")), "FILE:20:8: there are two targets 'Sun'");
  const std::string station =
      "[[station]]\nname = \"Kiruna\"\nlatitude = \"67.9 deg\"\nlongitude = \"21.1 deg\"\nheight = \"0.4 "
      "km\"\n";
  EXPECT_EQ(
      refusal_with(station),
      "FILE:19:1: a station needs the orientation of the Earth; missing: orientation = \"FILE\" in [earth]");
  EXPECT_EQ(refusal_with(with(station, "67.9", "167.9")),
            "FILE:21:12: 'station.latitude' is 167.9 deg; it is at most 90 deg");
  EXPECT_EQ(refusal_with(with(station, "21.1", "421.1")),
            "FILE:22:13: 'station.longitude' is 421.1 deg, more than a turn");
  EXPECT_EQ(refusal_with("[[measure]]\nname = \"off-Sun\"\naxis = \"x of body\"\ntarget = "
                         "\"sun\"\ncorrection = \"apparent\"\n"),
            "FILE:20:8: there are two measures 'off-Sun'");
}

TEST_F(ScenarioWords, SayWhatIsRequired) {
  EXPECT_EQ(refusal("measure = \"off-Sun\"", "measure = \"of-Sun\""),
            "FILE:16:11: there is no measure 'of-Sun'; the nearest is 'off-Sun'");
  EXPECT_EQ(refusal("absolute = \"0.5 deg\"\n", ""),
            "FILE:15:1: 'require' needs one of: absolute, relative, budget");
  EXPECT_EQ(refusal("percent", "relative = \"1 deg\"\npercent"),
            "FILE:18:12: 'require.relative' and 'require.absolute' are both given; one is needed");
  EXPECT_EQ(
      refusal("absolute", "relative"),
      "FILE:15:1: 'require.window' is missing: a relative error is over a window, as window = \"60 s\"");
  EXPECT_EQ(refusal("percent", "window = \"1 s\"\npercent"),
            "FILE:18:10: 'require.window' is of a relative error; this one is absolute");
  EXPECT_EQ(refusal("\"0.5 deg\"", "\"0 deg\""),
            "FILE:17:12: 'require.absolute' is 0 deg; it must be above 0");
  EXPECT_EQ(refusal("\"0.5 deg\"", "\"181 deg\""),
            "FILE:17:12: 'require.absolute' is 181 deg; it is at most 180 deg");
  EXPECT_EQ(refusal("\"95 %\"", "\"100.1 %\""),
            "FILE:18:11: 'require.percent' is 100.1 %; it is at most 100 %");
  EXPECT_EQ(refusal("percent", "when = \"shadow\"\npercent"),
            "FILE:18:8: whether it is in shadow needs an orbit; missing: [orbit]");
}

TEST_F(ScenarioWords, NameOneOrbit) {
  EXPECT_EQ(refusal_with("[orbit]\n"), "FILE:19:1: 'orbit' needs one of: tle, omm, oem, spk, table");
  EXPECT_EQ(refusal_with("[orbit]\nspk = \"t.tle\"\nsatellite = \"25544\"\n"),
            "FILE:21:13: 'orbit.satellite' is of elements, 'orbit.spk' is given");
  EXPECT_EQ(refusal_with("[orbit]\ntle = \"t.tle\"\noem = \"t.tle\"\n"),
            "FILE:21:7: 'orbit.oem' and 'orbit.tle' are both given; one is needed");
  EXPECT_EQ(refusal_with("[orbit]\ntle = \"t.tle\"\nunit = \"m\"\n"),
            "FILE:21:8: 'orbit.unit' is of a table, 'orbit.tle' is given");
  EXPECT_EQ(refusal_with("[orbit]\ntle = \"t.tle\"\ninterpolation = { method = \"hermite\", degree = 3 }\n"),
            "FILE:21:17: 'orbit.interpolation' is of a table or an OEM, 'orbit.tle' is given");
  EXPECT_EQ(refusal_with("[orbit]\noem = \"t.tle\"\ninterpolation = { method = \"hermite\", degree = 4 }\n"),
            "FILE:21:48: HERMITE interpolation of degree 4 does not exist; the degree is odd, 3 to 15");
  EXPECT_EQ(refusal_with("[orbit]\ntable = \"t.tle\"\n"),
            "FILE:19:1: 'orbit.time' is missing: a table needs it");
  const std::string table =
      "[orbit]\ntable = \"t.tle\"\ntime = { column = \"t\", scale = \"TAI\" }\nposition = [\"x\", \"y\", "
      "\"z\"]\n"
      "velocity = [\"u\", \"v\", \"w\"]\nunit = \"km\"\nframe = \"ITRF\"\ninterpolation = { method = "
      "\"lagrange\", degree = 7 }\n";
  EXPECT_EQ(refusal_with(table),
            "FILE:25:9: an orbit in ITRF needs the orientation of the Earth; missing: orientation = \"FILE\" "
            "in [earth]");
  const auto orbit = read(plain + with(table, "ITRF", "j2000")).orbit.value();
  EXPECT_EQ(orbit.table->columns->reference, "EME2000");
  EXPECT_TRUE(orbit.table->columns->in_kilometres);
  EXPECT_EQ(orbit.interpolation.value->name(), "LAGRANGE interpolation of degree 7");
}

TEST_F(ScenarioWords, SayWhichTimes) {
  EXPECT_EQ(refusal_with("[time]\nstart = 2026-11-29T00:00:10Z\nend = 2026-11-29T00:00:10Z\n"),
            "FILE:21:7: 'time.end' is 2026-11-29T00:00:10.000000 UTC, not after 'time.start', "
            "2026-11-29T00:00:10.000000 UTC");
  EXPECT_EQ(refusal_with("[time]\nstep = \"0 s\"\n"), "FILE:20:8: 'time.step' is 0 s; it must be above 0");
  EXPECT_EQ(refusal("scale = \"UTC\"", "scale = \"UT1\"").substr(0, 14), "FILE:5:32: 'at");
}

TEST_F(ScenarioWords, NameWhatIsWritten) {
  EXPECT_EQ(refusal_with("[output]\nreport = \"a.txt\"\n"),
            "FILE:20:10: 'output.report' is 'a.txt'; the name must end in .html");
  EXPECT_EQ(refusal_with("[output]\ncsv = \"a.html\"\n"),
            "FILE:20:7: 'output.csv' is 'a.html'; the name must end in .csv");
}

}  // namespace
}  // namespace vectrix::cli::scenario_test
