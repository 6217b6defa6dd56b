#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/orbit_ephemeris_segment.hpp>
#include <vectrix/space/files/parameter_message.hpp>
#include <vectrix/space/orbit/kepler_equation.hpp>

namespace vectrix {

/// The Keplerian elements of a message, osculating at its epoch about its centre in its frame. A mean anomaly
/// has become a true one. p = semi_latus_rectum(semi_major_axis, eccentricity).
struct ParameterElements {
  Quantity<si::length> semi_major_axis;
  double eccentricity;
  Quantity<si::angle> inclination, ascending_node, argument_of_pericentre;
  TrueAnomaly true_anomaly;
  Quantity<si::gravitational_parameter> gm;
};

/// How far two states are apart.
struct StateDistance {
  Quantity<si::length> position;
  Quantity<si::velocity> velocity;
};

/// An orbit parameter message (OPM, CCSDS 502.0-B, versions 1.0, 2.0 and 3.0) in keyword-value notation or
/// XML: position and velocity at one epoch.
///     const auto message = OrbitParameterMessage::read("sat.opm");
///     const auto sample = message.state().samples<earth::TrueOfDate, Satellite>().front();
/// state() is a segment of one sample; it has the covariance, if there is one, in its frame. A message may
/// have Keplerian elements in addition, which must be the same state: elements_distance() says how far they
/// are apart. Nothing is chosen. "spacecraft" and "manoeuvre" are blocks of numbers with names, as blocks()
/// has them all.
class VECTRIX_EXPORT OrbitParameterMessage : public ParameterMessage {
 public:
  /// Of a segment of one sample, with its covariance, if it has one at this time. Throws BadInput if it has
  /// more samples, or the version is unknown or does not have what the segment has.
  OrbitParameterMessage(const MessageHeader& header, const OrbitEphemerisSegment& state);
  OrbitParameterMessage(detail::Trusted, detail::ParameterContent content, OrbitEphemerisSegment state,
                        std::optional<ParameterElements> elements);

  /// The end of the text ends its last line. Throws BadInput with line, column, what was found there and why
  /// it is wrong, or the keyword that is missing; also for elements of no orbit.
  static OrbitParameterMessage parse(std::string_view text);
  /// Throws BadInput with the file, too, and if the file cannot be read. Its last line may have no line end,
  /// as in published files: cut within its last value, it is read.
  static OrbitParameterMessage read(const std::filesystem::path& file);

  [[nodiscard]] const OrbitEphemerisSegment& state() const { return state_; }
  [[nodiscard]] const std::optional<ParameterElements>& elements() const { return elements_; }
  /// From the state to that of the elements, by two-body motion with the GM of the message. Throws BadInput
  /// if there are no elements.
  [[nodiscard]] StateDistance elements_distance() const;

 private:
  OrbitEphemerisSegment state_;
  std::optional<ParameterElements> elements_;
};

}  // namespace vectrix
