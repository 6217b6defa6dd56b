#pragma once

#include <string>
#include <string_view>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

/// The XML of an ephemeris message in keyword-value notation, as text() writes it. Throws BadInput if a
/// comment is not UTF-8.
std::string xml_of(const std::string& kvn, const MessageKind& kind);

/// An element on a line of its own; the attributes begin with a blank.
std::string xml_leaf(std::string_view keyword, std::string_view value, std::string_view attributes = "");
/// Throws BadInput, which begins with `place`, if the comment is not UTF-8.
std::string xml_comment(const std::string& place, const std::string& comment);

}  // namespace vectrix::detail
