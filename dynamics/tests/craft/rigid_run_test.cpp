#include <array>
#include <limits>
#include <numbers>
#include <random>
#include <tuple>

#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "craft/rigid_craft.hpp"
#include "methods.hpp"
#include "testing/trials.hpp"

// Runs of a craft of one rigid body against closed-form solutions.
namespace vectrix::test::rigid_run_test {
namespace {

using namespace rigid_craft;

using Eigen::Quaterniond;
using Eigen::Vector3d;
using ode::Method;

constexpr double pi = std::numbers::pi;

/// The accumulated error at the tolerances of until(), 1e-12, over the some tens of radians of the motions
/// below: about five times the measured one. BDF (order 5) and Adams take the most steps.
double accuracy(Method method) {
  switch (method) {
    case Method::cvode_adams:
      return 5e-9;
    case Method::cvode_bdf:
      return 5e-8;
    case Method::arkode_dormand_prince_5:
      return 1e-10;
    case Method::arkode_fehlberg_8:
    case Method::verner_9:
    case Method::verner_7:
    case Method::radau_iia_7:
      return 1e-10;
  }
  return 0.0;
}

class RigidRun : public testing::TestWithParam<std::tuple<Method, AttitudeState>> {
 protected:
  Method method() const { return std::get<0>(GetParam()); }
  AttitudeState attitude() const { return std::get<1>(GetParam()); }
  double accuracy() const { return rigid_run_test::accuracy(method()); }
  /// Of an orbit, relative to its size: an error of its energy moves the body along the orbit as the square
  /// of time.
  double orbit_accuracy(double revolutions) const { return 3.0 * revolutions * accuracy(); }
  CraftPropagation until(double end) const { return rigid_craft::until(end, method(), attitude()); }
};

std::string name(const testing::TestParamInfo<RigidRun::ParamType>& info) {
  const bool quaternion = std::get<1>(info.param) == AttitudeState::quaternion;
  return vectrix_test::name_of(std::get<0>(info.param)) + (quaternion ? "_quaternion" : "_dcm");
}

INSTANTIATE_TEST_SUITE_P(Methods, RigidRun,
                         testing::Combine(testing::ValuesIn(vectrix_test::methods),
                                          testing::Values(AttitudeState::quaternion)),
                         name);
// A matrix is projected at each evaluation, in the same way for all methods.
INSTANTIATE_TEST_SUITE_P(MethodsWithMatrix, RigidRun,
                         testing::Combine(testing::ValuesIn(vectrix_test::tried(vectrix_test::methods)),
                                          testing::Values(AttitudeState::dcm)),
                         name);

template <class Exact>
double largest_node_error(const CraftTrajectory<Turning>& trajectory, const Exact& exact) {
  double largest = 0.0;
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const BodyState found = body_state(trajectory.node(i));
    largest = detail::larger(largest, error(found, exact(found.time.value())));
  }
  return largest;
}

TEST_P(RigidRun, torque_free_axisymmetric_body) {
  for (const double c : {3.0, 0.5}) {  // flat and slender
    const AxisymmetricBody body{.c = c};
    const Turning craft = turning(body);
    const auto trajectory = propagate(scenario(craft), start_of(craft, body.exact(0.0)), until(60.0));
    EXPECT_EQ(trajectory.end(), seconds(60.0));
    EXPECT_LT(largest_node_error(trajectory, [&](double t) { return body.exact(t); }), accuracy());
  }
}

// With loose tolerances an implicit method tries matrices far from a rotation, even left-handed ones.
TEST_P(RigidRun, takes_loose_tolerances) {
  const Turning craft(tensor(1.0, 2.0, 3.0));
  const BodyState start = state_at(0.0, Quaterniond::Identity(), {0.7, 0.6, 0.6});
  CraftPropagation how = until(100.0);
  how.relative_tolerance = 1e-3;
  how.absolute_tolerances.angle = 1e-3 * si::radian;
  how.absolute_tolerances.rate = 1e-3 * (si::radian / si::second);
  const auto trajectory = propagate(scenario(craft), start_of(craft, start), how);
  EXPECT_EQ(trajectory.end(), seconds(100.0));
  constexpr double of_some_hundred_steps = 0.3;
  const Vector3d w = trajectory(trajectory.end()).angular_velocity.coordinates();
  EXPECT_NEAR(w.norm() / Vector3d(0.7, 0.6, 0.6).norm(), 1.0, of_some_hundred_steps);
}

TEST_P(RigidRun, counts_seconds_from_any_time) {
  const AxisymmetricBody body;
  for (const double start : {1.7e9, 2.1e11}) {  // since 1970, Julian
    const Turning craft = turning(body);
    const auto trajectory =
        propagate(scenario(craft), start_of(craft, state_at(start, body.q0, body.w0)), until(start + 60.0));
    for (double s = 0.0; s <= 60.0; s += 0.25) {
      EXPECT_LT(error(body_state(trajectory.at(seconds(start + s))), body.exact(s)), accuracy())
          << start << " + " << s;
    }
  }
}

// The same motion, in units of 2^-250 kg m^2 and 2^300 s: powers of 2 change no digit.
TEST_P(RigidRun, tiny_bodies_turn_as_large_ones_until_the_torque_underflows) {
  const auto scaled = [&](double size, double slow) {
    const Turning craft(tensor(1.0 * size, 2.0 * size, 2.5 * size));
    const auto start =
        start_of(craft, state_at(0.0, Quaterniond(1, 0, 0, 0), slow * Vector3d(0.3, -0.2, 0.5)));
    CraftPropagation how = until(10.0 / slow);
    how.absolute_tolerances.rate = 1e-15 * slow * (si::radian / si::second);
    return body_state(propagate(scenario(craft), start, how).at(seconds(10.0 / slow)));
  };
  const BodyState tiny = scaled(std::ldexp(1.0, -250), std::ldexp(1.0, -300));
  const Turning large(tensor(1.0, 2.0, 2.5));
  const auto start = start_of(large, state_at(0.0, Quaterniond(1, 0, 0, 0), Vector3d(0.3, -0.2, 0.5)));
  const BodyState expected = body_state(propagate(scenario(large), start, until(10.0)).at(seconds(10.0)));
  EXPECT_LE(angle_between(tiny.q_i_from_b.eigen(), expected.q_i_from_b.eigen()), accuracy());
  const auto underflows = [&](int size, int slow) {
    try {
      scaled(std::ldexp(1.0, size), std::ldexp(1.0, slow));
      ADD_FAILURE() << "not refused: 2^" << size << ", 2^" << slow;
    } catch (const std::exception& failure) {
      expect_said(failure, "underflows, J w^2 = ");
    }
  };
  underflows(-250, -430);
  underflows(0, -545);  // w^2 itself does
}

/// Kepler's ellipse, by Kepler's equation, together with an attitude that it does not affect.
TEST_P(RigidRun, kepler_ellipse_in_the_same_state) {
  constexpr double mu = 3.986004418e14, a = 1e7, e = 0.2;
  const double n = std::sqrt(mu / (a * a * a));
  const auto ellipse = [&](double t) {
    double E = n * t;
    for (int i = 0; i < 30; ++i) E -= (E - e * std::sin(E) - n * t) / (1.0 - e * std::cos(E));
    const double b = a * std::sqrt(1.0 - e * e);
    const double rate = n / (1.0 - e * std::cos(E));
    return std::pair{Vector3d(a * (std::cos(E) - e), b * std::sin(E), 0.0),
                     Vector3d(-a * std::sin(E) * rate, b * std::cos(E) * rate, 0.0)};
  };
  const Quaterniond tilt(Eigen::AngleAxisd(0.7, Vector3d(1.0, -2.0, 0.5).normalized()));
  AxisymmetricBody body;
  body.w0 *= 1e-3;
  const Free craft = free(body);
  const auto start = start_of(craft, body.exact(0.0), tilt * ellipse(0.0).first, tilt * ellipse(0.0).second);
  const double end = 3.0 * 2.0 * pi / n;  // three revolutions, 8 h
  const auto trajectory = propagate(scenario(craft, field_of(mu)), start, until(end));
  for (int i = 0; i <= 50; ++i) {
    const double t = i * end / 50.0;
    const MovingTransform<Gcrf, Body> found = trajectory.at(seconds(t)).hub_motion();
    EXPECT_LT((found.translation.coordinates() - tilt * ellipse(t).first).norm(), orbit_accuracy(3.0) * a);
    EXPECT_LT((found.velocity.coordinates() - tilt * ellipse(t).second).norm(), orbit_accuracy(3.0) * n * a);
    EXPECT_LT(error(body_state(trajectory.at(seconds(t))), body.exact(t)), accuracy());
  }
}

/// Spin about the principal axis z: w' = torque(t) / Jzz. `exact` gives (angle, rate).
template <class Scenario, class Exact>
void expect_spin(const Scenario& scenario, const CraftState<Turning>& from, const CraftPropagation& how,
                 const Exact& exact, double tolerance) {
  const auto trajectory = propagate(scenario, from, how);
  const double start = trajectory.start().value();
  const double end = trajectory.end().value();
  for (int i = 0; i <= 200; ++i) {
    const double t = i == 200 ? end : start + i * (end - start) / 200.0;
    const auto [angle, rate] = exact(t);
    const Quaterniond q(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    ASSERT_LT(error(body_state(trajectory.at(seconds(t))), state_at(t, q, {0.0, 0.0, rate})), tolerance)
        << "at t = " << t;
  }
}

constexpr double Jzz = 5.0;

const Turning wheel(tensor(3.0, 4.0, Jzz));

CraftState<Turning> spinning(double start, double rate) {
  return start_of(wheel, state_at(start, Quaterniond::Identity(), {0.0, 0.0, rate}));
}

TEST_P(RigidRun, pulses_about_a_principal_axis) {
  constexpr double w0 = 0.1, start = 10.0;
  struct Pulse {
    double from, until, torque;
  };
  // One pulse begins with the propagation, two overlap, two touch, one lasts beyond the end, one ends before
  // it.
  const std::array<Pulse, 5> pulses = {
      {{10.0, 12.5, 0.5}, {11.3, 14.1, -0.8}, {14.1, 14.2, 3.0}, {27.0, 1e9, 0.2}, {1.0, 9.0, 100.0}}};
  const auto pulsed = std::apply(
      [](const auto&... p) {
        return scenario(wheel, pulse(wheel, of<Body>, torque_body(0.0, 0.0, p.torque), seconds(p.from),
                                     seconds(p.until))...);
      },
      pulses);
  const auto exact = [&](double t) {
    double angle = w0 * (t - start), rate = w0;
    for (const Pulse& p : pulses) {
      if (p.until <= start || t <= p.from) continue;
      const double lasted = std::min(t, p.until) - p.from;
      const double since = std::max(0.0, t - p.until);
      rate += p.torque / Jzz * lasted;
      angle += p.torque / Jzz * (0.5 * lasted * lasted + lasted * since);
    }
    return std::pair{angle, rate};
  };
  expect_spin(pulsed, spinning(start, w0), until(30.0), exact, accuracy());
}

TEST_P(RigidRun, a_torque_that_jumps_at_listed_times) {
  // tau = 1 before 7.3, -0.5 before the next jump, then 0.3 t.
  enum class Piece { first, second, third };
  for (const double next : vectrix_test::tried(std::vector{11.3, 11.0, 13.33, 12.0 + 1.0 / 3.0})) {
    const auto jumping = scenario(wheel, held(Piece::first), at_times({seconds(7.3)}, becomes(Piece::second)),
                                  at_times({seconds(next)}, becomes(Piece::third)),
                                  [](const Now<Turning>& now, Forces<Turning>& forces, const Piece& piece) {
                                    const double t = now.time().value();
                                    forces.torque(of<Body>, torque_body(0.0, 0.0,
                                                                        piece == Piece::first    ? 1.0
                                                                        : piece == Piece::second ? -0.5
                                                                                                 : 0.3 * t));
                                  });
    const auto exact = [&](double t) {
      const double first = std::min(t, 7.3), second = std::clamp(t, 7.3, next) - 7.3,
                   third = std::max(t, next) - next;
      const double w1 = first / Jzz, w2 = w1 - 0.5 * second / Jzz;
      const double rate = w2 + 0.3 * (next * third + 0.5 * third * third) / Jzz;
      const double angle = 0.5 * first * first / Jzz + w1 * second - 0.25 * second * second / Jzz +
                           w2 * third +
                           0.3 * (0.5 * next * third * third + third * third * third / 6.0) / Jzz;
      return std::pair{angle, rate};
    };
    expect_spin(jumping, spinning(0.0, 0.0), until(20.0), exact, accuracy());
  }
}

TEST_P(RigidRun, a_short_burst_of_torque_is_seen_with_a_maximum_step) {
  constexpr double centre = 10.1, width = 0.1;  // tau = exp(-((t - centre) / width)^2)
  const auto burst = of_time(wheel, of<Body>, [](const Quantity<si::time>& t) {
    const double x = (t.value() - centre) / width;
    return torque_body(0.0, 0.0, std::exp(-x * x));
  });
  CraftPropagation how = until(20.0);
  how.maximum_step = seconds(width / 4.0);
  const auto exact = [&](double t) {
    const double x = (t - centre) / width;
    const double integral = 0.5 * std::sqrt(pi) * width * (1.0 + std::erf(x));
    return std::pair{((t - centre) * integral + 0.5 * width * width * std::exp(-x * x)) / Jzz,
                     integral / Jzz};
  };
  expect_spin(scenario(wheel, burst), spinning(0.0, 0.0), how, exact, accuracy());
}

/// Pitch of a satellite in a circular orbit, phi from the radial: with yaw x (radial), roll y, pitch z,
///     phi'' = -3/2 n^2 k sin 2 phi,  k = (Jy - Jx) / Jz
/// so that phi'^2 + 3 n^2 k sin^2 phi is constant, and small phi oscillate at sqrt(3 n^2 k).
struct GravityGradientPendulum {
  double mu = 3.986004418e14;
  double radius = 7e6;
  double n = std::sqrt(mu / (radius * radius * radius));
  double Jx = 2.0, Jy = 5.0, Jz = 4.0;
  double k = (Jy - Jx) / Jz;

  CraftTrajectory<Free> run(double phi, const CraftPropagation& how) const {
    const Free craft(tensor(Jx, Jy, Jz));
    const Quaterniond q(Eigen::AngleAxisd(phi, Vector3d::UnitZ()));
    return propagate(
        scenario(craft, point_mass(craft, Quantity<si::gravitational_parameter>::from_value(mu))),
        start_of(craft, state_at(0.0, q, {0.0, 0.0, n}), {radius, 0.0, 0.0}, {0.0, n * radius, 0.0}), how);
  }
  double phi(const CraftState<Free>& state) const {
    const Eigen::Matrix3d R = state.turning().rotation.matrix();
    return std::remainder(std::atan2(R(1, 0), R(0, 0)) - n * state.time().value(), 2.0 * pi);
  }
};

TEST_P(RigidRun, small_libration_by_the_gravity_gradient) {
  const GravityGradientPendulum pendulum;
  constexpr double phi0 = 1e-3;
  const double frequency = std::sqrt(3.0 * pendulum.k) * pendulum.n;
  const double end = 10.0 * 2.0 * pi / frequency;  // 6.7 revolutions
  const auto trajectory = pendulum.run(phi0, until(end));
  // The period exceeds that of the small libration by the fraction phi0^2 / 4: 2.5e-7 of the phase, 63 rad.
  const double tolerance = 2e-5 * phi0 + orbit_accuracy(6.7 * 6.7);
  for (int i = 0; i <= 100; ++i) {
    const CraftState<Free> state = trajectory.at(seconds(i * end / 100.0));
    ASSERT_NEAR(pendulum.phi(state), phi0 * std::cos(frequency * state.time().value()), tolerance);
  }
}

TEST_P(RigidRun, large_libration_keeps_its_first_integral) {
  const GravityGradientPendulum pendulum;
  constexpr double phi0 = 1.2;
  const auto trajectory = pendulum.run(phi0, until(20000.0));
  double largest = 0.0, lowest = phi0, fastest = 0.0;
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const CraftState<Free> state = trajectory.node(i);
    const Vector3d w = state.turning().angular_velocity.coordinates();
    const double phi = pendulum.phi(state);
    const double speed = w.z() / pendulum.n - 1.0;
    const double integral = speed * speed + 3.0 * pendulum.k * std::pow(std::sin(phi), 2);
    EXPECT_NEAR(integral, 3.0 * pendulum.k * std::pow(std::sin(phi0), 2), 3.0 * accuracy());  // slope up to 3
    EXPECT_EQ(w.head<2>(), Eigen::Vector2d::Zero());
    largest = std::max(largest, std::abs(phi));
    lowest = std::min(lowest, phi);
    fastest = std::max(fastest, std::abs(speed));
  }
  EXPECT_NEAR(largest, phi0, 0.1);  // it oscillates and does not turn over
  EXPECT_LT(lowest, -0.99 * phi0);  // without the torque it would stay at phi0
  EXPECT_NEAR(fastest, std::sqrt(3.0 * pendulum.k) * std::sin(phi0), 0.02);
}

TEST_P(RigidRun, a_torque_free_motion_runs_backwards_after_its_rate_is_reversed) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 3; ++i) {
    const Quaterniond q =
        Quaterniond(number(random), number(random), number(random), number(random)).normalized();
    const Vector3d w(number(random), number(random), number(random));
    const Turning craft(tensor(3.0, 4.0, 6.0, 0.3, -0.5, 0.4));
    const auto forwards = propagate(scenario(craft), start_of(craft, state_at(0.0, q, w)), until(20.0));
    const BodyState turn = body_state(forwards.at(forwards.end()));
    const auto backwards = propagate(
        scenario(craft), start_of(craft, state_at(20.0, turn.q_i_from_b.eigen(), -turn.w_ib_b.coordinates())),
        until(40.0));
    for (const double t : {5.0, 13.0, 20.0}) {
      const BodyState earlier = body_state(forwards.at(seconds(20.0 - t)));
      const BodyState later = body_state(backwards.at(seconds(20.0 + t)));
      EXPECT_LT(angle_between(earlier.q_i_from_b.eigen(), later.q_i_from_b.eigen()), accuracy());
      EXPECT_LT((earlier.w_ib_b.coordinates() + later.w_ib_b.coordinates()).norm(), accuracy());
    }
  }
}

}  // namespace
}  // namespace vectrix::test::rigid_run_test
