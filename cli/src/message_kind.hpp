#pragma once

#include <filesystem>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// Whether the file begins as a message of CCSDS does, or else is a table. Throws BadInput if it cannot be
/// read, and for UTF-16 that is not XML.
bool is_message(const std::filesystem::path& file);
/// Throws BadInput for a file without a word.
void require_content(const std::filesystem::path& file);
/// Whether it is an orbit ephemeris message, or a combined one with such and without an attitude. Throws
/// BadInput if it cannot be read.
bool is_orbit_message(const std::filesystem::path& file);
/// The same of orbit mean-elements messages, in a combined one without an ephemeris.
bool is_mean_elements_message(const std::filesystem::path& file);

/// Of a file of this kind, or the one of a combined message. Throws BadInput as the message does, and, with
/// the kinds that are there, if there is none or several.
AttitudeEphemerisMessage read_attitude_message(const std::filesystem::path& file);
OrbitEphemerisMessage read_orbit_message(const std::filesystem::path& file);
/// All of them.
std::vector<OrbitMeanElementsMessage> read_mean_elements_messages(const std::filesystem::path& file);

}  // namespace vectrix::cli
