#include <gtest/gtest.h>

#include <random>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/scalar/lanes.hpp>
#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>
#include <vectrix/kinematics/rates/euler_rates.hpp>

#include <unsupported/Eigen/AutoDiff>

#include "testing/attitudes.hpp"

// Parameters of any scalar: float, long double, several attitudes at once, numbers with a derivative.
namespace vectrix_test::parameter_scalars_test {
namespace {

using namespace vectrix;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 2>>;

constexpr int instances = 100;

/// Twelve numbers: a quaternion of any length, scalar first, whose numbers are not small; w; alpha.
template <class S> struct Given {
  Eigen::Quaternion<S> q;
  Eigen::Matrix<S, 3, 1> w, alpha;
};
Given<double> random_given(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0), size(0.3, 1.0);
  const auto away = [&] { return number(random) < 0 ? -size(random) : size(random); };
  return {{size(random), away(), away(), away()},
          {number(random), number(random), number(random)},
          {number(random), number(random), number(random)}};
}
template <class S> Given<S> converted(const Given<double>& from) {
  return {from.q.template cast<S>(), from.w.template cast<S>(), from.alpha.template cast<S>()};
}

/// Parameters and their derivatives, converted to R and back to w and alpha.
template <class S, class Make> std::vector<S> numbers_of(const Given<S>& given, const Make& make) {
  using std::sqrt;
  const S norm = sqrt(S(given.q.coeffs().dot(given.q.coeffs())));
  const Quaternion<Gcrf, Body, S> q(detail::trusted, Eigen::Quaternion<S>(given.q.coeffs() / norm));
  const AngularVelocity<Gcrf, Body, In<Body>, S> w(detail::trusted, given.w);
  const AngularAcceleration<Gcrf, Body, In<Body>, S> alpha(detail::trusted, given.alpha);
  const auto x = make(q);
  const auto xdot = rate(x, w);
  const auto xddot = second_rate(x, w, alpha);
  std::vector<S> list;
  const auto add = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) list.push_back(matrix.data()[i]);
  };
  add(x.coordinates());
  add(xdot.coordinates());
  add(xddot.coordinates());
  add(dcm(x).matrix());
  add(angular_velocity_from(x, xdot, in<Gcrf>).coordinates());
  add(angular_acceleration_from(x, xdot, xddot, in<Body>).coordinates());
  return list;
}

template <class Check> void for_each_kind(const Check& check) {
  check([](const auto& q) { return euler_angles(intrinsic<3, 2, 1>, q); });
  check([](const auto& q) { return euler_angles(extrinsic<3, 1, 3>, dcm(q)); });
  check([](const auto& q) { return axis_angle(q); });
  check([](const auto& q) { return modified_rodrigues(q); });
  check([](const auto& q) { return modified_rodrigues(dcm(q)).shadow(); });
  check([](const auto& q) { return switch_to_shadow(modified_rodrigues(q).shadow()).parameters; });
  check([](const auto& q) { return gibbs_vector(dcm(q)); });
}

/// The second derivatives grow as the square of 1/distance, and so do their rounding errors.
template <class Number> double scale_of(const std::vector<Number>& list) {
  double largest = 1.0;
  for (const Number& number : list) largest = std::max(largest, std::abs(static_cast<double>(number)));
  return largest * largest;
}

TEST(ParametersOfAnyScalar, FloatAndDoubleGiveWhatLongDoubleGives) {
  std::mt19937_64 random(20261107);
  for (int i = 0; i < instances; ++i) {
    const auto given = random_given(random);
    for_each_kind([&](const auto& make) {
      const auto exact = numbers_of(converted<long double>(given), make);
      const auto check = [&]<class S>(const std::vector<S>& found) {
        ASSERT_EQ(found.size(), exact.size());
        const double tolerance =
            64 * static_cast<double>(std::numeric_limits<S>::epsilon()) * scale_of(exact);
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_LE(std::abs(static_cast<double>(static_cast<long double>(found[k]) - exact[k])), tolerance)
              << k;
        }
      };
      check(numbers_of(converted<double>(given), make));
      check(numbers_of(converted<float>(given), make));
    });
  }
}

