// Four control moment gyros on a pyramid turn a satellite by 90 degrees about x, through a momentum at which
// they give no torque along x: the gimbal angles (90, 0, -90, 0) degrees. Steered by the pseudo-inverse they
// swing about that point as long as more is asked. A singularity-robust inverse with a little of other
// directions leads them past it.
//
//     H_i = J_s O s_i about the spin axis s_i, which turns about the gimbal axis g_i at the rate d_i':
//     H' = h A d',   column i of A: g_i x s_i,   h = J_s O
//     pseudo-inverse:     d' = A^T (A A^T)^-1 H'/h
//     singularity-robust: d' = A^T (A A^T + lambda E)^-1 H'/h,   lambda = 0.01 exp(-10 det A A^T),
//                         E = [1 e_3 e_2; e_3 1 e_1; e_2 e_1 1],   e_k = 0.01 sin(pi t/2 + phi_k)
//     on the way to the singularity, d = (x, 0, -x, 0), with the skew b:
//         det A A^T = 8 cos^2 b sin^2 b cos^2 x (sin^2 x + cos^2 b (1 + cos^2 x))
//
// Source of the second: Wie, Bailey, Heiberg, "Singularity robust steering logic for redundant single-gimbal
// control moment gyros", J. Guidance, Control, and Dynamics 24(5), 2001. Each gyro is a gimbal on a hinge,
// with a rotor in it that a lock keeps at its speed; each gimbal motor is a servo of the rate. The angular
// momentum of the whole is zero. Torque and det to a table: cmg_pyramid <data> <table.csv>.

#include <Eigen/LU>
#include <algorithm>
#include <array>
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
struct Wanted : moving_frame {};
template <int I> struct Side : moving_frame {};    // of the pyramid, x outwards
template <int I> struct Gimbal : moving_frame {};  // z is the gimbal axis, y the spin axis
template <int I> struct Rotor : named_point {};

constexpr auto m = si::metre;
constexpr auto s = si::second;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto N_m = si::newton_metre;
constexpr double degrees = 180.0 / std::numbers::pi;

constexpr double J_s = 0.025, speed = 600.0, h = J_s * speed;  // 15 N m s
constexpr double J_gimbal = 0.05;                              // with the rotor, about the gimbal axis
const double skew = std::acos(1.0 / std::sqrt(3.0));           // 54.74 degrees

