#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <vectrix/dynamics/analysis/linearise.hpp>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/springs.hpp>
#include <vectrix/dynamics/load/stop_at.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

#include "craft/random_spacecraft.hpp"
#include "testing/trials.hpp"

// A, B, C, D against the flow in the same coordinates, and against closed forms.
namespace vectrix_test::spacecraft_test::linearise_test {
namespace {

using Eigen::Index, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
using Numbers = std::array<double, Every::state_size>;

// The minimal coordinates, written once more: where the quaternions of the hub, of Gyro and of Probe are.
using Shape = Every::shape;
constexpr std::array<std::size_t, 3> quaternions{0, Shape::position_at<Gyro>, Shape::position_at<Probe>};
constexpr Index size = static_cast<Index>(Every::state_size) - 3;

Eigen::Quaterniond quaternion_at(const Numbers& y, std::size_t at) {
  return Eigen::Quaterniond(y[at], y[at + 1], y[at + 2], y[at + 3]).normalized();
}
bool is_quaternion(std::size_t at) {
  return std::find(quaternions.begin(), quaternions.end(), at) != quaternions.end();
}
/// The errors of y from y0.
VectorXd errors(const Numbers& y0, const Numbers& y) {
  VectorXd x(size);
  Index k = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (is_quaternion(i)) {
      const Eigen::AngleAxisd turn(quaternion_at(y0, i).conjugate() * quaternion_at(y, i));
      const double angle =
          turn.angle() > std::numbers::pi ? turn.angle() - 2.0 * std::numbers::pi : turn.angle();
      x.segment<3>(k) = angle * turn.axis();
      k += 3, i += 3;
    } else {
      x[k++] = y[i] - y0[i];
    }
  }
  const Matrix3d to_hub = quaternion_at(y0, 0).toRotationMatrix().transpose();
  x.segment<3>(6) = to_hub * x.segment<3>(6);
  x.segment<3>(9) = to_hub * x.segment<3>(9);
  return x;
}
/// The state whose errors from y0 are e along coordinate k.
Numbers departed(const Numbers& y0, Index k, double e) {
  VectorXd x = VectorXd::Zero(size);
  x[k] = e;
  const Matrix3d from_hub = quaternion_at(y0, 0).toRotationMatrix();
  x.segment<3>(6) = from_hub * x.segment<3>(6);
  x.segment<3>(9) = from_hub * x.segment<3>(9);
  Numbers y = y0;
  Index at = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (is_quaternion(i)) {
      const Vector3d theta = x.segment<3>(at);
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(theta.norm(), theta.stableNormalized()));
      const Eigen::Quaterniond q = quaternion_at(y0, i) * turn;
      y[i] = q.w(), y[i + 1] = q.x(), y[i + 2] = q.y(), y[i + 3] = q.z();
      at += 3, i += 3;
    } else {
      y[i] += x[at++];
    }
  }
  return y;
}
/// One step of Runge and Kutta, forwards or backwards; its error is of order 5.
template <class Rates> Numbers step(Rates& rates, double t, const Numbers& y, double h) {
  const auto moved = [&](const Numbers& k, double by) {
    Numbers z = y;
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * k[i];
    return z;
  };
  std::array<Numbers, 4> k{};
  rates(t, y.data(), k[0].data());
  rates(t, moved(k[0], 0.5 * h).data(), k[1].data());
  rates(t, moved(k[1], 0.5 * h).data(), k[2].data());
  rates(t, moved(k[2], h).data(), k[3].data());
  Numbers z = y;
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
  return z;
}

/// A craft with all kinds of joints near a point mass, and a torque that depends on two attitudes and a rate.
auto loads_of(const Every& craft) {
  return std::tuple{
      spring(craft, of<Boom>, 3.0 * N_m / rad, 0.1 * rad), damper(craft, of<Mass>, 2.0 * (N / m_s)),
      point_mass(craft, Quantity<si::gravitational_parameter>::from_value(300.0)),
      []<class S>(const Now<Every, S>& now, Forces<Every, S>& forces) {
        const auto w = now.angular_velocity(of<Gyro>, relative_to<Probe>, in<Boom>).coordinates();
        forces.torque(of<spacecraft_test::Camera>, vector<si::torque>(in<Boom>, (0.3 * w).eval()));
        forces.force(of<Probe>, Quantity<si::force, S>(0.2 * si::newton) *
                                    (now.rotation(to<Antenna>, from<Hub>) * unit_x<Hub, S>(in<Hub>)));
      }};
}

