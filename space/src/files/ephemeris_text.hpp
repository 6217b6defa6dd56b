#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/space/files/ephemeris_metadata.hpp>

#include "kvn_entries.hpp"

namespace vectrix::detail {

// What orbit and attitude ephemeris messages have in common, as text.

struct MessageKind {
  const char* name;
  const char* version_keyword;
  std::initializer_list<const char*> versions;
};

/// A keyword of the metadata, and the versions that have it.
struct EphemerisKeyword {
  std::string_view name;
  std::string_view since = "1.0", until = "9.9";
};

/// From the first line to META_START, at which the reader is then.
MessageHeader read_header(KvnReader& reader, const MessageKind& kind);
/// From META_START to META_STOP, at which the reader is then.
KvnEntries read_entries(KvnReader& reader, const std::string& version,
                        const std::vector<EphemerisKeyword>& keywords, std::vector<std::string>& comments);
EphemerisMetadata metadata_of(const KvnEntries& entries, std::string_view interpolation_keyword);

/// Throws BadInput if the time system is not that of the first segment, with the line or after `place`.
void require_same_system(const KvnEntries& entries, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first);
void require_same_system(const std::string& place, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first);

Epoch read_epoch(const KvnReader& reader, const KvnWord& word, const TimeScale& scale);
/// The number times 10^shift.
double read_number(const KvnReader& reader, const KvnWord& word, std::string_view name, int shift = 0);
/// The time of a data line, which must be later than that of the line before, and within the metadata's span.
Epoch read_time(const KvnReader& reader, const KvnWord& word, const EphemerisMetadata& metadata,
                const Epoch* before);

/// Throws BadInput if a text is not one line of printable characters.
void require_text(const std::string& place, const char* what, const std::string& value);
void require_comments(const std::string& place, const std::vector<std::string>& comments);
void require_header(const MessageHeader& header, const MessageKind& kind);
/// The metadata of samples with these times, with START_TIME and STOP_TIME. Throws BadInput.
EphemerisMetadata checked_metadata(const std::string& place, EphemerisMetadata metadata,
                                   const std::vector<Epoch>& times);

void write_line(std::string& out, std::string_view keyword, const std::string& value);
void write_comments(std::string& out, const std::vector<std::string>& comments);
void write_header(std::string& out, const MessageHeader& header, const MessageKind& kind);
/// OBJECT_NAME to CENTER_NAME; TIME_SYSTEM to STOP_TIME; the interpolation.
void write_object(std::string& out, const EphemerisMetadata& metadata);
void write_span(std::string& out, const EphemerisMetadata& metadata);
void write_interpolation(std::string& out, const EphemerisMetadata& metadata, std::string_view keyword);

}  // namespace vectrix::detail
