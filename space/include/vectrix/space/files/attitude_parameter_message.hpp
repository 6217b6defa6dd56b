#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/attitude_ephemeris_segment.hpp>
#include <vectrix/space/files/parameter_message.hpp>

namespace vectrix {

/// An attitude parameter message (APM, CCSDS 504.0-B, versions 1.0 and 2.0) in keyword-value notation or XML:
/// attitudes at one epoch.
///     const auto message = AttitudeParameterMessage::read("sat.apm");
///     const auto sample = message.states().front().samples<earth::Eme2000,
///     Body>(called<Body>("SC_BODY_1")).front();
/// states() has a segment of one sample for each quaternion, each set of Euler angles, and in version 2.0
/// each angular velocity, in the order of the message. Two of them may be different attitudes: nothing is
/// merged. The other blocks, "spin", "inertia" and "manoeuvre", are numbers with names; blocks() has them
/// all.
///
/// The numbers of "inertia" are entries of the matrix in INERTIA_REF_FRAME: version 1.0 says of I12, I13 and
/// I23 that they are negative integrals, -∫ x y dm (504.0-B-1, 3.2.5.2.5). The rates of Euler angles in
/// version 1.0, X_RATE to Z_RATE, are numbers only.
class VECTRIX_EXPORT AttitudeParameterMessage : public ParameterMessage {
 public:
  /// Of segments of one sample, all at one time, with the metadata of the first; one with a rate becomes a
  /// quaternion and an angular velocity. Throws BadInput if there is none, the version is not 2.0, or a
  /// segment has another direction than A2B.
  AttitudeParameterMessage(const MessageHeader& header, const std::vector<AttitudeEphemerisSegment>& states);
  AttitudeParameterMessage(detail::Trusted, detail::ParameterContent content, const Epoch& epoch,
                           std::vector<AttitudeEphemerisSegment> states);

  /// The end of the text ends its last line. Throws BadInput with line, column, what was found there and why
  /// it is wrong, or the keyword that is missing.
  static AttitudeParameterMessage parse(std::string_view text);
  /// Throws BadInput with the file, too, and if the file cannot be read. Its last line may have no line end,
  /// as in published files: cut within its last value, it is read.
  static AttitudeParameterMessage read(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<AttitudeEphemerisSegment>& states() const { return states_; }

 private:
  std::vector<AttitudeEphemerisSegment> states_;
};

}  // namespace vectrix
