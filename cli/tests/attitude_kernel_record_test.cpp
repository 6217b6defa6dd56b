#include "attitude_kernel_record.hpp"

#include <gtest/gtest.h>

#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::attitude_kernel_record_test {
namespace {

const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
const std::filesystem::path kernel = data / "CTIM_20230420_attitude.bc";

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
  EXPECT_EQ(refusal("NOPE", {}), "--ck-frame NOPE: this is no number, and --fk has no frame of this name");
  EXPECT_EQ(refusal("CTIM_COORD", {}), "nothing was thrown");
}

}  // namespace
}  // namespace vectrix::cli::attitude_kernel_record_test
