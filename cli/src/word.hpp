#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace vectrix::cli {

/// An option, also with what is to be given, "--time COLUMN", and what was given; empty if nothing was.
struct Word {
  const char* option;
  const std::string& text;
};
using Words = std::vector<Word>;

/// The options for which nothing was given: "--time COLUMN, --scalar first|last".
std::string missing_of(const Words& words);
/// Throws BadInput for the first that is given: `before`, its option, `why`.
void refuse(const Words& words, const std::string& before, const std::string& why);

/// What stands between commas. Throws BadInput, with the option, unless they are so many.
std::vector<std::string> fields(const char* option, const std::string& text, std::size_t count);
/// The words, and `between` them.
std::string joined(const std::vector<std::string>& words, const char* between = ",");

/// The number that all of the text is.
template <class Number> std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace vectrix::cli
