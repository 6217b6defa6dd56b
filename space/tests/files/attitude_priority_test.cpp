#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "files/attitude_kernels.hpp"

// Of segments that know one instant the last in the file counts: in the samples as in the attitude.
namespace vectrix::attitude_kernel_test {
namespace {

const auto the_body = called<Body>("-77001");

// Ticks, with a bar before each sample that begins an interval.
std::string samples_of(const AttitudeKernel& kernel) {
  const auto samples = kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), the_body);
  const auto starts = kernel.interval_starts(of<Body>, relative_to<Gcrf>, kernel.span(), the_body);
  std::string text;
  for (const auto& sample : samples) {
    if (std::find(starts.begin(), starts.end(), sample.time) != starts.end()) text += "| ";
    text += std::to_string(std::lround((sample.time - at_ticks(0.0)).value() * 100.0)) + " ";
  }
  return text;
}
std::string hidden_in(const AttitudeKernel& kernel) {
  std::string text;
  for (const auto& [segment, span] : kernel.hidden(of<Body>, relative_to<Gcrf>, kernel.span(), the_body))
    text += std::to_string(segment) + ": " +
            std::to_string(std::lround((span.start() - at_ticks(0.0)).value() * 100.0)) + " to " +
            std::to_string(std::lround((span.end() - at_ticks(0.0)).value() * 100.0)) + "; ";
  return text;
}
DafTestArray other(const std::vector<double>& ticks, const std::vector<double>& intervals) {
  return steady_segment("OTHER", ticks, true, intervals, 1.0, 3.0);  // three seconds ahead
}
DafTestArray rotating(double start, double stop, double offset) {
  std::vector<double> numbers;
  add(numbers, steady(start / 100.0 + offset), 1.0, true);
  numbers.insert(numbers.end(), {0.01, start, stop});
  return segment("TYPE 2", 2, true, numbers, start, stop);
}

TEST(AttitudePriority, TakesTheSamplesOfTheLastSegmentThatCovers) {
  const auto wide = steady_segment("WIDE", ticks_from(0.0, 100.0, 9), true, {0.0});
  const auto narrow = other({200.0, 250.0, 400.0, 420.0, 440.0}, {200.0, 400.0});
  const auto kernel = written({wide, narrow});
  EXPECT_EQ(samples_of(kernel), "| 0 100 | 200 250 | 300 | 400 420 440 | 500 600 700 800 ");
  EXPECT_EQ(hidden_in(kernel), "0: 200 to 250; 0: 400 to 440; ");
  const auto reverse = written({narrow, wide});
  EXPECT_EQ(samples_of(reverse), "| 0 100 200 300 400 500 600 700 800 ");
  EXPECT_EQ(hidden_in(reverse), "0: 200 to 250; 0: 400 to 440; ");
}

TEST(AttitudePriority, GoesOnInAnotherSegmentOnlyWithTheSameAttitude) {
  const auto first = steady_segment("FIRST", ticks_from(0.0, 100.0, 4), true, {0.0});
  const auto same = [](double from) { return steady_segment("S", ticks_from(from, 100.0, 4), true, {from}); };
  for (const double from : {200.0, 300.0}) {  // with a step that both have, and without
    EXPECT_EQ(samples_of(written({first, same(from)})).find('|', 1), std::string::npos) << from;
    EXPECT_EQ(samples_of(written({same(from), first})).find('|', 1), std::string::npos) << from;
  }
  EXPECT_EQ(samples_of(written({first, same(250.0)})), "| 0 100 200 250 350 450 550 ");
  EXPECT_EQ(samples_of(written({first, same(400.0)})), "| 0 100 200 300 | 400 500 600 700 ");
  EXPECT_EQ(samples_of(written({first, other({300.0, 400.0}, {300.0})})), "| 0 100 200 | 300 400 ");
  EXPECT_EQ(hidden_in(written({first, same(300.0)})), "");
  EXPECT_EQ(hidden_in(written({first, same(200.0)})), "0: 200 to 300; ");
}

