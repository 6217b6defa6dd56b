#include <erfa.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/aberration.hpp>

#include "temporary_file.hpp"
#include "testing/attitudes.hpp"

namespace vectrix::aberration_test {
namespace {

using vectrix_test::Body;
using vectrix_test::Gcrf;
using vectrix_test::triple;

constexpr double light = 299792458.0;  // m/s

Vector<Gcrf, si::dimensionless> along(const Eigen::Vector3d& n) {
  return direction(vector<si::length>(in<Gcrf>, n));
}
Vector<Gcrf, si::velocity> velocity(const Eigen::Vector3d& v) {
  return vector<si::velocity>(in<Gcrf>, v);
}

rc::Gen<Eigen::Vector3d> not_zero() {
  return rc::gen::suchThat(triple(), [](const Eigen::Vector3d& v) { return v.norm() > 1e-3; });
}

// Special relativity: tan(theta'/2) = ((1 - b)/(1 + b))^(1/2) tan(theta/2), in the plane of n and v.
RC_GTEST_PROP(Aberration, HalfTheAngleShrinksByTheDopplerFactor, ()) {
  const auto n = along(*not_zero());
  const Eigen::Vector3d v = (0.999 / std::sqrt(3.0) * light) * *not_zero();
  const Eigen::Vector3d seen = aberrated(n, velocity(v)).coordinates();
  const Eigen::Vector3d heading = v.normalized();
  const double b = v.norm() / light;
  const auto half_angle = [&](const Eigen::Vector3d& u) {
    return std::atan2((u - heading).norm(), (u + heading).norm());
  };
  constexpr double rounding = 1e-12;  // of tan, where b is 0.999
  const double expected = std::atan(std::sqrt((1 - b) / (1 + b)) * std::tan(half_angle(n.coordinates())));
  RC_ASSERT(std::abs(half_angle(seen) - expected) < rounding);
  RC_ASSERT(std::abs(seen.dot(n.coordinates().cross(heading))) < rounding);
  RC_ASSERT(std::abs(seen.norm() - 1.0) < vectrix_test::rounding);
}

// eraAb adds the potential of the Sun, 2e-8/s of the aberration at s au: left out far away.
RC_GTEST_PROP(Aberration, IsErfasFarFromTheSun, ()) {
  const auto n = along(*not_zero());
  const Eigen::Vector3d v = 6e4 * *triple();
  Eigen::Vector3d natural = n.coordinates();
  Eigen::Vector3d b = v / light;
  Eigen::Vector3d expected;
  eraAb(natural.data(), b.data(), 1e9, std::sqrt(1.0 - b.squaredNorm()), expected.data());
  RC_ASSERT((aberrated(n, velocity(v)).coordinates() - expected).norm() < vectrix_test::rounding);
}

TEST(Aberration, OfTheEarthIs20ArcSeconds) {
  const auto seen = aberrated(unit_x(in<Gcrf>), velocity({0.0, 29784.0, 0.0}));
  EXPECT_NEAR(std::atan2(seen.y().value(), seen.x().value()) / 4.84813681109536e-6, 20.49, 0.01);
  EXPECT_EQ(aberrated(unit_x(in<Gcrf>), velocity({0.0, 0.0, 0.0})).coordinates(), Eigen::Vector3d::UnitX());
  EXPECT_EQ(aberrated(unit_x(in<Gcrf>), velocity({3e4, 0.0, 0.0})).coordinates(), Eigen::Vector3d::UnitX());
}

TEST(Aberration, RefusesWhatIsNoDirectionAndNoVelocity) {
  const auto n = unit_x(in<Gcrf>);
  EXPECT_EQ(complaint([&] {
              (void)aberrated(2.0 * n, velocity({1.0, 0.0, 0.0}));
            }),
            "aberrated(n, v): |n| is 2; n must be a unit vector");
  for (const double off : {-1e-9, 1e-9}) {
    EXPECT_NO_THROW((void)aberrated((1.0 + 0.999 * off) * n, velocity({1.0, 0.0, 0.0})));
    EXPECT_THROW((void)aberrated((1.0 + 1.001 * off) * n, velocity({1.0, 0.0, 0.0})), BadInput);
  }
  EXPECT_EQ(complaint([&] {
              (void)aberrated(n, velocity({light, 0.0, 0.0}));
            }),
            "aberrated(n, v): |v| is 299792458 m/s; it must be below the speed of light");
  EXPECT_THROW((void)aberrated(n, velocity({1e300, 1e300, 0.0})), BadInput);
}

template <class N, class V>
concept Aberrates = requires(const N& n, const V& v) {
  aberrated(n, v);
};
using Direction = Vector<Gcrf, si::dimensionless>;
static_assert(Aberrates<Direction, Vector<Gcrf, si::velocity>>);
static_assert(!Aberrates<Direction, Vector<Body, si::velocity>>);
static_assert(!Aberrates<Direction, Vector<Gcrf, si::length>>);
static_assert(!Aberrates<Vector<Gcrf, si::length>, Vector<Gcrf, si::velocity>>);

}  // namespace
}  // namespace vectrix::aberration_test
