#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vectrix/space/files/daf_file.hpp>

#include "daf_text.hpp"
#include "temporary_file.hpp"

// Double precision array files that the test writes, and what can be wrong in one.
namespace vectrix::daf_file_test {
namespace {

const std::vector<DafTestArray> two{{"first", {1.5, 2.5}, {-7, 1, 3, 0}, {1.0, -2.0, 0.1}},
                                    {"second", {3.5, 4.5}, {-8, 17, 2, 1}, {1e300, -1e-300, M_PI, 4.0}}};

std::string opened(const std::string& bytes) {
  const TemporaryFile file(bytes);
  return complaint([&] { static_cast<void>(DafFile::open(file.path())); }, file.path());
}
std::string with(std::string bytes, std::size_t at, const std::string& other) {
  return bytes.replace(at, other.size(), other);
}
std::string number(double value) {
  return DafBytes(false).number(value).bytes();
}
std::string integer(std::uint32_t value) {
  return DafBytes(false).integer(value).bytes();
}

void expect_two(const DafFile& daf) {
  ASSERT_EQ(daf.arrays().size(), 2U);
  for (std::size_t i = 0; i < two.size(); ++i) {
    EXPECT_EQ(daf.arrays()[i].name, two[i].name);
    EXPECT_EQ(daf.arrays()[i].doubles, two[i].doubles);
    EXPECT_EQ(daf.arrays()[i].integers, two[i].integers);
    EXPECT_EQ(daf.read(daf.arrays()[i], 0, daf.arrays()[i].size), two[i].numbers);
  }
  EXPECT_EQ(daf.read(daf.arrays()[1], 2, 1), std::vector<double>{M_PI});
  EXPECT_EQ(daf.kind(), "CK");
  EXPECT_EQ(daf.internal_name(), "a test");
  EXPECT_EQ(daf.comments(), "A comment\n");
}

TEST(DafFile, IsReadInBothByteOrders) {
  for (const bool big : {false, true}) {
    const TemporaryFile file(daf_bytes("CK", two, big));
    expect_two(DafFile::open(file.path()));
  }
}

TEST(DafFile, GivesNoMoreThanAnArrayHas) {
  const TemporaryFile file(daf_bytes("CK", two));
  const auto daf = DafFile::open(file.path());
  const auto asked = [&](std::uint64_t from, std::uint64_t count) {
    return complaint([&] { static_cast<void>(daf.read(daf.arrays()[0], from, count)); }, file.path());
  };
  EXPECT_EQ(asked(1, 2), "nothing was thrown");
  EXPECT_EQ(asked(2, 2), "DAF file FILE, array 'first': the elements 3 to 4 of 3");
  EXPECT_EQ(asked(0, std::uint64_t{1} << 60),
            "DAF file FILE, array 'first': the elements 1 to 1152921504606846976 of 3");
}

TEST(DafFile, HasSummariesInManyRecords) {
  std::vector<DafTestArray> many;
  for (int i = 0; i < 100; ++i)
    many.push_back({"array " + std::to_string(i), {0.0, 1.0}, {i, 0, 0, 0}, {1.0 * i}});
  for (const std::size_t in_record : {25U, 1U, 7U}) {
    const TemporaryFile file(daf_bytes("SPK", many, false, in_record));
    const auto daf = DafFile::open(file.path());
    ASSERT_EQ(daf.arrays().size(), many.size());
    for (std::size_t i = 0; i < many.size(); ++i) {
      EXPECT_EQ(daf.arrays()[i].name, many[i].name);
      EXPECT_EQ(daf.read(daf.arrays()[i], 0, 1), many[i].numbers);
    }
  }
}

TEST(DafFile, IsReadFromItsTransferForm) {
  const TemporaryFile file(R"(DAFETF NAIF DAF ENCODED TRANSFER FILE
'DAF/CK  '
'2'
'6'
'a test                                                      '
BEGIN_ARRAY 1 3
'first                                   '
'18^1'
'28^1'
'-7'
'1'
'3'
'0'
3
'1^1'
'-2^1'
'1999999999999A^0'
END_ARRAY 1 3
BEGIN_ARRAY 2 4
'second                                  '
'38^1'
'48^1'
'-8'
'11'
'2'
'1'
1
'17E43C8800759C^FA'
3
'-1111B0EC57E65^-F9' '3243F6A8885A3^1' '4^1'
END_ARRAY 2 4
TOTAL_ARRAYS 2
 ~NAIF/SPC BEGIN COMMENTS~
A comment
 ~NAIF/SPC END COMMENTS~
)");
  const auto daf = DafFile::open(file.path());
  ASSERT_EQ(daf.arrays().size(), 2U);
  EXPECT_EQ(daf.read(daf.arrays()[0], 0, 3), two[0].numbers);
  EXPECT_EQ(daf.read(daf.arrays()[1], 2, 2), (std::vector<double>{M_PI, 4.0}));
  EXPECT_EQ(daf.read(daf.arrays()[1], 0, 1).front(), 1e300);
  EXPECT_EQ(daf.arrays()[1].integers, two[1].integers);
  EXPECT_EQ(daf.comments(), "A comment\n");
}

TEST(DafFile, OfBeforeTheFormatWasWrittenDown) {
  for (const bool big : {false, true}) {
    const TemporaryFile file(with(with(daf_bytes("CK", two, big), 0, "NAIF/DAF"), 88, "        "));
    const auto daf = DafFile::open(file.path());
    EXPECT_EQ(daf.kind(), "");
    EXPECT_EQ(daf.read(daf.arrays()[0], 0, 3), two[0].numbers);
  }
}

TEST(DafFile, IsRefusedWhereItIsWrong) {
  const std::string good = daf_bytes("CK", two);
  constexpr std::size_t summaries = 2 * 1024, first = summaries + 24, addresses = first + 32;
  EXPECT_EQ(opened(with(good, 0, "PNG/")),
            "DAF file FILE: it begins with 'PNG/CK  ', not with DAF/, NAIF/DAF or DAFETF");
  EXPECT_EQ(opened(""), "DAF file FILE: it has no file record");
  EXPECT_EQ(opened(good.substr(0, 500)), "DAF file FILE, record 1: the file has 0 records; it was truncated");
  EXPECT_EQ(opened(good.substr(0, 2500)),
            "DAF file FILE, record 3: the file has 2 records; it was truncated");
  EXPECT_EQ(opened(good.substr(0, 3500)),
            "DAF file FILE, record 4: the file has 3 records; it was truncated");
  EXPECT_EQ(opened(good.substr(0, 4096)),
            "DAF file FILE, record 3, summary 1: the array 'first' has the words 513 to 515 of 512; the file "
            "was truncated");
  EXPECT_EQ(opened(with(good, 88, "VAX-GFLT")),
            "DAF file FILE, record 1: the numbers are 'VAX-GFLT', not LTL-IEEE or BIG-IEEE");
  EXPECT_EQ(opened(with(good, 88, "BIG-IEEE")),
            "DAF file FILE, record 1: summaries of 33554432 doubles and 100663296 integers");
  EXPECT_EQ(opened(with(good, 12, integer(0))),
            "DAF file FILE, record 1: summaries of 2 doubles and 0 integers");
  EXPECT_EQ(opened(with(good, 76, integer(0))),
            "DAF file FILE, record 1: the first record of summaries is 0");
  EXPECT_EQ(opened(with(good, 76, integer(4000000000U))),
            "DAF file FILE, record 4000000000: the file has 5 records; it was truncated");
  EXPECT_EQ(opened(with(good, 705, "\n")),
            "DAF file FILE, record 1: the file was damaged by a transfer as text");
  EXPECT_EQ(opened(with(good, summaries, number(3.0))),
            "DAF file FILE, record 3: the record before it is 3, and it says 0");
  EXPECT_EQ(opened(with(good, summaries, number(1e18))), "DAF file FILE, record 3: the next record is 1e+18");
  EXPECT_EQ(opened(with(good, summaries, number(NAN))), "DAF file FILE, record 3: the next record is nan");
  EXPECT_EQ(opened(with(good, summaries + 16, number(26.0))), "DAF file FILE, record 3: it has 26 summaries");
  EXPECT_EQ(opened(with(good, summaries + 16, number(1.5))), "DAF file FILE, record 3: it has 1.5 summaries");
  EXPECT_EQ(opened(with(good, addresses, integer(5))),
            "DAF file FILE, record 3, summary 1: the array 'first' has the words 5 to 515 of 640");
  EXPECT_EQ(opened(with(good, addresses + 4, integer(2147483647))),
            "DAF file FILE, record 3, summary 1: the array 'first' has the words 513 to 2147483647 of 640; "
            "the file was truncated");
  EXPECT_EQ(opened(with(good, addresses + 4, integer(516))),
            "DAF file FILE: the arrays 'first' and 'second' share words");
}

TEST(DafFile, TransferFormIsRefusedWhereItIsWrong) {
  const auto transfer = [](const std::string& rest) {
    return opened("DAFETF NAIF DAF ENCODED TRANSFER FILE\n" + rest);
  };
  const std::string begin = "'DAF/CK  '\n'2'\n'6'\n'a'\nBEGIN_ARRAY 1 ";
  EXPECT_EQ(opened("DAFETF other\n"),
            "DAF file FILE, line 1: 'DAFETF other' is not the title of a transfer file");
  EXPECT_EQ(transfer("'DAS/CK  '"), "DAF file FILE, line 2: 'DAS/CK  ' does not begin with DAF/");
  EXPECT_EQ(transfer("'DAF/CK  '\n'FFFFFFF'\n'6'\n"),
            "DAF file FILE, line 4: summaries of 268435455 doubles and 6 integers");
  EXPECT_EQ(transfer(begin + "999999999999\n'1^1'"),
            "DAF file FILE, line 6: an array of 999999999999 numbers in the 6 characters that are left");
  EXPECT_EQ(transfer(begin + "2\n'n'\n'1^1'\n'1^'\n"),
            "DAF file FILE, line 9: '1^' is not a number in base 16");
  EXPECT_EQ(transfer(begin + "2\n'n'\n'1^1'\n'1^7FFF'\n"),
            "DAF file FILE, line 9: '1^7FFF' is not a number in base 16");
  EXPECT_EQ(transfer(begin + "2\n'n'\n'1^1'\n'1^1'\n'1FFFFFFFF'\n"),
            "DAF file FILE, line 10: '1FFFFFFFF' is not an integer of 32 bits in base 16");
  EXPECT_EQ(transfer(begin + "2\n'n'\n'1^1'\n'1^1'\n'1'\n'1'\n'1'\n'1'\n3\n"),
            "DAF file FILE, line 14: a block of 3 numbers, of 2 that are left");
  EXPECT_EQ(transfer(begin + "2\n'n'\n'1^1'\n'1^1'\n'1'\n'1'\n'1'\n'1'\n2\n'1^1'\n"),
            "DAF file FILE, line 16: a number in base 16 is expected");
}

}  // namespace
}  // namespace vectrix::daf_file_test
