#pragma once

#include <gtest/gtest.h>

#include <string>

namespace vectrix::cli {

/// Whether the text holds the words; if not, the test shows both.
inline ::testing::AssertionResult says(const std::string& text, const std::string& words) {
  if (text.find(words) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << words << "' is not in:\n" << text;
}

}  // namespace vectrix::cli