// Phi(h) is the derivative of the flow, in errors from the reference motion, by the errors at the start:
// A = (Phi(h) - Phi(-h))/(2 h) up to h^2, and B = x(h)/h per input. What is left after one step of Richardson
// goes with h^4.
TEST(Linearise, TheDerivativesAreThoseOfTheFlow) {
  RandomCraft random(20261129);
  constexpr double h = 2e-3, e = 1e-4;  // the rounding of the differences is 1e-16/(h e), their error e^2
  for (int trial = 0; trial < trials(5); ++trial) {
    const Every craft(random);
    const auto start = random_state(craft, random);
    const double t = start.time().value();
    const auto loads = loads_of(craft);
    const auto flight = std::apply([&](const auto&... load) { return scenario(craft, load...); }, loads);
    const auto system =
        linearise(flight, start, inputs(torque_input(of<spacecraft_test::Camera>, in<Probe>)));
    ASSERT_EQ(system.A.rows(), size);

    auto rates = detail::rates_under(craft, loads);
    const auto difference = [&](double by) {
      MatrixXd A(size, size);
      const Numbers late = step(rates, t, start.numbers(), by), early = step(rates, t, start.numbers(), -by);
      for (Index k = 0; k < size; ++k) {
        const auto along = [&](double off) -> VectorXd {
          const Numbers y = departed(start.numbers(), k, off);
          return errors(late, step(rates, t, y, by)) - errors(early, step(rates, t, y, -by));
        };
        A.col(k) = (along(e) - along(-e)) / (4.0 * e * by);
      }
      return A;
    };
    const MatrixXd coarse = difference(2.0 * h), fine = difference(h);
    const MatrixXd error = (coarse - fine) / 3.0;
    const double tolerance =
        0.02 * error.cwiseAbs().maxCoeff() + 1e-6 * (1.0 + system.A.cwiseAbs().maxCoeff());
    EXPECT_LE((fine - error - system.A).cwiseAbs().maxCoeff(), tolerance);

    const auto under = [&](const Vector3d& M) {
      Numbers ydot{};
      const auto torque = [&](const Now<Every>&, Forces<Every>& forces) {
        forces.torque(of<spacecraft_test::Camera>, vector<si::torque>(in<Probe>, M));
      };
      auto with = detail::rates_under(craft, std::tuple_cat(loads, std::tuple{torque}));
      with(t, start.data(), ydot.data());
      return ydot;
    };
    // The motion is linear in its torques.
    const Numbers none = under(Vector3d::Zero());
    for (Index i = 0; i < 3; ++i) {
      const Numbers one = under(Vector3d::Unit(i));
      const auto speeds = system.rate(of<Probe>);
      for (Index k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        EXPECT_NEAR(system.B(3 + k, i), one[4 + at] - none[4 + at], 1e-10 * system.B.cwiseAbs().maxCoeff());
        EXPECT_NEAR(system.B(speeds[k], i),
                    one[Shape::speed_at<Probe> + at] - none[Shape::speed_at<Probe> + at],
                    1e-10 * system.B.cwiseAbs().maxCoeff());
      }
    }
  }
}

