#include "direction_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "testing/trials.hpp"

namespace vectrix::cli::direction_tree_test {
namespace {

using Eigen::Vector3d;

Vector3d direction(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

// By looking at each.
RC_GTEST_PROP(DirectionTree, FindsSumAndFarthestOfAnyStretch, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400);
  const auto size = *rc::gen::element(1e-9, 1e-3, 1.0, 10.0);
  const auto angle = [&] { return size * 1e-6 * *rc::gen::inRange(-300'000, 300'000); };
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(direction(angle(), angle()));
  DirectionTree tree(all);
  const auto first = *rc::gen::inRange<std::size_t>(0, count), last = *rc::gen::inRange(first, count);
  const Vector3d from = direction(angle(), angle());
  Vector3d sum = Vector3d::Zero();
  double largest = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    sum += all[i];
    largest = std::max(largest, (all[i] - from).norm());
  }
  constexpr double rounding = 1e-15;  // of one sum in two orders, for each of its terms
  RC_ASSERT((tree.sum(first, last) - sum).norm() <= rounding * static_cast<double>(count));
  const auto found = tree.farthest(from, first, last, -1.0);
  RC_ASSERT(found.has_value());
  RC_ASSERT(*found >= first);
  RC_ASSERT(*found <= last);
  constexpr double of_square_root = 4e-16;  // relative
  RC_ASSERT((all[*found] - from).norm() >= largest * (1.0 - of_square_root));
  RC_ASSERT(!tree.farthest(from, first, last, largest * (1.0 + of_square_root)).has_value());
}

// A spin about an axis that leans, seen as a circle: all directions are as far from the axis. Windows of half
// of them, with their means; what is looked at in a window.
double looks_in_a_spin(std::size_t count, double samples_in_a_turn) {
  const Eigen::Matrix3d lean =
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < count; ++i)
    all.emplace_back(lean *
                     direction(2.0 * std::numbers::pi * static_cast<double>(i) / samples_in_a_turn, 1.1));
  DirectionTree tree(all);
  const std::size_t window = count / 2;
  for (std::size_t first = 0; first + window < count; ++first) {
    const Vector3d mean = tree.sum(first, first + window).normalized();
    const auto found = tree.farthest(mean, first, first + window, -1.0);
    if (first % (count / 40) != 0) continue;
    double largest = 0.0;
    for (std::size_t i = first; i <= first + window; ++i) largest = std::max(largest, (all[i] - mean).norm());
    constexpr double rounding = 2e-15;  // of the unit vectors
    EXPECT_NEAR((all[found.value()] - mean).norm(), largest, rounding) << count << ' ' << first;
  }
  return static_cast<double>(tree.looks()) / static_cast<double>(count - window);
}

TEST(DirectionTree, LooksAtFewDirectionsOfASpin) {
  for (const double samples_in_a_turn : {60.0, 61.7, 997.3}) {
    constexpr std::size_t count = vectrix_test::trials(4000);
    const double few = looks_in_a_spin(count, samples_in_a_turn),
                 many = looks_in_a_spin(8 * count, samples_in_a_turn);
    // Of the order of log^2 n; looking at each takes eight times as many.
    EXPECT_LE(many, 3.0 * few) << samples_in_a_turn;
  }
}

}  // namespace
}  // namespace vectrix::cli::direction_tree_test
