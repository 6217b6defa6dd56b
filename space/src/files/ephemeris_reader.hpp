#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ephemeris_rules.hpp"
#include "kvn_entries.hpp"

namespace vectrix::detail {

// How orbit and attitude ephemeris messages are read.

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
/// Refuses another time system than that of the first segment.
void require_same_system(const KvnEntries& entries, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first);

/// The time of a data line, which must be later than that of the line before, and within the metadata's span.
Epoch read_time(const KvnReader& reader, const KvnWord& word, const EphemerisMetadata& metadata,
                const Epoch* before);
/// The number times 10^shift.
double read_number(const KvnReader& reader, const KvnWord& word, std::string_view name, int shift = 0);

}  // namespace vectrix::detail
