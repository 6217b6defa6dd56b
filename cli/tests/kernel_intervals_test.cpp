#include <gtest/gtest.h>

#include <sstream>

#include "resampled.hpp"
#include "sample_faults.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::kernel_intervals_test {
namespace {

// Samples each 10 s; a kernel says that an interval ends with the third one.
AttitudeRecord two_intervals() {
  AttitudeRecord record;
  record.file = "a.bc";
  record.body = "B";
  record.reference = "GCRF";
  record.stated = {Convention::Scalar::first, Convention::Maps::to_body};
  const Epoch start = Epoch::from_utc("2023-04-20T05:00:00");
  for (int i = 0; i < 6; ++i) {
    record.times.push_back(start + 10.0 * i * si::second);
    record.numbers.push_back({1.0, 0.0, 0.0, 0.01 * i});
  }
  record.interval_starts = {record.times[0], record.times[3]};
  return record;
}

TEST(KernelIntervals, AreNotInterpolatedAcross) {
  const AttitudeRecord record = two_intervals();
  std::vector<Epoch> instants;
  for (double s = 0.0; s <= 50.0; s += 5.0) instants.push_back(record.times[0] + s * si::second);
  const AttitudeRecord found = resampled(record, instants);
  ASSERT_EQ(found.size(), instants.size() - 1);  // but 25 s
  for (const Epoch& t : found.times) EXPECT_NE(t, instants[5]);
  EXPECT_TRUE(says(complaint([&] { (void)step_at(record, instants[5]); }), "is in a gap"));
  EXPECT_NO_THROW((void)step_at(record, record.times[2]));
  EXPECT_NO_THROW((void)step_at(record, record.times[3]));
}

TEST(KernelIntervals, AreSaid) {
  AttitudeRecord record = two_intervals();
  std::ostringstream out;
  write_samples(record, out);
  EXPECT_TRUE(says(out.str(),
                   "1 step from one interval of the kernel to another, over which nothing is interpolated, "
                   "first at sample 4"));
  record.interval_starts = {record.times[0]};
  EXPECT_EQ(faults_of(record).breaks.count, 0U);
}

}  // namespace
}  // namespace vectrix::cli::kernel_intervals_test
