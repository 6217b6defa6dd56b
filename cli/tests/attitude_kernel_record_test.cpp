#include "attitude_kernel_record.hpp"

#include <gtest/gtest.h>

#include <string>

#include "space/tests/files/daf_text.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::attitude_kernel_record_test {
namespace {

const std::string clock_file = std::string{VECTRIX_SOURCE_DIR} + "/examples/data/CTIM_clock.tsc";
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

}  // namespace
}  // namespace vectrix::cli::attitude_kernel_record_test
