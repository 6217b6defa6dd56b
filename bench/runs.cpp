/// Whole runs of a torque-free body: compared with Simbody at equal accuracy, and the library's methods with
/// each other. Prints sections of docs/evidence/performance.md.
#include <algorithm>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <chrono>
#include <cstdio>
#include <optional>
#include <random>
#include <vectrix/dynamics.hpp>

#include "raw_kernels.hpp"
#include "simbody_reference.hpp"
#include "simbody_reference_rate.hpp"
#include "torque_free.hpp"
#include "typed_kernels.hpp"

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;
using Body = B;
using Inertial = A;

struct Run {
  double tolerance, error;
  std::size_t evaluations;
  double milliseconds = 0.0;
};

template <class Function> double milliseconds(const Function& function, int times) {
  std::vector<double> durations;
  for (int i = 0; i < times; ++i) {
    const auto start = Clock::now();
    function();
    durations.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::nth_element(durations.begin(), durations.begin() + times / 2, durations.end());
  return durations[static_cast<std::size_t>(times / 2)];
}

/// Runs with tolerances from 1e-3 down, half a decade per step, until the tightest target is met or the
/// method fails.
template <class Engine>
std::vector<Run> sweep(const Engine& engine, const Attitudes& exact, double tightest) {
  constexpr double least_tolerance = 1e-15;
  std::vector<Run> runs;
  for (double tolerance = 1e-3; tolerance > least_tolerance; tolerance /= std::sqrt(10.0)) {
    Attitudes attitudes;
    try {
      const std::size_t evaluations = engine(tolerance, attitudes);
      runs.push_back({tolerance, difference(attitudes, exact), evaluations});
    } catch (const std::exception&) {
      break;  // more steps than allowed, or a tolerance below rounding
    }
    if (runs.back().error <= tightest) break;
  }
  return runs;
}

/// The cheapest run that meets the target, with its time.
template <class Engine>
std::optional<Run> cheapest(const Engine& engine, const std::vector<Run>& runs, double target, int times) {
  std::optional<Run> best;
  for (const Run& run : runs) {
    if (run.error <= target && (!best || run.evaluations < best->evaluations)) best = run;
  }
  if (best) {
    best->milliseconds = milliseconds(
        [&] {
          Attitudes unused;
          engine(best->tolerance, unused);
        },
        times);
  }
  return best;
}

Inertia<Body> inertia(const Eigen::Vector3d& principal_moments) {
  const auto kg_m2 = [](double value) { return Quantity<si::moment_of_inertia>::from_value(value); };
  return inertia_from_principal_moments(in<Body>, kg_m2(principal_moments.x()), kg_m2(principal_moments.y()),
                                        kg_m2(principal_moments.z()));
}
State<Inertial, Body> start(const Eigen::Vector3d& w) {
  return {0.0 * si::second, quaternion(aligned(to<Inertial>, from<Body>)),
          angular_velocity(of<Body>, relative_to<Inertial>, vector<si::angular_velocity>(in<Body>, w))};
}
auto free_body() {
  return spacecraft(body(
      mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>),
                      inertia(moments)),
      turning_in<Inertial>));
}
using FreeBody = decltype(free_body());
CraftState<FreeBody> start_of(const FreeBody& craft) {
  const State<Inertial, Body> from = start(start_rate);
  return state(craft, from.time, MovingDcm{from.R_i_from_b(), from.w_ib_b});
}

auto vectrix_engine(ode::Method method, AttitudeState attitude) {
  return [=](double tolerance, Attitudes& attitudes) {
    const FreeBody craft = free_body();
    CraftPropagation how{
        .end = sample_times.back() * si::second,
        .relative_tolerance = tolerance,
        .absolute_tolerances = {tolerance * si::radian, tolerance * (si::radian / si::second),
                                1e-6 * si::metre, 1e-9 * (si::metre / si::second), 1e-12},
        .method = method,
        .max_steps = 200'000,
        .attitude = attitude};
    for (const double t : sample_times) how.output_times.push_back(t * si::second);
    const auto trajectory = propagate(scenario(craft), start_of(craft), how);
    for (const auto& now : trajectory.outputs()) attitudes.push_back(now.turning().rotation.matrix());
    return trajectory.solution().statistics().rhs_evaluations;
  };
}

auto simbody_engine(validation::SimbodyIntegrator integrator) {
  return [=](double tolerance, Attitudes& attitudes) {
    const validation::SimbodyBody body{
        .mass_kg = 1.0,
        .inertia_tensor_b = {moments.x(), 0, 0, 0, moments.y(), 0, 0, 0, moments.z()},
        .R_i_from_b = {1, 0, 0, 0, 1, 0, 0, 0, 1},
        .w_ib_b = {start_rate.x(), start_rate.y(), start_rate.z()},
        .orbit = std::nullopt,
        .pulses = {}};
    std::vector<double> times{0.0};
    times.insert(times.end(), sample_times.begin(), sample_times.end());
    const auto run = validation::simbody_propagate(body, tolerance, times, integrator);
    for (std::size_t i = 1; i < run.samples.size(); ++i)
      attitudes.push_back(
          Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(run.samples[i].R_i_from_b.data()));
    return static_cast<std::size_t>(run.rhs_evaluations);
  };
}

