#include "attitude_kernel_record.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "sample_faults.hpp"
#include "space/tests/files/daf_text.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::attitude_kernel_record_test {
namespace {

const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
const std::filesystem::path kernel = data / "CTIM_20230420_attitude.bc";
const std::string clock_file = (data / "CTIM_clock.tsc").string();

std::string refusal(const std::string& frame, const Selection& selection) {
  const KernelWords words{(data / "CTIM_clock.tsc").string(), (data / "CTIM_frames.tf").string(), "", frame};
  return complaint([&] { (void)read_kernel(kernel, words, selection); }, kernel);
}

TEST(AttitudeKernelRecord, IsOfTheTimesThatAreAskedFor) {
  const std::string span =
      "FILE: its attitude is from 2023-04-20T05:00:09.001000 UTC to 2023-04-20T06:59:59.001000 UTC, none in "
      "the "
      "times that are asked for";
  Selection before, after;
  before.until = Epoch::from_utc("2023-04-20T04:00:00");
  after.from = Epoch::from_utc("2023-04-20T08:00:00");
  EXPECT_EQ(refusal("", before), span);
  EXPECT_EQ(refusal("", after), span);
}

TEST(AttitudeKernelRecord, NamesAFrameThatIsNotThere) {
  EXPECT_EQ(refusal("NOPE", {}), "--ck-frame NOPE: this is no number, and " +
                                     (data / "CTIM_frames.tf").string() + " has no frame of this name");
  EXPECT_EQ(complaint([&] { (void)read_kernel(kernel, {.clock = clock_file, .frame = "NOPE"}, {}); }),
            "--ck-frame NOPE: this is no number, and no frame kernel is given");
  EXPECT_EQ(refusal("CTIM_COORD", {}), "nothing was thrown");
}

constexpr double first = 1366002078186.0, last = first + 10000.0;  // ms

// Two records of type 3 at rest, with rates or without.
DafTestArray segment(int frame, bool has_rates) {
  std::vector<double> numbers;
  for (int i = 0; i < 2; ++i) {
    numbers.insert(numbers.end(), {1.0, 0.0, 0.0, 0.0});
    if (has_rates) numbers.insert(numbers.end(), {0.001, 0.002, 0.003});
  }
  numbers.insert(numbers.end(), {first, last, first, 1.0, 2.0});
  return {"S", {first, last}, {frame, 1, 3, has_rates ? 1 : 0}, numbers};
}

// Whether another frame of the file has rates does not matter.
TEST(AttitudeKernelRecord, HasTheRatesOfItsFrame) {
  const TemporaryFile file(daf_bytes("CK", {segment(-152950000, true), segment(-152950001, false)}));
  const auto rates = [&](const char* frame) {
    return read_kernel(file.path(), {.clock = clock_file, .frame = frame}, {}).rates;
  };
  ASSERT_EQ(rates("-152950000").size(), 2U);
  EXPECT_EQ(rates("-152950000").front(), Eigen::Vector3d(0.001, 0.002, 0.003));
  EXPECT_TRUE(rates("-152950001").empty());
}

// The second segment begins in the middle of the first one, and is turned from it.
TEST(AttitudeKernelRecord, SaysWhatLaterSegmentsHide) {
  constexpr double half = 5000.0;
  DafTestArray later = segment(-152950000, false);
  later.name = "LATER";
  later.doubles = {first + half, last + half};
  later.numbers = {0.8, 0.6, 0.0, 0.0, 0.8, 0.6, 0.0, 0.0, first + half, last + half, first + half, 1.0, 2.0};
  const TemporaryFile file(daf_bytes("CK", {segment(-152950000, false), later}));
  const auto record = read_kernel(file.path(), {.clock = clock_file}, {});
  ASSERT_EQ(record.size(), 3U);
  EXPECT_NEAR((record.times[1] - record.times[0]).value(), 5.0, 1e-6);  // s; a tick is 1e-3 s
  EXPECT_DOUBLE_EQ(record.numbers[0][0], 1.0);
  EXPECT_DOUBLE_EQ(record.numbers[1][0], 0.8);
  EXPECT_EQ(record.interval_starts, (std::vector{record.times[0], record.times[1]}));
  EXPECT_EQ(record.hidden_segments, "segment 1 'S' for 5 s");
  std::ostringstream out;
  write_samples(record, out);
  EXPECT_NE(out.str().find("hidden by later segments of the kernel: segment 1 'S' for 5 s\n"),
            std::string::npos);
  const TemporaryFile one(daf_bytes("CK", {later}));
  EXPECT_EQ(read_kernel(one.path(), {.clock = clock_file}, {}).hidden_segments, "");
}

}  // namespace
}  // namespace vectrix::cli::attitude_kernel_record_test
