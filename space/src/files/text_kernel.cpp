#include <vectrix/space/files/text_kernel.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <erfa.h>
#include <erfam.h>

#include <vectrix/frames/errors.hpp>

#include "kvn.hpp"
#include "text_file.hpp"
#include "text_kernel_parser.hpp"

namespace vectrix {
namespace {

std::string name_of_variable(std::string_view name) {
  return "the variable '" + detail::excerpt(name) + "'";
}

/// The parts of a date, between any of the separators.
std::vector<std::string_view> parts_of_date(std::string_view text) {
  std::vector<std::string_view> parts;
  constexpr std::string_view separators = "-/: \t";
  while (true) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return parts;
    text.remove_prefix(first);
    const auto end = std::min(text.find_first_of(separators), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<int> month_of(std::string_view part) {
  constexpr std::array<std::string_view, 12> names{"JAN", "FEB", "MAR", "APR", "MAY", "JUN",
                                                   "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"};
  constexpr std::size_t letters = 3;
  const std::string capitals = detail::upper_case(std::string{part});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (capitals.size() >= letters && capitals.substr(0, letters) == names[i]) return static_cast<int>(i) + 1;
  }
  return std::nullopt;
}

std::optional<double> digits_of(std::string_view part, double most, bool may_have_decimals = false) {
  const char* const allowed = may_have_decimals ? "0123456789." : "0123456789";
  if (part.find_first_not_of(allowed) != std::string_view::npos) return std::nullopt;
  const auto number = detail::parse_number(part);
  return number && *number <= most ? number : std::nullopt;
}

/// Seconds since 2000 January 1, 12 h.
std::optional<double> seconds_of_date(std::string_view text) {
  std::string_view date = text;
  std::string spaced;
  constexpr std::size_t iso = 10;  // 2000-01-01T12:00:00
  if (text.size() > iso && text[iso] == 'T') {
    spaced = std::string{text};
    spaced[iso] = ' ';
    date = spaced;
  }
  const auto parts = parts_of_date(date);
  constexpr std::size_t fewest = 3, most = 6;
  if (parts.size() < fewest || parts.size() > most) return std::nullopt;
  constexpr std::size_t digits_of_year = 4;
  const bool year_first = parts[0].size() == digits_of_year;
  const auto year = digits_of(parts[year_first ? 0 : 2], 9999.0);
  if (!year || parts[year_first ? 0 : 2].size() != digits_of_year) return std::nullopt;
  auto month = month_of(parts[1]);
  if (!month && year_first) {
    if (const auto number = digits_of(parts[1], 12.0)) month = static_cast<int>(*number);
  }
  const auto day = digits_of(parts[year_first ? 2 : 0], 31.0);
  if (!month || !day) return std::nullopt;
  double zero = 0.0, modified = 0.0;
  if (eraCal2jd(static_cast<int>(*year), *month, static_cast<int>(*day), &zero, &modified) != 0)
    return std::nullopt;
  constexpr double noon_of_2000 = 51544.5;
  double sum = (modified - noon_of_2000) * ERFA_DAYSEC;
  constexpr std::array<double, 3> unit{3600.0, 60.0, 1.0}, limit{23.0, 59.0, 60.0};
  for (std::size_t i = fewest; i < parts.size(); ++i) {
    const auto number = digits_of(parts[i], limit[i - fewest], i + 1 == most);
    if (!number || *number == 60.0) return std::nullopt;
    sum += *number * unit[i - fewest];
  }
  return sum;
}

}  // namespace

TextKernel TextKernel::parse(std::string_view text) {
  return parse(text, "text kernel");
}

TextKernel TextKernel::parse(std::string_view text, const std::string& place) {
  TextKernel kernel;
  kernel.place_ = place;
  kernel.variables_ = detail::TextKernelParser(place, detail::without_byte_order_mark(text)).read();
  return kernel;
}

TextKernel TextKernel::read(const std::filesystem::path& file) {
  const std::string place = "text kernel " + file.string();
  const auto text = detail::read_bytes(file);
  if (!text) throw BadInput(place + ": cannot be read");
  constexpr std::string_view binary = "DAF/";
  if (text->starts_with(binary)) throw BadInput(place + ": it is a binary kernel");
  return parse(*text, place);
}

const TextKernel::Variable* TextKernel::find(std::string_view name) const {
  const auto found = variables_.find(name);
  return found == variables_.end() ? nullptr : &found->second;
}

const TextKernel::Variable& TextKernel::variable(std::string_view name) const {
  const Variable* const found = find(name);
  if (!found) throw BadInput(place_ + ": there is no variable '" + detail::excerpt(name) + "'");
  return *found;
}

std::vector<double> TextKernel::numbers(std::string_view name) const {
  std::vector<double> numbers;
  for (const Value& value : variable(name).values) {
    if (value.kind != Value::Kind::number) refuse(value, "a number is expected");
    numbers.push_back(value.number);
  }
  return numbers;
}

double TextKernel::number(std::string_view name) const {
  const auto all = numbers(name);
  if (all.size() != 1) refuse(name, "has " + detail::text(all.size()) + " values instead of one");
  return all.front();
}

std::int32_t TextKernel::integer(std::string_view name) const {
  const double value = number(name);
  constexpr double most = 2147483647.0;
  if (value != std::floor(value) || std::abs(value) > most)
    refuse(name, "is " + detail::text(value) + ", not a whole number of 32 bits");
  return static_cast<std::int32_t>(value);
}

const std::string& TextKernel::text(std::string_view name) const {
  const Variable& found = variable(name);
  if (found.values.size() != 1 || found.values.front().kind != Value::Kind::text)
    refuse(name, "is not one text");
  return found.values.front().text;
}

double TextKernel::seconds(const Value& value) const {
  if (value.kind == Value::Kind::number) return value.number;
  const auto seconds = value.kind == Value::Kind::date ? seconds_of_date(value.text) : std::nullopt;
  if (!seconds)
    refuse(value, "'" + detail::excerpt(value.text) + "' is not a date such as @2017-JUN-21/17:09:38");
  return *seconds;
}

void TextKernel::refuse(const Value& value, const std::string& reason) const {
  throw BadInput(place_ + ", line " + detail::text(value.line) + ", column " + detail::text(value.column) +
                 ": " + reason);
}
void TextKernel::refuse(std::string_view name, const std::string& reason) const {
  throw BadInput(place_ + ", line " + detail::text(variable(name).line) + ": " + name_of_variable(name) +
                 " " + reason);
}

}  // namespace vectrix
