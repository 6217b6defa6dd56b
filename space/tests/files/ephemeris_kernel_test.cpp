#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "files/ephemeris_kernels.hpp"

// A cubesat's orbit in two-line elements: an ephemeris kernel of type 10.
namespace vectrix::ephemeris_kernel_test {
namespace {

struct Ctim : moving_frame {};
struct Radiometer : moving_frame {};

const std::filesystem::path examples = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";

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
