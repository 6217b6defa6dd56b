#include "sample_faults.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::sample_faults_test {
namespace {

const TableColumns columns{
    "t",    scale::utc, {"w", "x", "y", "z"}, {Convention::Scalar::first, Convention::Maps::to_body},
    "GCRF", {}};

std::string written(const std::string& rows) {
  TemporaryFile file("t,w,x,y,z\n" + rows);
  std::ostringstream out;
  write_samples(read_table(file.path(), columns), out);
  return out.str();
}

TEST(SampleFaults, AreOneOrMany) {
  const std::string steps =
      "2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:01,1,0,0,0\n2026-11-29T00:00:02,1,0,0,0\n"
      "2026-11-29T00:00:03,1,0,0,0\n2026-11-29T00:00:04,1,0,0,0\n";
  const std::string one = written(steps + "2026-11-29T00:00:09,-1,0,0,0\n");
  EXPECT_TRUE(
      says(one, "  1 gap, a step longer than three times the usual one; most 5 s, which ends at sample 6, "));
  EXPECT_TRUE(says(one, "  1 change from q to -q: the attitude is one"));
  const std::string two = written(steps + "2026-11-29T00:00:09,-1,0,0,0\n2026-11-29T00:00:15,1,0,0,0\n");
  EXPECT_TRUE(says(two, "  2 gaps, steps longer than three times the usual one; most 6 s"));
  EXPECT_TRUE(says(two, "  2 changes from q to -q"));
}

// One of each.
TEST(SampleFaults, AreCountedWhereTheyAre) {
  AttitudeRecord record;
  record.reference = "GCRF";
  record.stated = {Convention::Scalar::first, Convention::Maps::to_body};
  const auto start = Epoch::from_utc("2026-11-29T00:00:00");
  const auto add = [&](double second, double angle, double factor) {
    record.times.push_back(start + second * si::second);
    record.numbers.push_back({factor * std::cos(0.5 * angle), factor * std::sin(0.5 * angle), 0.0, 0.0});
  };
  for (int i = 0; i < 10; ++i) add(i, 0.001 * i, 1.0);
  add(10.0, 0.010, -1.0);  // -q: a change of sign, and one back
  add(11.0, 0.011, 1.0);
  add(20.0, 0.020, 1.0);         // a gap of 9 s
  add(21.0, 0.121, 1.0);         // a jump of 0.1 rad
  add(22.0, 0.122, 1.0 + 2e-6);  // the norm
  add(23.0, 3.122, 1.0);         // a jump of 3 rad, near half a turn
  add(23.5, 3.130, 1.0);         // as fast as a jump, but less than half a degree
  const SampleFaults found = faults_of(record);
  EXPECT_EQ(found.sign_flips.count, 2U);
  EXPECT_EQ(found.sign_flips.sample, 10U);
  EXPECT_EQ(found.gaps.count, 1U);
  EXPECT_EQ(found.gaps.sample, 12U);
  EXPECT_NEAR(found.gaps.largest, 9.0, 1e-9);
  EXPECT_EQ(found.jumps.count, 2U);
  EXPECT_EQ(found.half_turns.count, 1U);
  EXPECT_EQ(found.half_turns.sample, 15U);
  EXPECT_NEAR(found.half_turns.largest, 3.0, 1e-12);
  EXPECT_EQ(found.norm_errors.count, 1U);
  EXPECT_EQ(found.norm_errors.sample, 14U);
  EXPECT_EQ(found.scale, 1.0);
  EXPECT_NEAR(found.median_step, 1.0, 1e-9);
}

// A body that turns by 0.01 rad/s, ever faster, each 10 s; every seventh time, or attitude, is 2 s late.
TEST(SampleFaults, AreTimesThatAreLate) {
  const auto of = [](double time_late, double attitude_late) {
    AttitudeRecord record;
    record.reference = "GCRF";
    record.stated = {Convention::Scalar::first, Convention::Maps::to_body};
    for (int i = 0; i < 50; ++i) {
      const bool is_late = i % 7 == 4;
      const double t = 10.0 * i + (is_late ? attitude_late : 0.0), angle = 0.01 * t + 1e-6 * t * t;
      record.times.push_back(Epoch::from_utc("2026-11-29T00:00:00") +
                             (10.0 * i + (is_late ? time_late : 0.0)) * si::second);
      record.numbers.push_back({std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0});
    }
    return faults_of(record).wrong_times;
  };
  const auto late = of(2.0, 0.0);
  EXPECT_EQ(late.count, 7U);  // 4, 11, ... 46
  EXPECT_EQ(late.sample % 7, 4U);
  EXPECT_NEAR(late.largest, 2.0, 1e-9);
  EXPECT_EQ(of(0.0, 0.0).count, 0U);
  EXPECT_EQ(of(2.0, 2.0).count, 0U);  // the step is irregular, and the body turned with it
  EXPECT_EQ(of(0.05, 0.0).count, 0U);
}

TEST(SampleFaults, NeedTwoSamples) {
  TemporaryFile file("t,w,x,y,z\n");
  EXPECT_EQ(complaint([&] { (void)read_table(file.path(), columns); }, file.path()),
            "FILE: there are 0 samples; at least two are needed");
}

}  // namespace
}  // namespace vectrix::cli::sample_faults_test
