#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// A line of the keyword-value notation of CCSDS, its number, and the column of its value, counted from 1.
///     MEAN_MOTION = 15.49071756 [rev/day]
/// The unit is a part of the value: in names, brackets mean nothing.
struct KvnLine {
  std::string keyword, value;
  std::size_t line, column;
};

/// Where a part of a text stands in the text that it was made of. Lines and columns count from 1.
struct TextPosition {
  std::size_t line, column;
};
struct TextOrigin {
  std::size_t offset;  // in the text
  TextPosition position;
};

/// Where a character stands, and which may: printable ASCII everywhere, tabs but in a value, and in a comment
/// all but the other control characters.
enum class KvnText { value, comment, line };
/// The index of the first character that may not stand there; npos if all may.
std::size_t first_wrong(std::string_view text, KvnText where);

/// Whether a text is of A-Z, 0-9 and _.
bool is_keyword(std::string_view text);

/// Throws BadInput with the place, line, column, keyword and value.
[[noreturn]] void refuse(const std::string& place, const KvnLine& line, const std::string& reason);

/// The text in capitals of A-Z.
std::string upper_case(std::string text);

/// The lines of a message, one after the other, without blank ones. Every error is a BadInput with place,
/// line and column. A keyword is of A-Z, 0-9 and _, its value of printable ASCII. Data are read as words, in
/// which characters that are none of ASCII are refused with the word.
class KvnReader {
 public:
  /// Of a text that lives as long. If it is not whole, a last line without a line end is refused, for it may
  /// have been cut within a number; a comment or a word such as DATA_STOP may stand there.
  KvnReader(std::string place, std::string_view text, bool whole);
  /// Of a text that was made of another one, in which the errors have their lines and columns. The origins
  /// are sorted by offset, the first of them is 0, and each holds up to the next one.
  KvnReader(std::string place, std::string_view text, std::span<const TextOrigin> origins);

  /// To the next line. False at the end.
  bool next();

  /// What the line is: a comment, one word such as META_START, keyword = value, or data.
  [[nodiscard]] bool is_comment() const;
  [[nodiscard]] bool is(std::string_view word) const { return content_ == word; }
  [[nodiscard]] bool has_keyword() const { return content_.find('=') != std::string_view::npos; }

  /// What stands behind the word COMMENT and one blank.
  [[nodiscard]] std::string comment() const;
  [[nodiscard]] KvnLine keyword() const;
  static constexpr std::size_t most_words = 10;
  /// How many words the line has, and the first of them.
  [[nodiscard]] std::size_t words(std::array<std::string_view, most_words>& words) const;

  /// The line without the blanks around it.
  [[nodiscard]] std::string_view content() const { return content_; }
  /// How many lines there are from this one on, if all are as long.
  [[nodiscard]] std::size_t lines_left() const { return 1 + rest_.size() / (line_.size() + 1); }

  /// The number of the line; at the end, of the last one.
  [[nodiscard]] std::size_t line() const { return position(line_.data()).line; }
  [[nodiscard]] const std::string& place() const { return place_; }
  /// Refuses the line as it stands.
  [[noreturn]] void fail(const std::string& reason) const;
  /// Refuses a word of it, which is called `name`.
  [[noreturn]] void fail(std::string_view word, std::string_view name, const std::string& reason) const;

 private:
  void require_characters(std::string_view text, KvnText where) const;
  /// Of a character of the line.
  [[nodiscard]] TextPosition position(const char* at) const;
  [[nodiscard]] std::string here(const char* at) const;

  std::string place_;
  std::string_view text_, rest_, line_, content_;
  std::span<const TextOrigin> origins_{};
  bool whole_;
  std::size_t number_ = 0;
};

}  // namespace vectrix::detail
