#include <gtest/gtest.h>

#include <string>

#include <vectrix/frames/errors.hpp>

namespace vectrix::errors_test {
namespace {

using namespace std::string_literals;

// A zero byte of a file does not end a message.
TEST(BadInput, ShowsControlCharacters) {
  EXPECT_STREQ(BadInput("column 3: 'a\0b\x1b[31m'"s).what(), "column 3: 'a\\x00b\\x1b[31m'");
  EXPECT_STREQ(BadInput("\x7f\r"s).what(), "\\x7f\\x0d");
  EXPECT_STREQ(BadInput("a\tb\nc µ").what(), "a\tb\nc µ");
  EXPECT_STREQ(BadInput("").what(), "");
}

}  // namespace
}  // namespace vectrix::errors_test
