// Ready loads on a craft
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Panel : moving_frame {};
struct Mast : moving_frame {};
struct Wheel : named_point {};

template <Frame B> auto unit_mass() {
  return mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                         trust_inertia(in<B>, Eigen::Matrix3d::Identity()));
}
template <HubMotion motion> auto make_craft(MovesIn<Gcrf, motion> moves) {
  return spacecraft(
      body(unit_mass<Hub>(), moves),
      body(unit_mass<Panel>(),
           hinge(Transform{aligned(to<Hub>, from<Panel>), coincident(of<Panel>, relative_to<Hub>, in<Hub>)},
                 unit_x(in<Panel>))),
      body(unit_mass<Mast>(),
           slider(Transform{aligned(to<Hub>, from<Mast>), coincident(of<Mast>, relative_to<Hub>, in<Hub>)},
                  unit_x(in<Mast>))),
      rotor(of<Wheel>, unit_x(in<Hub>), 0.1 * si::kilogram_square_metre));
}
struct Sat : decltype(make_craft(free_in<Gcrf>)) {
  Sat() : decltype(make_craft(free_in<Gcrf>))(make_craft(free_in<Gcrf>)) {}
};
struct Turning : decltype(make_craft(turning_in<Gcrf>)) {
  Turning() : decltype(make_craft(turning_in<Gcrf>))(make_craft(turning_in<Gcrf>)) {}
};
constexpr auto N_m = si::newton_metre;
constexpr auto rad = si::radian;
constexpr auto s = si::second;

namespace gravity_without_a_place {
// mistake: the attraction of the Earth on a craft that does not know where it is
// expect: free_in<I>
auto gravity(const Sat& sat, const Turning& turning, const Quantity<si::gravitational_parameter>& mu) {
#ifdef REPAIRED
  return static_cast<void>(turning), point_mass(sat, mu);
#else
  return static_cast<void>(sat), point_mass(turning, mu);
#endif
}
}  // namespace gravity_without_a_place

namespace gravity_of_a_mass {
// mistake: a mass where its gravitational parameter is due
// expect: m\^3/s\^2
auto gravity(const Sat& sat) {
#ifdef REPAIRED
  return point_mass(sat, Quantity<si::gravitational_parameter>::from_value(3.986004418e14));
#else
  return point_mass(sat, 5.97e24 * si::kilogram);
#endif
}
}  // namespace gravity_of_a_mass

namespace a_spring_on_the_hub {
// mistake: a spring on the hub, which hangs on nothing
// expect: b on a hinge
auto panel_spring(const Sat& sat) {
#ifdef REPAIRED
  return spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad);
#else
  return spring(sat, of<Hub>, 2.0 * N_m / rad, 0.0 * rad);
#endif
}
}  // namespace a_spring_on_the_hub

namespace a_motor_in_newtons {
// mistake: a force where the torque on a wheel is due
// expect: an effort on a joint
auto motor(const Sat& sat) {
#ifdef REPAIRED
  return pulse(sat, of<Wheel>, 0.1 * N_m, 0.0 * s, 1.0 * s);
#else
  return pulse(sat, of<Wheel>, 0.1 * si::newton, 0.0 * s, 1.0 * s);
#endif
}
}  // namespace a_motor_in_newtons

namespace a_pulse_in_a_foreign_frame {
// mistake: a pulse expressed in a frame that the craft does not have
// expect: in frames of C
struct Lvlh : moving_frame {};
auto push(const Sat& sat) {
#ifdef REPAIRED
  return pulse(sat, of<Panel>, 0.1 * N_m * unit_x(in<Gcrf>), 0.0 * s, 1.0 * s);
#else
  return pulse(sat, of<Panel>, 0.1 * N_m * unit_x(in<Lvlh>), 0.0 * s, 1.0 * s);
#endif
}
}  // namespace a_pulse_in_a_foreign_frame

