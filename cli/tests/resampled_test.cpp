#include "resampled.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "attitude_motion.hpp"
#include "sample_faults.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::resampled_test {
namespace {

using Eigen::Vector3d;

const Convention stated{Convention::Scalar::last, Convention::Maps::to_body};

// Turns at a constant rate about one axis.
AttitudeRecord spin(double rate, std::size_t count) {
  const AttitudeMotion motion{{0.0, 0.0, 1e-300}, rate * Vector3d(0.6, 0.0, 0.8)};
  return motion.record(count, stated, stated, RateAxes::body, RateAxes::body);
}
Epoch at(double seconds) {
  return Epoch::from_utc("2026-11-29T00:00:00") + seconds * si::second;
}

RC_GTEST_PROP(Resampled, IsTheMotionOfAConstantRate, ()) {
  const double rate = 1e-3 * *rc::gen::inRange(-2700, 2700);  // below 0.9 of half a turn
  const double t = 1e-3 * *rc::gen::inRange(0, 8001);
  const auto record = resampled(spin(rate, 9), {at(0.0), at(t), at(8.0)});
  const auto expected = Eigen::Quaterniond(Eigen::AngleAxisd(rate * t, Vector3d(0.6, 0.0, 0.8)));
  constexpr double rounding = 1e-9;  // rad: epochs are kept to 1e-11 s
  RC_ASSERT(record.size() == 3U);
  RC_ASSERT(angle_of(record.to_reference(1, record.stated).conjugate() * expected) <= rounding);
}

TEST(Resampled, IsNotInGapsAndNotOutside) {
  auto record = spin(0.1, 9);
  record.times.erase(record.times.begin() + 4);
  record.numbers.erase(record.numbers.begin() + 4);
  const std::vector<Epoch> asked{at(-0.5), at(0.0), at(3.0), at(3.5), at(4.5), at(5.0), at(8.0), at(8.5)};
  EXPECT_EQ(resampled(record, asked).times,
            (std::vector<Epoch>{asked[1], asked[2], asked[3], asked[4], asked[5], asked[6]}));
  record.longest_step = 1.5;
  EXPECT_EQ(resampled(record, asked).times, (std::vector<Epoch>{asked[1], asked[2], asked[5], asked[6]}));
  EXPECT_EQ(complaint([&] {
              (void)resampled(record, {at(3.5), at(4.0), at(5.5)});
            }),
            "motion: 1 instant of 3 instants are within the samples and in no gap; at least two are needed");
}

// Steps that are longer than a gap are none; where an instant is left out is one.
TEST(Resampled, HasTheGapsOfTheRecord) {
  auto record = spin(0.01, 41);
  record.times.erase(record.times.begin() + 19, record.times.begin() + 22);  // 18 to 22 s
  record.numbers.erase(record.numbers.begin() + 19, record.numbers.begin() + 22);
  for (const std::optional<double> gap : {std::optional<double>{}, std::optional<double>{1.5}})
    for (const double step : {0.5, 1.0, 4.0}) {
      record.longest_step = gap;
      std::vector<Epoch> asked;
      for (double t = 0.0; t <= 40.0; t += step) asked.push_back(at(t));
      const auto found = resampled(record, asked);
      std::vector<double> gaps;
      for (const double duration : durations_of(found))
        if (duration > longest_step(found, step)) gaps.push_back(duration);
      ASSERT_EQ(gaps.size(), 1U) << step;
      EXPECT_NEAR(gaps[0], step == 4.0 ? 8.0 : 4.0, 1e-9);
    }
}

TEST(Resampled, DoesNotGuessWhichWayItTurned) {
  const auto record = spin(0.95 * std::numbers::pi, 9);
  EXPECT_TRUE(says(complaint([&] {
                     (void)resampled(record, {at(1.5), at(2.5)});
                   }),
                   "from 2026-11-29T00:00:01.000 UTC to 2026-11-29T00:00:02.000 UTC the attitude turns by "
                   "171 deg, nearly half a turn"));
}

}  // namespace
}  // namespace vectrix::cli::resampled_test
