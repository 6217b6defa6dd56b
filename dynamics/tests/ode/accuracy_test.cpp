#include <array>
#include <complex>
#include <limits>

#include "problems.hpp"
#include "testing/free_body.hpp"

namespace vectrix::ode::test::accuracy_test {
namespace {

class OdeAccuracy : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeAccuracy, testing::ValuesIn(methods), name);

/// The largest allowed ratio of error to tolerance over the runs below, about three times the measured one
/// (BDF, of order 5, drifts most): methods that go on with the better of two solutions are far below the sum
/// of their tolerances.
double most(Method method) {
  switch (method) {
    case Method::cvode_adams:
      return 2e4;
    case Method::cvode_bdf:
      return 2e5;
    case Method::arkode_dormand_prince_5:
      return 3e3;
    case Method::arkode_fehlberg_8:
    case Method::verner_9:
    case Method::verner_7:
    case Method::radau_iia_7:
      return 1e3;
  }
  return 0.0;
}

constexpr double tolerance = 1e-10;

/// The tolerance bounds the error of one step, to tolerance (1 + |y|) in each component. Such errors, of all
/// steps, add up, each grown by a factor of the problem.
double gathered(Method method, const Solution& solution, double growth) {
  const auto steps = static_cast<double>(solution.statistics().steps);
  return std::min(growth * steps, most(method)) * tolerance;
}

TEST_P(OdeAccuracy, harmonic_oscillator) {
  const Solution solution = solve(oscillator(GetParam(), 100.0, tolerance));
  constexpr double growth = 3.0;  // none, of two components with |y| <= 1 each
  EXPECT_LT(node_error(solution, oscillator_state), gathered(GetParam(), solution, growth));
  EXPECT_EQ(solution.end(), 100.0);
}

/// Torque-free body with J = diag(a, a, c): h = J w is fixed in space, and the body turns about h at h/a and
/// about its own axis at n (1 - c/a):  q(t) = exp(t h / 2a) exp(t n (1 - c/a) e3 / 2),  Hamilton, body to
/// inertial.
TEST_P(OdeAccuracy, torque_free_axisymmetric_body) {
  constexpr double a = 2.0, c = 3.0, n = 1.0, transverse = 0.4;
  Problem problem;
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    vectrix_test::free_body({a, a, c}, y.first<7>(), ydot.first<7>());
  };
  problem.initial_state = {1.0, 0.0, 0.0, 0.0, transverse, 0.0, n};
  problem.start = 0.0;
  problem.end = 100.0;
  problem.method = GetParam();
  set_tolerance(problem, tolerance);

  const auto exact = [](double t) -> std::vector<double> {
    const double hx = a * transverse, hz = c * n, h = std::hypot(hx, hz);
    const double half = 0.5 * t * h / a;  // p = exp(t h / 2a)
    const double p0 = std::cos(half), px = std::sin(half) * hx / h, pz = std::sin(half) * hz / h;
    const double spin = 0.5 * t * n * (1.0 - c / a);  // s = exp(spin e3)
    const double s0 = std::cos(spin), sz = std::sin(spin);
    const double lambda = (c - a) / a * n;
    return {p0 * s0 - pz * sz,
            px * s0,
            -px * sz,
            p0 * sz + pz * s0,
            transverse * std::cos(lambda * t),
            transverse * std::sin(lambda * t),
            n};
  };
  constexpr double growth = 2.0 * (1.0 + 0.5 * 100.0);  // half an error of the rate, for 100 s
  const Solution solution = solve(problem);
  EXPECT_LT(node_error(solution, exact), gathered(GetParam(), solution, growth));
}