/// The gyro on side I of the pyramid: x, y, -x, -y. At zero it spins along the edge of the base.
template <int I> auto gimbal() {
  using B = Gimbal<I>;
  const Quantity<si::angle> round = I * 0.5 * std::numbers::pi * rad;
  // z tilts by the skew towards the side; y is level.
  const auto R_side_from_h = turned_z(to<Side<I>>, from<Hub>, round);
  const auto R_b_from_side = turned_y(to<B>, from<Side<I>>, skew * rad);
  const auto r_hb_h = inverse(R_side_from_h) * vector(in<Side<I>>, 0.4 * m, 0.0 * m, 0.0 * m);
  return body(
      mass_properties(10.0 * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                      inertia_from_principal_moments(in<B>, 0.05 * kg_m2, 0.06 * kg_m2, J_gimbal * kg_m2)),
      hinge(Transform{Dcm<Hub, B>{inverse(R_b_from_side * R_side_from_h)},
                      displacement(of<B>, relative_to<Hub>, r_hb_h)},
            unit_z(in<B>)));
}
template <int I> auto spin() {
  return rotor(of<Rotor<I>>, unit_y(in<Gimbal<I>>), J_s * kg_m2);
}
auto make_sat() {
  return spacecraft(
      body(mass_properties(
               300.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
               inertia_from_principal_moments(in<Hub>, 160.0 * kg_m2, 150.0 * kg_m2, 180.0 * kg_m2)),
           turning_in<Gcrf>),
      gimbal<0>(), gimbal<1>(), gimbal<2>(), gimbal<3>(), spin<0>(), spin<1>(), spin<2>(), spin<3>());
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

using Three = Eigen::Vector3d;
using Four = Eigen::Vector4d;

/// Of each gyro as it stands, in the axes of the hub: g_i x s_i, and s_i.
template <int I, class Unit> Three in_hub(const Now<Sat>& now, const Unit& unit) {
  return (now.rotation(to<Hub>, from<Gimbal<I>>) * unit).coordinates();
}
Eigen::Matrix<double, 3, 4> torque_directions(const Now<Sat>& now) {
  Eigen::Matrix<double, 3, 4> A;
  A << -in_hub<0>(now, unit_x(in<Gimbal<0>>)), -in_hub<1>(now, unit_x(in<Gimbal<1>>)),
      -in_hub<2>(now, unit_x(in<Gimbal<2>>)), -in_hub<3>(now, unit_x(in<Gimbal<3>>));
  return A;
}
Three momentum_of_gyros(const Now<Sat>& now) {
  return h * (in_hub<0>(now, unit_y(in<Gimbal<0>>)) + in_hub<1>(now, unit_y(in<Gimbal<1>>)) +
              in_hub<2>(now, unit_y(in<Gimbal<2>>)) + in_hub<3>(now, unit_y(in<Gimbal<3>>)));
}
Four gimbal_angles(const CraftState<Sat>& state) {
  return {state.coordinate(of<Gimbal<0>>).value(), state.coordinate(of<Gimbal<1>>).value(),
          state.coordinate(of<Gimbal<2>>).value(), state.coordinate(of<Gimbal<3>>).value()};
}
double measure(const Eigen::Matrix<double, 3, 4>& A) {
  return (A * A.transpose()).determinant();
}
double measure_on_the_way(double x) {
  const double cos_b = std::cos(skew), sin_b = std::sin(skew), cos_x = std::cos(x), sin_x = std::sin(x);
  return 8.0 * std::pow(cos_b * sin_b * cos_x, 2) * (sin_x * sin_x + cos_b * cos_b * (1.0 + cos_x * cos_x));
}

/// Added to A A^T before it is inverted.
using Robustness = Eigen::Matrix3d (*)(double t, double det);
Eigen::Matrix3d nothing(double, double) {
  return Eigen::Matrix3d::Zero();
}
Eigen::Matrix3d robust(double t, double det) {
  const double at = 0.5 * std::numbers::pi * t;
  const double e1 = 0.01 * std::sin(at), e2 = 0.01 * std::cos(at), e3 = -0.01 * std::sin(at);
  Eigen::Matrix3d E;
  E << 1.0, e3, e2, e3, 1.0, e1, e2, e1, 1.0;
  return 0.01 * std::exp(-10.0 * det) * E;
}

/// The reference: rest to rest about x, with the largest rate in the middle.
constexpr double T = 24.0, turned = 0.5 * std::numbers::pi;
struct Reference {
  double angle, rate, acceleration;
};
Reference reference(double t) {
  if (t >= T) return {turned, 0.0, 0.0};
  const double u = 2.0 * std::numbers::pi / T;
  return {turned * (t / T - std::sin(u * t) / (2.0 * std::numbers::pi)), turned / T * (1.0 - std::cos(u * t)),
          turned / T * u * std::sin(u * t)};
}

/// What a tick gives: the rates of the gimbals, rad/s, and the H' in the hub that they are to give, N m.
struct Command {
  Four rates = Four::Zero();
  Three wanted = Three::Zero();
};
constexpr double largest_rate = 2.0;  // of a gimbal, rad/s

struct Steering {
  Eigen::Matrix3d J;  // of the whole, gimbals at zero, about its centre of mass
  Robustness robustness;

  /// J w' + H' + w x (J w + H) = 0, for the w' that brings the hub to the reference.
  Command operator()(const Now<Sat>& now) const {
    const double t = now.time().value();
    const Reference to_be = reference(t);
    const auto R_w_from_i = turned_x(to<Wanted>, from<Gcrf>, to_be.angle * rad);
    const Three theta = log(Dcm<Wanted, Hub>{R_w_from_i * now.rotation(to<Gcrf>, from<Hub>)}).coordinates();
    const Three w = now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).coordinates();
    const Three w_dot =
        to_be.acceleration * Three::UnitX() - 1.0 * theta - 1.6 * (w - to_be.rate * Three::UnitX());
    const Three wanted = -J * w_dot - w.cross(J * w + momentum_of_gyros(now));

    const auto A = torque_directions(now);
    const Eigen::Matrix3d inverted = (A * A.transpose() + robustness(t, measure(A))).inverse();
    const Four rates = A.transpose() * inverted * wanted / h;
    return {rates * std::min(1.0, largest_rate / rates.cwiseAbs().maxCoeff()), wanted};
  }
};

/// The servo of a gimbal: M = J_g k (d'_wanted - d') + h w_x, the second against the gyroscopic torque.
template <int I> void turn_gimbal(const Now<Sat>& now, Forces<Sat>& forces, const Command& command) {
  const double w_x = now.angular_velocity(of<Gimbal<I>>, relative_to<Gcrf>, in<Gimbal<I>>).coordinates().x();
  const double late = command.rates[I] - now.speed(of<Gimbal<I>>).value();
  forces.effort(of<Gimbal<I>>, (J_gimbal * 50.0 * late + h * w_x) * N_m);
  forces.lock(of<Rotor<I>>);
}

