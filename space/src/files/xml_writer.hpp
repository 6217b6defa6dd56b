#pragma once

#include <string>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

/// The XML of an ephemeris message in keyword-value notation, as text() writes it. Throws BadInput if a
/// comment is not UTF-8.
std::string xml_of(const std::string& kvn, const MessageKind& kind);

}  // namespace vectrix::detail
