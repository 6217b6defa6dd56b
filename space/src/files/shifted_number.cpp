#include "shifted_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr std::size_t most_characters = 100;

struct Parts {
  std::string_view digits;
  int exponent;
};

std::optional<Parts> parts_of(std::string_view text) {
  const auto e = text.find_first_of("eE");
  if (e == std::string_view::npos) return Parts{text, 0};
  const std::string_view written = without_plus(text.substr(e + 1));
  int exponent = 0;
  const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), exponent);
  constexpr int most = 10000;
  if (error != std::errc{} || end != written.data() + written.size() || std::abs(exponent) > most)
    return std::nullopt;
  return Parts{text.substr(0, e), exponent};
}

// Puts the digits behind those that are there.
const char* after_digits(const char* at, const char* end, std::uint64_t& digits) {
  std::uint64_t all = digits;
  for (; at != end; ++at) {
    const auto digit = static_cast<unsigned>(*at - '0');
    if (digit > 9) break;
    all = 10 * all + digit;
  }
  digits = all;
  return at;
}

// Of a number without an exponent and with few digits: these digits and the power of ten are exact, so that
// their product or quotient is rounded once.
std::optional<double> parse_short(std::string_view text, int shift) {
  static constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::size_t longest = 19;
  constexpr std::uint64_t most = std::uint64_t{1} << 53;
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.size() > longest) return std::nullopt;
  std::uint64_t digits = 0;  // of 19 at most
  const char* const end = text.data() + text.size();
  const char* const point = after_digits(text.data(), end, digits);
  const char* const first_decimal = point != end && *point == '.' ? point + 1 : point;
  const bool is_read = after_digits(first_decimal, end, digits) == end;
  const auto decimals = static_cast<int>(end - first_decimal);
  if (!is_read || point - text.data() + decimals == 0 || digits > most) return std::nullopt;
  constexpr std::int64_t highest = powers.size() - 1;
  const std::int64_t exponent = std::int64_t{shift} - decimals;
  if (std::abs(exponent) > highest) return std::nullopt;
  const double whole = is_negative ? -static_cast<double>(digits) : static_cast<double>(digits);
  return exponent < 0 ? whole / powers[static_cast<std::size_t>(-exponent)]
                      : whole * powers[static_cast<std::size_t>(exponent)];
}

}  // namespace

std::optional<double> parse_shifted(std::string_view text, int shift) {
  if (const auto value = parse_short(text, shift)) return value;
  const auto finite = [](std::optional<double> value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
  };
  if (shift == 0) return finite(parse_number(text));
  const auto parts = parts_of(text);
  if (!parts || text.size() > most_characters) return std::nullopt;
  std::array<char, most_characters + 16> buffer{};
  char* end = std::copy(parts->digits.begin(), parts->digits.end(), buffer.data());
  *end++ = 'e';
  end = std::to_chars(end, buffer.data() + buffer.size(), std::int64_t{parts->exponent} + shift).ptr;
  return finite(parse_number({buffer.data(), static_cast<std::size_t>(end - buffer.data())}));
}

bool is_finite_number(std::string_view text) {
  text = without_plus(text);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return stop == end && error != std::errc::invalid_argument && std::isfinite(value);
}

const char* number_fault(std::string_view text, int shift) {
  if (!is_finite_number(text)) return "not a finite number";
  if (shift == 0) return "too large or too small for a double, 5e-324 to 1.8e308";
  return text.size() > most_characters ? "a number of more than 100 characters"
                                       : "in SI units too large or too small for a double, 5e-324 to 1.8e308";
}

std::string shifted_text(double value, int shift) {
  std::array<char, 40> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
  const Parts parts = *parts_of({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
  std::string written{parts.digits};
  if (written.find('.') == std::string::npos) written += ".0";
  const int exponent = value == 0.0 ? 0 : parts.exponent - shift, size = std::abs(exponent);
  return written + (exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + std::to_string(size);
}

}  // namespace vectrix::detail
