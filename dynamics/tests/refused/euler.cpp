// Euler's equation
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Eci : inertial_frame {};
struct Ecef : moving_frame {};
struct Body : moving_frame {};
struct Wheel : moving_frame {};
struct Panel : moving_frame {};
struct Hinge : named_point {};

namespace angular_acceleration_as_rate {
// mistake: what Euler's equation gives, taken for an angular velocity
// expect: AngularAcceleration<Eci, Body
// expect: AngularVelocity<Eci, Body
auto after(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
           const Vector<Body, si::torque>& torque_body) {
#ifdef REPAIRED
  const AngularAcceleration<Eci, Body, In<Body>> change = euler(J_body, w_body, torque_body);
#else
  const AngularVelocity<Eci, Body, In<Body>> change = euler(J_body, w_body, torque_body);
#endif
  return change;
}
}  // namespace angular_acceleration_as_rate

namespace euler_angular_momentum_for_torque {
// mistake: Euler's equation with an angular momentum for the torque
// expect: TorqueGiven = (vectrix::)?AngularMomentum<
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Torque<CentreOfMassOf<Body>, In<Body>>& M_body,
                  const AngularMomentum<CentreOfMassOf<Body>, In<Body>>& H_body) {
#ifdef REPAIRED
  return static_cast<void>(H_body), euler(J_body, w_body, M_body);
#else
  return static_cast<void>(M_body), euler(J_body, w_body, H_body);
#endif
}
}  // namespace euler_angular_momentum_for_torque

namespace euler_energy_for_torque {
// mistake: a torque made of energies, which are joules, not newton metres
// expect: UnitGiven = (vectrix::)?si::energy
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  const auto unit = si::newton_metre;
#else
  const auto unit = si::joule;
#endif
  const Vector<Body, si::torque> torque = vector(in<Body>, 1.0 * unit, 2.0 * unit, 3.0 * unit);
  return euler(J_body, w_body, torque);
}
}  // namespace euler_energy_for_torque

namespace euler_force_for_torque {
// mistake: Euler's equation driven by a force
// expect: TorqueGiven = (vectrix::)?Vector<Body, (vectrix::)?si::force
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Vector<Body, si::length>& r_body, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return euler(J_body, w_body, cross(r_body, F_body));
#else
  static_cast<void>(r_body);
  return euler(J_body, w_body, F_body);
#endif
}
}  // namespace euler_force_for_torque

namespace euler_in_rotating_reference {
// mistake: Euler's equation relative to the rotating Earth
// expect: RateRelativeTo = Ecef
#ifdef REPAIRED
using Reference = Eci;
#else
using Reference = Ecef;
#endif

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Reference, Body, In<Body>>& w_body,
                  const Vector<Body, si::torque>& torque_body) {
  return euler(J_body, w_body, torque_body);
}
}  // namespace euler_in_rotating_reference

namespace euler_inertia_about_hinge {
// mistake: Euler's equation, about the centre of mass, with the inertia about a hinge
// expect: InertiaAbout = Hinge
// expect: InertiaOf = Body
auto acceleration(const Inertia<Body, Hinge>& J_hinge, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Vector<Body, si::torque>& torque_body,
                  const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                  const Quantity<si::mass>& mass) {
#ifdef REPAIRED
  return euler(shift(J_hinge, r_hc, mass), w_body, torque_body);
#else
  return static_cast<void>(r_hc), static_cast<void>(mass), euler(J_hinge, w_body, torque_body);
#endif
}
}  // namespace euler_inertia_about_hinge

namespace euler_inertia_of_other_body {
// mistake: Euler's equation of one body with the inertia of another
// expect: InertiaOf = Wheel
// expect: RateOf = Body
#ifdef REPAIRED
auto acceleration(const Inertia<Body>& J, const AngularVelocity<Eci, Body, In<Body>>& w_body,
#else
auto acceleration(const Inertia<Wheel>& J, const AngularVelocity<Eci, Body, In<Body>>& w_body,
#endif
                  const Vector<Body, si::torque>& torque_body) {
  return euler(J, w_body, torque_body);
}
}  // namespace euler_inertia_of_other_body

namespace euler_rate_in_reference {
// mistake: Euler's equation with the rate expressed in the inertial frame
// expect: RateIn = Eci
// expect: InertiaOf = Body
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Eci>>& w_eci,
                  const Dcm<Body, Eci>& R_body_from_eci, const Vector<Body, si::torque>& torque_body) {
#ifdef REPAIRED
  return euler(J_body, R_body_from_eci * w_eci, torque_body);
#else
  static_cast<void>(R_body_from_eci);
  return euler(J_body, w_eci, torque_body);
#endif
}
}  // namespace euler_rate_in_reference

namespace euler_torque_about_hinge {
// mistake: Euler's equation with the torque about a hinge
// expect: Torque<Hinge
// expect: InertiaAbout = (vectrix::)?CentreOfMassOf<Body>
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Torque<Hinge, In<Body>>& M_hinge,
                  const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                  const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return euler(J_body, w_body, shift(M_hinge, r_hc, F));
#else
  return static_cast<void>(r_hc), static_cast<void>(F), euler(J_body, w_body, M_hinge);
#endif
}
}  // namespace euler_torque_about_hinge

namespace euler_torque_in_inertial_axes {
// mistake: Euler's equation in the body's axes with a torque in inertial ones
// expect: TorqueGiven = (vectrix::)?Vector<Eci
// expect: InertiaOf = Body
auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Dcm<Body, Eci>& R_body_from_eci, const Vector<Eci, si::torque>& torque_eci) {
#ifdef REPAIRED
  return euler(J_body, w_body, R_body_from_eci * torque_eci);
#else
  static_cast<void>(R_body_from_eci);
  return euler(J_body, w_body, torque_eci);
#endif
}
}  // namespace euler_torque_in_inertial_axes

namespace torque_free_about_hinge {
// mistake: the torque-free motion with the inertia about a hinge
// expect: InertiaAbout = Hinge
// expect: StateOf = Panel
// expect: about its centre of mass
auto tumble(const Inertia<Panel, Hinge, In<Panel>>& J_hinge_panel, const State<Gcrf, Panel>& start,
            [[maybe_unused]] const Quantity<si::mass>& mass,
            [[maybe_unused]] const Displacement<Hinge, CentreOfMassOf<Panel>, In<Panel>>& r_hc_panel) {
#ifdef REPAIRED
  return torque_free(shift(J_hinge_panel, r_hc_panel, mass), start);
#else
  return torque_free(J_hinge_panel, start);
#endif
}
}  // namespace torque_free_about_hinge

namespace torque_free_of_other_body {
// mistake: the torque-free motion of one body with the inertia of another
// expect: InertiaOf = Wheel
// expect: StateOf = Body
// expect: one body b
auto tumble([[maybe_unused]] const Inertia<Wheel>& J_wheel, [[maybe_unused]] const Inertia<Body>& J_body,
            const State<Gcrf, Body>& start) {
#ifdef REPAIRED
  return torque_free(J_body, start);
#else
  return torque_free(J_wheel, start);
#endif
}
}  // namespace torque_free_of_other_body

namespace state_relative_to_moving_frame {
// mistake: a state relative to the rotating Earth
// expect: InertialFrame
// expect: Ecef
struct Ecef : moving_frame {};
#ifdef REPAIRED
double start(const State<Gcrf, Body>& state);
#else
double start(const State<Ecef, Body>& state);
#endif
}  // namespace state_relative_to_moving_frame
