#include <gtest/gtest.h>

#include <filesystem>
#include <vectrix/space.hpp>

#include "temporary_file.hpp"

// Attitude kernels that are written, and read again.
namespace vectrix::attitude_kernel_writer_test {
namespace {

using earth::Gcrf;

struct Ctim : moving_frame {};

const std::filesystem::path examples = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";

class Written {
 public:
  Written() = default;
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  ~Written() { std::filesystem::remove(path); }

  const std::filesystem::path path = temporary_path(".bc");
};

struct Flight {
  SpacecraftClock clock = SpacecraftClock::read(examples / "CTIM_clock.tsc", -152950);
  FrameKernel frames = FrameKernel::read(examples / "CTIM_frames.tf");
  AttitudeKernel kernel = AttitudeKernel::open(examples / "CTIM_20230420_attitude.bc", clock, frames);
  Called<Ctim> ctim = called<Ctim>("CTIM_COORD");
  std::vector<AttitudeSample<Gcrf, Ctim, Epoch>> samples =
      kernel.samples(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim);
  std::vector<AngularVelocity<Gcrf, Ctim, In<Gcrf>>> rates =
      kernel.recorded_rates(of<Ctim>, relative_to<Gcrf>, kernel.span(), ctim);
};

TEST(AttitudeKernelWriter, WritesWhatTheFlightHas) {
  const Flight flight;
  const Written file;
  const AttitudeKernelText text{"CTIM, AGAIN", 30.1 * si::second, "One line\nand another\n"};
  write_attitude_kernel(file.path, text, flight.samples, flight.rates, flight.clock, flight.frames,
                        flight.ctim);
  // The numbers of the flight's own kernel, but for the norm.
  const auto daf = DafFile::open(file.path), flown = DafFile::open(examples / "CTIM_20230420_attitude.bc");
  const DafFile::Array &ours = daf.arrays().front(), &theirs = flown.arrays().front();
  EXPECT_EQ(ours.integers, theirs.integers);
  ASSERT_EQ(ours.size, theirs.size);
  const auto x = daf.read(ours, 0, ours.size), y = flown.read(theirs, 0, theirs.size);
  constexpr double rounding = 1e-15, ulps_of_ticks = 2e-15 / 4.0;
  for (std::size_t i = 0; i < 692; ++i) {
    const double norm = Eigen::Vector4d(y[7 * i], y[7 * i + 1], y[7 * i + 2], y[7 * i + 3]).norm();
    for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(x[7 * i + k], y[7 * i + k] / norm, rounding);
    for (std::size_t k = 4; k < 7; ++k) ASSERT_EQ(x[7 * i + k], y[7 * i + k]);
  }
  for (std::size_t i = std::size_t{7} * 692; i < x.size(); ++i)
    ASSERT_NEAR(x[i], y[i], ulps_of_ticks * y[i]) << i;
  EXPECT_EQ(daf.comments(), text.comments);

  const auto again = AttitudeKernel::open(file.path, flight.clock, flight.frames);
  const auto a = again.attitude(of<Ctim>, relative_to<Gcrf>, again.span(), flight.ctim);
  const auto b = flight.kernel.attitude(of<Ctim>, relative_to<Gcrf>, flight.kernel.span(), flight.ctim);
  constexpr double turn = 1e-9;  // in the rounding of the ticks
  for (const Epoch& t : every(7.0 * si::second, from_until(again.span().start(), 3600.0 * si::second)))
    EXPECT_LT((a(t).rotation.matrix() - b(t).rotation.matrix()).norm(), turn);
}

TEST(AttitudeKernelWriter, EndsIntervalsAtLongGaps) {
  const Flight flight;
  const Written file;
  write_attitude_kernel(file.path, {"S", 15.0 * si::second}, flight.samples, flight.clock, flight.frames,
                        flight.ctim);
  const auto again = AttitudeKernel::open(file.path, flight.clock, flight.frames);
  EXPECT_FALSE(again.segments().front().has_rates);
  const auto attitude = again.attitude(of<Ctim>, relative_to<Gcrf>, again.span(), flight.ctim);
  int gaps = 0;
  for (std::size_t i = 0; i + 1 < flight.samples.size(); ++i) {
    const auto step = flight.samples[i + 1].time - flight.samples[i].time;
    const Epoch middle = flight.samples[i].time + 0.5 * step;
    if (step.value() < 15.0) {
      // A record that stands alone between two gaps is no interval.
      EXPECT_NO_THROW(attitude(middle));
    } else {
      EXPECT_THROW(attitude(middle), BadInput) << i;
      ++gaps;
    }
  }
  EXPECT_GT(gaps, 20);
}

TEST(AttitudeKernelWriter, RefusesWhatAKernelCannotHave) {
  const Flight flight;
  const Written file;
  const AttitudeKernelText text{"S", 30.1 * si::second};
  const auto written = [&](const AttitudeKernelText& what, const auto& samples,
                           const SpacecraftClock& clock) {
    return complaint(
        [&] { write_attitude_kernel(file.path, what, samples, clock, flight.frames, flight.ctim); },
        file.path);
  };
  auto turned = flight.samples;
  std::swap(turned[1], turned[2]);
  EXPECT_EQ(written(text, turned, flight.clock),
            "attitude kernel FILE: the sample of 2023-04-20T05:00:19.001000 UTC is not a tick after the one "
            "before");
  turned.clear();
  EXPECT_EQ(written(text, turned, flight.clock), "attitude kernel FILE: there are no samples");
  EXPECT_EQ(written({"", 1.0 * si::second}, flight.samples, flight.clock),
            "attitude kernel FILE: the name of the segment, '', is not of 1 to 40 printable characters");
  EXPECT_EQ(written({"S", -1.0 * si::second}, flight.samples, flight.clock),
            "attitude kernel FILE: the longest gap is -1 s");
  EXPECT_EQ(written({"S", 1.0 * si::second, "a\tb"}, flight.samples, flight.clock),
            "attitude kernel FILE: the comments have characters that are not printable");
  const auto other = SpacecraftClock::of(
      TextKernel::parse(
          "\\begindata\nSCLK_DATA_TYPE_77=1 SCLK01_N_FIELDS_77=1 SCLK01_MODULI_77=1e12 SCLK01_OFFSETS_77=0 "
          "SCLK_PARTITION_START_77=0 SCLK_PARTITION_END_77=1e12 SCLK01_COEFFICIENTS_77=(0 0 1)\n"),
      -77);
  EXPECT_EQ(written(text, flight.samples, other),
            "attitude kernel FILE: the ticks of the frame -152950000 are those of the clock -152950; given "
            "was the clock -77");
  auto few = flight.rates;
  few.pop_back();
  EXPECT_EQ(complaint(
                [&] {
                  write_attitude_kernel(file.path, text, flight.samples, few, flight.clock, flight.frames,
                                        flight.ctim);
                },
                file.path),
            "attitude kernel FILE: there are 692 samples and 691 rates");
  EXPECT_FALSE(std::filesystem::exists(file.path));
  EXPECT_EQ(complaint([&] {
              write_attitude_kernel("/no/such/folder.bc", text, flight.samples, flight.clock, flight.frames,
                                    flight.ctim);
            }),
            "attitude kernel /no/such/folder.bc: cannot be written");
}

}  // namespace
}  // namespace vectrix::attitude_kernel_writer_test
