// Screws, Jacobians and rates with automatic derivatives, compared with differences in long double.
#include <gtest/gtest.h>

#include "rigid_lists.hpp"
#include "testing/motions.hpp"

namespace vectrix_test::rigid_derivatives_test {
namespace {

TEST(RigidMotions, TheirAutomaticDerivativesAreThoseOfDifferences) {
  // The error of a central difference in long double: h^2 times a third derivative of order 1e4, and 1e-19/h.
  constexpr long double h = 1e-6L;
  constexpr double difference_tolerance = 1e-7;
  std::mt19937_64 random(20260402);
  for (int i = 0; i < instances; ++i) {
    const auto numbers = numbers_of(random);
    const auto moved_by = [&]<class S>(const S& s) {
      int n = 0;
      return converted<S>(numbers, [&](double x) { return S(S(x) + s * S(std::sin(++n))); });
    };
    const auto found = rigid_motions(moved_by(Dual(0.0, 1, 0)));
    const auto ahead = rigid_motions(moved_by(h));
    const auto behind = rigid_motions(moved_by(-h));
    std::vector<double> derivatives;
    std::vector<long double> slopes;
    for (std::size_t k = 0; k < found.size(); ++k) {
      derivatives.push_back(found[k].derivatives()(0));
      slopes.push_back((ahead[k] - behind[k]) / (2 * h));
    }
    expect_all_near(derivatives, slopes, difference_tolerance);
  }
}

}  // namespace
}  // namespace vectrix_test::rigid_derivatives_test