namespace a_pulse_about_another_origin {
// mistake: a wrench on the panel about the origin of the hub
// expect: wrench in frames of C
auto push(const Sat& sat, const Wrench<Hub, In<Hub>>& W_h_h,
          const Displacement<Hub, Panel, In<Hub>>& r_hp_h) {
#ifdef REPAIRED
  return pulse(sat, of<Panel>, shift(W_h_h, r_hp_h), 0.0 * s, 1.0 * s);
#else
  return static_cast<void>(r_hp_h), pulse(sat, of<Panel>, W_h_h, 0.0 * s, 1.0 * s);
#endif
}
}  // namespace a_pulse_about_another_origin

namespace a_pulse_outside_a_scenario {
// mistake: the accelerations under a pulse, which says nothing of the time before a scenario holds it
// expect: motion_at\(scenario, trajectory, time\)
auto alpha(const Sat& sat, const CraftState<Sat>& state) {
  const auto push = pulse(sat, of<Wheel>, 0.1 * N_m, 0.0 * s, 1.0 * s);
#ifdef REPAIRED
  return static_cast<void>(state), scenario(sat, push);
#else
  return motion(sat, state, push);
#endif
}
}  // namespace a_pulse_outside_a_scenario

namespace an_effort_on_the_hub {
// mistake: an effort as a function of time on the hub, which hangs on nothing
// expect: an effort on a joint
auto drive(const Sat& sat) {
  const auto torque = [](Quantity<si::time> t) { return t / s * 0.1 * N_m; };
#ifdef REPAIRED
  return of_time(sat, of<Panel>, torque);
#else
  return of_time(sat, of<Hub>, torque);
#endif
}
}  // namespace an_effort_on_the_hub

namespace a_function_of_a_number {
// mistake: a torque as a function of a bare number, not of the time
// expect: f\(t\)
#ifdef REPAIRED
const auto torque = [](Quantity<si::time> t) { return t / s * 0.1 * N_m; };
#else
const auto torque = [](double t) { return t * 0.1 * N_m; };
#endif
auto drive(const Sat& sat) {
  return of_time(sat, of<Wheel>, torque);
}
}  // namespace a_function_of_a_number

namespace a_load_on_another_craft {
// mistake: a pulse on another craft
// expect: IsNoLoad<
auto flight(const Sat& sat, const Turning& turning) {
#ifdef REPAIRED
  return static_cast<void>(turning), scenario(sat, pulse(sat, of<Wheel>, 0.1 * N_m, 0.0 * s, 1.0 * s));
#else
  return scenario(sat, pulse(turning, of<Wheel>, 0.1 * N_m, 0.0 * s, 1.0 * s));
#endif
}
}  // namespace a_load_on_another_craft

namespace a_lock_of_the_hub {
// mistake: the hub is locked, which hangs on nothing
// expect: that hangs on a joint, or a rotor
void lock(Forces<Sat>& forces) {
#ifdef REPAIRED
  forces.lock(of<Panel>);
#else
  forces.lock(of<Hub>);
#endif
}
}  // namespace a_lock_of_the_hub

namespace a_latch_of_the_hub {
// mistake: the hub can be locked, which hangs on nothing
// expect: a body of C on a joint that moves, or a rotor; at the start a Locked<B>
auto latch(const Sat& sat) {
#ifdef REPAIRED
  return lockable(sat, of<Panel>);
#else
  return lockable(sat, of<Hub>);
#endif
}
}  // namespace a_latch_of_the_hub

namespace friction_of_a_wheel_in_newtons {
// mistake: the friction of a wheel in newtons
// expect: hinge, rotor: N m
auto rub(const Sat& sat) {
  const auto c = 1e-3 * N_m / (rad / s);
#ifdef REPAIRED
  return friction(sat, of<Wheel>, 0.1 * N_m, 0.2 * N_m, 1.0 * (rad / s), c);
#else
  return friction(sat, of<Wheel>, 0.1 * si::newton, 0.2 * si::newton, 1.0 * (rad / s), c);
#endif
}
}  // namespace friction_of_a_wheel_in_newtons

