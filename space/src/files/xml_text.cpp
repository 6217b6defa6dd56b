#include "xml_text.hpp"

#include <algorithm>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "text_file.hpp"

namespace vectrix::detail {

using pugi::xml_node;

void XmlText::put(std::string_view text, const TextPosition& position) {
  if (text.empty()) return;
  origins_.push_back({text_.size(), position});
  text_ += text;
}

void XmlText::put_word(const std::string& word, xml_node element) {
  put(word + "\n", document_.position(element));
}

void XmlText::put_keyword(const std::string& keyword, const TextPosition& place,
                          const XmlDocument::Value& value) {
  put(keyword + " =", place);
  put(" ", value.position);
  put(value.text + "\n", value.position);
}

void XmlText::put_comment(xml_node entry) {
  const auto [text, position] = document_.value(entry);
  std::string_view rest = text;
  do {
    const std::string_view line = take_line(rest);
    put("COMMENT " + std::string{trimmed(line)} + "\n", position);
  } while (!rest.empty());
}

void XmlText::put_entry(xml_node entry) {
  if (XmlDocument::name(entry) == "COMMENT") return put_comment(entry);
  const std::string keyword = keyword_of(entry);
  if (!is_keyword(keyword)) document_.fail(entry, "'" + excerpt(keyword) + "' is no keyword");
  XmlDocument::Value value = value_of(entry);
  const std::string unit = document_.attribute(entry, "units");
  if (!unit.empty()) value.text += " [" + unit + "]";
  put_keyword(keyword, document_.position(entry), value);
}

// The text of an element, which must be one line.
XmlDocument::Value XmlText::value_of(xml_node entry) const {
  XmlDocument::Value value = document_.value(entry);
  if (value.text.find_first_of("\r\n") != std::string::npos)
    document_.fail(entry, "its value is of several lines");
  return value;
}

// The keyword of an element: its name, or what its attribute says.
std::string XmlText::keyword_of(xml_node entry) const {
  const std::string name{XmlDocument::name(entry)};
  if (name == "USER_DEFINED") return "USER_DEFINED_" + document_.attribute(entry, "parameter");
  if (name != "rotation1" && name != "rotation2" && name != "rotation3") return name;
  require_turn(entry);
  const std::string angle = document_.attribute(entry, "angle"), rate = document_.attribute(entry, "rate");
  return angle.empty() ? rate : angle;
}

// The turns are told apart by their place: of a sequence such as 313 two have one attribute.
void XmlText::require_turn(xml_node rotation) const {
  int place = 1;
  for (xml_node before = rotation.previous_sibling(); before; before = before.previous_sibling())
    place += XmlDocument::name(before).starts_with("rotation") ? 1 : 0;
  const std::string expected = "rotation" + text(place);
  if (XmlDocument::name(rotation) != expected) document_.fail(rotation, "expected " + expected);
}

// The elements with values in an element and in those that it has; the comments go into the text.
std::vector<XmlText::Field> XmlText::fields_of(xml_node state, int depth) {
  constexpr int deepest = 3;
  std::vector<Field> fields;
  document_.require_elements(state);
  for (const xml_node entry : state.children()) {
    if (XmlDocument::name(entry) == "COMMENT") {
      put_comment(entry);
    } else if (entry.first_child().type() != pugi::node_element) {
      fields.push_back({keyword_of(entry), entry});
    } else {
      if (depth == deepest) document_.fail(entry, "elements within so many others are not of a message");
      for (Field& field : fields_of(entry, depth + 1)) fields.push_back(std::move(field));
    }
  }
  return fields;
}

void XmlText::put_line(xml_node state, const std::vector<XmlColumn>& columns) {
  std::vector<Field> fields = fields_of(state, 0);
  for (const XmlColumn& column : columns) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& each) { return each.name == column.name; });
    if (field == fields.end()) document_.fail(state, "there is no " + column.name);
    put_number(field->element, column, &column == &columns.back() ? "\n" : " ");
    fields.erase(field);
  }
  if (!fields.empty())
    document_.fail(fields.front().element,
                   "'" + excerpt(fields.front().name) + "' is not of this line of data, or twice");
}

void XmlText::put_number(xml_node element, const XmlColumn& column, std::string_view end) {
  XmlDocument::Value value = value_of(element);
  if (value.text.empty()) document_.fail(element, "it is empty");
  if (value.text.find_first_of(" \t") != std::string::npos)
    document_.fail(value.position, "'" + excerpt(value.text) + "': more than one number");
  const std::string unit = document_.attribute(element, "units");
  if (!unit.empty() && upper_case(unit) != upper_case(column.unit))
    document_.fail(element, "the unit is '" + excerpt(unit) + "'" +
                                (column.unit.empty() ? "; it has no unit" : ", not '" + column.unit + "'"));
  put(value.text.append(end), value.position);
}

}  // namespace vectrix::detail
