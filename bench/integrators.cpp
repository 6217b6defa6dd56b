/// The integrators of the library compared with SUNDIALS called directly: a long run of a torque-free body,
/// and a controller that restarts every 0.1 s. Prints sections of docs/evidence/performance.md.
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <sundials/sundials_context.hpp>
#include <vector>
#include <vectrix/dynamics.hpp>
#include <vectrix/frames/scalar/larger.hpp>

#include "timing.hpp"

namespace bench {
namespace {

using namespace vectrix;
using Numbers = std::array<double, 7>;  // q_i_from_b, scalar first, then w_ib_b
using In = std::span<const double, 7>;
using Out = std::span<double, 7>;

struct Inertial : inertial_frame {};
struct Body : moving_frame {};

constexpr double end = 1e5;                                      // s
const Numbers initial{1.0, 0.0, 0.0, 0.0, 0.028, 0.024, 0.024};  // about 4440 rad until the end

/// Moments (1, 2, 3) kg m^2.
void free_body(const double* y, double* ydot) {
  const double p = y[4], q = y[5], r = y[6];
  ydot[0] = 0.5 * (-y[1] * p - y[2] * q - y[3] * r);
  ydot[1] = 0.5 * (y[0] * p + y[2] * r - y[3] * q);
  ydot[2] = 0.5 * (y[0] * q + y[3] * p - y[1] * r);
  ydot[3] = 0.5 * (y[0] * r + y[1] * q - y[2] * p);
  ydot[4] = -q * r;
  ydot[5] = r * p;
  ydot[6] = -p * q / 3.0;
}
constexpr auto rates = [](double, In y, Out ydot) { free_body(y.data(), ydot.data()); };
constexpr auto segment_rates = [](double, double, In y, Out ydot) { free_body(y.data(), ydot.data()); };

Quaternion<Inertial, Body> attitude(const Numbers& y) {
  const double norm = std::hypot(std::hypot(y[0], y[1]), std::hypot(y[2], y[3]));
  return quaternion_scalar_first(to<Inertial>, from<Body>, y[0] / norm, y[1] / norm, y[2] / norm,
                                 y[3] / norm);
}

Quaternion<Inertial, Body> exact_attitude() {
  const auto kg_m2 = si::kilogram_square_metre;
  const State<Inertial, Body> start{
      .time = 0.0 * si::second,
      .q_i_from_b = attitude(initial),
      .w_ib_b = angular_velocity(
          of<Body>, relative_to<Inertial>,
          vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(initial[4], initial[5], initial[6])))};
  return torque_free(inertia_from_principal_moments(in<Body>, 1.0 * kg_m2, 2.0 * kg_m2, 3.0 * kg_m2), start)
      .at(end * si::second)
      .q_i_from_b;
}

/// A state at the end and the number of evaluations.
struct Result {
  Numbers y;
  std::size_t evaluations;
};
using Engine = std::function<Result(double tolerance)>;

template <class Table> Result stepped(double tolerance) {
  Numbers absolute;
  absolute.fill(tolerance);
  std::size_t evaluations = 0;
  const auto counted = [&evaluations](double t, In y, Out ydot) {
    ++evaluations;
    rates(t, y, ydot);
  };
  ode::RungeKutta<Table, 7, decltype(counted)> method(counted, tolerance, absolute);
  method.start(0.0, initial);
  while (method.step(end) == ode::Advance::stepped) {
  }
  Result result{{}, evaluations};
  std::ranges::copy(method.state(), result.y.begin());
  return result;
}

ode::Problem problem_of(ode::Method method, double tolerance, double until) {
  ode::Problem problem;
  problem.initial_state.assign(initial.begin(), initial.end());
  problem.start = 0.0;
  problem.end = until;
  problem.relative_tolerance = tolerance;
  problem.absolute_tolerances.assign(7, tolerance);
  problem.method = method;
  problem.dense_output = false;
  return problem;
}

Result result_of(const ode::Solution& solution) {
  Result result{{}, solution.statistics().rhs_evaluations};
  std::ranges::copy(solution.node(solution.node_count() - 1).y, result.y.begin());
  return result;
}

const ode::RightHandSide by_function = [](double, double, std::span<const double> y, std::span<double> ydot) {
  free_body(y.data(), ydot.data());
};

Engine solved(ode::Method method, bool dense) {
  return [=](double tolerance) {
    ode::Problem problem = problem_of(method, tolerance, end);
    problem.dense_output = dense;
    problem.rhs = by_function;
    return result_of(ode::solve(problem));
  };
}

Result solved_inlined(double tolerance) {
  return result_of(ode::solve<7>(problem_of(ode::Method::verner_9, tolerance, end), segment_rates));
}

/// ARKODE's Fehlberg 7(8) alone, until its own end.
Result arkode(double tolerance) {
  const auto call = [](realtype, N_Vector y, N_Vector ydot, void*) {
    free_body(N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    return 0;
  };
  const sundials::Context context;
  const N_Vector y = N_VNew_Serial(7, context);
  std::ranges::copy(initial, N_VGetArrayPointer(y));
  void* memory = ARKStepCreate(call, nullptr, 0.0, y, context);
  ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, ARKODE_FEHLBERG_13_7_8);
  ARKStepSStolerances(memory, tolerance, tolerance);
  ARKStepSetMaxNumSteps(memory, 10'000'000);
  ARKStepSetStopTime(memory, end);
  double t = 0.0;
  const int flag = ARKStepEvolve(memory, end, y, &t, ARK_NORMAL);
  Result result{{}, 0};
  std::copy_n(N_VGetArrayPointer(y), 7, result.y.begin());
  if (flag < 0) result.y.fill(std::numeric_limits<double>::quiet_NaN());
  long explicit_calls = 0, implicit_calls = 0;
  ARKStepGetNumRhsEvals(memory, &explicit_calls, &implicit_calls);
  result.evaluations = static_cast<std::size_t>(explicit_calls);
  ARKStepFree(&memory);
  N_VDestroy(y);
  return result;
}

double milliseconds(const std::function<void()>& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct Row {
  std::string name;
  Engine engine;
  std::vector<double> ms = {};
  double tolerance = 0.0, error = std::numeric_limits<double>::infinity();
  std::size_t evaluations = 0;
};

/// The cheapest tolerance, half a decade apart, whose error is at most the target.
void find_tolerance(Row& row, double target, const Quaternion<Inertial, Body>& exact) {
  for (double tolerance = 1e-6; tolerance > 1e-15; tolerance /= std::sqrt(10.0)) {
    const Result result = row.engine(tolerance);
    const double error = std::isfinite(result.y[0])
                             ? log(inverse(before(attitude(result.y))) * exact).angle().value()
                             : INFINITY;
    if (!(error <= row.error)) continue;
    row.error = error;
    row.tolerance = tolerance;
    row.evaluations = result.evaluations;
    if (error <= target) return;
  }
}

void long_run() {
  const auto exact = exact_attitude();
  std::printf(
      "| error | integrator | tolerance | error reached, rad | evaluations | ms | ARKODE's time over it |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double target : {1e-6, 1e-9}) {
    std::vector<Row> rows{{"ARKODE, Fehlberg 7(8), called directly", arkode},
                          {"`RungeKutta<Verner9, 7>`", stepped<ode::Verner9>},
                          {"`RungeKutta<Verner7, 7>`", stepped<ode::Verner7>},
                          {"`solve<7>`, verner_9, nodes only", solved_inlined},
                          {"`solve`, verner_9, nodes only", solved(ode::Method::verner_9, false)},
                          {"`solve`, verner_9", solved(ode::Method::verner_9, true)},
                          {"`solve`, arkode_fehlberg_8", solved(ode::Method::arkode_fehlberg_8, true)}};
    for (Row& row : rows) find_tolerance(row, target, exact);
    constexpr int rounds = 7;
    for (int round = 0; round < rounds; ++round) {
      for (Row& row : rows) row.ms.push_back(milliseconds([&] { row.engine(row.tolerance); }));
    }
    const double reference = median(rows.front().ms);
    for (const Row& row : rows) {
      if (!(row.error <= target)) {
        std::printf("| %.0e rad | %s | not reached, at best | %.1e | %zu | %.2f | |\n", target,
                    row.name.c_str(), row.error, row.evaluations, median(row.ms));
        continue;
      }
      std::printf("| %.0e rad | %s | %.0e | %.1e | %zu | %.2f | %.1f |\n", target, row.name.c_str(),
                  row.tolerance, row.error, row.evaluations, median(row.ms), reference / median(row.ms));
    }
  }
}

/// 10 000 segments of 0.1 s, each with a constant torque of its own.
void short_segments() {
  constexpr std::size_t segments = 10'000;
  constexpr double length = 0.1, tolerance = 1e-9;
  double torque = 0.0;
  const auto torqued = [&torque](double, In y, Out ydot) {
    free_body(y.data(), ydot.data());
    ydot[4] += torque;
  };
  const auto by_steps = [&]<class Table>(Table) {
    Numbers absolute;
    absolute.fill(tolerance);
    ode::RungeKutta<Table, 7, decltype(torqued)> method(torqued, tolerance, absolute);
    Numbers y = initial;
    for (std::size_t i = 0; i < segments; ++i) {
      torque = i % 2 == 0 ? 1e-3 : -1e-3;
      const double t = length * static_cast<double>(i);
      method.start(t, y, method.next_step());
      while (method.step(t + length) == ode::Advance::stepped) {
      }
      std::ranges::copy(method.state(), y.begin());
    }
  };
  const auto by_solve = [&](ode::Method method) {
    ode::Problem problem = problem_of(method, tolerance, length * static_cast<double>(segments));
    for (std::size_t i = 1; i < segments; ++i) problem.breakpoints.push_back(length * static_cast<double>(i));
    problem.rhs = [&](double start, double, std::span<const double> y, std::span<double> ydot) {
      free_body(y.data(), ydot.data());
      ydot[4] += std::fmod(std::round(start / length), 2.0) == 0.0 ? 1e-3 : -1e-3;
    };
    (void)ode::solve(problem);
  };
  struct Segments {
    const char* name;
    std::function<void()> run;
    std::vector<double> ms = {};
  };
  std::vector<Segments> rows{
      {"`solve`, arkode_fehlberg_8", [&] { by_solve(ode::Method::arkode_fehlberg_8); }},
      {"`solve`, verner_7, nodes only", [&] { by_solve(ode::Method::verner_7); }},
      {"`RungeKutta<Verner9, 7>`", [&] { by_steps(ode::Verner9()); }},
      {"`RungeKutta<Verner7, 7>`", [&] { by_steps(ode::Verner7()); }}};
  constexpr int rounds = 7;
  for (int round = 0; round < rounds; ++round) {
    for (auto& row : rows) row.ms.push_back(milliseconds(row.run));
  }
  std::printf("| integrator | us a segment | the first row's time over it |\n| --- | --- | --- |\n");
  for (const auto& row : rows) {
    const double ms = median(row.ms);
    std::printf("| %s | %.2f | %.1f |\n", row.name, 1e3 * ms / static_cast<double>(segments),
                median(rows.front().ms) / ms);
  }
}

/// x'' = -2 z W x' - W^2 (x - cos t), W = 100 pi, z = 1 %, on its steady motion x = Re(G e^{it}), 100 s.
void stiff() {
  constexpr double W = 100.0 * std::numbers::pi, z = 0.01, duration = 100.0;
  const std::complex<double> gain = W * W / std::complex<double>(W * W - 1.0, 2.0 * z * W);
  const auto exact = [&](double t) { return gain * std::polar(1.0, t); };
  const auto run = [&](ode::Method method, double tolerance) {
    ode::Problem problem = problem_of(method, tolerance, duration);
    problem.initial_state = {exact(0.0).real(), -exact(0.0).imag()};
    problem.absolute_tolerances.assign(2, tolerance);
    problem.dense_output = true;
    problem.rhs = [](double, double t, std::span<const double> y, std::span<double> ydot) {
      ydot[0] = y[1];
      ydot[1] = -2.0 * z * W * y[1] - W * W * (y[0] - std::cos(t));
    };
    return ode::solve(problem);
  };
  const auto error_of = [&](const ode::Solution& solution) {
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = duration * i / 1000.0;
      largest = vectrix::detail::larger(largest, std::abs(solution.at(t)[0] - exact(t).real()));
    }
    return largest;
  };
  std::printf(
      "| error | integrator | tolerance | error reached | evaluations | ms |\n| --- | --- | --- | --- | --- "
      "| --- |\n");
  for (const double target : {1e-6, 1e-9}) {
    for (const auto& row :
         {std::pair{"radau_iia_7", ode::Method::radau_iia_7}, std::pair{"cvode_bdf", ode::Method::cvode_bdf},
          std::pair{"verner_7", ode::Method::verner_7}}) {
      for (double tolerance = 1e-4; tolerance > 1e-14; tolerance /= std::sqrt(10.0)) {
        const ode::Solution solution = run(row.second, tolerance);
        const double error = error_of(solution);
        if (!(error <= target)) continue;
        std::vector<double> ms;
        for (int round = 0; round < 5; ++round)
          ms.push_back(milliseconds([&] { (void)run(row.second, tolerance); }));
        std::printf("| %.0e | `solve`, %s | %.0e | %.1e | %zu | %.2f |\n", target, row.first, tolerance,
                    error, solution.statistics().rhs_evaluations, median(ms));
        break;
      }
    }
  }
}

}  // namespace
}  // namespace bench

int main() {
  std::printf(
      "## The integrators on a long run\n\n"
      "A torque-free body, moments (1, 2, 3) kg m^2, 4440 rad in 1e5 s, 7 states, g++, x86-64. Each row is "
      "the cheapest "
      "run whose attitude at the end is within the error of the exact motion; the tolerances tried are half "
      "a decade "
      "apart. Times are medians of interleaved rounds. `solve` keeps all nodes; with dense output it also "
      "keeps "
      "the interpolant of each step. `RungeKutta` and `solve<7>` inline the right-hand side.\n\n");
  bench::long_run();
  std::printf(
      "\n## A restart every 0.1 s\n\n"
      "The same body with a torque about x that changes every 0.1 s, as with a controller at 10 Hz, at a "
      "tolerance of 1e-9.\n\n");
  bench::short_segments();
  std::printf(
      "\n## A stiff mode\n\n"
      "A mode of 50 Hz with 1 %% of damping, driven slowly, for 100 s: the largest error of its deflection "
      "at 1001 "
      "times, relative to its size. The cheapest run of each integrator, medians of five.\n\n");
  bench::stiff();
}
