#include <limits>
#include <stdexcept>

#include "problems.hpp"

// What changes at the start of a segment: sampled values, switches at zeros.
namespace vectrix::ode::test::changes_test {
namespace {

class OdeChanges : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeChanges, testing::ValuesIn(methods), name);

/// The error of a run of some 20 segments, each of some ten steps with an error of 1e-12, five times as large
/// for what the segments amplify. BDF of order 5 has some thousand steps in a segment.
double error_of(Method method) {
  return 20 * (method == Method::cvode_bdf ? 1000 : 10) * 5 * 1e-12;
}

/// A heater: y' = u - y, u = 2 until y reaches 3/2, then 0 until y reaches 1/2, and so on. From y = 1 it
/// switches first after ln 2, then every ln 3.
struct Heater {
  double u = 2.0;
  std::vector<double> switched;

  Problem problem(Method method, double start) {
    Problem problem;
    problem.rhs = [this](double, double, State y, std::span<double> ydot) { ydot[0] = u - y[0]; };
    problem.initial_state = {1.0};
    problem.start = start;
    problem.end = start + 20.0;
    problem.method = method;
    set_tolerance(problem, 1e-12);
    problem.roots = {{"hot", [](double, State y) { return y[0] - 1.5; }, Direction::rising, false, true},
                     {"cold", [](double, State y) { return y[0] - 0.5; }, Direction::falling, false, true}};
    problem.at_segment_start = [this](double t, State, std::span<const Event> ended_by) {
      for (const Event& event : ended_by) {
        EXPECT_EQ(event.time, t);
        u = event.name == "hot" ? 0.0 : 2.0;
        switched.push_back(t);
      }
    };
    return problem;
  }
};

void expect_heater(const Heater& heater, const Solution& solution, double within) {
  ASSERT_EQ(heater.switched.size(), 18U);
  ASSERT_EQ(solution.segment_count(), 19U);
  ASSERT_EQ(solution.events().size(), 18U);
  for (std::size_t i = 0; i < 18; ++i) {
    const double expected = std::numbers::ln2 + static_cast<double>(i) * std::log(3.0);
    EXPECT_NEAR(heater.switched[i] - solution.start(), expected, within) << i;
    EXPECT_EQ(solution.events()[i].time, heater.switched[i]);
    const Node first = solution.node(solution.segment_begin(i + 1));
    EXPECT_EQ(first.t, heater.switched[i]);
    EXPECT_NEAR(first.ydot[0], (i % 2 == 0 ? 0.0 : 2.0) - first.y[0], within);
    // In the middle of the segment that follows, ln(3)/2 after the switch.
    const double target = i % 2 == 0 ? 0.0 : 2.0, from = i % 2 == 0 ? 1.5 : 0.5;
    const double middle = heater.switched[i] + 0.5 * std::log(3.0);
    if (middle < solution.end()) {
      EXPECT_NEAR(solution.at(middle)[0], target + (from - target) / std::sqrt(3.0), within);
    }
  }
}

TEST_P(OdeChanges, a_switch_at_a_zero_takes_effect_there) {
  Heater heater;
  const Problem problem = heater.problem(GetParam(), 0.0);
  expect_heater(heater, solve(problem), error_of(GetParam()));
}

TEST_P(OdeChanges, a_late_start_costs_its_rounding_alone) {
  Heater heater;
  const Problem problem = heater.problem(GetParam(), 1e9);
  expect_heater(heater, solve(problem), 18 * 1.2e-7);  // each switch is at a rounded time
}

// y' = y + u, u = -1.2 y at the start of each interval of 1/2: exact from one sample to the next.
TEST_P(OdeChanges, a_sampled_value_holds_until_the_next_sample) {
  double u = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> times;
  Problem problem;
  problem.rhs = [&](double, double, State y, std::span<double> ydot) { ydot[0] = y[0] + u; };
  problem.initial_state = {1.0};
  problem.start = 0.0;
  problem.end = 5.0;
  for (int k = 1; k < 10; ++k) problem.breakpoints.push_back(0.5 * k);
  problem.method = GetParam();
  set_tolerance(problem, 1e-12);
  problem.at_segment_start = [&](double t, State y, std::span<const Event> ended_by) {
    EXPECT_TRUE(ended_by.empty());
    times.push_back(t);
    u = -1.2 * y[0];
  };
  const Solution solution = solve(problem);
  ASSERT_EQ(times.size(), 10U);
  double y = 1.0;
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(times[static_cast<std::size_t>(k)], 0.5 * k);
    const double half = std::exp(0.25), whole = std::exp(0.5);
    EXPECT_NEAR(solution.at(0.5 * k + 0.25)[0], (half - 1.2 * (half - 1.0)) * y, error_of(GetParam()));
    y *= whole - 1.2 * (whole - 1.0);
  }
  EXPECT_NEAR(solution.at(5.0)[0], y, error_of(GetParam()));
}