/// Kepler ellipse, mu = a = 1, e = 1/2, five revolutions: the step size must change near the pericentre.
TEST_P(OdeAccuracy, kepler_ellipse) {
  constexpr double e = 0.5;
  Problem problem;
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    const double r = std::hypot(y[0], y[1]), r3 = r * r * r;
    ydot[0] = y[2];
    ydot[1] = y[3];
    ydot[2] = -y[0] / r3;
    ydot[3] = -y[1] / r3;
  };
  problem.initial_state = {1.0 - e, 0.0, 0.0, std::sqrt((1.0 + e) / (1.0 - e))};
  problem.start = 0.0;
  problem.end = 10.0 * std::numbers::pi;
  problem.method = GetParam();
  set_tolerance(problem, tolerance);

  const auto exact = [](double t) -> std::vector<double> {
    double anomaly = t;  // E - e sin E = t by Newton's iteration
    for (int i = 0; i < 20; ++i)
      anomaly -= (anomaly - e * std::sin(anomaly) - t) / (1.0 - e * std::cos(anomaly));
    const double b = std::sqrt(1.0 - e * e), r = 1.0 - e * std::cos(anomaly);
    return {std::cos(anomaly) - e, b * std::sin(anomaly), -std::sin(anomaly) / r, b * std::cos(anomaly) / r};
  };
  // An error dv of the speed v <= 3^(1/2) changes the phase by 3 v dv t, of a place that moves at v.
  constexpr double growth = 2.7 * 3.0 * 3.0 * 10.0 * std::numbers::pi;
  const Solution solution = solve(problem);
  EXPECT_LT(node_error(solution, exact), gathered(GetParam(), solution, growth));
}

/// x' = -x + sin t: the rate depends on time, so errors of the time matter.
TEST_P(OdeAccuracy, forced_relaxation) {
  Problem problem = oscillator(GetParam(), 50.0, tolerance);
  problem.rhs = [](double, double t, State y, std::span<double> ydot) { ydot[0] = -y[0] + std::sin(t); };
  problem.initial_state = {0.0};
  set_tolerance(problem, tolerance);
  const auto exact = [](double t) -> std::vector<double> {
    return {0.5 * (std::sin(t) - std::cos(t) + std::exp(-t))};
  };
  constexpr double growth = 2.0;  // none, of a component with |y| <= 1: errors decay
  const Solution solution = solve(problem);
  EXPECT_LT(node_error(solution, exact), gathered(GetParam(), solution, growth));
}

TEST_P(OdeAccuracy, error_falls_with_the_tolerance) {
  double previous = 1.0;
  for (const double t : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const double error = node_error(solve(oscillator(GetParam(), 30.0, t)), oscillator_state);
    constexpr double fall = 0.2;  // ideally a hundredth, the tolerance's; with the steps of each, at random
    EXPECT_LT(error, fall * previous) << "tolerance " << t;
    previous = error;
  }
}

/// Of the errors between nodes to those at nodes.
constexpr double as_good = 1.1;

TEST_P(OdeAccuracy, dense_output_is_as_good_as_the_nodes) {
  for (const double t : {1e-8, 1e-12}) {
    const Solution solution = solve(oscillator(GetParam(), 30.0, t));
    double between = 0.0;
    for (std::size_t i = 0; i + 1 < solution.node_count(); ++i) {
      const double left = solution.node(i).t, right = solution.node(i + 1).t;
      for (const double part : {0.1, 0.5, 0.8}) {
        const double time = left + part * (right - left);
        between = vectrix::detail::larger(between, distance(solution.at(time), oscillator_state(time)));
      }
    }
    // The nodes of Radau IIA, of order 13, are far better than the tolerance; its polynomial, of order 7, is
    // not.
    const double expected =
        GetParam() == Method::radau_iia_7 ? t : as_good * node_error(solution, oscillator_state);
    EXPECT_LT(between, expected) << "tolerance " << t;
  }
}

TEST_P(OdeAccuracy, rates_of_nodes_are_those_of_the_right_hand_side) {
  const Solution solution = solve(oscillator(GetParam(), 30.0, tolerance));
  for (std::size_t i = 0; i < solution.node_count(); ++i) {
    const Node node = solution.node(i);
    const std::array rate{node.y[1], -node.y[0]};
    // Of CVODE's polynomial: an error of the tolerance over the length of the step. The first is very short.
    constexpr double most_of_slope = 1e3 * tolerance;
    const bool is_slope = i > 0 && (GetParam() == Method::cvode_adams || GetParam() == Method::cvode_bdf);
    const double allowed =
        is_slope ? std::min(2.0 * tolerance / (node.t - solution.node(i - 1).t), most_of_slope) : 0.0;
    EXPECT_LE(distance(node.ydot, rate), allowed);
  }
}

