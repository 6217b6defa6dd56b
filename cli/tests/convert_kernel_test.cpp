#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "convert.hpp"
#include "cubesat.hpp"
#include "kernel_writer.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"
#include "target.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::convert_kernel_test {
namespace {

using earth::Gcrf;

struct Body : moving_frame {};

const auto data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";

// The name of the body is that of the frame kernel, if there is one.
TEST(ConvertKernel, TakesTheNameOfTheBodyFromAKernel) {
  const TemporaryFolder folder;
  AttitudeSource source{data / "CTIM_20230420_attitude.bc"};
  source.kernel = KernelWords{.clock = (data / "CTIM_clock.tsc").string()};
  ConvertOptions options{folder.file("out.aem")};
  options.text = {"CTIM", "2022-074G", "LASP", "2026-11-29T00:00:00"};
  std::ostringstream said;
  EXPECT_EQ(complaint([&] { convert(source, options, said); }, source.file),
            "FILE: the file does not say what a message needs; missing: --body FRAME");
  source.kernel->frames = (data / "CTIM_frames.tf").string();
  convert(source, options, said);
  EXPECT_EQ(read_message(options.out, {}).body, "CTIM_COORD");
  options.out = folder.file("out.a");
  said.str("");
  convert(source, options, said);
  const std::string norms = "divided by their norms";
  EXPECT_TRUE(says(said.str(), norms));
  EXPECT_EQ(said.str().find(norms), said.str().rfind(norms)) << "said twice";
}

// The numbers come back but for the norms and the ticks, which have 1e-7 s in 2023.
TEST(ConvertKernel, WritesAKernelOfSpice) {
  TemporaryFolder folder;
  const KernelWords words{
      (data / "CTIM_clock.tsc").string(), (data / "CTIM_frames.tf").string(), {}, "CTIM_COORD"};
  const AttitudeSource flown = cubesat_attitude();
  ConvertOptions options;
  options.out = folder.file("out.bc");
  options.kernel = words;
  std::ostringstream said;
  convert(flown, options, said);
  EXPECT_TRUE(says(said.str(), "692 samples of the body relative to GCRF"));
  const AttitudeRecord before = read_attitude(flown), after = read_attitude({options.out, {}, {}, words});
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after.body, "CTIM_COORD");
  constexpr double of_ticks = 2e-7, rounding = 1e-14;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR((after.times[i] - before.times[i]).value(), 0.0, of_ticks);
    EXPECT_LE(
        angle_of(before.to_reference(i, before.stated).conjugate() * after.to_reference(i, after.stated)),
        rounding);
  }
  // Intervals end at the gaps: 30 s, three times the usual step.
  const auto clock = SpacecraftClock::read(words.clock, -152950);
  const auto frames = FrameKernel::read(words.frames);
  const auto kernel = AttitudeKernel::open(options.out, clock, frames);
  const auto attitude =
      kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("CTIM_COORD"));
  EXPECT_NO_THROW(attitude(before.times[0] + 5.0 * si::second));
  options.kernel.frame.clear();
  EXPECT_TRUE(says(complaint([&] { convert(flown, options, said); }), "missing: --ck-frame NAME"));
  options.kernel = words;
  options.frame = "EME2000";
  EXPECT_TRUE(says(complaint([&] { convert(flown, options, said); }), "--frame GCRF turns it"));
}

// Rates of body axes in deg/s: a kernel wants the reference, rad/s.
TEST(ConvertKernel, TurnsTheRatesOfAKernel) {
  PlainAttitude attitude{"B", "GCRF"};
  const double s = std::sqrt(0.5);
  attitude.quaternions = {{2.0 * s, 0.0, 0.0, 2.0 * s}};  // R takes x of the body to y
  attitude.rates = {{180.0, 0.0, 0.0}};
  attitude.rates_in_degrees = true;
  const PlainAttitude found = as_in_a_kernel(attitude);
  constexpr double rounding = 1e-14;
  EXPECT_LE((found.rates[0] - Eigen::Vector3d(0.0, std::numbers::pi, 0.0)).norm(), rounding);
  EXPECT_EQ(found.rate_axes, RateAxes::reference);
  EXPECT_EQ(found.computed.size(), 3U);
}

}  // namespace
}  // namespace vectrix::cli::convert_kernel_test
