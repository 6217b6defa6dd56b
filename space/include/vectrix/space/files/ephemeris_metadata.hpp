#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix {

/// A keyword that is not of the standard, and its value.
struct OtherKeyword {
  std::string keyword, value;

  friend bool operator==(const OtherKeyword&, const OtherKeyword&) = default;
};

/// The header of an ephemeris message of CCSDS, as it is written. Some providers leave the date and the
/// originator empty. CLASSIFICATION and MESSAGE_ID are of the newest version of each message; empty if it
/// does not have them. The other keywords are kept in their order, and written behind those of the standard.
struct MessageHeader {
  std::string version;
  std::string creation_date, originator;
  std::string classification{}, message_id{};
  std::vector<std::string> comments{};
  std::vector<OtherKeyword> others{};
};

/// What the metadata of an orbit and of an attitude have in common; the others as in the header. A text that
/// is not there is empty; object name and id may be empty, too. An ephemeris of samples has their first and
/// last time for START_TIME and STOP_TIME if they are not given. The interpolation is text, not a claim that
/// it makes sense: files with 'Linear' of degree 7 exist.
struct EphemerisMetadata {
  std::string object_name, object_id;
  std::string center_name{};
  TimeScale time_system = scale::utc;
  std::optional<Epoch> start_time{}, useable_start_time{}, useable_stop_time{}, stop_time{};
  std::string interpolation{};
  std::optional<int> interpolation_degree{};
  std::vector<std::string> comments{};
  std::vector<OtherKeyword> others{};
};

}  // namespace vectrix