void right_hand_sides() {
  const std::array<double, 7> y{1.0, 0.0, 0.0, 0.0, start_rate.x(), start_rate.y(), start_rate.z()};
  const raw::Inertia raw_J{moments.asDiagonal(), moments.cwiseInverse().asDiagonal()};
  const FreeBody craft = free_body();
  detail::CraftRates<FreeBody> ours(craft);
  const raw::Attitude attitude = raw::Attitude::quaternion;
  validation::SimbodyRate simbody;
  std::array<double, 7> ydot;
  constexpr int calls = 20'000;
  constexpr int rounds = 51;
  const auto nanoseconds = [&](const auto& call) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) {
      call();
      asm volatile("" : : "r"(ydot.data()) : "memory");
    }
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls;
  };
  std::array<std::vector<double>, 3> ns;
  for (int round = 0; round < rounds; ++round) {  // interleaved, so that a slow machine slows all three
    ns[0].push_back(nanoseconds([&] { ours(0.0, y.data(), ydot.data()); }));
    ns[1].push_back(nanoseconds([&] { raw::body_rate(attitude, raw_J, y, ydot); }));
    ns[2].push_back(nanoseconds([&] { simbody.evaluate({y[0], y[1], y[2], y[3]}, {y[4], y[5], y[6]}); }));
  }
  std::printf("| right-hand side | ns a call | times ours |\n| --- | --- | --- |\n");
  const std::array names{"a craft of one body", "raw Eigen", "Simbody, `realize(Acceleration)`"};
  for (auto& list : ns) std::nth_element(list.begin(), list.begin() + rounds / 2, list.end());
  for (std::size_t i = 0; i < 3; ++i)
    std::printf("| %s | %.1f | %.2f |\n", names[i], ns[i][rounds / 2], ns[i][rounds / 2] / ns[0][rounds / 2]);
}

void row(const char* target, const char* name, const std::optional<Run>& run, double ours) {
  if (!run) {
    std::printf("| %s | %s | not reached | | | | |\n", target, name);
    return;
  }
  std::printf("| %s | %s | %.0e | %.1e | %zu | %.2f | %.1f |\n", target, name, run->tolerance, run->error,
              run->evaluations, run->milliseconds, run->milliseconds / ours);
}

void against_simbody(const Attitudes& exact) {
  std::printf(
      "| error | engine | tolerance | error reached, rad | evaluations | ms | times ours |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  const auto ours = vectrix_engine(ode::Method::verner_9, AttitudeState::quaternion);
  const auto merson = simbody_engine(validation::SimbodyIntegrator::runge_kutta_merson);
  const auto feldberg = simbody_engine(validation::SimbodyIntegrator::runge_kutta_feldberg);
  const auto our_runs = sweep(ours, exact, 1e-9);
  const auto merson_runs = sweep(merson, exact, 1e-9);
  const auto feldberg_runs = sweep(feldberg, exact, 1e-9);
  for (const auto& [target, label] : {std::pair{1e-6, "1e-6 rad"}, std::pair{1e-9, "1e-9 rad"}}) {
    const auto best = cheapest(ours, our_runs, target, 21);
    row(label, "Vectrix, default", best, best->milliseconds);
    row(label, "Simbody, Merson", cheapest(merson, merson_runs, target, 3), best->milliseconds);
    row(label, "Simbody, Feldberg", cheapest(feldberg, feldberg_runs, target, 3), best->milliseconds);
  }
}

void work_precision(const Attitudes& exact) {
  const std::array methods{std::pair{"cvode_adams", ode::Method::cvode_adams},
                           std::pair{"cvode_bdf", ode::Method::cvode_bdf},
                           std::pair{"arkode_dormand_prince_5", ode::Method::arkode_dormand_prince_5},
                           std::pair{"arkode_fehlberg_8", ode::Method::arkode_fehlberg_8},
                           std::pair{"verner_9", ode::Method::verner_9},
                           std::pair{"verner_7", ode::Method::verner_7},
                           std::pair{"radau_iia_7", ode::Method::radau_iia_7}};
  const std::array targets{1e-6, 1e-9, 1e-12};
  std::printf("| method | attitude | 1e-6 rad | 1e-9 rad | 1e-12 rad |\n| --- | --- | --- | --- | --- |\n");
  std::array<std::pair<double, std::string>, 3> fastest;
  fastest.fill({std::numeric_limits<double>::infinity(), ""});
  for (const auto& [method_name, method] : methods) {
    for (const auto attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
      const char* attitude_name = attitude == AttitudeState::quaternion ? "quaternion" : "DCM";
      const auto engine = vectrix_engine(method, attitude);
      const auto runs = sweep(engine, exact, targets.back());
      std::printf("| %s | %s |", method_name, attitude_name);
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto run = cheapest(engine, runs, targets[i], 21);
        if (!run) {
          std::printf(" not reached |");
          continue;
        }
        std::printf(" %zu, %.2f ms |", run->evaluations, run->milliseconds);
        const std::string name = std::string{method_name} + ", " + attitude_name;
        fastest[i] = std::min(fastest[i], std::pair{run->milliseconds, name});
      }
      std::printf("\n");
    }
  }
  std::printf(
      "\nThe fastest to 1e-6, 1e-9 and 1e-12 rad: %s; %s; %s. The default is verner_9, "
      "quaternion.\n",
      fastest[0].second.c_str(), fastest[1].second.c_str(), fastest[2].second.c_str());
}