TEST_P(OdeAccuracy, dense_output_survives_crowded_nodes) {
  // A pulse in the middle makes the integrator restart with steps thousands of times shorter than their
  // neighbours.
  Problem problem = oscillator(GetParam(), 10.0, 1e-12);
  problem.breakpoints = {5.0};
  const Solution solution = solve(problem);
  const double allowed =
      GetParam() == Method::radau_iia_7 ? 1e-12 : as_good * node_error(solution, oscillator_state);
  for (int i = 0; i <= 20'000; ++i) {
    const double t = 4.99 + 1e-6 * i;
    ASSERT_LE(distance(solution.at(t), oscillator_state(t)), allowed) << t;
  }
}

/// With tolerances that accept every step, all steps have the maximum length: error(h) / error(h / 2) =
/// 2^order.
TEST(OdeOrder, runge_kutta_tables_converge_with_their_order) {
  constexpr double end = 8.0;
  const auto error = [&](Method method, double step) {
    Problem problem = oscillator(method, end, 1e6);
    problem.maximum_step = step;
    const Solution solution = solve(problem);
    EXPECT_LE(solution.statistics().steps,
              static_cast<std::size_t>(end / step) + 5);  // plus a few shorter steps at the start
    return distance(solution.at(end), oscillator_state(end));
  };
  constexpr double slack = 0.3;  // because of the higher terms; measured within 0.15 of the order
  EXPECT_NEAR(std::log2(error(Method::arkode_dormand_prince_5, 0.125) /
                        error(Method::arkode_dormand_prince_5, 0.0625)),
              5.0, slack);
  EXPECT_NEAR(std::log2(error(Method::arkode_fehlberg_8, 0.5) / error(Method::arkode_fehlberg_8, 0.25)), 8.0,
              slack);
}

/// After some ten thousand steps, SUNDIALS' own clock is wrong, and the states would be wrong by 1e-10.
TEST(OdeClock, rounding_of_time_does_not_gather) {
  Problem problem = oscillator(Method::arkode_fehlberg_8, 1000.0, 1e-14);
  problem.maximum_step = 0.09;
  const Solution solution = solve(problem);
  // Roundings of the states, 1e-16 in each of 17 000 steps, and of the node times, 6e-14.
  constexpr double rounded = 2e-12;
  EXPECT_LT(node_error(solution, oscillator_state), rounded);
}

/// Thirteen stages a step: the rate at a node is the first stage of the next step, so it is not evaluated
/// twice.
TEST(OdeCost, fehlberg_8_takes_thirteen_evaluations_a_step) {
  const Statistics run = solve(oscillator(Method::arkode_fehlberg_8, 100.0, 1e-10)).statistics();
  EXPECT_LE(run.rhs_evaluations,
            13 * (run.steps + run.error_test_failures) + 10);  // plus the choice of the first step
}

class OdeStiff : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, OdeStiff, testing::Values(Method::cvode_bdf, Method::radau_iia_7), name);

TEST_P(OdeStiff, takes_long_steps_where_explicit_methods_cannot) {
  // x' = -1e6 (x - cos t) from 0: after microseconds x follows cos t + 1e-6 sin t.
  constexpr double coarse = 1e-8;
  Problem problem = oscillator(GetParam(), 10.0, coarse);
  problem.rhs = [](double, double t, State y, std::span<double> ydot) {
    ydot[0] = -1e6 * (y[0] - std::cos(t));
  };
  problem.initial_state = {0.0};
  set_tolerance(problem, coarse);
  const Solution solution = solve(problem);
  // (1 + |y|) at a node and as much between, as errors decay at once; BDF estimates its own to a factor of
  // two.
  constexpr double within = 8.0 * coarse;
  EXPECT_LT(solution.statistics().steps, 2000U);  // an explicit method needs 1e6 * 10 / 3
  for (int i = 1; i <= 1000; ++i) {
    const double t = 0.01 * i;
    ASSERT_NEAR(solution.at(t)[0], std::cos(t) + 1e-6 * std::sin(t), within);
  }
}

