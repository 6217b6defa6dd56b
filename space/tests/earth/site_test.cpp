#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>
#include <vectrix/space/earth/site.hpp>

#include "temporary_file.hpp"

namespace vectrix::site_test {
namespace {

using earth::Itrf;

struct Station : east_north_up_frame {};
struct Runway : north_east_down_frame {};
struct Plain : moving_frame {};
struct Both : east_north_up_frame, north_east_down_frame {};

static_assert(EastNorthUpFrame<Station> && !NorthEastDownFrame<Station>);
static_assert(NorthEastDownFrame<Runway> && !EastNorthUpFrame<Runway>);
static_assert(!EastNorthUpFrame<Plain> && !EastNorthUpFrame<Itrf> && !EastNorthUpFrame<Both>);
static_assert(!EastNorthUpFrame<east_north_up_frame>, "the axes of many places are no frame");

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-15;  // of a unit vector's coordinates
// A step of 1 m turns the vertical by 1.6e-7 rad: along a step the place moves so much off the axis.
constexpr double curvature = 2e-7;        // m, for steps of 1 m
constexpr double length_rounding = 5e-9;  // m: a few times 1e-16 of the Earth's radius

Geodetic place(double latitude, double longitude, double height) {
  return {GeodeticLatitude(latitude * si::radian), longitude * si::radian, height * si::metre};
}

TEST(Site, AxesOnTheEquatorAndAtThePoles) {
  const auto axes = [](double latitude, double longitude) {
    return east_north_up(from<Station>, place(latitude, longitude, 0.0)).rotation.matrix();
  };
  Eigen::Matrix3d expected;
  expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // columns: east is y, north z, up x
  EXPECT_LE((axes(0.0, 0.0) - expected).norm(), rounding);
  // At the pole with longitude 0: east y, north against x, up z. At the other pole: north along x, up -z.
  expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LE((axes(pi / 2, 0.0) - expected).norm(), rounding);
  expected << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  EXPECT_LE((axes(-pi / 2, 0.0) - expected).norm(), rounding);
  // The longitude decides there: a quarter turn of it is a quarter turn of the axes.
  expected << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  EXPECT_LE((axes(pi / 2, pi / 2) - expected).norm(), rounding);
}

// East, north and up are where a place goes if its longitude, latitude or height grows.
TEST(Site, AxesAreTheDirectionsOfGrowingCoordinates) {
  std::mt19937_64 random(20261201);
  std::uniform_real_distribution<double> latitude(-1.5, 1.5), longitude(-pi, pi), height(-1e4, 1e6);
  for (int i = 0; i < 300; ++i) {
    const double phi = latitude(random), lambda = longitude(random), h = height(random);
    const auto X = east_north_up(from<Station>, place(phi, lambda, h));
    const Eigen::Matrix3d& R = X.rotation.matrix();
    EXPECT_LE((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), rounding);
    EXPECT_GT(R.determinant(), 0.0);
    const Eigen::Vector3d at = wgs84::position(place(phi, lambda, h)).coordinates();
    EXPECT_EQ(X.translation.coordinates(), at);
    const auto expect_along = [&](const Geodetic& moved, int axis) {
      const Eigen::Vector3d step = wgs84::position(moved).coordinates() - at;
      EXPECT_LE((step / step.norm() - R.col(axis)).norm(), 2 * curvature / std::cos(phi)) << axis;
    };
    constexpr double about_a_metre = 1.5e-7;  // rad
    expect_along(place(phi, lambda + about_a_metre / std::cos(phi), h), 0);
    expect_along(place(phi + about_a_metre, lambda, h), 1);
    expect_along(place(phi, lambda, h + 1.0), 2);
    EXPECT_LE((R.col(2) - wgs84::up(wgs84::position(place(phi, lambda, h))).coordinates()).norm(),
              2 * rounding);
  }
}

TEST(Site, NorthEastDownHasTheSameAxesInAnotherOrder) {
  const Geodetic here = place(0.9, -2.0, 300.0);
  const auto enu = east_north_up(from<Station>, here);
  const auto ned = north_east_down(from<Runway>, here);
  Eigen::Matrix3d R_ned_from_enu;
  R_ned_from_enu << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  EXPECT_LE(((inverse(ned.rotation) * enu.rotation).matrix() - R_ned_from_enu).norm(), rounding);
  EXPECT_EQ(ned.translation.coordinates(), enu.translation.coordinates());
}

// Straight above the place is on the z axis: the height.
TEST(Site, IsARigidEdge) {
  const Geodetic here = place(-0.6, 2.5, 100.0), above = place(-0.6, 2.5, 20100.0);
  const auto graph = frame_graph(rigid_edge(east_north_up(from<Station>, here)),
                                 rigid_edge(north_east_down(from<Runway>, above)));
  const auto now = graph.at(0.0 * si::second);
  const Eigen::Vector3d r = now.position(of<Runway>, relative_to<Station>, in<Station>).coordinates();
  EXPECT_LE((r - Eigen::Vector3d(0.0, 0.0, 2e4)).norm(), length_rounding);
  EXPECT_EQ(now.angular_velocity(of<Station>, relative_to<Itrf>, in<Station>).coordinates().norm(), 0.0);
}

TEST(Site, RefusesBadInput) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(
      complaint([] { east_north_up(from<Station>, place(1.6, 0.0, 0.0)); }),
      "east_north_up(from<" + frame_name<Station>() + ">): the latitude 1.6 rad is not in [-pi/2, pi/2]");
  EXPECT_EQ(complaint([&] { north_east_down(from<Runway>, place(1.0, nan, 0.0)); }),
            "north_east_down(from<" + frame_name<Runway>() + ">): the longitude nan rad is not finite");
  EXPECT_EQ(complaint([&] { east_north_up(from<Station>, place(1.0, 0.0, -infinity)); }),
            "east_north_up(from<" + frame_name<Station>() + ">): the height -inf m is not finite");
  EXPECT_THROW(east_north_up(from<Station>, place(nan, 0.0, 0.0)), BadInput);
  EXPECT_THROW(east_north_up(from<Station>, place(0.0, infinity, 0.0)), BadInput);
  EXPECT_THROW(east_north_up(from<Station>, place(0.0, 0.0, nan)), BadInput);
}

}  // namespace
}  // namespace vectrix::site_test
