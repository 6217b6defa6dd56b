#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/frames/scalar/lanes.hpp>
#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/points/parallel.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>
#include <vectrix/space/pointing/pointing.hpp>

#include "temporary_file.hpp"
#include "testing/motions.hpp"

namespace vectrix::pointing_test {
namespace {

using Eigen::Vector3d;
using vectrix_test::Dual2, vectrix_test::constant, vectrix_test::instant;

struct Gcrf : inertial_frame {};
struct Turning : moving_frame {};
struct Body : moving_frame {};
struct Earth : named_point {};
struct Ship : named_point {};

constexpr double rounding = 4e-16;  // of a unit vector's coordinates
// Numbers of size 1 and sines from 0.2: rates reach 10 and accelerations 1e3, and the rounding of the cross
// product is amplified by 1/sin^2.
constexpr double rate_tolerance = 1e-13;
constexpr double acceleration_tolerance = 1e-11;

template <class S> using ColumnOf = Eigen::Matrix<S, 3, 1>;
using Path = std::array<Vector3d, 3>;

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  double number() { return number_(random_); }
  Vector3d vector() {
    Vector3d x(number(), number(), number());
    return x.norm() < 0.3 ? vector() : x;
  }
  Path path() { return {vector(), vector(), vector()}; }
  /// Two, not nearly along one line.
  template <class Make> auto pair(const Make& make) {
    auto u = make(), v = make();
    while (sine(u, v) < 0.2) u = make(), v = make();
    return std::pair{u, v};
  }

