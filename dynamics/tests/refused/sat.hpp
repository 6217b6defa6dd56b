#pragma once

#include <vectrix/dynamics.hpp>

// Two crafts of one shape, for the refused programs.
using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Dish : moving_frame {};
struct Wheel : named_point {};

auto make_sat() {
  return spacecraft(
      body(mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                           trust_inertia(in<Hub>, Eigen::Matrix3d::Identity())),
           turning_in<Gcrf>),
      rotor(of<Wheel>, unit_x(in<Hub>), 0.1 * si::kilogram_square_metre));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};
struct Probe : decltype(make_sat()) {
  Probe() : decltype(make_sat())(make_sat()) {}
};
