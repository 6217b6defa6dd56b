#pragma once

#include <gtest/gtest.h>

#include <string>

namespace vectrix {

/// The text with `by` in the first place of `old`, which must be there.
inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const auto at = text.find(old);
  if (at == std::string::npos) {
    ADD_FAILURE() << "there is no '" << old << "' to replace";
    return text;
  }
  return text.replace(at, old.size(), by);
}

}  // namespace vectrix
