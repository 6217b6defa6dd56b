// Screws, Jacobians and rates in float and double, compared with long double.
#include <gtest/gtest.h>

#include "rigid_lists.hpp"

namespace vectrix_test::rigid_scalars_test {
namespace {

template <class S> void expect_what_long_double_gives() {
  std::mt19937_64 random(20260401);
  for (int i = 0; i < instances; ++i) {
    const auto numbers = numbers_of(random);
    const auto given = converted<S>(numbers, [](double x) { return static_cast<S>(x); });
    const auto exact = converted<long double>(numbers, [](double x) { return static_cast<long double>(x); });
    expect_all_near(rigid_motions(given), rigid_motions(exact),
                    few_thousand * static_cast<double>(Eigen::NumTraits<S>::epsilon()));
  }
}

TEST(RigidMotions, InFloatAndDoubleAreThoseOfLongDouble) {
  expect_what_long_double_gives<float>();
  expect_what_long_double_gives<double>();
}

}  // namespace
}  // namespace vectrix_test::rigid_scalars_test
