#pragma once

#include <string>
#include <vector>

namespace vectrix::cli {

/// An option, and what was given for it; empty if nothing was.
struct Word {
  const char* option;
  const std::string& text;
};
using Words = std::vector<Word>;

/// The options for which nothing was given: "--time COLUMN, --scalar first|last".
inline std::string missing_of(const Words& words) {
  std::string missing;
  for (const Word& word : words)
    if (word.text.empty()) missing += (missing.empty() ? "" : ", ") + std::string(word.option);
  return missing;
}

}  // namespace vectrix::cli
