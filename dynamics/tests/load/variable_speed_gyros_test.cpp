#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <vectrix/dynamics/load/each.hpp>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/prescribed.hpp>

#include "multibody/random_craft.hpp"
#include "short_units.hpp"

// Control moment gyros whose gimbals and rotors are both driven, against the equations of Schaub and Junkins,
// "Analytical Mechanics of Space Systems".
namespace vectrix_test::variable_speed_gyros_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;
using Eigen::Matrix3d, Eigen::Vector3d;

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};
template <int i> struct Gimbal : moving_frame {};
template <int i> struct Wheel : named_point {};

// kg m^2 about the spin axis s, t and the gimbal axis g = s x t: of a gimbal with its rotor, and of the
// rotor.
const Vector3d J_gimbal{0.03, 0.05, 0.04};
constexpr double J_wheel = 0.02;
constexpr double mass_of_gimbal = 5.0;
const Matrix3d J_hub = (Matrix3d() << 20.0, 0.5, -0.3, 0.5, 18.0, 0.2, -0.3, 0.2, 25.0).finished();

/// Four on a circle, in a pyramid of the skew b with cos b = 0.6: their centre of mass is that of the hub.
Vector3d place(int i) {
  return 0.4 * Vector3d(std::cos(0.5 * std::numbers::pi * i), std::sin(0.5 * std::numbers::pi * i), 0.0);
}
/// Columns s, t, g in the axes of the hub, at zero.
Matrix3d axes(int i) {
  const Vector3d out = place(i).normalized(), g = 0.8 * out + 0.6 * Vector3d::UnitZ();
  const Vector3d t = Vector3d::UnitZ().cross(out);
  return (Matrix3d() << t.cross(g), t, g).finished();
}
template <int i> auto gimbal() {
  using G = Gimbal<i>;
  const auto mass =
      mass_properties(mass_of_gimbal * si::kilogram, coincident(of<CentreOfMassOf<G>>, relative_to<G>, in<G>),
                      inertia_from_principal_moments(in<G>, J_gimbal.x() * kg_m2, J_gimbal.y() * kg_m2,
                                                     J_gimbal.z() * kg_m2));
  return body(mass,
              hinge(Transform{dcm(to<Hub>, from<G>, axes(i)),
                              displacement(of<G>, relative_to<Hub>, vector<si::length>(in<Hub>, place(i)))},
                    unit_z(in<G>)));
}
template <int i> auto wheel() {
  return rotor(of<Wheel<i>>, unit_x(in<Gimbal<i>>), J_wheel * kg_m2);
}
auto make_sat() {
  return spacecraft(body(mass_properties(100.0 * si::kilogram,
                                         coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                                         trust_inertia(in<Hub>, J_hub)),
                         turning_in<Inertial>),
                    gimbal<1>(), gimbal<2>(), gimbal<3>(), gimbal<4>(), wheel<1>(), wheel<2>(), wheel<3>(),
                    wheel<4>());
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

struct Driven {  // of one gyro: gimbal angle, its rate and acceleration, rotor speed and acceleration
  double angle, rate, acceleration, spin, spin_up;
};

// The rigid-body equation of the hub with its gyros, and the torques of the motors.
struct Book {
  Vector3d alpha;
  std::array<double, 4> gimbal_torque, rotor_torque;
};
Book book(const std::array<Driven, 4>& gyros, const Vector3d& w, const Vector3d& L) {
  const auto [J_s, J_t, J_g] = std::array{J_gimbal.x(), J_gimbal.y(), J_gimbal.z()};
  Matrix3d J = J_hub;
  std::array<Matrix3d, 4> R;
  for (std::size_t i = 0; i < 4; ++i) {
    const int number = static_cast<int>(i) + 1;
    const Vector3d r = place(number);
    R[i] = axes(number) * Eigen::AngleAxisd(gyros[i].angle, Vector3d::UnitZ()).toRotationMatrix();
    J += mass_of_gimbal * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose()) +
         R[i] * J_gimbal.asDiagonal() * R[i].transpose();
  }
  Vector3d M = L - w.cross(J * w);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [angle, rate, acceleration, spin, spin_up] = gyros[i];
    const Vector3d along = R[i].transpose() * w;  // w_s, w_t, w_g
    const double w_s = along.x(), w_t = along.y(), w_g = along.z();
    M -=
        R[i] * Vector3d(J_s * rate * w_t + J_wheel * spin_up - (J_t - J_g) * w_t * rate,
                        (J_s * w_s + J_wheel * spin) * rate - (J_t + J_g) * w_s * rate + J_wheel * spin * w_g,
                        J_g * acceleration - J_wheel * spin * w_t);
  }
  Book found{J.ldlt().solve(M), {}, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d along = R[i].transpose() * w, alpha = R[i].transpose() * found.alpha;
    found.gimbal_torque[i] = J_g * (alpha.z() + gyros[i].acceleration) - (J_s - J_t) * along.x() * along.y() -
                             J_wheel * gyros[i].spin * along.y();
    found.rotor_torque[i] = J_wheel * (gyros[i].spin_up + alpha.x() + gyros[i].rate * along.y());
  }
  return found;
}

