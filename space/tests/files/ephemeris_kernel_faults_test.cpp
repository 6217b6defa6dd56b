#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "files/ephemeris_kernels.hpp"

namespace vectrix::ephemeris_kernel_test {
namespace {

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

}  // namespace
}  // namespace vectrix::ephemeris_kernel_test
