#include "sha256.hpp"

#include <gtest/gtest.h>

namespace vectrix::cli::sha256_test {
namespace {

// The examples that NIST publishes with FIPS 180-4, and its long message of a million letters.
TEST(Sha256, IsThatOfThePublishedMessages) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrl"
                   "mnopqrsmnopqrs"
                   "tnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Around the length where another block is needed.
TEST(Sha256, DiffersForEachLength) {
  for (std::size_t length = 54; length < 66; ++length)
    EXPECT_NE(sha256(std::string(length, '\0')), sha256(std::string(length + 1, '\0')));
}

}  // namespace
}  // namespace vectrix::cli::sha256_test
