#include <gtest/gtest.h>

#include <vectrix/dynamics/force/gravity.hpp>
#include <vectrix/dynamics/rigid/euler.hpp>
#include <vectrix/frames/scalar/lanes.hpp>

#include "testing/any_scalar.hpp"
#include "testing/motions.hpp"

// Inertia, Euler's equation and gravity for any scalar: values against long double, derivatives against
// differences of long double, lanes against doubles.
namespace vectrix_test::scalars_test {
namespace {

using Batch = std::experimental::native_simd<double>;

constexpr int instances = 200;
/// Rounding of some hundred operations; the largest moment of the inertia is ten times the smallest.
constexpr double roundings = 1e3;
/// The error of a central difference of long double over 2e-5 is h^2 times a third derivative of order 1e3.
constexpr long double step = 1e-5L;
constexpr double difference_tolerance = 1e-6;

template <class S> Quantity<si::moment_of_inertia, S> moment(const S& number) {
  return Quantity<si::moment_of_inertia, S>::from_value(number);
}

/// A valid inertia tensor: the sum over two masses and a ball.
template <class S> CentralInertia<Body, S> body(const Given<S>& given) {
  detail::Square<S> J = detail::Square<S>::Identity();
  for (const auto& r : {given.v[0], given.v[1]})
    J += r.squaredNorm() * detail::Square<S>::Identity() - r * r.transpose();
  return inertia_from_tensor(in<Body>, moment(J(0, 0)), moment(J(1, 1)), moment(J(2, 2)), xy(moment(J(0, 1))),
                             xz(moment(J(0, 2))), yz(moment(J(1, 2))));
}

template <class S> std::vector<S> right_hand_sides(const Given<S>& given) {
  Told<S> told;
  const auto J = body(given);
  const auto w = rate_of<Gcrf, Body>(given.v[2]);
  const auto torque = vector<si::torque>(in<Body>, given.v[3]);
  told.add(euler(J, w, torque));
  told.add(euler(trust_inertia(in<Body>, J.matrix()), w, torque));
  told.add(J * w);
  told.add(kinetic_energy(J, w).value());
  const auto mu = Quantity<si::gravitational_parameter, S>::from_value(given.t + S(1));
  const Eigen::Matrix<S, 3, 1> r = given.q[0].template head<3>();  // never zero
  told.add(point_mass_gravity(mu, vector<si::length>(in<Gcrf>, r)));
  told.add(gravity_gradient_torque(mu, J, vector<si::length>(in<Body>, r)));
  return told.numbers;
}

template <class S, class Reference>
void expect_near(const S& found, const Reference& reference, double tolerance) {
  const double exact = static_cast<double>(reference);
  EXPECT_LE(std::abs(static_cast<double>(found) - exact), tolerance * std::max(1.0, std::abs(exact)));
}

TEST(DynamicsOfAnyScalar, FloatsGiveWhatLongDoubleGives) {
  std::mt19937_64 random(20260104);
  for (int i = 0; i < instances; ++i) {
    const Given<double> numbers = random_numbers(random);
    const auto exact = right_hand_sides(converted<long double>(numbers, [](double x) { return 1.0L * x; }));
    const auto check = [&](const auto& found) {
      using S = typename std::decay_t<decltype(found)>::value_type;
      ASSERT_EQ(found.size(), exact.size());
      for (std::size_t k = 0; k < exact.size(); ++k)
        expect_near(found[k], exact[k], roundings * static_cast<double>(Eigen::NumTraits<S>::epsilon()));
    };
    check(right_hand_sides(converted<float>(numbers, [](double x) { return static_cast<float>(x); })));
    check(right_hand_sides(numbers));
  }
}

TEST(DynamicsOfAnyScalar, AutomaticDerivativesAreThoseOfLongDoubleDifferences) {
  std::mt19937_64 random(20260105);
  for (int i = 0; i < instances; ++i) {
    const Given<double> numbers = random_numbers(random);
    const auto moved = [&]<class S>(const S& s) {
      int n = 0;
      return converted<S>(numbers, [&](double x) { return S(S(x) + s * S(std::sin(++n))); });
    };
    const auto dual = right_hand_sides(moved(Dual(0.0, 1, 0)));
    const auto after = right_hand_sides(moved(step));
    const auto before = right_hand_sides(moved(-step));
    ASSERT_EQ(dual.size(), after.size());
    for (std::size_t k = 0; k < dual.size(); ++k) {
      expect_near(dual[k].value(), (after[k] + before[k]) / 2, difference_tolerance);
      expect_near(dual[k].derivatives()(0), (after[k] - before[k]) / (2 * step), difference_tolerance);
    }
  }
}

TEST(DynamicsOfAnyScalar, EachLaneIsThatOfADouble) {
  std::mt19937_64 random(20260106);
  for (int i = 0; i < instances; ++i) {
    std::vector<Given<double>> one;
    for (std::size_t lane = 0; lane < Batch::size(); ++lane) one.push_back(random_numbers(random));
    const auto found = right_hand_sides(batch_of<Batch>(one));
    for (std::size_t lane = 0; lane < Batch::size(); ++lane) {
      const auto wanted = right_hand_sides(one[lane]);
      ASSERT_EQ(found.size(), wanted.size());
      for (std::size_t k = 0; k < wanted.size(); ++k)
        expect_near(double(found[k][lane]), wanted[k], roundings * epsilon);
    }
  }
}

TEST(DynamicsOfAnyScalar, ADoorRefusesABadLane) {
  Batch jxx(1.0);
  const auto refusal = [&](double bad) {
    jxx[Batch::size() - 1] = bad;
    const Batch one(1.0);
    const Batch zero(0.0);
    return message<BadInput>([&] {
      inertia_from_tensor(in<Body>, moment(jxx), moment(one), moment(one), xy(moment(zero)), xz(moment(zero)),
                          yz(moment(zero)));
    });
  };
  EXPECT_EQ(refusal(1.5), "");
  EXPECT_TRUE(contains(refusal(2.5), "no body has this inertia"));
  EXPECT_TRUE(contains(refusal(-1.0), "positive or zero"));
  EXPECT_TRUE(contains(refusal(std::numeric_limits<double>::quiet_NaN()), "nan kg m^2"));
  Batch x(1.0);
  x[Batch::size() - 1] = 0.0;
  const auto nowhere = vector<si::length>(in<Gcrf>, detail::Column<Batch>(x, 0.0, 0.0));
  EXPECT_NE(message<BadInput>([&] {
              point_mass_gravity(Quantity<si::gravitational_parameter, Batch>::from_value(1.0), nowhere);
            }),
            "");
}

}  // namespace
}  // namespace vectrix_test::scalars_test
