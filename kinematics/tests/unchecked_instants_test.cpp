#include <gtest/gtest.h>

#include <vectrix/kinematics.hpp>

#include "../../frames/tests/attitudes.hpp"

// Without VECTRIX_CHECK_INSTANTS a quantity is its numbers, and nothing is asked of its instant.
using namespace vectrix;
using namespace vectrix_test;

#ifndef VECTRIX_CHECK_INSTANTS

namespace {

template <class Quantity> inline constexpr std::size_t numbers = sizeof(Quantity) / sizeof(double);

static_assert(std::is_empty_v<detail::Stamped> && std::is_empty_v<detail::Trusted>);
static_assert(numbers<Vector<Body, si::length>> == 3);
static_assert(numbers<Dcm<Gcrf, Body>> == 9);
static_assert(numbers<Quaternion<Gcrf, Body>> == 4);
static_assert(numbers<DcmRate<Gcrf, Body>> == 9);
static_assert(numbers<QuaternionRate<Gcrf, Body>> == 4);
static_assert(numbers<RotationVector<Gcrf, Body>> == 3);
static_assert(numbers<Displacement<Gcrf, Body, In<Body>>> == 3);
static_assert(numbers<Velocity<Gcrf, Body, ObservedFrom<Gcrf>, In<Body>>> == 3);
static_assert(numbers<Acceleration<Gcrf, Body, ObservedFrom<Gcrf>, In<Body>>> == 3);
static_assert(numbers<AngularVelocity<Gcrf, Body, In<Body>>> == 3);
static_assert(numbers<AngularAcceleration<Gcrf, Body, In<Body>>> == 3);
static_assert(numbers<Twist<Gcrf, Body, At<Body>, In<Body>>> == 6);
static_assert(numbers<Transform<Gcrf, Body>> == 9 + 3);
static_assert(numbers<MovingDcm<Gcrf, Body>> == 9 + 3);
static_assert(numbers<AcceleratingDcm<Gcrf, Body>> == 9 + 3 + 3);
static_assert(numbers<MovingTransform<Gcrf, Body>> == 9 + 3 + 3 + 3);
static_assert(numbers<AcceleratingTransform<Gcrf, Body>> == 9 + 5 * 3);

TEST(UncheckedInstants, GoTogether) {
  const auto turning = frame_graph(
      edge([](double t) { return turned_z(to<Gcrf>, from<Body>, Quantity<si::angle>::from_value(t)); }));
  const auto R_i_from_b = [&](double t) { return turning.at(t).rotation(to<Gcrf>, from<Body>); };
  const auto turned = inverse(R_i_from_b(1.0)) * (R_i_from_b(1.5) * unit_x(in<Body>));
  EXPECT_EQ(turned.x().value(),
            (inverse(without_instant(R_i_from_b(1.0))) * (R_i_from_b(1.5) * unit_x(in<Body>))).x().value());
}

}  // namespace

#endif
