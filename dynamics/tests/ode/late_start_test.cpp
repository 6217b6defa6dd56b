#include <vectrix/frames/errors.hpp>

#include "problems.hpp"
#include "testing/trials.hpp"

namespace vectrix::ode::test::late_start_test {
namespace {

/// Seconds since 1970, Julian seconds, and before zero.
constexpr double starts[] = {1.7e9, 2.1e11, -1.7e9, -2.1e11};

/// Accumulated over 64 rad at a tolerance of 1e-12, as from a start at 0: the methods of many steps take
/// more and shorter ones. A time that is rounded to the precision of the start would cost 1e-7 to 1e-5.
double accumulated(Method method) {
  return method == Method::cvode_adams || method == Method::cvode_bdf ? 5e-8 : 5e-10;
}

Problem late(Method method, double start) {
  Problem problem = oscillator(method, 64.0, 1e-12);
  problem.start = start;
  problem.end = start + 64.0;
  return problem;
}

class LateStart : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, LateStart, testing::ValuesIn(methods), name);

TEST_P(LateStart, loses_no_digits_between_the_nodes) {
  for (const double start : vectrix_test::tried(starts)) {
    Problem problem = late(GetParam(), start);
    problem.breakpoints = {start + 10.25, start + 40.5};
    const Solution solution = solve(problem);
    double largest = 0.0;
    for (double s = 0.0; s <= 64.0; s += 0.125)
      largest = vectrix::detail::larger(largest, distance(solution.at(start + s), oscillator_state(s)));
    EXPECT_LE(largest, accumulated(GetParam())) << start;
  }
}

TEST_P(LateStart, gives_events_at_the_rounded_time_and_after_the_change_of_sign) {
  for (const double start : vectrix_test::tried(starts)) {
    Problem problem = late(GetParam(), start);
    problem.roots = {{"x", [](double, State y) { return y[0]; }, Direction::any, false},
                     {"third", [](double, State y) { return y[1] - 0.5; }, Direction::rising, false}};
    const Solution solution = solve(problem);
    ASSERT_EQ(solution.events().size(), 20U + 10U);
    const double spacing = std::nextafter(std::abs(start), 1e300) - std::abs(start);
    for (const Event& event : solution.events()) {
      const double value = event.root == 0 ? event.state[0] : event.state[1] - 0.5;
      EXPECT_TRUE(event.direction == Direction::rising ? value >= 0.0 : value <= 0.0) << value;
      EXPECT_LE(std::abs(value), spacing + 1e-14);
      EXPECT_EQ(solution.at(event.time), event.state);
    }
    problem.roots[0].stop = true;
    const Solution stopped = solve(problem);
    EXPECT_EQ(stopped.end(), stopped.events().back().time);
    EXPECT_NEAR(stopped.end() - start, std::numbers::pi / 2, spacing + 1e-10);
    EXPECT_EQ(stopped.at(stopped.end()), stopped.events().back().state);
    EXPECT_LE(distance(stopped.at(start + 1.5), oscillator_state(1.5)), accumulated(GetParam()));
  }
}

// Of dense output that was not kept, at the rounded time of a node: the polynomial through six nodes. The
// distance d to that node is half the spacing of times, 1.5e-5 s at most, and the error is below
//     d^2 (1 1 2 2 3)^2 h^10 / 12!,  h the length of a step, less than 1.76 s.
constexpr double next_to_a_node = 2e-14;

// The state at the rounded time of a node may lie in the step before it or in the one after.
TEST_P(LateStart, without_dense_output_has_outputs_and_events_at_the_times_of_nodes) {
  for (const double start : vectrix_test::tried(starts)) {
    Problem problem = late(GetParam(), start);
    problem.breakpoints = {start + 10.25};
    const Solution nodes = solve(problem);
    for (std::size_t i = 0; i < nodes.node_count(); i += 3) {
      const Node node = nodes.node(i);
      if (problem.output_times.empty() || problem.output_times.back() < node.t)
        problem.output_times.push_back(node.t);
      if (problem.roots.size() == 20) continue;
      problem.roots.push_back({"node", [x = node.y[0]](double, State y) { return y[0] - x; }});
    }
    const Solution dense = solve(problem);
    problem.dense_output = false;
    const Solution sparse = solve(problem);
    ASSERT_EQ(sparse.output_times().size(), problem.output_times.size());
    for (std::size_t i = 0; i < problem.output_times.size(); ++i)
      EXPECT_EQ(distance(sparse.output(i), dense.output(i)), 0.0);
    ASSERT_EQ(sparse.events().size(), dense.events().size());
    for (std::size_t i = 0; i < dense.events().size(); ++i) {
      EXPECT_EQ(sparse.events()[i].time, dense.events()[i].time);
      EXPECT_LE(distance(sparse.events()[i].state, dense.events()[i].state), next_to_a_node);
      EXPECT_EQ(sparse.at(sparse.events()[i].time), sparse.events()[i].state);
    }
    for (std::size_t i = 0; i < sparse.node_count(); ++i) {
      const double t = sparse.node(i).t;
      EXPECT_LE(distance(sparse.at(t), dense.at(t)), next_to_a_node);
    }
  }
}

// Steps shorter than the rounding of time, 1.2e-7 s: each double between has a state.
TEST_P(LateStart, without_dense_output_has_outputs_at_all_times_within_short_steps) {
  constexpr double rate = 1e7, start = 1e9;  // rad/s, s
  Problem problem = oscillator(GetParam(), 1.0, 1e-9);
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    ydot[0] = rate * y[1];
    ydot[1] = -rate * y[0];
  };
  problem.start = start;
  for (double t = start; problem.output_times.size() < 20; t = std::nextafter(t, 2.0 * start))
    problem.output_times.push_back(t);
  problem.end = problem.output_times.back();
  problem.dense_output = false;
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.output_times().size(), 20U);
  // An interval of several steps ends with the step after which the rounded time is another: it is shorter
  // than two roundings, 2.4 rad. Within it the state is the cubic through its ends.
  const double h = 2.0 * rate * (std::nextafter(start, 2.0 * start) - start);
  for (std::size_t i = 0; i < 20; ++i) {
    const double phase = rate * (problem.output_times[i] - start);
    EXPECT_LE(distance(solution.output(i), oscillator_state(phase)), std::pow(h, 4) / 384.0) << i;
  }
}

// A segment that is short beside the time zero: its nodes and steps count from its own start.
TEST_P(LateStart, resolves_short_segments_far_from_the_start) {
  Problem problem = oscillator(GetParam(), 1.0, 1e-9);
  problem.start = -1e9;
  problem.rhs = [](double segment_start, double t, State, std::span<double> ydot) {
    ydot[0] = segment_start == 1e-8 ? 1e8 : 0.0;
    ydot[1] = t > 0.0 ? 1.0 : 0.0;
  };
  problem.breakpoints = {1e-8, 2e-8};
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.segment_count(), 3U);
  EXPECT_NEAR(solution.at(1.5e-8)[0], 1.5, 1e-6);
  EXPECT_NEAR(solution.at(1.0)[0], 2.0, 1e-6);
}

}  // namespace
}  // namespace vectrix::ode::test::late_start_test
