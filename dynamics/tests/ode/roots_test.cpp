#include <limits>

#include <vectrix/frames/errors.hpp>

#include "problems.hpp"

namespace vectrix::ode::test::roots_test {
namespace {

class OdeRoots : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeRoots, testing::ValuesIn(methods), name);

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-12;
constexpr double end = 100.0;  // 31 zeros of the sine after 0

/// Time error of a zero: error of the state divided by its rate, which is 1 at a zero of the sine.
double time_error(Method method) {
  return method == Method::cvode_bdf ? 1e-7 : 1e-8;
}

Root sine(Direction direction = Direction::any, bool stop = false) {
  return {"sine", [](double, State y) { return -y[1]; }, direction, stop};
}

TEST_P(OdeRoots, all_zeros_are_found_once_and_in_order) {
  Problem problem = oscillator(GetParam(), end, tolerance);
  problem.roots = {sine()};
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 31U);  // the zero at the start does not count
  for (std::size_t i = 0; i < 31; ++i) {
    const Event& event = solution.events()[i];
    EXPECT_NEAR(event.time, static_cast<double>(i + 1) * pi, time_error(GetParam()));
    EXPECT_EQ(event.direction, i % 2 == 0 ? Direction::falling : Direction::rising);
    EXPECT_EQ(event.name, "sine");
    EXPECT_EQ(event.root, 0U);
    EXPECT_EQ(distance(event.state, solution.at(event.time)), 0.0);
    EXPECT_LT(std::abs(event.state[1]), 1e-13);  // zero of the dense output itself, to the rounding of time
    const double value = problem.roots[0].function(event.time, event.state);  // has its new sign, or is 0
    EXPECT_TRUE(event.direction == Direction::rising ? value >= 0.0 : value <= 0.0);
  }
  EXPECT_FALSE(solution.stopped());
}

TEST_P(OdeRoots, direction_is_respected) {
  Problem problem = oscillator(GetParam(), end, tolerance);
  problem.roots = {sine(Direction::rising), sine(Direction::falling)};
  const Solution solution = solve(problem);
  EXPECT_EQ(std::ranges::count(solution.events(), 0U, &Event::root), 15);
  EXPECT_EQ(std::ranges::count(solution.events(), 1U, &Event::root), 16);
  for (const Event& event : solution.events()) {
    EXPECT_EQ(event.direction, event.root == 0 ? Direction::rising : Direction::falling);
  }
}

TEST_P(OdeRoots, a_function_of_time_is_located_to_rounding) {
  Problem problem = oscillator(GetParam(), end, 1e-6);
  problem.maximum_step = 0.2;  // shorter than the distance of the zeros, so that none is missed
  problem.roots = {{"fast", [](double t, State) { return std::sin(10.0 * t); }}};
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 318U);  // floor(1000 / pi)
  for (std::size_t i = 0; i < 318; ++i) {
    const double exact = static_cast<double>(i + 1) * pi / 10.0;
    EXPECT_NEAR(solution.events()[i].time, exact, 4.0 * std::numeric_limits<double>::epsilon() * exact);
  }
}

TEST_P(OdeRoots, a_zero_at_a_breakpoint_or_at_the_end_is_found_once) {
  Problem problem = oscillator(GetParam(), 4.0, 1e-8);
  problem.breakpoints = {2.5};
  problem.roots = {{"breakpoint", [](double t, State) { return t - 2.5; }},
                   {"end", [](double t, State) { return 4.0 - t; }}};
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 2U);
  EXPECT_EQ(solution.events()[0].time, 2.5);
  EXPECT_EQ(solution.events()[0].direction, Direction::rising);
  EXPECT_EQ(solution.events()[1].time, 4.0);
  EXPECT_EQ(solution.events()[1].direction, Direction::falling);
}

