#include "shifted_number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

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

__extension__ using Wide = unsigned __int128;

constexpr int most_digits = 19;  // all such numbers fit into 64 bits

// 10^n as m 2^e with 2^63 <= m < 2^64, rounded down, for n from -19 to 19.
struct Power {
  std::uint64_t m;
  int e;
};
constexpr auto powers_of_ten = [] {
  std::array<Power, 2 * most_digits + 1> powers{};
  std::uint64_t ten = 1;  // to the n
  for (std::size_t n = 0; n <= most_digits; ++n, ten *= 10) {
    const int lost = std::countl_zero(ten);
    const std::uint64_t m = ten << lost;
    powers[most_digits + n] = {m, -lost};
    if (n > 0) powers[most_digits - n] = {static_cast<std::uint64_t>((Wide{1} << 127) / m), lost - 127};
  }
  return powers;
}();

constexpr std::size_t word_size = 8;

// The number that eight digits are, the first one in the lowest byte; nothing if one is no digit. Neighbours
// are joined to pairs, to fours and to eight.
std::optional<std::uint64_t> eight_digits(std::uint64_t bytes) {
  constexpr std::uint64_t high = 0xF0F0F0F0F0F0F0F0, zeros = 0x3030303030303030, six = 0x0606060606060606;
  if ((bytes & high) != zeros || ((bytes + six) & high) != zeros) return std::nullopt;
  constexpr auto join = [](std::uint64_t parts, std::uint64_t weight, int bits) {
    return (parts * weight + (parts >> bits));
  };
  std::uint64_t x = bytes - zeros;
  x = join(x, 10, 8) & 0x00FF00FF00FF00FF;
  x = join(x, 100, 16) & 0x0000FFFF0000FFFF;
  return join(x, 10000, 32) & 0x00000000FFFFFFFF;
}

// Puts the digits behind those that are there.
const char* after_digits(const char* at, const char* end, std::uint64_t& digits) {
  std::uint64_t all = digits;
  if constexpr (std::endian::native == std::endian::little) {
    for (; end - at >= static_cast<std::ptrdiff_t>(word_size); at += word_size) {
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, at, word_size);
      const auto eight = eight_digits(bytes);
      if (!eight) break;
      all = 100'000'000 * all + *eight;
    }
  }
  for (; at != end; ++at) {
    const auto digit = static_cast<unsigned>(*at - '0');
    if (digit > 9) break;
    all = 10 * all + digit;
  }
  digits = all;
  return at;
}

// The exponent behind a number, and its end; null if it is none, or has more than four digits.
const char* after_exponent(const char* at, const char* end, int& exponent) {
  const bool is_negative = at != end && *at == '-';
  if (is_negative || (at != end && *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const behind = after_digits(at, end, digits);
  if (behind == at || behind - at > 4) return nullptr;
  exponent = is_negative ? -static_cast<int>(digits) : static_cast<int>(digits);
  return behind;
}

// digits 10^exponent, rounded once. Of the product of both, whose digits are cut, 64 bits are kept; they are
// less than 2 too small. Nothing if they are so near the middle of two doubles that this matters.
std::optional<double> rounded(std::uint64_t digits, int exponent) {
  const auto [m, e] = powers_of_ten[static_cast<std::size_t>(most_digits + exponent)];
  const int lost = std::countl_zero(digits);
  const auto bits = static_cast<std::uint64_t>((Wide{digits << lost} * m) >> 64);
  const int cut = 10 + static_cast<int>(bits >> 63);  // a double has 53 bits
  const std::uint64_t half = std::uint64_t{1} << (cut - 1), rest = bits & (2 * half - 1);
  if (rest == half || rest == half - 1) return std::nullopt;
  const std::uint64_t kept = (bits >> cut) + (rest > half ? 1 : 0);
  const auto power_of_two = [](int n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
  };
  return static_cast<double>(kept) * power_of_two(64 + cut - lost + e);
}

}  // namespace

std::optional<ScannedNumber> scan_shifted(const char* at, const char* end, int shift) {
  const bool is_negative = at != end && *at == '-';
  if (is_negative || (at != end && *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const point = after_digits(at, end, digits);
  const char* const first_decimal = point != end && *point == '.' ? point + 1 : point;
  const char* behind = after_digits(first_decimal, end, digits);
  const auto decimals = behind - first_decimal, count = point - at + decimals;
  if (count == 0 || count > most_digits) return std::nullopt;
  int written = 0;
  if (behind != end && (*behind == 'e' || *behind == 'E')) {
    behind = after_exponent(behind + 1, end, written);
    if (!behind) return std::nullopt;
  }
  const std::int64_t exponent = std::int64_t{shift} + written - decimals;
  if (digits == 0) return ScannedNumber{is_negative ? -0.0 : 0.0, behind};
  if (std::abs(exponent) > most_digits) return std::nullopt;
  const auto value = rounded(digits, static_cast<int>(exponent));
  if (!value) return std::nullopt;
  return ScannedNumber{is_negative ? -*value : *value, behind};
}

std::optional<double> parse_shifted(std::string_view text, int shift) {
  const char* const behind = text.data() + text.size();
  if (const auto number = scan_shifted(text.data(), behind, shift); number && number->end == behind)
    return number->value;
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

const char* exponent_fault(std::string_view text) {
  std::string other{text};
  const auto at = other.find_first_of("Dd");
  if (at == std::string::npos) return "";
  other[at] = 'E';
  return is_finite_number(other) ? "; its exponent has the letter D, where E is needed" : "";
}

const char* number_fault(std::string_view text, int shift) {
  if (!is_finite_number(text))
    return *exponent_fault(text) == '\0' ? "not a finite number"
                                         : "its exponent has the letter D, where E is needed";
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
