#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/files/attitude_ephemeris_message.hpp>
#include <vectrix/space/files/attitude_parameter_message.hpp>
#include <vectrix/space/files/orbit_ephemeris_message.hpp>
#include <vectrix/space/files/orbit_parameter_message.hpp>
#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>

namespace vectrix {

/// A message of a kind that is not read: the name of its element, and its line.
struct UnreadMessage {
  std::string element;
  std::size_t line;
};

/// A combined message, <ndm> (CCSDS 505.0-B): messages of several kinds in one XML document, each kind in the
/// order of the document. A document of one message is taken, too.
class VECTRIX_EXPORT NavigationDataMessage {
 public:
  /// Throws BadInput with line and column as the messages do, and if the text is not XML.
  static NavigationDataMessage parse(std::string_view text);
  static NavigationDataMessage read(const std::filesystem::path& file);

  /// Those of the document; a message has its own. MESSAGE_ID is one of them.
  std::vector<std::string> comments{};
  std::vector<AttitudeEphemerisMessage> attitude_ephemerides{};
  std::vector<AttitudeParameterMessage> attitude_parameters{};
  std::vector<OrbitEphemerisMessage> orbit_ephemerides{};
  std::vector<OrbitParameterMessage> orbit_parameters{};
  std::vector<OrbitMeanElementsMessage> orbit_mean_elements{};
  std::vector<UnreadMessage> unread{};
};

}  // namespace vectrix