TEST(ParametersOfAnyScalar, EachLaneIsThatOfADouble) {
  std::mt19937_64 random(20261108);
  for (int i = 0; i < instances; ++i) {
    const Given<double> one[] = {random_given(random), random_given(random)};
    Given<Lanes> both;
    const auto lane_of = [&](const auto& number) {
      return Lanes([&](auto lane) { return number(one[lane]); });
    };
    for (Eigen::Index k = 0; k < 4; ++k) {
      both.q.coeffs()(k) = lane_of([&](const auto& g) { return g.q.coeffs()(k); });
    }
    for (Eigen::Index k = 0; k < 3; ++k) {
      both.w(k) = lane_of([&](const auto& g) { return g.w(k); });
      both.alpha(k) = lane_of([&](const auto& g) { return g.alpha(k); });
    }
    for_each_kind([&](const auto& make) {
      const auto found = numbers_of(both, make);
      for (std::size_t lane = 0; lane < 2; ++lane) {
        const auto wanted = numbers_of(one[lane], make);
        const double tolerance = 64 * epsilon * scale_of(wanted);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
          EXPECT_LE(std::abs(double(found[k][lane]) - wanted[k]), tolerance) << k;
        }
      }
    });
  }
}

// Parameters made from a moving quaternion have the derivative that rate() gives.
TEST(ParametersOfAnyScalar, TheDerivativeOfTheConversionIsTheRate) {
  std::mt19937_64 random(20261109);
  for (int i = 0; i < instances; ++i) {
    const auto given = random_given(random);
    const Eigen::Quaterniond q = given.q.normalized();
    const Eigen::Quaterniond qdot =
        q * Eigen::Quaterniond(0, given.w.x() / 2, given.w.y() / 2, given.w.z() / 2);
    Eigen::Matrix<Dual, 4, 1> moving;
    for (Eigen::Index k = 0; k < 4; ++k) {
      moving(k) = Dual(q.coeffs()(k), Eigen::Matrix<double, 1, 1>(qdot.coeffs()(k)));
    }
    const Quaternion<Gcrf, Body, Dual> q_moving(detail::trusted, Eigen::Quaternion<Dual>(moving));
    const AngularVelocity<Gcrf, Body, In<Body>> w(detail::trusted, given.w);
    for_each_kind([&](const auto& make) {
      const auto x = make(Quaternion<Gcrf, Body>(detail::trusted, q));
      const auto xdot = rate(x, w).coordinates();
      const auto found = make(q_moving).coordinates();
      const double tolerance = 64 * epsilon * std::max(1.0, xdot.squaredNorm());
      for (Eigen::Index k = 0; k < xdot.size(); ++k) {
        EXPECT_LE(std::abs(found(k).derivatives()(0) - xdot(k)), tolerance) << k;
      }
    });
  }
}

// At the singularity the choice of the angle is a constant, so the parameters have no derivative.
TEST(ParametersOfAnyScalar, NumbersWithADerivativeAreRefusedAtTheSingularity) {
  const auto R = aligned<Dual>(to<Gcrf>, from<Body>);
  const auto angles = message<BadInput>([&] { euler_angles(intrinsic<3, 1, 3>, R); });
  EXPECT_TRUE(contains(angles, "euler_angles(Euler angles intrinsic 3-1-3 of ")) << angles;
  EXPECT_TRUE(contains(angles, "): 0 rad from the singularity")) << angles;
  EXPECT_NE(message<BadInput>([&] { axis_angle(R); }), "");
  EXPECT_EQ(message<BadInput>([&] { euler_angles(intrinsic<3, 2, 1>, R); }), "");
}

}  // namespace
}  // namespace vectrix_test::parameter_scalars_test
