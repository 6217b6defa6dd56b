#include "kvn.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr std::string_view comment_word = "COMMENT";

bool may_stand(char c, KvnText where) {
  const auto code = static_cast<unsigned char>(c);
  if (c == '\t') return where != KvnText::value;
  return code >= ' ' && code != 127 && (code < 127 || where == KvnText::comment);
}
bool is_comment(std::string_view text) {
  return text.starts_with(comment_word) &&
         (text.size() == comment_word.size() || text[comment_word.size()] == ' ' ||
          text[comment_word.size()] == '\t');
}

std::string line_place(const std::string& place, std::size_t line, std::size_t column) {
  return place + ", line " + text(line) + ", column " + text(column);
}

}  // namespace

bool is_keyword(std::string_view text) {
  return !text.empty() &&
         text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string_view::npos;
}

std::size_t first_wrong(std::string_view text, KvnText where) {
  const auto* const wrong =
      std::find_if_not(text.begin(), text.end(), [&](char c) { return may_stand(c, where); });
  return wrong == text.end() ? std::string_view::npos : static_cast<std::size_t>(wrong - text.begin());
}

void refuse(const std::string& place, const KvnLine& line, const std::string& reason) {
  throw BadInput(line_place(place, line.line, line.column) + " (" + excerpt(line.keyword) + "): '" +
                 excerpt(line.value) + "': " + reason);
}

std::string upper_case(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

KvnReader::KvnReader(std::string place, std::string_view text, bool whole)
    : place_(std::move(place)), text_(without_byte_order_mark(text)), rest_(text_), whole_(whole) {}

KvnReader::KvnReader(std::string place, std::string_view text, std::span<const TextOrigin> origins)
    : place_(std::move(place)), text_(text), rest_(text), origins_(origins), whole_(true) {}

bool KvnReader::next() {
  for (content_ = {}; content_.empty(); ++number_) {
    if (rest_.empty()) return false;
    line_ = take_line(rest_);
    content_ = trimmed(line_);
  }
  const auto may_be_cut = [&] { return !is_comment() && (has_keyword() || !content_.ends_with("_STOP")); };
  if (rest_.empty() && !whole_ && may_be_cut())
    throw BadInput(place_ + ", line " + text(line()) + ": " +
                   (line_.find('\r') == std::string_view::npos ? truncated : with_bare_returns));
  return true;
}

bool KvnReader::is_comment() const {
  return detail::is_comment(content_);
}

std::string KvnReader::comment() const {
  require_characters(line_, KvnText::comment);
  const auto behind = static_cast<std::size_t>(content_.data() - line_.data()) + comment_word.size();
  return std::string{line_.substr(std::min(behind + 1, line_.size()))};
}

KvnLine KvnReader::keyword() const {
  require_characters(line_, KvnText::line);
  const auto equals = content_.find('=');
  if (equals == std::string_view::npos) fail("expected keyword = value");
  const std::string_view keyword = trimmed(content_.substr(0, equals));
  if (!is_keyword(keyword))
    throw BadInput(here(content_.data()) + ": '" + excerpt(keyword) + "' is no keyword");
  const std::string_view value = trimmed(content_.substr(equals + 1));
  require_characters(value, KvnText::value);
  const auto [line, column] = position(value.empty() ? content_.data() + equals + 1 : value.data());
  return {std::string{keyword}, std::string{value}, line, column};
}

std::size_t KvnReader::words(std::array<std::string_view, most_words>& words) const {
  const char *at = content_.data(), *const end = at + content_.size();
  std::size_t count = 0;
  for (; at != end; ++count) {
    const char* const word = at;
    while (at != end && !is_blank(*at)) ++at;
    if (count < most_words) words[count] = {word, static_cast<std::size_t>(at - word)};
    while (at != end && is_blank(*at)) ++at;
  }
  return count;
}

void KvnReader::fail(const std::string& reason) const {
  require_characters(line_, KvnText::line);
  throw BadInput(here(content_.data()) + ": '" + excerpt(content_) + "': " + reason);
}

void KvnReader::fail(std::string_view word, std::string_view name, const std::string& reason) const {
  require_characters(line_, KvnText::line);
  throw BadInput(here(word.data()) + " (" + std::string{name} + "): '" + excerpt(word) + "': " + reason);
}

void KvnReader::require_characters(std::string_view text, KvnText where) const {
  const auto wrong = first_wrong(text, where);
  if (wrong == std::string_view::npos) return;
  throw BadInput(here(text.data() + wrong) + ": the byte " +
                 detail::text(static_cast<int>(static_cast<unsigned char>(text[wrong]))) +
                 " is no printable character of ASCII");
}

TextPosition KvnReader::position(const char* at) const {
  if (origins_.empty()) return {number_, static_cast<std::size_t>(at - line_.data()) + 1};
  const auto offset = static_cast<std::size_t>(at - text_.data());
  const auto next =
      std::upper_bound(origins_.begin(), origins_.end(), offset,
                       [](std::size_t wanted, const auto& origin) { return wanted < origin.offset; });
  const TextOrigin& origin = *std::prev(next);
  return {origin.position.line, origin.position.column + (offset - origin.offset)};
}

std::string KvnReader::here(const char* at) const {
  const auto [line, column] = position(at);
  return line_place(place_, line, column);
}

}  // namespace vectrix::detail