TEST(AttitudePriority, HidesAlsoWhereTheSummaryLeavesNoRecord) {
  auto narrow = other({200.0, 400.0}, {200.0});
  narrow.doubles = {250.0, 350.0};
  EXPECT_EQ(samples_of(written({steady_segment("WIDE", {0.0, 100.0, 500.0}, true, {0.0}), narrow})),
            "| 0 100 | 500 ");
}

TEST(AttitudePriority, TakesType1FromItsFirstRecordToItsLast) {
  const auto wide = steady_segment("WIDE", ticks_from(0.0, 100.0, 7), true, {});
  const auto kernel = written({wide, other({250.0, 350.0, 450.0}, {})});
  EXPECT_EQ(samples_of(kernel), "0 100 200 | 250 350 450 | 500 600 ");
  EXPECT_EQ(hidden_in(kernel), "0: 250 to 450; ");
  EXPECT_EQ(samples_of(written({wide, other({700.0, 800.0}, {})})), "0 100 200 300 400 500 600 700 800 ");
}

TEST(AttitudePriority, CutsARotationOfType2) {
  const auto inside = steady_segment("INSIDE", {300.0, 400.0}, true, {300.0});
  EXPECT_EQ(samples_of(written({rotating(0.0, 1000.0, 3.0), inside})), "| 0 | 300 400 | 1000 ");
  EXPECT_EQ(samples_of(written({rotating(0.0, 1000.0, 0.0), inside})), "| 0 300 400 1000 ");
  EXPECT_EQ(samples_of(written({inside, rotating(0.0, 1000.0, 0.0)})), "| 0 1000 ");
}

// A sample is the attitude at its instant, and the shortest turn of a step the attitude between.
TEST(AttitudePriority, AgreesWithTheAttitude) {
  std::mt19937 random(20261130);
  const auto one_of = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int steps = 0, begins = 0;
  for (int file = 0; file < 60; ++file) {
    std::vector<DafTestArray> segments;
    for (int n = 2 + one_of(3); n > 0; --n) {
      std::vector<double> ticks{50.0 * one_of(20)}, intervals{ticks[0]};
      for (int i = 1 + one_of(8); i > 0; --i) {
        ticks.push_back(ticks.back() + 50.0 * (1 + one_of(3)));
        if (one_of(4) == 0 && i > 1) intervals.push_back(ticks.back());
      }
      segments.push_back(steady_segment("S", ticks, true, intervals, 1.0, one_of(2) == 0 ? 0.0 : 3.0));
      if (one_of(4) == 0) segments.back() = rotating(ticks.front(), ticks.back(), 3.0);
    }
    const auto kernel = written(segments);
    const auto samples = kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), the_body);
    const auto starts = kernel.interval_starts(of<Body>, relative_to<Gcrf>, kernel.span(), the_body);
    const auto attitude = attitude_of(kernel);
    const auto difference = [&](const Epoch& t, const Eigen::Quaterniond& q_a_from_b) {
      return Eigen::Quaterniond(attitude(t).rotation.matrix()).angularDistance(q_a_from_b);
    };
    constexpr double tolerance = 1e-7;  // rad, of an angle by its cosine
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const auto &before = samples[i - 1], &now = samples[i];
      ASSERT_LT(before.time, now.time);
      if (std::find(starts.begin(), starts.end(), now.time) != starts.end()) {
        ++begins;
        continue;
      }
      ++steps;
      const Eigen::Quaterniond q = before.q_a_from_b.eigen(), next = now.q_a_from_b.eigen();
      EXPECT_LT(difference(before.time, q), tolerance) << file << ", " << i;
      EXPECT_LT(difference(before.time + 0.5 * (now.time - before.time), q.slerp(0.5, next)), tolerance)
          << file << ", " << i << "\n"
          << samples_of(kernel);
    }
  }
  EXPECT_GT(steps, 150);
  EXPECT_GT(begins, 60);
}

}  // namespace
}  // namespace vectrix::attitude_kernel_test
