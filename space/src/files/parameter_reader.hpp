#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <vectrix/space/files/parameter_message.hpp>

#include "ephemeris_reader.hpp"

namespace vectrix::detail {

/// A block of a parameter message that is being read.
struct ReadBlock {
  const MessageBlock* kind;
  KvnEntries entries;
  std::vector<KvnLine> lines{};  // of the entries, and those that repeat
  std::vector<std::string> comments{};
  std::string place{};  // begins messages

  /// The number of a keyword of the standard times 10^shift.
  [[nodiscard]] double number(const MessageKind& message, std::string_view keyword, int shift = 0) const;
};

/// A parameter message whose keywords have been checked: they are of their part and of the version, the
/// required ones are there, and numbers, units and epochs are well formed.
struct ReadParameters {
  MessageHeader header;
  EphemerisMetadata metadata;
  KvnEntries metadata_entries;
  std::vector<OtherKeyword> metadata_lines;
  std::vector<ReadBlock> blocks;

  /// The first block of a part. Null if there is none.
  [[nodiscard]] const ReadBlock* find(MessagePart part) const;
  [[nodiscard]] ParameterContent content() const;
};

/// The message that the reader is before, up to its end.
ReadParameters read_parameters(KvnReader& reader, const MessageKind& kind);

}  // namespace vectrix::detail
