#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include <vectrix/frames/errors.hpp>

#include "problems.hpp"
#include "testing/trials.hpp"

namespace vectrix::ode::test::failure_test {
namespace {

class OdeFailure : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeFailure, testing::ValuesIn(methods), name);

/// The failure of a problem that must fail.
Failure failure_of(const Problem& problem) {
  try {
    (void)solve(problem);
  } catch (const Failure& failure) {
    return failure;
  }
  throw std::logic_error("the problem did not fail");
}

void expect_text(const std::exception& error, const std::string& part) {
  EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
}

constexpr double trouble_time = 5.0;

/// An oscillator whose right-hand side is replaced from trouble_time on.
template <class Act> Problem troubled(Method method, Act act) {
  Problem problem = oscillator(method, 20.0, 1e-9);
  const auto rhs = problem.rhs;
  problem.rhs = [rhs, act](double segment_start, double t, State y, std::span<double> ydot) {
    rhs(segment_start, t, y, ydot);
    if (t >= trouble_time) act(ydot);
  };
  return problem;
}

void expect_solution_until_trouble(const Solution& solution) {
  EXPECT_LE(solution.end(), trouble_time);
  EXPECT_GT(solution.end(), trouble_time - 0.7);  // the longest step
  EXPECT_LT(node_error(solution, oscillator_state), 1e-4);
  EXPECT_LT(distance(solution.at(2.2), oscillator_state(2.2)), 1e-4);
}

TEST_P(OdeFailure, an_exception_of_the_right_hand_side_is_nested_and_nothing_is_lost) {
  Problem problem = troubled(GetParam(), [](std::span<double>) { throw std::domain_error("no thrust"); });
  problem.output_times = {1.0, 4.0, 6.0};
  problem.roots = {{"sine", [](double, State y) { return y[1]; }}};
  try {
    (void)solve(problem);
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    expect_text(failure, "the right-hand side threw: no thrust");
    expect_text(failure, "RHSFUNC_FAIL");
    EXPECT_GE(failure.time(), trouble_time);
    EXPECT_EQ(failure.flag(), -8);
    EXPECT_EQ(failure.step(), failure.solution().statistics().steps);
    EXPECT_THROW(std::rethrow_if_nested(failure), std::domain_error);
    expect_solution_until_trouble(failure.solution());
    EXPECT_EQ(failure.solution().output_times().size(), 2U);
    EXPECT_EQ(failure.solution().events().size(), 1U);
  }
}

/// Between the evaluations that fail in turn. Under the sanitizers 11, a prime: other stages of a step fail
/// each time.
constexpr std::size_t apart = vectrix_test::one_in == 1 ? 1 : 11;

/// Also in the stages of the dense output: then the last step has the cubic through its ends at least, whose
/// error is h^4 / 384 here.
TEST_P(OdeFailure, at_any_evaluation_leaves_dense_output_until_the_last_node) {
  for (std::size_t last = 10; last < 150; last += apart) {
    Problem problem = oscillator(GetParam(), 100.0, 1e-9);
    std::size_t evaluations = 0;
    problem.rhs = [&, rhs = problem.rhs](double segment_start, double t, State y, std::span<double> ydot) {
      if (++evaluations > last) throw std::runtime_error("enough");
      rhs(segment_start, t, y, ydot);
    };
    const Solution solution = failure_of(problem).solution();
    for (std::size_t i = 0; i + 1 < solution.node_count(); ++i) {
      const double left = solution.node(i).t, h = solution.node(i + 1).t - left;
      const double error = distance(solution.at(left + 0.5 * h), oscillator_state(left + 0.5 * h));
      ASSERT_LE(error, std::pow(h, 4) / 384.0 + 1e-6) << last;  // 1e-6: of the nodes
    }
  }
}

// An exception in the stages of the dense output that an output needs.
TEST_P(OdeFailure, at_any_evaluation_leaves_the_outputs_until_then) {
  for (std::size_t last = 10; last < 150; last += apart) {
    Problem problem = oscillator(GetParam(), 100.0, 1e-9);
    problem.dense_output = false;
    for (int i = 0; i <= 1000; ++i) problem.output_times.push_back(0.1 * i);
    std::size_t evaluations = 0;
    problem.rhs = [&, rhs = problem.rhs](double segment_start, double t, State y, std::span<double> ydot) {
      if (++evaluations > last) throw std::runtime_error("enough");
      rhs(segment_start, t, y, ydot);
    };
    try {
      solve(problem);
      FAIL();
    } catch (const Failure& failure) {
      EXPECT_THROW(std::rethrow_if_nested(failure), std::runtime_error);
      const Solution& solution = failure.solution();
      const auto reached = std::ranges::upper_bound(problem.output_times, solution.end());
      ASSERT_EQ(static_cast<std::ptrdiff_t>(solution.output_times().size()),
                reached - problem.output_times.begin());
    }
  }
}

// At the stop the right-hand side is asked once more.
TEST_P(OdeFailure, at_a_stop_the_run_has_not_stopped) {
  for (std::size_t last = 10; last < 150; last += apart) {
    Problem problem = oscillator(GetParam(), 100.0, 1e-9);
    problem.roots = {{"sine", [](double, State y) { return -y[1]; }, Direction::falling, true}};
    std::size_t evaluations = 0;
    problem.rhs = [&, rhs = problem.rhs](double segment_start, double t, State y, std::span<double> ydot) {
      if (++evaluations > last) throw std::runtime_error("enough");
      rhs(segment_start, t, y, ydot);
    };
    try {
      EXPECT_TRUE(solve(problem).stopped());
    } catch (const Failure& failure) {
      EXPECT_FALSE(failure.solution().stopped()) << last;
    }
  }
}

TEST_P(OdeFailure, what_is_thrown_need_not_be_an_exception_class) {
  try {
    (void)solve(troubled(GetParam(), [](std::span<double>) { throw 42; }));
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_THROW(std::rethrow_if_nested(failure), int);
  }
}

TEST_P(OdeFailure, a_rate_that_is_not_finite_is_named) {
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Failure failure =
        failure_of(troubled(GetParam(), [=](std::span<double> ydot) { ydot[1] = wrong; }));
    expect_text(failure, std::isnan(wrong) ? "component 1 of the right-hand side is nan at t = "
                                           : "component 1 of the right-hand side is inf at t = ");
    EXPECT_GE(failure.time(), trouble_time);
    EXPECT_NO_THROW(std::rethrow_if_nested(failure));
    expect_solution_until_trouble(failure.solution());
  }
}

