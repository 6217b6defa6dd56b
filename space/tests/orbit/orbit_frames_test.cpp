#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/frames/scalar/lanes.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>
#include <vectrix/space/orbit/two_body.hpp>

#include "temporary_file.hpp"
#include "testing/motions.hpp"

namespace vectrix::orbit_frames_test {
namespace {

using Eigen::Vector3d;
using vectrix_test::Dual2, vectrix_test::constant, vectrix_test::instant;

struct Gcrf : inertial_frame {};
struct Earth : named_point {};
struct Ship : moving_frame {};
struct Orbit : moving_frame {};

constexpr double rounding = 4e-16;  // of a unit vector's coordinates
// Numbers of size 1 with sin(r, v) >= 0.2: rates reach 10 and accelerations 1e3, and the rounding of r x v
// is amplified by 1/sin^2.
constexpr double random_rate_tolerance = 1e-13;
constexpr double random_acceleration_tolerance = 1e-11;

template <class S> using ColumnOf = Eigen::Matrix<S, 3, 1>;
template <class S> auto position(const ColumnOf<S>& r) {
  return displacement(of<Ship>, relative_to<Earth>, vector<si::length>(in<Gcrf>, r));
}
template <class S> auto velocity_of(const ColumnOf<S>& v) {
  return velocity(of<Ship>, relative_to<Earth>, observed_from<Gcrf>, vector<si::velocity>(in<Gcrf>, v));
}
auto acceleration_of(const Vector3d& a) {
  return acceleration(of<Ship>, relative_to<Earth>, observed_from<Gcrf>,
                      vector<si::acceleration>(in<Gcrf>, a));
}
auto jerk_of(const Vector3d& j) {
  return derivative<si::acceleration>(observed_from<Gcrf>, vector<si::jerk>(in<Gcrf>, j));
}

// The four functions as objects.
constexpr auto lvlh_of = [](const auto&... motion) { return lvlh(from<Orbit>, motion...); };
constexpr auto ric_of = [](const auto&... motion) { return ric(from<Orbit>, motion...); };
constexpr auto vnb_of = [](const auto&... motion) { return vnb(from<Orbit>, motion...); };
constexpr auto ntw_of = [](const auto&... motion) { return ntw(from<Orbit>, motion...); };
template <class Function> void for_each_frame(const Function& f) {
  f(lvlh_of), f(ric_of), f(vnb_of), f(ntw_of);
}

// A circle in the plane of x and y: r along x, v along y, h along z.
TEST(OrbitFrames, AxesOnACircle) {
  const auto r = position<double>({7e6, 0, 0});
  const auto v = velocity_of<double>({0, 7500, 0});
  const auto expect_axes = [](const Dcm<Gcrf, Orbit>& R, const Vector3d& x, const Vector3d& y,
                              const Vector3d& z) {
    Eigen::Matrix3d axes;
    axes << x, y, z;
    EXPECT_EQ((R.matrix() - axes).norm(), 0.0) << R;
  };
  const Vector3d out = Vector3d::UnitX(), forward = Vector3d::UnitY(), h = Vector3d::UnitZ();
  expect_axes(lvlh(from<Orbit>, r, v), forward, -h, -out);
  expect_axes(ric(from<Orbit>, r, v), out, forward, h);
  expect_axes(vnb(from<Orbit>, r, v), forward, h, out);
  expect_axes(ntw(from<Orbit>, r, v), out, forward, h);
}

// With v inclined to the horizon: lvlh and ric keep to the position, vnb and ntw to the velocity.
TEST(OrbitFrames, AxesByTheirDefinition) {
  std::mt19937_64 random(20270101);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Vector3d r(number(random), number(random), number(random)),
        v(number(random), number(random), number(random));
    const Vector3d h = r.cross(v);
    const double sine = h.norm() / (r.norm() * v.norm());
    if (sine < 0.2) continue;
    const double tolerance = 4 * rounding / sine;
    const auto expect_along = [&](const auto& frame, int axis, const Vector3d& wanted) {
      const Dcm<Gcrf, Orbit> R = frame(position<double>(r), velocity_of<double>(v));
      EXPECT_LE((R.matrix().col(axis) - wanted.normalized()).norm(), tolerance);
      EXPECT_LE((R.matrix().transpose() * R.matrix() - Eigen::Matrix3d::Identity()).norm(), tolerance);
      EXPECT_GT(R.matrix().determinant(), 0.0);
    };
    expect_along(lvlh_of, 2, -r);
    expect_along(lvlh_of, 1, -h);
    expect_along(ric_of, 0, r);
    expect_along(ric_of, 2, h);
    expect_along(vnb_of, 0, v);
    expect_along(vnb_of, 1, h);
    expect_along(ntw_of, 1, v);
    expect_along(ntw_of, 2, h);
  }
}

// A path with given derivatives; the rates of the frame come from automatic differentiation of its matrix.
TEST(OrbitFrames, RateAndAccelerationAreDerivativesOfTheRotation) {
  std::mt19937_64 random(20270102);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Dual2 t = instant(0.0);
  for (int i = 0; i < 200; ++i) {
    Vector3d path[4];
    for (Vector3d& x : path) x = {number(random), number(random), number(random)};
    if (distance_from_singularity(position<double>(path[0]), velocity_of<double>(path[1])).value() < 0.2 ||
        path[0].norm() < 0.3 || path[1].norm() < 0.3)
      continue;
    ColumnOf<Dual2> r, v;
    for (int k = 0; k < 3; ++k) {
      const Dual2 x = constant(path[0](k)), xdot = constant(path[1](k)), half = constant(path[2](k) / 2),
                  sixth = constant(path[3](k) / 6);
      r(k) = x + t * (xdot + t * (half + t * sixth));
      v(k) = xdot + t * (constant(2) * half + constant(3) * t * sixth);
    }
    for_each_frame([&](const auto& frame) {
      const vectrix_test::Motion<Gcrf, Orbit> exact(frame(position<Dual2>(r), velocity_of<Dual2>(v)));
      const auto r0 = position<double>(path[0]);
      const auto v0 = velocity_of<double>(path[1]);
      const auto a0 = acceleration_of(path[2]);
      const MovingDcm<Gcrf, Orbit> moving = frame(r0, v0, a0);
      const AcceleratingDcm<Gcrf, Orbit> accelerating = frame(r0, v0, a0, jerk_of(path[3]));
      EXPECT_LE((moving.rotation.matrix() - exact.R).norm(), 10 * rounding);
      EXPECT_LE((moving.angular_velocity.coordinates() - exact.w_ab_b().coordinates()).norm(),
                random_rate_tolerance);
      EXPECT_EQ(accelerating.rotation.matrix(), moving.rotation.matrix());
      EXPECT_EQ(accelerating.angular_velocity.coordinates(), moving.angular_velocity.coordinates());
      EXPECT_LE((accelerating.angular_acceleration.coordinates() - exact.alpha_ab_b().coordinates()).norm(),
                random_acceleration_tolerance);
    });
  }
}

// On a circle the rate is the mean motion along h, and the acceleration is zero: to rounding, because
// sin(r, v) is 1.
TEST(OrbitFrames, RateOnACircleToRounding) {
  const double radius = 7e6, n = 1e-3;
  const auto a = acceleration_of({-n * n * radius, 0, 0});
  const auto jerk = jerk_of({0, -n * n * n * radius, 0});
  const PointMotion<Earth, Ship, Gcrf> motion{position<double>({radius, 0, 0}),
                                              velocity_of<double>({0, n * radius, 0})};
  for_each_frame([&](const auto& frame) {
    const AcceleratingDcm<Gcrf, Orbit> moving = frame(motion, a, jerk);
    const auto w_gcrf = moving.rotation * moving.angular_velocity;
    EXPECT_LE((w_gcrf.coordinates() - Vector3d(0, 0, n)).norm(), 1e-15 * n);
    EXPECT_LE(moving.angular_acceleration.coordinates().norm(), 1e-15 * n * n);
  });
}

// Check-case 10A of NASA (NASA/TM-2015-218675) at t = 0: body from LVLH by 85 deg about y, then 1 deg about
// the new z, and the rate of LVLH in body axes. Figures with 16 digits.
TEST(OrbitFrames, NasaLvlhAndItsRate) {
  struct Body : moving_frame {};
  struct Pitched : moving_frame {};
  const auto table =
      CsvTable::read(VECTRIX_SOURCE_DIR "/validation/data/nasa_10A_first_300s.csv", {"t_s", "x_m", "T11"});
  const auto at = [&](const char* column) { return table.number(0, column); };
  ASSERT_EQ(at("t_s"), 0.0);
  const auto r = position<double>({at("x_m"), at("y_m"), at("z_m")});
  const auto v = velocity_of<double>({at("vx_mps"), at("vy_mps"), at("vz_mps")});
  const auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);
  const auto moving = lvlh(from<Orbit>, r, v, two_body_acceleration(mu, r));
  const auto R_b_from_o = turned_z(to<Body>, from<Pitched>, convert<si::angle>(1.0 * si::degree)) *
                          turned_y(to<Pitched>, from<Orbit>, convert<si::angle>(85.0 * si::degree));
  Eigen::Matrix3d T;
  T << at("T11"), at("T12"), at("T13"), at("T21"), at("T22"), at("T23"), at("T31"), at("T32"), at("T33");
  const Dcm<Body, Gcrf> R_b_from_gcrf = R_b_from_o * inverse(moving.rotation);
  EXPECT_LE((R_b_from_gcrf.matrix() - T).norm(), 4 * rounding);
  const Vector3d w(at("wx_radps"), at("wy_radps"), at("wz_radps"));
  EXPECT_LE(((R_b_from_o * moving.angular_velocity).coordinates() - w).norm(), 4 * rounding * w.norm());
}

