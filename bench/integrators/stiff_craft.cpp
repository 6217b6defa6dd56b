/// A hub with panels that are stiff: 50 Hz, 1 % of damping.
#include <cstdio>
#include <numbers>
#include <vector>
#include <vectrix/dynamics.hpp>

#include "engines.hpp"
#include "odeint.hpp"
#include "problems.hpp"
#include "sections.hpp"
#include "sundials.hpp"
#include "table.hpp"

namespace bench {

void print_stiff_craft() {
  constexpr double W = 100.0 * std::numbers::pi, damping_ratio = 0.01, inertia = 60.0, duration = 100.0;
  constexpr double target = 20.0;
  constexpr int steps = 40'000, rounds = 5;
  const HubWithPanels<> panels(inertia * W * W, 2.0 * damping_ratio * W * inertia, duration);
  const Reference exact = reference(panels, steps);
  const std::vector<Row> rows{{{"`solve`, radau_iia_7", solved(panels, ode::Method::radau_iia_7)}},
                              {{"`propagate`, radau_iia_7", propagated(panels, ode::Method::radau_iia_7)}},
                              {{"`solve`, cvode_bdf", solved(panels, ode::Method::cvode_bdf)}},
                              {{"CVODE, BDF, called directly", called_directly<Bdf>(panels)}, target},
                              {{inlined_name<HubWithPanels<>>("Verner7"), stepped<ode::Verner7>(panels)}}};
  Misses misses;
  std::printf(
      "\n## A stiff craft\n\n"
      "The hub with panels, which now vibrate at 50 Hz with 1 %% of damping, for 100 s, as on the long runs. "
      "The reference is Fehlberg 7(8) with a fixed step in long double, which changes by %.0e rad when its "
      "step is doubled.\n\n",
      exact.doubt);
  print_at_equal_accuracy("stiff craft", rows, exact.at_end, {1e-6, 1e-9}, rounds, misses);
  print_misses(misses);
}

}  // namespace bench