// C by differences of what is measured at departed states, and D by the torque, in which the motion is
// linear.
TEST(Linearise, TheOutputsAreThoseOfTheMotion) {
  RandomCraft random(20261202);
  constexpr double e = 1e-3;  // what is left after one step of Richardson goes with e^4
  const Every craft(random);
  const auto start = random_state(craft, random);
  const auto loads = loads_of(craft);
  const auto flight = std::apply([&](const auto&... load) { return scenario(craft, load...); }, loads);
  const auto acceleration = [](const auto& at) { return at.acceleration(of<Probe>, in<Boom>); };
  const auto torque = [](const auto& at) { return at.joint_torque(of<Antenna>, in<Mass>).vector(); };
  const auto system = linearise(flight, start, inputs(torque_input(of<spacecraft_test::Camera>, in<Probe>)),
                                outputs(output("acceleration", acceleration), output("torque", torque)));
  const auto measured = [&](const Numbers& y, const Vector3d& M) -> VectorXd {
    const auto by_hand = [&](const Now<Every>&, Forces<Every>& forces) {
      forces.torque(of<spacecraft_test::Camera>, vector<si::torque>(in<Probe>, M));
    };
    const auto moved = std::apply(
        [&](const auto&... load) {
          return motion(craft, state_from_numbers(craft, start.time(), y), load..., by_hand);
        },
        loads);
    VectorXd both(6);
    both << acceleration(moved).coordinates(), torque(moved).coordinates();
    return both;
  };
  const Vector3d none = Vector3d::Zero();
  const auto difference = [&](Index k, double off) -> VectorXd {
    const Numbers ahead = departed(start.numbers(), k, off), behind = departed(start.numbers(), k, -off);
    return (measured(ahead, none) - measured(behind, none)) / (2.0 * off);
  };
  const double scale = 1.0 + system.C.cwiseAbs().maxCoeff();
  for (Index k = 0; k < size; ++k) {
    const VectorXd coarse = difference(k, 2.0 * e), fine = difference(k, e), error = (coarse - fine) / 3.0;
    EXPECT_LE((fine - error - system.C.col(k)).cwiseAbs().maxCoeff(),
              0.02 * error.cwiseAbs().maxCoeff() + 1e-9 * scale)
        << system.state_names[static_cast<std::size_t>(k)];
  }
  EXPECT_GT(system.D.cwiseAbs().maxCoeff(), 0.0);
  for (Index i = 0; i < 3; ++i)
    EXPECT_LE(
        (measured(start.numbers(), Vector3d::Unit(i)) - measured(start.numbers(), none) - system.D.col(i))
            .cwiseAbs()
            .maxCoeff(),
        1e-10 * (1.0 + system.D.cwiseAbs().maxCoeff()));
}

// The words find the rows: of each, a number of the state that only this row changes.
TEST(Linearise, WordsFindTheRows) {
  RandomCraft random(20261130);
  const Every craft(random);
  const auto start = random_state(craft, random);
  const auto system = linearise(
      scenario(craft), start, inputs(motor_input(of<WheelOfHub>)),
      outputs(output("spin", [](const auto& at) { return at.state().spin(of<WheelOfHub>); }),
              output("boom", [](const auto& at) { return at.now().speed(of<Boom>); }),
              output("mass", [](const auto& at) { return at.now().coordinate(of<Mass>); }),
              output("gyro",
                     [](const auto& at) {
                       return at.now().angular_velocity(of<Gyro>, relative_to<Boom>, in<Gyro>);
                     }),
              output("probe",
                     [](const auto& at) { return at.now().position(of<Probe>, relative_to<Box>, in<Box>); }),
              output("antenna", [](const auto& at) { return at.now().speed(of<Antenna>)[1]; }),
              output("blanket", [](const auto& at) { return at.now().deflection_rates(of<Blanket>)[1]; })));
  const auto expect_unit = [&](Index row, Index column) {
    EXPECT_EQ(system.C.row(row), VectorXd::Unit(size, column).transpose())
        << system.output_names[static_cast<std::size_t>(row)];
  };
  expect_unit(0, system.spin(of<WheelOfHub>));
  expect_unit(1, system.speed(of<Boom>));
  expect_unit(2, system.coordinate(of<Mass>));
  for (Index i = 0; i < 3; ++i) {
    EXPECT_LE((system.C.row(3 + i) - VectorXd::Unit(size, system.rate(of<Gyro>)[i]).transpose()).norm(),
              1e-14);
    EXPECT_LE((system.C.row(6 + i) - VectorXd::Unit(size, system.place(of<Probe>)[i]).transpose()).norm(),
              1e-14);
  }
  expect_unit(9, system.speed(of<Antenna>)[1]);
  expect_unit(10, system.deflection_rates(of<Blanket>)[1]);
  const auto names_end_with = [&](Index row, const char* end) {
    const std::string& name = system.state_names.at(static_cast<std::size_t>(row));
    EXPECT_TRUE(name.ends_with(end)) << name;
  };
  names_end_with(system.attitude_error(of<Probe>)[2], "Probe [rad]");
  names_end_with(system.velocity(of<Probe>)[1], "Probe [m/s]");
  names_end_with(system.coordinate(of<Mass>), "Mass [m]");
  names_end_with(system.deflections(of<Tank>), "Tank [kg^1/2 m]");
  EXPECT_EQ(system.output_names[0], "spin [rad/s]");
  EXPECT_EQ(system.output_names[8], "probe z [m]");
  EXPECT_EQ(system.input_names.size(), 1U);
  EXPECT_EQ(system.B.cols(), 1);
}

