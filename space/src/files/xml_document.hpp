#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "kvn.hpp"

namespace vectrix::detail {

/// Whether a file is XML: it begins with <, or with the mark of UTF-16.
bool is_xml(std::string_view text);

/// An XML document, in UTF-8, or in UTF-16 with its mark. A document type is refused, and with it entities
/// that are not of XML. Every error is a BadInput with place, line and column; columns count bytes of UTF-8.
class XmlDocument {
 public:
  XmlDocument(std::string place, std::string_view text);
  XmlDocument(XmlDocument&&) = delete;

  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
  [[nodiscard]] const std::string& place() const { return place_; }

  /// The name without a prefix.
  [[nodiscard]] static std::string_view name(pugi::xml_node element);
  /// The elements in it with a name, also behind a prefix.
  [[nodiscard]] static std::vector<pugi::xml_node> children(pugi::xml_node element, std::string_view name);
  /// An attribute, which must be printable; empty if it is not there.
  [[nodiscard]] std::string attribute(pugi::xml_node element, const char* name) const;
  /// The text without the blanks around it, and where it begins. Refuses an element that has elements.
  struct Value {
    std::string text;
    TextPosition position;
  };
  [[nodiscard]] Value value(pugi::xml_node element) const;
  /// Refuses text between elements.
  void require_elements(pugi::xml_node element) const;

  [[nodiscard]] TextPosition position(pugi::xml_node element) const;
  [[noreturn]] void fail(pugi::xml_node element, const std::string& reason) const;
  [[noreturn]] void fail(const TextPosition& position, const std::string& reason) const;

 private:
  [[nodiscard]] TextPosition position(std::size_t offset) const;
  void require_declaration(bool is_utf16) const;
  void require_attributes(pugi::xml_node element) const;
  [[nodiscard]] std::string decoded(pugi::xml_node text) const;

  std::string place_, text_;  // the document points into the text
  std::vector<std::size_t> line_starts_{};
  pugi::xml_document document_{};
};

}  // namespace vectrix::detail