// Each lane of a batch as one number; other scalars to their rounding.
TEST(OrbitFrames, OtherScalars) {
  const Vector3d r(1.0, 0.25, -0.5), v(-0.25, 0.75, 0.5), a(-0.5, 0.125, 0.25), j(0.25, -1.0, 0.5);
  const auto all_of = [&]<class S>(S) {
    const auto cast = [](const Vector3d& x) {
      return ColumnOf<S>(x.unaryExpr([](double n) { return detail::number<S>(n); }));
    };
    const auto moving =
        vnb(from<Orbit>, position<S>(cast(r)), velocity_of<S>(cast(v)),
            acceleration(of<Ship>, relative_to<Earth>, observed_from<Gcrf>,
                         vector<si::acceleration>(in<Gcrf>, cast(a))),
            derivative<si::acceleration>(observed_from<Gcrf>, vector<si::jerk>(in<Gcrf>, cast(j))));
    return moving.angular_acceleration.coordinates();
  };
  using Lanes = std::experimental::native_simd<double>;
  const Vector3d exact = all_of(0.0L).cast<double>();
  const Vector3d number = all_of(0.0);
  const auto lanes = all_of(Lanes(0.0));
  EXPECT_LE((number - exact).norm(), 10 * rounding * exact.norm());
  EXPECT_LE((all_of(0.0f).cast<double>() - exact).norm(), 1e-5 * exact.norm());
  for (int k = 0; k < 3; ++k) {
    for (std::size_t lane = 0; lane < Lanes::size(); ++lane)
      EXPECT_NEAR(lanes(k)[lane], number(k), 10 * rounding * exact.norm());
  }
}

