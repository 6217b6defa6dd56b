#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

#include "temporary_file.hpp"

// The file of the Earth's orientation: what is read of it, and what is refused.
namespace vectrix::finals2000a_test {
namespace {

const std::filesystem::path source{VECTRIX_SOURCE_DIR};
const auto april_2022 = source / "examples/data/finals2000A_april_2022.txt";
constexpr double arcsecond = 4.84813681109536e-6;  // rad

// Its columns are the same, but its nutation is dPsi, dEps from IAU 1980: 3 m at the surface in 2022.
TEST(Finals2000AFile, OfAnotherModelIsRefused) {
  const std::filesystem::path data = source / "space/tests/data";
  const auto in_2022 = complaint([&] { EarthOrientation::read(data / "finals_all_2022.txt"); });
  EXPECT_NE(in_2022.find("columns 98-106 (dX): -105.062 and -9.348 milliarcseconds are offsets of the pole "
                         "from IAU 1980"),
            std::string::npos)
      << in_2022;
  EXPECT_NE(in_2022.find("line 3: "), std::string::npos) << in_2022;
  EXPECT_NE(in_2022.find("read finals2000A"), std::string::npos) << in_2022;
  const auto in_1973 = complaint([&] { EarthOrientation::read(data / "finals_all_1973.txt"); });
  EXPECT_NE(in_1973.find("milliarcseconds are offsets of the pole from IAU 1980"), std::string::npos)
      << in_1973;
}

// Four rows of 1982, made of those of 2022: the offsets of both models are within the errors of that time.
TEST(Finals2000AFile, OfAnUnclearModelIsRefusedUnlessTheCallerKnows) {
  std::string rows;
  std::ifstream in(april_2022);
  int day = 45000;
  for (std::string line; day < 45004 && std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    line.replace(7, 5, std::to_string(day++));
    rows += line.replace(97, 9, "    2.100").replace(116, 9, "   -1.600") + '\n';
  }
  const TemporaryFile file(rows);
  const auto refusal = complaint([&] { EarthOrientation::read(file.path()); }, file.path());
  EXPECT_EQ(
      refusal,
      "Earth orientation FILE, line 1: columns 98-106 (dX): 2.1 and -1.6 milliarcseconds may be offsets "
      "of the pole from IAU 2006/2000A, or from IAU 1980, as finals.all has them in these columns: these "
      "rows do not tell; if the file is finals2000A, say offsets_from_iau_2006");
  const auto claimed = EarthOrientation::read(file.path(), offsets_from_iau_2006);
  EXPECT_NEAR(claimed.parameters(claimed.first()).dX.value(), 2.1e-3 * arcsecond, 1e-9 * arcsecond);
  // What the rows do tell, no word changes.
  EXPECT_THROW(EarthOrientation::read(source / "space/tests/data/finals_all_2022.txt", offsets_from_iau_2006),
               BadInput);
}

class Finals2000A : public ::testing::Test {
 protected:
  Finals2000A() {
    std::ifstream in(april_2022);
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with('#')) lines.push_back(line);
    }
  }

  // Overwrites columns of a line; both are counted from 1.
  void write(std::size_t line, std::size_t column, const std::string& text) {
    lines[line - 1].replace(column - 1, text.size(), text);
  }

  [[nodiscard]] std::string content() const {
    std::ostringstream out;
    for (const auto& line : lines) out << line << '\n';
    return out.str();
  }

  [[nodiscard]] std::string refusal() const { return refusal(content()); }
  [[nodiscard]] static std::string refusal(const std::string& content) {
    const TemporaryFile file(content);
    return complaint([&] { EarthOrientation::read(file.path()); }, file.path());
  }

  std::vector<std::string> lines;
};

TEST_F(Finals2000A, ANumberThatStandsForNoneIsRefused) {
  write(3, 19, "999.99000");
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 3: columns 19-27 (x): 999.99 arcsec is more than 60 arcsec");
}

