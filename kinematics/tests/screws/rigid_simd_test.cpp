// Screws, Jacobians and rates in batches: each lane gives the result of a double.
#include <gtest/gtest.h>

#include <vectrix/frames/scalar/lanes.hpp>

#include "rigid_lists.hpp"

namespace vectrix_test::rigid_simd_test {
namespace {

TEST(RigidMotions, EachLaneOfABatchIsThatOfADouble) {
  using S = std::experimental::native_simd<double>;
  // Sine and cosine may round differently, and the next operations amplify the difference.
  constexpr double lane_tolerance = few_thousand * epsilon;
  std::mt19937_64 random(20260403);
  for (int i = 0; i < instances; ++i) {
    std::vector<Given<double>> lanes;
    for (std::size_t lane = 0; lane < S::size(); ++lane) lanes.push_back(numbers_of(random));
    const auto found = rigid_motions(batch_of<S>(lanes));
    for (std::size_t lane = 0; lane < S::size(); ++lane) {
      std::vector<double> alone;
      for (const S& number : found) alone.push_back(number[lane]);
      expect_all_near(alone, rigid_motions(lanes[lane]), lane_tolerance);
    }
  }
}

TEST(RigidMotions, ABatchWithOneLaneAtAFullTurnIsBadInput) {
  using S = std::experimental::native_simd<double>;
  S angle(1.0);
  angle[S::size() - 1] = 2 * std::numbers::pi;
  const auto theta = rotation_vector(of<Body>, relative_to<Gcrf>,
                                     vector<si::angle>(in<Gcrf>, detail::Column<S>(angle, S(0.0), S(0.0))));
  EXPECT_TRUE(contains(message<BadInput>([&] { inverse_left_jacobian(theta); }), "a full turn"));
  EXPECT_TRUE(contains(
      message<BadInput>([&] { rate(theta, rate_of<Gcrf, Body>(detail::Column<S>(angle, angle, angle))); }),
      "a full turn"));
}

}  // namespace
}  // namespace vectrix_test::rigid_simd_test
