#include "ephemeris_reader.hpp"

#include <algorithm>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "shifted_number.hpp"

namespace vectrix::detail {
namespace {

// The entries of a part, from the line behind its begin to the line that ends it, at which the reader is
// then.
void read_entries(KvnReader& reader, const MessageKind& kind, MessagePart part, const std::string& version,
                  KvnEntries& entries, std::vector<std::string>& comments,
                  std::vector<OtherKeyword>& others) {
  const char* end = part == MessagePart::header ? "META_START" : "META_STOP";
  while (true) {
    if (!reader.next())
      throw BadInput(reader.place() + ", line " + text(reader.line()) + ": there is no " + end);
    if (reader.is(end)) return;
    if (reader.is_comment()) {
      comments.push_back(reader.comment());
      continue;
    }
    KvnLine line = reader.keyword();
    if (!known_keyword(kind, part, version, reader.place(), line)) {
      if (const std::string fault = other_fault(kind, line.keyword); !fault.empty())
        entries.fail(line, fault);
      others.push_back({line.keyword, line.value});
    }
    entries.add(std::move(line));
  }
}

}  // namespace

const MessageKeyword* known_keyword(const MessageKind& kind, MessagePart part, const std::string& version,
                                    const std::string& place, const KvnLine& line) {
  const MessageKeyword* known = nullptr;
  for (const MessageKeyword& keyword : kind.keywords) {
    if (keyword.name != line.keyword || keyword.part != part) continue;
    known = &keyword;
    if (version >= known->since && version <= known->until) return known;
  }
  if (known)
    refuse(place, line,
           "the keyword is of version " + std::string{version < known->since ? known->since : known->until} +
               ", the message of version " + version);
  return nullptr;
}

MessageHeader read_version(KvnReader& reader, const MessageKind& kind) {
  MessageHeader header;
  bool more = reader.next();
  for (; more && reader.is_comment(); more = reader.next()) header.comments.push_back(reader.comment());
  const std::string first = "a message begins with " + std::string{kind.version_keyword};
  if (!more) throw BadInput(reader.place() + ": there is no message");
  if (!reader.has_keyword()) reader.fail(first);
  const KvnLine version = reader.keyword();
  if (version.keyword != kind.version_keyword) refuse(reader.place(), version, first);
  if (!kind.has(version.value)) refuse(reader.place(), version, "the versions are " + kind.list());
  header.version = version.value;
  return header;
}

void fill_header(const KvnEntries& entries, MessageHeader& header) {
  const auto value = [&](const char* keyword) {
    const KvnLine* line = entries.find(keyword);
    return line ? line->value : std::string{};
  };
  header.creation_date = value("CREATION_DATE");
  header.originator = value("ORIGINATOR");
  header.classification = value("CLASSIFICATION");
  header.message_id = value("MESSAGE_ID");
}

MessageHeader read_header(KvnReader& reader, const MessageKind& kind) {
  MessageHeader header = read_version(reader, kind);
  KvnEntries entries(reader.place(), "the message from line " + text(reader.line()) + " on");
  read_entries(reader, kind, MessagePart::header, header.version, entries, header.comments, header.others);
  fill_header(entries, header);
  return header;
}

void read_object(const KvnEntries& entries, EphemerisMetadata& metadata) {
  metadata.object_name = entries.line("OBJECT_NAME").value;
  metadata.object_id = entries.line("OBJECT_ID").value;
  if (const KvnLine* center = entries.find("CENTER_NAME")) metadata.center_name = center->value;
  const KvnLine& system = entries.filled("TIME_SYSTEM");
  const TimeScale* scale = scale_named(upper_case(system.value));
  if (!scale) entries.fail(system, "the time systems that are read are UTC, TAI, TT, TDB and GPS");
  metadata.time_system = *scale;
}

KvnEntries read_metadata(KvnReader& reader, const MessageKind& kind, const std::string& version,
                         std::string_view interpolation_keyword, EphemerisMetadata& metadata) {
  KvnEntries entries(reader.place(), "the segment from line " + text(reader.line()) + " on");
  read_entries(reader, kind, MessagePart::metadata, version, entries, metadata.comments, metadata.others);
  read_object(entries, metadata);
  const TimeScale& scale = metadata.time_system;
  metadata.start_time = entries.epoch(entries.filled("START_TIME"), scale);
  metadata.stop_time = entries.epoch(entries.filled("STOP_TIME"), scale);
  if (const KvnLine* start = entries.find("USEABLE_START_TIME"))
    metadata.useable_start_time = entries.epoch(*start, scale);
  if (const KvnLine* stop = entries.find("USEABLE_STOP_TIME"))
    metadata.useable_stop_time = entries.epoch(*stop, scale);
  if (const auto fault = span_fault(metadata))
    entries.fail(entries.line(fault->keyword), "it is before " + std::string{fault->before} + ", " +
                                                   exact_text(fault->limit, metadata.time_system));
  if (const KvnLine* method = entries.find(interpolation_keyword)) metadata.interpolation = method->value;
  if (const KvnLine* degree = entries.find("INTERPOLATION_DEGREE")) {
    const std::int64_t value = entries.whole(*degree);
    if (!is_degree(value))
      entries.fail(*degree, "no degree of an interpolation, which is at most " + text(most_degree));
    metadata.interpolation_degree = static_cast<int>(value);
  }
  return entries;
}

double read_number(const KvnReader& reader, std::string_view word, std::string_view name, int shift) {
  const auto value = parse_shifted(word, shift);
  if (!value) reader.fail(word, name, number_fault(word, shift));
  return *value;
}

DataReader::Line DataReader::read() {
  const auto scanned = scan();
  const Line line = scanned ? *scanned : read_words();
  before_ = line.time;
  return line;
}

// The line in one pass, if there is nothing unusual in it. Nothing for any other line, right or wrong.
std::optional<DataReader::Line> DataReader::scan() const {
  const std::string_view text = reader_.content();
  const char* const end = text.data() + text.size();
  const auto epoch = epochs_.scan(text.data(), end);
  if (!epoch || (before_ && !(*before_ < epoch->epoch)) || is_outside(metadata_, epoch->epoch))
    return std::nullopt;
  std::optional<Line> line{{epoch->epoch, 0, {}}};
  const std::size_t most = columns_.names.size();
  for (const char* at = epoch->end; at != end; ++line->size) {
    if (line->size == most || !is_blank(*at)) return std::nullopt;
    while (is_blank(*at)) ++at;  // there is none at the end
    const auto number = scan_shifted(at, end, columns_.shift);
    if (!number) return std::nullopt;
    line->numbers[line->size] = number->value;
    at = number->end;
  }
  if (line->size != most && line->size != columns_.fewest) return std::nullopt;
  return line;
}

DataReader::Line DataReader::read_words() {
  if (reader_.has_keyword() || reader_.is("META_START"))
    reader_.fail("no line of data, and not " + columns_.ends);
  std::array<std::string_view, KvnReader::most_words> words{};
  const std::size_t size = reader_.words(words);
  if (size != columns_.fewest + 1 && size != columns_.names.size() + 1)
    reader_.fail(text(size) + " fields; " + columns_.fields);
  Line line{read_time(words[0]), size - 1, {}};
  for (std::size_t i = 0; i < line.size; ++i)
    line.numbers[i] = read_number(reader_, words[i + 1], columns_.names[i], columns_.shift);
  return line;
}

Epoch DataReader::read_time(std::string_view word) {
  const auto fail = [&](const std::string& reason) { reader_.fail(word, "EPOCH", reason); };
  const Epoch time = epoch_of(epochs_, word, fail);
  if (before_ && !(*before_ < time))
    fail("not later than the line before, at " + exact_text(*before_, metadata_.time_system));
  if (is_outside(metadata_, time)) fail("outside " + span_text(metadata_));
  return time;
}

}  // namespace vectrix::detail
