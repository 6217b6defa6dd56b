#include <cmath>
#include <exception>
#include <stdexcept>

#include "problems.hpp"

// Root functions that do not answer everywhere: where the kept solution ends.
namespace vectrix::ode::test::unanswered_root_test {
namespace {

class OdeUnansweredRoot : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeUnansweredRoot, testing::ValuesIn(methods), name);

constexpr double stop_time = 2.0;
/// A stop is found to the rounding of its time; y, of slope 1, has the error of its tolerance.
constexpr double stop_error = 1e-6;

/// y' = 1, so that steps are long, with a stop at y = 2 and a function that answers where `answers` holds.
template <class Answers> Problem clock(Method method, const Answers& answers) {
  Problem problem;
  problem.rhs = [](double, double, State, std::span<double> ydot) { ydot[0] = 1.0; };
  problem.initial_state = {0.0};
  problem.start = 0.0;
  problem.end = 50.0;
  problem.method = method;
  set_tolerance(problem, 1e-9);
  problem.roots = {{"stop", [](double, State y) { return y[0] - stop_time; }, Direction::any, true},
                   {"quiet",
                    [answers](double t, State) {
                      if (!answers(t)) throw std::out_of_range("no answer");
                      return 1.0;
                    }},
                   {"seen", [](double t, State) { return t - 0.5; }}};
  return problem;
}

/// The solution of a run that must fail because of the function.
Solution failed(const Problem& problem) {
  try {
    (void)solve(problem);
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("root 1 (quiet) threw: no answer"), std::string::npos)
        << failure.what();
    EXPECT_THROW(std::rethrow_if_nested(failure), std::out_of_range);
    return failure.solution();
  }
  throw std::logic_error("the problem did not fail");
}

void expect_agrees(const Solution& solution, double last) {
  EXPECT_FALSE(solution.stopped());
  EXPECT_LE(solution.end(), last);
  for (const Event& event : solution.events()) EXPECT_LE(event.time, solution.end());
  EXPECT_EQ(solution.events().size(), solution.end() >= 0.5 ? 1U : 0U);
  EXPECT_NEAR(solution.at(0.5 * solution.end())[0], 0.5 * solution.end(), stop_error);
  EXPECT_NEAR(solution.at(solution.end())[0], solution.end(), stop_error);
}

// Wherever it begins: in the step of the stop, or in a later one.
TEST_P(OdeUnansweredRoot, after_a_stop_the_stop_wins) {
  for (const double until : {2.0 + stop_error, 2.2, 3.0, 4.0, 10.0, 40.0}) {
    const Solution solution = solve(clock(GetParam(), [until](double t) { return t <= until; }));
    EXPECT_TRUE(solution.stopped()) << until;
    EXPECT_NEAR(solution.end(), stop_time, stop_error) << until;
    ASSERT_EQ(solution.events().size(), 2U) << until;
    EXPECT_EQ(solution.events().back().name, "stop");
  }
}

TEST_P(OdeUnansweredRoot, before_a_stop_ends_the_kept_solution) {
  for (const double until : {0.1, 0.7, 1.0, 1.5, 1.9, 2.0 - stop_error})
    for (const bool dense : {true, false}) {
      Problem problem = clock(GetParam(), [until](double t) { return t <= until; });
      problem.dense_output = dense;
      problem.output_times = {0.05, 1.0};
      const Solution solution = failed(problem);
      EXPECT_LE(solution.end(), until);
      EXPECT_FALSE(solution.stopped());
      for (const Event& event : solution.events()) EXPECT_LE(event.time, solution.end());
      for (std::size_t i = 0; i < solution.output_times().size(); ++i)
        EXPECT_NEAR(solution.output(i)[0], solution.output_times()[i], stop_error);
      if (dense) expect_agrees(solution, until);
    }
}

// Only around the stop: the ends of all steps are checked, but the stop cannot be.
TEST_P(OdeUnansweredRoot, at_a_stop_alone_never_leads_past_it) {
  Problem problem = clock(GetParam(), [](double t) { return t <= 1.9 || t >= 2.1; });
  try {
    const Solution solution = solve(problem);
    EXPECT_TRUE(solution.stopped());
    EXPECT_NEAR(solution.end(), stop_time, stop_error);
  } catch (const Failure& failure) {
    expect_agrees(failure.solution(), 1.9);
  }
}

// The function of the stop itself does not answer where its zero is.
TEST_P(OdeUnansweredRoot, whose_zero_would_be_the_stop_ends_the_kept_solution_before_it) {
  Problem problem = clock(GetParam(), [](double) { return true; });
  problem.roots[0].function = [](double t, State y) {
    if (std::abs(t - stop_time) < 1e-3) throw std::out_of_range("no answer");
    return y[0] - stop_time;
  };
  try {
    (void)solve(problem);
    ADD_FAILURE() << "the problem did not fail";
  } catch (const Failure& failure) {
    expect_agrees(failure.solution(), stop_time);
  }
}

// The right-hand side is asked at the stop: without an answer there the stop is not applied.
TEST_P(OdeUnansweredRoot, or_a_rate_that_is_missing_at_the_stop) {
  Problem problem = clock(GetParam(), [](double) { return true; });
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    if (std::abs(y[0] - stop_time) < 1e-9) throw std::out_of_range("no rate");
    ydot[0] = 1.0;
  };
  try {
    const Solution solution = solve(problem);
    EXPECT_TRUE(solution.stopped());
    EXPECT_NEAR(solution.end(), stop_time, stop_error);
  } catch (const Failure& failure) {
    expect_agrees(failure.solution(), stop_time);
  }
}

}  // namespace
}  // namespace vectrix::ode::test::unanswered_root_test
