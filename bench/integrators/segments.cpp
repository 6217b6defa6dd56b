/// A controller at 10 Hz: a restart every 0.1 s, because the torque jumps.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <tuple>
#include <vector>
#include <vectrix/dynamics.hpp>

#include "engines.hpp"
#include "odeint.hpp"
#include "problems.hpp"
#include "sections.hpp"
#include "sundials.hpp"
#include "table.hpp"

namespace bench {
namespace {

constexpr double length = 0.1;  // s
constexpr double same_tolerance = 1e-9;

double start_of_segment(std::size_t segment) {
  return length * static_cast<double>(segment);
}

/// What changes the torque, and the problem that reads it.
template <class P> struct Controlled {
  double& torque;
  P problem;
  std::size_t segments;
  double newton_metres;

  void set_torque(std::size_t segment) const { torque = segment % 2 == 0 ? newton_metres : -newton_metres; }
};

template <class Table, class P> Attitude stepped(const Controlled<P>& run, double longest = INFINITY) {
  P own = run.problem;
  const auto rates = [&](double, std::span<const double, P::size> y, std::span<double, P::size> ydot) {
    own(y.data(), ydot.data());
  };
  ode::RungeKutta<Table, P::size, decltype(rates)> method(rates, same_tolerance,
                                                          all<P::size>(same_tolerance));
  Numbers<P::size> y = own.initial;
  for (std::size_t i = 0; i < run.segments; ++i) {
    run.set_torque(i);
    method.start(start_of_segment(i), y, method.next_step());
    while (method.step(start_of_segment(i + 1), longest) == ode::Advance::stepped) {
    }
    std::ranges::copy(method.state(), y.begin());
  }
  return attitude(y);
}

template <class P> Attitude solved(const Controlled<P>& run, ode::Method method) {
  ode::Problem problem = ode_problem(run.problem, method, same_tolerance);
  problem.end = start_of_segment(run.segments);
  for (std::size_t i = 1; i < run.segments; ++i) problem.breakpoints.push_back(start_of_segment(i));
  std::size_t next = 0;
  problem.at_segment_start = [&](double, std::span<double>, std::span<const ode::Event>) {
    run.set_torque(next++);
  };
  problem.rhs = [own = run.problem](double, double, std::span<const double> y,
                                    std::span<double> ydot) mutable { own(y.data(), ydot.data()); };
  return result_of(ode::solve(problem)).at_end;
}

struct Command {
  double torque;
};
template <class P> Attitude propagated(const Controlled<P>& run, ode::Method method) {
  const auto craft = run.problem.craft();
  using Craft = std::remove_const_t<decltype(craft)>;
  const auto motor = [](const Now<Craft>&, Forces<Craft>& forces, const Command& command) {
    forces.torque(of<Hub>, command.torque * si::newton_metre * unit_x(in<Hub>));
  };
  const auto controller = [](const Now<Craft>&, const Command& last) { return Command{-last.torque}; };
  const auto flight = std::apply(
      [&](const auto&... load) {
        return scenario(craft, load..., motor, held(Command{-run.newton_metres}),
                        every(length * si::second, controller));
      },
      run.problem.loads());
  auto how = propagation(run.problem, method, same_tolerance);
  how.end = start_of_segment(run.segments) * si::second;
  return result_of(propagate(flight, start_of(run.problem), how).solution()).at_end;
}

template <template <class> class Peer, class P> Attitude called_directly(const Controlled<P>& run) {
  P own = run.problem;
  Peer<P> peer(own, same_tolerance);
  for (std::size_t i = 0; i < run.segments; ++i) {
    run.set_torque(i);
    if (i > 0) peer.restart();
    peer.run_to(start_of_segment(i + 1));
  }
  return peer.result().at_end;
}

template <class P> Attitude odeint_rkf78(const Controlled<P>& run) {
  P own = run.problem;
  const auto rates = [&](const Numbers<P::size>& y, Numbers<P::size>& ydot, double) {
    own(y.data(), ydot.data());
  };
  Numbers<P::size> y = own.initial;
  const auto stepper = odeint::make_controlled(same_tolerance, same_tolerance, Fehlberg78<P::size>());
  for (std::size_t i = 0; i < run.segments; ++i) {
    run.set_torque(i);
    odeint::integrate_adaptive(stepper, rates, y, start_of_segment(i), start_of_segment(i + 1), length);
  }
  return attitude(y);
}

struct Timed {
  std::string name;
  std::function<Attitude()> run;
  double target = 0.0;
  std::vector<double> ms = {};
};

template <class P>
void print_segments_of(const char* craft, const Controlled<P>& run, double target, Misses& misses) {
  constexpr int rounds = 9;
  std::vector<Timed> rows{
      {inlined_name<P>("Verner7"), [&] { return stepped<ode::Verner7>(run); }},
      {inlined_name<P>("Verner9"), [&] { return stepped<ode::Verner9>(run); }},
      {"`solve`, verner_7", [&] { return solved(run, ode::Method::verner_7); }},
      {"`propagate`, verner_7", [&] { return propagated(run, ode::Method::verner_7); }},
      {"`solve`, arkode_fehlberg_8", [&] { return solved(run, ode::Method::arkode_fehlberg_8); }, target},
      {"ARKODE, Fehlberg 7(8), called directly", [&] { return called_directly<Arkode>(run); }},
      {"CVODE, Adams, called directly", [&] { return called_directly<Adams>(run); }},
      {"odeint, rkf78", [&] { return odeint_rkf78(run); }}};
  constexpr double short_step = length / 8;
  const Attitude exact = stepped<ode::Verner9>(run, short_step);
  for (int round = 0; round < rounds; ++round)
    for (Timed& row : rows) row.ms.push_back(milliseconds([&] { (void)row.run(); }));
  for (const Timed& row : rows) {
    const double ms = lower_quartile(row.ms);
    std::printf("| %s | %s | %.1e | %.3g |", craft, row.name.c_str(), angle_between(row.run(), exact),
                1e3 * ms / static_cast<double>(run.segments));
    compare(ms / lower_quartile(rows.front().ms), row.target, std::string(craft) + ", " + row.name, misses);
  }
}

}  // namespace

void print_segments() {
  constexpr std::size_t of_body = 10'000, of_panels = 1000;
  double torque = 0.0;
  const Controlled<ControlledFreeBody> body{torque, ControlledFreeBody(&torque), of_body, 1e-3};
  const Controlled<HubWithPanels<Motor>> panels{
      torque, HubWithPanels<Motor>(60.0, 0.05, 1000.0, Motor{&torque}), of_panels, 1.0};
  Misses misses;
  std::printf(
      "\n## A restart every 0.1 s\n\n"
      "The free body and the hub with panels, with a torque about x that changes every 0.1 s, as with a "
      "controller at 10 Hz, for %zu and %zu segments. All have the tolerance %.0e, with which each has an "
      "error of its own: that at "
      "the end, from a run of Verner9 with eight steps or more a segment. SUNDIALS and odeint begin each "
      "segment anew.\n\n"
      "| craft | integrator | error, rad | us a segment | over the first | target |\n"
      "| --- | --- | --- | --- | --- | --- |\n",
      of_body, of_panels, same_tolerance);
  print_segments_of("free body", body, 150.0, misses);
  print_segments_of("hub with panels", panels, 20.0, misses);
  print_misses(misses);
}

}  // namespace bench