struct Body : moving_frame {};
struct Star : inertial_frame {};
struct Wheel : named_point {};
const Matrix3d J = (Matrix3d() << 12.0, 1.5, -0.7, 1.5, 9.0, 0.4, -0.7, 0.4, 7.0).finished();
constexpr double J_s = 0.3;
const Vector3d n = Vector3d(2.0, -1.0, 2.0) / 3.0;

auto make_gyrostat() {
  return spacecraft(body(mass_properties(5.0 * si::kilogram,
                                         coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>),
                                         inertia_from_tensor(in<Body>, J)),
                         turning_in<Star>),
                    rotor(of<Wheel>, vector<si::dimensionless>(in<Body>, n), J_s * kg_m2));
}
using Gyrostat = decltype(make_gyrostat());

Matrix3d cross_of(const Vector3d& v) {
  return vectrix::hat(v);
}

// K w' = h x w + ..., K = J - J_s n n^T and h = J w + J_s Omega n the angular momentum; the wheel takes the
// rest of the torque:
//     K w' = (J w + n J_s Omega) x w - n tau,     Omega' = tau/J_s - n.w'
TEST(Linearise, AGyrostatHasItsClosedForm) {
  const Gyrostat craft = make_gyrostat();
  const Vector3d w(0.3, -0.8, 0.5);
  constexpr double Omega = 40.0;
  const auto start = state(
      craft, 0.0 * s,
      moving_dcm(turned_x(to<Star>, from<Body>, 0.4 * rad),
                 angular_velocity(of<Body>, relative_to<Star>, vector<si::angular_velocity>(in<Body>, w))),
      spins(of<Wheel>, Omega * rad_s));
  const auto accelerometer = [](const auto& at) { return at.angular_acceleration(of<Body>, in<Body>); };
  const auto system = linearise(scenario(craft), start, inputs(motor_input(of<Wheel>)),
                                outputs(output("acceleration", accelerometer)));
  const Matrix3d inverse = (J - J_s * n * n.transpose()).inverse();
  const Vector3d h = J * w + J_s * Omega * n;
  const Matrix3d by_rate = inverse * (cross_of(h) - cross_of(w) * J);
  const auto theta = system.attitude_error(of<Body>), rate = system.rate(of<Body>);
  const auto spin = system.spin(of<Wheel>);
  const double rounding = 1e-12 * h.norm();
  const auto near = [&](const MatrixXd& found, const MatrixXd& wanted) {
    EXPECT_LE((found - wanted).cwiseAbs().maxCoeff(), rounding) << found << "\n\n" << wanted;
  };
  near(system.A(theta, theta), -cross_of(w));
  near(system.A(theta, rate), Matrix3d::Identity());
  near(system.A(rate, theta), Matrix3d::Zero());
  near(system.A(rate, rate), by_rate);
  near(system.A(rate, spin), inverse * n.cross(w) * J_s);
  near(system.A(spin, rate), -n.transpose() * by_rate);
  const auto motor = system.input(motor_input(of<Wheel>));
  near(system.B(rate, motor), -inverse * n);
  EXPECT_NEAR(system.B(spin, motor), 1.0 / J_s + n.dot(inverse * n), rounding);
  // What is measured is w', so that D is the row of B.
  near(system.C, system.A(rate, Eigen::all));
  near(system.D, system.B(rate, Eigen::all));
}

