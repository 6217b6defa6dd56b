#include "orbit_ephemeris_text.hpp"

#include <vectrix/space/time/exact_text.hpp>

#include "ephemeris_writer.hpp"
#include "shifted_number.hpp"
#include "text_file.hpp"
#include "xml_writer.hpp"

namespace vectrix {
namespace {

void write_numbers(std::string& out, const Eigen::Vector3d& v) {
  for (const double x : v) out.append(" ").append(detail::shifted_text(x, detail::kilo));
}

void write_covariance(std::string& out, const OrbitCovariance& covariance, const TimeScale& scale) {
  detail::write_line(out, "EPOCH", exact_text(covariance.epoch, scale));
  if (!covariance.ref_frame.empty()) detail::write_line(out, "COV_REF_FRAME", covariance.ref_frame);
  std::size_t next = 0;
  for (std::size_t row = 0; row < 6; ++row) {
    for (std::size_t i = 0; i <= row; ++i)
      out.append(i == 0 ? "" : " ").append(detail::shifted_text(covariance.lower_triangle[next++], 0));
    out.append("\n");
  }
}

void write_segment(std::string& out, const OrbitEphemerisSegment& segment) {
  const EphemerisMetadata& metadata = segment.metadata();
  const detail::OrbitLines& lines = segment.lines(detail::trusted);
  out.append("\nMETA_START\n");
  detail::write_object(out, metadata);
  detail::write_line(out, "REF_FRAME", lines.ref_frame);
  if (lines.ref_frame_epoch)
    detail::write_line(out, "REF_FRAME_EPOCH", exact_text(*lines.ref_frame_epoch, metadata.time_system));
  detail::write_span(out, metadata);
  detail::write_rest(out, metadata, detail::orbit_interpolation);
  out.append("META_STOP\n\n");
  detail::write_comments(out, lines.comments);
  for (const detail::OrbitLine& line : lines.lines) {
    out.append(exact_text(line.time, metadata.time_system));
    write_numbers(out, line.position);
    write_numbers(out, line.velocity);
    if (line.acceleration) write_numbers(out, *line.acceleration);
    out.append("\n");
  }
  if (lines.covariances.empty()) return;
  out.append("\nCOVARIANCE_START\n");
  for (const OrbitCovariance& covariance : lines.covariances)
    write_covariance(out, covariance, metadata.time_system);
  out.append("COVARIANCE_STOP\n");
}

}  // namespace

std::string OrbitEphemerisMessage::text() const {
  std::string out;
  detail::write_header(out, header_, detail::orbit_ephemeris);
  for (const OrbitEphemerisSegment& segment : segments_) write_segment(out, segment);
  return out;
}

std::string OrbitEphemerisMessage::xml() const {
  return detail::xml_of(text(), detail::orbit_ephemeris);
}

void OrbitEphemerisMessage::write(const std::filesystem::path& file) const {
  detail::write_file(std::string{detail::orbit_ephemeris.name} + " " + file.string(), file,
                     file.extension() == ".xml" ? xml() : text());
}

}  // namespace vectrix
