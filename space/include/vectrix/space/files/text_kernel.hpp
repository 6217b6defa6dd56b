#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>

namespace vectrix {

/// A text kernel of SPICE: variables, assigned between \begindata and \begintext; the rest is comment.
///     FRAME_CTIM_COORD      = -152950000
///     DELTET/DELTA_AT       = ( 10, @1972-JAN-1  11, @1972-JUL-1 )      numbers and dates
///     NAMES                += 'it''s'                                   texts, in quotation marks
/// Numbers may have the exponents E and D. A second `=` replaces the value, `+=` adds to it. What the numbers
/// mean, the readers of a kernel know: frames, clocks, leap seconds.
class VECTRIX_EXPORT TextKernel {
 public:
  struct Value {
    enum class Kind { number, date, text };
    Kind kind;
    double number;     ///< of a number
    std::string text;  ///< of a text or a date, without its marks
    std::size_t line, column;
  };
  struct Variable {
    std::size_t line;
    std::vector<Value> values;
  };

  TextKernel() = default;  ///< without variables

  /// Throws BadInput with line and column, what was found there and why it is wrong.
  static TextKernel parse(std::string_view text);
  /// Throws BadInput with the file, too, and if it cannot be read.
  static TextKernel read(const std::filesystem::path& file);

  [[nodiscard]] const std::map<std::string, Variable, std::less<>>& variables() const { return variables_; }
  /// Null if there is none.
  [[nodiscard]] const Variable* find(std::string_view name) const;
  /// The values, which must be there. They throw BadInput with the file, the line and what is wrong.
  [[nodiscard]] const Variable& variable(std::string_view name) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] std::int32_t integer(std::string_view name) const;
  [[nodiscard]] const std::string& text(std::string_view name) const;
  /// Seconds of the calendar since 2000 January 1, 12 h, each day of 86400 s, of "2017-06-21/17:09:38",
  /// "1972-JAN-1", "6-JAN-1980 00:00:00.5"; of a number, the number.
  [[nodiscard]] double seconds(const Value& value) const;

  /// Throws BadInput with the place of the value.
  [[noreturn]] void refuse(const Value& value, const std::string& reason) const;
  [[noreturn]] void refuse(std::string_view name, const std::string& reason) const;
  /// "text kernel x.tf", which begins messages.
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  static TextKernel parse(std::string_view text, const std::string& place);

  std::string place_ = "text kernel";
  std::map<std::string, Variable, std::less<>> variables_;
};

}  // namespace vectrix
