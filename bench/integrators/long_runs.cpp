/// Long runs at equal accuracy: a free body, a hub with panels, a body on an orbit.
#include <array>
#include <cstdio>
#include <string>
#include <vector>
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/craft/craft_core.hpp>

#include "bench/timing.hpp"
#include "engines.hpp"
#include "odeint.hpp"
#include "problems.hpp"
#include "sections.hpp"
#include "sundials.hpp"
#include "table.hpp"

namespace bench {
namespace {

/// Over `RungeKutta<Verner9, N>`.
struct Targets {
  double arkode, odeint, adams;
};

template <class P> std::vector<Row> rows_of(const P& problem, const Targets& over) {
  return {{{inlined_name<P>("Verner9"), stepped<ode::Verner9>(problem)}},
          {{inlined_name<P>("Verner7"), stepped<ode::Verner7>(problem)}},
          {{"`solve<" + std::to_string(P::size) + ">`, verner_9", solved_inlined(problem)}},
          {{"`solve`, verner_9", solved(problem, ode::Method::verner_9)}},
          {{"`solve`, verner_9, dense output", solved(problem, ode::Method::verner_9, true)}},
          {{"`propagate`, verner_9", propagated(problem, ode::Method::verner_9)}},
          {{"ARKODE, Fehlberg 7(8), called directly", called_directly<Arkode>(problem)}, over.arkode},
          {{"CVODE, Adams, called directly", called_directly<Adams>(problem)}, over.adams},
          {{"odeint, rkf78", odeint_rkf78(problem)}, over.odeint}};
}

template <class P> double nanoseconds_of_rates(P problem) {
  constexpr int calls = 20'000, rounds = 40;
  Numbers<P::size> y = problem.initial, ydot{};
  std::vector<double> ns;
  for (int round = 0; round < rounds; ++round) {
    ns.push_back(1e6 / calls * milliseconds([&] {
                   for (int i = 0; i < calls; ++i) {
                     problem(y.data(), ydot.data());
                     y[4] += 1e-12 * ydot[4];
                   }
                 }));
    keep(ydot);
  }
  return lower_quartile(ns);
}
/// What a step costs besides its evaluations, an evaluation.
template <class P> void print_overhead(const char* name, const P& problem, double target, Misses& misses) {
  constexpr double tolerance = 1e-10;
  constexpr int rounds = 9;
  const auto run = stepped<ode::Verner9>(problem);
  std::vector<double> whole, rates;
  for (int round = 0; round < rounds; ++round) {
    std::size_t evaluations = 0;
    auto again = run;
    const double ms = milliseconds([&] { evaluations = again(tolerance).evaluations; });
    whole.push_back(1e6 * ms / static_cast<double>(evaluations));
    rates.push_back(nanoseconds_of_rates(problem));
  }
  const double each = lower_quartile(whole), rate = lower_quartile(rates);
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %g |\n", name, P::size, rate, each, each - rate, target);
  if (each - rate <= target) return;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ": %.1f ns beyond the right-hand side, %g allowed", each - rate,
                target);
  misses.push_back(name + std::string(text.data()));
}

Attitude exact_attitude(const FreeBody& body) {
  const auto start = start_of(body);
  const State<Inertial, Hub> from{start.time(), quaternion(start.turning().rotation),
                                  start.turning().angular_velocity};
  const auto kg_m2 = si::kilogram_square_metre;
  const auto motion =
      torque_free(inertia_from_principal_moments(in<Hub>, 1.0 * kg_m2, 2.0 * kg_m2, 3.0 * kg_m2), from);
  return attitude(detail::quaternion_numbers(motion.at(body.end * si::second).R_i_from_b().matrix()));
}

}  // namespace

void print_long_runs() {
  constexpr int rounds = 9;
  const std::vector<double> errors{1e-6, 1e-9};
  const FreeBody free_body;
  const HubWithPanels<> panels(60.0, 0.05, 1000.0);
  const GravityGradient orbit;
  const Reference of_panels = reference(panels, 16'000), of_orbit = reference(orbit, 16'000);
  Misses misses;
  std::printf(
      "## The integrators on long runs\n\n"
      "Three crafts, g++, x86-64: each integrator calls the same right-hand side. Each row is the cheapest "
      "run "
      "whose attitude at the end is within the error; the tolerances tried, relative and absolute, are half "
      "a "
      "decade apart, because one tolerance means another error with another integrator. Times are of the "
      "processor, lower "
      "quartiles of interleaved rounds. `RungeKutta` and `solve<N>` inline the right-hand side; `solve` "
      "keeps "
      "all nodes, with dense output also the interpolant of each step; `propagate` runs the typed craft, "
      "whose "
      "loads are of the library.\n\n"
      "### A free body\n\nMoments (1, 2, 3) kg m^2, no torque, 4440 rad in 1e5 s, 7 states. The reference is "
      "the "
      "closed form.\n\n");
  print_at_equal_accuracy("free body", rows_of(free_body, {20.0, 2.0, 60.0}), exact_attitude(free_body),
                          errors, rounds, misses);
  std::printf(
      "\n### A hub with two panels on sprung, lightly damped hinges\n\n1000 s, 17 states. The reference is "
      "Fehlberg 7(8) "
      "with a fixed step in long double, which changes by %.0e rad when its step is doubled.\n\n",
      of_panels.doubt);
  print_at_equal_accuracy("hub with panels", rows_of(panels, {2.8, 1.25, 6.0}), of_panels.at_end, errors,
                          rounds, misses);
  std::printf(
      "\n### A body on an orbit, with the gravity gradient\n\n8 h, 13 states; the right-hand side is "
      "written by hand, that of `propagate` is the library's. The reference, as above, changes by %.0e "
      "rad.\n\n",
      of_orbit.doubt);
  print_at_equal_accuracy("orbit", rows_of(orbit, {10.0, 1.4, 30.0}), of_orbit.at_end, errors, 3 * rounds,
                          misses);
  std::printf(
      "\n### Beyond the right-hand side\n\n`RungeKutta<Verner9, N>` at a tolerance of 1e-10, ns an "
      "evaluation.\n\n| craft | states | right-hand side | whole run | difference | target |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  print_overhead("free body", free_body, 9.0, misses);
  print_overhead("hub with panels", panels, 45.0, misses);
  print_misses(misses);
}

}  // namespace bench
