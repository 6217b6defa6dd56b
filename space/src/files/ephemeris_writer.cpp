#include "ephemeris_writer.hpp"

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

namespace vectrix::detail {

void write_line(std::string& out, std::string_view keyword, const std::string& value) {
  out.append(keyword).append(value.empty() ? " =" : " = ").append(value).append("\n");
}

void write_comments(std::string& out, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) out.append("COMMENT ").append(comment).append("\n");
}

namespace {

void write_others(std::string& out, const std::vector<OtherKeyword>& others) {
  for (const OtherKeyword& other : others) write_line(out, other.keyword, other.value);
}

}  // namespace

void write_header(std::string& out, const MessageHeader& header, const MessageKind& kind) {
  write_line(out, kind.version_keyword, header.version);
  write_comments(out, header.comments);
  if (!header.classification.empty()) write_line(out, "CLASSIFICATION", header.classification);
  write_line(out, "CREATION_DATE", header.creation_date);
  write_line(out, "ORIGINATOR", header.originator);
  if (!header.message_id.empty()) write_line(out, "MESSAGE_ID", header.message_id);
  write_others(out, header.others);
}

void write_object(std::string& out, const EphemerisMetadata& metadata) {
  write_comments(out, metadata.comments);
  write_line(out, "OBJECT_NAME", metadata.object_name);
  write_line(out, "OBJECT_ID", metadata.object_id);
  if (!metadata.center_name.empty()) write_line(out, "CENTER_NAME", metadata.center_name);
}

void write_span(std::string& out, const EphemerisMetadata& metadata) {
  const auto write_time = [&](const char* keyword, const std::optional<Epoch>& time) {
    if (time) write_line(out, keyword, exact_text(*time, metadata.time_system));
  };
  write_line(out, "TIME_SYSTEM", metadata.time_system.name());
  write_time("START_TIME", metadata.start_time);
  write_time("USEABLE_START_TIME", metadata.useable_start_time);
  write_time("USEABLE_STOP_TIME", metadata.useable_stop_time);
  write_time("STOP_TIME", metadata.stop_time);
}

void write_rest(std::string& out, const EphemerisMetadata& metadata, std::string_view keyword) {
  if (!metadata.interpolation.empty()) write_line(out, keyword, metadata.interpolation);
  if (metadata.interpolation_degree)
    write_line(out, "INTERPOLATION_DEGREE", text(*metadata.interpolation_degree));
  write_others(out, metadata.others);
}

}  // namespace vectrix::detail