/// Compared with Boost.Math's three Jacobi functions, which give the rate alone.
void closed_form() {
  constexpr std::size_t count = 1000;
  constexpr int rounds = 101;
  constexpr double longest = 1e5;
  std::mt19937_64 random(20240229);
  std::vector<double> times(count);
  for (double& t : times) t = std::uniform_real_distribution<double>(0.0, longest)(random);
  const auto nanoseconds = [&](const auto& call) {
    const auto start = Clock::now();
    for (const double t : times) {
      const auto result = call(t);
      asm volatile("" : : "r"(&result) : "memory");
    }
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / count;
  };

  struct Motion {
    const char* name;
    Eigen::Vector3d moments, w;
  };
  const std::array<Motion, 4> motions{{{"three moments, (1, 2, 3) kg m^2", moments, start_rate},
                                       {"near the separatrix, (1, 2, 3) kg m^2", moments, {1e-4, 1.0, 1e-4}},
                                       {"a symmetric body, (1, 1, 2) kg m^2", {1.0, 1.0, 2.0}, start_rate},
                                       {"a ball, (1, 1, 1) kg m^2", {1.0, 1.0, 1.0}, start_rate}}};
  std::vector<TorqueFree<Inertial, Body>> bodies;
  for (const Motion& motion : motions) {
    bodies.push_back(torque_free(inertia(motion.moments), start(motion.w)));
  }
  constexpr double modulus = 0.6;
  std::array<std::vector<double>, motions.size() + 1> ns;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      ns.at(i).push_back(nanoseconds([&](double t) { return bodies[i].at(t * si::second); }));
    ns.back().push_back(nanoseconds([](double t) {
      std::array<double, 3> functions;
      functions[0] = boost::math::jacobi_elliptic(modulus, t, &functions[1], &functions[2]);
      return functions;
    }));
  }
  for (auto& list : ns) std::nth_element(list.begin(), list.begin() + rounds / 2, list.end());
  std::printf("| closed form | ns a time | times ours |\n| --- | --- | --- |\n");
  const auto row = [&](const char* name, std::size_t i) {
    std::printf("| %s | %.0f | %.2f |\n", name, ns.at(i)[rounds / 2],
                ns.at(i)[rounds / 2] / ns[0][rounds / 2]);
  };
  for (std::size_t i = 0; i < motions.size(); ++i) row(motions.at(i).name, i);
  row("Boost.Math, `jacobi_elliptic`: sn, cn and dn alone", motions.size());
}

}  // namespace
}  // namespace bench

int main() {
  using namespace bench;
  const Attitudes exact = reference(4000);
  const double doubt = difference(exact, reference(2000));
  std::printf(
      "## The free body\n\n"
      "Moments (1, 2, 3) kg m^2, no torque, g++, x86-64. Times are medians of interleaved rounds.\n\n");
  right_hand_sides();
  std::printf(
      "\n## The exact motion of the free body\n\n"
      "`torque_free(...).at(t)`: attitude and rate at random times within 1e5 s, medians of interleaved "
      "rounds.\n\n");
  closed_form();
  std::printf(
      "\n## A whole run at equal accuracy\n\n"
      "The same body for 100 s, about 110 rad. The error is the "
      "largest angle from a reference at 20, 40, 60, 80 and 100 s. The reference is a Runge-Kutta run in "
      "long double, which changes by %.0e rad when its step is doubled. Each row is the cheapest run of an "
      "engine that reaches the error; the tolerances tried are half a decade apart.\n\n",
      doubt);
  against_simbody(exact);
  std::printf(
      "\n## Work and precision of the methods\n\n"
      "The same run: the number of evaluations of the right-hand "
      "side and the time of the cheapest run that reaches the error, with at most 200 000 steps.\n\n");
  work_precision(exact);
}
