#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <vectrix/dynamics/ode/inlined.hpp>
#include <vectrix/frames/errors.hpp>

#include "problems.hpp"

// The inlined integrators in solve<N>().
namespace vectrix::ode::test::inlined_solve_test {
namespace {

class InlinedSolve : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, InlinedSolve, testing::ValuesIn(inlined_methods), name);

constexpr auto oscillator_rates = [](double, double, std::span<const double, 2> y,
                                     std::span<double, 2> ydot) {
  ydot[0] = y[1];
  ydot[1] = -y[0];
};

TEST_P(InlinedSolve, is_solve_with_another_call) {
  Problem problem = oscillator(GetParam(), 50.0, 1e-11);
  problem.breakpoints = {10.0, 10.1, 10.2};
  problem.output_times = {3.3, 10.1, 44.0};
  problem.roots = {{"sine", [](double, State y) { return y[1]; }}};
  const Solution by_function = solve(problem);
  problem.rhs = nullptr;
  const Solution inlined = solve<2>(problem, oscillator_rates);
  ASSERT_EQ(inlined.node_count(), by_function.node_count());
  ASSERT_EQ(inlined.events().size(), 15U);
  constexpr double rounding = 1e-12;  // the compiler may order the sums in another way
  EXPECT_LT(distance(inlined.at(50.0), by_function.at(50.0)), rounding);
  EXPECT_LT(distance(inlined.output(0), by_function.output(0)), rounding);
  EXPECT_EQ(inlined.statistics().rhs_evaluations, by_function.statistics().rhs_evaluations);
}

TEST_P(InlinedSolve, refuses_two_right_hand_sides_another_size_and_another_method) {
  const auto refusal = [](const Problem& problem) -> std::string {
    try {
      (void)solve<2>(problem, oscillator_rates);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "not refused";
  };
  Problem problem = oscillator(GetParam(), 1.0, 1e-9);
  EXPECT_EQ(refusal(problem), "ode::solve: the problem has a right-hand side, and another one is given");
  problem.rhs = nullptr;
  EXPECT_EQ(refusal(problem), "not refused");
  problem.method = Method::arkode_fehlberg_8;
  EXPECT_EQ(refusal(problem), "ode::solve: a right-hand side is inlined by verner_9 and verner_7 only");
  problem.method = GetParam();
  problem.initial_state = {1.0, 0.0, 0.0};
  set_tolerance(problem, 1e-9);
  EXPECT_EQ(refusal(problem), "ode::solve: the right-hand side has 2 components, the initial state has 3");
}

/// Evaluations a step: the stages, the rate at its end, and with dense output the stages of the interpolant.
TEST_P(InlinedSolve, evaluates_what_is_asked_for) {
  const std::size_t stages = GetParam() == Method::verner_9 ? 15 : 9;
  const std::size_t dense = GetParam() == Method::verner_9 ? 9 : 5;
  Problem problem = oscillator(GetParam(), 100.0, 1e-10);
  const auto evaluations = [&] {
    const Statistics run = solve(problem).statistics();
    return std::pair{run.rhs_evaluations - 2 - stages * run.error_test_failures, run.steps};  // 2: the start
  };
  const auto [with, steps] = evaluations();
  EXPECT_EQ(with, (stages + 1 + dense) * steps);
  problem.dense_output = false;
  EXPECT_EQ(evaluations().first, (stages + 1) * steps);
}

TEST_P(InlinedSolve, without_dense_output_has_outputs_and_events) {
  Problem problem = oscillator(GetParam(), 100.0, 1e-10);
  problem.output_times = {0.0, 1.0, 1.5, 77.7, 100.0};
  problem.roots = {{"sine", [](double, State y) { return y[1]; }},
                   {"late", [](double t, State) { return t - 95.0; }, Direction::any, true}};
  const Solution dense = solve(problem);
  problem.dense_output = false;
  const Solution sparse = solve(problem);
  ASSERT_EQ(sparse.output_times().size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(distance(sparse.output(i), dense.output(i)), 0.0);
  ASSERT_EQ(sparse.events().size(), 31U);
  for (std::size_t i = 0; i < 31; ++i) EXPECT_EQ(sparse.events()[i].time, dense.events()[i].time);
  std::size_t refused = 0;
  for (std::size_t i = 0; i + 1 < sparse.node_count(); ++i) {
    const double inside = 0.5 * (sparse.node(i).t + sparse.node(i + 1).t);
    EXPECT_EQ(distance(sparse.at(sparse.node(i).t), sparse.node(i).y), 0.0);
    try {
      EXPECT_EQ(distance(sparse.at(inside), dense.at(inside)), 0.0);
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("is within a step whose dense output was not kept"),
                std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(refused, 10U);
}

/// cos t - 0.95 is positive for 0.64 s around each maximum, less than a step.
TEST_P(InlinedSolve, finds_two_zeros_in_one_step_if_a_quarter_of_it_lies_between) {
  Problem problem = oscillator(GetParam(), 100.0, GetParam() == Method::verner_9 ? 1e-6 : 1e-5);
  problem.roots = {{"near the maximum", [](double, State y) { return y[0] - 0.95; }}};
  const Solution solution = solve(problem);
  const double half_width = std::acos(0.95);
  EXPECT_LT(static_cast<double>(solution.statistics().steps), 100.0 / (2.0 * half_width));
  ASSERT_EQ(solution.events().size(), 31U);
  for (std::size_t i = 0; i < 31; ++i) {
    const double maximum = 2.0 * std::numbers::pi * static_cast<double>((i + 1) / 2);
    EXPECT_NEAR(solution.events()[i].time, maximum + (i % 2 == 0 ? half_width : -half_width), 1e-2);
  }
}

/// A controller at 10 Hz: a segment is one step, with the length carried over.
TEST_P(InlinedSolve, a_short_segment_is_one_step) {
  Problem problem = oscillator(GetParam(), 20.0, 1e-9);
  for (int i = 1; i < 200; ++i) problem.breakpoints.push_back(0.1 * i);
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.segment_count(), 200U);
  EXPECT_LE(solution.statistics().steps, 203U);  // the first segment grows its step
  EXPECT_LT(node_error(solution, oscillator_state), 1e-9);
  for (double t = 0.0; t <= 20.0; t += 0.03) EXPECT_LT(distance(solution.at(t), oscillator_state(t)), 1e-9);
}

/// At the pole of tan t. The step is too short long before the state overflows.
TEST_P(InlinedSolve, at_a_pole_names_the_component_and_the_method_for_stiff_problems) {
  Problem problem = oscillator(GetParam(), 2.0, 1e-9);
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    ydot[0] = 0.0;
    ydot[1] = y[1] * y[1] + 1.0;  // tan t
  };
  try {
    (void)solve(problem);
    ADD_FAILURE() << "no failure";
  } catch (const Failure& failure) {
    const std::string said = failure.what();
    EXPECT_NE(said.find("(ERR_FAILURE): the step fell below "), std::string::npos) << said;
    EXPECT_NE(said.find("the error of component 1 is still too large; a stiff problem needs radau_iia_7"),
              std::string::npos)
        << said;
    // An error e of tan t moves the pole by e / (1 + tan^2 t): at 1e-9 a step, 1e-7 in a hundred steps.
    EXPECT_NEAR(failure.time(), 0.5 * std::numbers::pi, 1e-7);
    EXPECT_EQ(failure.flag(), flag::step_too_short);
  }
  problem.relative_tolerance = 1e-15;
  try {
    (void)solve(problem);
    ADD_FAILURE() << "no failure";
  } catch (const Failure& failure) {
    const std::string said = failure.what();
    EXPECT_NE(said.find("is still too large; the relative tolerance, 1e-15, is near rounding"),
              std::string::npos)
        << said;
  }
}

TEST_P(InlinedSolve, a_step_that_overflows_is_a_failure) {
  Problem problem = oscillator(GetParam(), 1e200, 1e-9);
  problem.rhs = [](double, double, State, std::span<double> ydot) { ydot[0] = ydot[1] = 1e200; };
  try {
    (void)solve(problem);
    ADD_FAILURE() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("component 0 of a stage is inf at t = 1.79769313486"),
              std::string::npos)
        << failure.what();  // 1e200 t reaches the largest number
  }
}

}  // namespace
}  // namespace vectrix::ode::test::inlined_solve_test
