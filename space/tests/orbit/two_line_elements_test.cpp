#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>

#include <vectrix/space/orbit/two_line_elements.hpp>

#include "orbit/check_sum.hpp"
#include "temporary_file.hpp"

namespace vectrix::two_line_elements_test {
namespace {

constexpr double pi = std::numbers::pi;
// A conversion of a unit rounds the number and the factor.
constexpr double conversion = 2 * std::numeric_limits<double>::epsilon();

const std::string line1 = "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753";
const std::string line2 = "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667";

// The line with other text from the column on, and its check sum.
std::string with(std::string line, std::size_t column, const std::string& text) {
  return summed(line.replace(column - 1, text.size(), text));
}
std::string complaint_of(const std::string& first, const std::string& second) {
  return complaint([&] { TwoLineElements::parse(first, second); });
}
double degrees(double x) {
  return x * pi / 180.0;
}

TEST(TwoLineElements, ValuesOfASet) {
  const auto set = TwoLineElements::parse(line1, line2);
  EXPECT_EQ(set.title(), "");
  EXPECT_EQ(set.catalogue_number(), 5);
  EXPECT_EQ(set.classification(), 'U');
  EXPECT_EQ(set.designator(), "58002B");
  EXPECT_EQ(set.element_set_number(), 475);
  EXPECT_EQ(set.revolution_number(), 41366);
  EXPECT_EQ(set.epoch().utc(), "2000-06-27T18:50:19.733568");
  const MeanElements& x = set.mean_elements();
  EXPECT_EQ(x.epoch, set.epoch());
  EXPECT_EQ(x.eccentricity, 0.1859667);
  const auto near = [](double value, double expected) {
    EXPECT_NEAR(value, expected, conversion * std::abs(expected));
  };
  near(x.inclination.value(), degrees(34.2682));
  near(x.ascending_node.value(), degrees(348.7242));
  near(x.argument_of_perigee.value(), degrees(331.7664));
  near(x.mean_anomaly.angle.value(), degrees(19.3264));
  near(x.mean_motion.value(), 10.82419157 * 2 * pi / 86400.0);
  near(x.bstar.value() * 6378135.0, 0.28098e-4);
  near(set.mean_motion_rate().value(), 2 * 0.00000023 * 2 * pi / 86400.0 / 86400.0);
  EXPECT_EQ(set.mean_motion_second_rate().value(), 0.0);
}

TEST(TwoLineElements, TitleAndTextBehindTheLine) {
  const auto set = TwoLineElements::parse("0 VANGUARD 1  ", line1 + "\r", line2 + "     0.00      4320.0");
  EXPECT_EQ(set.title(), "VANGUARD 1");
  EXPECT_EQ(TwoLineElements::parse("  VANGUARD 1", line1, line2).title(), "VANGUARD 1");
  EXPECT_EQ(set.catalogue_number(), 5);
}

// Any character, replaced by a digit that has not its place in the sum.
TEST(TwoLineElements, EveryColumnIsChecked) {
  for (const bool first : {true, false}) {
    for (std::size_t i = 0; i < 69; ++i) {
      std::string changed = first ? line1 : line2;
      const char was = changed[i];
      changed[i] = was >= '0' && was <= '9' ? static_cast<char>('0' + (was - '0' + 1) % 10) : '5';
      const auto text = first ? complaint_of(changed, line2) : complaint_of(line1, changed);
      const std::string place =
          first ? "two-line elements, line 1, column" : "two-line elements, line 2, column";
      EXPECT_EQ(text.substr(0, place.size()), place) << changed << ": " << text;
    }
  }
}

// Two digits exchanged keep the sum; a blank between fields lost by a shift does not pass.
TEST(TwoLineElements, FieldsOutOfPlace) {
  EXPECT_EQ(complaint_of("1 00005U 58002B  00179.784950620  .00000023  00000-0  28098-4 0  4753", line2),
            "two-line elements, line 1, column 18 (between two fields): '0': expected a blank");
  for (const std::size_t column : std::initializer_list<std::size_t>{2, 9, 18, 33, 44, 53, 62, 64}) {
    const auto text = complaint_of(with(line1, column, "7"), line2);
    EXPECT_NE(text.find("(between two fields)"), std::string::npos) << column << ": " << text;
  }
  for (const std::size_t column : std::initializer_list<std::size_t>{2, 8, 17, 26, 34, 43, 52}) {
    const auto text = complaint_of(line1, with(line2, column, "7"));
    EXPECT_NE(text.find("(between two fields)"), std::string::npos) << column << ": " << text;
  }
  EXPECT_EQ(complaint_of(line2, line1), "two-line elements, line 1, column 1 (line number): '2': expected 1");
  EXPECT_EQ(complaint_of(line1.substr(0, 68), line2),
            "two-line elements, line 1: there are 68 columns; line 1 of two-line elements has 69");
  EXPECT_EQ(complaint_of(line1, ""),
            "two-line elements, line 2: there are 0 columns; line 2 of two-line elements has 69");
  EXPECT_EQ(complaint_of(line1.substr(0, 68) + "4", line2),
            "two-line elements, line 1, column 69 (check sum): '4': the digits before it give 3");
  EXPECT_EQ(complaint_of(with(line1, 24, "\t"), line2).substr(0, 36), "two-line elements, line 1, column 24");
}

TEST(TwoLineElements, CatalogueNumbers) {
  const auto number = [](const std::string& written) {
    return TwoLineElements::parse(with(line1, 3, written), with(line2, 3, written)).catalogue_number();
  };
  EXPECT_EQ(number("    5"), 5);
  EXPECT_EQ(number("99999"), 99999);
  EXPECT_EQ(number("A0000"), 100000);
  EXPECT_EQ(number("E8493"), 148493);
  EXPECT_EQ(number("H0000"), 170000);
  EXPECT_EQ(number("J2931"), 182931);
  EXPECT_EQ(number("N0000"), 220000);
  EXPECT_EQ(number("P4018"), 234018);
  EXPECT_EQ(number("Z9999"), 339999);
  for (const char* wrong : {"I0000", "O0000", "a0000", "AA000", "A 000", "     ", "0005 ", "-0005", "00O05"})
    EXPECT_THROW(number(wrong), BadInput) << wrong;
  EXPECT_EQ(complaint_of(line1, with(line2, 3, "00006")),
            "two-line elements, line 2, columns 3-7 (catalogue number): '00006': line 1 is of 00005");
}

TEST(TwoLineElements, Epochs) {
  const auto epoch = [](const std::string& written) {
    return TwoLineElements::parse(with(line1, 19, written), line2).epoch().utc();
  };
  EXPECT_EQ(epoch("60001.00000000"), "1960-01-01T00:00:00.000000");
  EXPECT_EQ(epoch("99365.50000000"), "1999-12-31T12:00:00.000000");
  EXPECT_EQ(epoch("00366.25000000"), "2000-12-31T06:00:00.000000");
  EXPECT_EQ(epoch("56  1.75000000"), "2056-01-01T18:00:00.000000");
  EXPECT_EQ(epoch("24060.00000001"), "2024-02-29T00:00:00.000864");
  // A day of 86401 s.
  EXPECT_EQ(epoch("16366.50000000"), "2016-12-31T12:00:00.500000");
  for (const char* wrong : {"01366.00000000", "01000.99999999", "00367.00000000", "-1001.00000000"})
    EXPECT_THROW(epoch(wrong), BadInput) << wrong;
  EXPECT_EQ(
      complaint_of(with(line1, 19, "01366.00000000"), line2),
      "two-line elements, line 1, columns 21-32 (day of the year): '366.00000000': the year 2001 has the "
      "days 1 to 365");
  // Vanguard's own years are before UTC.
  const auto before = complaint_of(with(line1, 19, "58179.78495062"), line2);
  EXPECT_EQ(before.substr(0, 53), "two-line elements, line 1, columns 19-32 (epoch): '58") << before;
  EXPECT_NE(before.find("1960"), std::string::npos) << before;
}

TEST(TwoLineElements, NumbersWithExponents) {
  const auto bstar = [](const std::string& written) {
    return TwoLineElements::parse(with(line1, 54, written), line2).mean_elements().bstar.value() * 6378135.0;
  };
  const auto near = [](double value, double expected) {
    EXPECT_NEAR(value, expected, 2 * conversion * std::abs(expected));
  };
  near(bstar("-11606-4"), -0.11606e-4);
  near(bstar("+11606-4"), 0.11606e-4);
  near(bstar(" 12345+1"), 1.2345);
  near(bstar(" 12345-0"), 0.12345);
  near(bstar(" 00000+0"), 0.0);
  for (const char* wrong :
       {" 1234 -4", " 12345 4", " 12345-a", ".12345-4", "  2345-4", " 1.345-4", "        "})
    EXPECT_THROW(bstar(wrong), BadInput) << wrong;
  EXPECT_EQ(complaint_of(with(line1, 54, " 12345 4"), line2),
            "two-line elements, line 1, columns 54-61 (B*): ' 12345 4': not a number as 28098-4, 0.28098e-4");
  const auto set = TwoLineElements::parse(with(with(line1, 34, "-.00002182"), 45, "-12345-6"), line2);
  near(set.mean_motion_rate().value(), -2 * 0.00002182 * 2 * pi / 86400.0 / 86400.0);
  near(set.mean_motion_second_rate().value(), -6 * 0.12345e-6 * 2 * pi / 86400.0 / 86400.0 / 86400.0);
}

TEST(TwoLineElements, NumbersOutOfRange) {
  EXPECT_EQ(complaint_of(line1, with(line2, 9, "180.2682")),
            "two-line elements, line 2, columns 9-16 (inclination): '180.2682': not in [0, 180]");
  EXPECT_EQ(complaint_of(line1, with(line2, 18, "-48.7242")),
            "two-line elements, line 2, columns 18-25 (ascending node): '-48.7242': not in [0, 360]");
  EXPECT_EQ(
      complaint_of(line1, with(line2, 27, " 859667")),
      "two-line elements, line 2, columns 27-33 (eccentricity): ' 859667': not the digits behind a decimal "
      "point");
  for (const char* wrong :
       {"     nan", "     inf", "  1e-002", "   0x1.0", "        ", "33 .7664", "360.0001"})
    EXPECT_THROW(TwoLineElements::parse(line1, with(line2, 35, wrong)), BadInput) << wrong;
  EXPECT_THROW(TwoLineElements::parse(line1, with(line2, 44, "361.0000")), BadInput);
  EXPECT_THROW(TwoLineElements::parse(line1, with(line2, 53, " 0.00000000")), BadInput);
  EXPECT_THROW(TwoLineElements::parse(line1, with(line2, 53, "20.10000000")), BadInput);
  EXPECT_THROW(TwoLineElements::parse(line1, with(line2, 64, "4136x")), BadInput);
}

// The sets of the verification end at .99999999 in columns 34-43 and 0.00027 in 45-52; a foil has B* 20.
TEST(TwoLineElements, NumbersOfNoOrbit) {
  const auto first = [](std::size_t column, const std::string& written) {
    return complaint_of(with(line1, column, written), line2);
  };
  EXPECT_EQ(first(54, " 10000+9"),
            "two-line elements, line 1, columns 54-61 (B*): ' 10000+9': not in [-100, 100]");
  EXPECT_EQ(first(54, "-10001+3"),
            "two-line elements, line 1, columns 54-61 (B*): '-10001+3': not in [-100, 100]");
  EXPECT_EQ(first(54, "-10000+3"), "nothing was thrown");
  EXPECT_EQ(
      first(34, "9999.00000"),
      "two-line elements, line 1, columns 34-43 (half the derivative of the mean motion): '9999.00000': "
      "not in [-1, 1]");
  EXPECT_EQ(first(34, "-.99999999"), "nothing was thrown");
  EXPECT_EQ(first(45, "-10001+1"),
            "two-line elements, line 1, columns 45-52 (a sixth of the second derivative of the mean motion): "
            "'-10001+1': not in [-1, 1]");
  EXPECT_EQ(first(45, " 99999-0"), "nothing was thrown");
  const auto motion = [](const std::string& written) {
    return complaint_of(line1, with(line2, 53, written));
  };
  EXPECT_EQ(motion("17.00000001"),
            "two-line elements, line 2, columns 53-63 (mean motion): '17.00000001': not in [0, 17]");
  EXPECT_EQ(motion("-1.00000000"),
            "two-line elements, line 2, columns 53-63 (mean motion): '-1.00000000': not in [0, 17]");
  EXPECT_EQ(motion("17.00000000"), "nothing was thrown");
}

TEST(TwoLineElements, KindsOfSets) {
  for (const char* kind : {" ", "0", "2", "3"})
    EXPECT_NO_THROW(TwoLineElements::parse(with(line1, 63, kind), line2)) << kind;
  EXPECT_EQ(
      complaint_of(with(line1, 63, "4"), line2),
      "two-line elements, line 1, column 63 (type of the elements): '4': the elements are of another theory "
      "than SGP4 and SDP4");
  for (const char* secrecy : {" ", "C", "S"})
    EXPECT_EQ(TwoLineElements::parse(with(line1, 8, secrecy), line2).classification(), secrecy[0]);
  EXPECT_THROW(TwoLineElements::parse(with(line1, 8, "X"), line2), BadInput);
  EXPECT_EQ(TwoLineElements::parse(with(line1, 10, "        "), line2).designator(), "");
}

std::string refused_file(const std::string& content) {
  const TemporaryFile file(content);
  return complaint([&] { TwoLineElements::read(file.path()); }, file.path());
}

TEST(TwoLineElements, FilesOfManySets) {
  const std::string other1 = with(line1, 3, "00006"), other2 = with(line2, 3, "00006");
  const TemporaryFile file("# comment\r\n\r\n" + line1 + "\r\n" + line2 + "\r\n0 VANGUARD 2\r\n" + other1 +
                           "\r\n# between the lines\r\n" + other2 + "  behind\r\n\r\nVANGUARD 3\r\n" + line1 +
                           "\r\n" + line2);
  const auto sets = TwoLineElements::read(file.path());
  ASSERT_EQ(sets.size(), 3U);
  EXPECT_EQ(sets[0].title(), "");
  EXPECT_EQ(sets[1].title(), "VANGUARD 2");
  EXPECT_EQ(sets[1].catalogue_number(), 6);
  EXPECT_EQ(sets[2].title(), "VANGUARD 3");

  EXPECT_EQ(refused_file(line1 + "\n" + line2 + "\n\n" + line1 + "\n" + other2 + "\n"),
            "two-line elements FILE, line 5, columns 3-7 (catalogue number): '00006': line 1 is of 00005");
  EXPECT_EQ(refused_file("A\n" + line1 + "\n" + line1 + "\n"),
            "two-line elements FILE, line 3, column 1 (line number): '1': expected 2");
  EXPECT_EQ(refused_file("A\nB\n" + line1 + "\n" + line2 + "\n"),
            "two-line elements FILE, line 2: there are 1 columns; line 1 of two-line elements has 69");
  EXPECT_EQ(refused_file(line2 + "\n"),
            "two-line elements FILE, line 1: line 2 of a set without line 1 before it");
  EXPECT_EQ(refused_file(line1 + "\n" + line2 + "\n" + line1 + "\n"),
            "two-line elements FILE, line 3: the file ends within a set");
  EXPECT_EQ(refused_file(line1 + "\n" + line2 + "\nA\n"),
            "two-line elements FILE, line 3: the file ends within a set");
  EXPECT_EQ(refused_file("# nothing\n"), "two-line elements FILE: there is no set of elements");
  EXPECT_EQ(complaint([] { TwoLineElements::read("/no/such/file"); }),
            "two-line elements /no/such/file: cannot be read");
}

}  // namespace
}  // namespace vectrix::two_line_elements_test
