#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vectrix::detail {

/// The lines of a text file, without their ends (LF or CR LF) and a byte order mark. `whole` tells whether
/// the last one had an end.
struct TextFile {
  std::vector<std::string> lines;
  bool whole = true;
};

/// Nothing when the file cannot be read.
std::optional<TextFile> read_lines(const std::filesystem::path& file);

/// Without the blanks around it.
std::string_view trimmed(std::string_view text);

/// The number that the whole text is, infinities and not-a-numbers among them; nothing for any other text.
std::optional<double> parse_number(std::string_view text);

}  // namespace vectrix::detail
