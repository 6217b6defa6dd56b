#include <gtest/gtest.h>

#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "load/three_parts.hpp"
#include "methods.hpp"

// What sticks is at rest, to the last bit, at any time and with any method.
namespace vectrix_test::three_parts::sticking_test {
namespace {

TEST(Sticking, WhatSticksHasNoSpeed) {
  const Sat sat;
  const auto rubbing =
      scenario(sat, friction(sat, of<Panel>, 0.3 * N_m, 0.4 * N_m, 0.1 * rad_s, 0.1 * (N_m / rad_s)),
               friction(sat, of<Mass>, 0.7 * N, 0.7 * N, 1.0 * m_s, 0.0 * (N / m_s)),
               friction(sat, of<Wheel>, 0.2 * N_m, 0.2 * N_m, 1.0 * rad_s, 0.0 * (N_m / rad_s)),
               pulse(sat, of<Hub>, 0.02 * N_m * unit_x(in<Hub>), 0.3 * s, 0.7 * s));
  for (const double epoch : {0.0, 8e8}) {
    const auto start =
        start_of(sat, {.time = epoch, .rate = 0.31, .velocity = -0.47, .spin = 1.7, .hub_rate = 0.05});
    const auto expect_rests = [&](ode::Method method, AttitudeState attitude) {
      auto how = until(epoch + 6.0, 1e-9);
      how.method = method;
      how.attitude = attitude;
      const auto flight = propagate(rubbing, start, how);
      double panel = epoch, mass = epoch, wheel = epoch;
      for (const auto& event : flight.events()) {
        const double t = event.state.time().value();
        if (event.name == frame_name<Panel>() + " comes to rest") panel = t;
        if (event.name == frame_name<Mass>() + " comes to rest") mass = t;
        if (event.name == frame_name<Wheel>() + " comes to rest") wheel = t;
      }
      for (const double rests : {panel, mass, wheel}) {
        EXPECT_GT(rests, epoch + 0.1);
        EXPECT_LT(rests, epoch + 5.0);
      }
      const auto expect_rest = [&](double t) {
        const auto now = flight.at(t * s);
        const auto expect_none = [&](double since, double speed) {
          if (t < since) return;
          EXPECT_EQ(speed, 0.0) << t << ' ' << static_cast<int>(method);
        };
        expect_none(panel, now.speed(of<Panel>).value());
        expect_none(mass, now.speed(of<Mass>).value());
        expect_none(wheel, now.spin(of<Wheel>).value());
      };
      for (double t = epoch; t <= epoch + 6.0; t += 0.0625) expect_rest(t);
      expect_rest(panel), expect_rest(mass), expect_rest(wheel);
      EXPECT_EQ(flight.at((epoch + 5.0) * s).coordinate(of<Mass>),
                flight.at((epoch + 6.0) * s).coordinate(of<Mass>));
    };
    for (const ode::Method method : methods) expect_rests(method, AttitudeState::quaternion);
    expect_rests(ode::Method::verner_9, AttitudeState::dcm);
  }
}

}  // namespace
}  // namespace vectrix_test::three_parts::sticking_test
