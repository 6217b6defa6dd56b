#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/attitude_kernels.hpp"

namespace vectrix::attitude_kernel_test {
namespace {

// "0 to 400; 500 to 900; ", ticks.
std::string coverage_of(const AttitudeKernel& kernel, double from, double until) {
  std::string text;
  for (const TimeSpan& span : kernel.coverage(
           of<Body>, relative_to<Gcrf>, from_until(at_ticks(from), at_ticks(until)), called<Body>("-77001")))
    text += std::to_string(std::lround((span.start() - at_ticks(0.0)).value() * 100.0)) + " to " +
            std::to_string(std::lround((span.end() - at_ticks(0.0)).value() * 100.0)) + "; ";
  return text;
}

// Two intervals, and a record alone in a third one.
DafTestArray with_gaps() {
  return steady_segment("GAPS", {0.0, 200.0, 400.0, 500.0, 900.0, 950.0}, true, {0.0, 500.0, 950.0});
}

TEST(AttitudeCoverage, IsWhereTheAttitudeAnswers) {
  const auto kernel = written({with_gaps()});
  EXPECT_EQ(coverage_of(kernel, 0.0, 1000.0), "0 to 400; 500 to 900; ");
  EXPECT_EQ(coverage_of(kernel, 100.0, 600.0), "100 to 400; 500 to 600; ");
  EXPECT_EQ(coverage_of(kernel, 250.0, 350.0), "250 to 350; ");  // between two records
  EXPECT_EQ(coverage_of(kernel, 410.0, 490.0), "");
  const auto attitude = attitude_of(kernel);
  for (const double ticks : {0.0, 400.0, 500.0, 900.0}) EXPECT_NO_THROW((void)attitude(at_ticks(ticks)));
  for (const double ticks : {401.0, 499.0, 950.0}) EXPECT_THROW((void)attitude(at_ticks(ticks)), BadInput);
}

TEST(AttitudeCoverage, IsThatOfAllSegmentsButOfType1) {
  const auto later = steady_segment("LATER", {350.0, 450.0}, true, {350.0});
  const auto touching = steady_segment("TOUCHING", {450.0, 500.0}, true, {450.0});
  const auto single = steady_segment("SINGLE", {2000.0, 2100.0}, true, {});
  EXPECT_EQ(coverage_of(written({with_gaps(), later, touching, single}), 0.0, 3000.0), "0 to 900; ");
}

}  // namespace
}  // namespace vectrix::attitude_kernel_test
