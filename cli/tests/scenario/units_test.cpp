#include "scenario/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "says.hpp"

namespace vectrix::cli::units_test {
namespace {

std::string refusal(std::string_view text, Dimension dimension, std::size_t count = 1) {
  try {
    (void)Amount::parse(text, dimension, count);
  } catch (const AmountError& error) {
    return std::to_string(error.at()) + ": " + error.what();
  }
  return "accepted";
}

TEST(Units, AreFactorsOfOneAnother) {
  constexpr double rounding = 1e-15;  // relative: two roundings of a factor
  const auto in = [](const char* text, Dimension dimension, const char* unit) {
    return Amount::parse(text, dimension).in(unit);
  };
  EXPECT_NEAR(in("180 deg", Dimension::angle, "rad"), std::numbers::pi, rounding * std::numbers::pi);
  EXPECT_NEAR(in("1 mrad", Dimension::angle, "rad"), 1e-3, rounding);
  EXPECT_NEAR(in("1 deg", Dimension::angle, "arcmin"), 60.0, 60.0 * rounding);
  EXPECT_NEAR(in("1 arcmin", Dimension::angle, "arcsec"), 60.0, 60.0 * rounding);
  EXPECT_NEAR(in("1 arcsec", Dimension::angle, "mas"), 1000.0, 1000.0 * rounding);
  EXPECT_EQ(in("1.5 min", Dimension::duration, "s"), 90.0);
  EXPECT_EQ(in("250 ms", Dimension::duration, "s"), 0.25);
  EXPECT_EQ(in("2 h", Dimension::duration, "min"), 120.0);
  EXPECT_EQ(in("1 day", Dimension::duration, "h"), 24.0);
  EXPECT_EQ(in("-0.4 km", Dimension::length, "m"), -400.0);
  EXPECT_NEAR(in("7 mm", Dimension::length, "m"), 7e-3, rounding);
  EXPECT_EQ(in("99.7 %", Dimension::share, "%"), 99.7);
}

TEST(Units, KeepTheNumberThatWasWritten) {
  EXPECT_EQ(Amount::parse("0.7 deg", Dimension::angle).in("deg"), 0.7);
  EXPECT_EQ(Amount::parse("+.7e0deg ", Dimension::angle).in("deg"), 0.7);
  EXPECT_EQ(Amount::parse("0.70 deg", Dimension::angle).text(), "0.70 deg");
  const auto several = Amount::parse("[6, -5.5,7 ] deg", Dimension::angle, 3);
  EXPECT_EQ(several.in("deg", 0), 6.0);
  EXPECT_EQ(several.in("deg", 1), -5.5);
  EXPECT_EQ(several.in("deg", 2), 7.0);
}

TEST(Units, SayWhereAnAmountIsWrong) {
  const std::string angles = "an angle takes: deg, rad, mrad, arcmin, arcsec, mas";
  EXPECT_EQ(refusal("0.5", Dimension::angle), "3: there is no unit; " + angles);
  EXPECT_EQ(refusal("0.5 degr", Dimension::angle), "4: 'degr' is no unit; the nearest is 'deg'; " + angles);
  EXPECT_EQ(refusal("0.5 furlong", Dimension::angle), "4: 'furlong' is no unit; " + angles);
  EXPECT_EQ(refusal("0.5 s", Dimension::angle), "4: 's' is a unit of a duration; " + angles);
  EXPECT_EQ(refusal("0.5 Deg", Dimension::angle), "4: 'Deg' is no unit; the nearest is 'deg'; " + angles);
  EXPECT_EQ(refusal("half a deg", Dimension::angle), "0: there is no number");
  EXPECT_EQ(refusal("", Dimension::angle), "0: there is no number");
  EXPECT_EQ(refusal("nan deg", Dimension::angle), "0: the number is not finite");
  EXPECT_EQ(refusal(" inf deg", Dimension::angle), "1: the number is not finite");
  EXPECT_EQ(refusal("1e999 deg", Dimension::angle), "0: the number is out of the range of doubles");
  EXPECT_EQ(refusal("[1, 2] deg", Dimension::angle, 3), "0: 3 numbers in brackets are needed, as [1, 2, 3]");
  EXPECT_EQ(refusal("1 deg", Dimension::angle, 3), "0: 3 numbers in brackets are needed, as [1, 2, 3]");
  EXPECT_EQ(refusal("[1, 2 3] deg", Dimension::angle, 3), "6: ',' or ']' is missing");
  EXPECT_EQ(refusal("[1, 2, x] deg", Dimension::angle, 3), "7: there is no number");
  EXPECT_EQ(refusal("[1, 2, 3]", Dimension::angle, 3), "9: there is no unit; " + angles);
}

}  // namespace
}  // namespace vectrix::cli::units_test
