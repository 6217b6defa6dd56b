#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vectrix/space.hpp>

#include "damage.hpp"
#include "temporary_file.hpp"

// Text kernels: their syntax, their dates, and the leap seconds of one.
namespace vectrix::text_kernel_test {
namespace {

const std::filesystem::path data = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data";

std::string refused(const std::string& data_block) {
  return complaint([&] { static_cast<void>(TextKernel::parse("\\begindata\n" + data_block)); });
}

TEST(TextKernel, HasNumbersTextsAndDates) {
  const auto kernel = TextKernel::parse(R"(KPL/XX
A comment: NAME = 'not read'
   \begindata
   ONE = 1  TWO=-2.5D+3 THREE   = ( 1.0, 2e2
       -3d-1 ) FOUR = (+4)
FIVE = ( 'it''s' 'a, (b) = c' '' )
FIVE += 'more'
SIX=
  @1972-JAN-1
ONE = ( 10 )
ONE += ( 11, @2000-01-01/12:00:01 )
\begintext
ONE = 99
\begindata
  \begindata
SEVEN = -152950000
)");
  EXPECT_EQ(kernel.numbers("TWO"), std::vector<double>{-2500.0});
  EXPECT_EQ(kernel.numbers("THREE"), (std::vector<double>{1.0, 200.0, -0.3}));
  EXPECT_EQ(kernel.number("FOUR"), 4.0);
  EXPECT_EQ(kernel.integer("SEVEN"), -152950000);
  const auto& five = kernel.variable("FIVE").values;
  ASSERT_EQ(five.size(), 4U);
  EXPECT_EQ(five[0].text, "it's");
  EXPECT_EQ(five[1].text, "a, (b) = c");
  EXPECT_EQ(five[2].text, "");
  EXPECT_EQ(five[3].text, "more");
  EXPECT_EQ(kernel.variable("SIX").values.front().text, "1972-JAN-1");
  const auto& one = kernel.variable("ONE").values;
  ASSERT_EQ(one.size(), 3U);
  EXPECT_EQ(one[0].number, 10.0);
  EXPECT_EQ(kernel.seconds(one[2]), 1.0);
  EXPECT_EQ(one[2].line, 11U);
  EXPECT_EQ(one[2].column, 14U);
  EXPECT_EQ(kernel.variables().size(), 7U);
  EXPECT_EQ(kernel.find("NAME"), nullptr);
}

TEST(TextKernel, ReadsTheDatesOfRealKernels) {
  const auto seconds = [](const std::string& date) {
    const auto kernel = TextKernel::parse("\\begindata\nX = @" + date + "\n");
    return kernel.seconds(kernel.variable("X").values.front());
  };
  constexpr double day = 86400.0;
  for (const char* const same : {"2017-06-21/17:09:38", "2017-JUN-21/17:09:38.0", "21-JUN-2017/17:09:38",
                                 "2017-06-21T17:09:38", "2017-JUNE-21-17:09:38", "2017/06/21//17:09:38"})
    EXPECT_EQ(seconds(same), 6380.5 * day + 17.0 * 3600.0 + 9.0 * 60.0 + 38.0) << same;
  EXPECT_EQ(seconds("1980-JAN-06-00:00:00.000"), -7300.5 * day);
  EXPECT_EQ(seconds("1972-JAN-1"), -10227.5 * day);
  EXPECT_EQ(seconds("2016-12-31/23:59:59.5"), seconds("2017-01-01") - 0.5);
  for (const char* const wrong :
       {"2017-06-31", "2017-13-01", "2017-FOO-01", "17-06-21", "2017-06-21/24:00:00", "2017-06-21/00:60:00",
        "2017-06-21/00:00:60", "2017-06", "2017-06-21/1:2:3:4", "2017-06-2x", "2017-06-21/12.5:00:00"})
    EXPECT_THROW(seconds(wrong), BadInput) << wrong;
}

TEST(TextKernel, IsRefusedWithLineAndColumn) {
  EXPECT_EQ(refused("A = 1 B\n"), "text kernel, line 2, column 8: '': = or += is expected");
  EXPECT_EQ(refused(" A 1\n"), "text kernel, line 2, column 4: '1': = or += is expected");
  EXPECT_EQ(refused("= 1\n"), "text kernel, line 2, column 1: '= 1': the name of a variable is expected");
  EXPECT_EQ(refused("A = ( 1, 2\n\n\\begintext\n"),
            "text kernel, line 2, column 1: the values of 'A' have no ')'");
  EXPECT_EQ(refused("A = ( )"), "text kernel, line 2, column 1: the variable 'A' has no value");
  EXPECT_EQ(refused("A =\n\\begintext"), "text kernel, line 2, column 1: the variable 'A' has no value");
  EXPECT_EQ(refused("A = 'x\n'"), "text kernel, line 2, column 5: the text 'x' has no end in its line");
  EXPECT_EQ(refused("A = ( 1,\n  'x' )"),
            "text kernel, line 3, column 3: the variable 'A' has numbers and texts");
  EXPECT_EQ(refused("A = 'x'\nA += 1"),
            "text kernel, line 3, column 6: the variable 'A' has numbers and texts");
  EXPECT_EQ(refused("A = nan"),
            "text kernel, line 2, column 5: 'nan' is not a finite number, a date or a text");
  EXPECT_EQ(refused("A = 1e999"),
            "text kernel, line 2, column 5: '1e999' is not a finite number, a date or a text");
  EXPECT_EQ(refused("A = one"),
            "text kernel, line 2, column 5: 'one' is not a finite number, a date or a text");
  EXPECT_EQ(refused("A = 1 \\begintext"),
            "text kernel, line 2, column 7: '\\begintext' is neither \\begindata nor \\begintext");
  EXPECT_EQ(refused("\\beginfoo"),
            "text kernel, line 2, column 1: '\\beginfoo' is neither \\begindata nor \\begintext");
  EXPECT_EQ(
      refused(std::string(33, 'A') + " = 1"),
      "text kernel, line 2, column 1: the name '" + std::string(33, 'A') + "' has more than 32 characters");
  EXPECT_EQ(complaint([] { static_cast<void>(TextKernel::read("no such file")); }),
            "text kernel no such file: cannot be read");
}

TEST(TextKernel, DamagedIsReadOrRefused) {
  const std::string good =
      "\\begindata\nA = ( 1, -2.5D3 @2000-JAN-1 )\nB += 'it''s'\n\\begintext\nx\n\\begindata\nB += 'y'\n";
  Damage damage(20261128);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::string text = damage.of(good);
    try {
      const auto kernel = TextKernel::parse(text);
      for (const auto& [name, variable] : kernel.variables()) EXPECT_FALSE(variable.values.empty()) << text;
      ++accepted;
    } catch (const BadInput& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("text kernel, line ")) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(LeapSecondKernel, HasTheTableOfTheProcess) {
  const auto table = read_leap_second_kernel(data / "naif0012.tls");
  EXPECT_EQ(table.size(), 28U);
  EXPECT_EQ(table.front(), (LeapSecond{1972, 1, 10}));
  EXPECT_EQ(table.back(), (LeapSecond{2017, 1, 37}));
  auto known = leap_seconds();
  known.resize(std::min(known.size(), table.size()));
  EXPECT_EQ(table, known);
}

TEST(LeapSecondKernel, IsRefusedWhereItIsWrong) {
  const auto with = [](const std::string& delta_at, const std::string& k = "1.657D-3") {
    return complaint([&] {
      static_cast<void>(leap_seconds_of(TextKernel::parse(
          "\\begindata\nDELTET/DELTA_T_A = 32.184 DELTET/K = " + k +
          " DELTET/EB = 1.671D-2 DELTET/M = ( 6.239996D0 1.99096871D-7 )\nDELTET/DELTA_AT = ( " + delta_at +
          " )\n")));
    });
  };
  EXPECT_EQ(with("10, @1972-JAN-1"), "nothing was thrown");
  EXPECT_EQ(with("10, @1972-JAN-1, 11"),
            "text kernel, line 3: the variable 'DELTET/DELTA_AT' has 3 values, which are no pairs");
  EXPECT_EQ(with("10.5, @1972-JAN-1"),
            "text kernel, line 3, column 21: a whole number of seconds is expected");
  EXPECT_EQ(with("10, @1972-JAN-2"),
            "text kernel, line 3, column 25: '1972-JAN-2' is not the first of a month");
  EXPECT_EQ(with("10, @1972-JAN-1/1:00"),
            "text kernel, line 3, column 25: the date of a midnight is expected");
  EXPECT_EQ(with("10, 11"), "text kernel, line 3, column 25: the date of a midnight is expected");
  EXPECT_EQ(with("10, @1972-JAN-1", "1.658D-3"),
            "text kernel, line 2: the variable 'DELTET/K' is 0.001658 and not 0.001657");
}

}  // namespace
}  // namespace vectrix::text_kernel_test
