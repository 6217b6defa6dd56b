// A scenario of the user's own, flown twice: by Vectrix and by Simbody, which shares no line of mechanics or
// integration with it. A hub with two panels on springy hinges and three wheels turns back to the inertial
// axes: a controller, sampled four times a second, commands the wheels. The load of its own is the pressure
// of sunlight on the panels.
//
//     tau_k = K theta_k + C w_k, held from tick to tick       the wheels turn the hub by -tau
//     F = -P A (n.s)^2 n on a panel whose normal n sees the Sun in the direction s

#include <array>
#include <exception>
#include <iostream>
#include <vectrix/simbody.hpp>

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};
template <int I> struct Panel : moving_frame {};
template <int I> struct Wheel : named_point {};

constexpr auto m = si::metre;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto N = si::newton;
constexpr auto N_m = si::newton_metre;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto s = si::second;

/// A panel along y or -y from its hinge, whose frame is turned by 30 degrees about that.
template <int I> auto panel() {
  using P = Panel<I>;
  const double side = I == 1 ? 1.0 : -1.0;
  const Transform<Hub, P> X_h_from_p{
      turned_y(to<Hub>, from<P>, convert<si::angle>(30.0 * si::degree)),
      displacement(of<P>, relative_to<Hub>, vector(in<Hub>, 0.0 * m, side * 0.6 * m, 0.1 * m))};
  const auto mass = mass_properties(
      8.0 * si::kilogram,
      displacement(of<CentreOfMassOf<P>>, relative_to<P>, vector(in<P>, 0.0 * m, side * 1.2 * m, 0.0 * m)),
      inertia_from_principal_moments(in<P>, 3.9 * kg_m2, 0.7 * kg_m2, 4.6 * kg_m2));
  return body(mass, hinge(X_h_from_p, unit_x(in<P>)));
}
auto make_sat() {
  const auto J_s = 0.01 * kg_m2;
  return spacecraft(
      body(mass_properties(120.0 * si::kilogram,
                           displacement(of<CentreOfMassOf<Hub>>, relative_to<Hub>,
                                        vector(in<Hub>, 0.02 * m, 0.0 * m, 0.05 * m)),
                           inertia_from_principal_moments(in<Hub>, 22.0 * kg_m2, 18.0 * kg_m2, 26.0 * kg_m2)),
           free_in<Inertial>),
      panel<1>(), panel<2>(), rotor(of<Wheel<1>>, unit_x(in<Hub>), J_s),
      rotor(of<Wheel<2>>, unit_y(in<Hub>), J_s), rotor(of<Wheel<3>>, unit_z(in<Hub>), J_s));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

/// What the controller commands: torques on the wheels.
struct Command {
  std::array<Quantity<si::torque>, 3> torques;
};
Command control(const Now<Sat>& now, const Command&) {
  const auto theta = log(now.rotation(to<Inertial>, from<Hub>)).coordinates();
  const auto w = now.angular_velocity(of<Hub>, relative_to<Inertial>, in<Hub>).coordinates();
  const auto torque = [&](int k) { return (1.0 * theta[k] + 8.0 * w[k]) * N_m; };
  return {{torque(0), torque(1), torque(2)}};
}
void turn_wheels(const Now<Sat>&, Forces<Sat>& forces, const Command& command) {
  forces.motor(of<Wheel<1>>, command.torques[0]);
  forces.motor(of<Wheel<2>>, command.torques[1]);
  forces.motor(of<Wheel<3>>, command.torques[2]);
}

/// 4.56e-6 N/m^2 on 2.4 m^2, all absorbed and sent back along the normal.
template <int I> void sunlight(const Now<Sat>& now, Forces<Sat>& forces) {
  using P = Panel<I>;
  const auto n_i = now.rotation(to<Inertial>, from<P>) * unit_z(in<P>);
  const double cosine = n_i.coordinates().x();  // the Sun is along x of the inertial frame
  if (cosine <= 0.0) return;
  const double pressed = 2.0 * 4.56e-6 * 2.4 * cosine * cosine;
  const auto F_i = vector(in<Inertial>, -pressed * n_i.coordinates().x() * N,
                          -pressed * n_i.coordinates().y() * N, -pressed * n_i.coordinates().z() * N);
  const double side = I == 1 ? 1.0 : -1.0;
  const auto r_p = vector(in<P>, 0.0 * m, side * 1.2 * m, 0.0 * m);
  forces.force(of<P>, displacement(of<CentreOfMassOf<P>>, relative_to<P>, r_p), F_i);
}

int main() try {
  const Sat sat;
  const auto k = 40.0 * N_m / rad;
  const auto c = 0.5 * N_m / rad_s;
  const auto flight = scenario(sat, spring(sat, of<Panel<1>>, k, 0.0 * rad), damper(sat, of<Panel<1>>, c),
                               spring(sat, of<Panel<2>>, k, 0.0 * rad), damper(sat, of<Panel<2>>, c),
                               &sunlight<1>, &sunlight<2>, &turn_wheels,
                               held(Command{{0.0 * N_m, 0.0 * N_m, 0.0 * N_m}}), every(0.25 * s, &control));

  const MovingTransform<Inertial, Hub> tumbling{
      {turned_z(to<Inertial>, from<Hub>, 0.6 * rad),
       angular_velocity(of<Hub>, relative_to<Inertial>,
                        vector(in<Hub>, 0.02 * rad_s, -0.03 * rad_s, 0.01 * rad_s))},
      displacement(of<Hub>, relative_to<Inertial>, vector(in<Inertial>, 0.0 * m, 0.0 * m, 0.0 * m)),
      velocity(of<Hub>, relative_to<Inertial>, observed_from<Inertial>,
               vector(in<Inertial>, 0.0 * (m / s), 0.0 * (m / s), 0.0 * (m / s)))};
  const auto start = state(sat, 0.0 * s, tumbling, starts(of<Panel<1>>, 0.05 * rad, 0.0 * rad_s),
                           starts(of<Panel<2>>, -0.02 * rad, 0.0 * rad_s), spins(of<Wheel<1>>, 150.0 * rad_s),
                           spins(of<Wheel<2>>, -100.0 * rad_s), spins(of<Wheel<3>>, 50.0 * rad_s));

  const auto ours = propagate(flight, start,
                              {.end = 30.0 * s,
                               .relative_tolerance = 1e-12,
                               .absolute_tolerances = {.angle = 1e-12 * rad,
                                                       .rate = 1e-12 * rad_s,
                                                       .length = 1e-12 * m,
                                                       .velocity = 1e-12 * (m / s),
                                                       .mode = 1e-12}});
  for (const double accuracy : {1e-8, 1e-10}) {
    const auto theirs = propagate_with_simbody(flight, start, {.end = 30.0 * s, .accuracy = accuracy});
    std::cout << "Simbody's accuracy " << accuracy << "\n" << compare(sat, ours, theirs) << "\n";
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
