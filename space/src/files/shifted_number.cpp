#include "shifted_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "text_file.hpp"

namespace vectrix::detail {
namespace {

struct Parts {
  std::string_view digits;
  int exponent;
};

std::optional<Parts> parts_of(std::string_view text) {
  const auto e = text.find_first_of("eE");
  if (e == std::string_view::npos) return Parts{text, 0};
  std::string_view written = text.substr(e + 1);
  if (written.starts_with('+') && !written.starts_with("+-")) written.remove_prefix(1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), exponent);
  constexpr int most = 10000;
  if (error != std::errc{} || end != written.data() + written.size() || std::abs(exponent) > most)
    return std::nullopt;
  return Parts{text.substr(0, e), exponent};
}

}  // namespace

std::optional<double> parse_shifted(std::string_view text, int shift) {
  constexpr std::size_t most = 100;
  const auto finite = [](std::optional<double> value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
  };
  if (shift == 0) return finite(parse_number(text));
  const auto parts = parts_of(text);
  if (!parts || text.size() > most) return std::nullopt;
  std::array<char, most + 16> buffer{};
  char* end = std::copy(parts->digits.begin(), parts->digits.end(), buffer.data());
  *end++ = 'e';
  end = std::to_chars(end, buffer.data() + buffer.size(), parts->exponent + shift).ptr;
  return finite(parse_number({buffer.data(), static_cast<std::size_t>(end - buffer.data())}));
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
