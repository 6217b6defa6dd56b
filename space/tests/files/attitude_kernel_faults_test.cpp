#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "files/attitude_kernels.hpp"

namespace vectrix::attitude_kernel_test {
namespace {

TEST(AttitudeKernel, RefusesOtherFramesAndClocks) {
  const auto kernel = ctim();
  const auto path = (examples / "CTIM_20230420_attitude.bc").string();
  const auto asked = [&](const auto& call) { return complaint(call, path); };
  EXPECT_EQ(asked([&] {
              static_cast<void>(
                  kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-152950001")));
            }),
            "attitude kernel FILE: it has -152950000 relative to 'J2000' (1); asked for -152950001 (" +
                frame_name<Body>() + ") relative to 'J2000' (1) (" + frame_name<Gcrf>() + ")");
  EXPECT_EQ(asked([&] {
              static_cast<void>(kernel.attitude(of<Ctim>, relative_to<Craft>, kernel.span(), ctim_frame,
                                                called<Craft>("ECLIPJ2000")));
            }),
            "attitude kernel FILE: it has -152950000 relative to 'J2000' (1); asked for -152950000 (" +
                frame_name<Ctim>() + ") relative to 'ECLIPJ2000' (17) (" + frame_name<Craft>() + ")");
  EXPECT_NE(
      asked([&] {
        static_cast<void>(kernel.attitude(of<Ctim>, relative_to<earth::Eme2000>, kernel.span(), ctim_frame));
      }).find("in them J2000 is earth::Gcrf"),
      std::string::npos);
  // Who claims it gets it.
  EXPECT_NO_THROW(static_cast<void>(kernel.attitude(of<Ctim>, relative_to<earth::Eme2000>, kernel.span(),
                                                    ctim_frame, called<earth::Eme2000>("J2000"))));
  EXPECT_EQ(
      asked([&] { static_cast<void>(AttitudeKernel::open(path, clock_of(-77))); }),
      "attitude kernel FILE, segment 1 '/Users/brst3037/code/ctim_config/kernels': the ticks of the frame "
      "-152950000 are those of the clock -152950; given was the clock -77");
  EXPECT_EQ(asked([&] {
              static_cast<void>(kernel.samples(
                  of<Ctim>, relative_to<Gcrf>,
                  from_until(Epoch::from_utc("2024-01-01T00:00:00"), 1.0 * si::second), ctim_frame));
            }),
            "attitude kernel FILE, segment 1 '/Users/brst3037/code/ctim_config/kernels': it goes from "
            "2023-04-20T05:00:09.001000 UTC to 2023-04-20T06:59:59.001000 UTC; asked for "
            "2024-01-01T00:00:00.000000 UTC "
            "to 2024-01-01T00:00:01.000000 UTC");
}

TEST(AttitudeKernel, RefusesAReferenceThatIsClaimedToBeAnother) {
  const auto kernel = ctim();
  const auto asked = [&](const Called<earth::Itrf>& claim) {
    return complaint([&] {
      static_cast<void>(
          kernel.attitude(of<Ctim>, relative_to<earth::Itrf>, kernel.span(), ctim_frame, claim));
    });
  };
  EXPECT_EQ(asked(called<earth::Itrf>("J2000")), "text kernel: 'J2000' was claimed to be earth::Itrf");
  // Of that frame the kernel has nothing, and says so.
  EXPECT_NE(asked(called<earth::Itrf>("ITRF93")).find("asked for -152950000"), std::string::npos);
}

TEST(AttitudeKernel, RefusesNumbersThatDoNotFit) {
  const auto good = steady_segment("S", {0.0, 100.0, 200.0}, true, {0.0, 100.0});
  const auto with = [&](std::size_t at, double number) {
    DafTestArray array = good;
    array.numbers[at] = number;
    const TemporaryFile file(daf_bytes("CK", {array}));
    return complaint(
        [&] { static_cast<void>(attitude_of(AttitudeKernel::open(file.path(), clock_of(-77)))); },
        file.path());
  };
  const std::string place = "attitude kernel FILE, segment 1 'S'";
  EXPECT_EQ(with(0, good.numbers[0]), "nothing was thrown");
  EXPECT_EQ(with(8, NAN), place + ", record 2: its number 2 is nan");
  EXPECT_EQ(with(13, HUGE_VAL), place + ", record 2: its number 7 is inf");
  EXPECT_EQ(with(7, 1e200), place + ", record 2: a quaternion of norm inf");
  EXPECT_EQ(with(22, 250.0), place + ", record 3: the ticks are 200, after 250");
  EXPECT_EQ(with(22, NAN), place + ", record 2: the ticks are nan, after 0");
  EXPECT_EQ(with(24, 50.0), place + ", interval 1: it does not begin with the first record");
  EXPECT_EQ(with(25, 150.0), place + ", an interval begins at 150 ticks, where there is no record");
  EXPECT_EQ(with(26, 4.0), place + ": it has 4 intervals and 3 records");
  EXPECT_EQ(with(26, 1.5), place + ": the number of intervals is 1.5, in a segment of 28 numbers");
  EXPECT_EQ(with(27, 1e15), place + ": the number of records is 1e+15, in a segment of 28 numbers");
  EXPECT_EQ(with(27, NAN), place + ": the number of records is nan, in a segment of 28 numbers");
  EXPECT_EQ(with(27, 2.0), place + ": 2 records of type 3 are 20 numbers; it has 28");
  DafTestArray zero = good;
  for (std::size_t i = 0; i < 4; ++i) zero.numbers[i] = 0.0;
  const TemporaryFile file(daf_bytes("CK", {zero}));
  EXPECT_EQ(
      complaint([&] { static_cast<void>(attitude_of(AttitudeKernel::open(file.path(), clock_of(-77)))); },
                file.path()),
      place + ", record 1: a quaternion of norm 0");
}

TEST(AttitudeKernel, RefusesAnotherTypeWhereItIsNeeded) {
  const auto good = steady_segment("S", {0.0, 100.0}, true, {0.0});
  auto other = steady_segment("T", {200.0, 300.0}, true, {200.0});
  other.integers[2] = 5;
  const TemporaryFile file(daf_bytes("CK", {good, other}));
  const auto kernel = AttitudeKernel::open(file.path(), clock_of(-77));
  const auto asked = [&](const TimeSpan& span) {
    return complaint(
        [&] {
          static_cast<void>(kernel.attitude(of<Body>, relative_to<Gcrf>, span,
                                            called<Body>(std::to_string(good.integers[0]))));
        },
        file.path());
  };
  EXPECT_EQ(kernel.segments()[1].type, 5);
  EXPECT_EQ(asked(from_until(at_ticks(0.0), at_ticks(100.0))), "nothing was thrown");
  EXPECT_EQ(asked(kernel.span()),
            "attitude kernel FILE, segment 2 'T': it is of type 5; the types 1, 2 and 3 are read");
}

TEST(AttitudeKernel, RefusesOtherFiles) {
  const auto opened = [](const std::string& bytes) {
    const TemporaryFile file(bytes);
    return complaint([&] { static_cast<void>(AttitudeKernel::open(file.path(), clock_of(-77))); },
                     file.path());
  };
  auto array = steady_segment("S", {0.0, 100.0}, true, {0.0});
  EXPECT_EQ(opened(daf_bytes("SPK", {array})), "DAF file FILE: it is a file of the kind 'SPK', not CK");
  array.integers[3] = 2;
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': the flag of the rates is 2");
  array.integers.pop_back();
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': a summary of 2 doubles and 5 integers; an attitude kernel "
            "has 2 and 6");
  array = steady_segment("S", {0.0, 100.0}, true, {0.0});
  array.doubles[0] = NAN;
  EXPECT_EQ(opened(daf_bytes("CK", {array})),
            "attitude kernel FILE, segment 1 'S': it goes from nan to 100 ticks");
}

}  // namespace
}  // namespace vectrix::attitude_kernel_test
