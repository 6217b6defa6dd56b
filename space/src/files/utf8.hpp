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

/// Whether a text is UTF-8, without asking for the shortest form.
inline bool is_utf8(std::string_view text) {
  std::size_t following = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool follows = (byte & 0xC0U) == 0x80U;
    if (follows != (following > 0)) return false;
    if (follows) {
      --following;
    } else if (byte >= 0x80U) {
      if (byte < 0xC2U || byte > 0xF4U) return false;
      following = byte < 0xE0U ? 1 : byte < 0xF0U ? 2 : 3;
    }
  }
  return following == 0;
}

}  // namespace vectrix::detail
