#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <vectrix/dynamics/ode/inlined.hpp>
#include <vectrix/frames/errors.hpp>

#include "problems.hpp"
#include "testing/free_body.hpp"
#include "testing/trials.hpp"

// The inlined integrators, alone.
namespace vectrix::ode::test::runge_kutta_test {
namespace {

template <class Table> class InlinedRungeKutta : public testing::Test {};
using Tables = testing::Types<Verner9, Verner7>;
TYPED_TEST_SUITE(InlinedRungeKutta, Tables);

constexpr double accepts_all = 1e9;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

constexpr double tolerance = 1e-9;
constexpr double of_step = 3.0 * tolerance;  // tolerance (1 + |y|), |y| below 2

/// Kepler's ellipse, mu = a = 1, from the pericentre; the rate is not linear, and no component is simple.
constexpr double eccentricity = 0.3;

struct Ellipse {
  void operator()(double, std::span<const double, 4> y, std::span<double, 4> ydot) const {
    const double r = std::hypot(y[0], y[1]), r3 = r * r * r;
    ydot[0] = y[2];
    ydot[1] = y[3];
    ydot[2] = -y[0] / r3;
    ydot[3] = -y[1] / r3;
  }
  static std::array<double, 4> at(double t) {
    const double e = eccentricity;
    double anomaly = t;
    for (int i = 0; i < 20; ++i)
      anomaly -= (anomaly - e * std::sin(anomaly) - t) / (1.0 - e * std::cos(anomaly));
    const double b = std::sqrt(1.0 - e * e), r = 1.0 - e * std::cos(anomaly);
    return {std::cos(anomaly) - e, b * std::sin(anomaly), -std::sin(anomaly) / r, b * std::cos(anomaly) / r};
  }
};

template <class Table> using EllipseMethod = RungeKutta<Table, 4, Ellipse>;

template <class Table> EllipseMethod<Table> ellipse(double of_all) {
  std::array<double, 4> absolute;
  absolute.fill(of_all);
  return {Ellipse(), of_all, absolute};
}

TYPED_TEST(InlinedRungeKutta, converges_with_its_order) {
  const auto error = [](int steps) {
    auto method = ellipse<TypeParam>(accepts_all);
    const double end = 6.0, h = end / steps;
    method.start(0.0, Ellipse::at(0.0), h);
    int taken = 1;
    while (method.step(end, h) == Advance::stepped) ++taken;
    EXPECT_EQ(taken, steps);
    EXPECT_EQ(method.time(), end);
    return distance(method.state(), Ellipse::at(end));
  };
  constexpr double slack = 0.3;  // of the higher terms
  EXPECT_NEAR(0.5 * std::log2(error(12) / error(48)), TypeParam::order, slack);
}

/// One step from the exact state: the interpolant of order p has an error of order p + 1 everywhere in the
/// step.
TYPED_TEST(InlinedRungeKutta, has_dense_output_of_its_order) {
  constexpr double start = 1.0;
  const auto error = [](double h, double part) {
    auto method = ellipse<TypeParam>(accepts_all);
    method.start(start, Ellipse::at(start), h);
    EXPECT_EQ(method.step(start + h), Advance::reached);
    std::array<double, 4> y;
    method.interpolate(start + part * h, y);
    return distance(y, Ellipse::at(start + part * h));
  };
  for (const double part : {0.1, 0.4, 0.7, 0.9}) {
    EXPECT_GT(std::log2(error(1.0, part) / error(0.5, part)), TypeParam::order + 0.3) << part;
    constexpr double of_order_7 = 3e-9;  // 0.25^8 times 2e-4, what the steps above leave of the ellipse
    EXPECT_LT(error(0.25, part), of_order_7) << part;
  }
}

TYPED_TEST(InlinedRungeKutta, its_dense_output_meets_the_nodes_and_their_rates) {
  auto method = ellipse<TypeParam>(1e-12);
  method.start(0.0, Ellipse::at(0.0));
  constexpr double rounding = 1e-15;  // of y, up to 1.4: some three
  // The square of the step times a third derivative below 100 / 3, and eight roundings over twice the step.
  constexpr double step_of_difference = 1e-5, difference_error = 1e-8;
  for (int i = 0; i < 10; ++i) {
    const std::vector<double> before(method.state().begin(), method.state().end());
    const std::vector<double> rate_before(method.rate().begin(), method.rate().end());
    const double t = method.time();
    ASSERT_EQ(method.step(100.0), Advance::stepped);
    std::array<double, 4> left, inside, right;
    method.interpolate(t, left);
    method.interpolate(method.time(), right);
    EXPECT_LT(distance(left, before), rounding);
    EXPECT_LT(distance(right, method.state()), 4 * rounding);
    const auto slope = [&](double at, double sign) {
      std::array<double, 4> a, b;
      method.interpolate(at, a);
      method.interpolate(at + sign * step_of_difference, b);
      method.interpolate(at + 2.0 * sign * step_of_difference, inside);
      std::array<double, 4> result;
      for (std::size_t c = 0; c < 4; ++c)
        result[c] = sign * (4.0 * b[c] - 3.0 * a[c] - inside[c]) / (2.0 * step_of_difference);
      return result;
    };
    EXPECT_LT(distance(slope(t, 1.0), rate_before), difference_error);
    EXPECT_LT(distance(slope(method.time(), -1.0), method.rate()), difference_error);
  }
}

/// Of a size known at run time the rates stand in pairs; of an odd size the last number has one of its own.
TYPED_TEST(InlinedRungeKutta, of_any_size_is_that_of_a_fixed_size) {
  constexpr std::size_t size = 5, terms = size * TypeParam::degree;
  constexpr double end = 1.0, h = 0.1;
  const auto rates = [](double, std::span<const double> y, std::span<double> ydot) {
    for (std::size_t c = 0; c < size; ++c) ydot[c] = y[(c + 1) % size] * y[(c + 3) % size] - y[c];
  };
  std::array<double, size> absolute;
  absolute.fill(accepts_all);
  RungeKutta<TypeParam, size, decltype(rates)> fixed(rates, accepts_all, absolute);
  RungeKutta<TypeParam, std::dynamic_extent, decltype(rates)> any(rates, accepts_all, absolute);
  const std::array<double, size> y{1.0, -0.4, 0.7, 0.2, -0.9};
  fixed.start(0.0, y, h);
  any.start(0.0, y, h);
  constexpr double rounding = 1e-14;  // of sums of ten numbers, which a compiler may contract
  constexpr double weights = 1e4;     // of the interpolant, up to
  Advance advance = Advance::stepped;
  while (advance == Advance::stepped) {
    advance = fixed.step(end, h);
    ASSERT_EQ(any.step(end, h), advance);
    EXPECT_LT(distance(any.state(), fixed.state()), rounding);
    EXPECT_LT(distance(any.rate(), fixed.rate()), rounding);
    std::array<double, terms> of_fixed, of_any;
    fixed.terms(of_fixed);
    any.terms(of_any);
    EXPECT_LT(distance(of_any, of_fixed), weights * rounding);
  }
}

TYPED_TEST(InlinedRungeKutta, a_polynomial_of_its_degree_is_exact_everywhere) {
  constexpr int degree = TypeParam::order;
  struct Power {
    void operator()(double t, std::span<const double, 1>, std::span<double, 1> ydot) const {
      ydot[0] = degree * std::pow(t, degree - 1);
    }
  };
  constexpr std::array absolute{accepts_all};
  RungeKutta<TypeParam, 1, Power> method(Power(), accepts_all, absolute);
  method.start(0.0, std::array{0.0}, 1.0);
  ASSERT_EQ(method.step(1.0), Advance::reached);
  constexpr double of_sum = 40 * epsilon;   // sixteen products of up to 5/2
  constexpr double of_interpolant = 1e-11;  // its weights, 1e4, times what a cubic leaves of the rate, 5
  EXPECT_NEAR(method.state()[0], 1.0, of_sum);
  for (double t = 0.0; t <= 1.0; t += 0.0625) {
    std::array<double, 1> y;
    method.interpolate(t, y);
    EXPECT_NEAR(y[0], std::pow(t, degree), of_interpolant) << t;
  }
}

TYPED_TEST(InlinedRungeKutta, ends_a_step_where_it_is_told_and_remembers_its_length) {
  auto method = ellipse<TypeParam>(tolerance);
  method.start(0.0, Ellipse::at(0.0));
  while (method.step(2.0) == Advance::stepped) {
  }
  EXPECT_EQ(method.time(), 2.0);
  const double unclipped = method.next_step();
  double until = 2.0;
  for (int i = 1; i <= 20; ++i) {
    until = 2.0 + 1e-3 * i;
    const double t = method.time();
    method.start(t, Ellipse::at(t), method.next_step());
    ASSERT_EQ(method.step(until), Advance::reached);
    EXPECT_EQ(method.time(), until);
  }
  EXPECT_GE(method.next_step(), unclipped);
  ASSERT_EQ(method.step(100.0), Advance::stepped);
  EXPECT_GT(method.time(), until + 0.5 * unclipped);  // at once, not after a series of growing steps
  EXPECT_LE(distance(method.state(), Ellipse::at(method.time())), 2 * of_step);
}

TYPED_TEST(InlinedRungeKutta, is_where_it_was_told_to_end_whatever_the_start) {
  auto method = ellipse<TypeParam>(accepts_all);
  for (int i = 1; i <= 100; ++i) {
    const double start = -i / 3.0, until = i / 70.0;  // start + (until - start) is often not until
    method.start(start, Ellipse::at(0.0));
    while (method.step(until) == Advance::stepped) {
    }
    ASSERT_EQ(method.time(), until);
  }
}

TYPED_TEST(InlinedRungeKutta, a_step_length_that_is_far_too_long_is_rejected_until_it_fits) {
  auto method = ellipse<TypeParam>(tolerance);
  method.start(0.0, Ellipse::at(0.0), 1e3);
  ASSERT_NE(method.step(1e6), Advance::not_finite);
  EXPECT_GT(method.rejections(), 0U);
  EXPECT_LT(distance(method.state(), Ellipse::at(method.time())), of_step);
}

/// y' = -sqrt(y) from 1: y = (1 - t / 2)^2. In a step of 1000 a stage is below 0 and the rate not a number.
TYPED_TEST(InlinedRungeKutta, a_step_with_a_stage_that_is_not_a_number_is_halved_until_it_fits) {
  const auto root = [](double, std::span<const double, 1> y, std::span<double, 1> ydot) {
    ydot[0] = -std::sqrt(y[0]);
  };
  constexpr std::array absolute{tolerance};
  RungeKutta<TypeParam, 1, decltype(root)> method(root, tolerance, absolute);
  method.start(0.0, std::array{1.0}, 1e3);
  ASSERT_EQ(method.step(1e6), Advance::stepped);
  EXPECT_GE(method.rejections(), 9U);  // 2 / 1000, halved
  EXPECT_NEAR(method.state()[0], std::pow(1.0 - 0.5 * method.time(), 2), of_step);
}

TYPED_TEST(InlinedRungeKutta, says_why_it_cannot_go_on) {
  const auto advance = [](auto f) {
    constexpr std::array absolute{1e-9};
    RungeKutta<TypeParam, 1, decltype(f)> method(f, 1e-9, absolute);
    method.start(0.0, std::array{1.0});
    Advance result = Advance::stepped;
    while (result == Advance::stepped) result = method.step(2.0);
    return result;
  };
  using In = std::span<const double, 1>;
  using Out = std::span<double, 1>;
  EXPECT_EQ(advance([](double, In y, Out ydot) { ydot[0] = y[0] * y[0]; }), Advance::too_short);
  EXPECT_EQ(advance([](double t, In, Out ydot) { ydot[0] = t < 1.0 ? 1.0 : NAN; }), Advance::not_finite);
  EXPECT_EQ(advance([](double t, In, Out ydot) { ydot[0] = t < 1.0 ? 1.0 : INFINITY; }), Advance::not_finite);
  EXPECT_EQ(advance([](double, In, Out ydot) { ydot[0] = 0.0; }), Advance::reached);
}

TEST(InlinedRungeKuttaDoors, refuse_times_lengths_and_states_that_are_none) {
  const auto refusal = [](auto act) -> std::string {
    auto method = ellipse<Verner9>(1e-9);
    method.start(0.0, Ellipse::at(0.0));
    EXPECT_EQ(method.step(1e-3), Advance::reached);
    std::array<double, 4> y = Ellipse::at(0.0);
    try {
      act(method, y);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal([](auto& m, auto& y) { m.start(NAN, y); }),
            "ode::RungeKutta::start: the time must be finite, got nan");
  EXPECT_EQ(refusal([](auto& m, auto& y) { m.start(0.0, y, -1.0); }),
            "ode::RungeKutta::start: the first step must be at least 0, got -1");
  EXPECT_EQ(refusal([](auto& m, auto& y) {
              y[2] = INFINITY;
              m.start(0.0, y);
            }),
            "ode::RungeKutta::start: component 2 of the state must be finite, got inf");
  EXPECT_EQ(refusal([](auto& m, auto&) { m.step(1e-3); }),
            "ode::RungeKutta::step: the end must be finite and later than 0.001, got 0.001");
  EXPECT_EQ(refusal([](auto& m, auto&) { m.step(INFINITY); }),
            "ode::RungeKutta::step: the end must be finite and later than 0.001, got inf");
  EXPECT_EQ(refusal([](auto& m, auto&) { m.step(1.0, 0.0); }),
            "ode::RungeKutta::step: the longest step must be greater than 0, got 0");
  EXPECT_EQ(refusal([](auto& m, auto& y) { m.interpolate(2e-3, y); }),
            "ode::RungeKutta::interpolate: the time 0.002 is outside the last step, [0, 0.001]");
  EXPECT_EQ(refusal([](auto& m, auto& y) {
              m.start(0.0, y);
              m.interpolate(0.0, y);
            }),
            "ode::RungeKutta::interpolate: there is no accepted step that ends at 0");
  EXPECT_EQ(refusal([](auto& m, auto& y) { m.interpolate(5e-4, y); }), "not refused");
}

TEST(InlinedRungeKuttaDoors, refuse_spans_of_another_size) {
  const auto oscillator_of_any_size = [](double, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = -y[0];
  };
  const std::vector absolute{1e-9, 1e-9}, y{1.0, 0.0};
  RungeKutta<Verner9, std::dynamic_extent, decltype(oscillator_of_any_size)> method(oscillator_of_any_size,
                                                                                    1e-9, absolute);
  std::vector<double> three(3), terms(18);
  const auto refusal = [](auto act) -> std::string {
    try {
      act();
    } catch (const BadInput& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal([&] { method.start(0.0, three); }),
            "ode::RungeKutta::start: the state has 2 numbers, the span 3");
  method.start(0.0, y);
  EXPECT_EQ(refusal([&] { method.terms(terms); }),
            "ode::RungeKutta::terms: there is no accepted step that ends at 0");
  EXPECT_EQ(method.step(1e-3), Advance::reached);
  EXPECT_EQ(refusal([&] { method.terms(terms); }), "not refused");
  EXPECT_EQ(refusal([&] { method.terms(three); }),
            "ode::RungeKutta::terms: the interpolant has 18 numbers, the span 3");
  EXPECT_EQ(refusal([&] { method.interpolate(1e-3, three); }),
            "ode::RungeKutta::interpolate: the state has 2 numbers, the span 3");
}

TEST(InlinedRungeKuttaDoors, refuse_tolerances_that_are_none) {
  const auto make = [](double relative, double absolute) {
    return RungeKutta<Verner9, 4, Ellipse>(Ellipse(), relative, std::array{1.0, absolute, 1.0, 1.0});
  };
  EXPECT_NO_THROW(make(1e-9, 1e-9));
  const auto refusal = [&](double relative, double absolute) -> std::string {
    try {
      make(relative, absolute);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "not refused";
  };
  const std::string relative = "ode::RungeKutta: the relative tolerance must be finite and at least 0, got ";
  EXPECT_EQ(refusal(-1e-9, 1e-9), relative + "-1e-09");
  EXPECT_EQ(refusal(NAN, 1e-9), relative + "nan");
  const std::string one =
      "ode::RungeKutta: the absolute tolerance of component 1 must be finite and greater than 0, got ";
  EXPECT_EQ(refusal(1e-9, 0.0), one + "0");
  EXPECT_EQ(refusal(1e-9, NAN), one + "nan");
}

/// A body without torque, J = diag(1, 2, 3), keeps |J w|^2 and |q|. Coefficients rounded to double could let
/// them drift by some roundings in each of the 160 000 steps: 1e-11. What is left is a random walk, 400
/// roundings.
TYPED_TEST(InlinedRungeKutta, rounded_coefficients_do_not_drift) {
  struct FreeBody {
    void operator()(double, std::span<const double, 7> y, std::span<double, 7> ydot) const {
      vectrix_test::free_body({1.0, 2.0, 3.0}, y, ydot);
    }
  };
  std::array<double, 7> absolute;
  absolute.fill(accepts_all);
  RungeKutta<TypeParam, 7, FreeBody> method(FreeBody(), accepts_all, absolute);
  constexpr double h = 0.025, end = vectrix_test::trials(4000);  // truncation: below 1e-16
  method.start(0.0, std::array{1.0, 0.0, 0.0, 0.0, 0.7, 0.6, 0.65}, h);
  const auto momentum = [&] {
    const auto y = method.state();
    return std::hypot(y[4], 2.0 * y[5], 3.0 * y[6]);
  };
  const auto norm = [&] {
    const auto y = method.state();
    return std::hypot(std::hypot(y[0], y[1]), std::hypot(y[2], y[3]));
  };
  const double before = momentum();
  while (method.step(end, h) == Advance::stepped) {
  }
  constexpr double random_walk = 400 * epsilon;  // (160 000)^(1/2)
  EXPECT_NEAR(momentum() / before, 1.0, random_walk);
  EXPECT_NEAR(norm(), 1.0, random_walk);
}

}  // namespace
}  // namespace vectrix::ode::test::runge_kutta_test
