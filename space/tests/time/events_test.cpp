#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/events.hpp>

#include "temporary_file.hpp"

namespace vectrix::events_test {
namespace {

constexpr double pi = std::numbers::pi;
const Epoch start = Epoch::from_utc("2023-04-20T05:00:00");
const auto day = from_until(start, 86400.0 * si::second);

// The tolerance of events, and the rounding of the clock in a result and in a difference of epochs.
constexpr double found_to = 1e-9 + 4e-11;  // s

double seconds(const Epoch& epoch) {
  return (epoch - start).value();
}

template <class F>
concept HasEvents = requires(const F& f) {
  { events(day, 1.0 * si::second, f) } -> std::same_as<std::vector<ZeroCrossing>>;
};
static_assert(HasEvents<double (*)(const Epoch&)> && HasEvents<Quantity<si::angle> (*)(Epoch)>);
static_assert(!HasEvents<bool (*)(const Epoch&)> && !HasEvents<int (*)(const Epoch&)>);
static_assert(!HasEvents<double (*)(double)>);

// sin(2 pi (t - phase)/period): zeros at phase + k period/2, in turn rising and falling.
TEST(Events, FindsTheZerosOfASine) {
  constexpr double period = 5400.0, phase = 1234.5678;
  const auto wave = [](const Epoch& t) { return std::sin(2 * pi * (seconds(t) - phase) / period); };
  const auto found = events(day, 300.0 * si::second, wave);
  ASSERT_EQ(found.size(), 32U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(seconds(found[i].epoch), phase + static_cast<double>(i) * period / 2, found_to);
    EXPECT_EQ(found[i].direction, i % 2 == 0 ? Crossing::rising : Crossing::falling);
  }
  const auto positive = intervals(day, 300.0 * si::second, wave);
  ASSERT_EQ(positive.size(), 16U);
  for (std::size_t i = 0; i < positive.size(); ++i) {
    EXPECT_EQ(positive[i].start(), found[2 * i].epoch);
    EXPECT_EQ(positive[i].end(), found[2 * i + 1].epoch);
  }
}

// Polynomials of random zeros, which are at least a step apart; every step finds the same.
TEST(Events, TheStepDoesNotMoveThem) {
  std::mt19937_64 random(20261205);
  std::uniform_real_distribution<double> gap(120.0, 10000.0), step(1.0, 119.0);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> zeros;
    for (double t = gap(random); zeros.size() < 7 && t < 86400.0; t += gap(random)) zeros.push_back(t);
    const auto f = [&](const Epoch& t) {
      double product = 1.0;
      for (const double zero : zeros) product *= (seconds(t) - zero) / 86400.0;
      return product * si::metre;
    };
    const auto found = events(day, step(random) * si::second, f);
    ASSERT_EQ(found.size(), zeros.size());
    for (std::size_t k = 0; k < zeros.size(); ++k) {
      EXPECT_NEAR(seconds(found[k].epoch), zeros[k], found_to);
      EXPECT_EQ(found[k].direction == Crossing::rising, (zeros.size() - k) % 2 == 1);
    }
  }
}

// Steps of a 1024th of a day are exact on the clock, so that the zeros are at instants of the grid.
TEST(Events, EndsOfTheSpanAndZerosOnTheGrid) {
  const Epoch midday = Epoch::from(scale::tai, "2023-04-20T12:00:00");
  const auto step = 84.375 * si::second;
  const auto span = from_until(midday, 9.5 * step);
  const auto steps = [&](const Epoch& t) { return (t - midday).value() / 84.375; };
  const auto line = [&](double zero, double slope) {
    return [=](const Epoch& t) { return slope * (steps(t) - zero); };
  };
  const auto find = [&](const auto& f) { return events(span, step, f); };
  ASSERT_EQ(find(line(5.0, 1.0)).size(), 1U);
  EXPECT_EQ(find(line(5.0, 1.0))[0].epoch, midday + 5.0 * step);
  EXPECT_EQ(find(line(5.0, -2.0)).at(0).direction, Crossing::falling);
  EXPECT_NEAR(steps(find(line(9.25, 1.0)).at(0).epoch), 9.25, found_to / 84.375) << "in the last half step";
  int evaluations = 0;
  const auto counted = [&](const Epoch& t) {
    ++evaluations;
    return std::expm1(steps(t) - 5.0);
  };
  EXPECT_EQ(find(counted).at(0).epoch, midday + 5.0 * step);
  EXPECT_EQ(evaluations, 11) << "a zero of the grid needs no search";
  for (const double second : {6.0, 6.5}) {
    const auto found = find([&](const Epoch& t) { return (steps(t) - 2.0) * (steps(t) - second); });
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].epoch, midday + 2.0 * step);
    EXPECT_NEAR(steps(found[1].epoch), second, found_to / 84.375);
    EXPECT_EQ(found[1].direction, Crossing::rising);
  }
  EXPECT_TRUE(find(line(0.0, 1.0)).empty());
  EXPECT_TRUE(find(line(9.5, 1.0)).empty());
  const auto touching = [&](const Epoch& t) { return std::pow(steps(t) - 5.0, 2); };
  EXPECT_TRUE(find(touching).empty());

  const auto positive = [&](const auto& f) { return intervals(span, step, f); };
  const auto expect_whole = [&](const std::vector<TimeSpan>& found) {
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].start(), span.start());
    EXPECT_EQ(found[0].end(), span.end());
  };
  expect_whole(positive(line(0.0, 1.0)));
  expect_whole(positive(line(9.5, -1.0)));
  expect_whole(positive(touching));
  EXPECT_TRUE(positive(line(9.5, 1.0)).empty());
  EXPECT_TRUE(positive(line(0.0, -1.0)).empty());
  const auto first = positive(line(9.25, -1.0));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].start(), span.start());
  EXPECT_NEAR(steps(first[0].end()), 9.25, found_to / 84.375);

  const auto instant = from_until(midday, midday);
  EXPECT_TRUE(events(instant, step, line(1.0, 1.0)).empty());
  EXPECT_TRUE(intervals(instant, step, line(1.0, 1.0)).empty());
  EXPECT_EQ(intervals(instant, step, line(1.0, -1.0)).size(), 1U);
}

