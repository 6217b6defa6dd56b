#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "attitude_motion.hpp"
#include "pointing_error.hpp"
#include "space/tests/temporary_file.hpp"
#include "target.hpp"

namespace vectrix::cli::relative_error_test {
namespace {

using Eigen::Vector3d;

const Convention stated{Convention::Scalar::last, Convention::Maps::to_reference};

// The target drifts along a great circle: the mean of evenly spaced directions is in their middle.
RC_GTEST_PROP(RelativeError, OfASteadyDriftIsHalfOfIt, ()) {
  const auto window = *rc::gen::inRange<int>(1, 40);
  const double rate = 1e-3 * *rc::gen::inRange(1, 50);
  const AttitudeMotion drift{{0.0, 0.0, rate}, {0.0, 0.0, 1e-9}};
  const auto record = drift.record(50, stated, stated, RateAxes::body, RateAxes::body);
  const auto seen = seen_in_body(record, std::vector<Vector3d>(record.size(), Vector3d::UnitX()));
  const auto found = relative_errors(record, seen, window);
  constexpr double rounding = 1e-7;  // rad: of the other axis' 1e-9 rad/s, and of a mean of unit vectors
  RC_ASSERT(found.errors.size() == static_cast<std::size_t>(50 - window));
  RC_ASSERT(found.left_out == static_cast<std::size_t>(window));
  for (const double error : found.errors) RC_ASSERT(std::abs(error - 0.5 * rate * window) <= rounding);
  RC_ASSERT(std::abs(found.largest_change - rate * window) <= rounding);
  RC_ASSERT(found.change_until == found.change_from + static_cast<std::size_t>(window));
}

TEST(RelativeError, LeavesOutWindowsThatReachOverAGap) {
  const AttitudeMotion still{{0.0, 0.0, 0.001}, {0.0, 0.0, 0.001}};
  auto record = still.record(20, stated, stated, RateAxes::body, RateAxes::body);
  for (std::size_t i = 10; i < 20; ++i) record.times[i] = record.times[i] + 100.0 * si::second;
  const auto seen = seen_in_body(record, std::vector<Vector3d>(record.size(), Vector3d::UnitX()));
  const auto found = relative_errors(record, seen, 4.0);
  // From each stretch of 10 samples, those that begin at its first 6.
  EXPECT_EQ(found.starts, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(found.left_out, 8U);
  EXPECT_NEAR(found.largest_change, 4.0 * 0.002, 1e-9);  // not over the gap
  EXPECT_EQ(relative_errors(record, seen, 4.5).starts,
            (std::vector<std::size_t>{0, 1, 2, 3, 4, 10, 11, 12, 13, 14}));
  const auto refusal = [&](double window) {
    return complaint([&] { (void)relative_errors(record, seen, window); });
  };
  EXPECT_EQ(refusal(10.0), "the window of 10 s: no stretch without gaps of motion is so long");
  EXPECT_EQ(refusal(0.9), "the window of 0.9 s is shorter than the steps of motion, 1.000000 s");
}

// A target opposite to itself half a turn later has no mean direction.
TEST(RelativeError, IsRefusedWhereTheDirectionsCancel) {
  const AttitudeMotion still{{0.0, 0.0, 0.001}, {0.0, 0.0, 0.001}};
  const auto record = still.record(4, stated, stated, RateAxes::body, RateAxes::body);
  const std::vector<Vector3d> seen{Vector3d::UnitX(), -Vector3d::UnitX(), Vector3d::UnitX(),
                                   Vector3d(-1.0, 1e-13, 0.0)};
  EXPECT_EQ(
      complaint([&] { (void)relative_errors(record, seen, 1.0); }),
      "in the window from 2026-11-29T00:00:00.000000 UTC the directions of the target cancel; they have "
      "no mean direction");
}

// The windows by looking at each direction of each.
RC_GTEST_PROP(RelativeError, IsThatOfEachWindow, ()) {
  const auto window = *rc::gen::inRange<std::size_t>(1, 150);
  const double size = *rc::gen::element(1e-7, 1e-3, 1.0);
  const AttitudeMotion still{{0.0, 0.0, 0.001}, {0.0, 0.0, 0.001}};
  const auto record = still.record(300, stated, stated, RateAxes::body, RateAxes::body);
  const auto any = [&] { return size * 1e-6 * *rc::gen::inRange(-1'000'000, 1'000'000); };
  std::vector<Vector3d> seen;
  for (std::size_t i = 0; i < record.size(); ++i) seen.push_back(Vector3d(any(), any(), 2.0).normalized());
  const auto found = relative_errors(record, seen, static_cast<double>(window));
  RC_ASSERT(found.errors.size() == record.size() - window);
  constexpr double rounding = 1e-14;  // rad: of a sum in another order
  double change = 0.0;
  for (std::size_t first = 0; first < record.size(); ++first) {
    Vector3d sum = Vector3d::Zero();
    const std::size_t end = std::min(first + window + 1, record.size());
    for (std::size_t i = first; i < end; ++i) {
      sum += seen[i];
      change = std::max(change, angle_between(seen[first], seen[i]));
    }
    if (first >= found.errors.size()) continue;
    double largest = 0.0;
    for (std::size_t i = first; i < end; ++i) largest = std::max(largest, angle_between(seen[i], sum));
    RC_ASSERT(std::abs(found.errors[first] - largest) <= rounding);
  }
  RC_ASSERT(std::abs(found.largest_change - change) <= rounding);
  RC_ASSERT(std::abs(angle_between(seen[found.change_from], seen[found.change_until]) - change) <= rounding);
}

// Each sample of a whole window once, and none of those that reach over a gap or over what does not count.
TEST(WindowErrors, AreThoseOfWindowsOneAfterTheOther) {
  const double rate = 1e-3;
  const AttitudeMotion drift{{0.0, 0.0, rate}, {0.0, 0.0, 1e-9}};
  auto record = drift.record(20, stated, stated, RateAxes::body, RateAxes::body);
  const auto seen = seen_in_body(record, std::vector<Vector3d>(record.size(), Vector3d::UnitX()));
  for (std::size_t i = 10; i < 20; ++i) record.times[i] = record.times[i] + 100.0 * si::second;
  // Of 10 samples 0 to 3 and 4 to 7, whose middles are 1.5 and 5.5 steps from the first direction.
  const auto found = window_errors(record, seen, Vector3d::UnitX(), 3.0);
  constexpr double rounding = 1e-7;  // rad: of the other axis' 1e-9 rad/s, and of a mean of unit vectors
  ASSERT_EQ(found.of_means.size(), 4U);
  ASSERT_EQ(found.from_means.size(), 16U);
  const std::vector<double> middles{1.5, 5.5, 11.5, 15.5};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(found.of_means[k], rate * middles[k], rounding);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(found.from_means[4 * k + i], rate * std::abs(static_cast<double>(i) - 1.5), rounding);
  }
  std::vector<bool> among(20, true);
  among[2] = false;  // so 3 to 6, then 10 to 13 and 14 to 17
  EXPECT_EQ(window_errors(record, seen, Vector3d::UnitX(), 3.0, among).of_means.size(), 3U);
  EXPECT_EQ(complaint([&] { (void)window_errors(record, seen, Vector3d::UnitX(), 10.0); }),
            "the window of 10 s: no stretch without gaps of motion is so long");
}

}  // namespace
}  // namespace vectrix::cli::relative_error_test
