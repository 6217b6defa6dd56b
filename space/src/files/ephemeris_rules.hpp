#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/space/files/ephemeris_metadata.hpp>

namespace vectrix::detail {

// What holds for messages of CCSDS, whether they are read or made of samples.

/// The header, the metadata, and the blocks of messages that have keywords for all data.
enum class MessagePart {
  header,
  metadata,
  epoch,
  quaternion,
  euler_angles,
  angular_velocity,
  spin,
  inertia,
  state,
  elements,
  spacecraft,
  covariance,
  maneuver
};

/// What the value of a keyword of a block is. An amount is a number that is not negative.
enum class ValueKind { text, epoch, number, amount };

/// A keyword of a part, and the versions that have it. Of a keyword of a block also what its value is, and
/// whether the block must have it.
struct MessageKeyword {
  std::string_view name;
  MessagePart part = MessagePart::metadata;
  std::string_view since = "1.0", until = "9.9";
  ValueKind value = ValueKind::text;
  std::string_view unit{};
  bool is_required = false;
  bool may_repeat = false;  // within its block
};

/// A block of a parameter message. `word` gives the lines <word>_START and <word>_STOP around it in the
/// versions that have them, from `delimited_since` on. Otherwise a block is there once, unless it has a
/// `first` keyword, which begins another one.
struct MessageBlock {
  MessagePart part;
  const char* name;
  std::string_view first{};
  std::string_view word{}, delimited_since = "9.9";

  [[nodiscard]] bool is_delimited(const std::string& version) const { return version >= delimited_since; }
};

struct MessageKind {
  const char* name;
  const char* version_keyword;
  std::initializer_list<const char*> versions;
  std::span<const MessageKeyword> keywords;
  std::span<const MessageBlock> blocks{};  // of parameter messages

  [[nodiscard]] bool has(const std::string& version) const;
  /// The name of the element in XML, aem.
  [[nodiscard]] std::string element() const;
  [[nodiscard]] std::string newest() const { return *(versions.end() - 1); }
  /// 1.0, 2.0, 3.0
  [[nodiscard]] std::string list() const;
};

/// Why a keyword that the part does not have cannot be kept as another one: it has its place elsewhere, or is
/// nearly one that is known, and so misspelt. Empty if it can be kept.
std::string other_fault(const MessageKind& kind, std::string_view keyword);
void require_others(const std::string& place, const MessageKind& kind,
                    const std::vector<OtherKeyword>& others);

/// What INTERPOLATION_DEGREE may be: 0 to 1000, whether it makes sense or not.
inline constexpr int most_degree = 1000;
inline bool is_degree(std::int64_t degree) {
  return 0 <= degree && degree <= most_degree;
}

/// The first time of the metadata that is before another one.
struct SpanFault {
  const char *keyword, *before;
  Epoch limit;  // of the other one
};
std::optional<SpanFault> span_fault(const EphemerisMetadata& metadata);
/// What is wrong with the time system of metadata after those of the first segment, if anything.
std::optional<std::string> system_fault(const EphemerisMetadata& metadata, const EphemerisMetadata& first);
/// "START_TIME, <text>, and STOP_TIME, <text>" of metadata that have them.
std::string span_text(const EphemerisMetadata& metadata);
/// Whether the time of a line is more than 1 ms outside START_TIME and STOP_TIME.
bool is_outside(const EphemerisMetadata& metadata, const Epoch& time);

/// Throws BadInput if a text is not one line of printable characters.
void require_text(const std::string& place, const char* what, const std::string& value);
void require_comments(const std::string& place, const std::vector<std::string>& comments);
void require_header(const MessageHeader& header, const MessageKind& kind);
/// The metadata of samples with these times, with START_TIME and STOP_TIME. Throws BadInput.
EphemerisMetadata checked_metadata(const std::string& place, const MessageKind& kind,
                                   EphemerisMetadata metadata, const std::vector<Epoch>& times);

}  // namespace vectrix::detail
