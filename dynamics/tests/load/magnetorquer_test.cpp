#include <gtest/gtest.h>

#include <vectrix/dynamics/load/magnetorquer.hpp>

#include "load/three_parts.hpp"

namespace vectrix_test::three_parts::magnetorquer_test {
namespace {

constexpr double rounding = 1e-13;  // of numbers near 1, in a run of some ten steps

const auto A_m2 = Quantity<si::magnetic_dipole_moment>::from_value(1.0);
const auto tesla = Quantity<si::magnetic_flux_density>::from_value(1.0);

// m = (0, 2, 0) A m^2 on the panel, B = (-0.1, 0, 0) T in its axes: M = (0, 0, 0.2) N m. In the axes of the
// panel the torque is constant; without a dipole there is none.
TEST(Magnetorquer, TurnsThePanelWhileItsDipoleIsOn) {
  const Sat sat;
  const Dipole<Panel> off{0.0 * A_m2 * unit_y(in<Panel>)}, on{2.0 * A_m2 * unit_y(in<Panel>)};
  const auto field = [&](const Now<Sat>&) { return -0.1 * tesla * unit_x(in<Panel>); };
  const auto driven = scenario(sat, held(off), magnetorquer(sat, of<Panel>, field),
                               at_times({1.0 * s}, becomes(on)), at_times({3.0 * s}, becomes(off)));
  const auto flight = propagate(driven, start_of(sat, {}), until(4.0));
  EXPECT_EQ(flight.at(1.0 * s).speed(of<Panel>).value(), 0.0);
  EXPECT_NEAR(flight.at(4.0 * s).speed(of<Panel>).value(), 0.2 * 2.0 / J_panel, rounding);
}

// With the field in other axes, as the user's own cross product; also on a mount.
TEST(Magnetorquer, TheFieldMayBeInAnyFrameOfTheCraft) {
  const Sat sat;
  const auto start = start_of(sat, {.angle = 0.7, .rate = 0.3, .hub_rate = 0.2});
  const auto B_i = vector(in<Inertial>, 0.3 * tesla, -0.1 * tesla, 0.2 * tesla);
  const auto m_n = vector(in<Nozzle>, 1.0 * A_m2, 3.0 * A_m2, -2.0 * A_m2);
  const auto driven = scenario(sat, held(Dipole<Nozzle>{m_n}),
                               magnetorquer(sat, of<Nozzle>, [&](const Now<Sat>&) { return B_i; }));
  const auto found = motion_at(driven, propagate(driven, start, until(0.1)), 0.0 * s).rates();
  const auto wanted = motion(sat, start, [&](const Now<Sat>& now, Forces<Sat>& forces) {
                        const auto m_i = now.rotation(to<Inertial>, from<Nozzle>) * m_n;
                        forces.torque(of<Panel>, cross(m_i, B_i));
                      }).rates();
  for (std::size_t i = 0; i < Sat::state_size; ++i) EXPECT_NEAR(found[i], wanted[i], 10 * rounding) << i;
}

}  // namespace
}  // namespace vectrix_test::three_parts::magnetorquer_test