// J2 in a low inclined orbit: rate and acceleration differ from those of two bodies by what the comment of
// lvlh says.
TEST(OrbitFrames, JerkOfTheRealMotionCounts) {
  using Dual = vectrix_test::Dual;
  constexpr double mu = 3.986004415e14, equator = 6378136.3, J2 = 1.0826e-3;
  const auto gravity = [&](const auto& r, double j2) {
    using S = typename std::decay_t<decltype(r)>::Scalar;
    using std::sqrt;
    const S r2 = r.squaredNorm(), pull = S(mu) / (r2 * S(sqrt(r2)));
    const S k = S(1.5 * j2 * equator * equator) / r2, s = S(5) * r.z() * r.z() / r2;
    return ColumnOf<S>(-pull * r.x() * (S(1) + k * (S(1) - s)), -pull * r.y() * (S(1) + k * (S(1) - s)),
                       -pull * r.z() * (S(1) + k * (S(3) - s)));
  };
  const Vector3d r(-4292653.41, 955168.47, 5139356.57), v(109.649663, -7527.726490, 1484.521489);
  const auto moving = [&](double j2) {
    ColumnOf<Dual> along;
    for (int k = 0; k < 3; ++k) along(k) = Dual(r(k), Eigen::Matrix<double, 1, 1>(v(k)));
    const ColumnOf<Dual> a = gravity(along, j2);
    const Vector3d jerk(a(0).derivatives()(0), a(1).derivatives()(0), a(2).derivatives()(0));
    return lvlh(from<Orbit>, position<double>(r), velocity_of<double>(v), acceleration_of(gravity(r, j2)),
                jerk_of(jerk));
  };
  const auto real = moving(J2), two_body = moving(0.0);
  const double w_off =
      (real.angular_velocity.vector() - two_body.angular_velocity.vector()).coordinates().norm();
  const double alpha_off =
      (real.angular_acceleration.vector() - two_body.angular_acceleration.vector()).coordinates().norm();
  EXPECT_GT(w_off, 1e-7);
  EXPECT_LT(w_off, 1e-5);
  EXPECT_GT(alpha_off, 1e-10);
  EXPECT_LT(alpha_off, 1e-8);
}

