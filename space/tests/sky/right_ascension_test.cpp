#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/space/earth/teme.hpp>
#include <vectrix/space/sky/right_ascension.hpp>

#include "temporary_file.hpp"

namespace vectrix::right_ascension_test {
namespace {

using earth::Gcrf;

struct Satellite : moving_frame {};

constexpr double pi = std::numbers::pi;
constexpr double angle_rounding = 1e-15;  // rad, of angles up to 2 pi
constexpr double rounding = 1e-15;        // of a unit vector's coordinates

template <class A>
concept HasPlace = requires(const Vector<A, si::dimensionless>& n) {
  { right_ascension_declination(n) } -> std::same_as<RightAscensionDeclination>;
};
static_assert(HasPlace<Gcrf> && HasPlace<earth::TrueOfDate> && HasPlace<earth::Teme>);
static_assert(!HasPlace<earth::Itrf> && !HasPlace<Satellite>);

RightAscensionDeclination place(double x, double y, double z) {
  return right_ascension_declination(vector<si::dimensionless>(in<Gcrf>, Eigen::Vector3d(x, y, z)));
}

TEST(RightAscension, OnTheAxes) {
  const auto expect = [](const RightAscensionDeclination& found, double right_ascension, double declination) {
    EXPECT_EQ(found.right_ascension.value(), right_ascension);
    EXPECT_EQ(found.declination.value(), declination);
  };
  expect(place(1, 0, 0), 0.0, 0.0);
  expect(place(0, 1, 0), pi / 2, 0.0);
  expect(place(-1, 0, 0), pi, 0.0);
  expect(place(0, -1, 0), 3 * pi / 2, 0.0);
  expect(place(0, 0, 2), 0.0, pi / 2);
  expect(place(-0.0, -0.0, -2), 0.0, -pi / 2);
  expect(place(1, -1e-300, 0), 0.0, 0.0);
  expect(place(1e200, 1e200, 0), pi / 4, 0.0);
}

// The Crab pulsar: 5 h 34 min 31.97 s, 22 deg 0' 52.1", and its direction by products of cosines.
TEST(RightAscension, OfAStarAndBack) {
  const double ra = 83.6332083 * pi / 180, dec = 22.0144722 * pi / 180;
  const auto n = direction_at(in<Gcrf>, {ra * si::radian, dec * si::radian});
  EXPECT_NEAR(n.coordinates().norm(), 1.0, rounding);
  EXPECT_NEAR(n.coordinates().y() / n.coordinates().x(), std::tan(ra), 10 * 9 * rounding);  // tan is 9
  EXPECT_NEAR(n.coordinates().z(), std::sin(dec), rounding);
  const auto found = right_ascension_declination(n);
  EXPECT_NEAR(found.right_ascension.value(), ra, angle_rounding);
  EXPECT_NEAR(found.declination.value(), dec, angle_rounding);
}

TEST(RightAscension, AndBack) {
  std::mt19937_64 random(20261204);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d n = Eigen::Vector3d(number(random), number(random), number(random)).normalized();
    const auto found = right_ascension_declination(displacement(
        of<Satellite>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(7e6 * n))));
    EXPECT_GE(found.right_ascension.value(), 0.0);
    EXPECT_LT(found.right_ascension.value(), 2 * pi);
    EXPECT_LE((direction_at(in<Gcrf>, found).coordinates() - n).norm(), 2 * rounding);
  }
}

TEST(RightAscension, RefusesBadInput) {
  EXPECT_EQ(complaint([] { place(0, 0, -0.0); }),
            "right_ascension_declination(in " + frame_name<Gcrf>() + "): a zero vector has no direction");
  const auto star = [](double ra, double dec) {
    return direction_at(in<Gcrf>, {ra * si::radian, dec * si::radian});
  };
  EXPECT_EQ(complaint([&] { star(1.0, -1.6); }),
            "direction_at(in<" + frame_name<Gcrf>() + ">): the declination -1.6 rad is not in [-pi/2, pi/2]");
  for (const double most : {pi / 2, -pi / 2}) {
    EXPECT_NO_THROW(star(1.0, most));
    EXPECT_THROW(star(1.0, std::nextafter(most, 2 * most)), BadInput);
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(star(nan, 0.0), BadInput);
  EXPECT_THROW(star(0.0, nan), BadInput);
}

}  // namespace
}  // namespace vectrix::right_ascension_test
