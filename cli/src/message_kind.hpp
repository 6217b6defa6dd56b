#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// Whether the file begins as a message of CCSDS does, or else is a table. Throws BadInput if it cannot be
/// read, and for UTF-16 that is not XML.
bool is_message(const std::filesystem::path& file);
/// Throws BadInput for a file without a word.
void require_content(const std::filesystem::path& file);

/// "aem", "oem" or "omm", or something else of a file that is none, whose reader says why; and what else a
/// combined message has, "OEM, 2 APM".
struct KindOfMessage {
  std::string kind, others;
};
/// What of a message is converted; of a combined one what is stated, or what the name of the file to be
/// written says, or the only one. Throws BadInput for a kind that is not converted, and if none is there or
/// several are left.
KindOfMessage kind_to_convert(const std::filesystem::path& file, const std::string& stated,
                              const std::filesystem::path& out);

/// Of a file of this kind, or the one of a combined message. Throws BadInput as the message does, and, with
/// the kinds that are there, if there is none or several.
AttitudeEphemerisMessage read_attitude_message(const std::filesystem::path& file);
OrbitEphemerisMessage read_orbit_message(const std::filesystem::path& file);
/// All of them.
std::vector<OrbitMeanElementsMessage> read_mean_elements_messages(const std::filesystem::path& file);

}  // namespace vectrix::cli
