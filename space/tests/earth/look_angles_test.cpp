#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/space/earth/look_angles.hpp>

#include "temporary_file.hpp"
#include "testing/motions.hpp"

namespace vectrix::look_angles_test {
namespace {

using vectrix_test::Dual;

struct Station : east_north_up_frame {};
struct Runway : north_east_down_frame {};
struct Plain : moving_frame {};
struct Gcrf : inertial_frame {};
struct Ship : moving_frame {};

constexpr double pi = std::numbers::pi;
constexpr double angle_rounding = 1e-15;     // rad, of angles up to 2 pi
constexpr double relative_rounding = 1e-15;  // of range and position
// Of rates by numbers of size 1: that of the range is below 2, those of the angles below 20, because the
// point is at least 0.1 off the vertical.
constexpr double range_rate_rounding = 1e-14, angle_rate_rounding = 1e-13;

Displacement<Station, Ship, In<Station>> at(double e, double n, double u) {
  return displacement(of<Ship>, relative_to<Station>,
                      vector<si::length>(in<Station>, Eigen::Vector3d(e, n, u)));
}
Velocity<Station, Ship, ObservedFrom<Station>, In<Station>> moving(double e, double n, double u) {
  return velocity(of<Ship>, relative_to<Station>, observed_from<Station>,
                  vector<si::velocity>(in<Station>, Eigen::Vector3d(e, n, u)));
}

template <class P, class F>
concept HasLook = requires(const Displacement<P, Ship, In<F>>& r) {
  { look_angles(r) } -> std::same_as<LookAngles>;
};
static_assert(HasLook<Station, Station>);
static_assert(!HasLook<Plain, Plain> && !HasLook<Runway, Runway> && !HasLook<earth::Itrf, earth::Itrf>);
static_assert(!HasLook<earth::Itrf, Station>, "seen from the centre of the Earth");

TEST(LookAngles, OfTheEightPointsOfTheCompass) {
  for (int eighth = 0; eighth < 8; ++eighth) {
    const double azimuth = eighth * pi / 4;
    const LookAngles look = look_angles(at(std::sin(azimuth), std::cos(azimuth), 1.0));
    EXPECT_NEAR(look.azimuth.value(), azimuth, angle_rounding);
    EXPECT_NEAR(look.elevation.value(), pi / 4, angle_rounding);
    EXPECT_NEAR(look.range.value(), std::sqrt(2.0), relative_rounding);
  }
}

TEST(LookAngles, AzimuthIsBelowAWholeTurn) {
  EXPECT_EQ(look_angles(at(-1e-300, 1.0, 0.0)).azimuth.value(), 0.0);
  EXPECT_LT(look_angles(at(-1e-15, 1.0, 0.0)).azimuth.value(), 2 * pi);
  EXPECT_GT(look_angles(at(-1e-15, 1.0, 0.0)).azimuth.value(), 6.0);
  EXPECT_FALSE(std::signbit(look_angles(at(-0.0, 1.0, 0.0)).azimuth.value()));
  EXPECT_EQ(look_angles(at(-0.0, -1.0, 0.0)).azimuth.value(), pi);
}

TEST(LookAngles, InTheZenithTheAzimuthIsZero) {
  for (const double up : {5e5, -5e5}) {
    const LookAngles look = look_angles(at(0.0, 0.0, up));
    EXPECT_EQ(look.azimuth.value(), 0.0);
    EXPECT_EQ(look.elevation.value(), std::copysign(pi / 2, up));
    EXPECT_EQ(look.range.value(), 5e5);
  }
}

TEST(LookAngles, AndBack) {
  std::mt19937_64 random(20261202);
  std::uniform_real_distribution<double> number(-1.0, 1.0), exponent(-150.0, 150.0);
  for (int i = 0; i < 500; ++i) {
    const double size = std::pow(10.0, exponent(random));
    const auto r = at(size * number(random), size * number(random), size * number(random));
    const auto back = displacement_at(of<Ship>, relative_to<Station>, look_angles(r));
    EXPECT_LE((back.coordinates() - r.coordinates()).stableNorm(), 4 * relative_rounding * norm(r).value());
  }
}

// The reference: the angles of r + t v with automatic derivatives.
TEST(LookAngles, RatesAreTheDerivatives) {
  std::mt19937_64 random(20261203);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d r(number(random), number(random), number(random)),
        v(number(random), number(random), number(random));
    if (std::hypot(r.x(), r.y()) < 0.1) continue;
    Eigen::Matrix<Dual, 3, 1> path;
    for (int k = 0; k < 3; ++k) path(k) = Dual(r(k), 1, 0) + Dual(0.0, 1, 0) * (v(k) - 1.0);
    const auto moved = look_angles(at(r.x(), r.y(), r.z()), moving(v.x(), v.y(), v.z()));
    const Dual h = sqrt(path(0) * path(0) + path(1) * path(1));
    const Dual azimuth = atan2(path(0), path(1)), elevation = atan2(path(2), h),
               range = sqrt(h * h + path(2) * path(2));
    EXPECT_EQ(moved.azimuth.value(), look_angles(at(r.x(), r.y(), r.z())).azimuth.value());
    EXPECT_NEAR(moved.azimuth_rate.value(), azimuth.derivatives()(0), angle_rate_rounding);
    EXPECT_NEAR(moved.elevation_rate.value(), elevation.derivatives()(0), angle_rate_rounding);
    EXPECT_NEAR(moved.range_rate.value(), range.derivatives()(0), range_rate_rounding);
  }
}

// Straight over the place: past the zenith the azimuth jumps by half a turn, its rate grows as 1/h.
TEST(LookAngles, NextToTheZenith) {
  for (const double h : {1e-3, 1e-30, 1e-200}) {
    const auto moved = look_angles(at(h, 0.0, 5e5), moving(0.0, 7e-200, 0.0));
    EXPECT_NEAR(moved.azimuth_rate.value() * h / -7e-200, 1.0, relative_rounding);
    EXPECT_NEAR(look_angles(at(h, 0.0, 5e5), moving(7e3, 0.0, 0.0)).elevation_rate.value(), -0.014,
                angle_rounding);
  }
}

TEST(LookAngles, OfAMotion) {
  const auto motion = point_motion(of<Ship>, relative_to<Station>, observed_from<Station>,
                                   vector<si::length>(in<Station>, Eigen::Vector3d(0.0, 3e5, 4e5)),
                                   vector<si::velocity>(in<Station>, Eigen::Vector3d(5e3, 0.0, 1e3)));
  const MovingLookAngles look = look_angles(motion);
  EXPECT_EQ(look.azimuth.value(), 0.0);
  EXPECT_NEAR(look.range_rate.value(), 800.0, 1e3 * relative_rounding);
  EXPECT_NEAR(look.azimuth_rate.value(), 5e3 / 3e5, angle_rounding);
  EXPECT_NEAR(look.elevation_rate.value(), 0.6e3 / 5e5, angle_rounding);
}

TEST(LookAngles, RefusesBadInput) {
  const std::string name = "(" + frame_name<Ship>() + " from " + frame_name<Station>() + "): ";
  EXPECT_EQ(complaint([] { look_angles(at(0.0, 0.0, 0.0)); }), "look_angles" + name + "the range is 0 m");
  EXPECT_THROW(look_angles(at(1.7e308, 1.7e308, 0.0)), BadInput);
  EXPECT_EQ(complaint([] { look_angles(at(0.0, 0.0, 5e5), moving(0.0, 0.0, 1.0)); }),
            "look_angles" + name + "at (0, 0, 5e+05) m, in the zenith, azimuth and elevation have no rates");
  EXPECT_EQ(complaint([] { look_angles(at(1e-300, 0.0, 1.0), moving(0.0, 1e10, 0.0)); }),
            "look_angles" + name +
                "the rates overflow: the position is (1e-300, 0, 1) m, the velocity (0, 1e+10, 0) m/s");
  const auto back = [](double azimuth, double elevation, double range) {
    return displacement_at(of<Ship>, relative_to<Station>,
                           LookAngles{azimuth * si::radian, elevation * si::radian, range * si::metre});
  };
  EXPECT_EQ(complaint([&] { back(0.0, 1.6, 1.0); }),
            "displacement_at" + name + "the elevation 1.6 rad is not in [-pi/2, pi/2]");
  for (const double most : {pi / 2, -pi / 2}) {
    EXPECT_NO_THROW(back(0.0, most, 1.0));
    EXPECT_THROW(back(0.0, std::nextafter(most, 2 * most), 1.0), BadInput);
  }
  EXPECT_EQ(complaint([&] { back(0.0, 1.0, -1.0); }), "displacement_at" + name + "the range is -1 m");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([&] { back(nan, 1.0, 1.0); }),
            "displacement_at" + name + "the azimuth nan rad is not finite");
  EXPECT_THROW(back(0.0, nan, 1.0), BadInput);
  EXPECT_THROW(back(0.0, 1.0, nan), BadInput);
  EXPECT_THROW(back(0.0, 1.0, std::numeric_limits<double>::infinity()), BadInput);
}

}  // namespace
}  // namespace vectrix::look_angles_test
