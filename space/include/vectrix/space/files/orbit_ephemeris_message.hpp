#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/orbit_ephemeris_segment.hpp>

namespace vectrix {

/// An orbit ephemeris message (OEM, CCSDS 502.0-B, versions 1.0, 2.0 and 3.0) in keyword-value notation or
/// XML.
///     const auto message = OrbitEphemerisMessage::read("sat.oem");
///     const auto orbit = message.segments().front().sampled_edge<earth::Eme2000, Satellite>(gap);
/// Time systems: UTC, TAI, TT, TDB, GPS, the same in all segments. Lines of data may have an acceleration,
/// and a segment covariances, but not in version 1.0. Keywords that are there twice, in the wrong part, or
/// one or two characters off one of the standard are refused; others are kept, as comments are. The order is
/// not checked.
class VECTRIX_EXPORT OrbitEphemerisMessage {
 public:
  /// Throws BadInput if there is no segment, their time systems differ, the version is none of the three, or
  /// a segment has what the version does not have.
  OrbitEphemerisMessage(MessageHeader header, std::vector<OrbitEphemerisSegment> segments);

  /// The end of the text ends its last line. Throws BadInput with line, column, what was found there and why
  /// it is wrong, or the keyword that is missing.
  static OrbitEphemerisMessage parse(std::string_view text);
  /// Throws BadInput with the file, too, and if the file cannot be read or stops within a line.
  static OrbitEphemerisMessage read(const std::filesystem::path& file);

  /// The message as text. A number is the shortest text that reads back as the same one, so that
  /// parse(text()) has the same samples. An epoch has 3, 6, 9 or 12 decimals: one that was read from a text
  /// reads back as the same, any other within 1e-11 s.
  [[nodiscard]] std::string text() const;
  /// The same in XML. Comments lose the blanks around them. Throws BadInput if one is not UTF-8.
  [[nodiscard]] std::string xml() const;
  /// As XML if the name ends in .xml. Throws BadInput if the file cannot be written.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] const MessageHeader& header() const { return header_; }
  [[nodiscard]] const std::vector<OrbitEphemerisSegment>& segments() const { return segments_; }

 private:
  MessageHeader header_;
  std::vector<OrbitEphemerisSegment> segments_;
};

}  // namespace vectrix
