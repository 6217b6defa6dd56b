#include "direction_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

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
  const DirectionTree tree(all);
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

}  // namespace
}  // namespace vectrix::cli::direction_tree_test
