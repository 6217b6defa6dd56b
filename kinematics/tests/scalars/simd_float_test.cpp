#include <gtest/gtest.h>

#include <vectrix/frames/scalar/lanes.hpp>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

// Several attitudes at once in floats: each lane gives the result of a float.
using namespace vectrix;
using namespace vectrix_test;

namespace simd_float_test {
namespace {

using Lanes = std::experimental::native_simd<float>;

/// A rotation, its logarithm and back: some hundred roundings of a float.
constexpr float float_tolerance = 100 * std::numeric_limits<float>::epsilon();

template <class S> Vector<Body, si::length, S> turned(const S& x) {
  const auto R_b_from_i = turned_z(to<Body>, from<Gcrf>, Quantity<si::angle, S>::from_value(x));
  const auto q_b_from_i = quaternion(dcm(to<Body>, from<Gcrf>, R_b_from_i.matrix()));
  return exp(log(q_b_from_i)) * vector<si::length>(in<Gcrf>, Eigen::Matrix<S, 3, 1>(x, x + S(1), x));
}

TEST(SimdFloat, GivesInEachLaneWhatAFloatGives) {
  const Lanes x([](auto i) { return 0.3f * static_cast<float>(i + 1) - 0.8f; });
  const auto r_b = turned(x);
  for (std::size_t i = 0; i < Lanes::size(); ++i) {
    const auto one_b = turned(float(x[i]));
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(float(r_b.coordinates()(k)[i]), one_b.coordinates()(k), float_tolerance) << i << ", " << k;
    }
  }
}

// Doors and parametrisations do not require that a scalar is double.
TEST(SimdFloat, GoesThroughEveryParametrisation) {
  const detail::Column<Lanes> x(Lanes(0.3f), Lanes(-0.2f), Lanes(0.5f));
  const auto theta = rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, x));
  const auto R = exp(theta);
  const auto expect_near = [](const detail::Square<Lanes>& found, const detail::Square<Lanes>& wanted) {
    for (Eigen::Index k = 0; k < 9; ++k) {
      for (std::size_t i = 0; i < Lanes::size(); ++i)
        EXPECT_NEAR(float(found(k)[i]), float(wanted(k)[i]), float_tolerance) << k << ", lane " << i;
    }
  };
  expect_near(dcm(euler_angles(intrinsic<3, 2, 1>, R)).matrix(), R.matrix());
  expect_near(dcm(gibbs_vector(quaternion(R))).matrix(), R.matrix());
  expect_near(dcm(modified_rodrigues(R)).matrix(), R.matrix());
  expect_near(dcm(axis_angle(R)).matrix(), R.matrix());
  expect_near(left_jacobian(theta) * inverse_left_jacobian(theta), detail::Square<Lanes>::Identity());
}

TEST(SimdFloat, IsRefusedForOneBadLane) {
  Lanes one(1.0f);
  one[Lanes::size() - 1] = 1.01f;
  detail::Square<Lanes> matrix = detail::Square<Lanes>::Identity();
  matrix(1, 1) = one;
  EXPECT_THROW(dcm(to<Body>, from<Gcrf>, matrix), BadInput);
  EXPECT_NEAR(float(nearest_dcm(to<Body>, from<Gcrf>, matrix).distance[Lanes::size() - 1]), 0.01f,
              float_tolerance);
}

}  // namespace
}  // namespace simd_float_test
