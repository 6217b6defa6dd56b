#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "temporary_file.hpp"

namespace vectrix::csv_table_test {
namespace {

struct Station : moving_frame {};

CsvTable read(const std::string& content) {
  return CsvTable::read(TemporaryFile(content).path(), {"t", "x"});
}

// The error text from reading the content and then all its numbers.
std::string refusal(const std::string& content) {
  const TemporaryFile file(content);
  return complaint(
      [&] {
        const auto table = CsvTable::read(file.path(), {"t", "x"});
        for (std::size_t row = 0; row < table.rows(); ++row) {
          for (const auto& column : table.columns()) (void)table.number(row, column);
        }
      },
      file.path());
}

TEST(CsvTable, ReadsNumbersAndTextByName) {
  const auto table = read("# a comment\nx,name,t\n1.5e-3, Rigel ,2\n-4,b,+3\n");
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"x", "name", "t"}));
  EXPECT_EQ(table.number(0, "x"), 1.5e-3);
  EXPECT_EQ(table.number(0, "t"), 2.0);
  EXPECT_EQ(table.number(1, "x"), -4.0);
  EXPECT_EQ(table.number(1, "t"), 3.0);
  EXPECT_EQ(table.text(0, "name"), "Rigel");
}

TEST(CsvTable, MayEndWithEmptyLines) {
  for (const char* const end : {"\n", "\n \n\r\n"})
    EXPECT_EQ(read(std::string("t,x\n1,2\n") + end).rows(), 1U);
}

TEST(CsvTable, ShiftsTheDecimalPointOfATextWithoutRoundingTwice) {
  TemporaryFile file("a,b,c\n6778.0669,-1.1e-3,1e308\n");
  const auto table = CsvTable::read(file.path(), {});
  EXPECT_EQ(table.number(0, "a", 3), 6778066.9);
  EXPECT_NE(table.number(0, "a") * 1000.0, 6778066.9);
  EXPECT_EQ(table.number(0, "b", 3), -1.1);
  EXPECT_EQ(complaint([&] { (void)table.number(0, "c", 3); }, file.path()),
            "table FILE, line 2, column 3 ('c'): '1e308' times 10^3: in SI units too large or too small for "
            "a double, 5e-324 to 1.8e308");
}

TEST(CsvTable, ShiftsByAnyPowerOfTen) {
  const TemporaryFile file("a,b\n1.5,0\n");
  const auto table = CsvTable::read(file.path(), {});
  for (const int shift : {22, 23, 24, 30, 300, -21, -22, -23, -30, -300})
    EXPECT_EQ(table.number(0, "a", shift), std::stod("1.5e" + std::to_string(shift))) << shift;
  constexpr int most = std::numeric_limits<int>::max();
  for (const int shift : {400, most, -400, -most}) {
    EXPECT_EQ(table.number(0, "b", shift), 0.0);
    EXPECT_EQ(complaint([&] { return table.number(0, "a", shift); }, file.path()),
              "table FILE, line 2, column 1 ('a'): '1.5' times 10^" + std::to_string(shift) +
                  ": in SI units too large or too small for a double, 5e-324 to 1.8e308");
  }
  const std::string zeros(100, '0');
  const TemporaryFile long_file("a\n1." + zeros + "\n");
  EXPECT_EQ(
      complaint([&] { return CsvTable::read(long_file.path(), {}).number(0, "a", 3); }, long_file.path()),
      "table FILE, line 2, column 1 ('a'): '1." + zeros +
          "' times 10^3: a number of more than 100 characters");
}

TEST(CsvTable, ReadsLinesThatEndWithCarriageReturn) {
  const auto table = read("t,x\r\n1,2\r\n");
  EXPECT_EQ(table.number(0, "x"), 2.0);
}

TEST(CsvTable, ReadsPastAByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBF# a comment\nt,x\n1,2\n").number(0, "t"), 1.0);
}

TEST(CsvTable, RefusesWhatItsReaderCannotUse) {
  const TemporaryFile file("# a comment\nt,x\n1,2\n0,3\n");
  const auto table = CsvTable::read(file.path(), {"t", "x"});
  EXPECT_EQ(complaint([&] { table.refuse(1, "t", "0 is not after the row before"); }, file.path()),
            "table FILE, line 4, column 1 ('t'): 0 is not after the row before");
  EXPECT_THROW(table.refuse(2, "t", ""), CsvError);
}

TEST(CsvTable, MayHaveNoRows) {
  EXPECT_EQ(read("t,x\n").rows(), 0U);
}

