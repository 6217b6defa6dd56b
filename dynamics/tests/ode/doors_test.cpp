#include <functional>
#include <limits>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "problems.hpp"

namespace vectrix::ode::test::doors_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Door {
  const char* text;
  std::function<void(Problem&)> spoil;
};

const std::vector<Door>& doors() {
  static const std::vector<Door> all = {
      {"the problem has no right-hand side", [](Problem& p) { p.rhs = nullptr; }},
      {"the initial state is empty", [](Problem& p) { p.initial_state.clear(); }},
      {"component 1 of the initial state must be finite, got nan",
       [](Problem& p) { p.initial_state[1] = nan; }},
      {"component 0 of the initial state must be finite, got -inf",
       [](Problem& p) { p.initial_state[0] = -infinity; }},
      {"relative_tolerance is left out, or 0; it has no default",
       [](Problem& p) { p.relative_tolerance = 0.0; }},
      {"relative_tolerance is left out, or nan; it has no default",
       [](Problem& p) { p.relative_tolerance = Problem{}.relative_tolerance; }},
      {"relative tolerance must be finite and greater than 0, got -1e-12",
       [](Problem& p) { p.relative_tolerance = -1e-12; }},
      {"the state has 2 components, but there are 3 absolute tolerances",
       [](Problem& p) { p.absolute_tolerances.push_back(1.0); }},
      {"absolute tolerance of component 1 must be finite and greater than 0, got -1",
       [](Problem& p) { p.absolute_tolerances[1] = -1.0; }},
      {"absolute tolerance of component 0 must be finite and greater than 0, got inf",
       [](Problem& p) { p.absolute_tolerances[0] = infinity; }},
      {"the relative tolerance 1e-20 is below rounding, 2.220446049250313e-16",
       [](Problem& p) { p.relative_tolerance = 1e-20; }},
      {"the relative tolerance 2.2e-16 is below rounding, 2.220446049250313e-16",
       [](Problem& p) { p.relative_tolerance = 2.2e-16; }},
      {"start is left out, or nan; it has no default", [](Problem& p) { p.start = Problem{}.start; }},
      {"end is left out, or nan; it has no default", [](Problem& p) { p.end = Problem{}.end; }},
      {"end must be finite, got inf", [](Problem& p) { p.end = infinity; }},
      {"end = 0 must be later than start = 0", [](Problem& p) { p.end = 0.0; }},
      {"end = -2 must be later than start = 0", [](Problem& p) { p.end = -2.0; }},
      {"end - start must be finite, got inf", [](Problem& p) { p.start = -(p.end = 1.5e308); }},
      {"output time 1 must be finite, got nan",
       [](Problem& p) {
         p.output_times = {1.0, nan};
       }},
      {"output times must increase strictly, but number 1 = 1 follows 2",
       [](Problem& p) {
         p.output_times = {2.0, 1.0};
       }},
      {"output times must increase strictly, but number 2 = 2 follows 2",
       [](Problem& p) {
         p.output_times = {1.0, 2.0, 2.0};
       }},
      {"output time -0.5 is outside [0, 10]", [](Problem& p) { p.output_times = {-0.5}; }},
      {"output time 10.5 is outside [0, 10]",
       [](Problem& p) {
         p.output_times = {3.0, 10.5};
       }},
      {"breakpoint 0 must be finite, got inf", [](Problem& p) { p.breakpoints = {infinity}; }},
      {"breakpoints must increase strictly, but number 1 = 3 follows 3",
       [](Problem& p) {
         p.breakpoints = {3.0, 3.0};
       }},
      {"root 1 (empty) has no function",
       [](Problem& p) {
         p.roots = {{"good", [](double, State) { return 1.0; }}, {"empty", nullptr}};
       }},
      {"root 0 (lost) has an unknown direction",
       [](Problem& p) {
         p.roots = {{"lost", [](double, State) { return 1.0; }, static_cast<Direction>(7)}};
       }},
      {"max_steps must be greater than 0", [](Problem& p) { p.max_steps = 0; }},
      {"maximum_step must be greater than 0, got 0", [](Problem& p) { p.maximum_step = 0.0; }},
      {"maximum_step must be greater than 0, got nan", [](Problem& p) { p.maximum_step = nan; }},
      {"unknown method 9", [](Problem& p) { p.method = static_cast<Method>(9); }},
  };
  return all;
}

TEST(OdeDoors, refuse_with_the_field_and_the_number) {
  const Problem good = oscillator(Method::cvode_adams, 10.0, 1e-6);
  EXPECT_NO_THROW((void)solve(good));
  for (const Door& door : doors()) {
    Problem problem = good;
    door.spoil(problem);
    try {
      (void)solve(problem);
      ADD_FAILURE() << "not refused: " << door.text;
    } catch (const BadInput& error) {
      EXPECT_EQ(error.what(), std::string("ode::solve: ") + door.text);
    }
  }
}

template <class S>
concept GivesViews = requires(S&& solution) {
  std::forward<S>(solution).node(0);
}
|| requires(S&& solution) {
  std::forward<S>(solution).output(0);
}
|| requires(S&& solution) {
  std::forward<S>(solution).output_times();
};
static_assert(GivesViews<const Solution&>);
static_assert(!GivesViews<Solution>);

template <class Call> std::string refusal(Call call) {
  try {
    call();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "not refused";
}

TEST(OdeDoors, solution_refuses_what_it_does_not_hold) {
  const Solution solution = solve(oscillator(Method::cvode_adams, 10.0, 1e-6));
  const std::string past = "ode::Solution::at: time 10.5 is outside [0, 10]";
  EXPECT_EQ(refusal([&] { (void)solution.at(10.5); }), past);
  EXPECT_EQ(refusal([&] { (void)solution.at(-1.0); }), "ode::Solution::at: time -1 is outside [0, 10]");
  EXPECT_EQ(refusal([&] { (void)solution.at(nan); }), "ode::Solution::at: time nan is outside [0, 10]");
  std::vector<double> three(3);
  EXPECT_EQ(refusal([&] { solution.at(1.0, three); }),
            "ode::Solution::at: the state has 2 components, the span 3");
  const std::string count = std::to_string(solution.node_count());
  EXPECT_EQ(refusal([&] { (void)solution.node(solution.node_count()); }),
            "ode::Solution: no node with index " + count + ", there are " + count);
  EXPECT_EQ(refusal([&] { (void)solution.output(0); }), "ode::Solution: no output with index 0, there are 0");
  EXPECT_EQ(refusal([&] { (void)solution.segment_begin(2); }),
            "ode::Solution: no segment with index 2, there are 1");
}

}  // namespace
}  // namespace vectrix::ode::test::doors_test