CraftState<Sat> start_at(const Sat& sat, const Three& w, double spin) {
  return state(
      sat, 0.0 * s,
      moving_dcm(aligned(to<Gcrf>, from<Hub>),
                 angular_velocity(of<Hub>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Hub>, w))),
      starts(of<Gimbal<0>>, 0.0 * rad, 0.0 * rad_s), starts(of<Gimbal<1>>, 0.0 * rad, 0.0 * rad_s),
      starts(of<Gimbal<2>>, 0.0 * rad, 0.0 * rad_s), starts(of<Gimbal<3>>, 0.0 * rad, 0.0 * rad_s),
      spins(of<Rotor<0>>, spin * rad_s), spins(of<Rotor<1>>, spin * rad_s), spins(of<Rotor<2>>, spin * rad_s),
      spins(of<Rotor<3>>, spin * rad_s));
}
/// Its columns are the angular momenta at unit rates.
Eigen::Matrix3d inertia_of_whole(const Sat& sat) {
  Eigen::Matrix3d J;
  for (int i = 0; i < 3; ++i)
    J.col(i) = motion(sat, start_at(sat, Three::Unit(i), 0.0)).angular_momentum().coordinates();
  return J;
}

void fly(const char* title, Robustness robustness, std::ofstream& table) {
  const Sat sat;
  const auto gimbals = [](const Now<Sat>& now, Forces<Sat>& forces, const Command& command) {
    turn_gimbal<0>(now, forces, command), turn_gimbal<1>(now, forces, command);
    turn_gimbal<2>(now, forces, command), turn_gimbal<3>(now, forces, command);
  };
  const auto steered =
      scenario(sat, gimbals, held(Command{}), every(0.1 * s, Steering{inertia_of_whole(sat), robustness}));
  constexpr double end = 30.0;
  const auto flight = propagate(steered, start_at(sat, Three::Zero(), speed),
                                {.end = end * s,
                                 .relative_tolerance = 1e-11,
                                 .absolute_tolerances = {.angle = 1e-12 * rad,
                                                         .rate = 1e-12 * rad_s,
                                                         .length = 1e-12 * m,
                                                         .velocity = 1e-12 * (m / s),
                                                         .mode = 1e-12},
                                 .method = ode::Method::verner_7});

  std::printf(
      "\n%s\n   t [s]   turned, wanted [deg]   H_x/h   det A A^T   on the way   torque error [N m]"
      "   gimbals [deg]\n",
      title);
  double late = 0.0, worst = 0.0, behind = 0.0, off = 0.0, kept = 0.0;
  for (int i = 0; i <= 600; ++i) {
    const auto motion = motion_at(steered, flight, end * i / 600.0 * s);
    const auto now = motion.now();
    const double t = now.time().value();
    const auto A = torque_directions(now);
    const Four angles = gimbal_angles(motion.state());
    const Command command = flight.template held<Command>(t * s);
    const double error = (h * A * command.rates - command.wanted).norm();
    const double det = measure(A), on_the_way = measure_on_the_way(0.5 * (angles[0] - angles[2]));
    const double turned_by = degrees * log(motion.state().turning().rotation).coordinates().x();
    const double H_x = std::round(1e3 * momentum_of_gyros(now).x() / h) / 1e3 + 0.0;
    worst = std::max(worst, error), late += error > 1.0 ? end / 600.0 : 0.0;
    behind = std::max(behind, degrees * reference(t).angle - turned_by);
    if (t < 8.0) off = std::max(off, std::abs(det / on_the_way - 1.0));
    kept = std::max(kept, now.angular_momentum().coordinates().norm() / h);
    table << title << ',' << t << ',' << turned_by << ',' << det << ',' << on_the_way << ',' << error << '\n';
    if (i % 40 != 0) continue;
    std::printf("%8.0f %11.3f %10.3f %7.3f %11.4f %12.4f %20.3f  ", t, turned_by,
                degrees * reference(t).angle, H_x, det, on_the_way, error);
    for (const double angle : angles) std::printf(" %8.2f", std::round(1e2 * degrees * angle) / 1e2 + 0.0);
    std::printf("\n");
  }
  std::printf(
      "the torque is wrong by up to %.3f N m, by more than 1 N m for %.2f s; the hub is up to %.3f deg "
      "behind\n",
      worst, late, behind);
  std::printf("until 8 s det A A^T %s its closed form to 1e-6\n", off < 1e-6 ? "is" : "is not");
  std::printf("the angular momentum of the whole is %s\n", kept < 1e-9 ? "zero to 1e-9 h" : "not kept");
}

}  // namespace

int main(int count, char** arguments) try {
  std::ofstream table(count > 2 ? arguments[2] : "/dev/null");
  table << "case,t_s,turned_deg,det,det_on_the_way,torque_error_N_m\n";
  fly("Pseudo-inverse", nothing, table);
  fly("Singularity-robust inverse", robust, table);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
