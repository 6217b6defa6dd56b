#include "text_file.hpp"

#include <charconv>
#include <fstream>
#include <istream>
#include <sstream>
#include <system_error>
#include <utility>

#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {

namespace {

TextFile lines_from(std::istream& in) {
  TextFile result;
  for (std::string line; std::getline(in, line);) {
    result.whole = !in.eof();
    if (!line.empty() && line.back() == '\r') line.pop_back();
    result.lines.push_back(line);
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (!result.lines.empty() && result.lines.front().starts_with(byte_order_mark)) {
    result.lines.front().erase(0, byte_order_mark.size());
  }
  return result;
}

}  // namespace

TextFile lines_of(std::string_view text) {
  std::istringstream in{std::string{text}};
  return lines_from(in);
}

std::optional<TextFile> read_lines(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  auto result = lines_from(in);
  return in.bad() ? std::nullopt : std::optional{std::move(result)};
}

void write_file(const std::string& place, const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!out) throw BadInput(place + ": cannot be written");
  out << text;
  out.close();
  if (!out) throw BadInput(place + ": was not written to its end");
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? std::string{text} : std::string{text.substr(0, longest)} + "...";
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace vectrix::detail