TEST(CsvTable, ReadsVectors) {
  const TemporaryFile file("x_m,y_m,z_m\n1,2,3\n4,5,nan\n");
  const auto table = CsvTable::read(file.path(), {"x_m", "y_m", "z_m"});
  const Vector<Station, si::length> r = read_vector<si::length>(in<Station>, table, 0, {"x_m", "y_m", "z_m"});
  EXPECT_EQ(r.coordinates(), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_THROW(read_vector<si::length>(in<Station>, table, 1, {"x_m", "y_m", "z_m"}), CsvError);
}

TEST(CsvTable, RefusesAMissingFile) {
  EXPECT_EQ(complaint([] { CsvTable::read("/nowhere/orbit.csv", {"t"}); }),
            "table /nowhere/orbit.csv: cannot be read");
  const auto folder = std::filesystem::temp_directory_path();
  EXPECT_EQ(complaint([&] { CsvTable::read(folder, {"t"}); }, folder), "table FILE: cannot be read");
}

TEST(CsvTable, RefusesAnEmptyFile) {
  EXPECT_EQ(refusal(""), "table FILE: is empty, not even a header line");
  EXPECT_EQ(refusal("# only a comment\n"), "table FILE: is empty, not even a header line");
}

TEST(CsvTable, RefusesAWrongHeader) {
  EXPECT_EQ(refusal("# a comment\nt,y\n"), "table FILE, line 2: no column 'x' in the header 't,y'");
  EXPECT_EQ(refusal("t,x,t\n"), "table FILE, line 1, column 3 ('t'): column 1 has the same name");
  EXPECT_EQ(refusal("t,,x\n"), "table FILE, line 1, column 2 (''): the column has no name");
}

TEST(CsvTable, RefusesAWrongNumberOfFields) {
  EXPECT_EQ(refusal("t,x\n1,2\n3\n"), "table FILE, line 3, column 2 ('x'): 1 fields instead of 2");
  EXPECT_EQ(refusal("t,x\n1,1.5D-03\n"),
            "table FILE, line 2, column 2 ('x'): '1.5D-03' is not a number; its exponent has the letter D, "
            "where E is "
            "needed");
  EXPECT_EQ(refusal("t,x\n1,2,3\n"), "table FILE, line 2, column 4: 3 fields instead of 2");
  for (const char* const table : {"t,x\n1,2\n\n3,4\n", "t,x\n1,2\n \n3,4\n\n"})
    EXPECT_EQ(refusal(table),
              "table FILE, line 3: the line is empty; a table has empty lines at its end only");
}

TEST(CsvTable, RefusesWhatIsNotAFiniteNumber) {
  for (const std::string wrong : {"abc", "1.5x", "1 2", "0x10", "--1", "+-1", "1,5e", ""}) {
    const std::string field = wrong.substr(wrong.find(',') + 1);
    EXPECT_EQ(refusal("t,x\n1,2\n3," + field + "\n"),
              "table FILE, line 3, column 2 ('x'): '" + field + "' is not a number");
  }
  for (const std::string wrong : {"nan", "inf", "-inf", "-nan"}) {
    EXPECT_EQ(refusal("t,x\n" + wrong + ",2\n"),
              "table FILE, line 2, column 1 ('t'): '" + wrong + "' is not a finite number");
  }
  for (const std::string wrong : {"1e999", "-1e999", "1e-400", "+1e-400"}) {
    EXPECT_EQ(refusal("t,x\n" + wrong + ",2\n"),
              "table FILE, line 2, column 1 ('t'): '" + wrong +
                  "': too large or too small for a double, 5e-324 to 1.8e308");
  }
}

TEST(CsvTable, RefusesATruncatedFile) {
  EXPECT_EQ(
      refusal("t,x\n1,2\n3,4"),
      "table FILE, line 3, column 2 ('x'): the last line has no line end; if the file is complete, add one");
  EXPECT_EQ(refusal("t,x\n1,2\n3"), "table FILE, line 3, column 2 ('x'): 1 fields instead of 2");
  EXPECT_EQ(
      refusal("t,x"),
      "table FILE, line 1, column 2 ('x'): the last line has no line end; if the file is complete, add one");
}

TEST(CsvTable, RefusesQuotationMarks) {
  EXPECT_EQ(refusal("t,x\n1,\"2\"\n"),
            "table FILE, line 2, column 2 ('x'): quotation marks are not supported");
}

TEST(CsvTable, SaysWhereAValueCannotBeMade) {
  const TemporaryFile file("t,x\n2022-04-14T10:22:11,2\nnoon,3\n");
  const auto table = CsvTable::read(file.path(), {});
  EXPECT_EQ(table.value(0, "t", Epoch::from_utc), Epoch::from_utc("2022-04-14T10:22:11"));
  EXPECT_EQ(complaint([&] { (void)table.value(1, "t", Epoch::from_utc); }, file.path()),
            "table FILE, line 3, column 1 ('t'): " + complaint([] { (void)Epoch::from_utc("noon"); }));
  // An error that already says where is not said twice.
  const auto number = [&](const std::string&) { return table.number(1, "t"); };
  EXPECT_EQ(complaint([&] { (void)table.value(1, "x", number); }, file.path()),
            "table FILE, line 3, column 1 ('t'): 'noon' is not a number");
}

TEST(CsvTable, RefusesToAnswerForWhatItDoesNotHave) {
  const TemporaryFile file("t,x\n1,2\n");
  const auto table = CsvTable::read(file.path(), {});
  EXPECT_EQ(complaint([&] { (void)table.number(0, "y"); }, file.path()),
            "table FILE: asked for a column 'y', which it does not have");
  EXPECT_EQ(complaint([&] { (void)table.text(1, "x"); }, file.path()), "table FILE: asked for row 1 of 1");
}

}  // namespace
}  // namespace vectrix::csv_table_test