/// A mode of 50 Hz with 1 % of damping, driven by cos t: in steady state x = Re(G e^{it}),
/// G = W^2 / (W^2 - 1 + 2 i z W). BDF stalls here; an explicit method needs a step below 1 / W, 30 000 of
/// them.
TEST(OdeRadau, passes_over_a_lightly_damped_mode) {
  constexpr double W = 100.0 * std::numbers::pi, z = 0.01, tight = 1e-9;
  const std::complex<double> gain = W * W / std::complex<double>(W * W - 1.0, 2.0 * z * W);
  const auto exact = [&](double t) -> std::vector<double> {
    const std::complex<double> x = gain * std::polar(1.0, t);
    return {x.real(), -x.imag()};
  };
  Problem problem = oscillator(Method::radau_iia_7, 100.0, tight);
  problem.rhs = [&](double, double t, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = -2.0 * z * W * y[1] - W * W * (y[0] - std::cos(t));
  };
  problem.initial_state = exact(0.0);
  const Solution solution = solve(problem);
  EXPECT_LT(solution.statistics().steps, 1000U);
  constexpr double within = 10.0 * tight;  // an error decays in 1 / (z W) = 0.3 s, of some two or three steps
  EXPECT_LT(node_error(solution, exact), within);
  for (double t = 0.0; t <= 100.0; t += 0.37) EXPECT_LT(std::abs(solution.at(t)[0] - exact(t)[0]), within);
}

/// x' = 0, then x' = 1 - e^x from -3: e^-x = 1 + (e^3 - 1) e^-t. The step carried into the second segment is
/// so long that differences for the Jacobian as large as h f would overflow.
TEST(OdeRadau, a_step_carried_over_a_breakpoint_is_shortened_until_it_fits) {
  constexpr double rest = 1e13;
  Problem problem = oscillator(Method::radau_iia_7, 2.0 * rest, 1e-9);
  problem.rhs = [](double segment_start, double, State y, std::span<double> ydot) {
    ydot[0] = segment_start == rest ? 1.0 - std::exp(y[0]) : 0.0;
  };
  problem.initial_state = {-3.0};
  problem.breakpoints = {rest};
  set_tolerance(problem, 1e-9);
  const Solution solution = solve(problem);
  constexpr double within = 20 * (1.0 + 3.0) * 1e-9;  // of some 20 steps; |x| <= 3
  for (const double t : {0.5, 3.0, 20.0}) {           // multiples of the rounding of time, 2 ms
    const double exact = -std::log1p(std::expm1(3.0) * std::exp(-t));
    EXPECT_NEAR(solution.at(rest + t)[0], exact, within) << t;
  }
}

/// Robertson's reactions, rates 0.04, 3e7 and 1e4, keep the sum of their three states; the first two decay
/// slowly. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, equation IV.1.4.
TEST(OdeRadau, goes_through_eleven_decades_of_time_with_robertsons_reactions) {
  Problem problem = oscillator(Method::radau_iia_7, 1e8, 1e-9);
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    ydot[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
    ydot[2] = 3e7 * y[1] * y[1];
    ydot[1] = -ydot[0] - ydot[2];
  };
  problem.initial_state = {1.0, 0.0, 0.0};
  problem.absolute_tolerances.assign(3, 1e-14);
  const Solution solution = solve(problem);
  EXPECT_LT(solution.statistics().steps, 300U);
  const std::vector<double> y = solution.at(1e8);
  constexpr double rounded = 300 * 7 * 2.0 * std::numeric_limits<double>::epsilon();  // steps of seven stages
  EXPECT_NEAR(y[0] + y[1] + y[2], 1.0, rounded);
  // The slow manifold, less 3e7 y1^2 for y1 = 8e-11: 3e-7 of it. Half of the absolute tolerance, 1e-14, of
  // y1.
  constexpr double of_manifold = 1e-4;
  EXPECT_NEAR(0.04 * y[0], 1e4 * y[1] * y[2], of_manifold * 0.04 * y[0]);
  problem.method = Method::cvode_bdf;
  const Solution bdf = solve(problem);
  constexpr double of_bdf = 1e-6;  // 1e-9 of y in each of some thousand steps
  for (const double t : {1.0, 1e4}) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(solution.at(t)[c], bdf.at(t)[c], of_bdf * bdf.at(t)[c]) << t;
  }
}

}  // namespace
}  // namespace vectrix::ode::test::accuracy_test
