#ifndef VECTRIX_SANITIZED  // they allocate themselves
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <string>

#include <vectrix/space.hpp>

#include "testing/allocations.hpp"

namespace vectrix::allocations_test {
namespace {

using earth::Gcrf, earth::Itrf;

struct Body : moving_frame {};
struct Satellite : moving_frame {};
struct Station : east_north_up_frame {};

// The second time: the first may make what is kept.
template <class Call> std::size_t allocations_of(const Call& call) {
  static_cast<void>(call());
  const std::size_t before = vectrix_test::allocations();
  static_cast<void>(call());
  return vectrix_test::allocations() - before;
}

// The counter sees what it should: an Eigen matrix of run-time size. It is made at a place that the compiler
// does not know, as it may leave out what it can follow.
Eigen::VectorXd* volatile kept;
std::string* volatile kept_text;
TEST(Allocations, AreCounted) {
  Eigen::VectorXd numbers;
  std::string text;
  kept = &numbers;
  kept_text = &text;
  EXPECT_EQ(allocations_of([] { return (*kept = Eigen::VectorXd::Zero(5).eval()).data(); }), 1U);
  EXPECT_EQ(allocations_of([] { return (*kept_text = std::string(100, ' ')).data(); }), 1U);
}

template <class U, Frame F> Vector<F, U> vector_in(double x, double y, double z) {
  return vector<U>(in<F>, Eigen::Vector3d(x, y, z));
}
template <Frame F>
const auto motion = point_motion(of<Satellite>, relative_to<F>, observed_from<F>,
                                 vector_in<si::length, F>(7e6, 1e5, 2e6),
                                 vector_in<si::velocity, F>(-2e3, 7e3, 5e2));
const Geodetic place{GeodeticLatitude(0.5 * si::radian), 0.2 * si::radian, 100.0 * si::metre};

// The name for an error is a text: it is written only for one.
TEST(Allocations, PlacesOnTheEarthNeedNone) {
  const auto azimuth = 0.3 * si::radian;
  const auto side = fixed_direction(vector_in<si::dimensionless, Itrf>(0.0, 1.0, 0.0));
  const auto seen =
      displacement(of<Satellite>, relative_to<Station>, vector_in<si::length, Station>(7e5, 1e5, 2e5));
  const auto look = look_angles(seen);
  EXPECT_EQ(allocations_of([&] { return wgs84::radii_of_curvature(place); }), 0U);
  EXPECT_EQ(allocations_of([&] { return wgs84::horizon_dip(place, azimuth); }), 0U);
  EXPECT_EQ(allocations_of([&] { return wgs84::position(place); }), 0U);
  EXPECT_EQ(allocations_of([&] { return earth::spherical(motion<Itrf>.position.vector()); }), 0U);
  EXPECT_EQ(allocations_of([&] { return wgs84::moving_up(motion<Itrf>); }), 0U);
  EXPECT_EQ(allocations_of([&] { return wgs84::limb(0.0 * si::metre, side, motion<Itrf>); }), 0U);
  EXPECT_EQ(allocations_of([&] { return east_north_up(from<Station>, place); }), 0U);
  EXPECT_EQ(allocations_of([&] { return look_angles(seen); }), 0U);
  EXPECT_EQ(allocations_of([&] { return displacement_at(of<Satellite>, relative_to<Station>, look); }), 0U);
}

TEST(Allocations, DirectionsAndOrbitsNeedNone) {
  constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986e14);
  const auto& state = motion<Gcrf>;
  const auto on_sky = right_ascension_declination(state.position);
  EXPECT_EQ(allocations_of([&] { return right_ascension_declination(state.position); }), 0U);
  EXPECT_EQ(allocations_of([&] { return direction_at(in<Gcrf>, on_sky); }), 0U);
  EXPECT_EQ(allocations_of([&] { return two_body(mu, state, 100.0 * si::second); }), 0U);
  EXPECT_EQ(allocations_of([&] { return keplerian_elements(mu, state); }), 0U);
  EXPECT_EQ(allocations_of([&] { return lvlh(from<Body>, state); }), 0U);
  EXPECT_EQ(allocations_of([&] { return perifocal(from<Body>, mu, state); }), 0U);
  EXPECT_EQ(allocations_of([&] {
              return pointing(align(unit_z(in<Body>), moving_direction(state)),
                              constrain(unit_x(in<Body>), moving_direction(state.velocity)));
            }),
            0U);
}

TEST(Allocations, InstantsNeedNone) {
  const auto now = Epoch::from_tt("2024-01-01T12:00:00");
  const auto day = from_until(now, convert<si::time>(24.0 * si::hour));
  const auto orientation = EarthOrientation::unobserved(day, 0.0 * si::second);
  const EarthMotion earth(orientation, day);
  const Ephemeris<sky::Moon> moon(day);
  EXPECT_EQ(allocations_of([&] { return orientation.at(now); }), 0U);
  EXPECT_EQ(allocations_of([&] { return earth.at(now); }), 0U);
  EXPECT_EQ(allocations_of([&] { return teme_from_itrf(now, earth); }), 0U);
  // An edge of a graph has a copy, which shares the rows.
  EXPECT_EQ(allocations_of([&] { return edge(orientation); }), 0U);
  EXPECT_EQ(allocations_of([&] { return edge(teme(orientation)); }), 0U);
  EXPECT_EQ(allocations_of([&] { return edge(teme(earth)); }), 0U);
  EXPECT_EQ(allocations_of([&] { return now.julian_date(scale::utc); }), 0U);
  EXPECT_EQ(allocations_of([&] { return geocentric(of<sky::Moon>, now); }), 0U);
  EXPECT_EQ(allocations_of([&] { return moon.direction(now, motion<Gcrf>, apparent); }), 0U);
}

// Near the Earth and in deep space, and the chain from an antenna to a station.
TEST(Allocations, ChainsOfTwoLineElementsNeedNone) {
  const auto near =
      TwoLineElements::parse("1 25544U 98067A   08264.51782528 -.00002182  00000-0 -11606-4 0  2927",
                             "2 25544  51.6416 247.4627 0006703 130.5360 325.0288 15.72125391563537")
          .mean_elements();
  MeanElements far = near;
  far.mean_motion = far.mean_motion / 7.8;
  far.eccentricity = 0.7;
  const auto day = from_until(near.epoch, convert<si::time>(24.0 * si::hour));
  const EarthMotion earth(EarthOrientation::unobserved(day, 0.0 * si::second), day);
  for (const MeanElements& elements : {near, far}) {
    const Sgp4<Satellite> orbit(elements, at_most(convert<si::time>(24.0 * si::hour)));
    const auto t = near.epoch + 5000.0 * si::second;
    EXPECT_EQ(allocations_of([&] { return orbit.at(t); }), 0U);
    EXPECT_EQ(allocations_of([&] { return orbit.path(t); }), 0U);
    const auto graph = frame_graph(
        edge(teme(earth)), edge(orbit), rigid_edge(east_north_up(from<Station>, place)),
        edge([](const Displacement<earth::Teme, Satellite, In<earth::Teme>>& r,
                const Velocity<earth::Teme, Satellite, ObservedFrom<earth::Teme>, In<earth::Teme>>& v) {
          return lvlh(from<Body>, r, v);
        }));
    EXPECT_EQ(
        allocations_of([&] { return graph.at(t).position(of<Station>, relative_to<Satellite>, in<Body>); }),
        0U);
  }
}

}  // namespace
}  // namespace vectrix::allocations_test
#endif
