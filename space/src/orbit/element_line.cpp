#include "element_line.hpp"

#include <charconv>
#include <span>

#include <vectrix/frames/errors.hpp>

#include "../files/text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr std::size_t line_length = 69;
// The columns between the fields.
constexpr std::size_t line1_blanks[] = {2, 9, 18, 33, 44, 53, 62, 64},
                      line2_blanks[] = {2, 8, 17, 26, 34, 43, 52};
constexpr std::span<const std::size_t> blanks_of_line1{line1_blanks}, blanks_of_line2{line2_blanks};
constexpr Columns catalogue_columns{3, 7, "catalogue number"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool all_digits(std::string_view text) {
  for (const char c : text) {
    if (!is_digit(c)) return false;
  }
  return !text.empty();
}
std::string_view without_leading_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

// A minus sign counts 1, what is no digit 0.
int check_sum(std::string_view text) {
  int sum = 0;
  for (const char c : text) sum += is_digit(c) ? c - '0' : c == '-' ? 1 : 0;
  return sum % 10;
}

}  // namespace

ElementLine::ElementLine(std::string place, std::string_view text, char number)
    : place_(std::move(place)), text_(text.substr(0, line_length)) {
  const std::string which{number};
  if (text_.size() < line_length)
    throw BadInput(place_ + ": there are " + detail::text(text_.size()) + " columns; line " + which +
                   " of two-line elements has 69");
  for (std::size_t i = 0; i < line_length; ++i) {
    if (text_[i] < ' ' || text_[i] > '~') fail({i + 1, i + 1, "any"}, "no printable character of ASCII");
  }
  if (text_[0] != number) fail({1, 1, "line number"}, "expected " + which);
  for (const std::size_t column : number == '1' ? blanks_of_line1 : blanks_of_line2) {
    if (text_[column - 1] != ' ') fail({column, column, "between two fields"}, "expected a blank");
  }
  const int sum = check_sum(text_.substr(0, line_length - 1));
  if (text_[line_length - 1] != '0' + sum)
    fail({line_length, line_length, "check sum"}, "the digits before it give " + detail::text(sum));
}

std::string_view ElementLine::text(const Columns& columns) const {
  return text_.substr(columns.first - 1, columns.last - columns.first + 1);
}

double ElementLine::number(const Columns& columns) const {
  const auto written = without_leading_blanks(text(columns));
  const bool plain = written.find_first_not_of("+-.0123456789") == std::string_view::npos;
  const auto value = plain ? parse_number(written) : std::nullopt;
  if (!value) fail(columns, "not a decimal number");
  return *value;
}

double ElementLine::number(const Columns& columns, double least, double most) const {
  return within(columns, number(columns), least, most);
}

double ElementLine::within(const Columns& columns, double value, double least, double most) const {
  if (!(value >= least && value <= most))
    fail(columns, "not in [" + detail::text(least) + ", " + detail::text(most) + "]");
  return value;
}

int ElementLine::count(const Columns& columns) const {
  const auto written = without_leading_blanks(text(columns));
  if (written.empty()) return 0;
  if (!all_digits(written)) fail(columns, "not a whole number");
  int value = 0;
  std::from_chars(written.data(), written.data() + written.size(), value);
  return value;
}

double ElementLine::decimals(const Columns& columns) const {
  const auto written = text(columns);
  if (!all_digits(written)) fail(columns, "not the digits behind a decimal point");
  return *parse_number("0." + std::string{written});
}

double ElementLine::with_exponent(const Columns& columns) const {
  const auto written = text(columns);
  const auto is_sign = [](char c) { return c == '+' || c == '-'; };
  const auto digits = written.substr(1, 5), power = written.substr(6, 2);
  if (!(written[0] == ' ' || is_sign(written[0])) || !all_digits(digits) || !is_sign(power[0]) ||
      !is_digit(power[1]))
    fail(columns, "not a number as 28098-4, 0.28098e-4");
  const double size = *parse_number("0." + std::string{digits} + 'e' + std::string{power});
  return written[0] == '-' ? -size : size;
}

double ElementLine::with_exponent(const Columns& columns, double most) const {
  return within(columns, with_exponent(columns), -most, most);
}

int ElementLine::catalogue_number() const {
  constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  const auto written = text(catalogue_columns);
  const auto letter = letters.find(written[0]);
  if (letter == std::string_view::npos) {
    if (without_leading_blanks(written).empty()) fail(catalogue_columns, "there is none");
    return count(catalogue_columns);
  }
  if (!all_digits(written.substr(1))) fail(catalogue_columns, "not a letter and four digits");
  int value = 0;
  std::from_chars(written.data() + 1, written.data() + written.size(), value);
  return (10 + static_cast<int>(letter)) * 10000 + value;
}

void ElementLine::fail(const Columns& columns, const std::string& reason) const {
  const bool one = columns.first == columns.last;
  throw BadInput(place_ + (one ? ", column " : ", columns ") + detail::text(columns.first) +
                 (one ? "" : "-" + detail::text(columns.last)) + " (" + columns.name + "): '" +
                 std::string{text(columns)} + "': " + reason);
}

}  // namespace vectrix::detail
