#include <gtest/gtest.h>

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/systems/si.hpp>
#include <experimental/simd>
#include <numbers>
#include <sstream>
#include <unsupported/Eigen/AutoDiff>
#include <vectrix/frames.hpp>
#include <vectrix/frames/scalar/lanes.hpp>

#include "testing/attitudes.hpp"

// A quantity is a number to the machine, and what unit it has is Boost.Units' to say.
using namespace vectrix;
using namespace vectrix_test;

namespace quantity_test {
namespace {

namespace bu = boost::units;

// The tags stand for Boost's own units.
template <class Tag, class BoostUnit>
concept Names = std::same_as<boost_unit<Tag>, BoostUnit> && std::same_as<unit_tag<BoostUnit>, Tag>;
static_assert(Names<si::dimensionless, bu::si::dimensionless> && Names<si::angle, bu::si::plane_angle>);
static_assert(Names<si::time, bu::si::time> && Names<si::frequency, bu::si::frequency>);
static_assert(Names<si::mass, bu::si::mass> && Names<si::length, bu::si::length>);
static_assert(Names<si::velocity, bu::si::velocity> && Names<si::acceleration, bu::si::acceleration>);
static_assert(Names<si::momentum, bu::si::momentum> && Names<si::force, bu::si::force>);
static_assert(Names<si::energy, bu::si::energy> && Names<si::power, bu::si::power>);
static_assert(Names<si::angular_velocity, bu::si::angular_velocity>);
static_assert(Names<si::angular_acceleration, bu::si::angular_acceleration>);
static_assert(Names<si::moment_of_inertia, bu::si::moment_of_inertia>);
static_assert(Names<si::angular_momentum, bu::si::angular_momentum>);
static_assert(Names<si::torque, bu::si::torque> && Names<si::area, bu::si::area>);
static_assert(Names<si::magnetic_flux_density, bu::si::magnetic_flux_density>);
static_assert(Names<si::unit<0, 0, 0, 0, 0, 1>, bu::si::temperature>);
static_assert(Names<si::derived<bu::si::luminous_intensity>, bu::si::luminous_intensity>);

// Each product and each quotient of two units is the one that Boost finds.
template <class... Units> struct List {};
template <class U, class V>
inline constexpr bool as_boost_finds =
    boost_unit<unit_product<U, V>>{} == boost_unit<U>{} * boost_unit<V>{} &&
    boost_unit<unit_quotient<U, V>>{} == boost_unit<U>{} / boost_unit<V>{} &&
    std::same_as<decltype(Quantity<U>{} * Quantity<V>{}), Quantity<unit_product<U, V>>>&&
        std::same_as<decltype(Quantity<U>{} / Quantity<V>{}), Quantity<unit_quotient<U, V>>>&& std::same_as<
            decltype(UnitConstant<U>{} * UnitConstant<V>{}), UnitConstant<unit_product<U, V>>>&&
            std::same_as<decltype(UnitConstant<U>{} / UnitConstant<V>{}), UnitConstant<unit_quotient<U, V>>>;
template <class U, class... Vs> constexpr bool row_as_boost_finds(List<Vs...>) {
  return (as_boost_finds<U, Vs> && ...);
}
template <class... Us> constexpr bool table_as_boost_finds(List<Us...> units) {
  return (row_as_boost_finds<Us>(units) && ...);
}
static_assert(table_as_boost_finds(List<si::dimensionless, si::angle, si::time, si::frequency, si::mass,
                                        si::length, si::velocity, si::force, si::energy, si::angular_velocity,
                                        si::moment_of_inertia, si::torque, si::gravitational_parameter>{}));
static_assert(table_as_boost_finds(List<si::time, si::length, si::kilometre_unit, si::hour_unit, si::day_unit,
                                        si::degree_unit, si::revolution_per_minute_unit>{}));

// A product that has a name takes it, however it came about; one without is short.
template <class Given, class U>
concept Has = std::same_as<Given, const Quantity<U>>;
constexpr auto five_newtons = 5.0 * si::kilogram * si::metre / si::second / si::second;
constexpr auto ratio = five_newtons / (2.0 * si::newton);
constexpr auto jerk = 3.0 * (si::metre / si::second) / si::second / si::second;
constexpr auto snap = jerk / si::second;
constexpr auto drift = 0.01 * si::degree / si::hour;
constexpr auto distance = 100.0 * si::kilometre / si::hour * si::hour;
constexpr auto rate = 1.0 / (4.0 * si::second);
static_assert(Has<decltype(five_newtons), si::force> && five_newtons.value() == 5.0);
static_assert(Has<decltype(ratio), si::dimensionless> && ratio == 2.5);
static_assert(Has<decltype(jerk), si::jerk> && jerk.value() == 3.0);
static_assert(Has<decltype(snap), si::unit<1, 0, -4>> && snap.value() == 3.0);
static_assert(Has<decltype(drift), si::per<si::degree_unit, si::hour_unit>>);
static_assert(convert<si::time>(2.0 * si::day).value() == 172800.0);
static_assert(Has<decltype(distance), si::kilometre_unit> && distance.value() == 100.0);
static_assert(Has<decltype(rate), si::frequency> && rate.value() == 0.25);
static_assert(std::same_as<unit_quotient<si::area, si::length>, si::length>);

// Boost counts the radian: a torque is no energy, and N m no torque.
template <class From, class To>
concept Becomes = std::convertible_to<From, To>;
static_assert(!Becomes<Quantity<si::energy>, Quantity<si::torque>>);
static_assert(!Becomes<decltype(2.0 * si::newton * si::metre), Quantity<si::torque>>);
static_assert(Becomes<decltype(2.0 * si::newton * si::metre / si::radian), Quantity<si::torque>>);
static_assert(!Becomes<Quantity<si::frequency>, Quantity<si::angular_velocity>>);

// One unit, and no bare number.
static_assert(!Becomes<Quantity<si::kilometre_unit>, Quantity<si::length>>);
static_assert(!Becomes<double, Quantity<si::length>> && !Becomes<Quantity<si::length>, double>);
static_assert(Becomes<Quantity<si::dimensionless>, double> && !Becomes<double, Quantity<si::dimensionless>>);
static_assert(std::constructible_from<Quantity<si::dimensionless>, double>);
static_assert(!std::constructible_from<Quantity<si::length>, double>);
template <class X, class Y>
concept Adds = requires(X x, Y y) {
  x + y;
};
template <class X, class Y>
concept AddsInPlace = requires(X x, Y y) {
  x += y;
};
template <class X, class Y>
concept Compares = requires(X x, Y y) {
  x < y;
};
template <class X, class Y>
concept Equates = requires(X x, Y y) {
  x == y;
};
template <class X, class Y>
inline constexpr bool goes_with = Adds<X, Y>&& AddsInPlace<X, Y>&& Compares<X, Y>&& Equates<X, Y>;
template <class X, class Y>
inline constexpr bool is_apart = !Adds<X, Y> && !AddsInPlace<X, Y> && !Compares<X, Y> && !Equates<X, Y>;
static_assert(goes_with<Quantity<si::length>, Quantity<si::length>>);
static_assert(is_apart<Quantity<si::length>, Quantity<si::time>>);
static_assert(is_apart<Quantity<si::length>, Quantity<si::kilometre_unit>>);
static_assert(is_apart<Quantity<si::torque>, Quantity<si::energy>>);
static_assert(is_apart<Quantity<si::length>, double> && is_apart<double, Quantity<si::length>>);
template <class U, class V, class S = double>
concept Converts = std::same_as<decltype(convert<U>(Quantity<V, S>{})), Quantity<U, S>>;
static_assert(Converts<si::length, si::kilometre_unit> && !Converts<si::length, si::time>);
static_assert(!Converts<si::torque, si::energy> && !Converts<si::angle, si::degree_unit, int>);

// A wider scalar takes a narrower one in, not the other way round.
static_assert(Becomes<Quantity<si::time, int>, Quantity<si::time>>);
static_assert(Becomes<Quantity<si::time, float>, Quantity<si::time>>);
static_assert(!Becomes<Quantity<si::time>, Quantity<si::time, float>>);
static_assert(!Becomes<Quantity<si::time>, Quantity<si::time, int>>);
static_assert(std::constructible_from<Quantity<si::time, float>, Quantity<si::time>>);

// A number to the machine.
template <class S>
inline constexpr bool as_the_number =
    sizeof(Quantity<si::torque, S>) == sizeof(S) && alignof(Quantity<si::torque, S>) == alignof(S) &&
    std::is_trivially_copyable_v<Quantity<si::torque, S>> ==
        std::is_trivially_copyable_v<S>&& std::is_standard_layout_v<Quantity<si::torque, S>> ==
        std::is_standard_layout_v<S>;
using Batch = std::experimental::native_simd<double>;
using Dual = Eigen::AutoDiffScalar<Eigen::Vector2d>;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
static_assert(as_the_number<double> && as_the_number<float> && as_the_number<long double>);
static_assert(as_the_number<Batch> && as_the_number<Dual> && as_the_number<Wide>);
static_assert(std::is_trivially_copyable_v<Quantity<si::torque>>);

TEST(Quantity, takes_boost_quantities_in_and_gives_them_back) {
  const auto given = 3.0 * bu::si::meters;
  const Quantity<si::length> taken = given;
  EXPECT_EQ(taken.value(), 3.0);
  const bu::quantity<bu::si::length> back = taken;
  EXPECT_EQ(back.value(), 3.0);
  EXPECT_EQ((taken + given).value(), 6.0);
  const bu::quantity<bu::si::dimensionless> number = ratio;
  EXPECT_EQ(number.value(), 2.5);
  const auto speed = [](const Quantity<si::velocity>& v) { return v.value(); };
  EXPECT_EQ(speed(given / (2.0 * bu::si::seconds)), 1.5);

  EXPECT_EQ(vector(in<Body>, quantity(given), taken, taken).coordinates(), Eigen::Vector3d(3, 3, 3));
  static_assert(std::same_as<decltype(quantity(2.0f * bu::si::newton_meters)), Quantity<si::torque, float>>);
  static_assert(!Becomes<bu::quantity<bu::si::energy>, Quantity<si::torque>>);
  static_assert(!Becomes<bu::quantity<bu::si::length>, Quantity<si::length, float>>);
  static_assert(!Becomes<Quantity<si::energy>, bu::quantity<bu::si::torque>>);
}

TEST(Quantity, converts_exactly) {
  EXPECT_EQ(convert<si::length>(7000.0 * si::kilometre).value(), 7e6);
  EXPECT_EQ(convert<si::kilometre_unit>(7e6 * si::metre).value(), 7000.0);
  EXPECT_EQ(convert<si::time>(1.5 * si::hour).value(), 5400.0);
  EXPECT_EQ(convert<si::minute_unit>(2.0 * si::hour).value(), 120.0);
  EXPECT_EQ(convert<si::time>(250.0 * si::millisecond).value(), 0.25);
  EXPECT_EQ(convert<si::angle>(1.0 * si::degree).value(), std::numbers::pi / 180);
  EXPECT_EQ(convert<si::length>(2.0 * si::metre).value(), 2.0);
  EXPECT_DOUBLE_EQ(convert<si::velocity>(36.0 * si::kilometre / si::hour).value(), 10.0);
  EXPECT_DOUBLE_EQ(convert<si::angular_velocity>(60.0 * si::degree / si::hour).value(),
                   std::numbers::pi / 10800);
  EXPECT_FLOAT_EQ(convert<si::length>(7000.0f * si::kilometre).value(), 7e6f);
  EXPECT_TRUE(all_of(convert<si::length>(Batch(7.0) * si::kilometre).value() == Batch(7000.0)));
}

template <class S> void expect_arithmetic() {
  const S two(2), three(3);
  const auto same = [](const S& x, const S& y) { return detail::all(x == y); };
  const auto d = two * si::metre;
  const auto e = Quantity<si::length, S>::from_value(three);
  EXPECT_TRUE(same((d + e).value(), S(two + three)));
  EXPECT_TRUE(same((d - e).value(), S(two - three)));
  EXPECT_TRUE(same((-d).value(), S(-two)));
  EXPECT_TRUE(same((d * e).value(), S(two * three)));
  EXPECT_TRUE(same((d / e).value(), S(two / three)));
  EXPECT_TRUE(same((three * d).value(), S(two * three)));
  EXPECT_TRUE(same((d * three).value(), S(two * three)));
  EXPECT_TRUE(same((d / three).value(), S(two / three)));
  EXPECT_TRUE(same((three / d).value(), S(three / two)));
  EXPECT_TRUE(same((2 * d).value(), S(two * two)));
  EXPECT_TRUE(same((d / si::second * si::second).value(), two));
  auto x = d;
  x += e;
  x -= d;
  x *= two;
  x /= three;
  EXPECT_TRUE(same(x.value(), two));
  EXPECT_TRUE(detail::all(d < e) && detail::all(d <= e) && detail::all(e > d) && detail::all(e >= d));
  EXPECT_TRUE(detail::all(d == d) && detail::all(d != e));
  EXPECT_TRUE(same(Quantity<si::length, S>{}.value(), S(0)));
  static_assert(std::same_as<decltype(d), const Quantity<si::length, S>>);
  static_assert(std::same_as<decltype(d * e), Quantity<si::area, S>>);
  static_assert(std::same_as<decltype(three / d), Quantity<si::unit<-1, 0, 0>, S>>);
}

TEST(Quantity, computes_as_its_scalar_does) {
  expect_arithmetic<double>();
  expect_arithmetic<float>();
  expect_arithmetic<long double>();
  expect_arithmetic<Batch>();
  expect_arithmetic<std::experimental::native_simd<float>>();
  expect_arithmetic<Dual>();
  expect_arithmetic<Wide>();
}

TEST(Quantity, goes_with_a_wider_scalar) {
  static_assert(std::same_as<decltype(2.0 * (3.0f * si::metre)), Quantity<si::length>>);
  static_assert(std::same_as<decltype(60.0f * si::second * 0.5), Quantity<si::time>>);
  static_assert(std::same_as<decltype((2.0 * si::metre) * Batch(3)), Quantity<si::length, Batch>>);
  static_assert(
      std::same_as<decltype((2.0 * si::metre) / (Dual(3) * si::second)), Quantity<si::velocity, Dual>>);
  const auto speed = (2.0 * si::metre) / (Dual(4.0, Eigen::Vector2d(1, 0)) * si::second);
  EXPECT_EQ(speed.value().value(), 0.5);
  EXPECT_EQ(speed.value().derivatives().x(), -0.125);
}

// As whole numbers, 1 m / 2 s would be 0, and a quarter turn in radians 1.
TEST(Quantity, takes_whole_numbers_as_numbers) {
  EXPECT_EQ((1 * si::metre / (2 * si::second)).value(), 0.5);
  EXPECT_EQ((1 / (4 * si::second)).value(), 0.25);
  EXPECT_EQ(convert<si::angle>(90 * si::degree).value(), std::numbers::pi / 2);
}

TEST(Quantity, gives_its_number_in_another_unit) {
  constexpr double exact_to_roundings = 4e-16;
  EXPECT_NEAR((std::numbers::pi / 3 * si::radian).in(si::degree), 60.0, 60 * exact_to_roundings);
  EXPECT_NEAR((7.5 * si::kilometre / si::second).in(si::metre / si::second), 7500.0,
              7500 * exact_to_roundings);
  EXPECT_NEAR((2.0f * si::minute).in(si::second), 120.0f, 1e-5f);
  EXPECT_EQ((3.0 * si::metre).in(si::metre), 3.0);
  static_assert(std::same_as<decltype((2.0f * si::minute).in(si::second)), float>);
  const Dual turn(1.0, Eigen::Vector2d(1, 0));
  EXPECT_NEAR((turn * si::radian).in(si::degree).derivatives().x(), 180 / std::numbers::pi, 1e-13);
}

TEST(Quantity, has_a_magnitude) {
  EXPECT_EQ(abs(-2.0 * si::newton_metre), 2.0 * si::newton_metre);
  EXPECT_EQ(abs(2.0 * si::newton_metre), 2.0 * si::newton_metre);
}

TEST(Quantity, prints_its_unit) {
  std::ostringstream out;
  out << 7000.0 * si::kilometre << ", " << 2.0 * si::newton_metre << ", " << ratio << ", " << drift;
  EXPECT_EQ(out.str(), "7000 km, 2 N m, 2.5, 0.01 other units");
}

}  // namespace
}  // namespace quantity_test
