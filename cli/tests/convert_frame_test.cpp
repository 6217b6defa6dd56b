#include <gtest/gtest.h>

#include <sstream>

#include "convert.hpp"
#include "earth_frame.hpp"
#include "figures.hpp"
#include "plain_attitude.hpp"
#include "says.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::convert_frame_test {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

const std::filesystem::path observed =
    std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data/finals2000A_april_2023.txt";
const EarthOrientation& orientation() {
  static const auto read = EarthOrientation::read(observed);
  return read;
}
const Epoch start = Epoch::from_utc("2023-04-20T05:00:00");

// R_frame^gcrf by the series of the library, where convert takes the polynomials of EarthMotion, and for TOD,
// whose series convert has, over ITRF.
Matrix3d frame_from_gcrf(const std::string& frame, const Epoch& t) {
  auto p = orientation().parameters(t);
  if (frame == "TOD" || frame == "TEME") {  // they have no observed offsets
    p.dX = p.dY = 0.0 * si::radian;
    p.dX_rate = p.dY_rate = 0.0 * (si::radian / si::second);
  }
  if (frame == "EME2000") return eme2000_from_gcrf().matrix();
  if (frame == "ITRF") return inverse(earth_rotation(t, p).rotation).matrix();
  if (frame == "TIRF") return inverse((gcrf_from_cirf(t, p) * cirf_from_tirf(t, p)).rotation).matrix();
  if (frame == "CIRF") return inverse(gcrf_from_cirf(t, p).rotation).matrix();
  if (frame == "TEME")
    return (teme_from_itrf(t, p).rotation * inverse(earth_rotation(t, p).rotation)).matrix();
  if (frame == "TOD")
    return (inverse(itrf_from_true_of_date(t, p).rotation) * inverse(earth_rotation(t, p).rotation)).matrix();
  if (frame == "MOD") return mean_of_date_from_gcrf(t).rotation.matrix();
  return Matrix3d::Identity();
}
constexpr double of_model = 2e-11;  // rad: the polynomials of EarthMotion, and TOD over ITRF

const std::string frames[] = {"EME2000", "ITRF", "TIRF", "CIRF", "TEME", "TOD", "MOD"};

struct State {
  Vector3d r, v;
};
// In GCRF, m and m/s: straight on, which no law of the frames knows of.
State flown(double seconds) {
  const Vector3d v(-1234.5, 6543.2, 3456.7);
  return {Vector3d(6.5e6, 1.2e6, -2.1e6) + seconds * v, v};
}

ConvertOptions options_to(const std::filesystem::path& out, const std::string& frame) {
  ConvertOptions options;
  options.out = out;
  options.frame = frame;
  options.text = {"S", "2026-001A", "TEST", "2026-11-29T00:00:00"};
  options.body = "SC_BODY_1";
  if (frame == "ITRF" || frame == "TIRF" || frame == "CIRF") options.orientation = observed;
  return options;
}
template <class Source>
std::string convert_to(const Source& source, const std::filesystem::path& out, const std::string& frame,
                       const std::filesystem::path& data = {}) {
  ConvertOptions options = options_to(out, frame);
  if (!data.empty()) options.orientation = data;
  std::ostringstream said;
  convert(source, options, said);
  return said.str();
}

OrbitFile orbit_in(const TemporaryFolder& folder) {
  std::string text = "t,x,y,z,u,v,w\n";
  for (const double t : {0.0, 60.0, 7200.0}) {
    const State state = flown(t);
    text += exact_text(start + t * si::second, scale::utc);
    for (const Vector3d& each : {state.r, state.v}) add_fields(text, each);
    text += "\n";
  }
  return {folder.written("orbit.csv", text),
          OrbitColumns{"t", scale::utc, {"x", "y", "z"}, {"u", "v", "w"}, false, "GCRF"}};
}

TEST(ConvertFrame, TurnsAnOrbitToTheAxesOfTheEarth) {
  const TemporaryFolder folder;
  const OrbitFile source = orbit_in(folder);
  for (const std::string& frame : frames) {
    const OrbitFile out{folder.file(frame + ".oem")};
    EXPECT_TRUE(says(convert_to(source, out.file, frame), "the orbit is turned from GCRF to " + frame));
    const auto record = read_orbit_file(out);
    EXPECT_EQ(record.lines.ref_frame, frame);
    const double of_position = 7e6 * of_model + 1e-8;  // m
    for (const auto& line : record.lines.lines) {
      const double t = (line.time - start).value(), h = 0.3;
      const auto position = [&](double s) {
        return Vector3d(frame_from_gcrf(frame, start + s * si::second) * flown(s).r);
      };
      EXPECT_LE((line.position - position(t)).norm(), of_position) << frame;
      // The difference quotient is off by h^2 / 6 of 3 (7e-5 rad/s)^2 |v|, 2e-6 m/s, and by roundings of 1e-6
      // m over 2 h. Without the turn of the axes it were 500 m/s, and in those of date 3e-5 m/s.
      constexpr double of_velocity = 5e-6;  // m/s
      EXPECT_LE((line.velocity - (position(t + h) - position(t - h)) / (2.0 * h)).norm(), of_velocity)
          << frame;
      if (frame != "EME2000") {
        EXPECT_GT((line.position - flown(t).r).norm(), 1e4) << frame;
      }
    }
  }
}

