#pragma once

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/scalar/batch.hpp>

namespace vectrix {

namespace detail {

/// The text with its control characters, but for tabs and line ends, as \x00: what() would end at a zero.
inline std::string printable(const std::string& text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string shown;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if ((code >= ' ' && code != 127) || c == '\t' || c == '\n') {
      shown += c;
    } else {
      shown += {'\\', 'x', digits[code / 16], digits[code % 16]};
    }
  }
  return shown;
}

}  // namespace detail

/// Wrong data at a door. The text names the action, the operands and the wrong number; control characters of
/// a file appear in it as \x00. Exported, so that other shared libraries can catch it by its type.
class VECTRIX_EXPORT BadInput : public std::invalid_argument {
 public:
  explicit BadInput(const std::string& text) : std::invalid_argument(detail::printable(text)) {}
};

namespace detail {

/// The shortest text that reads back as the same number. A batch gives one text per lane: {1, 2.5}.
template <class Number> std::string text(const Number& value) {
  if constexpr (std::is_arithmetic_v<Number>) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
  } else if constexpr (Batch<Number>) {
    std::string lanes;
    for (std::size_t i = 0; i < Number::size(); ++i) {
      lanes += (i == 0 ? "{" : ", ") + text(typename Number::value_type(value[i]));
    }
    return lanes + "}";
  } else {
    std::ostringstream out;
    out << value;
    return out.str();
  }
}

}  // namespace detail
}  // namespace vectrix
