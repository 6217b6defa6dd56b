#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <vectrix/dynamics/ode/radau_iia_7.hpp>
#include <vectrix/dynamics/ode/verner_7.hpp>
#include <vectrix/dynamics/ode/verner_9.hpp>
#include <vectrix/frames/scalar/larger.hpp>

// The figures of the Runge-Kutta tables against the conditions they solve.
namespace vectrix::ode::test::tables_test {
namespace {

template <class Table> class RungeKuttaTable : public testing::Test {};
using Tables = testing::Types<Verner9, Verner7>;
TYPED_TEST_SUITE(RungeKuttaTable, Tables);

/// Of a figure of size 1; the figures of stage 10 of Verner 7 reach 200.
constexpr double rounding = 3e-16;

/// A rooted tree: its order, its density gamma, and for each stage its elementary weight
///     Phi_i(tree) = prod over the branches of sum_j a_ij Phi_j(branch).
template <class Table> struct Tree {
  int order = 1;
  double density = 1.0;
  std::array<long double, Table::stages> weights;

  Tree() { weights.fill(1.0L); }

  /// With one more branch at the root. `order` is also the density's last factor.
  Tree grafted(const Tree& branch) const {
    Tree result = *this;
    result.order += branch.order;
    result.density *= branch.density * result.order / order;
    for (std::size_t i = 0; i < Table::stages; ++i) {
      long double sum = 0.0L;
      for (std::size_t j = 0; j < i; ++j) sum += Table::a[i][j] * branch.weights[j];
      result.weights[i] *= sum;
    }
    return result;
  }
};

/// All rooted trees up to an order: branches are added in the order of the list, so that each multiset of
/// branches comes once.
template <class Table> std::vector<Tree<Table>> trees_to_order(int order) {
  std::vector<Tree<Table>> trees{Tree<Table>()};
  std::vector<std::size_t> last_branch{0};
  for (int n = 2; n <= order; ++n) {
    const std::size_t end = trees.size();
    for (std::size_t trunk = 0; trunk < end; ++trunk) {
      for (std::size_t branch = last_branch[trunk]; branch < end; ++branch) {
        if (trees[trunk].order + trees[branch].order != n) continue;
        trees.push_back(trees[trunk].grafted(trees[branch]));
        last_branch.push_back(branch);
      }
    }
  }
  return trees;
}

/// The largest error of sum_i w_i Phi_i(tree) = 1 / gamma(tree) over the trees of one order.
template <class Table, class Weights>
double largest_error(const std::vector<Tree<Table>>& trees, int order, const Weights& weights) {
  double largest = 0.0;
  for (const auto& tree : trees) {
    if (tree.order != order) continue;
    const long double sum = std::inner_product(weights.begin(), weights.end(), tree.weights.begin(), 0.0L);
    largest = vectrix::detail::larger(largest, static_cast<double>(std::abs(sum - 1.0L / tree.density)));
  }
  return largest;
}

TYPED_TEST(RungeKuttaTable, rows_sum_to_their_abscissas) {
  for (std::size_t i = 0; i < TypeParam::all_stages; ++i) {
    if (i == TypeParam::stages) continue;  // the rate at the new state: its row is b
    double sum = 0.0, size = 1.0;
    for (const double a : TypeParam::a[i]) {
      sum += a;
      size += std::abs(a);
    }
    EXPECT_NEAR(sum, TypeParam::c[i], rounding * size) << "stage " << i + 1;
  }
}

/// One condition for each rooted tree: 486 for order 9.
TYPED_TEST(RungeKuttaTable, solves_all_conditions_of_its_orders_and_none_above) {
  constexpr std::array number_of_trees{1, 2, 4, 8, 17, 37, 85, 200, 486};  // up to the order
  const auto trees = trees_to_order<TypeParam>(TypeParam::order + 1);
  EXPECT_EQ(std::ranges::count_if(trees, [](const auto& tree) { return tree.order <= TypeParam::order; }),
            number_of_trees.at(TypeParam::order - 1));
  std::array<long double, TypeParam::stages> estimate;  // weights of the method of lower order
  for (std::size_t i = 0; i < TypeParam::stages; ++i)
    estimate.at(i) = static_cast<long double>(TypeParam::b[i]) - TypeParam::e[i];
  constexpr double rounded = 1e-14;  // some ten products of figures up to 50
  for (int order = 1; order <= TypeParam::order; ++order)
    EXPECT_LT(largest_error(trees, order, TypeParam::b), rounded) << order;
  for (int order = 1; order <= TypeParam::error_order; ++order)
    EXPECT_LT(largest_error(trees, order, estimate), rounded) << order;
  constexpr double felt = 1e-7;
  EXPECT_GT(largest_error(trees, TypeParam::order + 1, TypeParam::b), felt);
  EXPECT_GT(largest_error(trees, TypeParam::error_order + 1, estimate), felt);
}

/// The estimate is blind to no quadrature: a rate t^k of time alone has an error from k = error_order on.
TYPED_TEST(RungeKuttaTable, the_error_estimate_sees_a_quadrature) {
  double sum = 0.0;
  for (std::size_t i = 0; i < TypeParam::stages; ++i)
    sum += TypeParam::e[i] * std::pow(TypeParam::c[i], TypeParam::error_order);
  EXPECT_GT(std::abs(sum), 1e-6);
}

/// B(13), C(7) and D(6), from which order 13 follows: J. C. Butcher, Implicit Runge-Kutta processes, 1964.
///     sum_i b_i c_i^(k-1) = 1 / k,  sum_j a_ij c_j^(k-1) = c_i^k / k,
///     sum_i b_i c_i^(k-1) a_ij = b_j (1 - c_j^k) / k
TEST(RadauTable, solves_the_simplifying_conditions_of_order_13) {
  const RadauIIA7& table = RadauIIA7::table();
  constexpr std::size_t stages = RadauIIA7::stages;
  const auto& b = table.a.back();
  EXPECT_EQ(table.c.back(), 1.0);
  const auto quadrature = [&](int k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < stages; ++i) sum += b.at(i) * std::pow(table.c.at(i), k - 1);
    return sum - 1.0 / k;
  };
  for (int k = 1; k <= RadauIIA7::order; ++k) EXPECT_NEAR(quadrature(k), 0.0, rounding) << k;
  EXPECT_GT(std::abs(quadrature(RadauIIA7::order + 1)), 1e-8);
  for (int k = 1; k <= 7; ++k) {
    for (std::size_t i = 0; i < stages; ++i) {
      double row = 0.0, column = 0.0;
      for (std::size_t j = 0; j < stages; ++j) {
        row += table.a.at(i).at(j) * std::pow(table.c.at(j), k - 1);
        column += b.at(j) * std::pow(table.c.at(j), k - 1) * table.a.at(j).at(i);
      }
      EXPECT_NEAR(row, std::pow(table.c.at(i), k) / k, rounding);
      if (k == 7) continue;
      EXPECT_NEAR(column, b.at(i) * (1.0 - std::pow(table.c.at(i), k)) / k, rounding);
    }
  }
}

}  // namespace
}  // namespace vectrix::ode::test::tables_test
