#include <gtest/gtest.h>

#include <filesystem>
#include <vectrix/space.hpp>

#include "temporary_file.hpp"

// Clocks of kernels: fields, partitions, and their time.
namespace vectrix::spacecraft_clock_test {
namespace {

const std::filesystem::path data = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";

// Three partitions, of 1000, 500 and 10000 ticks of 1/100 s. The clock is set back in the second, runs 10 %
// slow for a while, and in the third it was off for 1000 s.
const std::string kernel = R"(
\begindata
SCLK_DATA_TYPE_77       = ( 1 )
SCLK01_TIME_SYSTEM_77   = ( 2 )
SCLK01_N_FIELDS_77      = ( 3 )
SCLK01_MODULI_77        = ( 1000 60 100 )
SCLK01_OFFSETS_77       = ( 0 0 1 )
SCLK01_OUTPUT_DELIM_77  = ( 2 )
SCLK_PARTITION_START_77 = ( 100 0 5000 )
SCLK_PARTITION_END_77   = ( 1100 500 15000 )
SCLK01_COEFFICIENTS_77  = ( 0     0.0     60.0
                            1000  10.0    66.0
                            1500  1015.5  60.0 )
\begintext
)";

constexpr double exact_seconds = 1e-10;  // the clock of an Epoch has 1e-11 s

SpacecraftClock clock() {
  return SpacecraftClock::of(TextKernel::parse(kernel), -77);
}
double seconds(const Epoch& t) {
  return (t - Epoch::from_tt("2000-01-01T12:00:00")).value();
}
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kernel;
  text.replace(text.find(from), from.size(), to);
  return complaint([&] { static_cast<void>(SpacecraftClock::of(TextKernel::parse(text), -77)); });
}

TEST(SpacecraftClock, CountsOverItsPartitions) {
  const auto c = clock();
  EXPECT_EQ(c.ticks("1/0:01:01").count, 0.0);     // 100 ticks of the clock
  EXPECT_EQ(c.ticks("1/0:11:01").count, 1000.0);  // the end of the first
  EXPECT_EQ(c.ticks("2/0:00:01").count, 1000.0);  // the start of the second
  EXPECT_EQ(c.ticks("2/0:04:51").count, 1450.0);
  EXPECT_EQ(c.ticks("3/0:50:01").count, 1500.0);
  EXPECT_EQ(c.ticks("3/1.30,26").count, 1500.0 + (9000.0 + 25.0 - 5000.0));
  EXPECT_EQ(c.ticks("3/1-30").count, 5500.0);  // fields at the end may be left out
}

TEST(SpacecraftClock, WritesWhatItReads) {
  const auto c = clock();
  for (const double count : {0.0, 17.0, 999.0, 1000.0, 1499.0, 1500.0, 11500.0})
    EXPECT_EQ(c.ticks(c.text({count})).count, count) << c.text({count});
  EXPECT_EQ(c.text({1450.4}), "2/000:04:051");
}

TEST(SpacecraftClock, RunsEvenlyInEachPiece) {
  const auto c = clock();
  for (const auto& [count, s] : {std::pair{0.0, 0.0},
                                 {500.0, 5.0},
                                 {1000.0, 10.0},
                                 {1100.0, 11.1},
                                 {1500.0, 1015.5},
                                 {11500.0, 1115.5}}) {
    EXPECT_NEAR(seconds(c.epoch({count})), s, exact_seconds) << count;
    EXPECT_NEAR(c.ticks(Epoch::from_tt("2000-01-01T12:00:00") + s * si::second).count, count,
                100.0 * exact_seconds);
  }
  // While it is off, it does not go past where it begins again.
  EXPECT_EQ(c.ticks(Epoch::from_tt("2000-01-01T12:10:00")).count, 1500.0);
}

TEST(SpacecraftClock, OfCtimCountsMillisecondsOfEphemerisTime) {
  const auto c = SpacecraftClock::read(data / "CTIM_clock.tsc", -152950);
  // Of the first row of CTIM's attitude, and the tick of the kernel that was made of it.
  const Epoch t = Epoch::from_utc("2023-04-20T05:00:09.001");
  constexpr double tick = 1366002078186.5957, tick_ulp = 2.44140625e-4;
  EXPECT_NEAR(c.ticks(t).count, tick, 2.0 * tick_ulp);
  EXPECT_NEAR((c.epoch({tick}) - t).value(), 0.0, 2e-3 * tick_ulp);
  EXPECT_EQ(c.ticks("1/1366002078:186").count, 1366002078186.0);
  EXPECT_EQ(c.text({1366002078186.4}), "1/1366002078.186");
}

