#include <gtest/gtest.h>

#include "batches.hpp"
#include "testing/any_scalar.hpp"

// Several attitudes at once: each lane gives the result of a double, and a door refuses a bad lane.
namespace vectrix_test::simd_test {
namespace {

namespace simd = std::experimental;

constexpr int instances = 200;
/// Lanes and doubles do the same operations. Only sin, cos and similar functions may round differently, and
/// the next operations amplify this some hundred times.
constexpr double lane_tolerance = 512 * epsilon;

template <class S> class Simd : public testing::Test {
 protected:
  static constexpr std::size_t lanes = S::size();
  static constexpr std::size_t last = lanes - 1;

  /// 1 in each lane, but `bad` in the last.
  static S spoilt(double bad) {
    S x(1.0);
    x[last] = bad;
    return x;
  }
  static detail::Square<S> spoilt_identity(double bad) {
    detail::Square<S> matrix = detail::Square<S>::Identity();
    matrix(1, 1) = spoilt(bad);
    return matrix;
  }
};
TYPED_TEST_SUITE(Simd, Batches);

TYPED_TEST(Simd, EachLaneIsThatOfADouble) {
  using S = TypeParam;
  std::mt19937_64 random(20260103);
  for (int i = 0; i < instances; ++i) {
    std::vector<Given<double>> one;
    for (std::size_t lane = 0; lane < S::size(); ++lane) one.push_back(random_numbers(random));
    const Given<S> batch = batch_of<S>(one);
    const auto check = [&](const char* law, const std::vector<S>& found, const auto& alone) {
      for (std::size_t lane = 0; lane < S::size(); ++lane) {
        const std::vector<double> wanted = alone(one[lane]);
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t k = 0; k < wanted.size(); ++k) {
          EXPECT_LE(std::abs(double(found[k][lane]) - wanted[k]),
                    lane_tolerance * std::max(1.0, std::abs(wanted[k])))
              << law << ", number " << k << ", lane " << lane;
        }
      }
    };
    check("rotations", rotations(batch), rotations<double>);
    check("projections", projections(batch), projections<double>);
    check("quaternions", quaternions(batch), quaternions<double>);
    check("turns", turns(batch), turns<double>);
    check("rates", rates(batch), rates<double>);
    // A graph does nothing with lanes but what these laws do: one kind of batch says so, for its time to
    // compile.
    if constexpr (std::same_as<S, simd::native_simd<double>>) {
      check("graph_answers", graph_answers(batch), graph_answers<double>);
    }
  }
}

TYPED_TEST(Simd, HalfTurnsTakeTheSameAxisAndSign) {
  using S = TypeParam;
  const auto list = hard_attitudes();
  for (std::size_t i = 0; i + S::size() <= list.size(); ++i) {
    const auto number = [&](Eigen::Index n) {
      return S([&](auto lane) { return list[i + lane].coeffs()(n); });
    };
    const auto q =
        nearest_quaternion_scalar_last(to<Gcrf>, from<Body>, number(0), number(1), number(2), number(3))
            .quaternion;
    const auto theta = log(q);
    const auto again = quaternion(dcm(q));
    for (std::size_t lane = 0; lane < S::size(); ++lane) {
      const auto& c = list[i + lane].coeffs();
      const auto one =
          nearest_quaternion_scalar_last(to<Gcrf>, from<Body>, c(0), c(1), c(2), c(3)).quaternion;
      EXPECT_LE(distance(detail::lane(theta.coordinates(), lane), log(one).coordinates()), rounding) << c;
      EXPECT_LE(distance(detail::lane(again.eigen().coeffs(), lane), quaternion(dcm(one)).eigen().coeffs()),
                rounding)
          << c;
    }
  }
}

// Above the range of sine_cosine() the lanes are computed one by one.
TYPED_TEST(Simd, AnglesMayBeLarge) {
  using S = TypeParam;
  for (const double angle : {1e3, 1e8, 4e9, 1e15, -1e300}) {
    S mixed(0.3);
    mixed[S::size() - 1] = angle;
    for (const S& batch : {mixed, S(angle)}) {
      const auto R = turned_z(to<Body>, from<Gcrf>, radians(batch)).matrix();
      for (std::size_t lane = 0; lane < S::size(); ++lane) {
        const auto one = turned_z(to<Body>, from<Gcrf>, double(batch[lane]) * si::radian).matrix();
        EXPECT_LE(distance(detail::lane(R, lane), one), rounding) << double(batch[lane]);
      }
    }
  }
}

TYPED_TEST(Simd, ADoorRefusesABadLane) {
  using S = TypeParam;
  const auto refusal = [](const auto& door) { return message<BadInput>(door); };
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const S x = this->spoilt(bad);
    const S one(1.0);
    const S zero(0.0);
    const detail::Square<S> matrix = this->spoilt_identity(bad);
    const detail::Column<S> column(one, zero, x);
    EXPECT_TRUE(contains(refusal([&] { dcm(to<Body>, from<Gcrf>, matrix); }), "entry (2, 2) is {"));
    EXPECT_NE(refusal([&] { nearest_dcm(to<Body>, from<Gcrf>, matrix); }), "");
    EXPECT_NE(refusal([&] { vector<si::length>(in<Body>, column); }), "");
    EXPECT_NE(refusal([&] { turned_x(to<Body>, from<Gcrf>, radians(x)); }), "");
    EXPECT_NE(refusal([&] { quaternion_scalar_first(to<Body>, from<Gcrf>, x, zero, zero, zero); }), "");
    EXPECT_NE(refusal([&] { nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, x, one, one, one); }), "");
    EXPECT_NE(refusal([&] { vee(hat(column)); }), "");
  }
  // Finite, but not a rotation, a direction, a quaternion or a time in the interval.
  const S zero(0.0);
  const S one(1.0);
  const auto vanishing = vector<si::length>(in<Body>, detail::Column<S>(this->spoilt(0.0), zero, zero));
  EXPECT_TRUE(contains(refusal([&] { dcm(to<Body>, from<Gcrf>, this->spoilt_identity(1.0 + 1e-6)); }),
                       "differs from the identity"));
  EXPECT_TRUE(contains(refusal([&] { dcm(to<Body>, from<Gcrf>, this->spoilt_identity(-1.0)); }),
                       "the determinant is {"));
  EXPECT_NE(refusal([&] { nearest_dcm(to<Body>, from<Gcrf>, this->spoilt_identity(-1.0)); }), "");
  EXPECT_TRUE(contains(refusal([&] { direction(vanishing); }), "no direction"));
  EXPECT_TRUE(contains(refusal([&] {
                         quaternion_scalar_first(to<Body>, from<Gcrf>, this->spoilt(1.0 - 1e-6), zero, zero,
                                                 zero);
                       }),
                       "differs from 1"));
  EXPECT_NE(refusal([&] {
              nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, zero, zero, zero, this->spoilt(0.0));
            }),
            "");
  const auto theta = vector<si::angle>(in<Body>, detail::Column<S>(this->spoilt(1e200), zero, zero));
  EXPECT_NE(refusal([&] { exp(rotation_vector(of<Body>, relative_to<Gcrf>, theta)); }), "");
  const auto still = nearest_quaternion_scalar_first(to<Gcrf>, from<Body>, one, zero, zero, zero).quaternion;
  EXPECT_NE(refusal([&] { Slerp(instant_of(zero), still, instant_of(this->spoilt(0.0)), still); }), "");
  const Slerp slerp(instant_of(zero), still, instant_of(one), still);
  EXPECT_NE(refusal([&] { slerp(instant_of(this->spoilt(1.5))); }), "");
}

TEST(Simd, PrintsItsLanes) {
  using S = simd::simd<double, simd::simd_abi::deduce_t<double, 2>>;
  const S x([](auto lane) { return lane + 0.5; });
  std::ostringstream out;
  out << vector<si::length>(in<Body>, detail::Column<S>(x, 1.0, 0.0));
  EXPECT_EQ(out.str(), "({0.5, 1.5}, {1, 1}, {0, 0}) m in " + frame_name<Body>());
}

// A comparison of lanes is not a bool: code that branches on one does not compile.
static_assert(!std::is_convertible_v<simd::native_simd<double>::mask_type, bool>);

}  // namespace
}  // namespace vectrix_test::simd_test
