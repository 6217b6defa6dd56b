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
#include <type_traits>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Body : moving_frame {};

constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto m = si::metre;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
const Eigen::Vector3d J(1.0, 2.0, 3.0);

void run() {
  const Eigen::Vector3d w0(0.0, 1.0, 1e-2);
  const auto J_b = inertia_from_principal_moments(in<Body>, J.x() * kg_m2, J.y() * kg_m2, J.z() * kg_m2);
  const State<Inertial, Body> start{
      0.0 * si::second, quaternion(aligned(to<Inertial>, from<Body>)),
      angular_velocity(of<Body>, relative_to<Inertial>, vector<si::angular_velocity>(in<Body>, w0))};
  const auto exact = torque_free(J_b, start);
  const double period = exact.period().value();

  const auto craft =
      spacecraft(body(mass_properties(1.0 * si::kilogram,
                                      coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>), J_b),
                      turning_in<Inertial>));
  using Craft = std::remove_const_t<decltype(craft)>;
  const auto w2 = [](const Now<Craft>& now) {
    return now.angular_velocity(of<Body>, relative_to<Inertial>, in<Body>).y();
  };
  const auto tumble = scenario(craft, when("flip", w2, ode::Direction::any));
  const auto trajectory = propagate(
      tumble, state(craft, start.time, MovingDcm{start.R_i_from_b(), start.w_ib_b}),
      {.end = 120.0 * si::second,
       .relative_tolerance = 1e-14,
       .absolute_tolerances = {1e-14 * rad, 1e-15 * rad_s, 1e-6 * m, 1e-9 * (m / si::second), 1e-12}});

  std::printf(
      "Torque-free tumble, J = (1, 2, 3) kg m^2, spin of 1 rad/s about axis 2, disturbed by 1e-2 rad/s\n\n");
  std::printf("%8s %11s %11s %11s %14s\n", "t [s]", "w1 [rad/s]", "w2 [rad/s]", "w3 [rad/s]",
              "body y to i y");
  for (int t = 0; t <= 120; t += 6) {
    const auto now = trajectory.at(static_cast<double>(t) * si::second).turning();
    const Eigen::Vector3d w = now.angular_velocity.coordinates();
    const double cosine = dot(now.rotation * unit_y(in<Body>), unit_y(in<Inertial>)).value();
    std::printf("%8d %11.6f %11.6f %11.6f %10.2f deg\n", t, w.x(), w.y(), w.z(),
                std::acos(cosine) * 180.0 / M_PI);
  }

  std::printf("\n%6s %20s %20s %12s\n", "flip", "found at [s]", "exact [s]", "difference");
  const auto events = trajectory.events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double found = events[i].state.time().value();
    const double expected = period / 4.0 + static_cast<double>(i) * period / 2.0;
    std::printf("%6zu %20.10f %20.10f %12s\n", i + 1, found, expected,
                std::abs(found - expected) < 1e-9 ? "< 1e-9 s" : "LARGE");
  }

  double worst = 0.0;
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const auto node = trajectory.node(i);
    const Eigen::Vector3d w = exact.at(node.time()).w_ib_b.coordinates();
    worst = std::max(worst, (node.turning().angular_velocity.coordinates() - w).norm());
  }
  const CraftConservation kept = conservation(tumble, trajectory);
  const auto below = [](double value, double bound) { return value < bound ? "below" : "ABOVE"; };
  std::printf("\nRate against the exact solution, all steps: %s 1e-9 rad/s\n", below(worst, 1e-9));
  std::printf("Energy and angular momentum kept to: %s 1e-12\n",
              below(std::max(*kept.energy, *kept.angular_momentum), 1e-12));
}

}  // namespace

int main() try { run(); } catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
