#include <cmath>
#include <exception>
#include <iostream>
#include <vector>
#include <vectrix/dynamics/analysis/equilibrium.hpp>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/simbody.hpp>

// SUNDIALS (CVODE, ARKODE and KINSOL, inside Vectrix) and Simbody, which exports an old CVODE under the same
// names, in one process. Each must still follow an exact motion, KINSOL find where its torques vanish. Built
// twice, with the libraries in both orders. Returns the number of engines that fail.
namespace {

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Body : moving_frame {};

constexpr double end = 20.0;  // s, twelve radians of precession
/// About ten times the measured errors, 1e-11 to 1e-9. An engine with the other's symbols does not move, or
/// crashes.
constexpr double tolerance = 1e-8;

/// J = diag(a, a, c) without torque, from the identity attitude: h is fixed in space, and the body turns
/// about it at |h| / a and about its own axis at n (1 - c/a), so that R_b^i = exp(t h / a) exp(t n (1 - c/a)
/// e3).
constexpr double a = 2.0;
constexpr double c = 3.0;
const Eigen::Vector3d w0(0.4, 0.0, 0.8);

Eigen::Matrix3d exact() {
  const Eigen::Vector3d h(a * w0.x(), a * w0.y(), c * w0.z());
  return (Eigen::AngleAxisd(end * h.norm() / a, h.normalized()) *
          Eigen::AngleAxisd(end * w0.z() * (1.0 - c / a), Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

auto make_top() {
  const auto moment = [](double value) { return value * si::kilogram_square_metre; };
  const auto J_b = inertia_from_principal_moments(in<Body>, moment(a), moment(a), moment(c));
  return spacecraft(
      body(mass_properties(1.0 * si::kilogram,
                           coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>), J_b),
           turning_in<Inertial>));
}
using Top = decltype(make_top());
CraftState<Top> start_of(const Top& craft) {
  const MovingDcm spinning{
      aligned(to<Inertial>, from<Body>),
      angular_velocity(of<Body>, relative_to<Inertial>, vector<si::angular_velocity>(in<Body>, w0))};
  return state(craft, 0.0 * si::second, spinning);
}

Eigen::Matrix3d by_vectrix(ode::Method method) {
  const Top craft = make_top();
  const auto trajectory =
      propagate(scenario(craft), start_of(craft),
                {.end = end * si::second,
                 .relative_tolerance = 1e-12,
                 .absolute_tolerances = {1e-12 * si::radian, 1e-15 * (si::radian / si::second),
                                         1e-6 * si::metre, 1e-9 * (si::metre / si::second), 1e-12},
                 .method = method});
  return trajectory(trajectory.end()).rotation.matrix();
}

/// Where a torsion wire, which pulls towards the exact attitude, is at rest.
Eigen::Matrix3d by_kinsol() {
  const auto kg_m2 = si::kilogram_square_metre;
  const auto craft = spacecraft(body(
      mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>),
                      inertia_from_principal_moments(in<Body>, a * kg_m2, a * kg_m2, c * kg_m2)),
      turning_in<Inertial>));
  const Eigen::Matrix3d R_i_from_w = exact();
  const auto wire = [&]<class Now, class Forces>(const Now& now, Forces& forces) {
    const auto R = now.rotation(to<Inertial>, from<Body>).matrix().eval();
    using S = typename decltype(R)::Scalar;
    const Eigen::Matrix<S, 3, 3> T = R_i_from_w.transpose().cast<S>() * R;
    forces.torque(of<Body>,
                  vector<si::torque>(in<Body>, Eigen::Matrix<S, 3, 1>(T(1, 2) - T(2, 1), T(2, 0) - T(0, 2),
                                                                      T(0, 1) - T(1, 0))));
  };
  const auto near = Eigen::Matrix3d(R_i_from_w * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()));
  const auto guess = state(
      craft, 0.0 * si::second,
      moving_dcm(dcm(to<Inertial>, from<Body>, near), at_rest(of<Body>, relative_to<Inertial>, in<Body>)));
  const EquilibriumTolerances fine{1e-10 * (si::radian / (si::second * si::second)),
                                   1e-10 * (si::metre / (si::second * si::second)), 1e-10};
  return equilibrium(scenario(craft, wire), guess, fine).turning().rotation.matrix();
}

Eigen::Matrix3d by_simbody() {
  const Top craft = make_top();
  const auto trajectory =
      propagate_with_simbody(scenario(craft), start_of(craft), {.end = end * si::second, .accuracy = 1e-11});
  return trajectory(trajectory.end()).rotation.matrix();
}

template <class Engine> int check(const char* name, const Engine& engine) {
  try {
    const double error = (engine() - exact()).norm();
    std::cout << name << ": error " << error << ", tolerance " << tolerance << '\n';
    return error < tolerance ? 0 : 1;
  } catch (const std::exception& failure) {
    std::cout << name << ": " << failure.what() << '\n';
    return 1;
  }
}

}  // namespace

int main() {
  int wrong = 0;
  for (int round = 0; round < 2; ++round) {  // so that each engine also runs after each other one
    wrong += check("Vectrix, CVODE", [] { return by_vectrix(ode::Method::cvode_adams); });
    wrong += check("Simbody", by_simbody);
    wrong += check("Vectrix, KINSOL", by_kinsol);
    wrong += check("Vectrix, ARKODE", [] { return by_vectrix(ode::Method::arkode_fehlberg_8); });
  }
  return wrong;
}
