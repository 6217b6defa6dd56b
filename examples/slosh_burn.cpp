// Propellant that sloshes while an engine burns: a pendulum in the tank, on a hinge ahead of the hub's centre
// of mass. The attitude is held by torques from sampled angles and rates. That feeds the slosh, because its
// hinge is less than its length ahead; with a notch at the slosh frequency in the controller it dies out.
//
//     hub M, J; pendulum m, length l, hinge b ahead; damper c of the baffles; thrust F, a = F/(M + m)
//     P(s) = l s^2 + (c/l)(1/m + 1/M) s + a (1 + m/M),   Q(s) = J s^2 + D s + K of the controller
//     small motions: P(s) Q(s) + (l - b) s^2 (c (l - b)/l s - m a b) = 0
//     without controller and damper: w^2 = F/(l (M + m)) (1 + m/M - m b (l - b)/J)
//     notch: (s^2 + w^2)/(s^2 + 2 z w s + w^2), by the bilinear rule that keeps w
//
// P = 0 is a pendulum with the thrust's acceleration for gravity, and the reaction of the hub. What is
// sampled is half a period late, so that the slosh grows a little faster than by P Q. The mass used is
// impulse over exhaust velocity; the craft keeps its mass. Angles to a table: slosh_burn <data> <table.csv>.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
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
struct Propellant : moving_frame {};
struct Nozzle : moving_frame {};

constexpr auto metre = si::metre;
constexpr auto s = si::second;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto N_m = si::newton_metre;
constexpr double degrees = 180.0 / std::numbers::pi;

constexpr double M = 700.0, J = 400.0, m = 300.0, l = 0.6, b = 0.3, F = 500.0, a = F / (M + m);
constexpr double exhaust_velocity = 3100.0;
constexpr double K = 64.0, D = 224.0;  // 0.4 rad/s, damping 0.7
const double w_slosh = std::sqrt(a / l * (1.0 + m / M - m * b * (l - b) / J));

template <Frame B> auto mass(double kg, double x, double moment) {
  return mass_properties(
      kg * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>, vector(in<B>, x * metre, 0.0 * metre, 0.0 * metre)),
      inertia_from_principal_moments(in<B>, moment * kg_m2, moment * kg_m2, moment * kg_m2));
}
template <Frame B> Transform<Hub, B> at_x(double x) {
  return {aligned(to<Hub>, from<B>),
          displacement(of<B>, relative_to<Hub>, vector(in<Hub>, x * metre, 0.0 * metre, 0.0 * metre))};
}
/// A point mass: its own inertia is a billionth of m l^2.
auto make_sat() {
  return spacecraft(
      body(mass<Hub>(M, 0.0, J), free_in<Gcrf>),
      body(mass<Propellant>(m, -l, 1e-9 * m * l * l), hinge(at_x<Propellant>(b), unit_y(in<Propellant>))),
      mount(at_x<Nozzle>(-1.2)));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

/// The sine of the angle that the hub has turned about y, while it turns about nothing else.
template <class S> S sine_of_pitch(const Now<Sat, S>& now) {
  return now.rotation(to<Gcrf>, from<Hub>).matrix()(0, 2);
}
template <class S> S rate_of_pitch(const Now<Sat, S>& now) {
  return now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).coordinates().y();
}

/// The torque between two samples, and what the notch remembers of the last two.
struct Control {
  double torque = 0.0;
  double in_1 = 0.0, in_2 = 0.0, out_1 = 0.0, out_2 = 0.0;
};
constexpr double period = 0.1;
Control hold(const Now<Sat>& now, const Control&) {
  return {-K * sine_of_pitch(now) - D * rate_of_pitch(now)};
}
Control hold_with_notch(const Now<Sat>& now, const Control& last) {
  constexpr double z = 0.5;
  const double in = -K * sine_of_pitch(now) - D * rate_of_pitch(now);
  const double t = std::tan(0.5 * w_slosh * period), across = 1.0 + t * t, wide = 2.0 * z * t;
  const double out = (across * (in + last.in_2) + 2.0 * (t * t - 1.0) * (last.in_1 - last.out_1) -
                      (across - wide) * last.out_2) /
                     (across + wide);
  return {out, in, last.in_1, out, last.out_1};
}

constexpr double burns = 150.0;
auto engine(const Sat& sat) {
  return thruster(sat, of<Nozzle>, F * si::newton * unit_x(in<Nozzle>), {0.2 * s, 0.2 * s},
                  {{0.0 * s, burns * s}});
}
auto baffles(const Sat& sat, double c) {
  return damper(sat, of<Propellant>, c * (N_m / rad_s));
}
CraftState<Sat> start_at(const Sat& sat, double time, double angle) {
  return state(sat, time * s,
               MovingTransform<Gcrf, Hub>{
                   moving_dcm(aligned(to<Gcrf>, from<Hub>), at_rest(of<Hub>, relative_to<Gcrf>, in<Hub>)),
                   coincident(of<Hub>, relative_to<Gcrf>, in<Gcrf>),
                   at_rest(of<Hub>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)},
               starts(of<Propellant>, angle * rad, 0.0 * rad_s));
}
CraftPropagation until(double end) {
  return {.end = end * s,
          .relative_tolerance = 1e-11,
          .absolute_tolerances = {.angle = 1e-13 * rad,
                                  .rate = 1e-13 * rad_s,
                                  .length = 1e-9 * metre,
                                  .velocity = 1e-9 * (metre / s),
                                  .mode = 1e-12}};
}