 private:
  static double sine(const Vector3d& u, const Vector3d& v) {
    return u.cross(v).norm() / (u.norm() * v.norm());
  }
  static double sine(const Path& u, const Path& v) { return sine(u[0], v[0]); }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> number_{-1.0, 1.0};
};

// u + udot t + uddot t^2/2 at t = 0, with its derivatives by t.
ColumnOf<Dual2> along(const Path& u) {
  const Dual2 t = instant(0.0);
  ColumnOf<Dual2> x;
  for (int k = 0; k < 3; ++k) x(k) = constant(u[0](k)) + t * (constant(u[1](k)) + t * constant(u[2](k) / 2));
  return x;
}
template <class A, class S> auto length(const ColumnOf<S>& u) {
  return vector<si::length>(in<A>, u);
}
template <class A> auto direction_of(const Path& u) {
  return moving_direction(length<A>(u[0]),
                          derivative<si::length>(observed_from<A>, vector<si::velocity>(in<A>, u[1])),
                          derivative<si::velocity>(observed_from<A>, vector<si::acceleration>(in<A>, u[2])));
}
template <class S> Vector<Body, si::dimensionless, S> axis(const Vector3d& u) {
  return vector<si::dimensionless>(in<Body>, ColumnOf<S>(u.template cast<S>()));
}

TEST(Pointing, AlignsOneAxisAndBringsTheOtherNear) {
  Random random(20270201);
  for (int i = 0; i < 200; ++i) {
    const auto [u, v] = random.pair([&] { return random.vector(); });
    const auto [b1, b2] = random.pair([&] { return random.vector(); });
    const Dcm<Gcrf, Body> R = pointing(align(axis<double>(b1), moving_direction(length<Gcrf>(u))),
                                       constrain(axis<double>(b2), moving_direction(length<Gcrf>(v))));
    const double tolerance = 10 * rounding / 0.2;
    EXPECT_LE((R.matrix() * b1.normalized() - u.normalized()).norm(), tolerance);
    EXPECT_LE((R.matrix().transpose() * R.matrix() - Eigen::Matrix3d::Identity()).norm(), tolerance);
    EXPECT_GT(R.matrix().determinant(), 0.0);
    // Turned about u from there, the second axis moves away from v on either side.
    const auto nearness = [&R, &u = u, &v = v, &b2 = b2](double angle) {
      return (Eigen::AngleAxisd(angle, u.normalized()) * (R.matrix() * b2)).dot(v);
    };
    EXPECT_GT(nearness(0.0), nearness(1e-3));
    EXPECT_GT(nearness(0.0), nearness(-1e-3));
    EXPECT_GT(nearness(0.0), nearness(3.0));
  }
}

TEST(Pointing, RateAndAccelerationAreDerivativesOfTheRotation) {
  Random random(20270202);
  for (int i = 0; i < 200; ++i) {
    const auto [u, v] = random.pair([&] { return random.path(); });
    const auto [b1, b2] = random.pair([&] { return random.vector(); });
    const vectrix_test::Motion<Gcrf, Body> exact(
        pointing(align(axis<Dual2>(b1), moving_direction(length<Gcrf>(along(u)))),
                 constrain(axis<Dual2>(b2), moving_direction(length<Gcrf>(along(v))))));
    const AcceleratingDcm<Gcrf, Body> now = pointing(align(axis<double>(b1), direction_of<Gcrf>(u)),
                                                     constrain(axis<double>(b2), direction_of<Gcrf>(v)));
    EXPECT_LE((now.rotation.matrix() - exact.R).norm(), 10 * rounding / 0.2);
    EXPECT_LE((now.angular_velocity.coordinates() - exact.w_ab_b().coordinates()).norm(), rate_tolerance);
    EXPECT_LE((now.angular_acceleration.coordinates() - exact.alpha_ab_b().coordinates()).norm(),
              acceleration_tolerance);
  }
}

// The level of a result is the lower of the two directions; what it has is what a higher level has.
TEST(Pointing, LevelsAgree) {
  Random random(20270203);
  const auto [u, v] = random.pair([&] { return random.path(); });
  const auto whole = direction_of<Gcrf>(u);
  const auto rate = moving_direction(
      length<Gcrf>(v[0]), derivative<si::length>(observed_from<Gcrf>, vector<si::velocity>(in<Gcrf>, v[1])));
  const auto held = moving_direction(length<Gcrf>(v[0]));
  const auto x = unit_x(in<Body>), z = unit_z(in<Body>);
  const AcceleratingDcm<Gcrf, Body> all = pointing(align(z, whole), constrain(x, direction_of<Gcrf>(v)));
  const MovingDcm<Gcrf, Body> moving = pointing(align(z, whole), constrain(x, rate));
  const Dcm<Gcrf, Body> R = pointing(align(z, whole), constrain(x, held));
  EXPECT_EQ(moving.angular_velocity.coordinates(), all.angular_velocity.coordinates());
  EXPECT_EQ(moving.rotation.matrix(), all.rotation.matrix());
  EXPECT_EQ(R.matrix(), all.rotation.matrix());
  const AcceleratingDcm<Gcrf, Body> fixed = pointing(align(z, fixed_direction(length<Gcrf>(u[0]))),
                                                     constrain(x, fixed_direction(length<Gcrf>(v[0]))));
  EXPECT_EQ(fixed.angular_velocity.coordinates().norm(), 0.0);
  EXPECT_EQ(fixed.angular_acceleration.coordinates().norm(), 0.0);
}

// lvlh() is nadir pointing with x as near as possible to the velocity.
TEST(Pointing, ToNadirIsLvlh) {
  Random random(20270204);
  for (int i = 0; i < 50; ++i) {
    const auto [r, v] = random.pair([&] { return random.vector(); });
    const Vector3d a = random.vector(), j = random.vector();
    const auto motion = point_motion(of<Ship>, relative_to<Earth>, observed_from<Gcrf>, length<Gcrf>(r),
                                     vector<si::velocity>(in<Gcrf>, v));
    const auto acceleration_ = acceleration(of<Ship>, relative_to<Earth>, observed_from<Gcrf>,
                                            vector<si::acceleration>(in<Gcrf>, a));
    const auto jerk = derivative<si::acceleration>(observed_from<Gcrf>, vector<si::jerk>(in<Gcrf>, j));
    const AcceleratingDcm<Gcrf, Body> wanted = lvlh(from<Body>, motion, acceleration_, jerk);
    const AcceleratingDcm<Gcrf, Body> pointed =
        pointing(align(unit_z(in<Body>), -moving_direction(motion, acceleration_)),
                 constrain(unit_x(in<Body>), moving_direction(motion.velocity, acceleration_, jerk)));
    EXPECT_LE((pointed.rotation.matrix() - wanted.rotation.matrix()).norm(), 10 * rounding);
    EXPECT_LE((pointed.angular_velocity.coordinates() - wanted.angular_velocity.coordinates()).norm(),
              rate_tolerance);
    EXPECT_LE((pointed.angular_acceleration.coordinates() - wanted.angular_acceleration.coordinates()).norm(),
              acceleration_tolerance);
  }
}

// A camera follows a place on the turning Earth from an orbit: seen from the body the place moves along z
// alone, in its velocity and its acceleration.
TEST(Pointing, FollowsATargetThroughAGraph) {
  struct Satellite : moving_frame {};
  struct Ground : moving_frame {};
  struct Site : moving_frame {};
  const double r = 7e6, n = 1.08e-3, w = 7.29e-5;
  const auto earth = edge([=](Quantity<si::time> t) {
    const AcceleratingDcm<Gcrf, Ground> turning = accelerating_dcm(
        inverse(turned_z(to<Ground>, from<Gcrf>, Quantity<si::angle>::from_value(w * t.value()))),
        angular_velocity(of<Ground>, relative_to<Gcrf>,
                         vector<si::angular_velocity>(in<Ground>, Vector3d(0, 0, w))),
        unaccelerated(of<Ground>, relative_to<Gcrf>, in<Ground>));
    return coincident(turning);
  });
  const auto site = rigid_edge(Transform<Ground, Site>{
      aligned(to<Ground>, from<Site>),
      displacement(of<Site>, relative_to<Ground>, length<Ground>(Vector3d(6.1e6, 1.2e6, 1.3e6)))});
  const auto orbit = edge([=](Quantity<si::time> t) {
    const double c = std::cos(n * t.value()), s = std::sin(n * t.value());
    const Vector3d x(r * c, 0.6 * r * s, 0.8 * r * s), v = n * r * Vector3d(-s, 0.6 * c, 0.8 * c);
    return parallel(point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, length<Gcrf>(x),
                                 vector<si::velocity>(in<Gcrf>, v)),
                    acceleration(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                                 vector<si::acceleration>(in<Gcrf>, Vector3d(-n * n * x))));
  });
  const auto camera =
      edge([](const Displacement<Satellite, Site, In<Satellite>>& to_site,
              const Velocity<Satellite, Site, ObservedFrom<Satellite>, In<Satellite>>& v,
              const Acceleration<Satellite, Site, ObservedFrom<Satellite>, In<Satellite>>& a) {
        return pointing(align(unit_z(in<Body>), moving_direction(to_site, v, a)),
                        constrain(unit_y(in<Body>), fixed_direction(unit_z(in<Satellite>))));
      });
  const auto graph = frame_graph(earth, site, orbit, camera);
  for (const double t : {0.0, 150.0, 700.0}) {
    const auto now = graph.at(t * si::second);
    const Vector3d place = now.position(of<Site>, relative_to<Satellite>, in<Body>).coordinates();
    const Vector3d v =
        now.velocity(of<Site>, relative_to<Satellite>, observed_from<Body>, in<Body>).coordinates();
    const Vector3d a =
        now.acceleration(of<Site>, relative_to<Satellite>, observed_from<Body>, in<Body>).coordinates();
    // Of what is subtracted: |w| |r| and |alpha| |r| + 2 |w| |v| + |w|^2 |r|, with w up to 0.1 rad/s.
    EXPECT_LE(place.head<2>().norm(), 10 * rounding * place.norm()) << t;
    EXPECT_GT(place.z(), 0.0) << t;
    EXPECT_LE(v.head<2>().norm(), 1e-15 * 0.1 * place.norm() + 1e-11) << t;
    EXPECT_LE(a.head<2>().norm(), 1e-12) << t;
    EXPECT_GT(std::abs(v.z()), 10.0) << t;
  }
}

