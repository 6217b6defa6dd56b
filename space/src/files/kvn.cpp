#include "kvn.hpp"

#include <vectrix/frames/errors.hpp>

#include "text_file.hpp"

namespace vectrix::detail {
namespace {

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < ' ' && c != '\t') || code == 127;
}
bool is_comment(std::string_view text) {
  constexpr std::string_view word = "COMMENT";
  return text.starts_with(word) &&
         (text.size() == word.size() || text[word.size()] == ' ' || text[word.size()] == '\t');
}

}  // namespace

std::optional<KvnLine> read_kvn_line(const std::string& place, std::size_t number, std::string_view line) {
  const auto refuse = [&](std::size_t index, const std::string& reason) {
    throw BadInput(place + ", line " + text(number) + ", column " + text(index + 1) + ": " + reason);
  };
  const std::string_view content = trimmed(line);
  const bool comment = is_comment(content);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto code = static_cast<unsigned char>(line[i]);
    if (is_control(line[i]) || (code > 127 && !comment))
      refuse(i, "the byte " + text(static_cast<int>(code)) + " is no printable character of ASCII");
  }
  if (content.empty() || comment) return std::nullopt;

  const auto first = static_cast<std::size_t>(content.data() - line.data());
  const auto equals = content.find('=');
  if (equals == std::string_view::npos) refuse(first, "'" + excerpt(content) + "': expected keyword = value");
  const std::string_view keyword = trimmed(content.substr(0, equals));
  if (keyword.empty() ||
      keyword.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != std::string_view::npos)
    refuse(first, "'" + excerpt(keyword) + "' is no keyword");

  const std::string_view value = trimmed(content.substr(equals + 1));
  const std::size_t column =
      value.empty() ? first + equals + 1 : static_cast<std::size_t>(value.data() - line.data());
  return KvnLine{std::string{keyword}, std::string{value}, number, column + 1};
}

}  // namespace vectrix::detail
