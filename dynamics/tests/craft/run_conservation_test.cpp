#include <algorithm>
#include <cmath>
#include <sstream>
#include <vectrix/dynamics/craft/conservation.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "craft/rigid_craft.hpp"
#include "testing/trials.hpp"

// What a run kept: the conservation report, and the largest change of any quantity.
namespace vectrix::test::run_conservation_test {
namespace {

using namespace rigid_craft;
using Eigen::Vector3d;

constexpr double accuracy = 1e-9;  // of a run of some tens of radians at 1e-12

const AxisymmetricBody body;
const Turning craft = turning(body);

CraftTrajectory<Turning> run(const CraftPropagation& how) {
  return propagate(scenario(craft), start_of(craft, body.exact(0.0)), how);
}

constexpr double mu_of_earth = 3.986004418e14;
const Free satellite = free(body);
CraftTrajectory<Free> in_orbit(const Eigen::Vector3d& w, const CraftPropagation& how) {
  return propagate(scenario(satellite, field_of(mu_of_earth)),
                   start_of(satellite, state_at(0.0, body.q0, w), {7e6, 0.0, 0.0}, {0.0, 5000.0, 6000.0}),
                   how);
}

/// How far what a torque-free body in an orbit keeps has changed.
struct Kept {
  double orthonormality, energy, angular_momentum, orbital_energy, orbital_angular_momentum;
};
Vector3d place(const Now<Free>& now) {
  return now.position(of<Body>, relative_to<Gcrf>, in<Gcrf>).coordinates();
}
Vector3d speed(const Now<Free>& now) {
  return now.velocity(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>).coordinates();
}
double orbital_energy_change(const CraftTrajectory<Free>& flight, double mu) {
  return largest_change(satellite, flight, [mu](const Now<Free>& now) {
    return speed(now).squaredNorm() / 2.0 - mu / place(now).norm();
  });
}
Kept kept(const CraftTrajectory<Free>& flight) {
  const Inertia<Body> J_b = tensor(body.a, body.a, body.c);
  const auto rate = [](const Now<Free>& now) {
    return now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
  };
  const auto change = [&](const auto& quantity) { return largest_change(satellite, flight, quantity); };
  return {
      flight.orthonormality_drift(),
      change([&](const Now<Free>& now) { return kinetic_energy(J_b, rate(now)); }),
      change([&](const Now<Free>& now) { return now.rotation(to<Gcrf>, from<Body>) * (J_b * rate(now)); }),
      orbital_energy_change(flight, mu_of_earth),
      change([&](const Now<Free>& now) { return Vector3d(place(now).cross(speed(now))); }),
  };
}

TEST(CraftConservationReport, of_a_torque_free_body_is_small) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    constexpr double drift = 1e-9;  // of some thousand steps at 1e-12
    CraftPropagation how = until(vectrix_test::trials(600));
    how.attitude = attitude;
    const CraftConservation report = conservation(scenario(craft), run(how));
    EXPECT_LT(report.orthonormality, drift);
    EXPECT_LT(report.energy.value(), drift);
    EXPECT_LT(report.angular_momentum.value(), drift);
    EXPECT_FALSE(report.momentum);  // the hub is only turning

    const Kept in_space = kept(in_orbit(body.w0, how));
    EXPECT_LT(in_space.orthonormality, drift);
    EXPECT_LT(in_space.energy, drift);
    EXPECT_LT(in_space.angular_momentum, drift);
    EXPECT_LT(in_space.orbital_energy, drift);
    EXPECT_LT(in_space.orbital_angular_momentum, drift);

    const auto drifting = propagate(
        scenario(satellite), start_of(satellite, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 5.0, 6.0}), how);
    EXPECT_LT(conservation(scenario(satellite), drifting).momentum.value(), drift);
  }
}

CraftPropagation with_tolerance(double end, double tolerance) {
  CraftPropagation how = until(end);
  how.relative_tolerance = tolerance;
  how.absolute_tolerances = {tolerance * si::radian, tolerance * (si::radian / si::second),
                             tolerance * 1e7 * si::metre, tolerance * 1e4 * (si::metre / si::second),
                             tolerance};
  return how;
}

