#pragma once

#include <vectrix/dynamics.hpp>

// A craft with a panel on a hinge and a wheel, for the refused programs.
using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Panel : moving_frame {};
struct Wheel : named_point {};

template <Frame B> auto unit_mass() {
  return mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                         trust_inertia(in<B>, Eigen::Matrix3d::Identity()));
}
auto make_sat() {
  return spacecraft(
      body(unit_mass<Hub>(), free_in<Gcrf>),
      body(unit_mass<Panel>(),
           hinge(Transform{aligned(to<Hub>, from<Panel>), coincident(of<Panel>, relative_to<Hub>, in<Hub>)},
                 unit_x(in<Panel>))),
      rotor(of<Wheel>, unit_x(in<Hub>), 0.1 * si::kilogram_square_metre));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};