// Wherever rows of finals.all stand among those of finals2000A, the first of them is named.
TEST_F(Finals2000A, ARowOfFinalsAllIsRefusedWhereverItStands) {
  const std::vector<std::string> own = lines;
  for (std::size_t first = 1; first <= own.size(); ++first) {
    for (std::size_t last = first; last <= own.size(); ++last) {
      lines = own;
      for (std::size_t line = first; line <= last; ++line) {
        write(line, 98, " -105.062");
        write(line, 117, "   -9.348");
      }
      EXPECT_EQ(refusal(),
                "Earth orientation FILE, line " + std::to_string(first) +
                    ": columns 98-106 (dX): -105.062 and -9.348 milliarcseconds are offsets of the "
                    "pole from IAU 1980, as finals.all has them in these columns, not from IAU "
                    "2006/2000A; read finals2000A");
    }
  }
}

TEST_F(Finals2000A, AJumpOfTheOffsetsIsRefused) {
  write(4, 98, "    5.328");
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 4: columns 98-106 (dX): 5.328 and -0.128 milliarcseconds differ by "
            "4.993032445318176 from the row before; those of one series change by at most 3 in a day");
  write(4, 98, "    2.328");  // unusual, not impossible
  EXPECT_EQ(refusal(), "nothing was thrown");
}

// A digit of x or y that was damaged moves the ground: 3 arcsec by 93 m.
TEST_F(Finals2000A, AJumpOfThePoleIsRefused) {
  const auto whole = lines;
  write(4, 19, " 3");
  const auto said = refusal();
  EXPECT_TRUE(said.starts_with("Earth orientation FILE, line 4: columns 19-27 (x): 3")) << said;
  EXPECT_TRUE(said.ends_with(" from the row before; the pole moves by at most 0.015 in a day")) << said;
  // From one row to the next it moves by less than 2 milliarcsec in this file.
  const auto moved = [&](std::size_t line, std::size_t column, double by) {
    lines = whole;
    std::ostringstream number;
    number << std::fixed << std::setprecision(6) << std::setw(9)
           << std::stod(lines[line - 1].substr(column - 1, 9)) + by;
    write(line, column, number.str());
    return refusal();
  };
  EXPECT_NE(moved(1, 19, 0.02).find("line 2: columns 19-27 (x): "), std::string::npos);
  EXPECT_NE(moved(7, 38, -0.02).find("line 7: columns 38-46 (y): "), std::string::npos);
  EXPECT_EQ(moved(7, 38, -0.01), "nothing was thrown");  // unusual, not impossible
}

// As where the lines of an excerpt lost their first character.
TEST_F(Finals2000A, ADayBeforeUtcIsRefusedWithItsLine) {
  int day = 9680;
  for (auto& line : lines) line.replace(7, 8, " " + std::to_string(day++) + ".00");
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 1: columns 8-15 (MJD): Epoch::from_utc_mjd(9680, 0): UTC is "
            "not known before 1960");
}

// Rows on a cubic, to the microarcsecond of the file, give the cubic, also in the first day and the last.
TEST_F(Finals2000A, RowsOnACubicGiveTheCubic) {
  const auto pole = [](double day) { return 0.05 + day * (0.004 + day * (-0.001 + day * 0.00016)); };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::ostringstream field;
    field << std::fixed << std::setprecision(6) << std::setw(9) << pole(static_cast<double>(i));
    write(i + 1, 19, field.str());
  }
  const TemporaryFile file(content());
  const auto orientation = EarthOrientation::read(file.path());
  constexpr double written =
      2e-6 * arcsecond;  // half a unit of the last digit, and what the spline makes of it
  for (const double day : {0.02, 0.5, 0.9, 2.5, 5.1, 5.5, 5.98}) {
    const auto p = orientation.parameters(orientation.first() + 86400.0 * day * si::second);
    EXPECT_NEAR(p.pole_x.value(), pole(day) * arcsecond, written) << day;
  }
}

