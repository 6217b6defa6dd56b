#include <gtest/gtest.h>

#include "testing/any_scalar.hpp"
#include "testing/motions.hpp"
#include "testing/trials.hpp"

// float, double, long double and automatic differentiation through frames, graph and kinematics, compared
// with long double and its differences.
namespace vectrix_test::scalars_test {
namespace {

constexpr int instances = trials(200);
/// Roundings of the longest list, the accelerations of a graph: some hundred, on numbers of order 10.
constexpr double roundings = 1e3;

#define FOR_EACH_LAW(check) \
  check(rotations);         \
  check(quaternions);       \
  check(turns);             \
  check(rates);             \
  check(graph_answers)

/// Compares each number of a list with a reference.
template <class S, class Reference>
void expect_near(const std::vector<S>& found, const std::vector<Reference>& reference, double tolerance,
                 const char* what) {
  ASSERT_EQ(found.size(), reference.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(std::abs(static_cast<double>(found[i] - static_cast<S>(reference[i]))),
              tolerance * std::max(1.0, std::abs(static_cast<double>(reference[i]))))
        << what << ", number " << i;
  }
}

template <class S> class Scalars : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(Scalars, Floats);

TYPED_TEST(Scalars, GiveWhatLongDoubleGivesToTheirRounding) {
  using S = TypeParam;
  std::mt19937_64 random(20260101);
  const double tolerance = roundings * static_cast<double>(Eigen::NumTraits<S>::epsilon());
  for (int i = 0; i < instances; ++i) {
    const Given<double> numbers = random_numbers(random);
    const auto given = converted<S>(numbers, [](double x) { return static_cast<S>(x); });
    const auto exact = converted<long double>(numbers, [](double x) { return static_cast<long double>(x); });
#define CHECK_VALUE(law) expect_near(law(given), law(exact), tolerance, #law)
    FOR_EACH_LAW(CHECK_VALUE);
    CHECK_VALUE(projections);
  }
}

/// Error of a central difference over 2h in long double, h = 1e-5: h^2 times a third derivative of order 1e3,
/// and 1e-19/h.
constexpr long double step = 1e-5L;
constexpr double difference_tolerance = 1e-6;

// The projected door takes no number with a derivative: it would be the derivative of a stopped iteration.
template <class S>
concept Projects = requires(const Eigen::Matrix<S, 3, 3>& matrix) {
  nearest_dcm(to<Body>, from<Gcrf>, matrix);
};
static_assert(Projects<float> && Projects<long double> && !Projects<Dual> && !Projects<Dual2>);

TEST(Scalars, AutomaticDerivativesAreThoseOfLongDoubleDifferences) {
  std::mt19937_64 random(20260102);
  for (int i = 0; i < instances; ++i) {
    const Given<double> numbers = random_numbers(random);
    // The n-th number x moves as x + c sin(n) s, where s is the variable.
    const auto moved = [&]<class S>(const S& s) {
      int n = 0;
      return converted<S>(numbers, [&](double x) { return S(S(x) + s * S(std::sin(++n))); });
    };
    const auto dual = moved(Dual(0.0, 1, 0));
    const auto ahead = moved(step);
    const auto behind = moved(-step);
    const auto check = [](const std::vector<Dual>& found, const std::vector<long double>& after,
                          const std::vector<long double>& before, const char* what) {
      std::vector<double> values, derivatives;
      std::vector<long double> means, slopes;
      for (std::size_t k = 0; k < found.size(); ++k) {
        values.push_back(found[k].value());
        derivatives.push_back(found[k].derivatives()(0));
        means.push_back((after.at(k) + before.at(k)) / 2);
        slopes.push_back((after[k] - before[k]) / (2 * step));
      }
      expect_near(values, means, difference_tolerance, what);
      expect_near(derivatives, slopes, difference_tolerance, what);
    };
#define CHECK_DERIVATIVE(law) check(law(dual), law(ahead), law(behind), #law)
    FOR_EACH_LAW(CHECK_DERIVATIVE);
  }
}

// w_ab = vee(Rdot R^T) and alpha_ab its derivative. A graph that knows the rates of its edges, at a plain
// instant, is compared with the second derivatives of a graph that knows rotations alone, at an instant with
// derivatives.
TEST(Scalars, TheRatesOfAGraphAreTheDerivativesOfItsRotations) {
  std::mt19937_64 random(20260107);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < instances; ++i) {
    const double k[] = {number(random), number(random), number(random), number(random)};
    const double t = number(random);
    using Time = Quantity<si::time, Dual2>;
    const auto attitudes =
        frame_graph(edge([&](const Time& now) { return turning<Gcrf, Body>(k[0], now.value()); }),
                    edge([&](const Time& now) { return turning<Camera, Body>(k[1], now.value()); }),
                    edge([&](const Time& now) { return turning<Camera, Wheel<1>>(k[2], now.value()); }),
                    edge([&](const Time& now) { return turning<Gcrf, Wheel<2>>(k[3], now.value()); }));
    const auto motions = frame_graph(
        edge([&](double now) { return Motion(turning<Gcrf, Body>(k[0], instant(now))).accelerating(); }),
        edge([&](double now) { return Motion(turning<Camera, Body>(k[1], instant(now))).accelerating(); }),
        edge(
            [&](double now) { return Motion(turning<Camera, Wheel<1>>(k[2], instant(now))).accelerating(); }),
        edge([&](double now) { return Motion(turning<Gcrf, Wheel<2>>(k[3], instant(now))).accelerating(); }));
    const auto check = [&]<class B, class A>(Of<B>, RelativeTo<A>) {
      const Motion<A, B> exact(attitudes.at(Time::from_value(instant(t))).rotation(to<A>, from<B>));
      const auto now = motions.at(t);
      const auto w = now.angular_velocity(of<B>, relative_to<A>, in<A>);
      const auto alpha = now.angular_acceleration(of<B>, relative_to<A>, in<A>);
      EXPECT_LE(distance(now.rotation(to<A>, from<B>).matrix(), exact.R), motion_tolerance);
      EXPECT_LE(distance(w.coordinates(), exact.w_a()), motion_tolerance);
      EXPECT_LE(distance(alpha.coordinates(), exact.alpha_a()), motion_tolerance);
    };
    check(of<Wheel<1>>, relative_to<Gcrf>);
    check(of<Gcrf>, relative_to<Wheel<1>>);
    check(of<Camera>, relative_to<Wheel<2>>);
    check(of<Wheel<2>>, relative_to<Wheel<1>>);
  }
}

}  // namespace
}  // namespace vectrix_test::scalars_test
