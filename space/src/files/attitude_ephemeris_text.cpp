#include <vectrix/space/files/attitude_ephemeris_message.hpp>

#include <vectrix/space/time/exact_text.hpp>

#include "attitude_lines.hpp"
#include "ephemeris_writer.hpp"
#include "shifted_number.hpp"
#include "text_file.hpp"
#include "xml_writer.hpp"

namespace vectrix {
namespace {

using detail::has_direction, detail::rate_keyword, detail::type_name;

void write_type(std::string& out, const detail::AttitudeLines& lines, const std::string& version) {
  detail::write_line(out, "ATTITUDE_TYPE", type_name(lines.type, version));
  if (has_direction(version) && detail::has_quaternion(lines.type))
    detail::write_line(out, "QUATERNION_TYPE", lines.is_scalar_first ? "FIRST" : "LAST");
  if (!lines.euler_sequence.empty()) detail::write_line(out, "EULER_ROT_SEQ", lines.euler_sequence);
  if (lines.rate_frame != detail::RateFrame::none)
    detail::write_line(out, rate_keyword(version), detail::rate_frame_name(lines.rate_frame));
}

void write_segment(std::string& out, const AttitudeEphemerisSegment& segment, const std::string& version) {
  const EphemerisMetadata& metadata = segment.metadata();
  const detail::AttitudeLines& lines = segment.lines(detail::trusted);
  out.append("\nMETA_START\n");
  detail::write_object(out, metadata);
  detail::write_line(out, "REF_FRAME_A", lines.ref_frame_a);
  detail::write_line(out, "REF_FRAME_B", lines.ref_frame_b);
  if (has_direction(version)) detail::write_line(out, "ATTITUDE_DIR", lines.is_b_to_a ? "B2A" : "A2B");
  detail::write_span(out, metadata);
  write_type(out, lines, version);
  detail::write_rest(out, metadata, detail::attitude_interpolation);
  out.append("META_STOP\n\nDATA_START\n");
  detail::write_comments(out, lines.comments);
  auto number = lines.numbers.begin();
  for (const Epoch& time : lines.times) {
    out.append(exact_text(time, metadata.time_system));
    for (std::size_t i = 0; i < detail::numbers_in_line(lines.type); ++i)
      out.append(" ").append(detail::shifted_text(*number++, 0));
    out.append("\n");
  }
  out.append("DATA_STOP\n");
}

}  // namespace

std::string AttitudeEphemerisMessage::text() const {
  std::string out;
  detail::write_header(out, header_, detail::attitude_ephemeris);
  for (const AttitudeEphemerisSegment& segment : segments_) write_segment(out, segment, header_.version);
  return out;
}

std::string AttitudeEphemerisMessage::xml() const {
  return detail::xml_of(text(), detail::attitude_ephemeris);
}

void AttitudeEphemerisMessage::write(const std::filesystem::path& file) const {
  detail::write_file(std::string{detail::attitude_ephemeris.name} + " " + file.string(), file,
                     file.extension() == ".xml" ? xml() : text());
}

}  // namespace vectrix