// Cardinal splines: -0.136 of the change in the interval after the next row. Here the end of the rows is
// near.
TEST_F(Finals2000A, ARowActsLittleBeyondTheNextOne) {
  const auto read = [&] {
    const TemporaryFile file(content());
    return EarthOrientation::read(file.path());
  };
  const auto before = read();
  write(4, 19, " 0.066532");  // 0.010000 more
  const auto after = read();
  double most = 0.0;
  for (double day = 4.0; day <= 5.0; day += 0.02) {
    const auto t = before.first() + 86400.0 * day * si::second;
    const auto changed = (after.parameters(t).pole_x - before.parameters(t).pole_x).value();
    most = vectrix::detail::larger(most, std::abs(changed) / (0.01 * arcsecond));
  }
  EXPECT_LE(most, 0.17);
  EXPECT_GE(most, 0.13);
}

TEST_F(Finals2000A, EndsWithTheLastCompleteRow) {
  write(6, 98, "         ");
  lines[6].resize(16);
  const TemporaryFile file(content());
  EXPECT_EQ(EarthOrientation::read(file.path()).last().utc(0), "2022-04-15T00:00:00");
}

TEST_F(Finals2000A, RefusesABlankFieldBeforeACompleteRow) {
  write(3, 98, "         ");
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 3: columns 98-106 (dX): the field is blank, but a complete row "
            "follows");
}

TEST_F(Finals2000A, RefusesWhatIsNotANumber) {
  write(2, 59, "-0.09x5844");
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 2: columns 59-68 (UT1-UTC): '-0.09x5844' is not a number");
  write(1, 19, "      nan");
  EXPECT_EQ(refusal(), "Earth orientation FILE, line 1: columns 19-27 (x): 'nan' is not a finite number");
  write(1, 8, "59680.50");
  EXPECT_EQ(refusal(), "Earth orientation FILE, line 1: columns 8-15 (MJD): 59680.5 is not a whole day");
  write(1, 8, "        ");
  EXPECT_EQ(refusal(), "Earth orientation FILE, line 1: columns 8-15 (MJD): the field is blank");
}

TEST_F(Finals2000A, RefusesRowsThatAreNotADayApart) {
  lines.erase(lines.begin() + 3);
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 4: columns 8-15 (MJD): the day 59684 follows 59682; rows must be a "
            "day apart");
  std::swap(lines[0], lines[1]);
  EXPECT_EQ(refusal(),
            "Earth orientation FILE, line 2: columns 8-15 (MJD): the day 59680 follows 59681; rows must be a "
            "day apart");
}

TEST_F(Finals2000A, RefusesALeapSecondThatErfaDoesNotKnow) {
  write(5, 59, " 0.9030981");
  EXPECT_EQ(refusal().substr(0, 86),
            "Earth orientation FILE, line 5: columns 59-68 (UT1-UTC): UT1-TAI changes by 0.99965970");
}

TEST_F(Finals2000A, RefusesFilesWithoutRows) {
  EXPECT_EQ(complaint([] { EarthOrientation::read("/nowhere/finals"); }),
            "Earth orientation /nowhere/finals: cannot be read");
  EXPECT_EQ(refusal(""), "Earth orientation FILE: 0 complete rows; there must be four");
  EXPECT_EQ(refusal(lines[0] + "\n"), "Earth orientation FILE: 1 complete rows; there must be four");
  write(2, 38, "         ");
  EXPECT_EQ(refusal(lines[0] + "\n" + lines[1] + "\n"),
            "Earth orientation FILE, line 2: columns 38-46 (y): the field is blank after 1 complete rows; "
            "there must be four");
}

TEST_F(Finals2000A, RefusesATruncatedFile) {
  const std::string whole = content();
  EXPECT_EQ(refusal(whole.substr(0, whole.size() - 100)),
            "Earth orientation FILE, line 7: the file stops within this line; it was truncated");
  // Columns 117 to 125 are the last that are read.
  const auto cut_after = [&](std::size_t column) {
    return refusal(whole.substr(0, whole.size() - lines.back().size() - 1 + column));
  };
  EXPECT_EQ(cut_after(124),
            "Earth orientation FILE, line 7: the file stops within this line; it was truncated");
  EXPECT_EQ(cut_after(125), "nothing was thrown");
}

}  // namespace
}  // namespace vectrix::finals2000a_test
