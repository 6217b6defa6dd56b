// A satellite turns by 30 degrees about x with a reaction wheel, from rest to rest in two minutes. Its two
// solar panels hang on springy hinges and bend. A torque that is switched leaves them swinging; a smooth
// torque of the same length does not.
//
//     J_s (Omega' + n.alpha) = tau                               each wheel
//     switched:  tau = -a J sign(T/2 - t),                       a = 4 theta / T^2
//     smooth:    tau = -a J (sin(2 pi t/T) - 1/2 sin(4 pi t/T)), a = 8 pi theta / (3 T^2)
//
// J is the inertia about x of the whole craft, less the wheel's, as if it were rigid: both profiles turn a
// rigid craft by theta. The mechanics is that of articulated bodies, with springs, dampers and one mode for
// each panel. Angles and rates to a table: slew_with_panels <data> <table.csv>.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
template <int I> struct Panel : moving_frame {};
template <int I> struct Wheel : named_point {};
template <int I> struct Bending : named_point {};
struct Whole : moving_frame {};

constexpr auto m = si::metre;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto s = si::second;

/// 25 kg, 4 m by 1.5 m, along y or -y from its hinge.
template <int I> constexpr double side = I == 1 ? 1.0 : -1.0;
template <int I> auto panel_mass() {
  using P = Panel<I>;
  return mass_properties(
      25.0 * si::kilogram,
      displacement(of<CentreOfMassOf<P>>, relative_to<P>, vector(in<P>, 0.0 * m, side<I> * 2.1 * m, 0.0 * m)),
      inertia_from_principal_moments(in<P>, 33.3 * kg_m2, 4.7 * kg_m2, 38.0 * kg_m2));
}
template <int I> auto panel_at_zero() {
  return Transform{
      aligned(to<Hub>, from<Panel<I>>),
      displacement(of<Panel<I>>, relative_to<Hub>, vector(in<Hub>, 0.0 * m, side<I> * 0.9 * m, 0.0 * m))};
}
auto hub_mass() {
  return mass_properties(
      800.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
      inertia_from_principal_moments(in<Hub>, 300.0 * kg_m2, 250.0 * kg_m2, 350.0 * kg_m2));
}

constexpr auto J_s = 0.05 * kg_m2;