// A parabola that exceeds zero by d: its zeros are sqrt(8 d/|f''|) apart. They are found at every place of
// the grid if that is more than the step; if less, at that part of the places, and otherwise neither.
TEST(Events, TwoZerosNearerThanAStepMayHide) {
  constexpr double step = 60.0, curvature = 2e-3;  // s, 1/s^2
  constexpr int places = 1000;
  for (const double apart : {1.001 * step, 0.999 * step, 0.25 * step, 1e-3 * step}) {
    const double d = curvature * apart * apart / 8.0;
    int found = 0;
    for (int k = 0; k < places; ++k) {
      const double top = 300.0 + step * (k + 0.5) / places;
      const auto pass = [&](const Epoch& t) { return d - 0.5 * curvature * std::pow(seconds(t) - top, 2); };
      const auto zeros = events(from_until(start, 600.0 * si::second), step * si::second, pass);
      ASSERT_TRUE(zeros.empty() || zeros.size() == 2U);
      if (zeros.empty()) continue;
      EXPECT_NEAR((zeros[1].epoch - zeros[0].epoch).value(), apart, 2.0 * found_to);
      ++found;
    }
    EXPECT_NEAR(found, places * std::min(1.0, apart / step), 1.0) << apart;
  }
  // Neither a cusp nor a tangent changes the sign, at an instant of the grid or between two.
  for (const double at : {300.0, 317.0}) {
    const auto cusp = [&](const Epoch& t) { return std::sqrt(std::abs(seconds(t) - at)); };
    const auto tangent = [&](const Epoch& t) { return -std::pow(seconds(t) - at, 2); };
    const auto ten_minutes = from_until(start, 600.0 * si::second);
    EXPECT_TRUE(events(ten_minutes, step * si::second, cusp).empty());
    EXPECT_TRUE(events(ten_minutes, step * si::second, tangent).empty());
  }
}

TEST(Events, AJumpIsFoundAsAZero) {
  constexpr double jump = 1000.0 / 3.0;
  const auto sign = [](const Epoch& t) { return seconds(t) < jump ? -1.0 : 1.0; };
  const auto found = events(day, 1000.0 * si::second, sign);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(seconds(found[0].epoch), jump, found_to);
}

TEST(Events, FewEvaluationsForASmoothFunction) {
  int evaluations = 0;
  const auto wave = [&](const Epoch& t) {
    ++evaluations;
    return std::cos(2 * pi * seconds(t) / 5400.0);
  };
  EXPECT_EQ(events(from_until(start, 2700.0 * si::second), 300.0 * si::second, wave).size(), 1U);
  EXPECT_LE(evaluations, 10 + 19);  // the grid, and half of what a bisection takes
}

