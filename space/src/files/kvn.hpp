#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "text_file.hpp"

namespace vectrix::detail {

/// A line of the keyword-value notation of CCSDS, its number, and the column of its value, counted from 1.
///     MEAN_MOTION = 15.49071756 [rev/day]
/// The unit is a part of the value: in names, brackets mean nothing.
struct KvnLine {
  std::string keyword, value;
  std::size_t line, column;
};

/// The line, or nothing if it is blank or a comment. `place` begins the message. Throws
/// BadInput with the column for a line without an equals sign, a keyword that is not of A-Z, 0-9 and _,
/// and characters that are not printable ASCII, which a comment may contain except for control characters.
std::optional<KvnLine> read_kvn_line(const std::string& place, std::size_t number, std::string_view line);

/// Where a character stands, and which may: printable ASCII everywhere, tabs but in a value, and in a comment
/// all but the other control characters.
enum class KvnText { value, comment, line };
/// The index of the first character that may not stand there; npos if all may.
std::size_t first_wrong(std::string_view text, KvnText where);

/// Throws BadInput with the place, line, column, keyword and value.
[[noreturn]] void refuse(const std::string& place, const KvnLine& line, const std::string& reason);

/// The text in capitals of A-Z.
std::string upper_case(std::string text);

/// A word of a data line, and its column, counted from 1.
struct KvnWord {
  std::string_view text;
  std::size_t column;
};

/// The lines of a message that has data lines, one after the other, without blank ones. Every error is a
/// BadInput with place, line and column.
class KvnReader {
 public:
  KvnReader(std::string place, TextFile file);

  /// To the next line. False at the end. Refuses a last line without a line end, for it may have been cut
  /// within a number; a comment or a word such as DATA_STOP may stand there.
  bool next();

  /// What the line is: a comment, one word such as META_START, keyword = value, or data.
  [[nodiscard]] bool is_comment() const { return comment_; }
  [[nodiscard]] bool is(std::string_view word) const { return content_ == word; }
  [[nodiscard]] bool is_xml() const { return content_.starts_with('<'); }
  [[nodiscard]] bool has_keyword() const { return content_.find('=') != std::string_view::npos; }

  /// What stands behind the word COMMENT and one blank.
  [[nodiscard]] std::string comment() const;
  [[nodiscard]] KvnLine keyword() const;
  static constexpr std::size_t most_words = 16;
  /// The words of the line, up to most_words; the rest is one word.
  [[nodiscard]] std::size_t words(std::array<KvnWord, most_words>& words) const;

  /// The number of the line; at the end, of the last one.
  [[nodiscard]] std::size_t line() const { return std::min(number_, file_.lines.size()); }
  [[nodiscard]] const std::string& place() const { return place_; }
  /// Refuses the line as it stands.
  [[noreturn]] void fail(const std::string& reason) const;
  /// Refuses a word of it, which is called `name`.
  [[noreturn]] void fail(const KvnWord& word, std::string_view name, const std::string& reason) const;

 private:
  std::string place_;
  TextFile file_;
  std::size_t number_ = 0;
  std::string_view content_;
  bool comment_ = false;
};

}  // namespace vectrix::detail
