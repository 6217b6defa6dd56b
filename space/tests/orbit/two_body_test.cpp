#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <vectrix/kinematics/points/motion_laws.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>
#include <vectrix/space/orbit/two_body.hpp>

#include "temporary_file.hpp"

namespace vectrix::two_body_test {
namespace {

using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using StateTransition = Eigen::Matrix<double, 6, 6>;

struct Gcrf : inertial_frame {};
struct Ship : moving_frame {};
using Orbit = PointMotion<Gcrf, Ship, Gcrf>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);

Orbit orbit(const Vector3d& r, const Vector3d& v) {
  return point_motion(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}
Vector6 numbers(const Orbit& motion) {
  Vector6 x;
  x << motion.position.coordinates(), motion.velocity.coordinates();
  return x;
}
Orbit orbit(const Vector6& x) {
  return orbit(Vector3d(x.head<3>()), Vector3d(x.tail<3>()));
}

// In units of what one ulp of each given number changes, all added: the method rounds about as often as the
// data.
constexpr double times_sensitivity = 2.0;

TEST(TwoBody, SixtyDigits) {
  const auto table = CsvTable::read(VECTRIX_SOURCE_DIR "/space/tests/data/two_body_60_digits.csv",
                                    {"e", "mu", "x", "dt", "end_x", "end_vx", "sens_r", "sens_v"});
  ASSERT_EQ(table.rows(), 84u);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto at = [&](const char* column) { return table.number(i, column); };
    const Orbit end =
        two_body(Quantity<si::gravitational_parameter>::from_value(at("mu")),
                 orbit(Vector3d(at("x"), at("y"), at("z")), Vector3d(at("vx"), at("vy"), at("vz"))),
                 at("dt") * si::second);
    const Vector3d r(at("end_x"), at("end_y"), at("end_z")), v(at("end_vx"), at("end_vy"), at("end_vz"));
    EXPECT_LE((end.position.coordinates() - r).norm(), times_sensitivity * at("sens_r"))
        << "row " << i << ", e " << at("e");
    EXPECT_LE((end.velocity.coordinates() - v).norm(), times_sensitivity * at("sens_v"))
        << "row " << i << ", e " << at("e");
  }
}

// In the units mu = 1, r and v of size 1: an ellipse, a hyperbola, both signs of time, and several periods.
constexpr auto unit_mu = Quantity<si::gravitational_parameter>::from_value(1.0);
struct Case {
  Vector6 start;
  double dt;
};
std::vector<Case> cases() {
  std::mt19937_64 random(20270121);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Case> all;
  while (all.size() < 100) {
    Case one;
    for (double& x : one.start) x = number(random);
    const auto r = one.start.head<3>(), v = one.start.tail<3>();
    if (r.norm() < 0.5 || r.cross(v).norm() < 0.3) continue;
    if (all.size() % 3 == 0) one.start.tail<3>() *= 2.0 / v.norm();  // escapes
    one.dt = (all.size() % 2 ? 4.0 : 20.0) * number(random);
    all.push_back(one);
  }
  return all;
}

// Rounding of r and v of about 1e-16, amplified by a close approach, h >= 0.3, and by the time, to 20.
constexpr double unit_tolerance = 1e-12;

TEST(TwoBody, ConservesAndReturns) {
  for (const auto& [start, dt] : cases()) {
    const Vector6 end = numbers(two_body(unit_mu, orbit(start), dt * si::second));
    const auto energy = [](const Vector6& x) {
      return 0.5 * x.tail<3>().squaredNorm() - 1.0 / x.head<3>().norm();
    };
    const auto momentum = [](const Vector6& x) -> Vector3d { return x.head<3>().cross(x.tail<3>()); };
    EXPECT_NEAR(energy(end), energy(start), unit_tolerance);
    EXPECT_LE((momentum(end) - momentum(start)).norm(), unit_tolerance);
    const Vector6 back = numbers(two_body(unit_mu, orbit(end), -dt * si::second));
    EXPECT_LE((back - start).norm(), 10 * unit_tolerance * (1 + std::abs(dt)));
  }
}

// A fast hyperbola past the centre at 1e-8 of the distance: its direction then is poorly defined, its energy
// is not.
TEST(TwoBody, HeadOnHyperbola) {
  Vector6 start;
  start << 1.8, 0.0, 0.0, -431.0, 2e-4, 0.0;
  const double energy = 0.5 * 431.0 * 431.0 - 1.0 / 1.8;
  for (const double dt : {0.004, 0.0042, 0.0157, 10.0}) {
    const Vector6 end = numbers(two_body(unit_mu, orbit(start), dt * si::second));
    EXPECT_NEAR(0.5 * end.tail<3>().squaredNorm() - 1.0 / end.head<3>().norm(), energy,
                unit_tolerance * (energy + 1.0 / end.head<3>().norm()));
    EXPECT_NEAR(end.head<3>().cross(end.tail<3>()).z(), 1.8 * 2e-4,
                1e-9 * 1.8 * 2e-4 + epsilon * 431.0 * end.head<3>().norm());
  }
}

// With J = [0 1; -1 0]: Phi^T J Phi = J, and Phi against differences of the motion.
TEST(TwoBody, TransitionIsTheDerivative) {
  constexpr double step = 1e-5;
  // A central difference errs by step^2 times the third derivative, which grows as the matrix squared.
  constexpr double difference_tolerance = 1e-7;
  Eigen::Matrix<double, 6, 6> J;
  J << Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity(),
      Eigen::Matrix3d::Zero();
  for (const auto& [start, dt] : cases()) {
    const auto [motion, Phi] = two_body_transition(unit_mu, orbit(start), dt * si::second);
    EXPECT_EQ(numbers(motion), numbers(two_body(unit_mu, orbit(start), dt * si::second)));
    EXPECT_LE((Phi.transpose() * J * Phi - J).norm(), 100 * epsilon * Phi.squaredNorm());
    for (int k = 0; k < 6; ++k) {
      Vector6 before = start, after = start;
      before(k) -= step;
      after(k) += step;
      const Vector6 difference = (numbers(two_body(unit_mu, orbit(after), dt * si::second)) -
                                  numbers(two_body(unit_mu, orbit(before), dt * si::second))) /
                                 (2 * step);
      EXPECT_LE((Phi.col(k) - difference).norm(), difference_tolerance * (1.0 + Phi.squaredNorm()))
          << "column " << k << ", dt " << dt;
    }
  }
}

// Far out on a hyperbola and back: the way back has the inverse matrix. Rounding far away, epsilon T, acts
// near periapsis over the distance 1, and as much on the matrix; some of its terms are ten times as large.
TEST(TwoBody, TheWayBackFromFarHasTheInverseTransition) {
  constexpr double T = 1e6, inverse_tolerance = 100 * epsilon * T;
  Vector6 near_periapsis;
  near_periapsis << 1.0, 0.0, 0.0, 0.1, 1.6, 0.4;
  for (const double before : {0.0, -1.0, 0.5}) {
    const Orbit start = two_body(unit_mu, orbit(near_periapsis), before * si::second);
    const auto [far, out] = two_body_transition(unit_mu, start, T * si::second);
    const auto [end, back] = two_body_transition(unit_mu, far, -T * si::second);
    EXPECT_LE((numbers(end) - numbers(start)).norm(), inverse_tolerance) << before;
    const auto inverse_of = [](const StateTransition& Phi) {
      StateTransition result;
      result << Phi.bottomRightCorner<3, 3>().transpose(), -Phi.topRightCorner<3, 3>().transpose(),
          -Phi.bottomLeftCorner<3, 3>().transpose(), Phi.topLeftCorner<3, 3>().transpose();
      return result;
    };
    EXPECT_LE((back - inverse_of(out)).norm(), inverse_tolerance * out.norm()) << before;
  }
}

TEST(TwoBody, NoTimeNoChange) {
  const Orbit start = orbit(Vector3d(7e6, 1e5, 3), Vector3d(-20, 7500, 400));
  const auto [motion, Phi] = two_body_transition(mu, start, 0.0 * si::second);
  EXPECT_EQ(numbers(motion), numbers(start));
  EXPECT_EQ((Phi - Eigen::Matrix<double, 6, 6>::Identity()).norm(), 0.0);
}

// From rest: t = (r0^3/(2 mu))^1/2 (acos x^1/2 + (x (1 - x))^1/2), x = r/r0.
TEST(TwoBody, FallsAlongALine) {
  const double r0 = 8e6;
  for (const double x : {0.99, 0.5, 0.1, 0.001}) {
    const double t =
        std::sqrt(r0 * r0 * r0 / (2 * mu.value())) * (std::acos(std::sqrt(x)) + std::sqrt(x * (1 - x)));
    const Orbit end = two_body(mu, orbit(Vector3d(0, r0, 0), Vector3d::Zero()), t * si::second);
    // dt errs by 1e-16 of it, and r by this times the speed.
    const double speed = std::sqrt(2 * mu.value() / r0 * (1 / x - 1));
    EXPECT_NEAR(norm(end.position).value(), x * r0, 8 * epsilon * (r0 + speed * t));
    EXPECT_NEAR(-end.velocity.y().value(), speed, 1e-12 * speed / x);
  }
  // Away from the centre along a line, slower than, at and above the speed of escape.
  for (const double v : {5000.0, std::sqrt(2 * mu.value() / r0), 20000.0}) {
    const Orbit start = orbit(Vector3d(0, 0, r0), Vector3d(0, 0, v));
    const Orbit end = two_body(mu, start, 500.0 * si::second);
    EXPECT_NEAR(0.5 * std::pow(norm(end.velocity).value(), 2) - mu.value() / norm(end.position).value(),
                0.5 * v * v - mu.value() / r0, 1e-14 * mu.value() / r0);
    EXPECT_LE((numbers(two_body(mu, end, -500.0 * si::second)) - numbers(start)).norm(), 1e-6);
  }
}

// The motion, its acceleration and its jerk as an edge: each is the derivative of the one before, and so
// are rate and acceleration of the orbit frame on it.
TEST(TwoBody, ObeysTheLawsOfMotion) {
  const Orbit start = orbit(Vector3d(7e6, 1e5, -3e5), Vector3d(600, 6000, 6500));
  const auto flight = [&](Quantity<si::time> t) {
    const Orbit now = two_body(mu, start, t);
    const auto a = two_body_acceleration(mu, now.position);
    return AcceleratingTransform{lvlh(from<Ship>, now, a, two_body_jerk(mu, now)), now.position, now.velocity,
                                 a};
  };
  for (const double t : {0.0, 700.0, -3000.0, 1e5})
    EXPECT_NO_THROW(require_motion_laws(flight, t * si::second, 1.0 * si::second));
}

std::string refusal(const Vector3d& r, const Vector3d& v, double gravity, double dt) {
  return complaint([&] {
    two_body(Quantity<si::gravitational_parameter>::from_value(gravity), orbit(r, v), dt * si::second);
  });
}

TEST(TwoBody, RefusesWhatIsNoOrbit) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto ends_with = [](const std::string& said, const std::string& end) {
    EXPECT_TRUE(said.ends_with(end)) << said;
    EXPECT_TRUE(said.starts_with("two_body(")) << said;
    EXPECT_NE(said.find("Ship relative to"), std::string::npos) << said;
  };
  const Vector3d r(7e6, 0, 0), v(0, 7e3, 0), none(0, 0, 0);
  ends_with(refusal(none, v, 1.0, 1.0), "|r| is 0 m, |v| 7000 m/s, no orbit");
  ends_with(refusal(r, v, 0.0, 1.0), "mu is 0 m^3/s^2; it must be finite and positive");
  ends_with(refusal(r, v, -1.0, 1.0), "mu is -1 m^3/s^2; it must be finite and positive");
  ends_with(refusal(r, v, nan, 1.0), "mu is nan m^3/s^2; it must be finite and positive");
  ends_with(refusal(r, v, 1.0, nan), "dt is nan s");
  ends_with(refusal(r, v, 1e7, 1e308), "dt is 1e+308 s: the motion then is not finite");
  const auto lost = refusal(r, v, 3.986e14, 1e20);
  EXPECT_NE(lost.find("dt is 1e+20 s, and its rounding more than the period, "), std::string::npos) << lost;
}

TEST(TwoBody, AccelerationsRefuseWhatIsNoAttraction) {
  const auto said = [](double gravity, double r) {
    const auto given = Quantity<si::gravitational_parameter>::from_value(gravity);
    const auto motion = orbit({r, 0, 0}, {0, 7e3, 0});
    const auto acceleration = complaint([&] { (void)two_body_acceleration(given, motion.position); });
    const auto jerk = complaint([&] { (void)two_body_jerk(given, motion); });
    EXPECT_EQ(acceleration.substr(acceleration.find('(')), jerk.substr(jerk.find('(')));
    return acceleration;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(said(-1.0, 7e6).find("mu is -1 m^3/s^2 and |r| 7e+06 m; mu must be positive"), std::string::npos);
  EXPECT_NE(said(1.0, 0.0).find("mu is 1 m^3/s^2 and |r| 0 m"), std::string::npos);
  EXPECT_NE(said(nan, 7e6).find("mu is nan"), std::string::npos);
}

}  // namespace
}  // namespace vectrix::two_body_test
