#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/time_span.hpp>

#include "temporary_file.hpp"

namespace vectrix::time_span_test {
namespace {

const Epoch start = Epoch::from_utc("2016-12-31T23:59:55");
constexpr double clock_rounding = 3e-11;  // s

static_assert(std::input_iterator<EpochRange::Iterator>);

std::vector<Epoch> listed(const EpochRange& range) {
  std::vector<Epoch> list;
  for (const Epoch& t : range) list.push_back(t);
  return list;
}

TEST(TimeSpan, HasBothEnds) {
  const auto span = from_until(start, 10.0 * si::second);
  EXPECT_EQ(span.end().utc(0), "2017-01-01T00:00:04");  // a leap second is between
  EXPECT_TRUE(span.contains(start) && span.contains(span.end()));
  EXPECT_FALSE(span.contains(span.end() + 1e-6 * si::second));
  EXPECT_FALSE(span.contains(start - 1e-6 * si::second));
  EXPECT_EQ(listed(every(10.0 * si::second, from_until(start, start))), std::vector{start});
}

TEST(TimeSpan, ARangeEndsAtTheLastStepWithinTheSpan) {
  const auto list = listed(every(3.0 * si::second, from_until(start, 10.0 * si::second)));
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0], start);
  EXPECT_EQ(list[2].utc(0), "2017-01-01T00:00:00");
  EXPECT_EQ(list[3].utc(0), "2017-01-01T00:00:03");
}

// Ten million steps of 0.1 s: a sum would have moved by 1e-3 s.
TEST(TimeSpan, StepsAreCountedNotSummed) {
  const auto span = from_until(start, 1e6 * si::second);
  const auto range = every(0.1 * si::second, span);
  EXPECT_EQ(range.size(), 10'000'001);
  EXPECT_EQ(range[10'000'000], span.end());
  EXPECT_NEAR((range[9'999'999] - start).value(), 999'999.9, 2e-10);  // 1e6 s is rounded to 1e-10 s
}

// A whole number of steps includes the end, however step and clock are rounded; and no epoch is past the end.
RC_GTEST_PROP(TimeSpan, TheEndBelongsToAWholeNumberOfSteps, ()) {
  const auto begin = start + *rc::gen::inRange(0, 1'000'000'000) * 1.37e-2 * si::second;
  const auto steps = *rc::gen::inRange(1, 1'000'000);
  const double step = *rc::gen::inRange(1, 100'000) / 700.0;
  const auto span = from_until(begin, steps * step * si::second);
  const auto range = every(step * si::second, span);
  RC_ASSERT(range.size() == steps + 1);
  RC_ASSERT(span.contains(range[steps]));
  const double rounding = clock_rounding + 4e-16 * steps * step;
  RC_ASSERT(std::abs((span.end() - range[steps]).value()) <= rounding);
  // A duration of one rounding less still has the last step, which is then the end.
  const auto cut = from_until(begin, std::nextafter(steps * step, 0.0) * si::second);
  const auto steps_of_cut = every(step * si::second, cut);
  RC_ASSERT(steps_of_cut.size() == steps + 1);
  RC_ASSERT(cut.contains(steps_of_cut[steps]));
  const auto shorter = every(step * si::second, from_until(begin, (steps - 0.001) * step * si::second));
  RC_ASSERT(shorter.size() == steps);
}

TEST(TimeSpan, RefusesWhatIsNoSpanAndNoStep) {
  EXPECT_EQ(complaint([] { from_until(start, start - 1.0 * si::second); }),
            "from_until: the end, 2016-12-31T23:59:54.000000 UTC, is before the start, "
            "2016-12-31T23:59:55.000000 UTC");
  EXPECT_EQ(complaint([] { from_until(start, -1.0 * si::second); }), "from_until: the duration is -1 s");
  const double infinity = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(from_until(start, infinity * si::second), BadInput);
  EXPECT_THROW(from_until(start, not_a_number * si::second), BadInput);
  const auto span = from_until(start, 10.0 * si::second);
  EXPECT_EQ(complaint([&] { (void)every(0.0 * si::second, span); }), "every: the step is 0 s");
  EXPECT_THROW((void)every(-1.0 * si::second, span), BadInput);
  EXPECT_THROW((void)every(infinity * si::second, span), BadInput);
  EXPECT_THROW((void)every(not_a_number * si::second, span), BadInput);
  EXPECT_EQ(complaint([&] { (void)every(1e-300 * si::second, span); }),
            "every: the step of 1e-300 s is too short for a span of 10 s");
}

TEST(TimeSpan, DurationsInOtherUnits) {
  const auto midnight = Epoch::from_utc("2016-12-31T00:00:00");
  EXPECT_EQ(from_until(midnight, 1.0 * si::day).end(), midnight + 86400.0 * si::second);
  EXPECT_EQ(from_until(midnight, 90.0 * si::minute).end(), midnight + 5400.0 * si::second);
  EXPECT_THROW(from_until(midnight, -1.0 * si::day), BadInput);
}

}  // namespace
}  // namespace vectrix::time_span_test
