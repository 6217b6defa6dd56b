#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <unsupported/Eigen/AutoDiff>
#include <vectrix/dynamics/multibody/any_scalar.hpp>
#include <vectrix/frames/scalar/lanes.hpp>

#include "random_craft.hpp"
#include "testing/trials.hpp"

// The engine in any scalar: values against long double, derivatives against differences of long double, lanes
// against doubles.
namespace vectrix_test::any_scalar_test {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using Lanes = std::experimental::native_simd<double>;

/// Ten bodies on each other lose at most four digits, by the condition of their joints.
constexpr double roundings = 1e4;
constexpr long double step = 1e-5L;

template <class S> std::vector<S> rates(const DescribedCraft& craft, const std::vector<S>& y) {
  const mb::Tree<S> tree(lowered<S>(craft, mb::HubMotion::free).numbers);
  auto k = tree.work();
  std::vector<S> ydot(y.size());
  tree.place(y.data(), k);
  tree.add_wrench(0, {S(0.3), S(-0.2), S(0.1)}, {S(0.1), S(0.2), S(0.4)}, k);
  tree.solve(y.data(), ydot.data(), k);
  const auto energy = tree.conserved(y.data(), mb::zero_column<S>(), k).energy;
  ydot.push_back(energy);
  return ydot;
}

struct Drawn {
  DescribedCraft craft;
  std::vector<double> y;
  explicit Drawn(RandomCraft& random) : craft(random.craft(random.below(10))) {
    y = random.state(mb::Tree<double>(lowered<double>(craft, mb::HubMotion::free).numbers));
  }
  template <class S> std::vector<S> state() const { return {y.begin(), y.end()}; }
};
template <class Numbers> double largest(const Numbers& numbers) {
  double scale = 1.0;
  for (const auto& number : numbers) scale = std::max(scale, std::abs(static_cast<double>(number)));
  return scale;
}

TEST(TreeOfAnyScalar, FloatsGiveWhatLongDoubleGives) {
  RandomCraft random(20260330);
  for (int trial = 0; trial < trials(50); ++trial) {
    const Drawn drawn(random);
    const auto check = [&](const auto& found, const auto& exact, double epsilon) {
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(static_cast<double>(found[i]), static_cast<double>(exact[i]),
                    roundings * epsilon * largest(exact));
    };
    std::vector<float> single;
    std::vector<long double> rounded;
    for (const double number : drawn.y) single.push_back(static_cast<float>(number));
    rounded.assign(single.begin(), single.end());
    check(rates(drawn.craft, single), rates(drawn.craft, rounded), std::numeric_limits<float>::epsilon());
    check(rates(drawn.craft, drawn.y), rates(drawn.craft, drawn.state<long double>()),
          std::numeric_limits<double>::epsilon());
  }
}

TEST(TreeOfAnyScalar, AutomaticDerivativesAreThoseOfDifferences) {
  RandomCraft random(20260331);
  for (int trial = 0; trial < trials(50); ++trial) {
    const Drawn drawn(random);
    std::vector<Dual> dual;
    std::vector<double> along;
    for (const double number : drawn.y) {
      along.push_back(random.normal());
      dual.emplace_back(number, Eigen::Matrix<double, 1, 1>(along.back()));
    }
    const auto moved = [&](long double h) {
      auto y = drawn.state<long double>();
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * along[i];
      return rates(drawn.craft, y);
    };
    const auto difference = [&](long double h) {
      const auto low = moved(-h), high = moved(h);
      std::vector<double> list;
      for (std::size_t i = 0; i < low.size(); ++i)
        list.push_back(static_cast<double>((high[i] - low[i]) / (2 * h)));
      return list;
    };
    const auto found = rates(drawn.craft, dual);
    // A central difference is off by the square of its step: two of them show how much. What is then left
    // goes with the fourth power, a hundredth of that while the steps are small.
    const auto coarse = difference(2 * step), fine = difference(step);
    std::vector<double> error;
    for (std::size_t i = 0; i < found.size(); ++i) error.push_back((coarse[i] - fine[i]) / 3.0);
    const auto [least, most] = std::minmax_element(error.begin(), error.end());
    const double rounding_of_difference =
        static_cast<double>(std::numeric_limits<long double>::epsilon() / step) * largest(moved(0.0L));
    const double rounded =
        roundings * (std::numeric_limits<double>::epsilon() * largest(fine) + rounding_of_difference);
    const double tolerance = 0.01 * std::max(-*least, *most) + rounded;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].derivatives()[0], fine[i] - error[i], tolerance);
  }
}

TEST(TreeOfAnyScalar, EachLaneIsThatOfADouble) {
  RandomCraft random(20260332);
  for (int trial = 0; trial < trials(20); ++trial) {
    const Drawn drawn(random);
    std::vector<std::vector<double>> one(Lanes::size(), drawn.y);
    for (auto& y : one)
      for (double& number : y) number += 0.1 * random.normal();
    std::vector<Lanes> y;
    for (std::size_t i = 0; i < drawn.y.size(); ++i) y.emplace_back([&](auto lane) { return one[lane][i]; });
    const auto found = rates(drawn.craft, y);
    for (std::size_t lane = 0; lane < Lanes::size(); ++lane) {
      const auto wanted = rates(drawn.craft, one[lane]);
      for (std::size_t i = 0; i < wanted.size(); ++i)
        EXPECT_NEAR(double(found[i][lane]), wanted[i],
                    roundings * std::numeric_limits<double>::epsilon() * largest(wanted));
    }
  }
}

}  // namespace
}  // namespace vectrix_test::any_scalar_test
