#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vectrix::detail {

/// The lines of a text file, without line ends (LF or CR LF) and without a byte order mark. `whole` is true
/// if the last line had a line end.
struct TextFile {
  std::vector<std::string> lines;
  bool whole = true;
};

/// What a reader says of a file that is not whole: a number may have been cut.
inline constexpr const char* truncated = "the file stops within this line; it was truncated";

/// What it says of a file of old Macintosh computers, which is one line here.
inline constexpr const char* with_bare_returns =
    "its lines end with CR alone; they must end with LF or CR LF";

/// The lines of a text, of which the end ends the last one.
TextFile lines_of(std::string_view text);
/// The lines of a file. Nothing if it cannot be read.
std::optional<TextFile> read_lines(const std::filesystem::path& file);

/// The bytes of a file. Nothing if it cannot be read.
std::optional<std::string> read_bytes(const std::filesystem::path& file);
std::string_view without_byte_order_mark(std::string_view text);
/// Takes the first line off a text, and gives it without its end, LF or CR LF.
std::string_view take_line(std::string_view& text);
/// Whether the end of a text ends its last line.
inline bool is_whole(std::string_view text) {
  return text.empty() || text.back() == '\n';
}

/// Throws BadInput that begins with `place` if it cannot be written.
void write_file(const std::string& place, const std::filesystem::path& file, const std::string& text);

inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
/// The text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// The text for a message: its beginning, if it is long.
std::string excerpt(std::string_view text);

/// The number without a plus sign before it, which std::from_chars does not take.
std::string_view without_plus(std::string_view number);
/// The number if the whole text is one, including infinities and NaN; nothing for any other text.
std::optional<double> parse_number(std::string_view text);

}  // namespace vectrix::detail