TEST(ConvertFrame, TurnsAnOrbitBackToTheLastDigits) {
  const TemporaryFolder folder;
  const OrbitFile source = orbit_in(folder);
  // m and m/s: some roundings of 7e6 and of 7e3, by as many of which R^T R is off the unit matrix.
  constexpr double of_position = 5e-8, of_velocity = 5e-11;
  for (const std::string& frame : frames) {
    const auto there = folder.file("there.oem"), back = folder.file("back.oem");
    convert_to(source, there, frame);
    convert_to(OrbitFile{there}, back, "GCRF", is_observed(frame) ? observed : "");
    for (const auto& line : read_orbit_file({back}).lines.lines) {
      const State expected = flown((line.time - start).value());
      EXPECT_LE((line.position - expected.r).norm(), of_position) << frame;
      EXPECT_LE((line.velocity - expected.v).norm(), of_velocity) << frame;
    }
    std::filesystem::remove(there);
    std::filesystem::remove(back);
  }
}

// A table of any of the frames says how it is read, and so it is.
TEST(ConvertFrame, WritesATableInTheAxesOfTheEarth) {
  const TemporaryFolder folder;
  const auto out = folder.file("out.csv"), message = folder.file("out.oem");
  convert_to(orbit_in(folder), out, "TIRF");
  EXPECT_TRUE(says(content(out), " --unit m --reference TIRF\n"));
  const OrbitFile table{out, OrbitColumns{"time_utc",
                                          scale::utc,
                                          {"x_in_tirf_m", "y_in_tirf_m", "z_in_tirf_m"},
                                          {"vx_in_tirf_m_per_s", "vy_in_tirf_m_per_s", "vz_in_tirf_m_per_s"},
                                          false,
                                          "TIRF"}};
  convert_to(table, message, "");
  EXPECT_EQ(read_orbit_file({message}).lines.lines[1].position,
            read_orbit_file(table).lines.lines[1].position);
}

// A body that turns evenly about an axis of its own, with its rates in the body or in GCRF.
Quaterniond gcrf_from_body(double seconds) {
  return Quaterniond(0.3, -0.5, 0.2, 0.7).normalized() *
         Quaterniond(Eigen::AngleAxisd(1e-3 * seconds, Vector3d(0.6, 0.0, 0.8)));
}
const Vector3d w_in_body = 1e-3 * Vector3d(0.6, 0.0, 0.8);  // rad/s
AttitudeSource attitude_in(const TemporaryFolder& folder, RateAxes axes) {
  std::string text = "t,a,b,c,d,u,v,w\n";
  for (const double t : {0.0, 10.0, 20.0, 43000.0}) {
    const Quaterniond q = gcrf_from_body(t);
    text += exact_text(start + t * si::second, scale::utc);
    add_fields(text, std::array{q.w(), q.x(), q.y(), q.z()});
    add_fields(text, axes == RateAxes::body ? w_in_body : Vector3d(q * w_in_body));
    text += "\n";
  }
  TableColumns columns;
  columns.time = "t";
  columns.quaternion = {"a", "b", "c", "d"};
  columns.stated = {Convention::Scalar::first, Convention::Maps::to_reference};
  columns.reference = "GCRF";
  columns.rates = {"u", "v", "w"};
  columns.rate_axes = axes;
  return {folder.written("attitude.csv", text), columns};
}