TEST_P(OdeChanges, a_breakpoint_and_a_zero_at_one_instant_are_one_change) {
  std::vector<std::pair<double, std::size_t>> calls;
  Problem problem = oscillator(GetParam(), 2.0, 1e-12);
  problem.breakpoints = {1.0};
  problem.roots = {{"one", [](double t, State) { return t - 1.0; }, Direction::any, false, true}};
  problem.at_segment_start = [&](double t, State, std::span<const Event> ended_by) {
    calls.emplace_back(t, ended_by.size());
  };
  const Solution solution = solve(problem);
  EXPECT_EQ(calls, (std::vector<std::pair<double, std::size_t>>{{0.0, 0}, {1.0, 1}}));
  EXPECT_EQ(solution.segment_count(), 2U);
  EXPECT_NEAR(solution.at(2.0)[0], std::cos(2.0), error_of(GetParam()));
}

/// Also where nothing changes.
TEST_P(OdeChanges, a_zero_after_the_change_is_found_once) {
  Problem problem = oscillator(GetParam(), 100.0, 1e-12);
  const auto zero_at = [](double t0) { return [t0](double t, State) { return t - t0; }; };
  problem.roots = {{"ends", zero_at(5.0), Direction::any, false, true},
                   {"before", zero_at(std::nextafter(5.0, 0.0))},
                   {"after", zero_at(std::nextafter(5.0, 6.0))},
                   {"later", zero_at(5.001)}};
  const auto names = [&] {
    std::vector<std::string> found;
    for (const Event& event : solve(problem).events()) found.push_back(event.name);
    return found;
  };
  const std::vector<std::string> all{"before", "ends", "after", "later"};
  EXPECT_EQ(names(), all);
  problem.at_segment_start = [](double, State, std::span<const Event>) {};
  EXPECT_EQ(names(), all);
}

TEST_P(OdeChanges, a_stop_is_the_last_event) {
  Problem problem = oscillator(GetParam(), 100.0, 1e-10);
  const auto two = [](double t, State) { return t - 2.0; };
  problem.roots = {{"stops", two, Direction::any, true}, {"ends", two, Direction::any, false, true}};
  int calls = 0;
  problem.at_segment_start = [&](double, State, std::span<const Event>) { ++calls; };
  const Solution solution = solve(problem);
  EXPECT_TRUE(solution.stopped());
  EXPECT_EQ(solution.end(), 2.0);
  ASSERT_EQ(solution.events().size(), 2U);
  EXPECT_EQ(solution.events().back().name, "stops");
  EXPECT_EQ(calls, 1);
}

// A function that is zero for a while: its zero may be located after the end of the segment that it began in.
TEST_P(OdeChanges, a_zero_that_lasts_over_the_change_is_not_lost) {
  const auto dead_band = [](double t, State) { return t < 5.0 ? t - 5.0 : std::max(0.0, t - 5.5); };
  for (const bool stops : {false, true}) {
    Problem problem = oscillator(GetParam(), 8.0, 1e-9);
    problem.roots = {{"band", dead_band, Direction::rising, stops},
                     {"ends", [](double t, State) { return t - 5.2; }, Direction::any, false, true}};
    const Solution solution = solve(problem);
    EXPECT_EQ(std::ranges::count(solution.events(), "band", &Event::name), 1);
    EXPECT_EQ(solution.stopped(), stops);
    const auto band = std::ranges::find(solution.events(), "band", &Event::name);
    ASSERT_NE(band, solution.events().end());
    EXPECT_GE(band->time, 5.0);
    EXPECT_LE(band->time, 5.2);
  }
}

// The distance from a point is rounded more coarsely than time: at the rounded time of its zero it may have
// its old sign still. The change must come once.
TEST_P(OdeChanges, a_zero_is_crossed_where_it_ends_the_segment) {
  constexpr double radius = 7e6;
  for (int i = 0; i < 40; ++i) {
    const double speed = 0.1 + 0.037 * i, angle = 0.1 + 0.031 * i, start = 3000.0 + 77.7 * i;
    Problem problem;
    problem.rhs = [=](double, double, State, std::span<double> ydot) {
      ydot[0] = speed * std::cos(angle);
      ydot[1] = speed * std::sin(angle);
    };
    problem.initial_state = {(radius - 10.0) * std::cos(angle), (radius - 10.0) * std::sin(angle)};
    problem.start = start;
    problem.end = start + 200.0;
    problem.breakpoints = {start + 1.0};
    problem.method = GetParam();
    set_tolerance(problem, 1e-9);
    problem.roots = {{"far", [=](double, State y) { return std::hypot(y[0], y[1]) - radius; }, Direction::any,
                      false, true}};
    int changes = 0;
    problem.at_segment_start = [&](double t, State y, std::span<const Event> ended_by) {
      if (ended_by.empty()) return;
      ++changes;
      EXPECT_GE(problem.roots[0].function(t, y), 0.0);
    };
    EXPECT_EQ(solve(problem).events().size(), 1U) << i;
    EXPECT_EQ(changes, 1) << i;
  }
}