/// The mode of the slosh: that of the highest frequency.
std::complex<double> slosh_of(const NaturalModes& modes) {
  return modes.list.back().eigenvalue;
}
/// The root of the fourth-order equation at the top that oscillates fastest.
std::complex<double> slosh_in_closed_form(double c) {
  const double p1 = c / l * (1.0 / m + 1.0 / M), p0 = a * (1.0 + m / M), arm = l - b;
  const double s4 = l * J;
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.row(0) << -(l * D + p1 * J + c * arm * arm / l), -(l * K + p1 * D + p0 * J - arm * m * a * b),
      -(p1 * K + p0 * D), -p0 * K;
  companion.row(0) /= s4;
  companion.bottomLeftCorner<3, 3>().setIdentity();
  const Eigen::Vector4cd roots = companion.eigenvalues();
  return *std::max_element(roots.begin(), roots.end(),
                           [](const auto& x, const auto& y) { return x.imag() < y.imag(); });
}

template <class Held>
void fly(const char* title, const Sat& sat, double c, Held controller, std::ofstream& table) {
  const auto push = [](const Now<Sat>&, Forces<Sat>& forces, const Control& control) {
    forces.torque(of<Hub>, control.torque * N_m * unit_y(in<Hub>));
  };
  const auto flight = propagate(
      scenario(sat, engine(sat), baffles(sat, c), push, held(Control{}), every(period * s, controller)),
      start_at(sat, 0.0, 1.0 / degrees), until(burns));
  const auto swing = [&](double around) {  // over a period
    double largest = 0.0;
    for (int i = 0; i <= 200; ++i)
      largest =
          std::max(largest, std::abs(flight.at((around + 2.0 * std::numbers::pi / w_slosh * i / 200.0) * s)
                                         .coordinate(of<Propellant>)
                                         .value()));
    return degrees * largest;
  };
  std::printf("\n%s\n   t [s]   slosh within a period [deg]   pitch [deg]\n", title);
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.5 * i;
    const auto now = flight.at(t * s);
    const double pitch = degrees * log(now.turning().rotation).coordinates().y();
    table << title << ',' << t << ',' << degrees * now.coordinate(of<Propellant>).value() << ',' << pitch
          << '\n';
    if (i % 40 == 0) std::printf("%8.0f %29.4f %13.4f\n", t, swing(t), std::round(1e4 * pitch) / 1e4 + 0.0);
  }
  std::printf("from 20 s to 120 s it changes by %.5f per second\n",
              std::log(swing(120.0) / swing(20.0)) / 100.0);
  const double impulse = flight.template held<Firing<Nozzle>>(burns * s).impulse(burns * s).value();
  std::printf("impulse %.2f N s, propellant used %.3f kg\n", impulse, impulse / exhaust_velocity);
}

void run(const std::string& path) {
  std::ofstream table(path);
  table << "case,t_s,slosh_deg,pitch_deg\n";
  const Sat sat;

  const auto swings =
      scenario(sat, engine(sat),
               when(
                   "through zero", [](const Now<Sat>& now) { return now.coordinate(of<Propellant>); },
                   ode::Direction::rising));
  const auto flight = propagate(swings, start_at(sat, 0.0, 1e-3), until(burns));
  const auto& zeros = flight.events();
  const double first = zeros[1].state.time().value(), last = zeros.back().state.time().value();
  const double counted = 2.0 * std::numbers::pi * static_cast<double>(zeros.size() - 2) / (last - first);
  const auto at_full_thrust = start_at(sat, 50.0, 0.0);
  std::printf(
      "Slosh without controller and baffles, rad/s: closed form %.6f, linear system %.6f, in flight %.6f\n",
      w_slosh, std::abs(slosh_of(natural_modes(linearise(swings, at_full_thrust)))), counted);
  std::printf("a pendulum on a hub that does not move would have %.6f\n", std::sqrt(a / l));

  const auto hold_always = []<class S>(const Now<Sat, S>& now, Forces<Sat, S>& forces) {
    using Torque = Quantity<si::torque, S>;
    const auto none = Torque::from_value(S(0.0));
    const auto torque = Torque::from_value(S(-K * sine_of_pitch(now) - D * rate_of_pitch(now)));
    forces.torque(of<Hub>, vector(in<Hub>, none, torque, none));
  };
  std::printf("With the controller, growth in 1/s and rad/s:\n");
  for (const double c : {0.0, 0.5}) {
    const auto linear = slosh_of(
        natural_modes(linearise(scenario(sat, engine(sat), baffles(sat, c), hold_always), at_full_thrust)));
    const auto exact = slosh_in_closed_form(c);
    std::printf("  baffles of %.1f N m s: linear system %.6f, %.6f; closed form %.6f, %.6f\n", c,
                linear.real(), linear.imag(), exact.real(), exact.imag());
  }
  fly("Controller with baffles of 0.5 N m s", sat, 0.5, hold, table);
  fly("Controller with a notch and baffles of 0.5 N m s", sat, 0.5, hold_with_notch, table);
}

}  // namespace

int main(int count, char** arguments) try {
  run(count > 2 ? arguments[2] : "/dev/null");
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