TEST(Events, ToleranceAndLongSteps) {
  const auto line = [](const Epoch& t) { return std::atan((seconds(t) - 1e8 / 3.0) / 1e7); };
  const auto decade = from_until(start, 3e8 * si::second);
  const auto found = events(decade, 1e8 * si::second, line);
  ASSERT_EQ(found.size(), 1U);
  constexpr double rounding_of_a_step = 4 * 2.3e-16 * 1e8;  // s
  EXPECT_NEAR(seconds(found[0].epoch), 1e8 / 3.0, found_to + rounding_of_a_step);
  const auto roughly = events(decade, 1e8 * si::second, line, {.tolerance = 10.0 * si::second});
  EXPECT_NEAR(seconds(roughly.at(0).epoch), 1e8 / 3.0, 10.0);
  // A jump is nowhere zero, and seconds of a year have no digit at the tolerance.
  int evaluations = 0;
  const auto jump = [&](const Epoch& t) {
    ++evaluations;
    return std::copysign(1.0, line(t));
  };
  EXPECT_NEAR(seconds(events(decade, 1e8 * si::second, jump).at(0).epoch), 1e8 / 3.0,
              found_to + rounding_of_a_step);
  EXPECT_LE(evaluations, 4 + 4 * 54);  // the grid, and four for each halving down to one rounding
}

TEST(Events, AcrossALeapSecond) {
  const Epoch leap = Epoch::from_utc("2016-12-31T23:59:60.5");
  const auto found = events(from_until(leap - 100.0 * si::second, leap + 100.0 * si::second),
                            30.0 * si::second, [&](const Epoch& t) { return (t - leap).value(); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].epoch.utc(3), "2016-12-31T23:59:60.500");
}

TEST(Events, RefusesBadInput) {
  const auto line = [](const Epoch& t) { return seconds(t) - 3.0; };
  const auto minute = from_until(start, 60.0 * si::second);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([&] { events(minute, 0.0 * si::second, line); }), "events: the step is 0 s");
  EXPECT_EQ(complaint([&] { intervals(minute, nan * si::second, line); }), "intervals: the step is nan s");
  EXPECT_EQ(complaint([&] { events(minute, 1.0 * si::second, line, {.tolerance = 1e-11 * si::second}); }),
            "events: the tolerance is 1e-11 s; it has to be at least 1e-10 s");
  EXPECT_NO_THROW(events(minute, 1.0 * si::second, line, {.tolerance = 1e-10 * si::second}));
  EXPECT_THROW(events(minute, 1.0 * si::second, line, {.tolerance = nan * si::second}), BadInput);
  EXPECT_EQ(complaint([&] { events(minute, 10.0 * si::second, [](const Epoch&) { return nan; }); }),
            "events: the function is nan at 2023-04-20T05:00:00.000000 UTC");
  EXPECT_EQ(complaint([&] {
              events(minute, 10.0 * si::second, [](const Epoch& t) {
                return seconds(t) < 15.0 ? 1.0 : std::numeric_limits<double>::infinity();
              });
            }),
            "events: the function is inf at 2023-04-20T05:00:20.000000 UTC");
  // Only between two instants of the grid, where the zero is narrowed down.
  EXPECT_EQ(complaint([&] {
              events(minute, 10.0 * si::second, [&](const Epoch& t) {
                const double x = seconds(t) - 35.0;
                return std::abs(x) < 4.0 ? nan : x;
              });
            }).substr(0, 61),
            "events: the function is nan at 2023-04-20T05:00:35.000000 UTC");
  EXPECT_EQ(
      complaint([&] {
        events(minute, 10.0 * si::second, [](const Epoch& t) { return std::max(0.0, seconds(t) - 35.0); });
      }),
      "events: the function is 0 at 2023-04-20T05:00:00.000000 UTC and at 2023-04-20T05:00:10.000000 UTC; "
      "it has to change its sign at a zero");
  EXPECT_EQ(complaint([&] {
              events(minute, 10.0 * si::second, [](const Epoch&) -> double { throw BadInput("no data"); });
            }),
            "events: at 2023-04-20T05:00:00.000000 UTC: no data");
}

TEST(Events, KeepsWhatTheFunctionThrew) {
  try {
    intervals(day, 10.0 * si::second, [](const Epoch&) -> double { throw std::domain_error("lost"); });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "intervals: at 2023-04-20T05:00:00.000000 UTC: lost");
    EXPECT_THROW(std::rethrow_if_nested(error), std::domain_error);
  }
  try {
    events(day, 10.0 * si::second, [](const Epoch&) -> double { throw 3; });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "events: at 2023-04-20T05:00:00.000000 UTC: the function threw");
    EXPECT_THROW(std::rethrow_if_nested(error), int);
  }
}

}  // namespace
}  // namespace vectrix::events_test
