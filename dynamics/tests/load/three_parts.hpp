#pragma once

#include <vectrix/dynamics/craft/propagate.hpp>

#include "short_units.hpp"
#include "testing/attitudes.hpp"

/// A hub with a panel on a hinge about z, a mass on a slider along x, a wheel about z and a mount: of round
/// numbers, so that its motions about z and along x are known.
namespace vectrix_test::three_parts {

using namespace vectrix;
using namespace vectrix_test::short_units;

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};
struct Panel : moving_frame {};
struct Mass : moving_frame {};
struct Nozzle : moving_frame {};
struct Wheel : named_point {};

// About z and along x: kg m^2, kg.
constexpr double J_hub = 2.0, J_panel = 0.5, J_wheel = 0.1, J_mass = 0.25;
/// About z, of the hub and the mass; the panel and the wheel are free.
constexpr double J_rest = J_hub - J_wheel + J_mass;
constexpr double m_hub = 6.0, m_panel = 2.0, m_mass = 1.0;

template <Frame B> MassProperties<B> mass(double kg, double J_z) {
  return mass_properties(
      kg * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
      inertia_from_principal_moments(in<B>, 0.7 * J_z * kg_m2, 0.8 * J_z * kg_m2, J_z * kg_m2));
}
template <Frame P, Frame B> Transform<P, B> at_origin() {
  return {aligned(to<P>, from<B>), coincident(of<B>, relative_to<P>, in<P>)};
}
inline auto make_sat() {
  return spacecraft(body(mass<Hub>(m_hub, J_hub), free_in<Inertial>),
                    body(mass<Panel>(m_panel, J_panel), hinge(at_origin<Hub, Panel>(), unit_z(in<Panel>))),
                    body(mass<Mass>(m_mass, J_mass), slider(at_origin<Hub, Mass>(), unit_x(in<Mass>))),
                    rotor(of<Wheel>, unit_z(in<Hub>), J_wheel * kg_m2),
                    mount(Transform{turned_z(to<Panel>, from<Nozzle>, 0.3 * rad),
                                    displacement(of<Nozzle>, relative_to<Panel>,
                                                 vector(in<Panel>, 0.0 * m, 1.5 * m, 0.2 * m))}));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

struct Starting {
  double time = 0.0, angle = 0.0, rate = 0.0, length = 0.0, velocity = 0.0, spin = 0.0;
  double hub_rate = 0.0;  // about z
};
inline CraftState<Sat> start_of(const Sat& sat, const Starting& with) {
  return state(sat, with.time * s,
               MovingTransform<Inertial, Hub>{
                   moving_dcm(aligned(to<Inertial>, from<Hub>),
                              angular_velocity(of<Hub>, relative_to<Inertial>,
                                               with.hub_rate * rad_s * unit_z(in<Hub>))),
                   coincident(of<Hub>, relative_to<Inertial>, in<Inertial>),
                   at_rest(of<Hub>, relative_to<Inertial>, observed_from<Inertial>, in<Inertial>)},
               starts(of<Panel>, with.angle * rad, with.rate * rad_s),
               starts(of<Mass>, with.length * m, with.velocity * m_s), spins(of<Wheel>, with.spin * rad_s));
}
inline CraftPropagation until(double end, double tolerance = 1e-13) {
  return {
      .end = end * s,
      .relative_tolerance = tolerance,
      .absolute_tolerances = {tolerance * rad, tolerance * rad_s, tolerance * m, tolerance * m_s, tolerance}};
}

}  // namespace vectrix_test::three_parts
