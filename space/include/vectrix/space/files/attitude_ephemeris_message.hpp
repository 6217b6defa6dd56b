#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/attitude_ephemeris_segment.hpp>

namespace vectrix {

/// An attitude ephemeris message (AEM, CCSDS 504.0-B, versions 1.0 and 2.0) in keyword-value notation or XML.
///     const auto message = AttitudeEphemerisMessage::read("sat.aem");
///     const auto samples =
///         message.segments().front().samples<earth::Eme2000, Body>(called<Body>("SC_BODY_1"));
///     const auto attitude = sampled_edge(samples, longest_gap);
/// Version 1.0 says the direction and the place of the scalar in ATTITUDE_DIR and QUATERNION_TYPE, and must;
/// version 2.0 must not. Quaternions whose norm is off 1 by more than 0.01 are refused, so are types that
/// AttitudeType does not have. For time systems, keywords and comments see OrbitEphemerisMessage.
class VECTRIX_EXPORT AttitudeEphemerisMessage {
 public:
  /// Throws BadInput if there is no segment, the time systems differ, the version is neither of the two, or a
  /// segment is not of version 2.0: another direction than A2B, the scalar first.
  AttitudeEphemerisMessage(MessageHeader header, std::vector<AttitudeEphemerisSegment> segments);

  /// The end of the text ends its last line. Throws BadInput with line, column, what was found there and why
  /// it is wrong, or the keyword that is missing.
  static AttitudeEphemerisMessage parse(std::string_view text);
  /// Throws BadInput with the file, too, and if the file cannot be read or stops within a line.
  static AttitudeEphemerisMessage read(const std::filesystem::path& file);

  /// The message as text: the numbers of the file in its units, otherwise as OrbitEphemerisMessage::text().
  /// A rate in rad/s is rounded when a segment takes it, to degrees.
  [[nodiscard]] std::string text() const;
  /// The same in XML. Comments lose the blanks around them. Throws BadInput if one is not UTF-8.
  [[nodiscard]] std::string xml() const;
  /// As XML if the name ends in .xml. Throws BadInput if the file cannot be written.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] const MessageHeader& header() const { return header_; }
  [[nodiscard]] const std::vector<AttitudeEphemerisSegment>& segments() const { return segments_; }

 private:
  MessageHeader header_;
  std::vector<AttitudeEphemerisSegment> segments_;
};

}  // namespace vectrix