// A wheel that sticks does not move; one that slips has the slope of its friction.
TEST(Linearise, FrictionHasTheStateInWhichARunStarts) {
  const Gyrostat craft = make_gyrostat();
  const auto at = [&](double Omega) {
    const auto start =
        state(craft, 0.0 * s,
              moving_dcm(aligned(to<Star>, from<Body>), at_rest(of<Body>, relative_to<Star>, in<Body>)),
              spins(of<Wheel>, Omega * rad_s));
    const auto rub = friction(craft, of<Wheel>, 0.1 * N_m, 0.1 * N_m, 1.0 * rad_s, 0.02 * (N_m / rad_s));
    return linearise(scenario(craft, rub), start, inputs(motor_input(of<Wheel>)));
  };
  const auto sticks = at(0.0), slips = at(5.0);
  EXPECT_EQ(sticks.B(sticks.spin(of<Wheel>), 0), 0.0);
  EXPECT_EQ(sticks.A(sticks.spin(of<Wheel>), sticks.spin(of<Wheel>)), 0.0);
  const double coupling = 1.0 / J_s + n.dot((J - J_s * n * n.transpose()).inverse() * n);
  EXPECT_NEAR(slips.A(slips.spin(of<Wheel>), slips.spin(of<Wheel>)), -0.02 * coupling, 1e-14);
}

// At a stop, a joint that moves beyond it has a spring and a damper, and one that moves away has nothing.
TEST(Linearise, AStopHasTheSideOnWhichARunStarts) {
  RandomCraft random(20261201);
  const Every craft(random);
  const auto k = 30.0 * (N / m);
  const auto c = 2.0 * (N / m_s);
  std::array<int, 2> pushes{};
  for (int trial = 0; trial < 8; ++trial) {
    const auto start = random_state(craft, random);
    const auto at = start.coordinate(of<Mass>), far = 1.0 * m;
    const auto matrix = [&](const auto&... load) { return linearise(scenario(craft, load...), start).A; };
    const MatrixXd free = matrix(),
                   springy = matrix(spring(craft, of<Mass>, k, at), damper(craft, of<Mass>, c));
    const bool rises = start.speed(of<Mass>).value() > 0.0;
    ++pushes[rises];
    const MatrixXd upper = matrix(stop_at(craft, of<Mass>, at - far, at, k, c)),
                   lower = matrix(stop_at(craft, of<Mass>, at, at + far, k, c));
    const double rounding = 1e-12 * springy.cwiseAbs().maxCoeff();
    EXPECT_LE((upper - (rises ? springy : free)).cwiseAbs().maxCoeff(), rounding);
    EXPECT_LE((lower - (rises ? free : springy)).cwiseAbs().maxCoeff(), rounding);
    EXPECT_GT((springy - free).cwiseAbs().maxCoeff(), 1e6 * rounding);
  }
  EXPECT_GT(pushes[0] * pushes[1], 0);
}

TEST(Linearise, RefusesDerivativesThatAreNotFinite) {
  const Gyrostat craft = make_gyrostat();
  const auto start =
      state(craft, 0.0 * s,
            moving_dcm(aligned(to<Star>, from<Body>), at_rest(of<Body>, relative_to<Star>, in<Body>)),
            spins(of<Wheel>, 0.0 * rad_s));
  const auto root = []<class S>(const Now<Gyrostat, S>& now, Forces<Gyrostat, S>& forces) {
    using std::sqrt;
    forces.motor(of<Wheel>, Quantity<si::torque, S>::from_value(sqrt(now.spin(of<Wheel>).value())));
  };
  const std::string text = vectrix_test::message<BadInput>([&] { linearise(scenario(craft, root), start); });
  EXPECT_NE(text.find("linearise"), std::string::npos);
  EXPECT_NE(text.find("by spin of " + frame_name<Wheel>() + " [rad/s] is "), std::string::npos) << text;

  const auto lost = [](const auto&, auto& forces) { forces.motor(of<Wheel>, std::nan("") * N_m); };
  const std::string named = vectrix_test::message<BadInput>([&] { linearise(scenario(craft, lost), start); });
  EXPECT_NE(named.find("linearise of the craft of "), std::string::npos) << named;
  EXPECT_NE(named.find(": load 1 of 1: the motor torque on " + frame_name<Wheel>() + " is nan N m"),
            std::string::npos)
      << named;
}

}  // namespace
}  // namespace vectrix_test::spacecraft_test::linearise_test
