#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "files/attitude_kernels.hpp"

// What the types of segments say between their records.
namespace vectrix::attitude_kernel_test {
namespace {

TEST(AttitudeKernel, Type3TurnsEvenlyBetweenItsRecords) {
  const auto ticks = ticks_from(1000.0, 250.0, 400);  // with directories of its ticks
  for (const bool big : {false, true}) {
    for (const double norm : {1.0, 2.0e9, 1e-9, -3.0}) {
      const auto attitude = attitude_of(written({steady_segment("S", ticks, true, {1000.0}, norm)}, big));
      for (const double t : {1000.0, 1000.1, 1124.9, 1250.0, 50000.0, 100749.9, 100750.0})
        expect_steady(attitude, t);
      EXPECT_THROW(attitude(at_ticks(999.99)), BadInput);
      EXPECT_THROW(attitude(at_ticks(100750.01)), BadInput);
    }
  }
}

TEST(AttitudeKernel, Type3StopsAtTheEndOfAnInterval) {
  std::vector<double> ticks = ticks_from(0.0, 100.0, 5);  // to 400
  const auto second = ticks_from(500.0, 100.0, 5);        // from 500: one step behind, and not across it
  ticks.insert(ticks.end(), second.begin(), second.end());
  const auto kernel = written({steady_segment("S", ticks, true, {0.0, 500.0})});
  const auto attitude = attitude_of(kernel);
  for (const double t : {0.0, 399.9, 400.0, 500.0, 500.1, 900.0}) expect_steady(attitude, t);
  for (const double t : {400.1, 450.0, 499.9}) EXPECT_THROW(attitude(at_ticks(t)), BadInput) << t;
  const auto starts =
      kernel.interval_starts(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"));
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_EQ(starts[0], kernel.span().start());
  EXPECT_NEAR((starts[1] - at_ticks(500.0)).value(), 0.0, clock_rounding);
  // Read in parts, it stops there, too.
  for (const double from : {150.0, 350.0, 400.0, 450.0}) {
    const auto part = kernel.attitude(of<Body>, relative_to<Gcrf>,
                                      from_until(at_ticks(from), at_ticks(650.0)), called<Body>("-77001"));
    EXPECT_THROW(part(at_ticks(450.0)), BadInput) << from;
    expect_steady(part, 600.0);
  }
  const auto one = written({steady_segment("S", ticks, true, {0.0})});
  expect_steady(attitude_of(one), 450.0);
}

TEST(AttitudeKernel, Type3SaysWhereARecordIsAlone) {
  const auto kernel =
      written({steady_segment("S", {0.0, 100.0, 200.0, 300.0, 400.0}, true, {0.0, 200.0, 300.0})});
  const auto attitude = attitude_of(kernel);
  const auto at = [&](double ticks) {
    return complaint([&] { static_cast<void>(attitude(at_ticks(ticks))); });
  };
  EXPECT_NE(at(200.0).find(
                "segment 1 'S': the record of 2000-01-01T11:58:57.816000 UTC, 200 ticks, is alone in its "
                "interval, and nothing says how it turns; samples() has it"),
            std::string::npos)
      << at(200.0);
  for (const double ticks : {199.0, 201.0, 299.0})
    EXPECT_NE(at(ticks).find("is outside the intervals"), std::string::npos) << ticks;
  expect_steady(attitude, 300.0);
  EXPECT_EQ(kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001")).size(), 5U);
}

TEST(AttitudeKernel, Type3MayHaveNoRates) {
  const auto kernel = written({steady_segment("S", ticks_from(0.0, 100.0, 5), false, {0.0})});
  const auto attitude = attitude_of(kernel);
  const auto now = attitude(at_ticks(150.0));
  EXPECT_LT((inverse(now.rotation).matrix() - steady(1.5).q.toRotationMatrix()).norm(), clock_rounding);
  EXPECT_THROW(static_cast<void>(attitude.recorded_rate(at_ticks(150.0))), BadInput);
  EXPECT_THROW(static_cast<void>(
                   kernel.recorded_rates(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"))),
               BadInput);
}

TEST(AttitudeKernel, Type2TurnsAtTheRateOfItsRecord) {
  for (const std::size_t count : {1U, 2U, 100U, 101U, 250U}) {
    std::vector<double> numbers, starts, stops;
    for (std::size_t i = 0; i < count; ++i) {
      const double start = 1000.0 * static_cast<double>(i);
      add(numbers, steady(start / 100.0), 5.0, true);
      numbers.push_back(0.01);  // seconds per tick
      starts.push_back(start);
      stops.push_back(start + 900.0);
    }
    numbers.insert(numbers.end(), starts.begin(), starts.end());
    numbers.insert(numbers.end(), stops.begin(), stops.end());
    add_directory(numbers, starts);
    for (const bool big : {false, true}) {
      const auto attitude = attitude_of(written({segment("S", 2, true, numbers, 0.0, stops.back())}, big));
      for (const double t : {0.0, 1.0, 450.0, 900.0, stops.back() - 450.0, stops.back()})
        expect_steady(attitude, t);
      if (count > 1) {
        EXPECT_THROW(attitude(at_ticks(950.0)), BadInput);
        expect_steady(attitude, 1500.0);
      }
    }
  }
}

// Three intervals: the second goes on where the first ends, and before the third is a gap.
TEST(AttitudeKernel, Type2HasSamplesOfEachInterval) {
  const std::vector<double> starts{0.0, 1000.0, 3000.0}, stops{1000.0, 2000.0, 9000.0};
  std::vector<double> numbers;
  for (const double start : starts) {
    add(numbers, steady(start / 100.0), 5.0, true);
    numbers.push_back(0.01);  // seconds per tick
  }
  numbers.insert(numbers.end(), starts.begin(), starts.end());
  numbers.insert(numbers.end(), stops.begin(), stops.end());
  const auto kernel = written({segment("S", 2, true, numbers, 0.0, 9000.0)});
  const auto body = called<Body>("-77001");
  const auto samples = kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), body);
  const auto rates = kernel.recorded_rates(of<Body>, relative_to<Gcrf>, kernel.span(), body);
  // In 60 s it turns by 3.7 rad: three steps of less than a quarter of a turn.
  const std::vector<double> expected{0.0, 1000.0, 2000.0, 3000.0, 5000.0, 7000.0, 9000.0};
  ASSERT_EQ(samples.size(), expected.size());
  ASSERT_EQ(rates.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR((samples[i].time - at_ticks(expected[i])).value(), 0.0, 1e-9);
    EXPECT_LT((samples[i].q_a_from_b.eigen().conjugate().toRotationMatrix() -
               steady(expected[i] / 100.0).q.toRotationMatrix())
                  .norm(),
              clock_rounding)
        << expected[i];
    EXPECT_EQ(rates[i].coordinates(), w);
  }
  const auto begins = kernel.interval_starts(of<Body>, relative_to<Gcrf>, kernel.span(), body);
  ASSERT_EQ(begins.size(), 2U);
  EXPECT_EQ(begins[0], samples[0].time);
  EXPECT_EQ(begins[1], samples[3].time);
  EXPECT_EQ(
      kernel.samples(of<Body>, relative_to<Gcrf>, from_until(at_ticks(900.0), at_ticks(3500.0)), body).size(),
      3U);
}

TEST(AttitudeKernel, Type2RefusesSamplesOfTurnsWithoutEnd) {
  std::vector<double> numbers;
  Turn fast = steady(0.0);
  fast.w = {0.0, 0.0, 1e6};
  add(numbers, fast, 1.0, true);
  numbers.insert(numbers.end(), {0.01, 0.0, 9000.0});
  const auto kernel = written({segment("S", 2, true, numbers, 0.0, 9000.0)});
  EXPECT_NE(
      complaint([&] {
        static_cast<void>(kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001")));
      }).find("turns at one rate; attitude() has them"),
      std::string::npos);
}

TEST(AttitudeKernel, Type1HasSingleAttitudes) {
  for (const bool rates : {false, true}) {
    const auto ticks = ticks_from(0.0, 100.0, 301);
    const auto kernel = written({steady_segment("S", ticks, rates, {})});
    const auto body = called<Body>("-77001");
    const auto samples = kernel.samples(of<Body>, relative_to<Gcrf>, kernel.span(), body);
    ASSERT_EQ(samples.size(), ticks.size());
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_NEAR((samples[i].time - at_ticks(ticks[i])).value(), 0.0, clock_rounding);
      EXPECT_LT(samples[i].q_a_from_b.eigen().conjugate().angularDistance(steady(ticks[i] / 100.0).q),
                clock_rounding);
    }
    EXPECT_EQ(kernel.samples(of<Body>, relative_to<Gcrf>, from_until(at_ticks(150.0), at_ticks(400.0)), body)
                  .size(),
              3U);
    const auto nearest =
        kernel.nearest_sample(of<Body>, relative_to<Gcrf>, at_ticks(1234.0), 0.5 * si::second, body);
    EXPECT_NEAR((nearest.time - at_ticks(1200.0)).value(), 0.0, clock_rounding);
    const std::string text = complaint([&] { static_cast<void>(attitude_of(kernel)); });
    EXPECT_NE(text.find("segment 1 'S': type 1 has single attitudes and nothing between them"),
              std::string::npos)
        << text;
  }
}

TEST(AttitudeKernel, TheLastSegmentThatKnowsAnInstantCounts) {
  const auto wide = steady_segment("WIDE", ticks_from(0.0, 100.0, 21), true, {0.0});
  // Three seconds ahead, with a gap from 900 to 1000.
  auto ticks = ticks_from(800.0, 50.0, 3);
  const auto more = ticks_from(1000.0, 50.0, 3);
  ticks.insert(ticks.end(), more.begin(), more.end());
  const auto narrow = steady_segment("NARROW", ticks, true, {800.0, 1000.0}, 1.0, 3.0);
  const auto first_body = [](const DafTestArray& first, const DafTestArray& second, double t) {
    const auto now = attitude_of(written({first, second}))(at_ticks(t));
    return Eigen::Quaterniond(inverse(now.rotation).matrix());
  };
  for (const double t : {700.0, 850.0, 950.0, 1050.0, 1500.0}) {
    const bool is_narrow = t == 850.0 || t == 1050.0;
    EXPECT_LT(first_body(wide, narrow, t).angularDistance(steady(t / 100.0 + (is_narrow ? 3.0 : 0.0)).q),
              1e-7)
        << t;
    EXPECT_LT(first_body(narrow, wide, t).angularDistance(steady(t / 100.0).q), 1e-7) << t;
  }
}

}  // namespace
}  // namespace vectrix::attitude_kernel_test