TEST(SpacecraftClock, RefusesOtherCounts) {
  const auto c = clock();
  const auto of = [&](const char* text) { return complaint([&] { static_cast<void>(c.ticks(text)); }); };
  EXPECT_EQ(of("0:02:01"), "text kernel, clock -77: '0:02:01': the partitions 1 and 2 have this count");
  EXPECT_EQ(of("2/0:10:01"),
            "text kernel, clock -77: '2/0:10:01': this partition does not have the count 1000");
  EXPECT_EQ(of("9:00:01"), "text kernel, clock -77: '9:00:01': no partition has the count 54000");
  EXPECT_EQ(of("4/0"), "text kernel, clock -77: '4/0': the partitions are 1 to 3");
  EXPECT_EQ(of("1/0:60:01"), "text kernel, clock -77: '1/0:60:01': field 2 is 60; it counts from 0 to 59");
  EXPECT_EQ(of("1/0:00:00"), "text kernel, clock -77: '1/0:00:00': field 3 is 0; it counts from 1 to 100");
  EXPECT_EQ(of("1/0:0x:00"), "text kernel, clock -77: '1/0:0x:00': the field '0x' is not a whole number");
  EXPECT_EQ(of("1/0:00:01:00"), "text kernel, clock -77: '1/0:00:01:00': the clock has 3 fields");
  EXPECT_EQ(of(""), "text kernel, clock -77: '': the field '' is not a whole number");
  EXPECT_EQ(complaint([&] { static_cast<void>(c.epoch({-1.0})); }),
            "text kernel, clock -77: it knows no time of -1 ticks, only of 0 to 11500");
  EXPECT_EQ(complaint([&] { static_cast<void>(c.epoch({std::nan("")})); }),
            "text kernel, clock -77: it knows no time of nan ticks, only of 0 to 11500");
  EXPECT_EQ(complaint([&] { static_cast<void>(c.ticks(Epoch::from_tt("1999-12-31T00:00:00"))); }),
            "text kernel, clock -77: it begins after 1999-12-30T23:58:55.816000 UTC");
  EXPECT_EQ(complaint([&] { static_cast<void>(c.ticks(Epoch::from_tt("2000-01-02T00:00:00"))); }),
            "text kernel, clock -77: its last partition ends before 2000-01-01T23:58:55.816000 UTC");
}

TEST(SpacecraftClock, RefusesWrongKernels) {
  EXPECT_EQ(changed("TYPE_77       = ( 1 )", "TYPE_77 = 2"),
            "text kernel, line 3: the variable 'SCLK_DATA_TYPE_77' is 2; only type 1 is known");
  EXPECT_EQ(changed("= ( 2 )\nSCLK01_N", "= 3\nSCLK01_N"),
            "text kernel, line 4: the variable 'SCLK01_TIME_SYSTEM_77' is 3; it is 1, TDB, or 2, TT");
  EXPECT_EQ(
      changed("FIELDS_77      = ( 3 )", "FIELDS_77 = 1e9"),
      "text kernel, line 5: the variable 'SCLK01_N_FIELDS_77' is 1000000000; a clock has 1 to 10 fields");
  EXPECT_EQ(changed("1000 60 100", "1000 60"),
            "text kernel, line 6: the variable 'SCLK01_MODULI_77' has 2 numbers for 3 fields");
  EXPECT_EQ(changed("1000 60 100", "1000 0 100"),
            "text kernel, line 6: the variable 'SCLK01_MODULI_77' has the number 0");
  EXPECT_EQ(changed("100 0 5000", "100 0"),
            "text kernel, line 10: the variable 'SCLK_PARTITION_END_77' has 3 numbers for 2 partitions");
  EXPECT_EQ(changed("100 0 5000", "100 600 5000"),
            "text kernel, line 10: the variable 'SCLK_PARTITION_END_77' says that partition 2 goes from 600 "
            "to 500");
  EXPECT_EQ(changed("10.0    66.0", "10.0    0"),
            "text kernel, line 12, column 43: the rate is not positive");
  EXPECT_EQ(changed("1000  10.0", "0     10.0"),
            "text kernel, line 12, column 29: the ticks do not increase, after 0");
  EXPECT_EQ(changed("1015.5", "10"),
            "text kernel, line 13, column 35: the times do not increase, after 10 s");
  EXPECT_EQ(changed("1015.5  60.0", "1015.5"),
            "text kernel, line 11: the variable 'SCLK01_COEFFICIENTS_77' has 8 values, which are no triples");
  EXPECT_EQ(complaint([&] { static_cast<void>(SpacecraftClock::of(TextKernel::parse(kernel), -78)); }),
            "text kernel: there is no variable 'SCLK_DATA_TYPE_78'");
}

}  // namespace
}  // namespace vectrix::spacecraft_clock_test