/// Of torques of some 100 N m.
constexpr double rounding = 1e-12;

TEST(VariableSpeedGyros, HaveTheAccelerationsAndTorquesOfTheBook) {
  const Sat sat;
  RandomCraft random(20261129);
  const auto number = [&](double most) { return random.between(-most, most); };
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Driven, 4> gyros;
    for (auto& gyro : gyros) gyro = {number(3.0), number(1.0), number(2.0), number(400.0), number(5.0)};
    const Vector3d w(number(0.5), number(0.5), number(0.5)), L(number(2.0), number(2.0), number(2.0));
    const auto gimbals = [&]<int i>(Of<Gimbal<i>>) {
      const auto& gyro = gyros[std::size_t{i - 1}];
      return prescribed(sat, of<Gimbal<i>>, [gyro](const Quantity<si::time>&) {
        return JointMotion{gyro.angle * rad, gyro.rate * rad_s, gyro.acceleration * (rad_s / s)};
      });
    };
    const auto rotors = [&]<int i>(Of<Wheel<i>>) {
      const auto& gyro = gyros[std::size_t{i - 1}];
      return prescribed(sat, of<Wheel<i>>, [gyro](const Quantity<si::time>&) {
        return RotorMotion{gyro.spin * rad_s, gyro.spin_up * (rad_s / s)};
      });
    };
    const auto at = [&]<int... i>(std::integer_sequence<int, i...>) {
      return state(
          sat, 0.0 * s,
          moving_dcm(
              aligned(to<Inertial>, from<Hub>),
              angular_velocity(of<Hub>, relative_to<Inertial>, vector<si::angular_velocity>(in<Hub>, w))),
          starts(of<Gimbal<i + 1>>, gyros[std::size_t{i}].angle * rad, gyros[std::size_t{i}].rate * rad_s)...,
          spins(of<Wheel<i + 1>>, gyros[std::size_t{i}].spin * rad_s)...);
    }
    (std::make_integer_sequence<int, 4>{});
    const auto push =
        of_time(sat, of<Hub>, [L](const Quantity<si::time>&) { return vector<si::torque>(in<Hub>, L); });
    const auto found = motion(sat, at, each(of_numbered<Gimbal, 1, 4>, gimbals),
                              each(of_numbered<Wheel, 1, 4>, rotors), push);
    const Book wanted = book(gyros, w, L);
    EXPECT_LE((found.angular_acceleration(of<Hub>, in<Hub>).coordinates() - wanted.alpha).norm(), rounding);
    const auto expect = [&]<int i>(Of<Gimbal<i>>) {
      EXPECT_NEAR(found.holding_effort(of<Gimbal<i>>).value(), wanted.gimbal_torque[std::size_t{i - 1}],
                  100.0 * rounding);
      EXPECT_NEAR(found.holding_effort(of<Wheel<i>>).value(), wanted.rotor_torque[std::size_t{i - 1}],
                  100.0 * rounding);
    };
    expect(of<Gimbal<1>>), expect(of<Gimbal<2>>), expect(of<Gimbal<3>>), expect(of<Gimbal<4>>);
  }
}

}  // namespace
}  // namespace vectrix_test::variable_speed_gyros_test
