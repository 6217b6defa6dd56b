#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kvn.hpp"
#include "xml_columns.hpp"
#include "xml_document.hpp"

namespace vectrix::detail {

/// A text in keyword-value notation that is made of the elements of a document, and where its parts stand
/// there.
class XmlText {
 public:
  explicit XmlText(const XmlDocument& document) : document_(document) {}

 protected:
  /// A line of one word.
  void put_word(const std::string& word, pugi::xml_node element);
  void put_keyword(const std::string& keyword, const TextPosition& place, const XmlDocument::Value& value);
  /// A line for each line of the comment.
  void put_comment(pugi::xml_node entry);
  /// COMMENT, or a keyword with the value of the element and its units.
  void put_entry(pugi::xml_node entry);
  /// A line of data, whose columns are elements in `state`, one each, in any order; before it the comments
  /// there.
  void put_line(pugi::xml_node state, const std::vector<XmlColumn>& columns);
  /// One word, with its unit or without one, and what follows it.
  void put_number(pugi::xml_node element, const XmlColumn& column, std::string_view end);

  const XmlDocument& document_;
  std::string text_{};
  std::vector<TextOrigin> origins_{};

 private:
  struct Field {
    std::string name;
    pugi::xml_node element;
  };

  void put(std::string_view text, const TextPosition& position);
  [[nodiscard]] XmlDocument::Value value_of(pugi::xml_node entry) const;
  [[nodiscard]] std::string keyword_of(pugi::xml_node entry) const;
  void require_turn(pugi::xml_node rotation) const;
  std::vector<Field> fields_of(pugi::xml_node state, int depth);
};

}  // namespace vectrix::detail
