#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <vectrix/frames/errors.hpp>

#include "../time/date.hpp"
#include "ephemeris_rules.hpp"
#include "kvn_entries.hpp"
#include "text_file.hpp"
#include "xml_document.hpp"
#include "xml_messages.hpp"

namespace vectrix::detail {

// How messages of CCSDS are read.

/// The first line of a message, CCSDS_..._VERS, and the comments before it; the header has no more then.
MessageHeader read_version(KvnReader& reader, const MessageKind& kind);
/// Takes the keywords of the header that are of the standard.
void fill_header(const KvnEntries& entries, MessageHeader& header);
/// The keyword of the kind in this part, which the version must have. Null if there is none.
const MessageKeyword* known_keyword(const MessageKind& kind, MessagePart part, const std::string& version,
                                    const std::string& place, const KvnLine& line);
/// OBJECT_NAME, OBJECT_ID, CENTER_NAME and TIME_SYSTEM.
void read_object(const KvnEntries& entries, EphemerisMetadata& metadata);

// How orbit and attitude ephemeris messages are read.

/// From the first line to META_START, at which the reader is then.
MessageHeader read_header(KvnReader& reader, const MessageKind& kind);
/// From META_START to META_STOP, at which the reader is then. `metadata` gets what both kinds of message
/// have, with the comments behind those that it has.
KvnEntries read_metadata(KvnReader& reader, const MessageKind& kind, const std::string& version,
                         std::string_view interpolation_keyword, EphemerisMetadata& metadata);

/// What the lines of data of a segment have: an epoch, and numbers times 10^shift.
struct DataColumns {
  std::vector<std::string_view> names;  // of the numbers
  std::size_t fewest;                   // there are so many, or all
  int shift;
  std::string fields;  // "a line of data has an epoch and 6 numbers, or 9"
  std::string ends;    // the words that end the lines, "META_START or COVARIANCE_START"
};

/// Reads the lines of data of a segment. The time of each must be later than that of the line before, and
/// within the span of the metadata. Reader and metadata must live as long.
class DataReader {
 public:
  DataReader(const KvnReader& reader, const EphemerisMetadata& metadata, DataColumns columns)
      : reader_(reader), metadata_(metadata), columns_(std::move(columns)), epochs_(metadata.time_system) {}

  static constexpr std::size_t most_numbers = KvnReader::most_words - 1;
  struct Line {
    Epoch time;
    std::size_t size;
    std::array<double, most_numbers> numbers;
  };
  /// Refuses a line that is wrong.
  Line read();

 private:
  [[nodiscard]] std::optional<Line> scan() const;
  Line read_words();
  Epoch read_time(std::string_view word);

  const KvnReader& reader_;
  const EphemerisMetadata& metadata_;
  DataColumns columns_;
  EpochReader epochs_;
  std::optional<Epoch> before_{};
};

/// Gives back the capacity that is far more than the lines need.
template <class T> void give_back(std::vector<T>& lines) {
  if (lines.capacity() / 2 > lines.size()) lines.shrink_to_fit();
}

/// The number times 10^shift.
double read_number(const KvnReader& reader, std::string_view word, std::string_view name, int shift = 0);

/// What read(reader) makes of each message of a text, which is of keywords and values, or XML.
template <class Read>
auto read_messages(const std::string& place, std::string_view text, bool whole, const MessageKind& kind,
                   Read read) {
  std::vector<decltype(read(std::declval<KvnReader&>()))> all;
  if (is_xml(text)) {
    for (const XmlMessage& message : messages_in_xml(place, text, kind.element())) {
      KvnReader reader(place, message.text, message.origins);
      all.push_back(read(reader));
    }
  } else {
    KvnReader reader(place, text, whole);
    all.push_back(read(reader));
  }
  return all;
}
template <class Read>
auto read_messages(const std::filesystem::path& file, const MessageKind& kind, Read read) {
  const std::string place = std::string{kind.name} + " " + file.string();
  const auto bytes = read_bytes(file);
  if (!bytes) throw BadInput(place + ": cannot be read");
  // A parameter message often has no line end at its end, and no other sign of it.
  return read_messages(place, *bytes, is_whole(*bytes) || !kind.blocks.empty(), kind, read);
}
/// The only one.
template <class Message> Message single(const std::string& place, std::vector<Message> messages) {
  if (messages.size() != 1) throw BadInput(place + ": there are " + text(messages.size()) + " messages");
  return std::move(messages.front());
}
template <class Read> auto parse_message(std::string_view text, const MessageKind& kind, Read read) {
  return single(kind.name, read_messages(kind.name, text, true, kind, read));
}
template <class Read>
auto read_message(const std::filesystem::path& file, const MessageKind& kind, Read read) {
  return single(std::string{kind.name} + " " + file.string(), read_messages(file, kind, read));
}

/// The ephemeris message that the reader is before. `SegmentReader(reader, version)` reads one segment with
/// each call of read(), and at the last gives false.
template <class Message, class SegmentReader>
Message read_segments(KvnReader& reader, const MessageKind& kind) {
  MessageHeader header = read_header(reader, kind);
  SegmentReader segments(reader, header.version);
  while (segments.read()) continue;
  return {std::move(header), std::move(segments).segments()};
}

}  // namespace vectrix::detail
