#include "plain_words.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace vectrix::cli::plain_words_test
