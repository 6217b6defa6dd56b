// A spinner with a nutation damper, twice: the flat spin of a long body that spins about its axis of least
// inertia, and the dual-spin turn, in which a wheel takes the momentum of a body that spins across it.
//
//     H = J w + J_s Omega z + (what the damper's mass adds) is constant in the inertial frame
//     damper: a mass m on the hub at (r, 0, q), m q'' + c q' + k q = -m a_z
//     flat spin: energy goes where H is constant, until w is along the axis of most inertia, w = H/J_max
//     turn: J_s (Omega' + w_z') = tau, until J_s Omega = H: then z is near H, and the hub nearly stands
//
// About the first spin the linear system of the craft is constant, because it turns steadily: its unstable
// mode says how fast the nutation grows before it is large. Nutation and energy to a table: flat_spin <data>
// <table.csv>.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Bob : moving_frame {};
struct Wheel : named_point {};

constexpr auto m = si::metre;
constexpr auto s = si::second;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto N_m = si::newton_metre;
constexpr double J_s = 0.05;

auto make_sat() {
  const Transform<Hub, Bob> X_h_from_bob{
      aligned(to<Hub>, from<Bob>),
      displacement(of<Bob>, relative_to<Hub>, vector(in<Hub>, 1.0 * m, 0.0 * m, 0.0 * m))};
  return spacecraft(
      body(
          mass_properties(60.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                          inertia_from_principal_moments(in<Hub>, 28.0 * kg_m2, 30.0 * kg_m2, 12.0 * kg_m2)),
          turning_in<Gcrf>),
      body(
          mass_properties(0.05 * si::kilogram, coincident(of<CentreOfMassOf<Bob>>, relative_to<Bob>, in<Bob>),
                          inertia_from_principal_moments(in<Bob>, 1e-5 * kg_m2, 1e-5 * kg_m2, 1e-5 * kg_m2)),
          slider(X_h_from_bob, unit_z(in<Bob>))),
      rotor(of<Wheel>, unit_z(in<Hub>), J_s * kg_m2));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

struct Motor {  // held from one change to the next
  Quantity<si::torque> torque;
};

CraftState<Sat> spinning(const Sat& sat, double x, double y, double z) {
  return state(sat, 0.0 * s,
               moving_dcm(aligned(to<Gcrf>, from<Hub>),
                          angular_velocity(of<Hub>, relative_to<Gcrf>,
                                           vector(in<Hub>, x * rad_s, y * rad_s, z * rad_s))),
               starts(of<Bob>, 0.0 * m, 0.0 * (m / s)), spins(of<Wheel>, 0.0 * rad_s));
}
/// Between the hub's z and H, which the start gives along it.
double nutation(const Now<Sat>& now) {
  const auto H_i = now.angular_momentum();
  const auto H_h = inverse(now.rotation(to<Gcrf>, from<Hub>)) * H_i;
  const double along = H_h.z().value(), across = std::hypot(H_h.x().value(), H_h.y().value());
  return std::atan2(across, along) * (180.0 / std::numbers::pi);
}

template <class Scenario>
auto fly(const char* title, const Scenario& scenario, const CraftState<Sat>& start, double end,
         std::ofstream& table) {
  const CraftPropagation how{.end = end * s,
                             .relative_tolerance = 1e-11,
                             .absolute_tolerances = {.angle = 1e-12 * rad,
                                                     .rate = 1e-12 * rad_s,
                                                     .length = 1e-12 * m,
                                                     .velocity = 1e-12 * (m / s),
                                                     .mode = 1e-12}};
  const auto flight = propagate(scenario, start, how);
  std::printf("\n%s\n   t [s]   nutation [deg]   rate [rad/s]   energy [J]   wheel [rad/s]\n", title);
  const auto print = [&](double t, bool on_screen) {
    const auto motion = motion_at(scenario, flight, t * s);
    const auto now = motion.now();
    const double rate = now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).coordinates().norm();
    if (on_screen)
      std::printf("%8.0f %16.3f %14.4f %12.4f %15.3f\n", t, nutation(now), rate, now.energy().value(),
                  now.spin(of<Wheel>).value());
    table << title << ',' << t << ',' << nutation(now) << ',' << rate << ',' << now.energy().value() << '\n';
  };
  const double last = flight.end().value();
  for (int i = 0; i <= 300; ++i) print(last * i / 300.0, i % 30 == 0);
  return flight;
}

void run(const std::string& path) {
  std::ofstream table(path);
  table << "case,t_s,nutation_deg,rate_rad_s,energy_J\n";
  const Sat sat;
  const auto spring_of_damper = spring(sat, of<Bob>, 0.0686 * (si::newton / m), 0.0 * m);
  const auto dashpot = damper(sat, of<Bob>, 0.012 * (si::newton / (m / s)));

  // The wheel stands still: it is locked.
  const auto locked = [](const auto&, auto& forces) { forces.lock(of<Wheel>); };
  const auto spinner = scenario(sat, spring_of_damper, dashpot, locked);
  const auto modes = natural_modes(linearise(spinner, spinning(sat, 0.0, 0.0, 2.0)));
  std::printf("Modes about a spin of 2 rad/s about the axis of least inertia: %zu zeros\n", modes.zeros);
  double growth = 0.0;
  for (const NaturalMode& mode : modes.list) {
    std::printf("  %.5f rad/s, damping ratio %.5f\n", mode.frequency.value(),
                std::round(1e5 * mode.damping_ratio) / 1e5 + 0.0);
    growth = std::max(growth, mode.eigenvalue.real());
  }
  const auto flat = fly("Flat spin", spinner, spinning(sat, 0.002, 0.0, 2.0), 2000.0, table);
  const auto nutation_at = [&](double t) {
    const auto motion = motion_at(spinner, flat, t * s);
    return nutation(motion.now());
  };
  // The nutation angle of an asymmetric body swings: both instants are whole periods of it apart.
  const double period = std::numbers::pi / modes.list.back().eigenvalue.imag();
  double early = 0.0, late = 0.0;
  for (int i = 0; i <= 50; ++i) {
    early = std::max(early, nutation_at(20.0 + period * i / 50.0));
    late = std::max(late, nutation_at(120.0 + period * i / 50.0));
  }
  std::printf("the nutation grows by %.4f %% per second, the unstable mode by %.4f %%\n",
              std::log(late / early), 100.0 * growth);

  // The slower the wheel takes the momentum, the less nutation is left.
  const auto start = spinning(sat, 0.0, 0.3, 0.0);
  const double H = motion(sat, start, spring_of_damper, dashpot).angular_momentum().coordinates().norm();
  const auto drive = [](const Now<Sat>&, Forces<Sat>& forces, const Motor& motor) {
    forces.motor(of<Wheel>, motor.torque);
  };
  for (const auto& [title, torque] :
       {std::pair{"Dual-spin turn by 0.05 N m", 0.05}, {"Dual-spin turn by 0.005 N m", 0.005}}) {
    const auto turn =
        scenario(sat, spring_of_damper, dashpot, drive, held(Motor{torque * N_m}),
                 when(
                     "done", [H](const Now<Sat>& now) { return now.spin(of<Wheel>).value() - H / J_s; },
                     ode::Direction::rising, stop));
    const auto flight = fly(title, turn, start, 2000.0, table);
    std::printf("the wheel has the momentum at %.3f s\n", flight.end().value());
  }
}

}  // namespace

int main(int count, char** arguments) try {
  run(count > 2 ? arguments[2] : "/dev/null");
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
