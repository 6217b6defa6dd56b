#include "report/text.hpp"

#include <bit>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {
namespace {

static_assert(std::endian::native == std::endian::little);

std::string base64_of_bytes(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> unsigned {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned group = byte(0) << 16U | byte(1) << 8U | byte(2);
    text += digits[group >> 18U];
    text += digits[group >> 12U & 63U];
    text += i + 1 < bytes.size() ? digits[group >> 6U & 63U] : '=';
    text += i + 2 < bytes.size() ? digits[group & 63U] : '=';
  }
  return text;
}

template <class Number> std::string_view bytes_of(std::span<const Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : detail::printable(std::string(text))) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string element(std::string_view name,
                    std::initializer_list<std::pair<std::string_view, std::string>> attributes,
                    std::string_view inside) {
  std::string text = "<" + std::string(name);
  for (const auto& [key, value] : attributes) text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  return text + ">" + std::string(inside) + "</" + std::string(name) + ">";
}

std::string json_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : detail::printable(std::string(text))) {
    if (c == '<') {
      result += "\\u003c";
    } else if (c == '\t') {
      result += "\\t";
    } else if (c == '\n') {
      result += "\\n";
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + '"';
}

std::string json_list(std::span<const double> numbers) {
  std::string text = "[";
  for (const double x : numbers) text += (text.size() == 1 ? "" : ",") + detail::text(x);
  return text + "]";
}

std::string base64(std::span<const float> numbers) {
  return base64_of_bytes(bytes_of(numbers));
}
std::string base64(std::span<const double> numbers) {
  return base64_of_bytes(bytes_of(numbers));
}

}  // namespace vectrix::cli