// A direction for another observer: what is differentiated is R(t) u(t).
TEST(MovingDirection, ForAnotherObserver) {
  Random random(20270205);
  for (int i = 0; i < 50; ++i) {
    const Path u = random.path();
    const auto R = vectrix_test::turning<Gcrf, Turning>(10 * random.number(), instant(0.0));
    const vectrix_test::Motion<Gcrf, Turning> motion(R);
    const ColumnOf<Dual2> exact = R.matrix() * along(u);
    const auto expect_first = [&](const auto& direction, std::size_t known) {
      ASSERT_EQ(direction.numbers().size(), known);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(direction.numbers()[0](k), vectrix_test::value(exact(k)), vectrix_test::motion_tolerance);
        if constexpr (std::decay_t<decltype(direction)>::level != Level::rotation) {
          EXPECT_NEAR(direction.numbers()[1](k), vectrix_test::first(exact(k)),
                      vectrix_test::motion_tolerance);
        }
        if constexpr (std::decay_t<decltype(direction)>::level == Level::acceleration) {
          EXPECT_NEAR(direction.numbers()[2](k), vectrix_test::second(exact(k)),
                      100 * vectrix_test::motion_tolerance);
        }
      }
    };
    const MovingDirection<Turning, Level::acceleration> moving = direction_of<Turning>(u);
    const auto held = moving_direction(length<Turning>(u[0]));
    expect_first(motion.accelerating() * moving, 3);
    expect_first(motion.moving() * moving, 2);
    expect_first(motion.rotation() * moving, 1);
    expect_first(motion.accelerating() * held, 1);
    expect_first(motion.moving() * held, 1);
  }
}