TEST(CraftConservationReport, says_what_a_loose_tolerance_costs) {
  const auto report = [](double tolerance) {
    return conservation(scenario(craft), run(with_tolerance(100.0, tolerance)));
  };
  const CraftConservation tight = report(1e-12), loose = report(1e-5);
  EXPECT_GT(loose.orthonormality, 1e3 * tight.orthonormality);
  EXPECT_GT(loose.energy.value(), 1e3 * tight.energy.value());
  EXPECT_GT(loose.angular_momentum.value(), 1e3 * tight.angular_momentum.value());
  EXPECT_LT(loose.angular_momentum.value(), 0.1);  // but smaller than the momentum
}

/// The report gives the relative change between the nodes. Here it uses the inertia of another body.
TEST(CraftConservationReport, finds_a_change) {
  const Turning claimed(tensor(2.0, 2.6, 3.0));  // T and h of this body are not constant in the motion
  const auto trajectory = run(until(60.0));
  const double w = std::hypot(0.3, 0.2);  // turns in the xy plane: 2T varies by 0.6 wy^2
  const double start = 2.0 * 0.09 + 2.6 * 0.04 + 3.0 * 0.25;
  const double largest = 0.6 * std::max(w * w - 0.04, 0.04);
  const CraftConservation report = conservation(scenario(claimed), trajectory);
  EXPECT_NEAR(report.energy.value(), largest / start, 0.01 * largest / start);
  EXPECT_GT(report.angular_momentum.value(), 0.01);
}

// With another mu than the flown one v^2/2 - mu/r changes as 1/r does.
TEST(LargestChange, finds_a_change_of_the_orbital_energy) {
  const auto trajectory = in_orbit(body.w0, until(3000.0));
  const auto radius = [&](std::size_t i) {
    return trajectory.node(i).hub_motion().translation.coordinates().norm();
  };
  const double v = trajectory.node(0).hub_motion().velocity.coordinates().norm();
  double largest = 0.0;
  for (std::size_t i = 1; i < trajectory.node_count(); ++i)
    largest = std::max(largest, mu_of_earth * std::abs(1.0 / radius(i) - 1.0 / radius(0)));
  const double expected = largest / std::abs(v * v / 2.0 - 2.0 * mu_of_earth / radius(0));
  EXPECT_GT(expected, 0.05);
  EXPECT_NEAR(orbital_energy_change(trajectory, 2.0 * mu_of_earth), expected, accuracy);
}

TEST(LargestChange, says_what_a_loose_tolerance_costs_an_orbit) {
  const auto report = [](double tolerance) {
    return kept(in_orbit(1e-3 * body.w0, with_tolerance(20000.0, tolerance)));
  };
  const Kept tight = report(1e-12), loose = report(1e-3);
  EXPECT_GT(loose.orbital_energy, 1e6 * tight.orbital_energy);
  EXPECT_GT(loose.orbital_angular_momentum, 1e6 * tight.orbital_angular_momentum);
}

TEST(LargestChange, of_what_was_zero_is_the_change) {
  const auto elapsed = [](const Now<Turning>& now) { return now.time(); };
  EXPECT_EQ(largest_change(craft, run(until(10.0)), elapsed), 10.0);
}

TEST(CraftConservationReport, leaves_out_what_is_not_conserved_or_not_there) {
  const auto pushed =
      scenario(craft, pulse(craft, of<Body>, torque_body(0.1, 0.0, 0.0), seconds(1.0), seconds(2.0)));
  const CraftConservation of_pushed =
      conservation(pushed, propagate(pushed, start_of(craft, body.exact(0.0)), until(10.0)));
  EXPECT_FALSE(of_pushed.energy);
  EXPECT_FALSE(of_pushed.momentum);
  EXPECT_FALSE(of_pushed.angular_momentum);
  EXPECT_LT(of_pushed.orthonormality, accuracy);

  const auto attracted = scenario(
      satellite, point_mass(satellite, Quantity<si::gravitational_parameter>::from_value(mu_of_earth)));
  const auto flight = propagate(
      attracted, start_of(satellite, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 5000.0, 6000.0}), until(10.0));
  EXPECT_FALSE(conservation(attracted, flight).energy);
  EXPECT_LT(kept(flight).orbital_energy, accuracy);
  EXPECT_LT(kept(flight).orbital_angular_momentum, accuracy);
}

TEST(CraftConservation, PrintsWhatIsKnown) {
  std::ostringstream out;
  out << std::fixed << CraftConservation{1.5e-15, 2.0e-13, {}, 0.0};
  EXPECT_EQ(out.str(),
            "orthonormality of the attitude: off by 1.5e-15\nenergy: changed by 2e-13\n"
            "angular momentum: changed by 0\n");
}

}  // namespace
}  // namespace vectrix::test::run_conservation_test
