#include <gtest/gtest.h>

#include <vectrix/frames/scalar/lanes.hpp>

#include "testing/any_scalar.hpp"

// Batches in which one lane uses the series and another the closed form: each must equal the result for a
// double.
namespace vectrix_test::lane_mix_test {
namespace {

/// As in simd_test.cpp: the same operations; sines may round differently, amplified some hundred times.
constexpr double lane_tolerance = 512 * epsilon;

template <class S> struct LaneMix : testing::Test {};
#ifdef __clang__  // see batches.hpp
using WideBatches = testing::Types<std::experimental::native_simd<double>>;
#else
using WideBatches =
    testing::Types<std::experimental::native_simd<double>, std::experimental::fixed_size_simd<double, 3>,
                   std::experimental::fixed_size_simd<double, 8>>;
#endif
TYPED_TEST_SUITE(LaneMix, WideBatches);

template <class S> detail::Column<S> each_other(const double* sizes, std::size_t first) {
  const S size([&](auto lane) { return sizes[(first + lane) % 6]; });
  return {size, S(2.0) * size, S(-1.0) * size};
}
template <class S> RotationVector<Gcrf, Body, S> turn(const detail::Column<S>& theta) {
  return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
}

TYPED_TEST(LaneMix, TheSeriesAndTheClosedFormDoNotMeet) {
  using S = TypeParam;
  const double sizes[] = {0.0, 0.5, 1e-200, 1.2, 1e-6, 2.1};
  for (std::size_t first = 0; first < 6; ++first) {
    const auto theta = each_other<S>(sizes, first);
    const auto q = exp_quaternion(turn(theta));
    const auto again = log(q);
    const auto jacobian = left_jacobian(turn(theta));
    for (std::size_t lane = 0; lane < S::size(); ++lane) {
      const detail::Column<double> one = detail::lane(theta, lane);
      const auto q_alone = exp_quaternion(turn(one));
      const auto check = [&](const auto& found, const auto& wanted) {
        EXPECT_LE((found - wanted).norm(), lane_tolerance) << one.transpose() << ", lane " << lane;
      };
      check(detail::lane(q.eigen().coeffs(), lane), q_alone.eigen().coeffs());
      check(detail::lane(again.coordinates(), lane), log(q_alone).coordinates());
      check(detail::lane(jacobian, lane), left_jacobian(turn(one)));
    }
  }
}

TYPED_TEST(LaneMix, CovariancesAreThoseOfDoubles) {
  using S = TypeParam;
  const double sizes[] = {1.0, 2.0, 0.5, 4.0, 3.0, 0.25};
  const auto r = each_other<S>(sizes, 0);
  detail::Square<S> P = detail::Square<S>::Identity();
  P(0, 1) = P(1, 0) = S(0.5);
  const auto length = [](const auto& x) { return vector<si::length>(in<Gcrf>, x); };
  const auto P_a = covariance<si::length>(in<Gcrf>, P);
  const S distance = mahalanobis_distance(P_a, length(r)).value();
  const S variance = variance_along(P_a, unit_x<Gcrf, S>(in<Gcrf>)).value();
  for (std::size_t lane = 0; lane < S::size(); ++lane) {
    const auto alone = covariance<si::length>(in<Gcrf>, detail::lane(P, lane));
    EXPECT_EQ(double(distance[lane]),
              mahalanobis_distance(alone, length(detail::Column<double>(detail::lane(r, lane)))).value());
    EXPECT_EQ(double(variance[lane]), 1.0);
  }
  P(0, 1)[S::size() - 1] = 0.4;
  EXPECT_TRUE(contains(message<BadInput>([&] { covariance<si::length>(in<Gcrf>, P); }), "not symmetric"));
  const auto deviation = [](const S& x) { return Quantity<si::length, S>::from_value(x); };
  EXPECT_EQ(double(covariance_from_standard_deviations(in<Gcrf>, deviation(S(2.0)), deviation(S(1.0)),
                                                       deviation(S(3.0)))
                       .matrix()(0, 0)[S::size() - 1]),
            4.0);
  S spoilt(1.0);
  spoilt[S::size() - 1] = -1.0;
  EXPECT_TRUE(contains(message<BadInput>([&] {
                         covariance_from_standard_deviations(in<Gcrf>, deviation(spoilt), deviation(S(1.0)),
                                                             deviation(S(1.0)));
                       }),
                       "(-1, 1, 1) are not all zero"));
}

}  // namespace
}  // namespace vectrix_test::lane_mix_test