auto make_sat() {
  const auto bending = [](auto panel, double to_side) {
    return FlexibleMode<decltype(panel)>{{5.0 * to_side, 0.0, 0.0}, {0.0, 0.0, 3.0}, 11.0 * rad_s, 0.005};
  };
  return spacecraft(body(hub_mass(), turning_in<Gcrf>),
                    body(panel_mass<1>(), hinge(panel_at_zero<1>(), unit_x(in<Panel<1>>))),
                    body(panel_mass<2>(), hinge(panel_at_zero<2>(), unit_x(in<Panel<2>>))),
                    modes(of<Bending<1>>, on<Panel<1>>, bending(Panel<1>{}, side<1>)),
                    modes(of<Bending<2>>, on<Panel<2>>, bending(Panel<2>{}, side<2>)),
                    rotor(of<Wheel<1>>, unit_x(in<Hub>), J_s), rotor(of<Wheel<2>>, unit_y(in<Hub>), J_s),
                    rotor(of<Wheel<3>>, unit_z(in<Hub>), J_s));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

/// About x, of the craft as if it were rigid, about its centre of mass, less the wheel.
Quantity<si::moment_of_inertia> rigid_inertia() {
  const auto in_hub = [](const auto& X_h_from_p, const auto& panel) {
    return shift(X_h_from_p.rotation * panel, -X_h_from_p.translation);
  };
  const auto whole = join(of<Whole>, hub_mass(), in_hub(panel_at_zero<1>(), panel_mass<1>()),
                          in_hub(panel_at_zero<2>(), panel_mass<2>()));
  return whole.inertia().matrix()(0, 0) * kg_m2 - J_s;
}

constexpr auto T = 120.0 * s;
const auto slew_angle = convert<si::angle>(30.0 * si::degree);

/// The angular acceleration of the hub, if the craft were rigid, that the wheel is to give in a part of the
/// slew: held from one change to the next.
using Acceleration = Quantity<si::angular_acceleration>;
struct Phase {
  Acceleration (*demand)(const Quantity<si::time>& t);
};
const Phase speed_up{[](const Quantity<si::time>&) -> Acceleration { return 4.0 * slew_angle / (T * T); }};
const Phase slow_down{[](const Quantity<si::time>&) -> Acceleration { return -4.0 * slew_angle / (T * T); }};
const Phase smooth{[](const Quantity<si::time>& t) -> Acceleration {
  const double phase = 2.0 * std::numbers::pi * (t / T);
  return (std::sin(phase) - 0.5 * std::sin(2.0 * phase)) *
         (8.0 * std::numbers::pi / 3.0 * slew_angle / (T * T));
}};
const Phase coast{[](const Quantity<si::time>&) -> Acceleration { return 0.0 * slew_angle / (T * T); }};

using Flight = CraftTrajectory<Sat, Phase>;

template <class... Changes> Flight slew(const Sat& sat, const Phase& first, const Changes&... changes) {
  const auto at_rest_in_gcrf =
      moving_dcm(aligned(to<Gcrf>, from<Hub>), at_rest(of<Hub>, relative_to<Gcrf>, in<Hub>));
  const auto start = state(sat, 0.0 * s, at_rest_in_gcrf, starts(of<Panel<1>>, 0.0 * rad, 0.0 * rad_s),
                           starts(of<Panel<2>>, 0.0 * rad, 0.0 * rad_s), deflects(of<Bending<1>>, 0.0, 0.0),
                           deflects(of<Bending<2>>, 0.0, 0.0), spins(of<Wheel<1>>, 200.0 * rad_s),
                           spins(of<Wheel<2>>, 0.0 * rad_s), spins(of<Wheel<3>>, 0.0 * rad_s));
  const auto k = 350.0 * si::newton_metre / rad;
  const auto c = 2.0 * si::newton_metre / rad_s;
  const auto turn_wheel = [J = rigid_inertia()](const Now<Sat>& now, Forces<Sat>& forces,
                                                const Phase& phase) {
    forces.motor(of<Wheel<1>>, -(J * phase.demand(now.time())));
  };
  const auto flight = scenario(sat, spring(sat, of<Panel<1>>, k, 0.0 * rad), damper(sat, of<Panel<1>>, c),
                               spring(sat, of<Panel<2>>, k, 0.0 * rad), damper(sat, of<Panel<2>>, c),
                               turn_wheel, held(first), changes...);
  return propagate(flight, start,
                   {.end = 180.0 * s,
                    .relative_tolerance = 1e-10,
                    .absolute_tolerances = {.angle = 1e-12 * rad,
                                            .rate = 1e-12 * rad_s,
                                            .length = 1e-12 * m,
                                            .velocity = 1e-12 * (m / s),
                                            .mode = 1e-10}});
}

double degrees_about_x(const CraftState<Sat>& state) {
  return log(state.turning().rotation).coordinates().x() * (180.0 / std::numbers::pi);
}

/// To three decimals, and zero without a sign.
double rounded(double x) {
  return std::round(1e3 * x) / 1e3 + 0.0;
}

void print(const std::string& name, const Flight& flight, std::ofstream& table) {
  std::printf("\n%s\n   t [s]   turned [deg]   rate [mrad/s]   panel 1 [urad]   wheel 1 [rad/s]\n",
              name.c_str());
  for (const double t : {0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0}) {
    const auto now = flight.at(t * s);
    std::printf("%8.0f %14.3f %15.3f %16.3f %17.3f\n", t, rounded(degrees_about_x(now)),
                rounded(1e3 * now.turning().angular_velocity.x().in(rad_s)),
                rounded(1e6 * now.coordinate(of<Panel<1>>).in(rad)), now.spin(of<Wheel<1>>).in(rad_s));
  }
  for (int i = 0; i <= 720; ++i) {
    const double t = 0.25 * i;
    const auto now = flight.at(t * s);
    table << name << ',' << t << ',' << degrees_about_x(now) << ','
          << 1e3 * now.turning().angular_velocity.x().in(rad_s) << ','
          << 1e6 * now.coordinate(of<Panel<1>>).in(rad) << '\n';
  }
  double panel = 0.0, hub = 0.0;
  for (int i = 0; i <= 2400; ++i) {  // the last 60 s, 25 ms apart
    const auto now = flight.at((120.0 + 0.025 * i) * s);
    panel = std::max(panel, std::abs(now.coordinate(of<Panel<1>>).in(rad)));
    hub = std::max(hub, std::abs(now.turning().angular_velocity.x().in(rad_s)));
  }
  std::printf("after the slew: panel 1 swings by %.3f urad, the hub by %.3f urad/s\n", 1e6 * panel,
              1e6 * hub);
}

}  // namespace

int main(int count, char** arguments) try {
  const Sat sat;
  std::ofstream table(count > 2 ? arguments[2] : "/dev/null");
  table << "case,t_s,turned_deg,rate_mrad_s,panel_urad\n";
  std::printf("A slew of %.0f degrees in %.0f s, inertia %.1f kg m^2\n", slew_angle.in(si::degree), T.in(s),
              rigid_inertia().in(kg_m2));
  print("Switched torque",
        slew(sat, speed_up, at_times({0.5 * T}, becomes(slow_down)), at_times({T}, becomes(coast))), table);
  print("Smooth torque", slew(sat, smooth, at_times({T}, becomes(coast))), table);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
