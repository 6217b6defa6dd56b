/// A typed craft compared with the same tree of raw numbers, and lanes with double. Prints rows of
/// docs/evidence/performance.md: typed_crafts v3. Fails if a pair disagrees.
#include <array>
#include <cmath>
#include <cstdio>
#include <experimental/simd>
#include <memory>
#include <random>
#include <vector>
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/multibody/any_scalar.hpp>
#include <vectrix/dynamics/multibody/converted.hpp>
#include <vectrix/frames/scalar/lanes.hpp>

#include "bursts.hpp"

namespace bench {
namespace {

using namespace vectrix;
using Lanes = std::experimental::native_simd<double>;

struct I : inertial_frame {};
struct Hub : moving_frame {};
template <int K> struct Panel : moving_frame {};

constexpr auto m = si::metre;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr double stiffness = 3.0, damping = 0.05;

template <class B> auto mass(double kilograms, const Eigen::Vector3d& c, const Eigen::Vector3d& J) {
  return mass_properties(
      kilograms * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>, vector(in<B>, c.x() * m, c.y() * m, c.z() * m)),
      inertia_from_principal_moments(in<B>, J.x() * kg_m2, J.y() * kg_m2, J.z() * kg_m2));
}
/// On the hub, or the panel before it.
template <int K, class Parent> auto panel(const Eigen::Vector3d& r) {
  using P = Panel<K>;
  return body(mass<P>(3.0, {0.2, -0.3, 0.1}, {0.5, 0.6, 0.8}),
              hinge(Transform{turned_x(to<Parent>, from<P>, 0.3 * K * si::radian),
                              displacement(of<P>, relative_to<Parent>,
                                           vector(in<Parent>, r.x() * m, r.y() * m, r.z() * m))},
                    unit_y(in<P>)));
}
auto hub() {
  return body(mass<Hub>(300.0, {0.1, 0.0, -0.1}, {100.0, 110.0, 120.0}), free_in<I>);
}

/// So many random states, each with its quaternion of unit norm.
std::vector<std::vector<double>> states(std::size_t size) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> all(inputs, std::vector<double>(size));
  for (auto& y : all) {
    for (double& number : y) number = normal(random);
    const double norm = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
    for (std::size_t i = 0; i < 4; ++i) y[i] /= norm;
  }
  return all;
}
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0, size = 1.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = vectrix::detail::larger(largest, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return largest / size;
}

/// The right-hand side of a tree with a spring and a damper on each hinge, in raw numbers.
template <class S> class TreeRates {
 public:
  explicit TreeRates(const multibody::Tree<S>& tree) : tree_(tree), work_(tree_.work()) {}
  void operator()(const S* y, S* ydot) {
    tree_.place(y, work_);
    const auto& layout = tree_.layout();
    for (std::size_t i = 0; i < layout.speeds; ++i)
      work_.efforts[i] = -stiffness * y[layout.hub + i] - damping * y[layout.speeds_begin() + i];
    tree_.solve(y, ydot, work_);
  }

 private:
  multibody::Tree<S> tree_;
  multibody::Work<S> work_;
};

