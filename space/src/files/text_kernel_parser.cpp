#include "text_kernel_parser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr std::string_view begin_data = "\\begindata", begin_text = "\\begintext";
constexpr std::string_view blanks = " \t\r\n", after_value = " \t\r\n,()'";
constexpr std::size_t longest_value = 100;

std::string_view first_line(std::string_view text) {
  return take_line(text);
}

/// Of a number with the exponent of Fortran, 1.657D-3, too.
std::optional<double> kernel_number(std::string_view word) {
  if (word.size() > longest_value) return std::nullopt;
  std::string text{word};
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'e');
  const auto number = parse_number(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace

void TextKernelParser::fail(const std::string& reason) const {
  fail(line_, column_, reason);
}
void TextKernelParser::fail(std::size_t line, std::size_t column, const std::string& reason) const {
  throw BadInput(place_ + ", line " + text(line) + ", column " + text(column) + ": " + reason);
}

void TextKernelParser::take(std::size_t count) {
  for (const char c : rest_.substr(0, count)) {
    only_blanks_ = c == '\n' || (only_blanks_ && blanks.find(c) != std::string_view::npos);
    line_ += c == '\n';
    column_ = c == '\n' ? 1 : column_ + 1;
  }
  rest_.remove_prefix(std::min(count, rest_.size()));
}

std::string_view TextKernelParser::word(std::string_view ends) const {
  return rest_.substr(0, rest_.find_first_of(ends));
}

TextKernelParser::Variables TextKernelParser::read() {
  Variables variables;
  while (!rest_.empty()) {
    if (!in_data_) {
      take_line_of_comment();
    } else if (skip_to_data()) {
      take_assignment(variables);
    }
  }
  return variables;
}

void TextKernelParser::take_line_of_comment() {
  in_data_ = trimmed(first_line(rest_)) == begin_data;
  const auto end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  column_ = 1;
  only_blanks_ = true;
}

bool TextKernelParser::skip_to_data() {
  take(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  if (rest_.empty()) return false;
  if (rest_.front() != '\\') return true;
  const std::string_view command = trimmed(first_line(rest_));
  if (!at_line_start() || (command != begin_text && command != begin_data))
    fail("'" + excerpt(command) + "' is neither \\begindata nor \\begintext");
  in_data_ = command == begin_data;
  take(first_line(rest_).size());
  return false;
}

void TextKernelParser::take_assignment(Variables& variables) {
  const std::size_t line = line_, column = column_;
  std::string_view name = word(" \t\r\n=(),'");
  const bool adds_at_once = name.ends_with('+') && rest_.substr(name.size()).starts_with('=');
  if (adds_at_once) name.remove_suffix(1);
  constexpr std::size_t longest = 32;
  if (name.empty()) fail("'" + excerpt(word("\r\n")) + "': the name of a variable is expected");
  if (name.size() > longest) fail("the name '" + excerpt(name) + "' has more than 32 characters");
  take(name.size());
  take(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
  const bool adds = rest_.starts_with("+=");
  if (!adds && !rest_.starts_with('=')) fail("'" + excerpt(word("\r\n")) + "': = or += is expected");
  take(adds ? 2 : 1);

  std::vector<TextKernel::Value> values;
  if (!skip_to_data()) fail(line, column, "the variable '" + std::string{name} + "' has no value");
  if (rest_.front() != '(') {
    values.push_back(take_value());
  } else {
    take(1);
    while (true) {
      take(std::min(rest_.find_first_not_of(" \t\r\n,"), rest_.size()));
      if (rest_.empty() || (rest_.front() == '\\' && at_line_start()))
        fail(line, column, "the values of '" + std::string{name} + "' have no ')'");
      if (rest_.front() == ')') break;
      values.push_back(take_value());
    }
    take(1);
    if (values.empty()) fail(line, column, "the variable '" + std::string{name} + "' has no value");
  }
  TextKernel::Variable& variable = variables[std::string{name}];
  if (!adds) variable.values.clear();
  if (variable.values.empty()) variable.line = line;
  const auto is_text = [](const TextKernel::Value& value) {
    return value.kind == TextKernel::Value::Kind::text;
  };
  const bool texts = is_text(variable.values.empty() ? values.front() : variable.values.front());
  for (const TextKernel::Value& value : values) {
    if (is_text(value) != texts)
      fail(value.line, value.column, "the variable '" + std::string{name} + "' has numbers and texts");
  }
  std::move(values.begin(), values.end(), std::back_inserter(variable.values));
}

TextKernel::Value TextKernelParser::take_value() {
  using Kind = TextKernel::Value::Kind;
  if (rest_.front() == '\'') return take_text();
  const std::string_view found = word(after_value);
  TextKernel::Value value{Kind::number, 0.0, {}, line_, column_};
  if (found.starts_with('@') && found.size() > 1 && found.size() <= longest_value) {
    value.kind = Kind::date;
    value.text = found.substr(1);
  } else {
    const auto number = kernel_number(found);
    if (!number)
      fail("'" + excerpt(found.empty() ? word("\r\n") : found) +
           "' is not a finite number, a date or a text");
    value.number = *number;
  }
  take(found.size());
  return value;
}

TextKernel::Value TextKernelParser::take_text() {
  TextKernel::Value value{TextKernel::Value::Kind::text, 0.0, {}, line_, column_};
  std::size_t at = 1;
  while (true) {
    const auto end = rest_.find_first_of("'\n", at);
    if (end == std::string_view::npos || rest_[end] == '\n')
      fail("the text '" + excerpt(first_line(rest_.substr(1))) + "' has no end in its line");
    value.text += rest_.substr(at, end - at);
    at = end + 1;
    if (!rest_.substr(at).starts_with('\'')) break;
    value.text += '\'';
    ++at;
  }
  take(at);
  return value;
}

}  // namespace vectrix::detail
