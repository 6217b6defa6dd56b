#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <vectrix/space.hpp>

#include "daf_text.hpp"
#include "temporary_file.hpp"

// Ephemeris kernels: a cubesat's orbit in two-line elements, and kernels of every type that the test writes.
namespace vectrix::ephemeris_kernel_test {
namespace {

using earth::Gcrf;

struct Ctim : moving_frame {};
struct Radiometer : moving_frame {};
struct Ship : moving_frame {};
struct Other : moving_frame {};
struct SunInertial : inertial_frame {};
struct Ecliptic : inertial_frame {};

const std::filesystem::path examples = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";
constexpr double km = 1e3;

// ---- CTIM: type 10 ----

TEST(EphemerisKernel, OfCtimIsWhereItsRadiometerSawTheEarth) {
  const auto kernel = EphemerisKernel::open(examples / "CTIM_20230420_orbit.bsp");
  ASSERT_EQ(kernel.segments().size(), 1U);
  EXPECT_EQ(kernel.segments()[0].target, -152950);
  EXPECT_EQ(kernel.segments()[0].center, 399);
  EXPECT_EQ(kernel.segments()[0].type, 10);
  EXPECT_NE(kernel.comments().find("INPUT_DATA_TYPE = 'TL_ELEMENTS'"), std::string::npos);
  const auto frames = FrameKernel::read(examples / "CTIM_frames.tf");
  const auto attitudes =
      AttitudeKernel::open(examples / "CTIM_20230420_attitude.bc",
                           SpacecraftClock::read(examples / "CTIM_clock.tsc", -152950), frames);
  const auto ctim = called<Ctim>("CTIM_COORD");
  const auto attitude = attitudes.attitude(of<Ctim>, relative_to<Gcrf>, attitudes.span(), ctim);
  const auto R_ctim_from_radiometer =
      frames.nearest_rotation(to<Ctim>, from<Radiometer>, ctim, called<Radiometer>("CTIM_TIM_COORD"))
          .rotation;
  const auto orbit = kernel.motion(of<Ctim>, relative_to<Gcrf>, attitudes.span(), called<Ctim>("-152950"));

  const auto table = CsvTable::read(examples / "CTIM_20230420_pointing.csv", {"timdotearth"});
  double sum = 0.0, largest = 0.0;
  int rows = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto microseconds = static_cast<std::int64_t>(table.number(row, "microsecondssincegpsepoch"));
    const auto t = Epoch::from_gps_seconds(microseconds / 1'000'000);
    if (!attitudes.span().contains(t)) continue;
    std::optional<MovingDcm<Gcrf, Ctim>> now;
    try {
      now = attitude(t);
    } catch (const BadInput&) {
      continue;
    }
    const auto boresight = now->rotation * (R_ctim_from_radiometer * -unit_z(in<Radiometer>));
    const auto to_earth = -direction(orbit.at(t).position.vector());
    const double error =
        std::acos(dot(boresight, to_earth).value()) - std::acos(table.number(row, "timdotearth"));
    sum += error * error;
    largest = std::max(largest, std::abs(error));
    ++rows;
  }
  constexpr double arcsecond = 4.84813681109536e-6;
  // The same theory in the same frame: what is left are the digits of the quaternions, 1e-4 arcsec, and the
  // equation of the equinoxes, of which 0.003 arcsec depend on its year. The nearest set of elements alone,
  // without blending, is 110 arcsec off.
  constexpr double tolerance = 0.005 * arcsecond;
  EXPECT_EQ(rows, 719);
  EXPECT_LT(std::sqrt(sum / rows), tolerance);
  EXPECT_LT(largest, tolerance);
}

TEST(EphemerisKernel, OfCtimHasTheElementsOfItsTwoLines) {
  const auto kernel = EphemerisKernel::open(examples / "CTIM_20230420_orbit.bsp");
  const auto orbit = kernel.motion(of<Ctim>, relative_to<Gcrf>, kernel.span(), called<Ctim>("-152950"));
  // The set before the first day of flight is the first of the kernel: at its epoch it counts alone.
  const auto set = TwoLineElements::read(examples / "CTIM_20230419.tle").front();
  const Sgp4<Ctim> sgp4(set, at_most(1.0 * si::hour));
  const auto in_teme = sgp4.at(set.epoch()).position.coordinates();
  const auto in_gcrf = orbit.at(set.epoch()).position.coordinates();
  EXPECT_NEAR(in_gcrf.norm(), in_teme.norm(), 1e-3);
  // From TEME to GCRF by IAU 2006, through the Earth; the two precessions differ by 0.1 arcsec, 3 m.
  const EarthOrientationParameters none{0.0 * si::radian,   0.0 * si::radian,
                                        -37.0 * si::second, 0.0 * (si::second / si::second),
                                        0.0 * si::radian,   0.0 * si::radian};
  const auto R_teme_from_itrf = teme_from_itrf(set.epoch(), none).rotation;
  const auto R_gcrf_from_itrf = earth_rotation(set.epoch(), none).rotation;
  const Eigen::Vector3d expected =
      R_gcrf_from_itrf.matrix() * R_teme_from_itrf.matrix().transpose() * in_teme;
  EXPECT_LT((in_gcrf - expected).norm(), 5.0);
  EXPECT_GT((in_gcrf - in_teme).norm(), 30.0 * km);
  // The velocity is the derivative of the position to what SGP4 leaves out, 0.02 m/s; where two sets are
  // blended, their difference of km counts.
  const auto h = 1.0 * si::second;
  for (const double hours : {1.0, 20.0, 40.0, 45.0, 50.0}) {
    const Epoch t = set.epoch() + convert<si::time>(hours * si::hour);
    const Eigen::Vector3d slope =
        (orbit.at(t + h).position.coordinates() - orbit.at(t - h).position.coordinates()) / 2.0;
    EXPECT_LT((slope - orbit.at(t).velocity.coordinates()).norm(), 0.05) << hours;
  }
}

// ---- kernels that the test writes ----

// A cubic in time, from 2000 on, in km: each type of degree 3 has it exactly.
Eigen::Vector3d cubic(double t, int derivative) {
  const double x = t / 1000.0, k = 1.0 / 1000.0;
  if (derivative == 0)
    return {7000.0 + 100.0 * x - 3.0 * x * x + x * x * x, -500.0 + 200.0 * x, 4.0 * x * x * x};
  return {k * (100.0 - 6.0 * x + 3.0 * x * x), k * 200.0, k * 12.0 * x * x};
}
// As Chebyshev polynomials over middle +- radius: x^2 = (1 + T2)/2, x^3 = (3 T1 + T3)/4.
std::vector<double> chebyshev(double middle, double radius, int derivative, int axis) {
  const auto f = [&](double x) { return cubic(middle + radius * x, derivative)(axis); };
  const double a0 = f(0.0), odd = (f(1.0) - f(-1.0)) / 2.0, even = (f(1.0) + f(-1.0)) / 2.0 - a0;
  const double half = (f(0.5) - f(-0.5)) / 2.0, a3 = (odd - 2.0 * half) / 0.75, a1 = odd - a3;
  return {a0 + even / 2.0, a1 + 0.75 * a3, even / 2.0, a3 / 4.0};
}
DafTestArray segment(int type, std::vector<double> numbers, double first, double last, int target = -77,
                     int center = 399, int frame = 1) {
  return {"S" + std::to_string(type), {first, last}, {target, center, frame, type}, std::move(numbers)};
}
DafTestArray of_type(int type, int target = -77, int center = 399, int frame = 1, double sign = 1.0) {
  std::vector<double> numbers;
  const double first = 100.0, step = 50.0;
  const auto add_state = [&](double t) {
    for (const int derivative : {0, 1}) {
      for (const double x : cubic(t, derivative)) numbers.push_back(sign * x);
    }
  };
  if (type == 2 || type == 3) {
    const int count = 20;
    for (int i = 0; i < count; ++i) {
      const double radius = step / 2.0, middle = first + i * step + radius;
      numbers.insert(numbers.end(), {middle, radius});
      for (int derivative = 0; derivative < type - 1; ++derivative) {
        for (int axis = 0; axis < 3; ++axis) {
          for (const double a : chebyshev(middle, radius, derivative, axis)) numbers.push_back(sign * a);
        }
      }
    }
    numbers.insert(numbers.end(), {first, step, type == 2 ? 14.0 : 26.0, 1.0 * count});
    return segment(type, numbers, first, first + count * step, target, center, frame);
  }
  const bool is_even = type == 8 || type == 12;
  std::vector<double> times;
  for (int i = 0; i <= 250; ++i) times.push_back(first + i * step + (is_even ? 0.0 : 10.0 * std::sin(i)));
  times.front() = first;
  for (const double t : times) add_state(t);
  if (is_even) {
    numbers.insert(numbers.end(), {first, step});
  } else {
    numbers.insert(numbers.end(), times.begin(), times.end());
    numbers.insert(numbers.end(), {times[99], times[199]});
  }
  const double window = type == 8 ? 3.0 : type == 9 ? 4.0 : type == 12 ? 1.0 : 2.0;
  numbers.insert(numbers.end(), {window, 1.0 * static_cast<double>(times.size())});
  return segment(type, numbers, first, times.back(), target, center, frame);
}
// At these seconds of ephemeris time.
Epoch at_seconds(double et) {
  return Epoch::from_julian_date(scale::tdb, 2451545.0, et / 86400.0);
}
EphemerisKernel written(const std::vector<DafTestArray>& arrays, bool big = false) {
  const TemporaryFile file(daf_bytes("SPK", arrays, big));
  return EphemerisKernel::open(file.path());
}
// ERFA's TDB and SPICE's ephemeris time differ by 2e-5 s near 2000, here of 0.3 km/s.
constexpr double of_time = 0.02, of_time_in_velocity = 1e-4;

TEST(EphemerisKernel, OfEachTypeIsExactForACubic) {
  for (const int type : {2, 3, 8, 9, 12, 13}) {
    for (const bool big : {false, true}) {
      const auto kernel = written({of_type(type)}, big);
      const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
      const auto part = kernel.motion(of<Ship>, relative_to<Gcrf>,
                                      from_until(at_seconds(400.0), at_seconds(420.0)), called<Ship>("-77"));
      for (const double t : {100.1, 125.0, 149.9, 410.0, 777.0, 1099.0}) {
        const auto now = orbit.at(at_seconds(t));
        EXPECT_LT((now.position.coordinates() - km * cubic(t, 0)).norm(), of_time) << type << " " << t;
        EXPECT_LT((now.velocity.coordinates() - km * cubic(t, 1)).norm(), of_time_in_velocity)
            << type << " " << t;
      }
      EXPECT_EQ(part.at(at_seconds(410.0)).position.coordinates(),
                orbit.at(at_seconds(410.0)).position.coordinates());
      EXPECT_THROW(static_cast<void>(part.at(at_seconds(421.0))), BadInput);
      EXPECT_THROW(static_cast<void>(orbit.at(at_seconds(99.0))), BadInput);
      EXPECT_THROW(static_cast<void>(orbit.at(kernel.span().end() + 1.0 * si::second)), BadInput);
    }
  }
}

TEST(EphemerisKernel, TakesTheStatesAroundTheInstant) {
  // x alone is 1 at the fourth of eight states, and 0 at the others: the value says which states were taken.
  const auto at = [](int type, double window, double t) {
    std::vector<double> numbers;
    for (int i = 0; i < 8; ++i) numbers.insert(numbers.end(), {i == 3 ? 1.0 : 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    if (type == 8) numbers.insert(numbers.end(), {0.0, 1000.0});
    if (type == 9) {
      for (int i = 0; i < 8; ++i) numbers.push_back(1000.0 * i);
    }
    numbers.insert(numbers.end(), {window, 8.0});
    const auto kernel = written({segment(type, numbers, 0.0, 7000.0)});
    const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
    return orbit.at(at_seconds(t)).position.coordinates().x() / km;
  };
  constexpr double of_time_per_step = 1e-6;
  for (const int type : {8, 9}) {
    // Two states: a straight line from one to the next.
    EXPECT_NEAR(at(type, 1.0, 2250.0), 0.25, of_time_per_step);
    EXPECT_NEAR(at(type, 1.0, 3250.0), 0.75, of_time_per_step);
    EXPECT_NEAR(at(type, 1.0, 4250.0), 0.0, of_time_per_step);
    // Three: the nearest one and its neighbours. At 2.6 that is the fourth, at 2.4 the third.
    EXPECT_NEAR(at(type, 2.0, 2600.0), 1.0 - 0.4 * 0.4, of_time_per_step);
    EXPECT_NEAR(at(type, 2.0, 2400.0), 0.4 * 1.4 / 2.0, of_time_per_step);
    // Four: two on each side.
    EXPECT_NEAR(at(type, 3.0, 4500.0), -1.0 / 16.0, of_time_per_step);
    EXPECT_NEAR(at(type, 3.0, 3500.0), 9.0 / 16.0, of_time_per_step);
    // At an end the first ones.
    EXPECT_NEAR(at(type, 3.0, 500.0), 1.0 / 16.0, of_time_per_step);
  }
}

TEST(EphemerisKernel, IsAnEdge) {
  const auto kernel = written({of_type(13)});
  const auto graph =
      frame_graph(edge(kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"))));
  const auto now = graph.at(at_seconds(500.0));
  EXPECT_LT((now.position(of<Ship>, relative_to<Gcrf>, in<Gcrf>).coordinates() - km * cubic(500.0, 0)).norm(),
            of_time);
}

TEST(EphemerisKernel, AddsSegmentsUp) {
  // As in a kernel of planets: the Moon and the Earth relative to their barycentre, that and the Sun to the
  // barycentre of the solar system.
  const auto kernel = written({of_type(2, 301, 3), of_type(2, 399, 3, 1, -2.0), of_type(2, 3, 0, 1, 10.0),
                               of_type(2, 10, 0, 1, 0.5)});
  const Epoch t = at_seconds(500.0);
  const Eigen::Vector3d r = km * cubic(500.0, 0), v = km * cubic(500.0, 1);
  const auto moon = kernel.motion(of<sky::Moon>, relative_to<Gcrf>, kernel.span()).at(t);
  EXPECT_LT((moon.position.coordinates() - 3.0 * r).norm(), 20.0 * of_time);
  const auto sun = kernel.motion(of<sky::Sun>, relative_to<Gcrf>, kernel.span()).at(t);
  EXPECT_LT((sun.position.coordinates() - (0.5 - (10.0 - 2.0)) * r).norm(), 20.0 * of_time);
  EXPECT_LT((sun.velocity.coordinates() - (0.5 - (10.0 - 2.0)) * v).norm(), 20.0 * of_time_in_velocity);
  const auto moon_of_sun =
      kernel
          .motion(of<sky::Moon>, relative_to<SunInertial>, kernel.span(), called<SunInertial>("J2000", "SUN"))
          .at(t);
  EXPECT_LT((moon_of_sun.position.coordinates() - (1.0 + 10.0 - 0.5) * r).norm(), 20.0 * of_time);
}

TEST(EphemerisKernel, TurnsFromTheEclipticOfJ2000) {
  const auto kernel = written({of_type(2, -77, 399, 17)});
  const Epoch t = at_seconds(500.0);
  const auto equator = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77")).at(t);
  const auto ecliptic = kernel
                            .motion(of<Ship>, relative_to<Ecliptic>, kernel.span(), called<Ship>("-77"),
                                    called<Ecliptic>("ECLIPJ2000"))
                            .at(t);
  const Eigen::Vector3d r = km * cubic(500.0, 0);
  EXPECT_LT((ecliptic.position.coordinates() - r).norm(), of_time);
  // The pole of the ecliptic is towards -y of the equator.
  constexpr double e = 84381.448 / 3600.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d expected(r.x(), std::cos(e) * r.y() - std::sin(e) * r.z(),
                                 std::sin(e) * r.y() + std::cos(e) * r.z());
  EXPECT_LT((equator.position.coordinates() - expected).norm(), of_time);
}

TEST(EphemerisKernel, TheLastSegmentThatKnowsAnInstantCounts) {
  auto narrow = of_type(9, -77, 399, 1, 2.0);
  narrow.doubles = {300.0, 400.0};
  for (const bool narrow_is_last : {true, false}) {
    const auto wide = of_type(2);
    const auto kernel = narrow_is_last ? written({wide, narrow}) : written({narrow, wide});
    const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
    for (const double t : {200.0, 350.0, 500.0}) {
      const double sign = narrow_is_last && t == 350.0 ? 2.0 : 1.0;
      EXPECT_LT((orbit.at(at_seconds(t)).position.coordinates() - sign * km * cubic(t, 0)).norm(),
                2.0 * of_time)
          << t;
    }
  }
}

TEST(EphemerisKernel, RefusesOtherBodiesAndFrames) {
  const TemporaryFile file(daf_bytes("SPK", {of_type(2)}));
  const auto kernel = EphemerisKernel::open(file.path());
  const auto asked = [&](const auto& call) { return complaint(call, file.path()); };
  const std::string has =
      "ephemeris kernel FILE: it has -77 relative to 'EARTH' (399), from 2000-01-01T12:00:35.816073 UTC to "
      "2000-01-01T12:17:15.816072 UTC; asked for ";
  const std::string span = " from 2000-01-01T12:00:35.816073 UTC to 2000-01-01T12:17:15.816072 UTC";
  EXPECT_EQ(
      asked([&] {
        static_cast<void>(kernel.motion(of<Other>, relative_to<Gcrf>, kernel.span(), called<Other>("-78")));
      }),
      has + "-78 (" + frame_name<Other>() + ") relative to 'EARTH' (399) (" + frame_name<Gcrf>() + ")" +
          span);
  EXPECT_EQ(asked([&] { static_cast<void>(kernel.motion(of<sky::Sun>, relative_to<Gcrf>, kernel.span())); }),
            has + "'SUN' (10) (" + frame_name<sky::Sun>() + ") relative to 'EARTH' (399) (" +
                frame_name<Gcrf>() + ")" + span);
  EXPECT_EQ(asked([&] {
              static_cast<void>(
                  kernel.motion(of<Ship>, relative_to<earth::Eme2000>, kernel.span(), called<Ship>("-77")));
            }),
            "ephemeris kernel FILE: asked for axes of " + frame_name<earth::Eme2000>() +
                "; it has those of J2000, which is earth::Gcrf, and ECLIPJ2000");
  EXPECT_EQ(
      asked([&] {
        static_cast<void>(kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("SHIP")));
      }),
      "ephemeris kernel FILE: 'SHIP' (" + frame_name<Ship>() +
          ") is no body that is known by name; give its number");
  EXPECT_EQ(asked([&] {
              static_cast<void>(
                  kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77", "MARS")));
            }),
            "ephemeris kernel FILE: the claim of the body '-77' (" + frame_name<Ship>() +
                ") has the centre 'MARS', which belongs to that of " + frame_name<Gcrf>());
  const TemporaryFile fixed(daf_bytes("SPK", {of_type(2, -77, 399, 13000)}));
  EXPECT_EQ(complaint(
                [&] {
                  const auto k = EphemerisKernel::open(fixed.path());
                  static_cast<void>(k.motion(of<Ship>, relative_to<Gcrf>, k.span(), called<Ship>("-77")));
                },
                fixed.path()),
            "ephemeris kernel FILE, segment 1 'S2': its frame is 13000; J2000 (1) and ECLIPJ2000 (17) are "
            "read; asked for " +
                frame_name<Gcrf>());
  const TemporaryFile circle(daf_bytes("SPK", {of_type(2, -77, -78), of_type(2, -78, -77)}));
  EXPECT_EQ(complaint(
                [&] {
                  const auto k = EphemerisKernel::open(circle.path());
                  static_cast<void>(k.motion(of<Ship>, relative_to<Other>, k.span(), called<Ship>("-77"),
                                             called<Other>("J2000", "-78"))
                                        .at(at_seconds(500.0)));
                },
                circle.path()),
            "ephemeris kernel FILE: the segments lead from -77 in a circle");
}

TEST(EphemerisKernel, RefusesNumbersThatDoNotFit) {
  const auto with = [](int type, std::ptrdiff_t at, double number) {
    DafTestArray array = of_type(type);
    (at < 0 ? array.numbers.end() : array.numbers.begin())[at] = number;
    const TemporaryFile file(daf_bytes("SPK", {array}));
    return complaint(
        [&] {
          const auto kernel = EphemerisKernel::open(file.path());
          static_cast<void>(kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77")));
        },
        file.path());
  };
  const std::string place = "ephemeris kernel FILE, segment 1 'S";
  EXPECT_EQ(with(2, 5, NAN), place + "2', number 6 of the segment: nan");
  EXPECT_EQ(with(2, -1, 1e9), place + "2': the number of records is 1e+09");
  EXPECT_EQ(with(2, -1, 19.0), place + "2': 19 records of 14 numbers do not make a segment of 284");
  EXPECT_EQ(with(2, -2, 13.0), place + "2': a record of 13 numbers");
  EXPECT_EQ(with(2, -3, 0.0), place + "2': the length of a piece is 0 s");
  EXPECT_EQ(with(2, 14, 200.0), place + "2', record 2: its piece is 200 +- 25 s; expected 150 to 200");
  EXPECT_EQ(with(2, 15, 50.0), place + "2', record 2: its piece is 175 +- 50 s; expected 150 to 200");
  EXPECT_EQ(with(8, -1, 250.0), place + "8': 250 states of type 8 are 1504 numbers; it has 1510");
  EXPECT_EQ(with(8, -2, 28.0), place + "8': the degree is 28");
  EXPECT_EQ(with(8, -3, -50.0), place + "8': the step is -50 s");
  EXPECT_EQ(with(12, -2, 14.0), place + "12': the size of a window less 1 is 14");
  EXPECT_EQ(with(13, -2, 0.5), place + "13': the size of a window less 1 is 0.5");
  EXPECT_EQ(with(9, -1, NAN), place + "9', number 1761 of the segment: nan");
  EXPECT_EQ(with(9, 6 * 251 + 7, 100.0).find(place + "9', state 8: its time is 100 s, after"), 0U);
  EXPECT_EQ(with(9, 6 * 251, 120.0).find(place + "9': the states are of 120 to"), 0U);
}

TEST(EphemerisKernel, SaysWhereItHasNothing) {
  auto later = of_type(2);
  for (double& t : later.doubles) t += 2000.0;
  later.numbers[284 - 4] += 2000.0;
  for (std::size_t i = 0; i < 20; ++i) later.numbers[14 * i] += 2000.0;
  const TemporaryFile file(daf_bytes("SPK", {of_type(2), later}));
  const auto kernel = EphemerisKernel::open(file.path());
  const auto part = from_until(at_seconds(300.0), at_seconds(2500.0));
  const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, part, called<Ship>("-77"));
  const auto at = [&](double t) {
    return complaint([&] { static_cast<void>(orbit.at(at_seconds(t))); }, file.path());
  };
  EXPECT_EQ(at(2400.0), "nothing was thrown");
  EXPECT_EQ(at(200.0),
            "ephemeris kernel FILE: the epoch 2000-01-01T12:02:15.816099 UTC is outside the times that were "
            "read, 2000-01-01T12:03:55.816099 UTC to 2000-01-01T12:40:35.816098 UTC");
  EXPECT_EQ(at(1500.0),
            "ephemeris kernel FILE: at 2000-01-01T12:23:55.816099 UTC its segments lead from -77 to -77, of "
            "which they have nothing then, and from 'EARTH' (399) to 'EARTH' (399)");
}

TEST(EphemerisKernel, RefusesAxesThatAreClaimedToBeOthers) {
  const TemporaryFile file(daf_bytes("SPK", {of_type(13)}));
  const auto kernel = EphemerisKernel::open(file.path());
  const auto asked = [&]<class F>(const Called<F>& claim) {
    return complaint(
        [&] {
          static_cast<void>(
              kernel.motion(of<Ship>, relative_to<F>, kernel.span(), called<Ship>("-77"), claim));
        },
        file.path());
  };
  EXPECT_EQ(asked(called<earth::Eme2000>("J2000")), "nothing was thrown");
  EXPECT_EQ(asked(called<earth::Itrf>("J2000")),
            "ephemeris kernel FILE: 'J2000' was claimed to be earth::Itrf");
  EXPECT_EQ(asked(called<earth::Teme>("1")), "ephemeris kernel FILE: 'J2000' was claimed to be earth::Teme");
  EXPECT_EQ(asked(called<Gcrf>("ECLIPJ2000")),
            "ephemeris kernel FILE: 'ECLIPJ2000' was claimed to be earth::Gcrf");
}

TEST(EphemerisKernel, RefusesAnotherTypeWhereItIsNeeded) {
  // The ways from the ship and from the Earth meet in body 3, so that its own segment is not needed.
  auto of_3 = of_type(2, 3, 0), of_other = of_type(2, -78);
  of_3.integers[3] = of_other.integers[3] = 1;
  const TemporaryFile file(
      daf_bytes("SPK", {of_type(13, -77, 3), of_type(2, 399, 3, 1, -2.0), of_3, of_other}));
  const auto kernel = EphemerisKernel::open(file.path());
  const auto span = from_until(at_seconds(200.0), at_seconds(900.0));
  const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, span, called<Ship>("-77"));
  EXPECT_LT((orbit.at(at_seconds(500.0)).position.coordinates() - 3.0 * km * cubic(500.0, 0)).norm(),
            3.0 * of_time);
  const auto asked = [&](const std::string& ship, const std::string& center) {
    return complaint(
        [&] {
          static_cast<void>(kernel.motion(of<Ship>, relative_to<Other>, span, called<Ship>(ship),
                                          called<Other>("J2000", center)));
        },
        file.path());
  };
  const std::string reason = "it is of type 1; the types 2, 3, 8, 9, 10, 12 and 13 are read";
  EXPECT_EQ(asked("-78", "EARTH"), "ephemeris kernel FILE, segment 4 'S2': " + reason);
  EXPECT_EQ(asked("-77", "SSB"), "ephemeris kernel FILE, segment 3 'S2': " + reason);
}

TEST(EphemerisKernel, RefusesOtherFiles) {
  const auto opened = [](const DafTestArray& array, const char* kind = "SPK") {
    const TemporaryFile file(daf_bytes(kind, {array}));
    return complaint([&] { static_cast<void>(EphemerisKernel::open(file.path())); }, file.path());
  };
  EXPECT_EQ(opened(of_type(2), "CK"), "DAF file FILE: it is a file of the kind 'CK', not SPK");
  EXPECT_EQ(opened(of_type(2, 399, 399)),
            "ephemeris kernel FILE, segment 1 'S2': it is of 'EARTH' (399) relative to itself");
  auto array = of_type(2);
  array.doubles[1] = 1e300;
  EXPECT_EQ(opened(array),
            "ephemeris kernel FILE, segment 1 'S2': the time 1e+300 s is more than 9000 years from 2000");
  array.doubles.pop_back();
  EXPECT_EQ(opened(array),
            "ephemeris kernel FILE, segment 1 'S2': a summary of 1 doubles and 6 integers; an ephemeris "
            "kernel has 2 and 6");
}

TEST(EphemerisKernel, RefusesElementsThatDoNotFit) {
  // The segment of CTIM, changed in one number.
  const auto daf = DafFile::open(examples / "CTIM_20230420_orbit.bsp");
  const DafFile::Array& ctim = daf.arrays().front();
  const auto with = [&](std::size_t at, double number) {
    DafTestArray array{"S", ctim.doubles, ctim.integers, daf.read(ctim, 0, ctim.size)};
    array.numbers[at] = number;
    const TemporaryFile file(daf_bytes("SPK", {array}));
    return complaint(
        [&] {
          const auto kernel = EphemerisKernel::open(file.path());
          static_cast<void>(kernel.motion(of<Ctim>, relative_to<Gcrf>, kernel.span(), called<Ctim>("-152950"))
                                .at(kernel.span().start()));
        },
        file.path());
  };
  const std::string place = "ephemeris kernel FILE, segment 1 'S'";
  EXPECT_EQ(with(7, 1.0), "nothing was thrown");
  EXPECT_EQ(with(3, 0.07), place + ": the constant 4 of SGP4 is 0.07; that of WGS-72 is 0.0743669161");
  EXPECT_EQ(with(88, 15.0), place + ": its directory has 15 entries; 17 are read");
  EXPECT_EQ(with(83, 1e6), place + ": the number of sets is 1e+06");
  EXPECT_EQ(with(83, 3.0), place + ": 8 constants, 3 sets of 14 numbers and 4 epochs");
  EXPECT_EQ(with(82, 80.0), place + ": its parts do not fit into 89 numbers");
  EXPECT_EQ(with(69, 0.0), place + ", set 2: its epoch is 0 s, after 735184426.4492486");
  EXPECT_EQ(with(18, 735184427.0),
            place + ", set 1: its epoch is 735184427 s, and in the list 735184426.4492486");
  EXPECT_EQ(with(12, NAN), place + ", number 13 of the segment: nan");
  EXPECT_EQ(with(14, 1.5).find(place + ", set 1: "), 0U);
}

}  // namespace
}  // namespace vectrix::ephemeris_kernel_test