/// The rows of a craft whose bodies hang on hinges: typed over raw numbers, and lanes over double, for as
/// many systems as there are lanes.
template <class C, class... Loads>
void add(const std::string& name, const C& craft, std::vector<Row>& rows, const Loads&... loads) {
  constexpr double typed_target = 1.03, lanes_target = Lanes::size() == 4 ? 1.0 / 3.0 : 0.0;
  constexpr double rounding = 1e-11;  // relative to the largest rate: two orders of the same sums
  constexpr std::size_t lanes = Lanes::size();
  struct Held {
    detail::CraftRates<C, Loads...> typed;
    TreeRates<double> raw;
    TreeRates<Lanes> in_lanes;
    std::vector<std::vector<double>> y;
    std::vector<std::vector<Lanes>> packed;
    std::vector<double> typed_rates, raw_rates;
    std::vector<Lanes> lanes_rates;
  };
  const auto y = states(C::state_size);
  std::vector<std::vector<Lanes>> packed(inputs, std::vector<Lanes>(C::state_size));
  for (std::size_t i = 0; i < inputs; ++i)
    for (std::size_t k = 0; k < C::state_size; ++k)
      packed[i][k] = Lanes([&](auto lane) { return y[(i + lane) % inputs][k]; });
  const std::vector<double> numbers(C::state_size);
  const auto held = std::make_shared<Held>(Held{
      detail::CraftRates<C, Loads...>(craft, loads...), TreeRates<double>(craft.core()->tree),
      TreeRates<Lanes>(multibody::Tree<Lanes>(multibody::converted<Lanes>(craft.core()->tree.numbers()))), y,
      packed, numbers, numbers, std::vector<Lanes>(C::state_size)});
  const auto typed = [held](std::size_t i) { held->typed(0.0, held->y[i].data(), held->typed_rates.data()); };
  const auto raw = [held](std::size_t i) { held->raw(held->y[i].data(), held->raw_rates.data()); };
  const auto in_lanes = [held](std::size_t i) {
    held->in_lanes(held->packed[i].data(), held->lanes_rates.data());
  };
  rows.push_back({{name + ", typed", typed},
                  {"raw numbers", raw},
                  typed_target,
                  [held, typed, raw] {
                    return largest_over_inputs([&](std::size_t i) {
                      typed(i), raw(i);
                      return apart(held->typed_rates, held->raw_rates);
                    });
                  },
                  rounding});
  rows.push_back({{name + ", " + std::to_string(lanes) + " systems in lanes", in_lanes},
                  {"the same in double",
                   [raw](std::size_t i) {
                     for (std::size_t lane = 0; lane < lanes; ++lane) raw((i + lane) % inputs);
                   }},
                  lanes_target,
                  [held, raw, in_lanes] {
                    return largest_over_inputs([&](std::size_t i) {
                      in_lanes(i);
                      double largest = 0.0;
                      for (std::size_t lane = 0; lane < lanes; ++lane) {
                        raw((i + lane) % inputs);
                        std::vector<double> one;
                        for (const Lanes& rate : held->lanes_rates) one.push_back(rate[lane]);
                        largest = vectrix::detail::larger(largest, apart(one, held->raw_rates));
                      }
                      return largest;
                    });
                  },
                  rounding});
}

template <class C, class... B>
void add_sprung(const std::string& name, const C& craft, std::vector<Row>& rows, Of<B>...) {
  const auto k = stiffness * (si::newton_metre / si::radian);
  const auto c = damping * (si::newton_metre / (si::radian / si::second));
  add(name, craft, rows, spring(craft, of<B>, k, 0.0 * si::radian)..., damper(craft, of<B>, c)...);
}

int run(const char* build) {
  const Eigen::Vector3d out(0.0, 1.0, 0.2);
  const auto panels = spacecraft(hub(), panel<1, Hub>(out), panel<2, Hub>(-out));
  const auto chain = spacecraft(hub(), panel<1, Hub>(out), panel<2, Panel<1>>(out), panel<3, Panel<2>>(out),
                                panel<4, Panel<3>>(out), panel<5, Panel<4>>(out));
  std::vector<Row> rows;
  add_sprung(std::string(build) + ": hub and 2 panels", panels, rows, of<Panel<1>>, of<Panel<2>>);
  add_sprung(std::string(build) + ": hub and chain of 5", chain, rows, of<Panel<1>>, of<Panel<2>>,
             of<Panel<3>>, of<Panel<4>>, of<Panel<5>>);
  for (const Row& row : rows) {
    if (!(row.difference() <= row.allowed)) {
      std::fprintf(stderr, "typed_crafts: %s and %s differ by %g\n", row.ours.name.c_str(),
                   row.peer.name.c_str(), row.difference());
      return 1;
    }
  }
  measure(rows);
  print(rows);
  return 0;
}

}  // namespace
}  // namespace bench

int main(int, char** argv) {
  return bench::run(argv[1]);
}
