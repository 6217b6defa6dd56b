#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

// A quantity has the size of its numbers.
using namespace vectrix;
using namespace vectrix_test;

namespace size_test {
namespace {

template <class Quantity> inline constexpr std::size_t numbers = sizeof(Quantity) / sizeof(double);

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

}  // namespace
}  // namespace size_test
