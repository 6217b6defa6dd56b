#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kvn.hpp"

namespace vectrix::detail {

/// A message of an XML document as a text in keyword-value notation, and where its parts stand in the
/// document.
struct XmlMessage {
  std::string element;  // aem
  TextPosition position;
  std::string text{};  // empty if messages of this kind are not read
  std::vector<TextOrigin> origins{};
};

struct XmlMessages {
  bool is_combined = false;
  std::vector<std::string> comments{};  // of the combined message
  std::vector<XmlMessage> messages{};
};

/// The message of a document, or those of a combined one, <ndm>. Throws BadInput with place, line and column.
XmlMessages read_xml(const std::string& place, std::string_view text);

/// Those of a document that has only messages of one kind, <aem> for example.
std::vector<XmlMessage> messages_in_xml(const std::string& place, std::string_view text,
                                        const std::string& element);

}  // namespace vectrix::detail
