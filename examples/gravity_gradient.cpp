// A cylinder in low Earth orbit for 8 hours under the gravity-gradient torque: NASA's check-case 10A. The
// result is compared with NASA's final state, and with Simbody where it is installed.
//
//     d^2/dt^2 r^i = -mu r^i / |r|^3
//     J dw_ib^b/dt = 3 mu / |r|^5  r^b x (J r^b)  -  w_ib^b x (J w_ib^b)
//     d/dt q_b^i   = 1/2 q_b^i (0, w_ib^b)
//
// point_mass() attracts each point of the body, which moves its orbit by 0.3 mm in these 8 hours; NASA's
// orbit is that of a point.
//
// Figures: NASA Johnson Space Center, orbital attitude check-cases (the set behind NASA/TM-2015-218675).

#include <cstdio>
#include <exception>
#include <iostream>
#include <vectrix/dynamics.hpp>

#ifdef VECTRIX_WITH_SIMBODY
#include <vectrix/simbody.hpp>
#endif

namespace {

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Lvlh : moving_frame {};     // z to nadir, y along -h, x = y x z
struct Pitched : moving_frame {};  // LVLH turned about its y axis
struct Body : moving_frame {};

constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto m = si::metre;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;

const auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);

auto make_cylinder() {
  return spacecraft(
      body(mass_properties(
               1000.0 * si::kilogram, coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>),
               inertia_from_principal_moments(in<Body>, 500.0 * kg_m2, 12250.0 * kg_m2, 12250.0 * kg_m2)),
           free_in<Inertial>));
}
using Cylinder = decltype(make_cylinder());

CraftState<Cylinder> run_10A(const Cylinder& craft) {
  const auto r_i = vector<si::length>(in<Inertial>, Eigen::Vector3d(-4292653.41, 955168.47, 5139356.57));
  const auto v_i = vector<si::velocity>(in<Inertial>, Eigen::Vector3d(109.649663, -7527.726490, 1484.521489));

  const auto z_i = -direction(r_i);
  const auto y_i = -direction(cross(r_i, v_i));
  const auto R_lvlh_from_i = dcm_from_axes(to<Lvlh>, cross(y_i, z_i), y_i, z_i);
  const auto R_b_from_lvlh = turned_z(to<Body>, from<Pitched>, convert<si::angle>(1.0 * si::degree)) *
                             turned_y(to<Pitched>, from<Lvlh>, convert<si::angle>(85.0 * si::degree));
  const auto R_b_from_i = R_b_from_lvlh * R_lvlh_from_i;

  // The body starts at rest in the local frame, which rotates at w_il = r x v / r^2.
  const Eigen::Vector3d w = r_i.coordinates().cross(v_i.coordinates()) / r_i.coordinates().squaredNorm();
  const auto w_il_i =
      angular_velocity(of<Lvlh>, relative_to<Inertial>, vector<si::angular_velocity>(in<Inertial>, w));
  const auto w_ib_b = R_b_from_i * w_il_i + at_rest(of<Body>, relative_to<Lvlh>, in<Body>);
  return state(craft, 0.0 * si::second,
               MovingTransform<Inertial, Body>{
                   MovingDcm{inverse(R_b_from_i), w_ib_b}, displacement(of<Body>, relative_to<Inertial>, r_i),
                   velocity(of<Body>, relative_to<Inertial>, observed_from<Inertial>, v_i)});
}

// NASA's state after 28 800 s; the matrix is body from inertial.
const Eigen::Vector3d nasa_r_i(-1024262.411095882, -6151093.565368023, 2599975.06217899);
const Eigen::Vector3d nasa_w_b(-1.97989570839746e-05, -0.001080027400090759, -0.0007098670173048437);
Eigen::Matrix3d nasa_T() {
  Eigen::Matrix3d T;
  T << -0.1303977224153033, -0.9235551691194414, 0.3606137595567613, -0.9835635249313684, 0.0746803593168579,
      -0.1643947576928366, 0.1248968631050554, -0.3761232424685627, -0.9181133263717784;
  return T;
}

void compare(const char* name, const CraftState<Cylinder>& state, const Eigen::Matrix3d& R_i_from_b,
             const Eigen::Vector3d& w_b, const Eigen::Vector3d& r_i, double bounds[3]) {
  const auto theirs = nearest_dcm(to<Inertial>, from<Body>, R_i_from_b).dcm;
  const auto ours = state.hub_motion();
  const double differences[] = {log(inverse(ours.turning.rotation) * theirs).angle().value(),
                                (ours.turning.angular_velocity.coordinates() - w_b).norm(),
                                (ours.translation.coordinates() - r_i).norm()};
  const char* units[] = {"rad", "rad/s", "m"};
  std::printf("%-8s", name);
  for (int i = 0; i < 3; ++i) {
    std::printf("  %s %.0e %s", differences[i] < bounds[i] ? "within" : "NOT within", bounds[i], units[i]);
  }
  std::printf("\n");
}

void run() {
  const Cylinder craft = make_cylinder();
  const auto start = run_10A(craft);
  const auto flight = scenario(craft, point_mass(craft, mu));
  const auto trajectory = propagate(
      flight, start,
      {.end = 8.0 * 3600.0 * si::second,
       .relative_tolerance = 1e-14,
       .absolute_tolerances = {1e-14 * rad, 1e-15 * rad_s, 1e-6 * m, 1e-9 * (m / si::second), 1e-12}});

  std::printf("Gravity gradient on a cylinder, 8 h in low Earth orbit (NASA run 10A)\n\n");
  std::printf("%8s %14s %14s %14s %18s\n", "t [h]", "wx [deg/s]", "wy [deg/s]", "wz [deg/s]",
              "body x to nadir");
  for (int hour = 0; hour <= 8; ++hour) {
    const auto now = trajectory.at(3600.0 * hour * si::second).hub_motion();
    const Eigen::Vector3d w = now.turning.angular_velocity.coordinates() * 180.0 / M_PI;
    const auto nadir_b = inverse(now.turning.rotation) * -direction(now.translation.vector());
    std::printf("%8d %14.9f %14.9f %14.9f %14.4f deg\n", hour, w.x(), w.y(), w.z(),
                std::acos(nadir_b.x().value()) * 180.0 / M_PI);
  }

  const auto end = trajectory.at(trajectory.end());
  std::printf("\nDifference after 8 h in attitude, rate and position\n");
  double nasa_bounds[] = {1e-10, 1e-14, 1e-3};
  compare("NASA", end, nasa_T().transpose(), nasa_w_b, nasa_r_i, nasa_bounds);
#ifdef VECTRIX_WITH_SIMBODY
  const auto theirs = propagate_with_simbody(
      flight, start, {.end = trajectory.end(), .accuracy = 1e-12, .time_scale = 1000.0 * si::second});
  const auto simbody = theirs.at(theirs.end()).hub_motion();
  double simbody_bounds[] = {1e-6, 1e-9, 10.0};
  compare("Simbody", end, simbody.turning.rotation.matrix(), simbody.turning.angular_velocity.coordinates(),
          simbody.translation.coordinates(), simbody_bounds);
#else
  std::printf("Simbody   not compared: this example was built without it\n");
#endif
}

}  // namespace

int main() try { run(); } catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