TEST(OrbitFrames, EdgesOfAGraph) {
  const double radius = 7e6, n = 1e-3;
  const auto ship = edge([=](Quantity<si::time> t) {
    const double c = std::cos(n * t.value()), s = std::sin(n * t.value());
    return AcceleratingTransform<Gcrf, Ship>{
        rigid_edge(aligned(to<Gcrf>, from<Ship>)).value(),
        displacement(of<Ship>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, radius * Vector3d(c, s, 0))),
        velocity(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>,
                 vector<si::velocity>(in<Gcrf>, n * radius * Vector3d(-s, c, 0))),
        acceleration(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>,
                     vector<si::acceleration>(in<Gcrf>, -n * n * radius * Vector3d(c, s, 0)))};
  });
  const auto orbit = edge([](const Displacement<Gcrf, Ship, In<Gcrf>>& r,
                             const Velocity<Gcrf, Ship, ObservedFrom<Gcrf>, In<Gcrf>>& v,
                             const Acceleration<Gcrf, Ship, ObservedFrom<Gcrf>, In<Gcrf>>& a) {
    return lvlh(from<Orbit>, r, v, a);
  });
  const auto graph = frame_graph(ship, orbit);
  const auto now = graph.at(700.0 * si::second);
  const auto nadir = now.position(of<Gcrf>, relative_to<Ship>, in<Orbit>);
  EXPECT_LE((nadir.coordinates() / radius - Vector3d::UnitZ()).norm(), rounding);
  const auto w = now.angular_velocity(of<Orbit>, relative_to<Gcrf>, in<Orbit>);
  EXPECT_LE((w.coordinates() / n - Vector3d(0, -1, 0)).norm(), 4 * rounding);
}

template <class Frame>
concept TakesMotionObservedFrom = requires(const Displacement<Earth, Ship, In<Frame>>& r,
                                           const Velocity<Earth, Ship, ObservedFrom<Frame>, In<Frame>>& v) {
  { lvlh(from<Orbit>, r, v) } -> std::same_as<Dcm<Frame, Orbit>>;
};
static_assert(TakesMotionObservedFrom<Gcrf>);
struct Itrf : moving_frame {};
static_assert(!TakesMotionObservedFrom<Itrf>);

std::string refusal(const Vector3d& r, const Vector3d& v) {
  return complaint([&] { lvlh(from<Orbit>, position<double>(r), velocity_of<double>(v)); });
}

TEST(OrbitFrames, RectilinearMotionIsRefused) {
  const std::string end = "; rectilinear motion has no orbital plane";
  EXPECT_EQ(refusal({1, 0, 0}, {3, 2e-7 * 3, 0}), "nothing was thrown");
  const std::string small = refusal({4, 0, 0}, {3, 3 * 5e-8, 0});
  EXPECT_NE(small.find("lvlh(from<"), std::string::npos) << small;
  EXPECT_NE(small.find("Ship relative to"), std::string::npos) << small;
  EXPECT_NE(small.find("|r| is 4 m, |v| 3"), std::string::npos) << small;
  EXPECT_NE(small.find("the sine of the angle between them 4.99"), std::string::npos) << small;
  EXPECT_NE(small.find(end), std::string::npos) << small;
  EXPECT_NE(refusal({0, 0, 0}, {1, 0, 0}).find("|r| is 0 m"), std::string::npos);
  EXPECT_NE(refusal({1, 0, 0}, {0, 0, 0}).find("|v| 0 m/s"), std::string::npos);
  EXPECT_FALSE(refusal({1e200, 0, 0}, {0, 1e200, 0}).empty());
}

TEST(OrbitFrames, DistanceFromSingularityIsTheSine) {
  const auto distance = [](const Vector3d& r, const Vector3d& v) {
    return distance_from_singularity(position<double>(r), velocity_of<double>(v)).value();
  };
  EXPECT_NEAR(distance({2, 0, 0}, {0, 5, 0}), 1.0, rounding);
  EXPECT_NEAR(distance({2, 0, 0}, {std::sqrt(3.0), 1, 0}), 0.5, rounding);
  EXPECT_NEAR(distance({2, 0, 0}, {-3, 3e-9, 0}), 1e-9, 1e-9 * rounding);
  EXPECT_EQ(distance({0, 0, 0}, {1, 1, 0}), 0.0);
  EXPECT_EQ(distance({1, 1, 0}, {0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace vectrix::orbit_frames_test
