#include "scenario/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>

#include "scenario/place.hpp"

namespace vectrix::cli {
namespace {

struct Unit {
  std::string_view name;
  Dimension dimension;
  double factor;  // of the first one of its dimension
};
constexpr double of_radian = 180.0 / std::numbers::pi;
constexpr std::array units{
    Unit{"deg", Dimension::angle, 1.0},
    Unit{"rad", Dimension::angle, of_radian},
    Unit{"mrad", Dimension::angle, 1e-3 * of_radian},
    Unit{"arcmin", Dimension::angle, 1.0 / 60.0},
    Unit{"arcsec", Dimension::angle, 1.0 / 3600.0},
    Unit{"mas", Dimension::angle, 1e-3 / 3600.0},
    Unit{"s", Dimension::duration, 1.0},
    Unit{"ms", Dimension::duration, 1e-3},
    Unit{"min", Dimension::duration, 60.0},
    Unit{"h", Dimension::duration, 3600.0},
    Unit{"day", Dimension::duration, 86400.0},
    Unit{"m", Dimension::length, 1.0},
    Unit{"km", Dimension::length, 1e3},
    Unit{"mm", Dimension::length, 1e-3},
    Unit{"%", Dimension::share, 1.0},
    Unit{"deg/h", Dimension::rate, 1.0},
    Unit{"deg/s", Dimension::rate, 3600.0},
    Unit{"rad/s", Dimension::rate, 3600.0 * of_radian},
    Unit{"arcsec/s", Dimension::rate, 1.0},
    Unit{"mas/yr", Dimension::proper_motion, 1.0},  // of Julian years
    Unit{"arcsec/yr", Dimension::proper_motion, 1e3},
};

const Unit* unit_called(std::string_view name) {
  const auto found =
      std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == name; });
  return found == units.end() ? nullptr : found;
}

void skip_blanks(std::string_view text, std::size_t& at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
}

double parse_number(std::string_view text, std::size_t& at) {
  skip_blanks(text, at);
  const std::size_t begin = at;
  if (at < text.size() && text[at] == '+') ++at;
  double number{};
  const auto read = std::from_chars(text.data() + at, text.data() + text.size(), number);
  if (read.ec == std::errc::result_out_of_range)
    throw AmountError("the number is out of the range of doubles", begin);
  if (read.ec != std::errc()) throw AmountError("there is no number", begin);
  if (!std::isfinite(number)) throw AmountError("the number is not finite", begin);
  at = static_cast<std::size_t>(read.ptr - text.data());
  return number;
}

const Unit& parse_unit(std::string_view text, std::size_t at, Dimension dimension) {
  skip_blanks(text, at);
  std::string_view name = text.substr(at);
  while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
  const auto taken = units_of(dimension);
  const std::string kind = name_of(dimension) + " takes: " + listed(taken);
  if (name.empty()) throw AmountError("there is no unit; " + kind, at);
  const Unit* const unit = unit_called(name);
  if (!unit) {
    const std::string_view nearest = detail::nearest_name(name, taken);
    throw AmountError("'" + std::string(name) + "' is no unit" +
                          (nearest.empty() ? "" : "; the nearest is '" + std::string(nearest) + "'") + "; " +
                          kind,
                      at);
  }
  if (unit->dimension != dimension)
    throw AmountError("'" + std::string(name) + "' is a unit of " + name_of(unit->dimension) + "; " + kind,
                      at);
  return *unit;
}

}  // namespace

std::string name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::angle:
      return "an angle";
    case Dimension::duration:
      return "a duration";
    case Dimension::length:
      return "a length";
    case Dimension::rate:
      return "a rate of turn";
    case Dimension::proper_motion:
      return "a proper motion";
    default:
      return "a share";
  }
}

std::vector<std::string_view> units_of(Dimension dimension) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units)
    if (unit.dimension == dimension) names.push_back(unit.name);
  return names;
}

std::vector<double> parse_numbers(std::string_view text, std::size_t& at, std::size_t count) {
  skip_blanks(text, at);
  const std::size_t begin = at;
  const auto wanted = [&] {
    return AmountError(std::to_string(count) + " numbers in brackets are needed, as [1, 2, 3]", begin);
  };
  if (at == text.size() || text[at] != '[') throw wanted();
  std::vector<double> numbers;
  do {
    ++at;
    numbers.push_back(parse_number(text, at));
    skip_blanks(text, at);
  } while (at < text.size() && text[at] == ',');
  if (at == text.size() || text[at] != ']') throw AmountError("',' or ']' is missing", at);
  if (numbers.size() != count) throw wanted();
  ++at;
  return numbers;
}

Amount Amount::parse(std::string_view text, Dimension dimension, std::size_t count) {
  Amount amount;
  amount.text_ = text;
  std::size_t at = 0;
  if (count == 1) {
    amount.numbers_ = {parse_number(text, at)};
  } else {
    amount.numbers_ = parse_numbers(text, at, count);
  }
  amount.unit_ = parse_unit(text, at, dimension).name;
  return amount;
}

double Amount::in(std::string_view unit, std::size_t i) const {
  if (unit == unit_) return numbers_.at(i);
  return numbers_.at(i) * (unit_called(unit_)->factor / unit_called(unit)->factor);
}

}  // namespace vectrix::cli