namespace friction_on_the_hub {
// mistake: friction on the hub, which hangs on nothing
// expect: hinge, rotor: N m
auto rub(const Sat& sat) {
  const auto c = 1e-3 * N_m / (rad / s);
#ifdef REPAIRED
  return friction(sat, of<Panel>, 0.1 * N_m, 0.2 * N_m, 1.0 * (rad / s), c);
#else
  return friction(sat, of<Hub>, 0.1 * N_m, 0.2 * N_m, 1.0 * (rad / s), c);
#endif
}
}  // namespace friction_on_the_hub

namespace two_frictions_on_one_wheel {
// mistake: a wheel has two frictions
// expect: IsHeldTwice<(vectrix::)?StickSlip<Wheel>
auto flight(const Sat& sat) {
  const auto rub = friction(sat, of<Wheel>, 0.1 * N_m, 0.2 * N_m, 1.0 * (rad / s), 1e-3 * N_m / (rad / s));
#ifdef REPAIRED
  return scenario(sat, rub);
#else
  return scenario(sat, rub, rub);
#endif
}
}  // namespace two_frictions_on_one_wheel

namespace a_stop_in_metres {
// mistake: the stops of a hinge in metres
// expect: hinge: rad
auto stops(const Sat& sat) {
  const auto k = 100.0 * N_m / rad;
  const auto c = 1.0 * N_m / (rad / s);
#ifdef REPAIRED
  return stop_at(sat, of<Panel>, -1.0 * rad, 1.0 * rad, k, c);
#else
  return stop_at(sat, of<Panel>, -1.0 * si::metre, 1.0 * si::metre, k, c);
#endif
}
}  // namespace a_stop_in_metres

namespace limits_of_a_slider_as_angles {
// mistake: the stops of a slider as angles, with a stiffness that makes a force of them
// expect: slider: m
auto stops(const Sat& sat) {
  const auto c = 1.0 * si::newton / (si::metre / s);
#ifdef REPAIRED
  return stop_at(sat, of<Mast>, 0.0 * si::metre, 1.0 * si::metre, 100.0 * si::newton / si::metre, c);
#else
  return stop_at(sat, of<Mast>, 0.0 * rad, 1.0 * rad, 100.0 * si::newton / rad, c);
#endif
}
}  // namespace limits_of_a_slider_as_angles

namespace stops_of_a_slider_with_the_damping_of_a_hinge {
// mistake: the damping of the stops of a slider for an angular velocity
// expect: slider: m, N/m, N s/m
auto stops(const Sat& sat) {
  const auto k = 100.0 * si::newton / si::metre;
#ifdef REPAIRED
  return stop_at(sat, of<Mast>, 0.0 * si::metre, 1.0 * si::metre, k, 1.0 * si::newton / (si::metre / s));
#else
  return stop_at(sat, of<Mast>, 0.0 * si::metre, 1.0 * si::metre, k, 1.0 * si::newton / (rad / s));
#endif
}
}  // namespace stops_of_a_slider_with_the_damping_of_a_hinge

namespace a_damper_of_a_hinge_in_metres {
// mistake: the damping of a hinge for a velocity, though it makes a torque of it
// expect: b on a hinge, N m s/rad
auto damped(const Sat& sat) {
#ifdef REPAIRED
  return damper(sat, of<Panel>, 1.0 * N_m / (rad / s));
#else
  return damper(sat, of<Panel>, 1.0 * N_m / (si::metre / s));
#endif
}
}  // namespace a_damper_of_a_hinge_in_metres

