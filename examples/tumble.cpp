// Torque-free rotation about the intermediate axis: the flips, with the exact and the integrated solution.
//
//     J dw/dt = -w x (J w),   d/dt q_b^i = 1/2 q_b^i (0, w_ib^b)
//
// With J1 < J2 < J3 and a disturbed spin about axis 2, H^2 < 2 T J2 or H^2 > 2 T J2 decides about which axis
// the body tumbles. The exact motion is Jacobi's, torque_free(): its rate contains cn, sn and dn, with the
// period 4 K(k) / rho. The body flips, w2 = 0, a quarter period after the start, and then every half period.

#include <cstdio>
#include <exception>
#include <iostream>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Body : moving_frame {};

constexpr auto kg_m2 = si::kilogram_square_metre;
const Eigen::Vector3d J(1.0, 2.0, 3.0);

void run() {
  const Eigen::Vector3d w0(0.0, 1.0, 1e-2);
  const Scenario<Inertial, Body> scenario{
      .inertia = inertia_from_principal_moments(in<Body>, J.x() * kg_m2, J.y() * kg_m2, J.z() * kg_m2),
      .initial = {.time = 0.0 * si::second,
                  .q_i_from_b = quaternion_scalar_first(to<Inertial>, from<Body>, 1.0, 0.0, 0.0, 0.0),
                  .w_ib_b = angular_velocity(of<Body>, relative_to<Inertial>,
                                             vector<si::angular_velocity>(in<Body>, w0))}};
  const auto exact = torque_free(scenario.inertia, scenario.initial);
  const double period = exact.period().value();

  Propagation<Inertial, Body> how{.end = 120.0 * si::second};
  how.tolerances.relative = 1e-14;
  how.tolerances.attitude = 1e-14;
  how.roots = {{.name = "flip", .function = [](const State<Inertial, Body>& state) {
                  return state.w_ib_b.vector().y().value();
                }}};
  const auto trajectory = propagate(scenario, how);

  std::printf(
      "Torque-free tumble, J = (1, 2, 3) kg m^2, spin of 1 rad/s about axis 2, disturbed by 1e-2 rad/s\n\n");
  std::printf("%8s %11s %11s %11s %14s\n", "t [s]", "w1 [rad/s]", "w2 [rad/s]", "w3 [rad/s]",
              "body y to i y");
  for (int t = 0; t <= 120; t += 6) {
    const auto state = trajectory.at(static_cast<double>(t) * si::second);
    const Eigen::Vector3d w = state.w_ib_b.coordinates();
    const double cosine = dot(state.R_i_from_b() * unit_y(in<Body>), unit_y(in<Inertial>)).value();
    std::printf("%8d %11.6f %11.6f %11.6f %10.2f deg\n", t, w.x(), w.y(), w.z(),
                std::acos(cosine) * 180.0 / M_PI);
  }

  std::printf("\n%6s %20s %20s %12s\n", "flip", "found at [s]", "exact [s]", "difference");
  const auto events = trajectory.events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double found = events[i].state.time.value();
    const double expected = period / 4.0 + static_cast<double>(i) * period / 2.0;
    std::printf("%6zu %20.10f %20.10f %12s\n", i + 1, found, expected,
                std::abs(found - expected) < 1e-9 ? "< 1e-9 s" : "LARGE");
  }

  double worst = 0.0;
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const auto state = trajectory.node(i);
    const Eigen::Vector3d w = exact.at(state.time).w_ib_b.coordinates();
    worst = std::max(worst, (state.w_ib_b.coordinates() - w).norm());
  }
  const Conservation kept = conservation(scenario, trajectory);
  const auto below = [](double value, double bound) { return value < bound ? "below" : "ABOVE"; };
  std::printf("\nRate against the exact solution, all steps: %s 1e-9 rad/s\n", below(worst, 1e-9));
  std::printf("Energy and angular momentum kept to: %s 1e-12\n",
              below(std::max(*kept.rotational_energy, *kept.angular_momentum), 1e-12));
}

}  // namespace

int main() try { run(); } catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