TEST(Pointing, OtherScalars) {
  const Path u{Vector3d(1.0, 0.25, -0.5), Vector3d(-0.25, 0.75, 0.5), Vector3d(-0.5, 0.125, 0.25)};
  const Path v{Vector3d(0.5, -1.0, 0.5), Vector3d(0.75, 0.25, 0.5), Vector3d(0.25, -1.0, 0.5)};
  const auto all_of = [&]<class S>(S) {
    const auto jet = [](const Path& path) {
      detail::Jet<S, 3> numbers;
      for (std::size_t i = 0; i < 3; ++i)
        numbers[i] = path[i].unaryExpr([](double n) { return detail::number<S>(n); });
      return MovingDirection<Gcrf, Level::acceleration, S>{detail::trusted, numbers};
    };
    return ColumnOf<S>(
        pointing(align(unit_z<Body, S>(in<Body>), jet(u)), constrain(unit_y<Body, S>(in<Body>), jet(v)))
            .angular_acceleration.coordinates());
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

std::string refusal(const Vector3d& u, const Vector3d& v, const Vector3d& b1, const Vector3d& b2) {
  return complaint([&] {
    pointing(align(vector<si::dimensionless>(in<Body>, b1), moving_direction(length<Gcrf>(u))),
             constrain(vector<si::dimensionless>(in<Body>, b2), moving_direction(length<Gcrf>(v))));
  });
}

TEST(Pointing, OneDirectionIsRefused) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  EXPECT_EQ(refusal({2, 0, 0}, {3, 3 * 2e-7, 0}, x, y), "nothing was thrown");
  const std::string along = refusal({2, 0, 0}, {-3, 3 * 5e-8, 0}, x, y);
  EXPECT_NE(along.find("pointing("), std::string::npos) << along;
  EXPECT_NE(along.find("Body relative to"), std::string::npos) << along;
  EXPECT_NE(along.find("the lengths of the two directions are 2 and 3"), std::string::npos) << along;
  EXPECT_NE(along.find("the sine of the angle between them 4.99"), std::string::npos) << along;
  EXPECT_NE(refusal({0, 0, 0}, x, x, y).find("are 0 and 1"), std::string::npos);
  EXPECT_NE(refusal(x, {0, 0, 0}, x, y).find("are 1 and 0"), std::string::npos);
  EXPECT_NE(refusal({1e200, 0, 0}, {0, 1e200, 0}, x, y), "nothing was thrown");
  const std::string axes = refusal(x, y, {0, 0, 1}, {0, 0, -2});
  EXPECT_NE(axes.find("the lengths of the two axes are 1 and 2"), std::string::npos) << axes;
}

TEST(Pointing, DistanceFromSingularityIsTheSine) {
  const auto distance = [](const Vector3d& u, const Vector3d& v) {
    return distance_from_singularity(moving_direction(length<Gcrf>(u)), direction_of<Gcrf>({v, v, v}))
        .value();
  };
  EXPECT_NEAR(distance({2, 0, 0}, {0, 5, 0}), 1.0, rounding);
  EXPECT_NEAR(distance({2, 0, 0}, {std::sqrt(3.0), 1, 0}), 0.5, rounding);
  EXPECT_NEAR(distance({2, 0, 0}, {-3, 3e-9, 0}), 1e-9, 1e-9 * rounding);
  EXPECT_EQ(distance({0, 0, 0}, {1, 1, 0}), 0.0);
}

}  // namespace
}  // namespace vectrix::pointing_test
