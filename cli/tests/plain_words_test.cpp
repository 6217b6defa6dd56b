#include "plain_words.hpp"

#include <gtest/gtest.h>

#include "says.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::plain_words_test {
namespace {

TEST(PlainWords, HaveNoNamesOfTypes) {
  EXPECT_EQ(without_types("lvlh(from<cli::steadiness(const Record&)::Lvlh>, cli::Satellite relative to "
                          "earth::Gcrf): |r| is 0 m"),
            "|r| is 0 m");
  EXPECT_EQ(without_types("Sgp4(cli::Satellite): catalogue number 5, the epoch: late"),
            "catalogue number 5, the epoch: late");
  EXPECT_EQ(without_types("Ephemeris<Sun>: the epoch"), "the epoch");
  EXPECT_EQ(without_types("a.csv: 3 < 4: no"), "a.csv: 3 < 4: no");
}

TEST(PlainWords, HaveNoTypesBehindNames) {
  EXPECT_EQ(
      without_types_of_names(
          "o.bsp: it has -99 relative to 'MARS' (499); asked for -99 (cli::Satellite) relative "
          "to 'EARTH' (399) (earth::Gcrf) from 1 to 2"),
      "o.bsp: it has -99 relative to 'MARS' (499); asked for -99 relative to 'EARTH' (399) from 1 to 2");
  EXPECT_EQ(without_types_of_names("o.bsp: J2000 (1) is read; asked for earth::Gcrf"),
            "o.bsp: J2000 (1) is read");
  EXPECT_EQ(without_types_of_names("a (b: open"), "a (b: open");
}

TEST(PlainWords, HaveNoFunctions) {
  EXPECT_EQ(without_function("half_cone(): the confidence is 2"), "the confidence is 2");
  EXPECT_EQ(without_function("in line 1, half_cone(): the confidence"),
            "in line 1, half_cone(): the confidence");
  EXPECT_EQ(without_function("a: b"), "a: b");
}

// The place is said once.
TEST(PlainWords, KeepTheFileOfAMessageThatHasIt) {
  const auto said = [](const std::string& text) {
    return complaint([&] { in_plain_words("FILE", [&]() -> void { throw BadInput(text); }); });
  };
  EXPECT_EQ(said("kernel o.bsp: it has -99 (cli::Satellite)"), "kernel o.bsp: it has -99");
  EXPECT_EQ(said("Sgp4(cli::Satellite): late"), "FILE: late");
}

}  // namespace
}  // namespace vectrix::cli::plain_words_test
