#include "xml_document.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "text_file.hpp"
#include "utf8.hpp"

namespace vectrix::detail {
namespace {

constexpr std::string_view little_endian = "\xFF\xFE", big_endian = "\xFE\xFF", xml_blanks = " \t\r\n";

bool is_utf16(std::string_view text) {
  return text.starts_with(little_endian) || text.starts_with(big_endian);
}

std::string utf8_of_utf16(const std::string& place, std::string_view text) {
  const bool is_little = text.starts_with(little_endian);
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]),
               second = static_cast<unsigned char>(text[at + 1]);
    return is_little ? std::uint32_t{first} | (std::uint32_t{second} << 8U)
                     : std::uint32_t{second} | (std::uint32_t{first} << 8U);
  };
  std::string utf8;
  utf8.reserve(text.size() / 2);
  for (std::size_t at = 2; at < text.size(); at += 2) {
    std::uint32_t code = at + 1 < text.size() ? unit(at) : 0xD800U;
    if (code >= 0xD800U && code < 0xDC00U && at + 3 < text.size() && unit(at + 2) >= 0xDC00U &&
        unit(at + 2) < 0xE000U) {
      code = 0x10000U + ((code - 0xD800U) << 10U) + (unit(at + 2) - 0xDC00U);
      at += 2;
    }
    if (is_surrogate(code)) throw BadInput(place + ": it is no UTF-16 at byte " + detail::text(at));
    append_utf8(utf8, code);
  }
  return utf8;
}

std::string_view without_xml_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(xml_blanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(xml_blanks) - first + 1);
}

// What stands between & and ;. Nothing if it is no character that a message may have.
std::optional<std::uint32_t> character(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, char>, 5> named{
      {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
  for (const auto& [known, meant] : named) {
    if (name == known) return static_cast<std::uint32_t>(meant);
  }
  if (!name.starts_with('#')) return std::nullopt;
  name.remove_prefix(1);
  const int base = name.starts_with('x') ? 16 : 10;
  if (base == 16) name.remove_prefix(1);
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), code, base);
  constexpr std::uint32_t most = 0x10FFFF, deleted = 0x7F;
  if (name.empty() || error != std::errc{} || end != name.data() + name.size() || code < ' ' ||
      code == deleted || code > most || is_surrogate(code))
    return std::nullopt;
  return code;
}

}  // namespace

bool is_xml(std::string_view text) {
  return is_utf16(text) || without_xml_blanks(without_byte_order_mark(text)).starts_with('<');
}

XmlDocument::XmlDocument(std::string place, std::string_view text)
    : place_(std::move(place)),
      text_(is_utf16(text) ? utf8_of_utf16(place_, text) : std::string{without_byte_order_mark(text)}) {
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
  if (const auto zero = text_.find('\0'); zero != std::string::npos)
    fail(position(zero), "the byte 0 is no character of XML");
  const auto wrong = first_not_utf8(text_);
  if (!without_xml_blanks(text_).starts_with('<')) fail(position(0), "UTF-16, but not XML");
  const auto last = text_.find_last_not_of(xml_blanks), doctype = text_.find("<!DOCTYPE");
  const bool has_end = text_[last] == '>';
  constexpr unsigned what = pugi::parse_cdata | pugi::parse_doctype | pugi::parse_declaration;
  const auto result =  // with the 0 at the end
      document_.load_buffer_inplace(text_.data(), text_.size() + 1, what, pugi::encoding_utf8);
  // A document type may be what cannot be parsed.
  for (const pugi::xml_node node : document_.children()) {
    if (node.type() == pugi::node_doctype)
      fail(position(static_cast<std::size_t>(node.offset_debug())),
           "a document type; it can name other files and entities, and is refused");
  }
  if (result.status == pugi::status_bad_doctype) fail(position(doctype), "a document type, which is refused");
  if (!result)
    fail(position(static_cast<std::size_t>(result.offset)),
         "it is not well-formed: " + std::string{result.description()});
  if (!has_end) fail(position(last), "text behind the document");
  require_declaration(is_utf16(text));
  if (wrong != text_.size())
    fail(position(wrong), "the byte " +
                              detail::text(static_cast<int>(static_cast<unsigned char>(text_[wrong]))) +
                              " is not of UTF-8");
  if (const pugi::xml_node second = root().next_sibling())
    fail(second, "a second element outside of the first");
}