TEST(ConvertFrame, TurnsAnAttitudeWithItsRates) {
  for (const RateAxes axes : {RateAxes::body, RateAxes::reference}) {
    const TemporaryFolder folder;
    const AttitudeSource source = attitude_in(folder, axes);
    for (const std::string& frame : frames) {
      const auto out = folder.file(frame + ".aem");
      EXPECT_TRUE(says(convert_to(source, out, frame), "4 samples of SC_BODY_1 relative to " + frame));
      const auto record = read_attitude({out});
      EXPECT_EQ(record.reference, frame);
      const auto rates = record.rates_in_radians();
      ASSERT_EQ(rates.size(), 4U);
      const bool turns_by_day = frame == "ITRF" || frame == "TIRF";
      for (std::size_t i = 0; i < record.size(); ++i) {
        const double t = (record.times[i] - start).value();
        const Quaterniond q = gcrf_from_body(t);
        const Matrix3d R = frame_from_gcrf(frame, record.times[i]);
        EXPECT_LE(record.to_reference(i, record.stated).angularDistance(Quaterniond(R) * q), 2.0 * of_model)
            << frame;
        // The Earth turns once in 86164.0989 s about its pole, less dUT1 and polar motion, and axes of date
        // by less than 1e-11 rad/s.
        constexpr double of_earth = 1e-11, by_pole = 2.0 * std::numbers::pi / 86164.098903691,
                         of_pole = 2e-10;
        const Vector3d w_of_axes(0.0, 0.0, turns_by_day ? by_pole : 0.0);
        const Vector3d in_axes = R * (q * w_in_body) - w_of_axes;
        const Vector3d expected =
            axes == RateAxes::reference ? in_axes : Vector3d(q.conjugate() * (R.transpose() * in_axes));
        EXPECT_LE((rates[i] - expected).norm(), turns_by_day ? of_pole : of_earth) << frame;
      }
    }
  }
}

// The numbers come back; they change their sign nowhere, which who interpolates them would not bear.
TEST(ConvertFrame, TurnsAnAttitudeBackToTheLastDigits) {
  const TemporaryFolder folder;
  std::vector<Epoch> times;
  PlainAttitude attitude{"B", "GCRF", scale::utc, times};
  for (int i = 0; i < 100; ++i) {
    const double t = 900.0 * i;  // a day of the Earth
    attitude.times.push_back(start + t * si::second);
    const Quaterniond q = gcrf_from_body(0.01 * t);
    attitude.quaternions.push_back({q.w(), q.x(), q.y(), q.z()});
    attitude.rates.push_back(w_in_body);
  }
  const auto there = turned(attitude, "ITRF", orientation(), "FILE"),
             back = turned(there, "GCRF", orientation(), "FILE");
  constexpr double rounding = 1e-15, of_rates = 1e-18;
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    double dot = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(std::abs(back.quaternions[i][k]), std::abs(attitude.quaternions[i][k]), rounding);
      if (i > 0) dot += there.quaternions[i][k] * there.quaternions[i - 1][k];
    }
    EXPECT_LE((back.rates[i] - attitude.rates[i]).norm(), of_rates);
    if (i > 0) {
      EXPECT_GT(dot, 0.9) << i;
    }
  }
}

TEST(ConvertFrame, RefusesWhatItCannotTurn) {
  const TemporaryFolder folder;
  const OrbitFile orbit = orbit_in(folder);
  const AttitudeSource attitude = attitude_in(folder, RateAxes::body);
  const auto refused = [&](const auto& source, const std::string& frame, bool with_data) {
    ConvertOptions options = options_to(folder.file("out.xml"), frame);
    options.orientation = with_data ? observed : "";
    std::ostringstream said;
    return complaint([&] { convert(source, options, said); }, source.file);
  };
  const std::string needs =
      "FILE: from GCRF to CIRF needs the orientation of the Earth; missing: --orientation FILE";
  EXPECT_EQ(refused(orbit, "CIRF", false), needs);
  EXPECT_EQ(refused(attitude, "CIRF", false), needs);
  EXPECT_EQ(
      refused(orbit, "TEME", true),
      "--orientation is for --frame, to or from ITRF, TIRF or CIRF; the orbit is in GCRF, and is to be in "
      "TEME");
  EXPECT_EQ(refused(attitude, "", true),
            "--orientation is for --frame, to or from ITRF, TIRF or CIRF; the attitude is relative to GCRF");
  EXPECT_EQ(refused(orbit, "ITRS", false),
            "--frame 'ITRS' is none of EME2000, J2000, GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD and MOD; the "
            "nearest is 'ITRF'");
  const auto message = folder.file("tod.oem");
  convert_to(orbit, message, "TOD");
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = content(message);
    text.replace(text.find(part), part.size(), other);
    return refused(OrbitFile{folder.written("changed.oem", text)}, "GCRF", false);
  };
  EXPECT_EQ(with("TIME_SYSTEM", "REF_FRAME_EPOCH = 2020-01-01T00:00:00\nTIME_SYSTEM"),
            "FILE: REF_FRAME_EPOCH stops TOD; it is turned as a frame of date only");
  EXPECT_EQ(with("EARTH", "MARS"),
            "FILE: CENTER_NAME is 'MARS'; only an orbit about EARTH is turned to or from axes of the Earth");
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.xml")));
}

}  // namespace
}  // namespace vectrix::cli::convert_frame_test