namespace a_spring_of_a_slider_as_an_angle {
// mistake: the place of rest of a slider as an angle
// expect: or on a slider, N/m and m
auto sprung(const Sat& sat) {
#ifdef REPAIRED
  return spring(sat, of<Mast>, 1.0 * si::newton / si::metre, 0.1 * si::metre);
#else
  return spring(sat, of<Mast>, 1.0 * si::newton / rad, 0.1 * rad);
#endif
}
}  // namespace a_spring_of_a_slider_as_an_angle

namespace a_thruster_in_newton_metres {
// mistake: the full thrust as a torque
// expect: F in N in a frame
auto engine(const Sat& sat) {
  const ThrustResponse response{0.01 * s, 0.02 * s};
#ifdef REPAIRED
  return thruster(sat, of<Hub>, 1.0 * si::newton * unit_x(in<Hub>), response, {{1.0 * s, 2.0 * s}});
#else
  return thruster(sat, of<Hub>, 1.0 * N_m * unit_x(in<Hub>), response, {{1.0 * s, 2.0 * s}});
#endif
}
}  // namespace a_thruster_in_newton_metres

namespace a_field_of_the_time {
// mistake: the magnetic field as a function of the time, not of the instant of the craft
// expect: gives tesla in a frame of C
auto coils(const Sat& sat, const Vector<Gcrf, si::magnetic_flux_density>& B_i) {
#ifdef REPAIRED
  return magnetorquer(sat, of<Hub>, [=](const Now<Sat>&) { return B_i; });
#else
  return magnetorquer(sat, of<Hub>, [=](Quantity<si::time>) { return B_i; });
#endif
}
}  // namespace a_field_of_the_time

namespace coils_without_a_dipole {
// mistake: nothing holds the dipole of the coils
// expect: NothingHolds<(vectrix::)?Dipole<Hub>
auto flight(const Sat& sat, const Vector<Gcrf, si::magnetic_flux_density>& B_i, const Dipole<Hub>& dipole) {
  const auto coils = magnetorquer(sat, of<Hub>, [=](const Now<Sat>&) { return B_i; });
#ifdef REPAIRED
  return scenario(sat, held(dipole), coils);
#else
  return static_cast<void>(dipole), scenario(sat, coils);
#endif
}
}  // namespace coils_without_a_dipole

namespace the_same_load_on_a_type {
// mistake: one spring where a function is due that gives that of each joint
// expect: each\(of_each<A, B>, f\)
auto springs(const Sat& sat) {
#ifdef REPAIRED
  return each(of_each<Panel>, [&](auto b) { return spring(sat, b, 2.0 * N_m / rad, 0.0 * rad); });
#else
  return each(of_each<Panel>, spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad));
#endif
}
}  // namespace the_same_load_on_a_type

namespace starts_of_fewer {
// mistake: two angles for the starts of three hinges
// expect: of each a value, or a std::array of all
template <int i> struct Blade : moving_frame {};
auto blades() {
#ifdef REPAIRED
  const std::array angles{0.1 * rad, 0.2 * rad, 0.3 * rad};
#else
  const std::array angles{0.1 * rad, 0.2 * rad};
#endif
  return starts(of_numbered<Blade, 1, 3>, angles, 0.0 * rad / s);
}
}  // namespace starts_of_fewer

namespace a_spring_without_its_craft {
// mistake: the craft of a spring is left out
// expect: spring\(craft, of<B>, k, q_0\)
auto panel_spring(const Sat& sat) {
#ifdef REPAIRED
  return spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad);
#else
  return static_cast<void>(sat), spring(of<Panel>, 2.0 * N_m / rad, 0.0 * rad);
#endif
}
}  // namespace a_spring_without_its_craft

namespace a_spring_without_its_rest {
// mistake: a spring without its place of rest
// expect: spring\(craft, of<B>, k, q_0\)
auto panel_spring(const Sat& sat) {
#ifdef REPAIRED
  return spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad);
#else
  return spring(sat, of<Panel>, 2.0 * N_m / rad);
#endif
}
}  // namespace a_spring_without_its_rest
