#pragma once

#include <string>
#include <string_view>

namespace vectrix::detail {

/// Columns of a line, counted from 1, and what they hold.
struct Columns {
  std::size_t first, last;
  const char* name;
};

/// One of the two lines of a set. Every error is a BadInput with the place, the columns and what is there.
class ElementLine {
 public:
  /// Checks length, characters, line number, the blank columns between the fields, and the sum of the digits.
  ElementLine(std::string place, std::string_view text, char number);

  [[nodiscard]] std::string_view text(const Columns& columns) const;
  /// A decimal number without exponent, blanks before it.
  [[nodiscard]] double number(const Columns& columns) const;
  /// The same, in [least, most].
  [[nodiscard]] double number(const Columns& columns, double least, double most) const;
  /// Digits with blanks before them; 0 if all are blank.
  [[nodiscard]] int count(const Columns& columns) const;
  /// Digits behind a decimal point that is not written.
  [[nodiscard]] double decimals(const Columns& columns) const;
  /// The same with a sign before and a power of ten behind: " 28098-4" is 0.28098e-4.
  [[nodiscard]] double with_exponent(const Columns& columns) const;
  /// The same, in [-most, most].
  [[nodiscard]] double with_exponent(const Columns& columns, double most) const;
  /// Five digits, or a letter and four digits.
  [[nodiscard]] int catalogue_number() const;

  [[noreturn]] void fail(const Columns& columns, const std::string& reason) const;

 private:
  [[nodiscard]] double within(const Columns& columns, double value, double least, double most) const;

  std::string place_;
  std::string_view text_;
};

}  // namespace vectrix::detail
