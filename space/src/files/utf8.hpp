#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// Puts a code point, below 0x110000 and no surrogate, behind a text in UTF-8.
inline void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto put_rest = [&](int bits) {
    for (; bits >= 0; bits -= 6) put(0x80U | ((code >> static_cast<unsigned>(bits)) & 0x3FU));
  };
  if (code < 0x80U) {
    put(code);
  } else if (code < 0x800U) {
    put(0xC0U | (code >> 6U));
    put_rest(0);
  } else if (code < 0x10000U) {
    put(0xE0U | (code >> 12U));
    put_rest(6);
  } else {
    put(0xF0U | (code >> 18U));
    put_rest(12);
  }
}

constexpr bool is_surrogate(std::uint32_t code) {
  return code >= 0xD800U && code < 0xE000U;
}

/// The index of the first byte of a text that is not of UTF-8 in its shortest form; its size if all are.
inline std::size_t first_not_utf8(std::string_view text) {
  const auto byte = [&](std::size_t at) {
    return at < text.size() ? std::uint32_t{static_cast<unsigned char>(text[at])} : 0U;
  };
  std::size_t at = 0;
  while (at < text.size()) {
    const std::uint32_t first = byte(at);
    const std::size_t following = first < 0x80U ? 0 : first < 0xE0U ? 1 : first < 0xF0U ? 2 : 3;
    constexpr std::uint32_t least[] = {0U, 0x80U, 0x800U, 0x10000U}, bits[] = {0x7FU, 0x1FU, 0xFU, 0x7U};
    std::uint32_t code = first & bits[following];
    bool follow = first < 0x80U || (first >= 0xC0U && first < 0xF8U);
    for (std::size_t i = 1; i <= following; ++i) {
      follow = follow && (byte(at + i) & 0xC0U) == 0x80U;
      code = (code << 6U) | (byte(at + i) & 0x3FU);
    }
    if (!follow || code < least[following] || code >= 0x110000U || is_surrogate(code)) return at;
    at += following + 1;
  }
  return at;
}

}  // namespace vectrix::detail
