#include <gtest/gtest.h>

#include <cmath>

#include "circular_orbit.hpp"
#include "flown_orbit.hpp"
#include "space/tests/orbit/check_sum.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::flown_orbit_test {
namespace {

using earth::Eme2000, earth::Gcrf, earth::Itrf, earth::Teme;
using Eigen::Vector3d;

const auto start = Epoch::from_utc("2023-04-20T05:00:00");
const auto span = from_until(start, 3600.0 * si::second);

template <Frame A> PointMotion<A, Satellite, A> motion(const Epoch& t) {
  return circular_orbit<A>((t - start).value());
}
template <Frame A> OrbitEphemerisSegment segment(double from, double until) {
  std::vector<PositionSample<A, Satellite, Epoch>> samples;
  for (double s = from; s <= until; s += 60.0)
    samples.push_back({start + s * si::second, motion<A>(start + s * si::second)});
  EphemerisMetadata metadata{"SATELLITE", "2023-001A"};
  metadata.interpolation = "HERMITE";
  metadata.interpolation_degree = 7;
  return {metadata, samples};
}
std::string message(const std::vector<OrbitEphemerisSegment>& segments) {
  return OrbitEphemerisMessage({"2.0", "2026-11-29T00:00:00", "TEST"}, segments).text();
}

// Between samples: Hermite of degree 7 leaves 1e-6 m of a circle of 60 s steps; kilometres are written to the
// last bit.
constexpr double of_interpolation = 1e-5;  // m

template <Frame A> Vector3d at(const Epoch& t) {
  TemporaryFile file(message({segment<A>(0.0, 3600.0)}));
  return orbit_of_message(file.path(), span)(t).position.coordinates();
}

std::string with(std::string text, const std::string& before, const std::string& after) {
  return text.replace(text.find(before), before.size(), after);
}

TEST(FlownOrbit, IsInGcrfWhateverFrameTheMessageHas) {
  const auto t = start + 1234.5 * si::second;
  EXPECT_LE((at<Gcrf>(t) - motion<Gcrf>(t).position.coordinates()).norm(), of_interpolation);
  const Vector3d by_bias =
      (inverse(eme2000_from_gcrf()) * motion<Eme2000>(t).position.vector()).coordinates();
  EXPECT_LE((at<Eme2000>(t) - by_bias).norm(), of_interpolation);
  EXPECT_GT((at<Eme2000>(t) - motion<Gcrf>(t).position.coordinates()).norm(), 0.1);
  // With an Earth as it may be observed: the pole, and another UT1. Only dX and dY do not cancel.
  EarthOrientationParameters observed{};
  observed.ut1_minus_tai = (0.3 - 37.0) * si::second;
  observed.pole_x = 1e-6 * si::radian;
  observed.pole_y = 2e-6 * si::radian;
  const auto R_gcrf_from_teme =
      earth_rotation(t, observed).rotation * inverse(teme_from_itrf(t, observed).rotation);
  const Vector3d by_the_earth = (R_gcrf_from_teme * motion<Teme>(t).position.vector()).coordinates();
  constexpr double of_equinox = 0.3 * 8e-12 * 7e6;  // m: TEME turns by 8e-12 rad/s, and UT1 by 0.3 s
  EXPECT_LE((at<Teme>(t) - by_the_earth).norm(), of_interpolation + of_equinox);
  EXPECT_GT((at<Teme>(t) - motion<Gcrf>(t).position.coordinates()).norm(), 1e4);
}

TEST(FlownOrbit, TakesTheFirstSegmentThatHasTheEpoch) {
  TemporaryFile file(message({segment<Gcrf>(0.0, 1200.0), segment<Eme2000>(1800.0, 3600.0)}));
  const auto orbit = orbit_of_message(file.path(), span);
  const auto early = start + 601.0 * si::second, late = start + 2401.0 * si::second;
  EXPECT_LE((orbit(early).position.coordinates() - motion<Gcrf>(early).position.coordinates()).norm(),
            of_interpolation);
  EXPECT_GT((orbit(late).position.coordinates() - motion<Gcrf>(late).position.coordinates()).norm(), 0.1);
  EXPECT_EQ(complaint([&] { (void)orbit(start + 1500.0 * si::second); }, file.path()),
            "FILE: the epoch 2023-04-20T05:25:00.000000 UTC of an attitude is in no segment; they are from "
            "2023-04-20T05:00:00.000 to 2023-04-20T05:20:00.000, 2023-04-20T05:30:00.000 to "
            "2023-04-20T06:00:00.000");
  // Ticks of a clock are rounded: that is not outside.
  const auto rounded = start - 2e-7 * si::second;
  EXPECT_LE((orbit(rounded).position.coordinates() - motion<Gcrf>(rounded).position.coordinates()).norm(),
            0.002);
  EXPECT_NE(complaint([&] { (void)orbit(start - 1e-5 * si::second); }), "nothing was thrown");
}

TEST(FlownOrbit, TakesTemeOfDateByBothNames) {
  const std::string text = message({segment<Teme>(0.0, 3600.0)});
  const auto of = [](const std::string& written) {
    TemporaryFile file(written);
    const auto t = start + 1234.5 * si::second;
    return Vector3d(orbit_of_message(file.path(), span)(t).position.coordinates());
  };
  EXPECT_EQ(of(text), of(with(text, "= TEME", "= TEMEOFDATE")));
  TemporaryFile stopped(with(text, "TIME_SYSTEM", "REF_FRAME_EPOCH = 2023-04-20T00:00:00\nTIME_SYSTEM"));
  EXPECT_EQ(complaint([&] { (void)orbit_of_message(stopped.path(), span); }, stopped.path()),
            "FILE: REF_FRAME_EPOCH stops TEME; it is taken of date");
}

TEST(FlownOrbit, RefusesAnEarthFixedMessageAndOldElements) {
  TemporaryFile file(message({segment<Itrf>(0.0, 3600.0)}));
  EXPECT_EQ(complaint([&] { (void)orbit_of_message(file.path(), span); }, file.path()),
            "FILE: REF_FRAME is 'ITRF'; ITRF needs the orientation of the Earth: --orientation FILE, or "
            "orientation = \"FILE\" in [earth] of a scenario");
  const auto elements = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/CTIM_20230419.tle";
  const auto later = [](const char* time) { return from_until(Epoch::from_utc(time), 60.0 * si::second); };
  EXPECT_EQ(
      complaint(
          [&] { (void)orbit_of_elements(read_two_lines(elements), elements, later("2023-05-20T05:00:00")); },
          elements),
      "FILE: the nearest element set, of 2023-04-19T13:52:37 UTC, is 31 days from the times that are looked "
      "at; at most "
      "7 are allowed");
  // The end alone is more than a week from it.
  EXPECT_EQ(
      complaint(
          [&] { (void)orbit_of_elements(read_two_lines(elements), elements, later("2023-04-26T13:52:00")); },
          elements),
      "FILE: the nearest element set, of 2023-04-19T13:52:37 UTC, is 8 days from the times that are looked "
      "at; at most "
      "7 are allowed");
  EXPECT_EQ(complaint([&] {
              (void)orbit_of_elements(read_two_lines(elements), elements, later("2023-04-26T13:51:00"));
            }),
            "nothing was thrown");
}

// Two satellites in one file, the second with the nearer epoch, as in a list of many.
std::string two_lines(const std::string& number, const char* day) {
  return summed("1 " + number + "U 22074G   231" + day + ".57820907  .00068572  00000-0  17802-2 0  999") +
         "\n" + summed("2 " + number + "  97.5000 120.0000 0010000 100.0000 260.0000 15.3000000000001") +
         "\n";
}
// The same as a message.
std::string mean_elements(const std::string& number, const char* epoch) {
  return "CCSDS_OMM_VERS = 3.0\nCREATION_DATE =\nORIGINATOR =\nOBJECT_NAME = CTIM\nOBJECT_ID = 2022-074G\n"
         "CENTER_NAME = EARTH\nREF_FRAME = TEME\nTIME_SYSTEM = UTC\nMEAN_ELEMENT_THEORY = SGP4\nEPOCH = " +
         std::string(epoch) +
         "\nMEAN_MOTION = 15.3\nECCENTRICITY = .001\nINCLINATION = 97.5\nRA_OF_ASC_NODE = 120\n"
         "ARG_OF_PERICENTER = 100\nMEAN_ANOMALY = 260\nNORAD_CAT_ID = " +
         number + "\nBSTAR = 17802E-7\nMEAN_MOTION_DOT = 0\nMEAN_MOTION_DDOT = 0\n";
}

TEST(FlownOrbit, TakesNoSetOfAnotherSatellite) {
  const auto place_at = [](const auto& read, const std::string& text, const StatedSatellite& satellite) {
    TemporaryFile file(text);
    return Vector3d(
        orbit_of_elements(read(file.path()), file.path(), span, {}, satellite)(start).position.coordinates());
  };
  const std::string first = two_lines("52950", "09"), second = two_lines("A0001", "10");
  const Vector3d of_first = place_at(read_two_lines, first, {});
  EXPECT_GT((of_first - place_at(read_two_lines, second, {})).norm(), 1e5);
  EXPECT_EQ(place_at(read_two_lines, first + second, {"52950"}), of_first);
  EXPECT_EQ(place_at(read_two_lines, second + first, {"100001"}), place_at(read_two_lines, second, {}));
  const auto refused = [](const StatedSatellite& satellite) {
    TemporaryFile file(two_lines("52950", "09") + two_lines("A0001", "10"));
    return complaint(
        [&] { (void)orbit_of_elements(read_two_lines(file.path()), file.path(), span, {}, satellite); },
        file.path());
  };
  EXPECT_EQ(refused({}),
            "FILE: it has the elements of 2 satellites, 52950, 100001; missing: --satellite NUMBER");
  EXPECT_EQ(refused({"5295"}),
            "FILE: it has the elements of 2 satellites, 52950, 100001; --satellite is 5295");
  // The one that is there is not the one that is meant.
  TemporaryFile one(first);
  EXPECT_EQ(
      complaint([&] { (void)orbit_of_elements(read_two_lines(one.path()), one.path(), span, {}, {"25544"}); },
                one.path()),
      "FILE: it has the elements of 1 satellite, 52950; --satellite is 25544");
  const std::string messages = mean_elements("52950", "2023-04-19T13:52:37.263648") +
                               mean_elements("100001", "2023-04-20T13:52:37.263648");
  // The epoch of two lines has 1e-8 day, of which the message has 1e-6 s: 8 mm.
  EXPECT_LE((place_at(read_mean_elements, messages, {"52950"}) - of_first).norm(), 0.01);
}

const std::string said = "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 7\n";

TEST(FlownOrbit, IsInterpolatedAsTheFileOrElseTheUserSays) {
  const std::string text = message({segment<Gcrf>(0.0, 3600.0)});
  TemporaryFile file(with(text, said, ""));
  EXPECT_EQ(complaint([&] { (void)orbit_of_message(file.path(), span); }, file.path()),
            "FILE: the file does not say how to interpolate; missing: --interpolation hermite|lagrange "
            "--degree NUMBER");
  const auto t = start + 1234.5 * si::second;
  const auto off = [&](const Interpolation& stated) {
    return (orbit_of_message(file.path(), span, {stated})(t).position.coordinates() -
            motion<Gcrf>(t).position.coordinates())
        .norm();
  };
  EXPECT_LE(off({"HERMITE", 7}), of_interpolation);
  constexpr double of_a_parabola = 1.0;  // m: r (n h)^3 is 1900 m, of which a parabola leaves more than this
  EXPECT_GT(off({"LAGRANGE", 2}), of_a_parabola);
}

TEST(FlownOrbit, RefusesAnInterpolationThatContradictsTheFile) {
  const std::string text = message({segment<Gcrf>(0.0, 3600.0)});
  const auto refusal = [](const std::string& content, const std::optional<Interpolation>& stated = {}) {
    TemporaryFile file(content);
    return complaint([&] { (void)orbit_of_message(file.path(), span, {stated}); }, file.path());
  };
  EXPECT_EQ(
      refusal(text, Interpolation{"LAGRANGE", 7}),
      "FILE: says itself how to interpolate, HERMITE interpolation of degree 7; --interpolation is for a "
      "message that does not say it");
  EXPECT_EQ(
      refusal(with(text, "= HERMITE", "= LINEAR")),
      "FILE: INTERPOLATION is 'LINEAR', of degree 7, none of hermite and lagrange with a degree; missing: "
      "--interpolation hermite|lagrange --degree NUMBER");
  EXPECT_EQ(refusal(with(text, "= HERMITE", "= LINEAR"), Interpolation{"HERMITE", 7}), "nothing was thrown");
  EXPECT_EQ(refusal(with(text, "DEGREE = 7", "DEGREE = 8")),
            "FILE: HERMITE interpolation of degree 8 does not exist; the degree is odd, 3 to 15");
  EXPECT_EQ(refusal(message({segment<Gcrf>(0.0, 60.0)})),
            "FILE: 2 samples from 2023-04-20T05:00:00.000000 UTC; HERMITE interpolation of degree 7 needs 4");
  EXPECT_EQ(refusal(with(text, "CENTER_NAME = EARTH", "CENTER_NAME = MARS")),
            "FILE: CENTER_NAME is 'MARS'; the orbit must be about EARTH");
}

// One segment of 20 minutes, and after more than an hour one of some minutes.
std::string with_a_gap(int minutes, const std::string& stop) {
  const auto late = message({segment<Gcrf>(7200.0, 7200.0 + 60.0 * minutes)});
  return with(message({segment<Gcrf>(0.0, 1200.0)}), "STOP_TIME = 2023-04-20T05:20:00",
              "STOP_TIME = 2023-04-20T" + stop) +
         late.substr(late.find("2023-04-20T07:00:00", late.find("META_STOP")));
}

TEST(FlownOrbit, NeedsItsSamplesBetweenGaps) {
  TemporaryFile file(with_a_gap(1, "07:01:00"));
  EXPECT_EQ(complaint([&] { (void)orbit_of_message(file.path(), span); }, file.path()),
            "FILE: 2 samples from 2023-04-20T07:00:00.000000 UTC, without a step above an hour; HERMITE "
            "interpolation of degree 7 needs 4");
}

// What the library says of its types, at the door of the program.
TEST(FlownOrbit, NamesNoTypes) {
  TemporaryFile file(with_a_gap(20, "07:20:00"));
  const auto orbit = orbit_of_message(file.path(), span);
  const auto gap = complaint([&] { (void)orbit(start + 3600.0 * si::second); }, file.path());
  EXPECT_EQ(gap.substr(0, 6), "FILE: ") << gap;
  EXPECT_EQ(gap.find("::"), std::string::npos) << gap;
}

// Kilometres, in the axes of the table.
TEST(OrbitTable, IsTheMotionOfItsLines) {
  std::string text = "t,x,y,z,u,v,w\n";
  for (double seconds = -600.0; seconds <= 4200.0; seconds += 60.0) {
    const Epoch t = start + seconds * si::second;
    const auto [r, v] = motion<Gcrf>(t);
    text += t.tt(9);
    for (const Vector3d& numbers : {Vector3d(r.coordinates()), Vector3d(v.coordinates())})
      for (const double number : numbers) text += "," + detail::text(1e-3 * number);
    text += "\n";
  }
  const TemporaryFile file(text);
  OrbitColumns columns{"t", scale::tt, {"x", "y", "z"}, {"u", "v", "w"}, true, "GCRF"};
  const Interpolation hermite{"HERMITE", 7};
  const auto orbit = orbit_of_table({file.path(), columns, {}}, span, hermite, std::nullopt);
  const Epoch t = start + 1234.5 * si::second;
  EXPECT_LE((orbit(t).position.coordinates() - motion<Gcrf>(t).position.coordinates()).norm(),
            of_interpolation);
  columns.reference = "EME2000";
  const auto turned = orbit_of_table({file.path(), columns, {}}, span, hermite, std::nullopt);
  const Vector3d r = (inverse(eme2000_from_gcrf()).matrix() * motion<Gcrf>(t).position.coordinates());
  EXPECT_LE((turned(t).position.coordinates() - r).norm(), of_interpolation);
  columns.reference = "ITRF";
  EXPECT_EQ(complaint(
                [&] {
                  (void)orbit_of_table({file.path(), columns, {}}, span, hermite, std::nullopt);
                },
                file.path()),
            "FILE: REF_FRAME is 'ITRF'; ITRF needs the orientation of the Earth: --orientation FILE, or "
            "orientation = \"FILE\" in [earth] of a scenario");
  EXPECT_EQ(complaint(
                [&] {
                  (void)orbit_of_table({file.path(), columns, {}}, span, {"LAGRANGE", 90}, std::nullopt);
                },
                file.path()),
            "FILE: LAGRANGE interpolation of degree 90 does not exist; the degree is 2 to 15");
}

TEST(OrbitMessage, SaysHowToStateItsInterpolation) {
  OrbitEphemerisSegment silent = segment<Gcrf>(-600.0, 4200.0);
  EphemerisMetadata metadata = silent.metadata();
  metadata.interpolation.clear();
  metadata.interpolation_degree.reset();
  const TemporaryFile file(message({{detail::trusted, metadata, silent.lines(detail::trusted)}}));
  const StatedInterpolation none{std::nullopt, "interpolation = { ... } in [orbit]"};
  EXPECT_EQ(complaint([&] { (void)orbit_of_message(file.path(), span, none); }, file.path()),
            "FILE: the file does not say how to interpolate; missing: interpolation = { ... } in [orbit]");
}

}  // namespace
}  // namespace vectrix::cli::flown_orbit_test