TEST_P(OdeRoots, a_stop_ends_the_solution) {
  Problem problem = oscillator(GetParam(), end, tolerance);
  problem.output_times = {1.0, 5.0, 9.0, 50.0};
  problem.roots = {sine(),
                   {"late", [](double t, State) { return t - 50.0; }, Direction::any, true},
                   sine(Direction::rising, true)};
  const Solution solution = solve(problem);
  EXPECT_TRUE(solution.stopped());
  EXPECT_NEAR(solution.end(), 2.0 * pi, time_error(GetParam()));
  ASSERT_EQ(solution.events().size(), 3U);  // sine at pi and 2 pi, and the stop
  const Event& last = solution.events().back();
  EXPECT_EQ(last.root, 2U);
  EXPECT_EQ(last.time, solution.end());
  const Node node = solution.node(solution.node_count() - 1);
  EXPECT_EQ(node.t, last.time);
  EXPECT_EQ(distance(node.y, last.state), 0.0);
  for (std::size_t i = 1; i < solution.node_count(); ++i)
    ASSERT_LT(solution.node(i - 1).t, solution.node(i).t);
  EXPECT_EQ(solution.output_times().size(), 2U);
  EXPECT_THROW((void)solution.at(7.0), BadInput);
  EXPECT_LT(node_error(solution, oscillator_state), time_error(GetParam()));
  for (double t = 0.0; t < solution.end(); t += 0.01) {  // dense output until the stop
    ASSERT_LT(distance(solution.at(t), oscillator_state(t)), time_error(GetParam()));
  }
}

TEST_P(OdeRoots, a_stop_soon_after_the_start_is_as_accurate) {
  // There are few nodes before the root and none after it, so the step that passed it must be repeated.
  for (int i = 1; i <= 50; ++i) {
    const double exact = 0.02 * i;
    Problem problem = oscillator(GetParam(), end, tolerance);
    problem.roots = {{"soon", [&](double, State y) { return y[1] + std::sin(exact); }, Direction::any, true}};
    const double found = solve(problem).end();
    ASSERT_NEAR(found, exact,
                (GetParam() == Method::cvode_bdf ? 1e4 : 200.0) * tolerance);  // as at the nodes there
  }
}

TEST_P(OdeRoots, a_stop_never_asks_for_the_rate_beyond_the_step_that_passed_it) {
  Problem problem = oscillator(GetParam(), end, 1e-6);
  problem.maximum_step = 0.1;
  const auto rhs = problem.rhs;
  double latest = 0.0;
  problem.rhs = [&](double segment_start, double t, State y, std::span<double> ydot) {
    latest = std::max(latest, t);
    rhs(segment_start, t, y, ydot);
  };
  problem.roots = {{"stop", [](double t, State) { return t - 3.33; }, Direction::any, true}};
  const Solution solution = solve(problem);
  EXPECT_DOUBLE_EQ(solution.end(), 3.33);
  EXPECT_LE(latest, 3.33 + problem.maximum_step);
}

TEST_P(OdeRoots, of_two_stops_in_one_step_the_earlier_counts) {
  Problem problem = oscillator(GetParam(), 10.0, 1e-6);
  problem.roots = {{"second", [](double t, State) { return t - 1.0001; }, Direction::any, true},
                   {"first", [](double t, State) { return t - 1.0; }, Direction::any, true}};
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 1U);
  EXPECT_EQ(solution.events()[0].name, "first");
  EXPECT_DOUBLE_EQ(solution.end(), 1.0);
}

TEST_P(OdeRoots, the_stop_is_the_last_of_simultaneous_events) {
  Problem problem = oscillator(GetParam(), 10.0, 1e-6);
  problem.roots = {sine(Direction::any, true), sine()};
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 2U);
  EXPECT_EQ(solution.events().back().root, 0U);
  EXPECT_EQ(solution.events()[0].time, solution.events()[1].time);
}

TEST(OdeRootAccuracy, fehlberg_8_locates_zeros_within_a_few_tolerances) {
  // ARKODE's own cubic interpolant has an error of 1e-9 here.
  Problem problem = oscillator(Method::arkode_fehlberg_8, 10.0, 1e-13);
  problem.roots = {sine()};
  const auto events = solve(problem).events();
  ASSERT_EQ(events.size(), 3U);
  for (std::size_t i = 0; i < events.size(); ++i)
    EXPECT_NEAR(events[i].time, static_cast<double>(i + 1) * pi, 1e-12);  // ten tolerances
}

}  // namespace
}  // namespace vectrix::ode::test::roots_test
