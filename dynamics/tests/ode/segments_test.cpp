#include <array>
#include <limits>

#include "problems.hpp"
#include "testing/free_body.hpp"

namespace vectrix::ode::test::segments_test {
namespace {

class OdeSegments : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeSegments, testing::ValuesIn(methods), name);

constexpr double on = 1.0, off = 3.0;

double pulse(double segment_start) {
  return segment_start >= on && segment_start < off ? 1.0 : 0.0;
}

/// x'' = 1 in [1, 3), else 0, from rest.
Problem pulsed(Method method) {
  Problem problem;
  problem.rhs = [](double segment_start, double, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = pulse(segment_start);
  };
  problem.initial_state = {0.0, 0.0};
  problem.start = 0.0;
  problem.end = 10.0;
  problem.breakpoints = {on, off};
  problem.method = method;
  set_tolerance(problem, 1e-12);
  return problem;
}

std::vector<double> pulsed_state(double t) {
  if (t < on) return {0.0, 0.0};
  if (t < off) return {0.5 * (t - on) * (t - on), t - on};
  return {2.0 + 2.0 * (t - off), 2.0};
}

/// Every method here integrates polynomials of degree 2 exactly, up to its starting order and rounding.
constexpr double exact_within = 1e-11;

TEST_P(OdeSegments, square_pulse_is_exact) {
  Problem problem = pulsed(GetParam());
  problem.output_times = {0.0, 0.5, on, 1.7, off, 5.0, 10.0};
  const Solution solution = solve(problem);
  EXPECT_LT(node_error(solution, pulsed_state), exact_within);
  ASSERT_EQ(solution.output_times().size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_LT(distance(solution.output(i), pulsed_state(problem.output_times[i])), exact_within);
    EXPECT_EQ(distance(solution.output(i), solution.at(problem.output_times[i])), 0.0);
  }
}

TEST_P(OdeSegments, breakpoint_is_a_node_of_both_segments) {
  const Solution solution = solve(pulsed(GetParam()));
  ASSERT_EQ(solution.segment_count(), 3U);
  for (std::size_t segment = 1; segment < 3; ++segment) {
    const Node after = solution.node(solution.segment_begin(segment));
    const Node before = solution.node(solution.segment_begin(segment) - 1);
    EXPECT_EQ(before.t, segment == 1 ? on : off);
    EXPECT_EQ(after.t, before.t);
    EXPECT_EQ(distance(after.y, before.y), 0.0);
    EXPECT_NEAR(before.ydot[1], segment == 1 ? 0.0 : 1.0, 1e-9);  // slope of a polynomial with CVODE
    EXPECT_EQ(after.ydot[1], segment == 1 ? 1.0 : 0.0);
  }
  EXPECT_EQ(solution.segment_begin(3), solution.node_count());
}

/// A body at rest for an hour, then a torque off its principal axes. The steps at rest grow without limit,
/// and one of that length overflows in the pulse: in its stages the rate is squared again and again.
Problem pushed_after_rest(Method method) {
  constexpr double rest = 3600.0, pulse_end = rest + 20.0;
  Problem problem;
  problem.rhs = [](double segment_start, double, State y, std::span<double> ydot) {
    constexpr std::array moments{1.0, 2.0, 3.0}, torque{0.5, -2.0, 3.0};
    EXPECT_TRUE(std::ranges::all_of(y, [](double number) { return std::isfinite(number); }));
    vectrix_test::free_body(moments, y.first<7>(), ydot.first<7>());
    for (std::size_t i = 0; i < 3; ++i)
      if (segment_start == rest) ydot[4 + i] += torque[i] / moments[i];
  };
  problem.initial_state = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  problem.start = 0.0;
  problem.end = pulse_end;
  problem.breakpoints = {rest};
  problem.method = method;
  set_tolerance(problem, 1e-10);
  return problem;
}

TEST_P(OdeSegments, a_step_carried_into_a_pulse_is_shortened_until_it_fits) {
  Problem problem = pushed_after_rest(GetParam());
  const Solution carried = solve(problem);
  problem.start = problem.breakpoints.front();
  const Solution fresh = solve(problem);
  // The first steps in the pulse differ, within the tolerance 1e-10 (1 + |w|), and |w| reaches 20.
  EXPECT_LT(distance(carried.at(problem.end), fresh.at(problem.end)), 2e-9);
}

class OdeSegmentsOfSundials : public OdeSegments {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeSegmentsOfSundials, testing::ValuesIn(sundials_methods), name);

TEST_P(OdeSegmentsOfSundials, have_the_nodes_of_dense_output) {
  const Solution solution = solve(pulsed(GetParam()));
  for (std::size_t segment = 0; segment < 3; ++segment) {
    EXPECT_GE(solution.segment_begin(segment + 1) - solution.segment_begin(segment), 6U);
  }
}

TEST_P(OdeSegments, times_given_to_the_right_hand_side_stay_in_the_segment) {
  Problem problem = oscillator(GetParam(), 40.0, 1e-9);
  problem.start = 0.1;
  for (int i = 1; i < 100; ++i) problem.breakpoints.push_back(0.1 + 0.3 * i);
  std::size_t calls = 0;
  const auto rhs = problem.rhs;
  problem.rhs = [&](double segment_start, double t, State y, std::span<double> ydot) {
    const auto end = std::ranges::upper_bound(problem.breakpoints, segment_start);
    EXPECT_GE(t, segment_start);
    EXPECT_LE(t, end == problem.breakpoints.end() ? problem.end : *end);
    ++calls;
    rhs(segment_start, t, y, ydot);
  };
  EXPECT_EQ(solve(problem).statistics().rhs_evaluations, calls);
}

TEST_P(OdeSegments, breakpoints_outside_the_span_have_no_effect) {
  Problem problem = oscillator(GetParam(), 5.0, 1e-9);
  const Solution plain = solve(problem);
  problem.breakpoints = {-1.0, 0.0, 5.0, 7.0};
  const Solution same = solve(problem);
  ASSERT_EQ(same.node_count(), plain.node_count());
  EXPECT_EQ(same.segment_count(), 1U);
  EXPECT_EQ(distance(same.at(5.0), plain.at(5.0)), 0.0);
}

TEST_P(OdeSegments, segments_within_the_rounding_of_time) {
  Problem problem = oscillator(GetParam(), 3.0, 1e-11);
  const double next = std::nextafter(1.5, 2.0);
  problem.breakpoints = {1.5, next, next + 1e-14};
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.segment_count(), 4U);
  EXPECT_LT(node_error(solution, oscillator_state), 1e-7);  // as without breakpoints; BDF is worst
}

TEST_P(OdeSegments, a_start_far_from_zero) {
  Problem problem = pulsed(GetParam());
  constexpr double epoch = 8e8;  // s, for example since J2000: there times are rounded to 1.2e-7 s
  problem.start += epoch;
  problem.end += epoch;
  problem.breakpoints = {epoch + on, epoch + off};
  problem.rhs = [](double segment_start, double, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = pulse(segment_start - epoch);
  };
  const Solution solution = solve(problem);
  EXPECT_LT(distance(solution.at(problem.end), pulsed_state(10.0)), 1e-6);  // ten times the rounding of time
}

TEST_P(OdeSegments, a_start_so_far_that_most_steps_are_within_the_rounding_of_time) {
  Problem problem = oscillator(GetParam(), 10.0, 1e-10);
  constexpr double epoch = 1e15;  // there times are multiples of 1/8
  problem.start = epoch;
  problem.end = epoch + 10.0;
  const Solution solution = solve(problem);
  EXPECT_LT(distance(solution.at(problem.end), oscillator_state(10.0)),
            1e-6);  // SUNDIALS does not see the epoch
  EXPECT_LE(solution.node_count(), 81U);
}

}  // namespace
}  // namespace vectrix::ode::test::segments_test
