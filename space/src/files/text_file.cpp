#include "text_file.hpp"

#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>

#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {

TextFile lines_of(std::string_view text) {
  TextFile result;
  text = without_byte_order_mark(text);
  while (!text.empty()) result.lines.emplace_back(take_line(text));
  return result;
}

std::optional<TextFile> read_lines(const std::filesystem::path& file) {
  const auto bytes = read_bytes(file);
  if (!bytes) return std::nullopt;
  TextFile result = lines_of(*bytes);
  result.whole = is_whole(*bytes);
  return result;
}

std::optional<std::string> read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes;
  constexpr std::size_t at_once = 1 << 16;
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(file, unknown); !unknown) bytes.reserve(size + at_once);
  while (in) {
    const std::size_t size = bytes.size();
    bytes.resize(size + at_once);
    in.read(bytes.data() + size, at_once);
    bytes.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  return in.bad() ? std::nullopt : std::optional{std::move(bytes)};
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void write_file(const std::string& place, const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!out) throw BadInput(place + ": cannot be written");
  out << text;
  out.close();
  if (!out) throw BadInput(place + ": was not written to its end");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? std::string{text} : std::string{text.substr(0, longest)} + "...";
}

std::string_view without_plus(std::string_view number) {
  return number.starts_with('+') && !number.starts_with("+-") ? number.substr(1) : number;
}

std::optional<double> parse_number(std::string_view text) {
  text = without_plus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace vectrix::detail