void XmlDocument::require_declaration(bool is_wide) const {
  const pugi::xml_node declaration = document_.first_child();
  if (declaration.type() != pugi::node_declaration) return;
  const std::string encoding = upper_case(declaration.attribute("encoding").value());
  const bool is_known = is_wide ? encoding == "UTF-16" : encoding == "UTF-8" || encoding == "US-ASCII";
  if (!encoding.empty() && !is_known)
    fail(declaration, "the encoding is '" + excerpt(encoding) + "'; " +
                          (is_wide ? "the mark of the file is that of UTF-16"
                                   : "UTF-8 is read, and UTF-16 with its mark"));
}

std::string_view XmlDocument::name(pugi::xml_node element) {
  const std::string_view name = element.name();
  return name.substr(name.find(':') + 1);
}

std::vector<pugi::xml_node> XmlDocument::children(pugi::xml_node element, std::string_view wanted) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node child : element.children()) {
    if (name(child) == wanted) found.push_back(child);
  }
  return found;
}

std::string XmlDocument::attribute(pugi::xml_node element, const char* name) const {
  const pugi::xml_attribute found = element.attribute(name);
  for (pugi::xml_attribute next = found.next_attribute(); next; next = next.next_attribute()) {
    if (std::string_view{next.name()} == name)
      fail(element, "the attribute '" + std::string{name} + "' is there twice");
  }
  const std::string value = found.value();
  if (first_wrong(value, KvnText::value) != std::string::npos || value.find('&') != std::string::npos)
    fail(element, "the attribute '" + std::string{name} + "' is not one line of printable ASCII");
  return std::string{trimmed(value)};
}

// A unit in another attribute than `units` would not be seen.
void XmlDocument::require_attributes(pugi::xml_node element) const {
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    const bool is_of_xml = name == "xmlns" || name.find(':') != std::string_view::npos;
    if (!is_of_xml && name != "units" && name != "parameter" && name != "angle" && name != "rate")
      fail(element,
           "the attribute '" + excerpt(name) + "'; a value may have units, parameter, angle or rate");
  }
}

XmlDocument::Value XmlDocument::value(pugi::xml_node element) const {
  require_attributes(element);
  Value value{"", position(element)};
  for (const pugi::xml_node child : element.children()) {
    if (child.type() == pugi::node_element) fail(child, "an element within a value");
    if (value.text.empty()) {
      const auto offset = static_cast<std::size_t>(child.offset_debug());
      const std::string_view raw = child.value();
      value.position = position(offset + std::min(raw.find_first_not_of(xml_blanks), raw.size()));
    }
    value.text += child.type() == pugi::node_cdata ? std::string{child.value()} : decoded(child);
  }
  value.text = without_xml_blanks(value.text);
  return value;
}

void XmlDocument::require_elements(pugi::xml_node element) const {
  for (const pugi::xml_node child : element.children()) {
    if (child.type() != pugi::node_element && !without_xml_blanks(child.value()).empty())
      fail(child, "text between elements");
  }
}

std::string XmlDocument::decoded(pugi::xml_node node) const {
  const std::string_view raw = node.value();
  std::string text;
  for (std::size_t at = 0; at < raw.size();) {
    const auto mark = std::min(raw.find('&', at), raw.size());
    text += raw.substr(at, mark - at);
    if (mark == raw.size()) break;
    const auto end = raw.find(';', mark);
    const auto code =
        end == std::string_view::npos ? std::nullopt : character(raw.substr(mark + 1, end - mark - 1));
    if (!code)
      fail(position(static_cast<std::size_t>(node.offset_debug()) + mark),
           "'" + excerpt(raw.substr(mark, end - mark + 1)) + "' is no entity of XML");
    append_utf8(text, *code);
    at = end + 1;
  }
  return text;
}

TextPosition XmlDocument::position(pugi::xml_node element) const {
  return position(static_cast<std::size_t>(element.offset_debug()));
}

TextPosition XmlDocument::position(std::size_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return {static_cast<std::size_t>(next - line_starts_.begin()), offset - *std::prev(next) + 1};
}

void XmlDocument::fail(pugi::xml_node element, const std::string& reason) const {
  fail(position(element), (*element.name() ? "<" + excerpt(element.name()) + ">: " : "") + reason);
}

void XmlDocument::fail(const TextPosition& at, const std::string& reason) const {
  throw BadInput(place_ + ", line " + detail::text(at.line) + ", column " + detail::text(at.column) + ": " +
                 reason);
}

}  // namespace vectrix::detail
