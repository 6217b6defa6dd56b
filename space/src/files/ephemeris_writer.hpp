#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

// How orbit and attitude ephemeris messages are written.

void write_line(std::string& out, std::string_view keyword, const std::string& value);
void write_comments(std::string& out, const std::vector<std::string>& comments);
void write_header(std::string& out, const MessageHeader& header, const MessageKind& kind);
/// OBJECT_NAME to CENTER_NAME; TIME_SYSTEM to STOP_TIME; the interpolation and the other keywords.
void write_object(std::string& out, const EphemerisMetadata& metadata);
void write_span(std::string& out, const EphemerisMetadata& metadata);
void write_rest(std::string& out, const EphemerisMetadata& metadata, std::string_view keyword);

}  // namespace vectrix::detail