// What a root function reads may jump with the change: no zero was crossed.
TEST_P(OdeChanges, a_sign_that_a_change_turns_is_no_event) {
  double limit = 5.0;
  Problem problem = oscillator(GetParam(), 6.0, 1e-10);
  problem.breakpoints = {1.0};
  problem.roots = {{"limit", [&](double t, State) { return t - limit; }}};
  problem.at_segment_start = [&](double t, State, std::span<const Event>) { limit = t < 1.0 ? 5.0 : 0.5; };
  EXPECT_TRUE(solve(problem).events().empty());
}

/// A ball falls from 1 m at 1 m/s^2, bounces with half its speed at 2^(1/2) s, and again 2^(1/2) s later.
TEST_P(OdeChanges, the_state_may_change) {
  const double fall = std::sqrt(2.0);
  Problem problem;
  problem.rhs = [](double, double, State y, std::span<double> ydot) { ydot[0] = y[1], ydot[1] = -1.0; };
  problem.initial_state = {1.0, 0.0};
  problem.start = 0.0;
  problem.end = 2.4 * fall;
  problem.method = GetParam();
  set_tolerance(problem, 1e-12);
  problem.roots = {{"ground", [](double, State y) { return y[0]; }, Direction::falling, false, true}};
  problem.at_segment_start = [](double, std::span<double> y, std::span<const Event> ended_by) {
    if (!ended_by.empty()) y[0] = 0.0, y[1] = -0.5 * y[1];
  };
  const Solution solution = solve(problem);
  ASSERT_EQ(solution.events().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Event& event = solution.events()[i];
    const double speed = fall * std::exp2(-static_cast<double>(i));
    EXPECT_NEAR(event.time, static_cast<double>(i + 1) * fall, error_of(GetParam()));
    EXPECT_NEAR(event.state[1], -speed, error_of(GetParam()));
    EXPECT_EQ(solution.at(event.time), (std::vector{0.0, -0.5 * event.state[1]}));
    const std::size_t node = solution.segment_begin(i + 1);
    EXPECT_EQ(distance(solution.node(node - 1).y, event.state), 0.0);
    EXPECT_EQ(distance(solution.node(node).y, solution.at(event.time)), 0.0);
    const double t = 0.25 * fall;
    EXPECT_NEAR(solution.at(event.time + t)[0], 0.5 * speed * t - 0.5 * t * t, error_of(GetParam()));
  }
}

TEST_P(OdeChanges, a_state_that_is_not_finite_is_refused) {
  Problem problem = oscillator(GetParam(), 10.0, 1e-10);
  problem.component_names = {"place", "speed"};
  problem.breakpoints = {1.0};
  problem.at_segment_start = [](double t, std::span<double> y, std::span<const Event>) {
    if (t == 1.0) y[1] = std::numeric_limits<double>::quiet_NaN();
  };
  try {
    solve(problem);
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_NE(
        std::string(failure.what()).find("the change at the start of the segment at t = 1 sets speed to nan"),
        std::string::npos)
        << failure.what();
    EXPECT_EQ(failure.solution().end(), 1.0);
  }
}

TEST_P(OdeChanges, an_exception_arrives_with_the_solution_until_then) {
  Problem problem = oscillator(GetParam(), 10.0, 1e-10);
  problem.breakpoints = {1.0, 3.0};
  problem.at_segment_start = [](double t, State, std::span<const Event>) {
    if (t == 3.0) throw std::domain_error("no command");
  };
  try {
    solve(problem);
    FAIL() << "no failure";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.time(), 3.0);
    EXPECT_NE(std::string(failure.what()).find("the change at the start of the segment at t = 3 threw"),
              std::string::npos)
        << failure.what();
    EXPECT_THROW(std::rethrow_if_nested(failure), std::domain_error);
    EXPECT_EQ(failure.solution().end(), 3.0);
    // Some ten steps with an error of 1e-10 each; those of Adams and BDF are some hundred.
    const bool multistep = GetParam() == Method::cvode_adams || GetParam() == Method::cvode_bdf;
    EXPECT_NEAR(failure.solution().at(3.0)[0], std::cos(3.0), (multistep ? 100 : 10) * 1e-10);
  }
}

}  // namespace
}  // namespace vectrix::ode::test::changes_test
