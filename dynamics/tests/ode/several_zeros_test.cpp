#include <limits>

#include "problems.hpp"
#include "testing/trials.hpp"

// Steps in which several zeros lie, and zeros that last for no more than a rounding of time.
namespace vectrix::ode::test::several_zeros_test {
namespace {

class OdeSeveralZeros : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeSeveralZeros, testing::ValuesIn(methods), name);

/// A zero is located to the rounding of its time, and reported at most one rounding later.
double two_roundings(double t) {
  return 2.0 * std::numeric_limits<double>::epsilon() * t;
}

/// y' = 1: the steps become long.
Problem clock(Method method, double start, double end) {
  Problem problem;
  problem.rhs = [](double, double, State, std::span<double> ydot) { ydot[0] = 1.0; };
  problem.initial_state = {0.0};
  problem.start = start;
  problem.end = end;
  problem.method = method;
  set_tolerance(problem, 1e-6);
  return problem;
}

struct Step {
  double from, length;
  [[nodiscard]] double at(double part) const { return from + part * length; }
};
Step longest_step(const Solution& solution) {
  Step longest{0.0, 0.0};
  for (std::size_t i = 1; i < solution.node_count(); ++i) {
    const double from = solution.node(i - 1).t, length = solution.node(i).t - from;
    if (length > longest.length) longest = {from, length};
  }
  return longest;
}
std::vector<double> times_of(const Solution& solution, const std::string& root) {
  std::vector<double> times;
  for (const Event& event : solution.events())
    if (event.name == root) times.push_back(event.time);
  return times;
}

// (t - a) (t - b) has the sign at the end of the segment, before a, that it has after b. With the end in a
// step it has the zeros that it has without: none is taken for one at the end, none is lost.
TEST_P(OdeSeveralZeros, AfterAnEndOfASegmentTheyAreFoundOnce) {
  for (const double start : {0.0, 8e8}) {
    const auto base = [&] { return clock(GetParam(), start, start + 4096.0); };
    const Step step = longest_step(solve(base()));
    struct Parts {
      double end, a, b;
    };
    for (const Parts& parts : {Parts{0.08, 0.18, 0.3}, Parts{0.2, 0.3, 0.6}, Parts{0.08, 0.8, 0.9},
                               Parts{0.3, 0.45, 0.7}, Parts{0.08, 0.12, 0.9}}) {
      const double a = step.at(parts.a), b = step.at(parts.b);
      const auto both = [=](double t, State) { return (t - a) * (t - b); };
      for (const Direction direction : {Direction::any, Direction::rising, Direction::falling}) {
        for (const bool stops : {false, true}) {
          Problem problem = base();
          problem.roots = {{"both", both, direction, stops}};
          const auto without = times_of(solve(problem), "both");
          problem.roots.push_back(
              {"ends", [&](double t, State) { return t - step.at(parts.end); }, Direction::any, false, true});
          const Solution solution = solve(problem);
          const auto found = times_of(solution, "both");
          const auto ends = times_of(solution, "ends");
          ASSERT_EQ(ends.size(), 1U);
          EXPECT_NEAR(ends[0], step.at(parts.end), two_roundings(ends[0]));
          for (const double time : found)
            EXPECT_LE(std::min(std::abs(time - a), std::abs(time - b)), two_roundings(time));
          const auto near = [&](double wanted) {
            return std::ranges::count_if(
                found, [&](double time) { return std::abs(time - wanted) <= two_roundings(wanted); });
          };
          EXPECT_LE(near(a), 1);
          EXPECT_LE(near(b), 1);
          for (const double time : without)
            EXPECT_EQ(near(time), 1) << parts.end << ' ' << parts.a << ' ' << parts.b;
          EXPECT_EQ(solution.stopped(), stops && !found.empty());
        }
      }
    }
  }
}

// |t - c|, c where a quarter of a step ends: at neighbouring times it has its old sign. Its time is c also
// where the time in the segment rounds up.
TEST_P(OdeSeveralZeros, AZeroOfOneRoundingIsWhereItIs) {
  for (int i = 0; i < vectrix_test::trials(16); ++i) {
    const double start = 1000.1 + 0.37 * i;
    Problem problem = clock(GetParam(), start, start + 100.0);
    const Step step = longest_step(solve(problem));
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const double c = part < 1.0 ? start + ((step.from - start) + part * step.length) : step.at(1.0);
      for (const bool ends : {false, true}) {
        problem.roots = {
            {"touches", [=](double t, State) { return std::abs(t - c); }, Direction::falling, false, ends}};
        for (const double time : times_of(solve(problem), "touches")) EXPECT_NEAR(time, c, two_roundings(c));
      }
    }
  }
}

// At the rounded time of a node the state is one before or after the node's.
TEST_P(OdeSeveralZeros, AnEndAtANodeHasItsNewSign) {
  Problem problem = oscillator(GetParam(), 8e8 + 20.0, 1e-9);
  problem.start = 8e8;
  const Solution nodes = solve(problem);
  for (std::size_t i = 1; i + 1 < nodes.node_count(); i += 1 + nodes.node_count() / 40) {
    const double x = nodes.node(i).y[0];
    problem.roots = {{"node", [x](double, State y) { return y[0] - x; }, Direction::any, false, true}};
    std::size_t changes = 0;
    problem.at_segment_start = [&](double t, State y, std::span<const Event> ended_by) {
      for (const Event& event : ended_by) {
        const double now = problem.roots[0].function(t, y);
        EXPECT_TRUE(event.direction == Direction::rising ? now >= 0.0 : now <= 0.0) << i << ' ' << now;
        ++changes;
      }
    };
    // cos crosses each level once between its extremes, of which 6 are inside 20 rad; near one perhaps not.
    EXPECT_EQ(solve(problem).events().size(), changes);
    EXPECT_LE(changes, 7U);
  }
}

// Changes some roundings of time apart: breakpoints, ends of segments by zeros, and plain zeros.
TEST_P(OdeSeveralZeros, SegmentsOfSomeRoundings) {
  for (const double start : {0.0, 8e8}) {
    const double at = start + 1.0, rounding = std::nextafter(at, 2.0 * at) - at;
    for (int k = -12; k <= 12; ++k) {
      for (const int width : vectrix_test::tried(std::vector{1, 2, 3, 7})) {
        Problem problem = oscillator(GetParam(), start + 2.0, 1e-9);
        problem.start = start;
        problem.breakpoints = {at, at + width * rounding};
        const double zero = at + k * rounding;
        problem.roots = {{"ends", [=](double t, State) { return t - zero; }, Direction::any, false, true},
                         {"later", [=](double t, State) { return t - (zero + rounding); }}};
        problem.output_times = {at, at + rounding, at + 5.0 * rounding};
        const Solution solution = solve(problem);
        ASSERT_EQ(solution.events().size(), 2U) << k << ' ' << width;
        EXPECT_NEAR(solution.events()[0].time, zero, two_roundings(zero));
        EXPECT_NEAR(solution.events()[1].time, zero + rounding, two_roundings(zero));
        EXPECT_EQ(solution.output_times().size(), 3U);
        EXPECT_EQ(solution.end(), problem.end);
      }
    }
  }
}

}  // namespace
}  // namespace vectrix::ode::test::several_zeros_test