TEST_P(OdeFailure, at_the_very_first_evaluation_the_solution_is_empty) {
  Problem problem = oscillator(GetParam(), 1.0, 1e-9);
  problem.rhs = [](double, double, State, std::span<double>) { throw std::runtime_error("never"); };
  const Failure failure = failure_of(problem);
  EXPECT_EQ(failure.time(), 0.0);
  EXPECT_EQ(failure.solution().node_count(), 0U);
  EXPECT_EQ(failure.solution().segment_count(), 0U);
  EXPECT_THROW((void)failure.solution().at(0.0), BadInput);
}

TEST_P(OdeFailure, in_a_later_segment_the_earlier_are_kept) {
  Problem problem = troubled(GetParam(), [](std::span<double>) { throw std::runtime_error("late"); });
  problem.breakpoints = {2.0, trouble_time};
  const Failure failure = failure_of(problem);
  EXPECT_GE(failure.solution().segment_count(), 2U);
  EXPECT_GT(failure.solution().end(), 4.0);
}

TEST_P(OdeFailure, step_limit) {
  Problem problem = oscillator(GetParam(), 1e6, 1e-9);
  problem.max_steps = 50;
  const Failure failure = failure_of(problem);
  expect_text(failure, "max_steps = 50 reached");
  expect_text(failure, "TOO_MUCH_WORK");
  EXPECT_EQ(failure.flag(), -1);
  EXPECT_EQ(failure.step(), 50U);
  EXPECT_EQ(failure.solution().node_count(), 51U);
  EXPECT_EQ(failure.time(), failure.solution().end());
}

// A relay that is switched back as soon as it has switched: a sliding mode, of ever shorter segments.
TEST_P(OdeFailure, step_limit_of_changes_without_end_names_the_zero) {
  Problem problem = oscillator(GetParam(), 20.0, 1e-9);
  const auto acceleration = std::make_shared<double>(-1.0);
  problem.rhs = [acceleration](double, double, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = *acceleration;
  };
  problem.initial_state = {0.2, 0.3};
  const auto g = [](double, State y) { return y[1] + 0.5 * y[0]; };
  problem.roots = {{"above", g, Direction::rising, false, true},
                   {"below", g, Direction::falling, false, true}};
  problem.at_segment_start = [acceleration](double, std::span<double>, std::span<const Event> ended_by) {
    for (const Event& event : ended_by) *acceleration = event.root == 0 ? -1.0 : 1.0;
  };
  problem.max_steps = 2000;
  const Failure failure = failure_of(problem);
  expect_text(failure, "max_steps = 2000 reached: they are in ");
  expect_text(failure, " smooth segments, the last of which begins at the zero of ");
}

