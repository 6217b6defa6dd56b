#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/attitude/euler_angles.hpp>
#include <vectrix/kinematics/samples/interpolated_position.hpp>
#include <vectrix/kinematics/samples/sampled_attitude.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>
#include <vectrix/space/pointing/steering.hpp>
#include <vectrix/space/sky/bodies.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "temporary_file.hpp"
#include "testing/motions.hpp"

namespace vectrix::steering_test {
namespace {

using earth::Gcrf, earth::Itrf;
using Eigen::Vector3d;
using sky::Sun;
using vectrix_test::Dual2;

struct Satellite : moving_frame {};
struct Body : moving_frame {};
struct Local : moving_frame {};

const std::filesystem::path source = VECTRIX_SOURCE_DIR;
constexpr double rounding = 4e-16;  // of a unit vector's coordinates

template <class S> using ColumnOf = Eigen::Matrix<S, 3, 1>;

// A circle, i the inclination, of radius r at the rate n.
struct Circle {
  double r, n, i;

  template <class S> ColumnOf<S> position(const S& t) const {
    using std::cos, std::sin;
    const S u = S(n) * t, x = cos(u), y = sin(u);
    return ColumnOf<S>(S(r) * x, S(r * std::cos(i)) * y, S(r * std::sin(i)) * y);
  }
  // The derivative of this order.
  Vector3d derivative(int order, double t) const {
    const double quarter = std::acos(-1.0) / 2;
    return std::pow(n, order) * position(t + order * quarter / n);
  }
};

template <class A> auto motion(const Vector3d& r, const Vector3d& v) {
  return point_motion(of<Satellite>, relative_to<Itrf>, observed_from<A>, vector<si::length>(in<A>, r),
                      vector<si::velocity>(in<A>, v));
}
template <class A> auto acceleration_of(const Vector3d& a) {
  return acceleration(of<Satellite>, relative_to<Itrf>, observed_from<A>, vector<si::acceleration>(in<A>, a));
}
PointMotion<Satellite, Sun, Gcrf> to_sun(const Vector3d& r, const Vector3d& v) {
  return point_motion(of<Sun>, relative_to<Satellite>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}

constexpr Circle navigation{2.96e7, 1.24e-4, 0.98};
constexpr double parsec = 3.0857e16;  // so far the Sun's direction is fixed

// Relative to lvlh(), whose x is forward, the body is turned about z, by the yaw psi with
//     tan psi = tan beta / sin mu,    d psi/dt = -n tan beta cos mu/(sin^2 mu + tan^2 beta)
// up to a constant turn, beta the angle of the Sun from the orbit and mu that of the satellite from midnight.
TEST(YawSteering, TurnsAboutNadirOnACircle) {
  const Vector3d h(0, -std::sin(navigation.i), std::cos(navigation.i));
  for (const double beta : {0.05, 0.4, -0.9}) {
    const Vector3d node = Vector3d::UnitX();
    const Vector3d sun = parsec * (std::cos(beta) * -node + std::sin(beta) * h);  // midnight is at t = 0
    for (int k = 0; k < 12; ++k) {
      const double t = (0.1 + 0.5 * k) / navigation.n, mu = navigation.n * t;
      const Vector3d r = navigation.position(t), v = navigation.derivative(1, t),
                     a = navigation.derivative(2, t);
      const auto eq = motion<Gcrf>(r, v);
      const auto a_eq = acceleration_of<Gcrf>(a);
      const auto jerk = derivative<si::acceleration>(observed_from<Gcrf>,
                                                     vector<si::jerk>(in<Gcrf>, navigation.derivative(3, t)));
      const auto now = yaw_steering(from<Body>, eq, a_eq, to_sun(sun - r, -v),
                                    acceleration(of<Sun>, relative_to<Satellite>, observed_from<Gcrf>,
                                                 vector<si::acceleration>(in<Gcrf>, -a)));
      const auto local = lvlh(from<Local>, eq, a_eq, jerk);
      const auto relative = inverse(local) * now;
      const double tan_beta = std::tan(beta), square = std::pow(std::sin(mu), 2) + tan_beta * tan_beta;
      const double yaw_rate = navigation.n * tan_beta * std::cos(mu) / square;
      // d2 psi/dt2 = n^2 tan beta sin mu (-1 - 2 cos^2 mu/square)/square
      const double yaw_acceleration = -navigation.n * navigation.n * tan_beta * std::sin(mu) *
                                      (1 + 2 * std::pow(std::cos(mu), 2) / square) / square;
      // The rounding of the cross product over the powers of the sine, which is down to 0.05.
      EXPECT_LE(
          (relative.angular_velocity.coordinates() / navigation.n - Vector3d(0, 0, yaw_rate / navigation.n))
              .norm(),
          1e-12)
          << beta << ' ' << mu;
      EXPECT_LE((relative.angular_acceleration.coordinates() / (navigation.n * navigation.n) -
                 Vector3d(0, 0, yaw_acceleration / (navigation.n * navigation.n)))
                    .norm(),
                1e-11)
          << beta << ' ' << mu;
      EXPECT_LE((now.rotation.matrix().col(2) + r.normalized()).norm(), 4 * rounding);
      EXPECT_GT(now.rotation.matrix().col(0).dot(sun), 0.0);
      EXPECT_LE(std::abs(now.rotation.matrix().col(1).dot(sun - r)) / parsec, 4 * rounding);
    }
  }
}

// The nominal axes of two Galileo satellites through noon and midnight turns, in which the Sun is down to 1
// deg from the line to the Earth. The file has 14 decimals, and its positions 1e-6 m.
TEST(YawSteering, OfGalileo) {
  constexpr double fourteen_decimals = 3e-14;
  const auto table = CsvTable::read(source / "space/tests/data/galileo_yaw_steering.csv", {"x_m", "axis_x"});
  ASSERT_EQ(table.rows(), 32u);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto columns = [&](const char* x, const char* y, const char* z) {
      return Vector3d(table.number(i, x), table.number(i, y), table.number(i, z));
    };
    const Vector3d r = columns("x_m", "y_m", "z_m"), sun = columns("sun_x_m", "sun_y_m", "sun_z_m");
    const Dcm<Gcrf, Body> R = yaw_steering(
        from<Body>, displacement(of<Satellite>, relative_to<Itrf>, vector<si::length>(in<Gcrf>, r)),
        displacement(of<Sun>, relative_to<Satellite>, vector<si::length>(in<Gcrf>, sun - r)));
    EXPECT_LE((R.matrix().col(0) - columns("axis_x", "axis_y", "axis_z")).norm(), fourteen_decimals);
  }
}

TEST(YawSteering, NoonIsRefused) {
  const Vector3d r(2.96e7, 0, 0), v(0, 3.7e3, 0);
  const auto yaw = [&](const Vector3d& sun) {
    return yaw_steering(from<Body>, motion<Gcrf>(r, v), to_sun(sun - r, -v));
  };
  EXPECT_THROW(static_cast<void>(yaw({1.5e11, 0, 0})), BadInput);
  EXPECT_THROW(static_cast<void>(yaw({-1.5e11, 1e3, 0})), BadInput);
  const std::string text = complaint([&] { yaw({1.5e11, 1e3, 0}); });
  EXPECT_NE(text.find("yaw_steering("), std::string::npos) << text;
  EXPECT_NE(text.find("the sine of the angle between them 6.66"), std::string::npos) << text;
  // The yaw rate at noon grows as n / tan beta.
  const double beta = 1e-3, n = v.norm() / r.norm();
  const auto now = yaw({parsec * std::cos(beta), 0, parsec * std::sin(beta)});
  EXPECT_NEAR(now.angular_velocity.coordinates().z() * std::tan(beta) / n, -1.0, 1e-9);
}

// From the velocity that the Earth sees, on a circle, the yaw relative to lvlh() is
//     tan psi = w sin i cos u/(n - w cos i)
TEST(ZeroDopplerSteering, YawOnACircle) {
  constexpr Circle low{7.07e6, 1.062e-3, 1.713};
  constexpr double w = 7.292115e-5;
  for (int k = 0; k < 12; ++k) {
    const double t = 0.5 * k / low.n, u = low.n * t;
    // At this instant the axes of the Earth are those of Gcrf.
    const Vector3d r = low.position(t), v = low.derivative(1, t), spin(0, 0, w);
    const Dcm<Itrf, Body> R = zero_doppler_steering(from<Body>, motion<Itrf>(r, v - spin.cross(r)));
    const Dcm<Gcrf, Local> local = lvlh(from<Local>, motion<Gcrf>(r, v));
    const Eigen::Matrix3d relative = local.matrix().transpose() * R.matrix();
    const double yaw = -std::atan2(w * std::sin(low.i) * std::cos(u), low.n - w * std::cos(low.i));
    EXPECT_NEAR(std::atan2(relative(1, 0), relative(0, 0)), yaw, 4 * rounding);
    EXPECT_NEAR(relative(2, 2), 1.0, 4 * rounding);
  }
}

// The rates of a path with all derivatives, by automatic differentiation.
TEST(ZeroDopplerSteering, RateAndAccelerationAreDerivatives) {
  const Vector3d path[4]{{1.0, 0.2, -0.4}, {-0.3, 0.9, 0.5}, {-0.6, -0.2, 0.3}, {0.4, -0.7, 0.2}};
  ColumnOf<Dual2> r, v;
  const Dual2 t = vectrix_test::instant(0.0);
  const auto constant = [](double x) { return vectrix_test::constant(x); };
  for (int k = 0; k < 3; ++k) {
    r(k) = constant(path[0](k)) +
           t * (constant(path[1](k)) + t * (constant(path[2](k) / 2) + t * constant(path[3](k) / 6)));
    v(k) = constant(path[1](k)) + t * (constant(path[2](k)) + t * constant(path[3](k) / 2));
  }
  const vectrix_test::Motion<Itrf, Body> exact(zero_doppler_steering(
      from<Body>, displacement(of<Satellite>, relative_to<Itrf>, vector<si::length>(in<Itrf>, r)),
      velocity(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>, vector<si::velocity>(in<Itrf>, v))));
  const auto a = acceleration_of<Itrf>(path[2]);
  const auto jerk = derivative<si::acceleration>(observed_from<Itrf>, vector<si::jerk>(in<Itrf>, path[3]));
  const AcceleratingDcm<Itrf, Body> now =
      zero_doppler_steering(from<Body>, motion<Itrf>(path[0], path[1]), a, jerk);
  const MovingDcm<Itrf, Body> moving = zero_doppler_steering(from<Body>, motion<Itrf>(path[0], path[1]), a);
  EXPECT_LE((now.rotation.matrix() - exact.R).norm(), 10 * rounding);
  EXPECT_LE((now.angular_velocity.coordinates() - exact.w_ab_b().coordinates()).norm(), 1e-14);
  EXPECT_LE((now.angular_acceleration.coordinates() - exact.alpha_ab_b().coordinates()).norm(), 1e-13);
  EXPECT_EQ(moving.angular_velocity.coordinates(), now.angular_velocity.coordinates());
}

std::vector<PositionSample<Itrf, Satellite, Epoch>> sentinel1_orbit() {
  const auto orbit = CsvTable::read(source / "examples/data/S1A_IW_20220414T102211_orbit.csv",
                                    {"time_utc", "x_m", "vx_mps"});
  std::vector<PositionSample<Itrf, Satellite, Epoch>> places;
  for (std::size_t i = 0; i < orbit.rows(); ++i) {
    const auto r = read_vector<si::length>(in<Itrf>, orbit, i, {"x_m", "y_m", "z_m"});
    const auto v = read_vector<si::velocity>(in<Itrf>, orbit, i, {"vx_mps", "vy_mps", "vz_mps"});
    places.push_back({Epoch::from_utc(orbit.text(i, "time_utc")),
                      point_motion(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>, r, v)});
  }
  return places;
}

// A real pass of Sentinel-1A ("Contains Copernicus Sentinel data [2022]"; the files and their conventions are
// described in examples/data): the satellite is steered as the law says, and rolled by about -30 deg.
TEST(ZeroDopplerSteering, OfSentinel1) {
  struct QuaternionAxes : moving_frame {};
  struct Real : moving_frame {};
  constexpr double steering_error = 2e-3;  // deg; the satellite's own, 1e-3 along the velocity
  constexpr double gyro_error = 6e-6;      // rad/s; three times their noise
  const std::filesystem::path data = source / "examples/data";
  const auto places = sentinel1_orbit();
  const auto table = CsvTable::read(data / "S1A_IW_20220414T102211_attitude.csv", {"time_utc", "q0"});
  std::vector<AttitudeSample<Gcrf, QuaternionAxes, Epoch>> attitude;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    attitude.push_back(
        {Epoch::from_utc(table.text(i, "time_utc")),
         nearest_quaternion_scalar_last(to<Gcrf>, from<QuaternionAxes>, table.number(i, "q0"),
                                        table.number(i, "q1"), table.number(i, "q2"), table.number(i, "q3"))
             .quaternion});
  }
  const auto orientation = EarthOrientation::read(data / "finals2000A_april_2022.txt");
  using Place = Displacement<Itrf, Satellite, In<Itrf>>;
  using Speed = Velocity<Itrf, Satellite, ObservedFrom<Itrf>, In<Itrf>>;
  using Change = Acceleration<Itrf, Satellite, ObservedFrom<Itrf>, In<Itrf>>;
  const auto graph =
      frame_graph(edge(orientation), sampled_edge(places, Hermite{7}, 20.0 * si::second),
                  sampled_edge(attitude, 2.0 * si::second),
                  static_edge(dcm_from_axes(to<Real>, -unit_y(in<QuaternionAxes>),
                                            -unit_x(in<QuaternionAxes>), -unit_z(in<QuaternionAxes>))),
                  edge([](const Place& r, const Speed& v, const Change& a) {
                    return zero_doppler_steering(from<Body>, r, v, a);
                  }));
  ASSERT_GT(attitude.size(), 20u);
  const auto turn_of = [&](const auto& now) {
    return euler_angles(intrinsic<3, 2, 1>, now.rotation(to<Body>, from<Real>));
  };
  const Epoch &first = attitude.front().time, &last = attitude.back().time;
  const double roll_rate =
      (turn_of(graph.at(last)).third() - turn_of(graph.at(first)).third()).value() / (last - first).value();
  for (std::size_t i = 0; i < attitude.size(); ++i) {
    const auto now = graph.at(attitude[i].time);
    const auto angles = turn_of(now);
    EXPECT_NEAR(angles.first().in(si::degree), 0.0, steering_error);
    EXPECT_NEAR(angles.second().in(si::degree), 0.0, steering_error);
    EXPECT_NEAR(angles.third().in(si::degree), -30.0, 1.0);
    // The gyros of the satellite measure the rate of the law, and about x that of the roll, which follows the
    // height above the ground.
    const auto w_real = now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Real>);
    const Vector3d gyro(table.number(i, "wx"), table.number(i, "wy"), table.number(i, "wz"));
    const Vector3d off = gyro - w_real.coordinates();
    EXPECT_LE(off.tail<2>().norm(), gyro_error) << i;
    EXPECT_NEAR(off.x(), roll_rate, gyro_error) << i;
  }
}

// Of every second sample of the orbit: the others are 10 s from the nearest. The file has 1e-6 m.
TEST(InterpolatedPosition, OfSentinel1) {
  constexpr double noise = 0.05,
                   noise_of_velocity = 2e-3;  // m, m/s: of the solution on board, twice at the ends
  const auto all = sentinel1_orbit();
  std::vector<PositionSample<Itrf, Satellite, Epoch>> half;
  for (std::size_t i = 0; i < all.size(); i += 2) half.push_back(all[i]);
  const auto expect_others = [&](const auto& method, double metres, double metres_per_second) {
    const InterpolatedPosition position(half, method, 25.0 * si::second);
    for (std::size_t i = 1; i + 1 < all.size(); i += 2) {
      const auto found = position(all[i].time);
      EXPECT_LE((found.translation.coordinates() - all[i].motion.position.coordinates()).norm(), metres) << i;
      EXPECT_LE((found.velocity.coordinates() - all[i].motion.velocity.coordinates()).norm(),
                metres_per_second)
          << i;
    }
  };
  expect_others(Hermite{7}, noise, noise_of_velocity);
  expect_others(Lagrange{7}, noise, noise_of_velocity);
}

}  // namespace
}  // namespace vectrix::steering_test