// y_1 follows cos t at once: an explicit method must take steps of its time constant.
TEST_P(OdeFailure, step_limit_of_a_stiff_component_names_it_and_what_to_try) {
  Problem problem = oscillator(GetParam(), 1e3, 1e-6);
  problem.rhs = [](double, double t, State y, std::span<double> ydot) {
    ydot[0] = -1e-3 * y[0];
    ydot[1] = -1e6 * (y[1] - std::cos(t));
  };
  problem.initial_state = {1.0, 1.0};
  problem.max_steps = 400;
  const Method method = GetParam();
  if (method == Method::cvode_bdf) problem.max_steps = 20;  // while y_1 is not yet smooth
  if (method == Method::radau_iia_7) return;                // it is the one to try
  expect_text(failure_of(problem), "max_steps = " + std::to_string(problem.max_steps) +
                                       " reached: the error of component 1 allows steps of ");
  expect_text(failure_of(problem), " s; a stiff problem needs radau_iia_7");
}

/// x' = x^2, x(0) = 1 has no solution beyond t = 1.
TEST_P(OdeFailure, a_blow_up_ends) {
  Problem problem = oscillator(GetParam(), 2.0, 1e-9);
  problem.rhs = [](double, double, State y, std::span<double> ydot) { ydot[0] = y[0] * y[0]; };
  problem.initial_state = {1.0};
  set_tolerance(problem, 1e-9);
  const Failure failure = failure_of(problem);
  EXPECT_NEAR(failure.solution().end(), 1.0, 1e-5);  // the pole moves by the accumulated error
  EXPECT_NEAR(failure.solution().at(0.5)[0], 2.0, 1e-6);
}

TEST_P(OdeFailure, an_exception_of_a_root_function_is_nested) {
  Problem problem = oscillator(GetParam(), 20.0, 1e-9);
  problem.roots = {{"horizon", [](double t, State) -> double {
                      if (t >= trouble_time) throw std::domain_error("below");
                      return 1.0;
                    }}};
  try {
    (void)solve(problem);
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    expect_text(failure, "root 0 (horizon) threw: below");
    expect_text(failure, "RTFUNC_FAIL");
    EXPECT_THROW(std::rethrow_if_nested(failure), std::domain_error);
    EXPECT_GT(failure.solution().end(), trouble_time - 0.7);
  }
}

TEST_P(OdeFailure, a_root_that_is_not_finite_is_named) {
  Problem problem = oscillator(GetParam(), 20.0, 1e-9);
  problem.roots = {{"ratio", [](double t, State) { return t < trouble_time ? 1.0 : std::nan(""); }}};
  expect_text(failure_of(problem), "root 0 (ratio) is nan at t = ");
}

TEST_P(OdeFailure, four_threads_agree_to_the_last_bit) {
  Problem problem = oscillator(GetParam(), 50.0, 1e-10);
  problem.breakpoints = {10.0, 20.0};
  problem.roots = {{"sine", [](double, State y) { return y[1]; }}};
  std::vector<std::optional<Solution>> solutions(4);
  {
    std::vector<std::jthread> threads;
    for (auto& solution : solutions) threads.emplace_back([&] { solution = solve(problem); });
  }
  for (const auto& solution : solutions) {
    ASSERT_EQ(solution->node_count(), solutions[0]->node_count());
    ASSERT_EQ(solution->events().size(), solutions[0]->events().size());
    for (std::size_t i = 0; i < solution->node_count(); ++i) {
      ASSERT_EQ(solution->node(i).t, solutions[0]->node(i).t);
      ASSERT_EQ(distance(solution->node(i).y, solutions[0]->node(i).y), 0.0);
    }
    for (std::size_t i = 0; i < solution->events().size(); ++i) {
      ASSERT_EQ(solution->events()[i].time, solutions[0]->events()[i].time);
    }
  }
}

}  // namespace
}  // namespace vectrix::ode::test::failure_test
